//! Texts that a person typed into a page: braille is written as it is, and so are labels; print letters are told.

use std::collections::HashMap;

use usvg::roxmltree::Node;

use super::document::{Typed, is_in_labels};
use crate::Note;
use crate::page::PrintText;
use crate::units::MmPoint;

/// A text that is to be written in braille.
#[derive(Debug, Clone, PartialEq)]
pub struct TypedText {
    /// What it says, in letters or in Unicode braille.
    pub string: String,
    /// Where it begins, mm on the sheet.
    pub at: MmPoint,
}

/// Most texts that are told one by one.
const MOST: usize = 5;

fn is_braille(text: &str) -> bool {
    text.chars().all(|c| c == ' ' || ('\u{2800}'..='\u{28ff}').contains(&c))
}

/// Whether a text of a page is one that is written in braille where the page is rendered: a label, or braille.
pub fn is_written(node: Node<'_, '_>, text: &str) -> bool {
    is_in_labels(node) || is_braille(text)
}

/// Texts that are to be written, those in print, and what is told of the others.
pub(super) fn sorted(
    texts: Vec<Typed<'_>>,
    places: &HashMap<String, MmPoint>,
) -> (Vec<TypedText>, Vec<PrintText>, Option<Note>) {
    let (mut written, mut print, mut left) = (Vec::new(), Vec::new(), Vec::new());
    for Typed { id, string, is_label, print: size } in texts {
        match places.get(id) {
            Some(&at) if size.is_some() => print.extend(size.map(|size| PrintText { string, at, size })),
            Some(&at) if is_label || is_braille(&string) => written.push(TypedText { string, at }),
            Some(at) => left.push(format!("\"{string}\" at {:.0}, {:.0} mm", at.x, at.y)),
            None => left.push(format!("\"{string}\"")),
        }
    }
    let more = left.len().saturating_sub(MOST);
    left.truncate(MOST);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let told = (!left.is_empty()).then(|| {
        let what = "fingers read no print letters; in a layer called labels-text they are written in braille";
        Note::LeftOut(format!("text {}{more}: {what}", left.join(", ")))
    });
    (written, print, told)
}
