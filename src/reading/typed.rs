//! Texts that a person typed into a page: braille is written as it is, and so are labels; print letters are told.

use std::collections::HashMap;

use usvg::roxmltree::Node;

use super::document::{TypedElement, is_in_labels};
use super::print::{font_size, is_print_words};
use super::subpath::clean;
use crate::listing::first_few;
use crate::page::PrintText;
use crate::units::MmPoint;
use crate::{About, Note, Reason};

/// A text that is to be written in braille.
#[derive(Debug, Clone, PartialEq)]
pub struct TypedText {
    /// What it says, in letters or in Unicode braille.
    pub string: String,
    /// Where it begins, mm on the sheet.
    pub at: MmPoint,
    /// Whether it is Unicode braille: then it is meant to stand where it is.
    pub is_braille: bool,
}

/// Most texts that are told one by one.
const MOST: usize = 5;

/// Whether a text is written in Unicode braille.
pub fn is_braille(text: &str) -> bool {
    text.chars().all(|c| c == ' ' || ('\u{2800}'..='\u{28ff}').contains(&c))
}

/// Whether a text of a page is one that is written in braille where the page is rendered: a label, or braille.
pub fn is_written(node: Node<'_, '_>, text: &str) -> bool {
    is_in_labels(node) || is_braille(text)
}

/// Texts that are to be written, those in print, and what is told of the others.
pub(super) fn sorted(
    texts: Vec<TypedElement<'_>>,
    places: &HashMap<String, (MmPoint, f32)>,
) -> (Vec<TypedText>, Vec<PrintText>, Option<Note>) {
    let (mut written, mut print, mut left) = (Vec::new(), Vec::new(), Vec::new());
    for TypedElement { id, node, string, is_label } in texts {
        match places.get(id) {
            Some(&(at, unit)) if is_print_words(node) => {
                print.push(PrintText { string, at, size: clean(font_size(node, unit)) });
            }
            Some(&(at, _)) if is_label || is_braille(&string) => {
                written.push(TypedText { is_braille: is_braille(&string), string, at });
            }
            Some((at, _)) => left.push(format!("\"{string}\" at {:.0}, {:.0} mm", at.x, at.y)),
            None => left.push(format!("\"{string}\"")),
        }
    }
    let told = (!left.is_empty()).then(|| {
        let what = "fingers read no print letters; in a layer called labels-text they are written in braille";
        Note::NotOnPage(
            About::Texts,
            Reason::PrintLetters,
            format!("text {}: {what}", first_few(&left, MOST, String::clone)),
        )
    });
    (written, print, told)
}
