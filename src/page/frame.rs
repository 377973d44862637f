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

/// The frame around a picture on a grid: every so many dots of a ring, one in each corner.
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
    // from both corners to the middle, so that a flipped picture has the flipped frame
    let steps = |low: i32, high: i32| {
        let half = (low..=(low + high) / 2).step_by(step as usize);
        half.flat_map(move |at| [at, low + high - at])
    };
    let mut cells: Vec<(i32, i32)> = steps(left, right).flat_map(|x| [(x, top), (x, bottom)]).collect();
    cells.extend(steps(top, bottom).flat_map(|y| [(left, y), (right, y)]));
    cells.sort_unstable_by_key(|&(x, y)| (y, x));
    cells.dedup();
    let at = cells.into_iter().filter_map(|(x, y)| grid.at(usize::try_from(x).ok()?, usize::try_from(y).ok()?));
    Dots { diameter: medium.diameter(), at: at.collect() }
}

#[cfg(test)]
mod tests;
