//! Where words may be divided at the end of a line: by the patterns of their language, and by what braille asks for.
//!
//! The patterns are those of TeX (hyph-utf8), after F. M. Liang, "Word Hy-phen-a-tion by Com-put-er" (1983).

use hypher::{Lang, hyphenate_bounded};

/// Fewest letters before and after the place: no letter stands alone, and none is brought over alone.
const FEWEST: usize = 2;
/// Longest word that is divided, letters: there is no longer one in a dictionary.
const LONGEST: usize = 60;

/// The characters of a text in front of which a word may be divided, in order. Words with a capital inside, such as
/// abbreviations, and with digits beside them, such as units, are not divided, and neither are those of an unknown
/// language.
pub(super) fn places(text: &[char], language: &str) -> Vec<usize> {
    let Some(lang) = language.as_bytes().first_chunk().copied().and_then(Lang::from_iso) else { return Vec::new() };
    let (left, right) = lang.bounds();
    let mut places = Vec::new();
    let mut from = 0;
    for word in text.split(|letter| !letter.is_alphanumeric()) {
        let is_one = word.len() >= 2 * FEWEST
            && word.len() <= LONGEST
            && word.iter().all(|letter| letter.is_alphabetic())
            && word[1..].iter().all(|letter| !letter.is_uppercase());
        if is_one {
            let spelled: String = word.iter().collect();
            let mut at = from;
            for syllable in hyphenate_bounded(&spelled, lang, left.max(FEWEST), right.max(FEWEST)) {
                at += syllable.chars().count();
                places.push(at);
            }
            places.pop(); // the end of the word
        }
        from += word.len() + 1;
    }
    places
}

#[cfg(test)]
mod tests;
