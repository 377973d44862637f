//! Tests of `grouped`.

use super::*;
use crate::braille::Code;

/// The text with a hyphen at each space that parts groups of one number.
fn grouped(text: &str, of_thousands_only: bool) -> String {
    let group = Group { cells: vec![4], of_thousands_only };
    let letters: Vec<char> = text.chars().collect();
    let is_joined = |at: usize| letters[at] == ' ' && is_in_number(&group, &letters, at);
    letters.iter().enumerate().map(|(at, letter)| if is_joined(at) { '-' } else { *letter }).collect()
}

#[test]
fn groups_of_three_digits_are_of_one_number() {
    for (text, want) in [
        ("12 000", "12-000"),
        ("1 234 567 km", "1-234-567 km"),
        ("1:25 000", "1:25-000"),
        ("1789 100", "1789 100"),
        ("12 00", "12 00"),
        ("3 1000", "3 1000"),
        ("0 100 200", "0 100 200"),
        ("100 200 300", "100 200 300"),
        ("12 000 or 10 000", "12-000 or 10-000"),
        ("12 000 10 000", "12-000 10-000"),
        ("0,5 100", "0,5 100"),
        ("3,141 592", "3,141-592"),
        ("1 000 000", "1-000-000"),
        ("1 002 003", "1-002-003"),
        ("1 234 467", "1-234-467"),
        ("100 200 400 800 m", "100 200 400 800 m"),
        ("5 10 50 100 500", "5 10 50 100 500"),
        ("10 100 1000", "10 100 1000"),
        ("0221 123 456", "0221 123 456"),
        ("5 000 10 000 15 000", "5-000 10-000 15-000"),
    ] {
        assert_eq!(grouped(text, true), want);
    }
    assert_eq!(grouped("020 7946 0018", true), "020 7946 0018");
    assert_eq!(grouped("020 7946 0018", false), "020-7946-0018");
}

#[test]
fn numbers_of_another_translator_are_joined_as_the_code_joins_them() {
    let table = Code::of_language("de").and_then(Code::table).expect("a table");
    // a number sign (60) before each group, and a blank between
    let (with, words) = ([60, 3, 0, 60, 26, 26, 26, 0, 13], "2 000 m");
    assert_eq!(join(&table, words, with.to_vec()), [60, 3, 4, 26, 26, 26, 0, 13]);
    assert_eq!(join(&table, "2 000m", with.to_vec()), with, "other blanks than those of the text");
    let italian = Code::of_language("it").and_then(Code::table).expect("a table");
    assert_eq!(join(&italian, words, with.to_vec()), with, "its blanks stay");
}
