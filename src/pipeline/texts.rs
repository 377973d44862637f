//! Texts of a picture that are not drawn, on the sheet.

use crate::raster::vector::DrawnText;
use crate::units::{MmRect, PageTransform};

/// A text of a picture that is not drawn, for labels in braille or a list beside the page.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Text {
    /// Its letters, without line breaks.
    pub string: String,
    /// The box around it, mm on the sheet.
    pub place: MmRect,
    /// Direction in which it is read, degrees counter-clockwise from left to right.
    pub angle: f32,
    /// Size of its font, mm.
    pub size: f32,
    /// Whether it is not painted, as the words that lie behind a scanned page are not: its letters are a part of the
    /// picture, if they are seen at all.
    pub hidden: bool,
}

/// Texts where they stand on the sheet.
pub(super) fn placed(texts: &[DrawnText], transform: &PageTransform) -> Vec<Text> {
    let placed = |text: &DrawnText| Text {
        string: text.string.clone(),
        place: MmRect::new(transform.to_mm(text.min), transform.to_mm(text.max)),
        angle: text.angle,
        size: text.size * transform.mm_per_px(),
        hidden: text.hidden,
    };
    texts.iter().map(placed).collect()
}
