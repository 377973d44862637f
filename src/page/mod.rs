//! stub
/// The finished page.
#[derive(Debug, Clone, Default)]
pub struct Page {}
