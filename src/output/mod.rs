//! Writers: of a page, and of contours as data.

mod dot_files;
pub mod dots;
mod format;
pub mod json;
pub(crate) mod layer;
pub mod pdf;
pub mod png;
mod png_file;
pub mod seal;
pub mod svg;
mod text;

pub use dot_files::write as write_dots;
pub use dots::index::Embossing;
pub use format::{DotFormat, DrawingFormat, Format};

/// What the PDF and the PNG of a page say of their program ([`pdf`], [`png`]).
const IN_PDF: &[u8] = b"xmlns:tactograph=";
const IN_PNG: &[u8] = b"Software\0\0\0\0\0tactograph ";

/// The words of a PNG end within so many bytes: title and description, which have some thousand letters.
const LONGEST_WORDS: usize = 1 << 16;

/// The format of a page of ours that these bytes are, of those from which pages are not read; none if they are
/// something else.
pub fn written_as(bytes: &[u8]) -> Option<&'static str> {
    let contains = |bytes: &[u8], what: &[u8]| bytes.windows(what.len()).any(|part| part == what);
    if bytes.starts_with(b"%PDF-") {
        contains(bytes, IN_PDF).then_some("PDF")
    } else if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        // its words stand before its pixels
        let words = &bytes[..bytes.len().min(LONGEST_WORDS)];
        contains(words, IN_PNG).then_some("PNG")
    } else {
        None
    }
}
