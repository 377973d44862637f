//! By which numbers textures are drawn.

use super::palette::Palette;

/// How textures are drawn. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Least clearance between a glyph and the edge of a line.
    pub line_gap: f32,
    /// Distance of rhombuses along their row.
    pub along: f32,
    /// Distance of rows; larger than `along`, or fingers feel columns instead of rows.
    pub across: f32,
    /// Length of the boldest rhombus.
    pub length: f32,
    /// Thickness of the boldest rhombus.
    pub thickness: f32,
    /// Diameter of the boldest dot.
    pub dot: f32,
    /// Distance of dots.
    pub dot_pitch: f32,
    /// Thickness of the lightest glyph, the thinnest that is printed, and the least clearance between two glyphs.
    pub min_glyph: f32,
    /// Sigma of the blur that makes the map of line density.
    pub density_blur: f32,
    /// Local line density (1 on a lone straight line) from which the texture is as dense as it gets; above 0.
    pub dense_from: f32,
    /// Lightness from which there is no texture; glyphs grow from here on.
    pub white_from: f32,
    /// Which sign stands for which class.
    pub palette: Palette,
}

#[cfg(test)]
impl Params {
    /// What most tests draw with.
    pub(super) const TEST: Self = Self {
        line_gap: 3.0,
        along: 2.8,
        across: 4.0,
        length: 2.2,
        thickness: 1.2,
        dot: 1.5,
        dot_pitch: 3.2,
        min_glyph: 0.6,
        density_blur: 8.0,
        dense_from: 0.5,
        white_from: 0.92,
        palette: Palette::PAPER,
    };
}
