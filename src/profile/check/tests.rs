//! Tests of `check`.

use super::*;

/// A misspelt path would switch its rule off without a word.
#[test]
fn rules_name_keys_that_exist() {
    let known = |path: &&str| KEYS.iter().any(|key| key.path == *path);
    for order in ORDERS {
        assert!(known(&order.small) && known(&order.large), "{} {}", order.small, order.large);
        assert!(order.when.iter().all(known), "{:?}", order.when);
    }
    assert!(ROOM.iter().chain(DRAWN).all(known));
    assert!(NARROW.iter().all(|(path, when, _)| known(path) && when.iter().all(known)));
}
