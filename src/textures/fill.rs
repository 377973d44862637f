//! Which glyphs fill which region.

use std::collections::BTreeMap;

use super::glyph::{self, Glyph, Texture, unit};
use super::lattice::{self, LatticePoint};
use super::maps::{RegionMap, line_density};
use super::params::Params;
use crate::classes::{Class, Classes, Region};
use crate::geom::components::Components;
use crate::geom::nearby::Nearby;
use crate::geom::{components, nearest_on_segment};
use crate::lines::{Line, index_of_lines};
use crate::units::{MmPoint, MmRect};

/// A connected component of fewer glyphs than this is no texture: single glyphs that stand apart, in a tongue of their
/// region or between two lines, have no direction and are felt as dirt.
const LEAST_COMPONENT: usize = 4;
/// In a photograph a component has at least so many glyphs: two rows of three rhombuses, or a ring of dots, which is
/// what the honeycomb of grey consists of. Fewer are felt as dirt, and two rows of two dots as a letter in braille. Of
/// drawings smaller ones stay, as there they may be all that says the colour of a bar or a window, whose outline is
/// felt as well.
const LEAST_IN_PHOTOGRAPH: usize = 6;
/// On a page with labels a component of dots has at least so many: a cell of braille has up to six, and one more does
/// not make a texture of it.
const LEAST_BESIDE_LABELS: usize = 8;
/// Of a component of rhombuses so large a share lies beside another one of its row. In a strip with room for one
/// rhombus of each row, such as a narrow bar of a chart, they are felt as one row, and that runs across their own:
/// level rows, blue, would be felt as upright ones, yellow.
const LEAST_IN_ROWS: f32 = 0.5;

/// Fills the regions of `classes`, whose cells cover `area` of the sheet, with a clearance from `lines`. Where there is
/// room for single glyphs only, none are set; a region without room for a few of them side by side gives no
/// texture.
pub fn fill(classes: &Classes, area: MmRect, lines: &[Line], params: &Params) -> Vec<Texture> {
    let runs = lines.iter().flat_map(|line| &line.runs);
    let widest = runs.map(|run| run.width).fold(0.0, f32::max);
    let lines_near = index_of_lines(lines, area, params.line_gap + params.length);
    let reach = params.line_gap + 0.5 * widest;
    let density = line_density(lines, area, params.density_blur);
    let regions = RegionMap::new(classes, area);
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
        lattice::each_position(class, area, params, |position| {
            let Some(region) = regions.region_at(position.at).filter(|&r| textures[r as usize].class == class) else {
                return;
            };
            let at = position.at - area.min;
            let Some(glyph) =
                glyph_at(class, position, density.at(at.x, at.y), regions.lightness_at(position.at), params)
            else {
                return;
            };
            let leaning = regions.fringe_at(position.at).and_then(|class| params.palette.degrees(class));
            let glyph = leaning.map_or(glyph, |degrees| glyph.turned(degrees));
            let corners = glyph.corners();
            // Two glyphs that each keep half of the gap from the boundary between them keep all of it from one another.
            if regions.keeps_inside(&glyph, &corners, region, 0.5 * params.min_glyph)
                && is_clear(&glyph, &corners, &lines_near, params.line_gap, reach)
            {
                textures[region as usize].glyphs.push(glyph);
            }
        });
    }
    for texture in &mut textures {
        remove_small_components(&mut texture.glyphs, params.palette.degrees(texture.class), params);
    }
    textures.retain(|texture| !texture.glyphs.is_empty());
    textures.sort_by_key(|texture| texture.class);
    textures
}

/// The texture of a class at one lightness (HSL, 0..=1) and one density of lines (0..=1) all over `area`: a sample for
/// charts and tests.
pub fn sample(class: Class, lightness: f32, density: f32, area: MmRect, params: &Params) -> Texture {
    let mut glyphs = Vec::new();
    lattice::each_position(class, area, params, |position| {
        glyphs.extend(glyph_at(class, position, density, lightness, params).filter(|glyph| {
            let corners = glyph.corners();
            corners.iter().all(|corner| area.contains_inclusive(*corner))
        }));
    });
    let colour = [(255.0 * lightness).round() as u8; 3];
    Texture { class, sign: params.palette.sign(class), colour, area: area.area(), glyphs }
}

/// The glyph at a position of the lattice where lines have this density and the colour this lightness, if there is one.
fn glyph_at(class: Class, position: LatticePoint, density: f32, lightness: f32, params: &Params) -> Option<Glyph> {
    let boldness = glyph::boldness(lightness, params);
    let dense = density >= position.from_density * params.dense_from;
    (dense && glyph::is_left(position.from_boldness, boldness))
        .then(|| glyph::bold(class, position.at, boldness, params))
}

