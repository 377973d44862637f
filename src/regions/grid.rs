//! The cells that a picture is divided into for its regions.

use std::ops::Range;

use crate::units::{PxPoint, Size};

/// Most cells of a picture, for which the distances in this module were chosen (photographs of 481 x 321 pixels); a
/// larger picture has larger cells, so that time does not grow with it.
const MOST_CELLS: f64 = 200_000.0;

/// How far from a place a trace or a border may pass and still count there, cells.
pub(super) const REACH: f32 = 2.5;

/// Cells over a picture, corner on corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegionGrid {
    /// Columns and rows of cells.
    pub cells: Size,
    /// The picture in pixels.
    pub picture: Size,
}

impl RegionGrid {
    /// The cells of a picture of this size.
    pub fn new(picture: Size) -> Self {
        let scale = (MOST_CELLS / picture.area().max(1) as f64).sqrt().min(1.0);
        let side = |pixels: u32| ((f64::from(pixels) * scale).round() as u32).clamp(1, pixels.max(1));
        Self { cells: Size::new(side(picture.width), side(picture.height)), picture }
    }

    /// A place of the picture, in cells.
    pub(super) fn to_cells(self, at: PxPoint) -> PxPoint {
        let across = self.cells.width as f32 / self.picture.width as f32;
        let down = self.cells.height as f32 / self.picture.height as f32;
        PxPoint::new(at.x * across, at.y * down)
    }

    /// A place in cells, in the picture.
    pub(super) fn to_picture(self, at: PxPoint) -> PxPoint {
        let across = self.picture.width as f32 / self.cells.width as f32;
        let down = self.picture.height as f32 / self.cells.height as f32;
        PxPoint::new(at.x * across, at.y * down)
    }

    /// The columns and the rows of the cells that may be nearer than `reach` to a place in cells; none beside the grid.
    pub(super) fn around(self, at: PxPoint, reach: f32) -> [Range<usize>; 2] {
        let range = |v: f32, end: u32| {
            // to 32 bits first, which processors do in one step
            let [from, to] = [(v - reach).max(0.0) as u32, (v + reach).max(0.0) as u32];
            from.min(end) as usize..to.saturating_add(1).min(end) as usize
        };
        [range(at.x, self.cells.width), range(at.y, self.cells.height)]
    }

    /// The number of the cell at a place in cells; none outside.
    pub(super) fn cell_at(self, at: PxPoint) -> Option<usize> {
        let inside = |v: f32, end: u32| v >= 0.0 && v < end as f32;
        (inside(at.x, self.cells.width) && inside(at.y, self.cells.height))
            .then(|| at.y as u32 as usize * self.cells.width as usize + at.x as u32 as usize)
    }
}

#[cfg(test)]
mod tests;
