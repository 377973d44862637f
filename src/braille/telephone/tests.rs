//! Tests of `telephone`.

use super::*;

/// The text with a hyphen at each space that parts groups of one number.
fn joined(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_joined = |at: usize| letters[at] == ' ' && is_in_number(&letters, at);
    letters.iter().enumerate().map(|(at, letter)| if is_joined(at) { '-' } else { *letter }).collect()
}

#[test]
fn three_numbers_of_a_list_are_none_of_a_telephone() {
    for (text, want) in [
        ("555 123 4567", "555 123 4567"),
        ("Sales 100 200 3000", "Sales 100 200 3000"),
        ("Tel. 555 123 4567", "Tel. 555-123-4567"),
        ("Phone no.: 555 123 4567", "Phone no.: 555-123-4567"),
        ("mobile number 555 123 4567", "mobile number 555-123-4567"),
        ("mobile homes 100 200 3000", "mobile homes 100 200 3000"),
        ("numbers 555 123 4567", "numbers 555 123 4567"),
        ("telegrams 555 123 4567", "telegrams 555 123 4567"),
        ("fax or room numbers 555 123 4567", "fax or room numbers 555 123 4567"),
        ("+1 555 123 4567", "+1-555-123-4567"),
        ("(212) 555 0199", "(212) 555-0199"),
        ("020 7946 0018", "020-7946-0018"),
        ("01 44 49 35 35", "01-44-49-35-35"),
        ("08 09 10 11 12", "08 09 10 11 12"),
        ("12 44 49 35 35", "12 44 49 35 35"),
        ("978 1 55468 513 4", "978-1-55468-513-4"),
    ] {
        assert_eq!(joined(text), want, "{text}");
    }
}

#[test]
fn a_longer_row_of_digits_is_a_list() {
    let list = "01 234 567 890 123 456 789 012 345 678";
    assert_eq!(joined(list), list);
    assert_eq!(joined("+999 123 456 789 012"), "+999-123-456-789-012", "15 digits are the most");
    assert_eq!(joined("+999 123 456 789 0123"), "+999 123 456 789 0123");
}
