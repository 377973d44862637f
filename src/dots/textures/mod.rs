//! Regions become patterns of equal dots: the textures of a device that knows no rhombuses.
//!
//! The meaning is that of [`crate::textures`]: *direction* by class, here by rows of dots, and none for the class that is told
//! by dots; fewer dots where a colour is light and where lines are far. A dot has one size, so both act on the *number* of
//! dots. Nothing stands where the picture is white.
//!
//! `pattern` says which patterns fingers read right at which pitch, and what a device cannot carry.

mod free;
mod grid;
mod pattern;
mod strays;
#[cfg(test)]
mod tests;

pub use pattern::{Way, carried};

use crate::classes::{Class, Classes, Region};
use crate::devices::DotArea;
use crate::lines::Line;
use crate::raster::plane::Plane;
use crate::textures::{Glyph, Palette, RegionMap, Shape, Texture, boldness_of, line_density};
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
    /// The same in an area that would lose more than half of its texture otherwise, such as a bar of a chart; at most `line_gap`.
    pub least_gap: u32,
    /// Sigma of the blur that makes the map of line density.
    pub density_blur: f32,
    /// Local line density (1 on a lone straight line) from which lines count in full; above 0.
    pub dense_from: f32,
    /// HSL lightness, 0..=1, from which there is no texture.
    pub white_from: f32,
    /// Which class is told by which sign. What a grid makes of it says [`carried`].
    pub palette: Palette,
}

/// Fills the regions of `classes`, whose cells cover `area` of the sheet, with dots clear of `lines`, which are given as
/// drawn: the points of their runs are the centres of dots. Every glyph is a [`Shape::Dot`] of `params.diameter`, and the
/// sign of a texture is the one that its dots make. Where there is room for a few dots only, none are set.
///
/// Fringes ([`Classes::fringe`]) are not shown: a single dot has no direction to turn.
pub fn fill(classes: &Classes, area: MmRect, lines: &[Line], room: &DotArea, params: &Params) -> Vec<Texture> {
    let mut field = Field {
        borders: RegionMap::new(classes, area),
        density: line_density(lines, area, params.density_blur),
        classes,
        area,
        params,
    };
    let filled = |field: &Field<'_>| match room {
        DotArea::Grid(grid) => grid::fill(field, lines, grid),
        DotArea::Free(part) => free::fill(field, lines, *part),
    };
    let mut sets = filled(&field);
    let narrow = Params { line_gap: params.least_gap, ..*params };
    if params.line_gap > params.least_gap {
        // Areas that the wider gap takes most of, such as a bar of a chart, keep the narrower one. Dots at the wider gap are dots at the
        // narrower one as well, so neighbours keep their distance.
        field.params = &narrow;
        let closer = filled(&field);
        for (set, closer) in sets.iter_mut().zip(closer).filter(|(set, closer)| 2 * set.len() < closer.len()) {
            *set = closer;
        }
    }
    let cell = area.area() / classes.size.area() as f32;
    let texture = |(region, at): (&Region, Vec<MmPoint>)| {
        let sign = pattern::sign(params.palette.sign(region.class), room);
        let shape = Shape::Dot { diameter: params.diameter };
        let glyphs = at.into_iter().map(|at| Glyph { at, shape }).collect();
        Texture { class: region.class, sign, colour: region.colour, area: region.cells as f32 * cell, glyphs }
    };
    let mut textures: Vec<Texture> = classes.regions.iter().zip(sets).map(texture).collect();
    textures.retain(|texture| !texture.glyphs.is_empty());
    textures.sort_by_key(|texture| texture.class);
    textures
}

/// What is known of every place of the figure.
struct Field<'a> {
    borders: RegionMap<'a>,
    density: Plane,
    classes: &'a Classes,
    area: MmRect,
    params: &'a Params,
}

impl Field<'_> {
    /// The region at a place and how much texture there is, 0..=1; `None` where there is none.
    fn at(&self, at: MmPoint) -> Option<(u32, f32)> {
        let region = self.borders.region_at(at)?;
        let from_corner = at - self.area.min;
        let density = self.density.at(from_corner.x, from_corner.y);
        amount(self.borders.lightness_at(at), density, self.params).map(|amount| (region, amount))
    }

    fn class_of(&self, region: u32) -> Class {
        self.classes.regions[region as usize].class
    }

    /// Whether a whole dot lies in the picture.
    fn holds(&self, at: MmPoint) -> bool {
        let radius = 0.5 * self.params.diameter;
        self.area.inflate(-radius, -radius).contains_inclusive(at)
    }
}

/// How much texture a colour of this lightness has where lines have this density, 0..=1: half of it comes from darkness,
/// half from lines. `None` where the colour is white.
fn amount(lightness: f32, density: f32, params: &Params) -> Option<f32> {
    let boldness = boldness_of(lightness, params.white_from);
    let near = (density / params.dense_from.max(f32::EPSILON)).clamp(0.0, 1.0);
    (boldness > 0.0).then_some(0.5 * (boldness + near))
}

/// The texture of a class at one lightness (HSL, 0..=1) and one density of lines (0..=1) all over `area`: a sample for charts
/// and tests.
pub fn sample(class: Class, lightness: f32, density: f32, area: MmRect, room: &DotArea, params: &Params) -> Texture {
    let size = crate::units::Size::new(1, 1);
    let colour = [(255.0 * lightness).round() as u8; 3];
    let classes = Classes {
        size,
        region: vec![Some(0)],
        regions: vec![Region { class, colour, cells: 1 }],
        lightness: Plane::filled(size, lightness),
        fringe: Vec::new(),
    };
    let field = Field {
        borders: RegionMap::new(&classes, area),
        density: Plane::filled(size, density),
        classes: &classes,
        area,
        params,
    };
    let mut sets = match room {
        DotArea::Grid(grid) => grid::fill(&field, &[], grid),
        DotArea::Free(part) => free::fill(&field, &[], *part),
    };
    let shape = Shape::Dot { diameter: params.diameter };
    let glyphs = sets.pop().unwrap_or_default().into_iter().map(|at| Glyph { at, shape }).collect();
    let sign = pattern::sign(params.palette.sign(class), room);
    Texture { class, sign, colour, area: area.area(), glyphs }
}
