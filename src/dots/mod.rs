//! Lines become dots that a device can press: evenly along the line, on the device's grid or anywhere.
//!
//! ```text
//! on a grid:  Line -> rasterise (one dot wide) -> clearance (empty dots between lines) -> marks -> second row -> dots
//! anywhere:   Line -> spacing (even steps)     -> clearance                            -> marks -> second row -> dots
//! ```
//!
//! Dots are placed along the line itself, not sampled from a drawn stroke: a thresholded stroke has clots where it
//! crosses the grid, and gaps between dots are what a finger feels.

mod clearance;
mod grid_dot;
mod marks;
mod params;
mod rasterise;
mod second_row;
mod spacing;
pub mod textures;

pub use clearance::{GOES_ON, STEPS, least_arc, longest_approach, longest_cut};
pub use marks::{Shown, ShownScale};
pub use params::Params;

use crate::devices::DotArea;
use crate::geom::polyline::PolylineRef;
use crate::geom::spaced_row::every_second;
use crate::lines::{Height, Line, LineMarks, Run};
use crate::units::{MmPoint, MmRect};

/// The dots of lines, the strongest first; all of them lie in `part` of the sheet. A line that is left with too few
/// of its dots is left out.
pub fn lines(lines: &[Line], part: MmRect, area: &DotArea, params: &Params) -> Vec<Line> {
    with_marks(lines, &LineMarks::default(), part, area, params).0
}

/// The same with marks on the lines, and which of these are drawn.
pub fn with_marks(
    lines: &[Line],
    marks: &LineMarks,
    part: MmRect,
    area: &DotArea,
    params: &Params,
) -> (Vec<Line>, Shown) {
    match area {
        DotArea::Grid(grid) => clearance::on_grid(lines, marks, part, grid, params),
        DotArea::Free(_) => clearance::anywhere(lines, marks, part, params),
    }
}

/// The dots of an open line by itself, such as a mark beside the picture.
pub fn mark(points: &[MmPoint], area: &DotArea, params: &Params) -> Run {
    let line = PolylineRef { vertices: points, closed: false };
    let points = match area {
        DotArea::Grid(grid) => {
            let cells = rasterise::rasterise(line, grid).cells;
            cells.into_iter().map(|cell| grid_dot::centre(cell, grid)).collect()
        }
        DotArea::Free(_) => spacing::evenly(line, params.pitch),
    };
    params.run(points, Height::High)
}

/// The dots of a leader line from a label to what it names, the last of its points.
pub fn leader_line(points: &[MmPoint], area: &DotArea, params: &Params) -> Run {
    let row = mark(points, area, params);
    Run { points: every_second(&row.points, params.pitch), ..row }
}
