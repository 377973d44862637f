//! Print beside the braille, for those who see: small, above its braille, within the blank that braille has around it.

use super::label::CLEARANCE;
use crate::Note;
use crate::page::{BrailleText, Medium, Parts, PrintText, TextRole};
use crate::profile::Plan;
use crate::units::MmPoint;

/// Sizes of letters that are tried, mm: 3 is 8.5 points, as captions are printed; 2.5 is 7.
const SIZES: [f32; 2] = [3.0, 2.5];
/// From the letters' line to the dots below, mm: tails of letters take a fifth of their size.
const ABOVE: f32 = 0.7;
/// Width of a letter as a share of the size: broader than the mean of Helvetica (0.5), since other fonts may be there.
const LETTER: f32 = 0.56;
/// Print keeps this far from the edge of the sheet, mm: many printers leave 4 mm blank.
const EDGE: f32 = 4.5;

/// The print beside the braille of a page; none unless the profile asks for it and the page is printed.
pub(super) fn of(parts: &Parts, plan: &Plan) -> Vec<PrintText> {
    let wanted = plan.profile().braille.print && matches!(parts.medium, Medium::Print(_));
    if wanted { parts.braille.iter().filter_map(|text| beside(text, parts.sheet)).collect() } else { Vec::new() }
}

/// What has no room beside its braille; none if all has.
pub(super) fn left_out(parts: &Parts, plan: &Plan) -> Option<Note> {
    if !plan.profile().braille.print || !matches!(parts.medium, Medium::Print(_)) {
        return None;
    }
    let lost = parts.braille.iter().filter(|text| beside(text, parts.sheet).is_none());
    let lost: Vec<String> = lost.map(|text| format!("\"{}\"", text.text)).collect();
    let why = "there is no room in print beside their braille (braille.print)";
    (!lost.is_empty()).then(|| Note::LeftOut(format!("{} in print, as {why}", lost.join(", "))))
}

/// Print above the first line of a text's braille, from where it begins: all of it, or its abbreviation. A title may be
/// as long as the sheet is wide.
fn beside(text: &BrailleText, sheet: [f32; 2]) -> Option<PrintText> {
    let place = text.dots.bounds()?;
    let room = match text.role {
        TextRole::Title | TextRole::Key => sheet[0] - EDGE - place.min.x,
        TextRole::Label | TextRole::Number => place.width() + CLEARANCE,
    };
    let at = MmPoint::new(place.min.x, place.min.y - ABOVE);
    let is_on_sheet = |size: f32| at.y - size >= EDGE;
    let words = [Some(&text.text), text.abbreviation.as_ref()];
    let tried = words.into_iter().flatten().flat_map(|words| SIZES.map(|size| (words, size)));
    let fits =
        |(words, size): &(&String, f32)| words.chars().count() as f32 * LETTER * size <= room && is_on_sheet(*size);
    let (words, size) = tried.into_iter().find(fits)?;
    let string = words.split_whitespace().collect::<Vec<_>>().join(" ");
    (!string.is_empty()).then_some(PrintText { string, at, size })
}

#[cfg(test)]
mod tests {
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
        assert_eq!((whole.string.as_str(), whole.size), ("Brazil", 3.0));
        assert!(whole.at.y < 100.0 - 0.65 && whole.at.y - 0.75 * whole.size > 100.0 - 0.65 - CLEARANCE);
        let short = label("Federal Republic", Some("fr"), 8.5, 100.0).expect("its abbreviation fits");
        assert_eq!(short.string, "fr");
        assert_eq!(label("Federal Republic", None, 8.5, 100.0), None);
        assert_eq!(label("Brazil", None, 32.5, 5.0), None, "printers leave the edge blank");
    }
}
