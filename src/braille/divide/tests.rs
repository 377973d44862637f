//! Tests of `divide`.

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
