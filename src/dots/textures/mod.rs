//! Regions become patterns of equal dots: the textures of a device that has no rhombuses.
//!
//! The meaning is that of `textures`: *direction* by class, here by rows of dots, and no direction for the
//! class whose sign is dots; fewer dots where a colour is light and where lines are far. A dot has one size, so both
//! act on the *number* of dots. There are none where the picture is white.
//!
//! `pattern` records which patterns fingers read right at which pitch, and what a device cannot carry.

mod field;
mod free;
mod grid;
mod pattern;
mod small_components;
#[cfg(test)]
mod tests;

pub use field::Params;
pub use pattern::{RowDirection, carried};
pub use small_components::Least;

use crate::classes::{Class, Classes, Region};
use crate::devices::DotArea;
use crate::lines::Line;
use crate::raster::plane::Plane;
use crate::textures::{Glyph, RegionMap, Shape, Texture, line_density};
use crate::units::{MmPoint, MmRect, Size};
use field::Field;

/// Fills the regions of `classes`, whose cells cover `figure` on the sheet, with dots clear of `lines`, which are
/// given as drawn: the points of their runs are the centres of dots. Every glyph is a [`Shape::Dot`] of
/// `params.diameter`, and the sign of a texture is the one that its dots make. Where only a few dots would fit, none
/// are set.
///
/// Fringes ([`Classes::fringe`]) are not shown: a single dot has no direction to turn.
pub fn fill(classes: &Classes, figure: MmRect, lines: &[Line], area: &DotArea, params: &Params) -> Vec<Texture> {
    let field = Field {
        borders: RegionMap::new(classes, figure),
        density: line_density(lines, figure, params.density_blur),
        classes,
        area: figure,
        params,
    };
    let sets = dots(&field, lines, area);
    let cell = figure.area() / classes.size.area() as f32;
    let texture = |(region, dots): (&Region, Vec<MmPoint>)| {
        texture(region.class, region.colour, region.cells as f32 * cell, dots, area, params)
    };
    let mut textures: Vec<Texture> = classes.regions.iter().zip(sets).map(texture).collect();
    textures.retain(|texture| !texture.glyphs.is_empty());
    textures.sort_by_key(|texture| texture.class);
    textures
}

/// The dots of each region.
fn dots(field: &Field<'_>, lines: &[Line], area: &DotArea) -> Vec<Vec<MmPoint>> {
    match area {
        DotArea::Grid(grid) => {
            let candidates = grid::GridCandidates::of(field, grid);
            with_gaps(field.params, |gap| candidates.dots(lines, gap))
        }
        DotArea::Free(part) => {
            let candidates = free::FreeCandidates::of(field, *part);
            with_gaps(field.params, |gap| candidates.dots(lines, gap))
        }
    }
}

/// The dots of each region with the gap from lines that suits it: the wider one, unless that takes more than half of
/// the region's dots, as from a bar of a chart. Dots at the wider gap are dots at the narrower one as well, so
/// neighbouring textures keep their distance.
fn with_gaps(params: &Params, dots: impl Fn(u32) -> Vec<Vec<MmPoint>>) -> Vec<Vec<MmPoint>> {
    let mut sets = dots(params.line_gap);
    if params.line_gap > params.least_gap {
        for (set, closer) in sets.iter_mut().zip(dots(params.least_gap)) {
            if 2 * set.len() < closer.len() {
                *set = closer;
            }
        }
    }
    sets
}

fn texture(
    class: Class,
    colour: [u8; 3],
    area_mm2: f32,
    dots: Vec<MmPoint>,
    area: &DotArea,
    params: &Params,
) -> Texture {
    let shape = Shape::Dot { diameter: params.diameter };
    let glyphs = dots.into_iter().map(|at| Glyph { at, shape }).collect();
    Texture { class, sign: pattern::sign(params.palette.sign(class), area), colour, area: area_mm2, glyphs }
}

/// The texture of a class at one lightness (HSL, 0..=1) and one density of lines (0..=1) all over `figure`: a sample
/// for charts and tests.
pub fn sample(class: Class, lightness: f32, density: f32, figure: MmRect, area: &DotArea, params: &Params) -> Texture {
    let size = Size::new(1, 1);
    let colour = [(255.0 * lightness).round() as u8; 3];
    let classes = Classes {
        size,
        region: vec![Some(0)],
        regions: vec![Region { class, colour, cells: 1 }],
        lightness: Plane::filled(size, lightness),
        fringe: Vec::new(),
    };
    let field = Field {
        borders: RegionMap::new(&classes, figure),
        density: Plane::filled(size, density),
        classes: &classes,
        area: figure,
        params,
    };
    let dots = dots(&field, &[], area).pop().unwrap_or_default();
    texture(class, colour, figure.area(), dots, area, params)
}
