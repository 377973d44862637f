//! What the measuring programs share.

/// The root of the project, where `samples`, `docs` and `target` are.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
