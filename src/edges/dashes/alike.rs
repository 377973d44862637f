//! Lengths and widths of the dashes of one row, which are alike.

/// Lengths and widths of a row are alike if the greatest is at most so many times the least, beside [`ROUNDING`]: of
/// its dashes, but for the first and last one, which may be cut, and of its gaps.
pub(super) const ALIKE: f32 = 1.6;
/// What blur and the grid of pixels change in a length, px.
pub(super) const ROUNDING: f32 = 2.0;

/// Whether two lengths or widths, px, are alike, as those of one row are.
pub(super) fn are_alike(a: f32, b: f32) -> bool {
    a.max(b) <= ALIKE * a.min(b) + ROUNDING
}
