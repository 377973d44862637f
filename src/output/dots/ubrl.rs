//! Unicode braille, as the filters of CUPS pass it to each other: cells of eight dots, U+2800 to U+28FF.
//!
//! A row of cells is four rows of dots and ends with LF, a page ends with FF, the last one too. Every row has all its
//! cells, blank ones at its end as well, since that is what CUPS makes of a picture of the same dots.
//!
//! The way to an Index V3 with CUPS's own driver, A4 with dots 2.0 mm apart (the driver's default is another page):
//!
//! ```text
//! lp -d PRINTER -o document-format=image/vnd.cups-ubrl -o PageSize=A4 -o GraphicDotDistance=200 \
//!    -o LibLouis=None -o LibLouis2=None page.ubrl
//! ```
//!
//! Without `LibLouis=None` the driver stops if it knows no braille table for the language that the computer is set
//! to. The driver for V4 and V5 in cups-filters 1.28 leaves out the header, and with it pitch and paper; send it what
//! [`index`](super::index) writes: `lp -d PRINTER -o raw page.idx`. A picture with a pixel a dot
//! ([`pixels`](super::pixels)) needs much more: `Edge=None Rotate=0 fitplot=False`, and 0 for TopMargin,
//! BottomMargin, LeftMargin, RightMargin, page-top, page-bottom, page-left and page-right, or the filters look for
//! edges, turn it, fit it to the page and shift it.

use super::FORM_FEED;
use super::dot_matrix::DotMatrix;

/// The pages as Unicode braille.
pub fn write(pages: &[DotMatrix]) -> String {
    let mut text = String::new();
    for page in pages {
        for cy in 0..page.rows().div_ceil(4) {
            text.extend((0..page.columns().div_ceil(2)).map(|cx| character(page.cell8(cx, cy))));
            text.push('\n');
        }
        text.push(FORM_FEED);
    }
    text
}

/// The blank cell.
const BLANK: u32 = 0x2800;

/// The character of a cell.
pub(super) fn character(cell: u8) -> char {
    char::from_u32(BLANK + u32::from(cell)).unwrap_or('\u{2800}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_whole_and_pages_end() {
        let page = DotMatrix::drawn("#..\n...\n...\n...\n..#\n");
        let text = "⠁⠀\n⠀⠁\n\u{c}";
        assert_eq!(write(std::slice::from_ref(&page)), text);
        assert_eq!(write(&[page.clone(), page]), text.repeat(2));
        assert_eq!((write(&[]), write(&[DotMatrix::drawn("")])), (String::new(), "\u{c}".into()));
    }
}
