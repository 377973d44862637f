//! Tests of `letters`.

use super::*;
use crate::page::Class;

/// What a map says beside the names of classes.
const OTHER_WORDS: [&str; 5] = ["BLANK", "WRONG", "UNCLEAR", "NOT JUDGED", "NOT"];

#[test]
fn every_letter_that_is_written_has_strokes_inside_its_box() {
    let of_classes = Class::ALL.map(|class| class.name().to_uppercase());
    for word in of_classes.into_iter().chain(OTHER_WORDS.map(String::from)) {
        for letter in word.chars().filter(|letter| *letter != ' ') {
            assert!(!strokes(letter).is_empty(), "{letter} of {word} cannot be written");
            for point in strokes(letter).iter().flat_map(|stroke| stroke.split(' ')) {
                let digits: Vec<char> = point.chars().collect();
                assert!(digits.len() == 2 && ('0'..='4').contains(&digits[0]) && ('0'..='6').contains(&digits[1]));
            }
        }
    }
}
