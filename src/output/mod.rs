//! Writers: of a page, and of contours as data.

pub mod json;
pub mod svg;
