//! stub

/// A checked profile.
#[derive(Debug, Clone, Default)]
pub struct Plan {}
