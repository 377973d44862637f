//! Tests of `address`.

use super::*;

#[test]
fn addresses_begin_at_their_first_letter() {
    let of = |text: &str| places(&text.chars().collect::<Vec<_>>());
    assert_eq!(of("info@schule.de"), [0]);
    assert_eq!(of("Post an (info@schule.de)"), [9]);
    assert_eq!(of("5 @ 3, www.schule.de"), [2, 7]);
    assert!(of("no address. 3:4 Awww.").is_empty());
}
