//! Tests of `pages`.

use super::*;

#[test]
fn pages_are_a_number_or_two() {
    for (text, wanted) in [("3", Pages::One(3)), ("1-4", Pages::Range(1, 4)), ("2 - 2", Pages::Range(2, 2))] {
        assert_eq!(text.parse(), Ok(wanted), "{text}");
    }
    for (text, told) in [
        ("0", "the first is 1"),
        ("", "give a page"),
        ("2-", "give a page"),
        ("-2", "give a page"),
        ("1,3", "give a page"),
        ("4-2", "2-4"),
        ("1-501", "501 pages"),
    ] {
        let fault = text.parse::<Pages>().expect_err(text);
        assert!(fault.contains(told), "{text}: {fault}");
    }
}
