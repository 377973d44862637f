//! Texts that a person typed into a page: braille is written as it is, and so are labels; print letters are told.

use std::collections::HashMap;

use super::document::{TypedElement, lines_of};
use super::marks::TextPlace;
use super::print::{anchor, font_size, is_light, is_print_words};
use super::subpath::clean;
use crate::listing::first_few;
use crate::page::PrintText;
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason};

/// A text that is to be written in braille.
#[derive(Debug, Clone, PartialEq)]
pub struct TypedText {
    /// What it says, in letters or in Unicode braille.
    pub string: String,
    /// Its place, mm on the sheet: where it begins, or what its anchor says.
    pub at: MmPoint,
    /// The share of it that lies before that.
    pub anchor: f32,
    /// Whether it is Unicode braille: then it is meant to stand where it is.
    pub is_braille: bool,
}

impl TypedText {
    /// The same by the place where it begins, if it is so wide, mm.
    pub fn from_its_begin(&self, width: f32) -> Self {
        Self { at: MmPoint::new(self.at.x - self.anchor * width, self.at.y), anchor: 0.0, ..self.clone() }
    }
}

/// A text that is shown in letters or in a font of braille.
#[derive(Debug, Clone, PartialEq)]
pub struct SeenText {
    /// What it says.
    pub string: String,
    /// Its place, mm on the sheet.
    pub at: MmPoint,
    /// The box around it, about: how broad its letters are is not known.
    pub extent: MmRect,
    /// The line of the file in which its element begins.
    pub row: u32,
    /// Whether it is written in braille where the page is rendered.
    pub is_written: bool,
}

/// Where texts are shown, by their keys.
type Places = HashMap<String, TextPlace>;

/// Measures of letters as shares of their size, as most fonts have them: how broad one is, how far it reaches above and
/// below its line, and how far one line is from the next.
const BROAD: f32 = 0.55;
const ABOVE: f32 = 0.75;
const BELOW: f32 = 0.25;
const LINES: f32 = 1.2;

/// The box around a text, about. No fonts are loaded, so that it is the same on all machines.
fn extent(text: &TypedElement<'_>, place: &TextPlace) -> MmRect {
    let size = font_size(text.node, place.unit);
    let (lines, letters) = lines_of(text.node);
    let width = BROAD * size * letters as f32;
    let left = -anchor(text.node, text.shown_by) * width;
    let (top, bottom) = (-ABOVE * size, (BELOW + LINES * lines.saturating_sub(1) as f32) * size);
    let [along, down] = place.axes;
    let corners = [(left, top), (left + width, top), (left, bottom), (left + width, bottom)];
    MmRect::from_points(corners.map(|(x, y)| place.at + along * x + down * y))
}

/// The texts that are shown, but for words in print that are too light to rise.
pub(super) fn seen(texts: &[TypedElement<'_>], places: &Places) -> Vec<SeenText> {
    let seen = |text: &TypedElement<'_>| {
        let place = places.get(&text.key)?;
        let row = text.node.document().text_pos_at(text.shown_by.range().start).row;
        let is_written = text.is_label || is_braille(&text.string);
        let is_light_print = is_print_words(text.shown_by) && is_light(text.node);
        let (string, extent) = (text.string.clone(), extent(text, place));
        (!is_light_print).then_some(SeenText { string, at: place.at, extent, row, is_written })
    };
    texts.iter().filter_map(seen).collect()
}

/// Most texts that are told one by one.
const MOST: usize = 5;

/// Whether a text is written in Unicode braille.
pub fn is_braille(text: &str) -> bool {
    text.chars().all(|c| c == ' ' || ('\u{2800}'..='\u{28ff}').contains(&c))
}

/// Texts that are to be written, those in print, and what is told of the others. What is hidden has no place.
pub(super) fn sorted(texts: Vec<TypedElement<'_>>, places: &Places) -> (Vec<TypedText>, Vec<PrintText>, Option<Note>) {
    let (mut written, mut print, mut left) = (Vec::new(), Vec::new(), Vec::new());
    for TypedElement { key, node, shown_by, string, is_label } in texts {
        let Some(&TextPlace { at, unit, .. }) = places.get(&key) else { continue };
        let is_braille = is_braille(&string);
        if is_print_words(shown_by) {
            print.push(PrintText { string, at, size: clean(font_size(node, unit)) });
        } else if is_label || is_braille {
            written.push(TypedText { is_braille, string, at, anchor: anchor(node, shown_by) });
        } else {
            left.push(format!("\"{string}\" at {:.0}, {:.0} mm", at.x, at.y));
        }
    }
    let told = (!left.is_empty()).then(|| {
        let what = "fingers read no print letters; in a layer called labels-text they are written in braille";
        Note::NotOnPage(
            About::Texts,
            Reason::PrintLetters,
            format!("text {}: {what}", first_few(&left, MOST, String::clone)).into(),
        )
    });
    (written, print, told)
}
