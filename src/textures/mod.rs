//! Regions become textures: small rhombuses whose direction names the colour, dots for grey.
//!
//! Three things vary and nothing else: the *direction* of the lattice by class, the *boldness* of the glyph by lightness,
//! the *density* of the lattice by how many lines are near. Around every line the page stays white, and no
//! glyph crosses a border between classes or the edge of the picture. No glyph is smaller, and no two are nearer to one another,
//! than the least that is felt: where a colour fades into white its glyphs shrink to that size, and then rows are left out.
//!
//! `lattice` says what was learned about lattices that fingers read right; [`crate::touch`] is the measure.

mod borders;
pub(crate) mod density;
mod glyph;
pub(crate) mod lattice;
mod palette;
mod strays;

#[cfg(test)]
mod tests;

pub use glyph::{Glyph, Shape};
pub use palette::{LEAST_ANGLE, Palette, Sign};

pub(crate) use borders::Borders;
pub(crate) use glyph::{boldness_of, unit};

use lattice::Place;

use crate::classes::{Class, Classes, Region};
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
    /// Thickness of the lightest glyph, the thinnest that is printed, and least blank between two glyphs.
    pub min_glyph: f32,
    /// Sigma of the blur that makes the map of line density.
    pub density_blur: f32,
    /// Local line density (1 on a lone straight line) from which the texture is as dense as it gets; above 0.
    pub dense_from: f32,
    /// Lightness from which there is no texture; glyphs grow from here on.
    pub white_from: f32,
    /// Which class is told by which sign.
    pub palette: Palette,
}

/// The texture of one region.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// What colour it says.
    pub class: Class,
    /// By which sign.
    pub sign: Sign,
    /// The region's mean colour as sRGB red, green and blue.
    pub colour: [u8; 3],
    /// The region's area, gaps and all, mm^2.
    pub area: f32,
    /// Its glyphs, row by row.
    pub glyphs: Vec<Glyph>,
}

/// Fills the regions of `classes`, whose cells cover `area` of the sheet, clear of `lines`. Where there is room for single
/// glyphs only, none are set; a region without room for a few gives no texture.
pub fn fill(classes: &Classes, area: MmRect, lines: &[Line], params: &Params) -> Vec<Texture> {
    let runs = lines.iter().flat_map(|line| &line.runs);
    let widest = runs.map(|run| run.width).fold(0.0, f32::max);
    let lines_near = index(lines, area, params);
    let reach = params.line_gap + 0.5 * widest;
    let density = density::map(lines, area, params.density_blur);
    let borders = Borders::new(classes, area);
    let cell = area.area() / classes.size.area() as f32;
    let empty = |region: &Region| {
        let Region { class, colour, cells } = *region;
        Texture { class, sign: params.palette.sign(class), colour, area: cells as f32 * cell, glyphs: Vec::new() }
    };
    let mut textures: Vec<Texture> = classes.regions.iter().map(empty).collect();
    for class in Class::ALL {
        if !classes.regions.iter().any(|region| region.class == class) {
            continue;
        }
        lattice::each_place(class, area, params, |place| {
            let Some(region) = borders.region_at(place.at).filter(|&r| textures[r as usize].class == class) else {
                return;
            };
            let at = place.at - area.min;
            let Some(glyph) = glyph_at(class, place, density.at(at.x, at.y), borders.lightness_at(place.at), params)
            else {
                return;
            };
            let leaning = borders.fringe_at(place.at).and_then(|class| params.palette.degrees(class));
            let glyph = leaning.map_or(glyph, |degrees| glyph.turned(degrees));
            let corners = glyph.corners();
            // Two neighbours that each keep half of the gap from their common border keep all of it from one another.
            if borders.keeps_inside(&glyph, &corners, region, 0.5 * params.min_glyph)
                && is_clear(&glyph, &corners, &lines_near, params.line_gap, reach)
            {
                textures[region as usize].glyphs.push(glyph);
            }
        });
    }
    for texture in &mut textures {
        strays::leave_out(&mut texture.glyphs, params);
    }
    textures.retain(|texture| !texture.glyphs.is_empty());
    textures.sort_by_key(|texture| texture.class);
    textures
}

/// The texture of a class at one lightness (HSL, 0..=1) and one density of lines (0..=1) all over `area`: a sample for charts
/// and tests.
pub fn sample(class: Class, lightness: f32, density: f32, area: MmRect, params: &Params) -> Texture {
    let mut glyphs = Vec::new();
    lattice::each_place(class, area, params, |place| {
        glyphs.extend(glyph_at(class, place, density, lightness, params).filter(|glyph| {
            let corners = glyph.corners();
            corners.iter().all(|corner| area.contains_inclusive(*corner))
        }));
    });
    let colour = [(255.0 * lightness).round() as u8; 3];
    Texture { class, sign: params.palette.sign(class), colour, area: area.area(), glyphs }
}

/// The glyph at a place where lines have this density and the colour this lightness, if there is one.
fn glyph_at(class: Class, place: Place, density: f32, lightness: f32, params: &Params) -> Option<Glyph> {
    let boldness = glyph::boldness(lightness, params);
    let dense = density >= place.from_density * params.dense_from;
    (dense && glyph::is_left(place.from_boldness, boldness)).then(|| glyph::bold(class, place.at, boldness, params))
}

/// All lines' segments by place.
fn index(lines: &[Line], area: MmRect, params: &Params) -> Nearby {
    let mut nearby = Nearby::new(area, params.line_gap + params.length);
    for (number, run) in lines.iter().flat_map(|line| &line.runs).enumerate() {
        for (i, (&a, &b)) in run.polyline().segments().enumerate() {
            nearby.insert(Segment {
                a,
                b,
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
        across: 4.0,
        length: 2.2,
        thickness: 1.2,
        dot: 1.5,
        dot_pitch: 3.2,
        min_glyph: 0.6,
        density_blur: 8.0,
        dense_from: 0.5,
        white_from: 0.92,
        palette: super::Palette::PAPER,
    };
}
