//! Tests of `complexity`.

use super::*;

#[test]
fn digits_before_the_point_are_counted_with_exponents() {
    for (text, want) in [
        ("", 0),
        ("M 12.5,-300 4", 3),
        ("a1e38 1e38 0 0 0 5 5", 39),
        ("1e-5", 1),
        ("0.25 007", 1),
        ("1e99999999999999999999", usize::MAX),
        ("20037508.34 1E+3", 8),
        ("1e5.5", 6),
    ] {
        assert_eq!(digits_in(text), want, "{text}");
    }
}