/// Whether a glyph has a clearance of `gap` from every line; `reach` is `gap` and half the width of the widest line.
fn is_clear(glyph: &Glyph, corners: &[MmPoint], lines: &Nearby, gap: f32, reach: f32) -> bool {
    let radius = glyph.radius();
    let mut clear = true;
    lines.around(glyph.at, glyph.at, reach + radius, |segment| {
        if clear {
            let from_centre = nearest_on_segment(glyph.at, segment.a, segment.b).0;
            let need = gap + segment.half_width;
            if from_centre < need + radius {
                clear = glyph.distance_to((segment.a, segment.b), corners) >= need;
            }
        }
    });
    clear
}

/// Leaves out what is too small a patch of a photograph to be felt as a texture: `LEAST_IN_PHOTOGRAPH`.
pub fn leave_out_crumbs(textures: &mut Vec<Texture>, params: &Params) {
    leave_out_smaller(textures, params, |_| LEAST_IN_PHOTOGRAPH);
}

/// Leaves out patches of dots that are read as a cell on a page with labels: `LEAST_BESIDE_LABELS`.
pub fn leave_out_cells(textures: &mut Vec<Texture>, params: &Params) {
    leave_out_smaller(textures, params, |degrees| if degrees.is_none() { LEAST_BESIDE_LABELS } else { 0 });
}

/// Leaves out components of fewer glyphs than the least of a texture whose rows run in these degrees, or that has
/// dots. Dots are linked if they are no further apart than those of sparse grey, as a trail of single ones is no patch.
fn leave_out_smaller(textures: &mut Vec<Texture>, params: &Params, least: impl Fn(Option<f32>) -> usize) {
    for texture in textures.iter_mut() {
        let degrees = params.palette.degrees(texture.class);
        let apart = if degrees.is_some() { 2.0 * params.across } else { 3.0_f32.sqrt() * params.dot_pitch };
        let groups = components_within(&texture.glyphs, 1.01 * apart);
        components::retain(&mut texture.glyphs, &groups, |_, group| group.len() >= least(degrees));
    }
    textures.retain(|texture| !texture.glyphs.is_empty());
}

/// The components of glyphs of which two are linked if they are no further apart than this.
fn components_within(glyphs: &[Glyph], reach: f32) -> Components {
    let centres: Vec<MmPoint> = glyphs.iter().map(|glyph| glyph.at).collect();
    components::of_points(&centres, reach, |between| between.length() <= reach)
}

/// Removes small components of glyphs. Two glyphs are linked if they are no further apart than rows of the sparsest
/// texture, which are two rows of the dense one. So does a component without rows in the direction of its texture, if
/// that has one.
fn remove_small_components(glyphs: &mut Vec<Glyph>, degrees: Option<f32>, params: &Params) {
    let reach = 1.01 * (2.0 * params.across).max(3.0_f32.sqrt() * params.dot_pitch);
    let groups = components_within(glyphs, reach);
    components::retain(glyphs, &groups, |glyphs, group| {
        let is_felt = || degrees.is_none_or(|degrees| are_in_rows(glyphs, group, degrees, params));
        group.len() >= LEAST_COMPONENT && is_felt()
    });
}

/// Whether enough glyphs of a group lie side by side in rows of this direction, degrees: [`LEAST_IN_ROWS`].
fn are_in_rows(glyphs: &[Glyph], group: &[usize], degrees: f32, params: &Params) -> bool {
    let Some(first) = group.first().map(|&number| glyphs[number].at) else { return false };
    let (along, across) = (unit(degrees), unit(degrees + 90.0));
    let mut rows: BTreeMap<i32, Vec<f32>> = BTreeMap::new();
    for from in group.iter().map(|&number| glyphs[number].at - first) {
        let row = (from.dot(across) / params.across).round() as i32;
        rows.entry(row).or_default().push(from.dot(along));
    }
    let beside_another = |row: &mut Vec<f32>| {
        row.sort_by(f32::total_cmp);
        let stretches = row.chunk_by(|a, b| b - a <= 1.01 * params.along);
        stretches.map(<[f32]>::len).filter(|count| *count > 1).sum::<usize>()
    };
    let count: usize = rows.values_mut().map(beside_another).sum();
    count as f32 >= LEAST_IN_ROWS * group.len() as f32
}

#[cfg(test)]
mod tests;
