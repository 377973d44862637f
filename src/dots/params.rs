//! How lines become dots, and a line as one polyline.

use crate::geom::polyline::Polyline;
use crate::lines::{self, Height, Line, Run};
use crate::units::MmPoint;

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
    /// Whether a line that is level and upright for the most part, such as the outline of a bar or a wall with a door,
    /// has its second row along all of it or not at all, as in drawings: of a wall that is broad in part a finger does
    /// not know where it is.
    pub whole_rows: bool,
    /// Whether the device has heights.
    pub has_heights: bool,
    /// The least strength of a line, which those of faint strokes have.
    pub least_strength: f32,
    /// A line shorter than this is left out, mm.
    pub min_length: f32,
}

/// Dots anywhere that are nearer than this share of the pitch to one already there are left out: two needles' marks
/// would run together.
pub(super) const LEAST_STEP: f32 = 0.75;
/// Factor on the distance of two lines so that rounding to the grid leaves their dots far enough apart. Lines at 45
/// degrees need most, whose dots on both sides come within half a diagonal of one another. Chosen by us, between 1,
/// with which slanting lines lose many dots, and 1.18, with which they lose none but fewer lines fit.
const ROUNDING: f32 = 1.08;

/// Fewer dots than this are no line, and no piece of a second row.
pub(super) const LEAST_DOTS: usize = 3;
/// What rounding may take off a length, mm.
pub(super) const ROUNDED_OFF: f32 = 1e-3;

#[cfg(test)]
impl Params {
    /// An Index, but for the heavy lines, from which tests differ in what they are about.
    pub(super) const TEST: Self = Self {
        pitch: 2.0,
        diameter: 1.6,
        line_gap: 2,
        heavy_from: 50.0,
        whole_rows: false,
        has_heights: false,
        least_strength: 5.0,
        min_length: 12.5,
    };
}

impl Params {
    /// How far a line may be from the contours that it stands for, and so from the marks on these, mm.
    pub fn farthest_moved(&self) -> f32 {
        lines::farthest_moved(self.centres())
    }

    /// Least distance of the middles of two lines, mm.
    pub fn centres(&self) -> f32 {
        self.clearance() * ROUNDING
    }

    /// Least distance of dots of two lines, mm.
    pub(super) fn clearance(&self) -> f32 {
        (self.line_gap + 1) as f32 * self.pitch
    }

    fn is_heavy(&self, line: &Line) -> bool {
        line.strength >= self.heavy_from
    }

    /// The height of a line's dots.
    pub(super) fn height(&self, line: &Line) -> Height {
        if self.has_heights && !self.is_heavy(line) { Height::Middle } else { Height::High }
    }

    /// Whether a line has a second row of dots.
    pub(super) fn has_second_row(&self, line: &Line) -> bool {
        !self.has_heights && self.is_heavy(line)
    }

    /// A run of dots.
    pub fn run(&self, points: Vec<MmPoint>, height: Height) -> Run {
        Run::dots(self.diameter, points, height)
    }
}

/// A line through all its runs.
pub(super) fn polyline_of(line: &Line) -> Polyline<MmPoint> {
    let mut path: Vec<MmPoint> = Vec::new();
    for run in &line.runs {
        let shared = usize::from(path.last().is_some() && path.last() == run.points.first());
        path.extend(run.polyline().path().skip(shared));
    }
    Polyline::from_path(path)
}
