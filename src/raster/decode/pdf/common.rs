//! What all of this module speaks of.

/// The format's name in messages.
pub(super) const FORMAT: &str = "PDF";

/// CSS pixels for a point, in which PDF measures.
pub(super) const PX_PER_POINT: f32 = 96.0 / 72.0;
