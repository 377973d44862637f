//! Regions become textures: small rhombuses whose direction names the colour, dots for grey.
//!
//! Three things vary and nothing else: the *direction* of the lattice by class, the *boldness* of the glyph by lightness,
//! the *density* of the lattice by how many lines are near. Around every line the page stays white, and no
//! glyph crosses a border between classes or the edge of the picture.

mod density;
mod glyph;
mod lattice;
mod palette;

pub use glyph::{Glyph, Shape};
pub use palette::{LEAST_ANGLE, Palette, Sign};

use crate::classes::{Class, Classes};
use crate::geom::nearby::{Nearby, Segment};
use crate::lines::Line;
use crate::units::{MmPoint, MmRect};

/// How textures are drawn. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Least blank between a glyph and the edge of a line.
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
    /// Thickness of the lightest glyph, the thinnest that is printed.
    pub min_glyph: f32,
    /// Sigma of the blur that makes the map of line density.
    pub density_blur: f32,
    /// Local line density (1 on a lone straight line) from which the texture is dense.
    pub dense_from: f32,
    /// Lightness from which there is no texture; glyphs grow from here on.
    pub white_from: f32,
}

/// The texture of one region.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// What colour it says.
    pub class: Class,
    /// Its glyphs, row by row.
    pub glyphs: Vec<Glyph>,
}

/// A region with room for fewer glyphs than this stays empty: a stray mark has no direction, it is only felt as dirt.
const MIN_GLYPHS: usize = 4;

/// Fills the regions of `classes`, whose cells cover `area` of the sheet, clear of `lines`. Regions without room for a few
/// glyphs give no texture.
pub fn fill(classes: &Classes, area: MmRect, lines: &[Line], params: &Params) -> Vec<Texture> {
    let runs = lines.iter().flat_map(|line| &line.runs);
    let widest = runs.map(|run| run.width).fold(0.0, f32::max);
    let lines_near = index(lines, area, params);
    let reach = params.line_gap + 0.5 * widest;
    let density = density::map(lines, area, params.density_blur);
    let mut textures: Vec<Texture> =
        classes.regions.iter().map(|region| Texture { class: region.class, glyphs: Vec::new() }).collect();
    let (columns, rows) = (classes.size.width as f32, classes.size.height as f32);
    let cell_of =
        |at: MmPoint| ((at.x - area.min.x) / area.width() * columns, (at.y - area.min.y) / area.height() * rows);
    let region_at = |at: MmPoint| -> Option<u32> {
        let (x, y) = cell_of(at);
        let (x, y) = (x.floor() as i64, y.floor() as i64);
        let inside = x >= 0 && y >= 0 && x < i64::from(classes.size.width) && y < i64::from(classes.size.height);
        if inside { classes.region[y as usize * classes.size.width as usize + x as usize] } else { None }
    };
    for class in Class::ALL {
        if !classes.regions.iter().any(|region| region.class == class) {
            continue;
        }
        lattice::each_place(class, area, params, |place| {
            let Some(region) = region_at(place.at).filter(|&r| textures[r as usize].class == class) else { return };
            if place.dense_only && density.at(place.at.x - area.min.x, place.at.y - area.min.y) < params.dense_from {
                return;
            }
            let (x, y) = cell_of(place.at);
            let Some(glyph) = glyph::bold(class, place.at, classes.lightness.at(x, y), params) else {
                return;
            };
            let corners = glyph.corners();
            if corners.iter().all(|&corner| region_at(corner) == Some(region) && area.contains_inclusive(corner))
                && is_clear(&glyph, &corners, &lines_near, params.line_gap, reach)
            {
                textures[region as usize].glyphs.push(glyph);
            }
        });
    }
    textures.retain(|texture| texture.glyphs.len() >= MIN_GLYPHS);
    textures.sort_by_key(|texture| texture.class);
    textures
}

/// All lines' segments by place.
fn index(lines: &[Line], area: MmRect, params: &Params) -> Nearby {
    let mut nearby = Nearby::new(area, params.line_gap + params.length);
    for (number, run) in lines.iter().flat_map(|line| &line.runs).enumerate() {
        for (i, pair) in run.points.windows(2).enumerate() {
            nearby.insert(Segment {
                a: pair[0],
                b: pair[1],
                half_width: 0.5 * run.width,
                line: number as u32,
                index: i as u32,
                arc: 0.0,
            });
        }
    }
    nearby
}

/// Whether a glyph keeps its distance `gap` from every line; `reach` is that of the widest line, to its middle.
fn is_clear(glyph: &Glyph, corners: &[MmPoint], lines: &Nearby, gap: f32, reach: f32) -> bool {
    let radius = glyph.radius();
    let mut clear = true;
    lines.around(glyph.at, glyph.at, reach + radius, |segment| {
        if clear {
            let from_centre = crate::geom::nearest_on_segment(glyph.at, segment.a, segment.b).0;
            let need = gap + segment.half_width;
            if from_centre < need + radius {
                clear = glyph.distance_to((segment.a, segment.b), corners) >= need;
            }
        }
    });
    clear
}

#[cfg(test)]
mod tests_support {
    /// What most tests draw with.
    pub(super) const PARAMS: super::Params = super::Params {
        line_gap: 3.0,
        along: 2.8,
        across: 3.4,
        length: 2.2,
        thickness: 1.2,
        dot: 1.5,
        dot_pitch: 3.0,
        min_glyph: 0.6,
        density_blur: 8.0,
        dense_from: 0.5,
        white_from: 0.92,
    };
}
