//! Writers: of a page, and of contours as data.

mod dot_files;
pub mod dots;
mod format;
pub mod json;
mod layer;
pub mod pdf;
pub mod png;
mod seal;
pub mod svg;
mod zlib;

pub use dot_files::{Embossing, write as write_dots};
pub use format::{DotFormat, DrawingFormat, Format};

/// Text that XML and other formats may hold: control characters are replaced.
fn plain(text: &str) -> String {
    let allowed = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => '\u{fffd}',
        c => c,
    };
    text.chars().map(allowed).collect()
}

/// How a page was made, as lines `name = value`.
fn origin_lines(origin: &[(String, String)]) -> impl Iterator<Item = String> {
    origin.iter().map(|(name, value)| plain(&format!("{name} = {value}")))
}
