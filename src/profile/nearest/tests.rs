//! Tests of `nearest`.

use super::*;

#[test]
fn slips_find_the_name_that_was_meant() {
    let values = ["auto", "portrait", "landscape"];
    for (wrong, found) in [
        ("portrat", Some("did you mean \"portrait\"?")),
        ("Landscape", Some("did you mean \"landscape\"?")),
        ("sideways", None),
    ] {
        assert_eq!(nearest_value(wrong, values.into_iter()).as_deref(), found);
    }
    assert!(is_misspelt("width", "widht") && is_misspelt("min", "min"));
    assert!(!is_misspelt("min", "max") && !is_misspelt("width", "swell"));
}
