//! Dots on a device's grid, and the files that embossers, braille programs and pin displays take.
//!
//! Every writer takes the pages of a document, in order, and gives the same bytes for the same dots.
//!
//! | module | for whom | dots |
//! |---|---|---|
//! | [`ubrl`] | CUPS, and whoever reads Unicode | cells of 8 |
//! | [`pef`] | programs and embossers that know the Portable Embosser Format | cells of 8 |
//! | [`brf`] | every other embosser | cells of 6, which do not lie evenly on paper |
//! | [`index`] | Index embossers, straight | bands of 4 rows |
//! | [`text`] | eyes, braille displays, screen readers | a letter a dot |
//! | [`pixels`] | ViewPlus's own driver, pin displays | a pixel a dot, with heights |
//! | [`gcode`] | BrailleRAP | anywhere, in the order of [`path_order`] |

pub mod brf;
mod dot_matrix;
pub mod gcode;
pub mod index;
pub mod path_order;
pub mod pef;
pub mod pixels;
pub mod text;
pub mod ubrl;

pub use dot_matrix::{DotMatrix, dots};

/// What a document is called, for formats that state it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DocumentWords<'a> {
    /// Its name.
    pub title: &'a str,
    /// What is on it, in plain words; may be empty.
    pub description: &'a str,
    /// The language of its name as in BCP 47, such as `en`; empty if nobody knows.
    pub language: &'a str,
    /// The language of the description.
    pub description_language: &'a str,
    /// Lines in Unicode braille that stand in front of the pages, in formats that have pages of text.
    pub text: &'a [String],
}

/// Ends a page of text.
const FORM_FEED: char = '\u{c}';
