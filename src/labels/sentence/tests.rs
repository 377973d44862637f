//! Tests of `sentence`.

use super::*;

#[test]
fn instructions_are_sentences() {
    for text in [
        "1. Find the area of the rectangle.",
        "2. How large is the angle x?",
        "b) Name this shape",
        "What is this?",
        "Colour the cells green",
        "Male drei Viertel des Kreises aus.",
        "Name: ______________ Date: ________",
        "Trage die Namen der Teile der Zelle ein",
    ] {
        assert!(is_sentence(text, false), "{text}");
    }
}

#[test]
fn names_quantities_and_headings_are_none() {
    for text in [
        "nucleus",
        "Living room",
        "Cape of Good Hope",
        "United States of America",
        "approx. 5 m.",
        "Rain in mm",
        "12 cm",
        "St. John's",
        "3. Dezember 2024",
        "y = x + 3",
        "a b c d e",
        "",
    ] {
        assert!(!is_sentence(text, false), "{text}");
    }
}

#[test]
fn beside_a_line_a_long_text_may_be_its_name() {
    assert!(is_sentence("Height of the water column", false));
    assert!(!is_sentence("Height of the water column", true));
    assert!(is_sentence("Colour the cells green.", true));
    assert!(is_sentence("3) Measure the water", true));
}
