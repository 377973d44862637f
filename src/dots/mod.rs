//! Lines become dots that a device can press: evenly along the line, on the device's grid or anywhere.
//!
//! ```text
//! on a grid:  Line -> trace (the cells it runs through, one dot wide) -> clear (empty dots between lines) -> thick -> dots
//! anywhere:   Line -> walk (even steps along the line)                -> clear                            -> dots
//! ```
//!
//! A line is never drawn first and sampled then: a thresholded stroke has clots where it crosses the grid, and gaps between
//! dots are what a finger feels.

mod cells;
mod clear;
pub mod textures;
mod thick;
mod trace;
mod walk;

use crate::devices::DotArea;
use crate::lines::{Height, Line, Run};
use crate::units::{MmPoint, MmRect};

/// How lines become dots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Distance of dots along a line, mm; on a grid that of its columns and rows.
    pub pitch: f32,
    /// Diameter of a dot as it is felt, mm.
    pub diameter: f32,
    /// Empty dots between two lines, at least.
    pub line_gap: u32,
    /// Height of a colour step from which a line is heavy: two dots wide or, on a device with heights, higher.
    pub heavy_from: f32,
    /// Whether the device has heights.
    pub has_heights: bool,
    /// A line shorter than this is left out, mm.
    pub min_length: f32,
}

/// Two lines that are this much further apart than their dots must be, as a share, still are so once they are on the grid: lines
/// at 45 degrees lose most, whose dots on both sides come within half a diagonal of one another. Chosen by us, between 1,
/// with which slanting lines lose many dots, and 1.18, with which none do but fewer lines find room.
const ROUNDING: f32 = 1.08;

impl Params {
    /// Least distance of the middles of two lines, mm.
    pub fn centres(&self) -> f32 {
        (self.line_gap + 1) as f32 * self.pitch * ROUNDING
    }

    fn is_heavy(&self, line: &Line) -> bool {
        line.strength >= self.heavy_from
    }

    fn height(&self, line: &Line) -> Height {
        if self.has_heights && !self.is_heavy(line) { Height::Middle } else { Height::High }
    }

    fn is_wide(&self, line: &Line) -> bool {
        !self.has_heights && self.is_heavy(line)
    }
}

/// The dots of lines, the weightiest first; all of them lie in `area`. A line that is left with too few of its dots is left out.
pub fn lines(lines: &[Line], area: MmRect, room: &DotArea, params: &Params) -> Vec<Line> {
    match room {
        DotArea::Grid(grid) => clear::on_grid(lines, area, grid, params),
        DotArea::Free(_) => clear::anywhere(lines, area, params),
    }
}

/// The dots of one run by itself, such as a mark beside the picture.
pub fn mark(points: &[MmPoint], room: &DotArea, params: &Params) -> Run {
    let points = match room {
        DotArea::Grid(grid) => {
            let traced = trace::trace(points, false, grid);
            traced.into_iter().map(|cell| cells::centre(cell, grid)).collect()
        }
        DotArea::Free(_) => walk::along(points, false, params.pitch),
    };
    dotted(points, Height::High, params)
}

fn dotted(points: Vec<MmPoint>, height: Height, params: &Params) -> Run {
    Run::dots(params.diameter, points, height)
}

/// The way of a line through all its runs, and whether it is closed.
fn way(line: &Line) -> (Vec<MmPoint>, bool) {
    let mut way: Vec<MmPoint> = Vec::new();
    for run in &line.runs {
        let shared = usize::from(way.last().is_some() && way.last() == run.points.first());
        way.extend(run.polyline().path().skip(shared));
    }
    let closed = way.len() > 2 && way.first() == way.last();
    (way, closed)
}
