//! Tests of `edited`.

use super::*;

#[test]
fn parts_are_replaced_in_the_order_in_which_they_stand() {
    let of = |edits: &[(Range<usize>, &str)]| {
        edited("abcdef", edits.iter().map(|(range, with)| (range.clone(), (*with).to_owned())).collect())
    };
    assert_eq!(of(&[]), "abcdef");
    assert_eq!(of(&[(4..6, ""), (0..1, "xyz"), (2..2, "-")]), "xyzb-cd");
    assert_eq!(of(&[(1..2, "x"), (2..2, "-")]), "ax-cdef", "one right behind another");
    assert_eq!(of(&[(1..5, "x"), (2..3, "y")]), "axf", "one within another");
}
