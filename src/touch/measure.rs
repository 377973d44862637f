//! The model: what a fingertip that slides over ink feels, by the structure tensor of the blurred ink.
//!
//! ```text
//! ink (8 px/mm) -> blur (fingertip) -> minus its own wide blur -> gradient -> structure tensor over a window -> Feel
//! ```
//!
//! A fingertip of size f is a Gaussian of sigma f mm: finer detail merges under it. The mean over the window is
//! subtracted from the blurred ink, because a border or a gradual change of ink is no texture. The structure tensor
//! of the remaining slopes (gradients per mm, averaged over the window; J. Bigun and G. Granlund, Optimal orientation
//! detection of linear symmetry, 1987) gives their coherence and direction. Slopes that are small compared with the
//! ink are not felt: the denominator of the coherence has a tenth of the ink added.

use crate::raster::plane::Plane;
use crate::units::Size;

/// Sizes of fingertips that can be asked for, mm: beyond the largest, the window is no wider than the fingertip.
pub const FINGERS: std::ops::RangeInclusive<f32> = 0.3..=2.5;
/// Resolution of ink, px per mm: 0.125 mm is a fifth of the smallest glyph and less than half of the finest fingertip.
pub const PX_PER_MM: u32 = 8;
/// Resolution of what is felt, cells per mm. The window is wider by far.
pub const CELLS_PER_MM: u32 = 2;
/// Sigma of the window over which a texture is felt, mm: about the pad of a finger.
pub const WINDOW: f32 = 3.0;
/// Less ink than this (share of the area, over the window) is felt as blank.
pub const BLANK: f32 = 0.004;
/// Slopes below this share of the ink, divided by the size of the fingertip, count as flat.
const FAINT: f32 = 0.10;

/// Coherence from which a direction is felt, by the size of the fingertip, mm. A fine fingertip feels single glyphs,
/// whose sides have many directions; a broad one feels only rows.
const DIRECTED_FROM: [(f32, f32); 3] = [(0.5, 0.12), (1.0, 0.30), (1.5, 0.35)];

/// What is felt in one cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feel {
    /// Ink over the window, 0..=1.
    pub ink: f32,
    /// Coherence of the slopes: 0 no common direction, 1 all the same.
    pub coherence: f32,
    /// Direction of the rows, degrees counter-clockwise from the x axis as a reader sees the page, 0..180.
    pub degrees: f32,
}

/// What is felt over an area: [`CELLS_PER_MM`] cells a millimetre, rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Feels {
    /// Cells from left to right and from top to bottom.
    pub size: Size,
    /// What is felt in each cell.
    pub cells: Vec<Feel>,
}

/// The coherence from which a fingertip of `finger` mm feels a direction; linear between the three
/// measured sizes.
pub fn directed_from(finger: f32) -> f32 {
    let [(first, least), .., (_, most)] = DIRECTED_FROM;
    if finger <= first {
        return least;
    }
    let pair = DIRECTED_FROM.windows(2).find(|pair| finger <= pair[1].0);
    pair.map_or(most, |pair| pair[0].1 + (pair[1].1 - pair[0].1) * (finger - pair[0].0) / (pair[1].0 - pair[0].0))
}

/// Feels `ink` ([`PX_PER_MM`], 0 white and 1 black, sides of whole millimetres) with a fingertip of `finger` mm.
/// Beyond the border the nearest pixel counts, so leave some blank round the texture.
pub fn feel(ink: &Plane, finger: f32) -> Feels {
    let per_cell = PX_PER_MM / CELLS_PER_MM;
    let size = Size::new(ink.size.width / per_cell, ink.size.height / per_cell);
    let window = WINDOW * CELLS_PER_MM as f32;
    let mut blurred = ink.blurred(finger * PX_PER_MM as f32);
    let wide = blurred.shrunk(size).blurred(window);
    subtract(&mut blurred, &wide);
    let [xx, xy, yy] = slopes(&blurred, size).map(|plane| plane.blurred(window));
    let mean = ink.shrunk(size).blurred(window);
    let cells = (0..size.len()).map(|i| {
        let (xx, xy, yy, ink) = (xx.values[i], xy.values[i], yy.values[i], mean.values[i]);
        let faint = FAINT * ink / finger;
        let coherence = (xx - yy).hypot(2.0 * xy) / (xx + yy + faint * faint).max(f32::MIN_POSITIVE);
        // rows run across the slope; y points down here and up for a reader
        let degrees = (-90.0 - 0.5 * (2.0 * xy).atan2(xx - yy).to_degrees()).rem_euclid(180.0);
        Feel { ink, coherence, degrees }
    });
    Feels { size, cells: cells.collect() }
}

/// Subtracts a coarse plane over the same area from a fine one.
fn subtract(fine: &mut Plane, coarse: &Plane) {
    let width = fine.size.width as usize;
    let scale = coarse.size.width as f32 / fine.size.width as f32;
    for (y, row) in fine.values.chunks_exact_mut(width).enumerate() {
        for (x, value) in row.iter_mut().enumerate() {
            *value -= coarse.at((x as f32 + 0.5) * scale, (y as f32 + 0.5) * scale);
        }
    }
}

/// Products of the gradient (per mm), averaged over cells: along x, both, along y.
fn slopes(plane: &Plane, size: Size) -> [Plane; 3] {
    let (width, height) = (plane.size.width as usize, plane.size.height as usize);
    let per_mm = 0.5 * PX_PER_MM as f32;
    let mut products = [Plane::filled(size, 0.0), Plane::filled(size, 0.0), Plane::filled(size, 0.0)];
    let (columns, rows) = (size.width as usize, size.height as usize);
    let (across, down) = (width / columns, height / rows);
    let share = 1.0 / (across * down) as f32;
    for y in 0..rows * down {
        let row = |y: usize| &plane.values[y * width..(y + 1) * width];
        let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
        for x in 0..columns * across {
            let gx = per_mm * (here[(x + 1).min(width - 1)] - here[x.saturating_sub(1)]);
            let gy = per_mm * (below[x] - above[x]);
            let cell = y / down * columns + x / across;
            products[0].values[cell] += share * gx * gx;
            products[1].values[cell] += share * gx * gy;
            products[2].values[cell] += share * gy * gy;
        }
    }
    products
}

#[cfg(test)]
mod tests;
