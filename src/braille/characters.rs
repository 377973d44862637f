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

/// Whether a character is one of a formula or a measure: a number, a power, an index, a sign of mathematics or of a
/// currency, or a Greek letter.
pub fn is_of_formula(character: char) -> bool {
    let is_sign = matches!(
        character,
        '+' | '<' | '=' | '>' | '$' | '\u{a2}'..='\u{a5}' | '\u{ac}' | '\u{b1}' | '\u{b5}' | '\u{b7}' | '\u{d7}'
            | '\u{f7}' | '\u{1d2c}'..='\u{1d6a}' | '\u{2070}'..='\u{209f}' | '\u{20a0}'..='\u{20cf}' | '\u{2126}'
            | '\u{2200}'..='\u{22ff}' | '\u{27c0}'..='\u{27ef}' | '\u{2980}'..='\u{2aff}'
    );
    is_sign || is_greek(character) || character.is_numeric()
}

/// Whether a character is a Greek letter.
pub fn is_greek(character: char) -> bool {
    matches!(character, '\u{370}'..='\u{3ff}') && character.is_alphabetic()
}

/// A character in others that say the same, or nearly: a letter without its accent, a fraction by its numbers, what
/// Unicode has as compatible, such as a degree with its C or a Roman number. Any other sign of a formula is none: a
/// power without its height, or an equals sign without its stroke, says something else.
pub(super) fn simpler(character: char) -> Option<String> {
    let decomposed: String = character.nfkd().collect();
    let is_fraction = decomposed.contains(FRACTION);
    let is_roman = matches!(character, '\u{2160}'..='\u{217f}');
    // squares of words, such as those of areas, have powers in them
    let is_square = matches!(character, '\u{3300}'..='\u{33ff}');
    if is_square || is_raised_letter(character) || is_of_formula(character) && !is_fraction && !is_roman {
        return None;
    }
    let letters = match character {
        'ł' => "l".into(),
        'Ł' => "L".into(),
        'ø' => "o".into(),
        'Ø' => "O".into(),
        'đ' => "d".into(),
        'Đ' => "D".into(),
        'ħ' => "h".into(),
        'Ħ' => "H".into(),
        'ŧ' => "t".into(),
        'Ŧ' => "T".into(),
        'ı' => "i".into(),
        'æ' => "ae".into(),
        'Æ' => "Ae".into(),
        'œ' => "oe".into(),
        'Œ' => "Oe".into(),
        // of minutes, and of the image of a point
        '\u{2032}' => "'".into(),
        '\u{2033}' => "''".into(),
        _ => decomposed.chars().filter(|&part| !is_accent(part)).collect::<String>().replace(FRACTION, "/"),
    };
    // an accent that stands by itself has a blank in place of its letter
    let are_said = letters.chars().all(|part| part.is_ascii_alphanumeric() || matches!(part, '\u{b0}' | '/' | '\''));
    (are_said && !letters.is_empty() && !letters.contains(character)).then_some(letters)
}

/// Between the two numbers of a fraction.
const FRACTION: char = '\u{2044}';

/// Whether a character is a letter that stands higher, as those at the end of numbers of an order and of short words in
/// French and Spanish do. Others, such as x, are powers.
pub(super) fn is_raised_letter(character: char) -> bool {
    matches!(
        character,
        '\u{aa}'
            | '\u{ba}'
            | '\u{2b0}'
            | '\u{2b3}'
            | '\u{2e2}'
            | '\u{1d43}'
            | '\u{1d48}'
            | '\u{1d49}'
            | '\u{1d50}'
            | '\u{1d52}'
            | '\u{1d57}'
    )
}

/// A raised letter on the line.
pub(super) fn on_line(character: char) -> Option<char> {
    let mut letter = character.nfkd();
    letter.next().filter(|letter| is_raised_letter(character) && letter.is_ascii_alphabetic())
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
