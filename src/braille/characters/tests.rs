//! Tests of `characters`.

use super::*;

#[test]
fn accents_are_joined_and_ligatures_taken_apart() {
    assert_eq!(composed("An\u{303}o pe\u{301}"), "A\u{f1}o p\u{e9}");
    assert_eq!(composed("\u{fb01}n, o\u{fb03}ce, x\u{b2}"), "fin, office, x\u{b2}");
    // places are those of the text
    assert_eq!(characters("e\u{301}a"), [('\u{e9}', 1), ('a', 3)]);
    assert_eq!(characters("x\u{304}\u{fb01}"), [('x', 1), ('\u{304}', 1), ('f', 3), ('i', 3)]);
    assert!(characters("").is_empty() && is_accent('\u{304}') && !is_accent('^'));
}
