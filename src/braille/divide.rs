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
mod tests {
    use super::*;

    /// Divided as dictionaries of each language divide them; the ends that are too short stay with what is beside them.
    #[test]
    fn words_are_divided_by_their_language() {
        for (language, divided) in [
            ("en", "tem-per-a-ture"),
            ("de", "Re-gen-was-ser"),
            ("de", "Nie-der-schlags-men-gen"),
            ("fr", "tem-pé-ra-ture"),
            ("es", "tem-pe-ra-tu-ra"),
            ("pl", "tem-pe-ra-tu-ra"),
            ("it", "tem-pe-ra-tu-ra"),
            ("nl", "tem-pe-ra-tuur"),
            ("pt", "tem-pe-ra-tura"),
            ("cs", "ne-moc-ni-ce"),
            ("sv", "tem-pe-ra-tur"),
        ] {
            let plain: Vec<char> = divided.chars().filter(|c| *c != '-').collect();
            let mut with: String = String::new();
            for (i, letter) in plain.iter().enumerate() {
                if places(&plain, language).contains(&i) {
                    with.push('-');
                }
                with.push(*letter);
            }
            assert_eq!(with, divided, "{language}");
        }
    }

    #[test]
    fn units_abbreviations_and_short_words_stay_whole() {
        let text: Vec<char> = "NATIONAL McDonald 5kilometer over a, temperature2".chars().collect();
        // "over" has two syllables, and its second has two letters: English asks for three
        assert!(places(&text, "en").is_empty(), "{:?}", places(&text, "en"));
        let text: Vec<char> = "a temperature".chars().collect();
        assert!(places(&text, "ja").is_empty() && places(&text, "").is_empty());
        assert_eq!(places(&text, "en").first(), Some(&5));
    }
}
