//! How textures of dots are drawn, and what is known of every point of the figure.

use super::small_components::Least;
use crate::classes::{Class, Classes};
use crate::raster::plane::Plane;
use crate::textures::{Palette, RegionMap, boldness_of};
use crate::units::{MmPoint, MmRect};

/// How textures of dots are drawn. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// From dot to dot; on a grid that of the grid, or for braille cells the dots' within a cell.
    pub pitch: f32,
    /// Diameter of a dot. Only drawings of the dots need it, and the edge of the picture, which no dot crosses.
    pub diameter: f32,
    /// Empty dots between a line and a texture.
    pub line_gap: u32,
    /// The same in an area that would lose more than half of its texture otherwise, such as a bar of a chart; at most
    /// `line_gap`.
    pub least_gap: u32,
    /// The least that is a texture.
    pub least: Least,
    /// Sigma of the blur that makes the map of line density.
    pub density_blur: f32,
    /// Local line density (1 on a lone straight line) from which lines count in full; above 0.
    pub dense_from: f32,
    /// HSL lightness, 0..=1, from which there is no texture.
    pub white_from: f32,
    /// The sign of each class. What a grid makes of it says [`carried`](super::carried).
    pub palette: Palette,
}

/// What is known of every point of the figure.
pub(super) struct Field<'a> {
    pub(super) borders: RegionMap<'a>,
    pub(super) density: Plane,
    pub(super) classes: &'a Classes,
    pub(super) area: MmRect,
    pub(super) params: &'a Params,
}

impl Field<'_> {
    /// The region at a point and how much texture there is, 0..=1; `None` where there is none.
    pub(super) fn at(&self, at: MmPoint) -> Option<(u32, f32)> {
        let region = self.borders.region_at(at)?;
        let from_corner = at - self.area.min;
        let density = self.density.at(from_corner.x, from_corner.y);
        amount(self.borders.lightness_at(at), density, self.params).map(|amount| (region, amount))
    }

    pub(super) fn class_of(&self, region: u32) -> Class {
        self.classes.regions[region as usize].class
    }

    /// Whether a whole dot lies in the picture.
    pub(super) fn holds(&self, at: MmPoint) -> bool {
        let radius = 0.5 * self.params.diameter;
        self.area.inflate(-radius, -radius).contains_inclusive(at)
    }
}

/// How much texture a colour of this lightness has where lines have this density, 0..=1: half of it comes from
/// darkness, half from lines. `None` where the colour is white.
fn amount(lightness: f32, density: f32, params: &Params) -> Option<f32> {
    let boldness = boldness_of(lightness, params.white_from);
    let near = (density / params.dense_from.max(f32::EPSILON)).clamp(0.0, 1.0);
    (boldness > 0.0).then_some(0.5 * (boldness + near))
}
