//! The characters of a text as tables have them: an accent that stands by itself is joined to its letter, as macOS
//! parts them in names of files, and ligatures of letters are taken apart.

use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::canonical_combining_class;

/// The characters of a text with their places in it, from 1. An accent that no letter has is a character of its own at
/// the place of its letter.
pub fn characters(text: &str) -> Vec<(char, usize)> {
    let mut characters = Vec::new();
    let mut letter = (String::new(), 1);
    for (at, character) in (1..).zip(text.chars()) {
        if canonical_combining_class(character) == 0 {
            put(&letter.0, letter.1, &mut characters);
            letter = (String::new(), at);
        }
        letter.0.push(character);
    }
    put(&letter.0, letter.1, &mut characters);
    characters
}

/// The same as a text.
pub(super) fn composed(text: &str) -> String {
    characters(text).into_iter().map(|(character, _)| character).collect()
}

/// Whether a character is an accent that stands by itself.
pub fn is_accent(character: char) -> bool {
    canonical_combining_class(character) != 0
}

/// Whether a character is one of a formula: a number, a power, an index, a sign of mathematics.
pub fn is_of_formula(character: char) -> bool {
    let is_sign = matches!(
        character,
        '+' | '<' | '=' | '>' | '\u{b1}' | '\u{d7}' | '\u{f7}' | '\u{ac}' | '\u{b7}' | '\u{1d2c}'..='\u{1d6a}'
            | '\u{2070}'..='\u{209f}' | '\u{2200}'..='\u{22ff}' | '\u{27c0}'..='\u{27ef}' | '\u{2980}'..='\u{2aff}'
    );
    is_sign || character.is_numeric()
}

/// Puts a letter with its accents behind other characters.
fn put(letter: &str, at: usize, characters: &mut Vec<(char, usize)>) {
    for character in letter.nfc() {
        match ligature(character) {
            Some(letters) => characters.extend(letters.chars().map(|letter| (letter, at))),
            None => characters.push((character, at)),
        }
    }
}

/// The letters of a ligature.
fn ligature(character: char) -> Option<&'static str> {
    Some(match character {
        '\u{fb00}' => "ff",
        '\u{fb01}' => "fi",
        '\u{fb02}' => "fl",
        '\u{fb03}' => "ffi",
        '\u{fb04}' => "ffl",
        '\u{fb05}' | '\u{fb06}' => "st",
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
