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
