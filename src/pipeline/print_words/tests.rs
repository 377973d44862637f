//! Tests of `print_words`.

use super::*;
use crate::page::Dots;

fn label(words: &str, abbreviation: Option<&str>, width: f32, top: f32) -> Option<PrintText> {
    let at = vec![MmPoint::new(50.0, top), MmPoint::new(50.0 + width, top + 5.0)];
    let text = BrailleText {
        role: TextRole::Label,
        text: words.into(),
        language: "en".into(),
        abbreviation: abbreviation.map(str::to_owned),
        lines: Vec::new(),
        dots: Dots { diameter: 1.3, at },
        leader: None,
    };
    beside(&text, [210.0, 297.0])
}

#[test]
fn print_stays_in_the_blank_around_its_braille() {
    let whole = label("Brazil", None, 32.5, 100.0).expect("it fits");
    assert_eq!((whole.string.as_str(), whole.size), ("Brazil", 2.5));
    // tails of letters stay as far from the dots as they are long
    assert!(
        whole.at.y + 2.0 * 0.2 * whole.size < 100.0 - 0.65 && whole.at.y - 0.75 * whole.size > 100.0 - 0.65 - CLEARANCE
    );
    let short = label("Federal Republic", Some("fr"), 8.5, 100.0).expect("its abbreviation fits");
    assert_eq!(short.string, "fr");
    assert_eq!(label("Federal Republic", None, 8.5, 100.0), None);
    assert_eq!(label("Brazil", None, 32.5, 5.0), None, "printers leave the edge blank");
}
