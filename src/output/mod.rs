//! Writers of a page.
pub mod svg;
