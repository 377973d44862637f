//! The frame: rows of fine dots around a picture, neutral as the texture of grey and much finer. Of dots that a
//! device raises it is a single row: on a grid a ring of dots, every so many, with as many empty dots inside it as
//! make up its gap.

use super::medium::DotMedium;
use super::parts::Dots;
use super::sheet::FrameParams;
use crate::devices::{DotArea, Grid};
use crate::units::{MmPoint, MmRect, MmVector};

/// A frame of several rows, for print: rows as in a hexagonal lattice, as many as the band has room for, the
/// innermost at its inner edge.
pub fn printed(picture: MmRect, params: &FrameParams) -> Dots {
    let row_pitch = params.pitch * 0.75_f32.sqrt();
    let rows = ((params.width - params.dot) / row_pitch).floor().max(0.0) as u32 + 1;
    let mut dots = Dots { diameter: params.dot, at: Vec::new() };
    for row in 0..rows {
        let out = params.gap + 0.5 * params.dot + row as f32 * row_pitch;
        even(picture.inflate(out, out), params.pitch, row % 2 == 1, &mut dots.at);
    }
    dots
}

/// Dots evenly on the four sides: whole steps with a dot in each corner, or half a step further for every other row.
fn even(rect: MmRect, pitch: f32, between: bool, dots: &mut Vec<MmPoint>) {
    let (right, down) = (MmVector::new(rect.width(), 0.0), MmVector::new(0.0, rect.height()));
    let corners = [rect.min, rect.min + right, rect.max, rect.min + down];
    for (i, &from) in corners.iter().enumerate() {
        let side = corners[(i + 1) % 4] - from;
        let steps = (side.length() / pitch).round().max(1.0);
        let shift = if between { 0.5 } else { 0.0 };
        dots.extend((0..steps as u32).map(|k| from + side * ((k as f32 + shift) / steps)));
    }
}

/// A frame of one row, of dots that a device raises.
pub fn dotted(picture: MmRect, params: &FrameParams, medium: &DotMedium) -> Dots {
    match &medium.area {
        DotArea::Grid(grid) => ring(picture, grid, params, medium),
        DotArea::Free(_) => {
            let (width, pitch) = (medium.diameter(), params.pitch.max(1.5 * medium.pitch));
            printed(picture, &FrameParams { width, dot: width, pitch, gap: params.gap })
        }
    }
}

/// Empty dots between the frame and the picture.
pub(super) fn empty(params: &FrameParams, medium: &DotMedium) -> i32 {
    (params.gap / medium.pitch).round().max(1.0) as i32
}

/// The frame around a picture on a grid: dots of a ring about so many apart, one in each corner.
fn ring(picture: MmRect, grid: &Grid, params: &FrameParams, medium: &DotMedium) -> Dots {
    let out = empty(params, medium) + 1;
    let step = (params.pitch / medium.pitch).round().max(2.0) as i32;
    let range = |from: f32, to: f32, centres: &[f32]| {
        let first = centres.partition_point(|&centre| centre < from) as i32;
        let last = centres.partition_point(|&centre| centre <= to) as i32 - 1;
        [(first - out).max(0), (last + out).min(centres.len() as i32 - 1)]
    };
    let [left, right] = range(picture.min.x, picture.max.x, &grid.columns);
    let [top, bottom] = range(picture.min.y, picture.max.y, &grid.rows);
    let mut cells: Vec<(i32, i32)> = along(left, right, step).flat_map(|x| [(x, top), (x, bottom)]).collect();
    cells.extend(along(top, bottom, step).flat_map(|y| [(left, y), (right, y)]));
    cells.sort_unstable_by_key(|&(x, y)| (y, x));
    cells.dedup();
    let at = cells.into_iter().filter_map(|(x, y)| grid.at(usize::try_from(x).ok()?, usize::try_from(y).ok()?));
    Dots { diameter: medium.diameter(), at: at.collect() }
}

/// Places from `low` to `high`, both of them, about `step` dots of a grid apart: even to one dot, and never side by
/// side, as a finger on a frame feels one wider or narrower space as a mark. They lie alike from both ends, so that a
/// flipped picture has the flipped frame; an odd length so has an odd number of spaces.
fn along(low: i32, high: i32, step: i32) -> impl Iterator<Item = i32> {
    let length = high - low;
    let most = (length / 2).max(1);
    let nearest = ((2 * length + step) / (2 * step)).clamp(1, most);
    let may_be = |count: &i32| (1..=most).contains(count) && (length % 2 == 0 || count % 2 == 1);
    let around = [nearest, nearest - 1, nearest + 1].into_iter().filter(may_be);
    let count = around.min_by_key(|count| (length - count * step).abs()).unwrap_or(1);
    // rounded to the nearest dot
    let offset = move |k: i32| (2 * k * length + count) / (2 * count);
    (0..=count / 2).flat_map(move |k| [low + offset(k), high - offset(k)])
}

#[cfg(test)]
mod tests;
