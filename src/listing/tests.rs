//! Tests of `listing`.

use super::*;

#[test]
fn a_list_ends_with_and() {
    let lists = [&["a"][..], &["a", "b"], &["a", "b", "c"]].map(|items| list(items, "and"));
    assert_eq!(lists, ["a", "a and b", "a, b and c"]);
    assert_eq!(list(&["a", "b"], "or"), "a or b");
    assert_eq!(list::<&str>(&[], "and"), "");
}

#[test]
fn what_is_not_shown_is_counted() {
    let few = |most: usize| first_few(&[1, 2, 3], most, |number| format!("no. {number}"));
    assert_eq!(few(3), "no. 1, no. 2, no. 3");
    assert_eq!(few(1), "no. 1 and 2 more");
    let more = |count: usize| and_more("a; b", count, "such place");
    assert_eq!([0, 1, 2].map(more), ["a; b", "a; b and 1 more such place", "a; b and 2 more such places"]);
}
