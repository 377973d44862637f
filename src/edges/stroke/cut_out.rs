//! Whether what lies on an even ground is a photograph: a thing that was cut out, or taken before a wall.
//!
//! A picture that is mostly flat is a drawing, but for these. In a drawing what is not ground is mostly flat too:
//! areas of one colour; and the rest are strokes. A thing of a photograph is flat nowhere.

use super::flat::shrunk_to_squares;
use crate::geom::components::{self, Connectivity};
use crate::raster::Raster;
use crate::raster::lab;
use crate::raster::plane::Plane;
use crate::raster::residue::square_max;
use crate::units::Size;

// The numbers were chosen on the stamps of a paint program for children, on white that is up to four times as large: of
// 95 photographs of things 87 are found. Of 100 drawings 5 are taken for photographs (as JPEG of quality 75: 7), all of
// them shaded all over, such as a pumpkin, whose pages are the better for it.

/// Squares that differ from their neighbours by no more than this are flat, in units of strength.
const FLAT: f32 = 0.8;
/// Weight of chroma, which in a JPEG has steps in flat areas.
const CHROMA: f32 = 0.5;
/// Squares that differ by more than this have a stroke or a border.
const LINE: f32 = 8.0;
/// A thing is of a photograph if less than this share of it is flat, strokes and borders aside.
const FLAT_SHARE: f32 = 0.1;
/// A thing with less than this share of the picture is too small to tell, strokes and borders aside.
const SMALLEST: f32 = 0.01;
/// Least share of a thing, borders aside, that has no ground within two squares (30 photographs have 0.66 to 1). Of a
/// thin stroke nothing has, and its middle is no steeper than the shading of a photograph where it is pale.
const BROAD: f32 = 0.25;
/// Least share of all that is not ground: a worksheet may have a photograph beside its words and lines.
const MOST: f32 = 0.9;

/// Whether most of what is not ground in a picture is a photograph.
pub(in crate::edges) fn is_cut_out(raster: &Raster) -> bool {
    let Some(squares) = shrunk_to_squares(raster) else { return false };
    let (size, steps) = (squares.size(), steps(&squares));
    let flat: Vec<bool> = steps.iter().map(|step| *step <= FLAT).collect();
    let is_ground = ground(&flat, size);
    let of_ground: Vec<u8> = is_ground.iter().map(|set| u8::from(*set)).collect();
    // beside the ground a square may have a part of it
    let [near_ground, around_ground] = [1, 2].map(|radius| square_max(&of_ground, size, radius, false));
    let is_told = |cell: usize| near_ground[cell] == 0 && steps[cell] <= LINE;
    let (mut all, mut of_photographs) = (0, 0);
    let things: Vec<bool> = is_ground.iter().map(|set| !set).collect();
    for thing in components::of_set(&things, size, Connectivity::Eight) {
        let told: Vec<usize> = thing.iter().copied().filter(|cell| is_told(*cell)).collect();
        let even = told.iter().filter(|cell| flat[**cell]).count();
        let inner = told.iter().filter(|cell| around_ground[**cell] == 0).count();
        let is_large = told.len() as f32 >= SMALLEST * size.len() as f32;
        let is_broad = inner as f32 >= BROAD * told.len() as f32;
        all += thing.len();
        if is_large && is_broad && (even as f32) < FLAT_SHARE * told.len() as f32 {
            of_photographs += thing.len();
        }
    }
    of_photographs > 0 && of_photographs as f32 >= MOST * all as f32
}

/// By how much each pixel differs from its four neighbours, at most, in units of strength.
fn steps(raster: &Raster) -> Vec<f32> {
    let width = raster.size().width as usize;
    let mut steps = vec![0.0_f32; raster.size().len()];
    for (Plane { values, .. }, weight) in lab::whole(raster).iter().zip([1.0, CHROMA, CHROMA]) {
        for cell in 0..values.len() {
            let next = (cell % width + 1 < width).then_some(cell + 1);
            for other in [next, Some(cell + width)].into_iter().flatten().filter(|other| *other < values.len()) {
                let step = weight * (values[cell] - values[other]).abs();
                steps[cell] = steps[cell].max(step);
                steps[other] = steps[other].max(step);
            }
        }
    }
    steps
}

/// What is flat and reaches the sides of the picture.
fn ground(flat: &[bool], size: Size) -> Vec<bool> {
    let (width, height) = (size.width as usize, size.height as usize);
    let is_at_side = |cell: &usize| {
        let (x, y) = (cell % width, cell / width);
        x == 0 || y == 0 || x + 1 == width || y + 1 == height
    };
    let mut ground = vec![false; flat.len()];
    let areas = components::of_set(flat, size, Connectivity::Four);
    areas.iter().filter(|cells| cells.iter().any(is_at_side)).flatten().for_each(|cell| ground[*cell] = true);
    ground
}

#[cfg(test)]
mod tests;
