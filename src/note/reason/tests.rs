//! Tests of `reason`.

use std::collections::BTreeSet;

use super::*;

#[test]
fn each_reason_has_a_name_of_its_own() {
    let names: BTreeSet<&str> = Reason::ALL.iter().map(|reason| reason.name()).collect();
    assert_eq!(names.len(), Reason::ALL.len());
    let is_id = |name: &&str| name.chars().all(|c| c.is_ascii_lowercase() || c == '-');
    assert!(names.iter().all(is_id), "{names:?}");
}
