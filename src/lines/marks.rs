//! Marks on lines that are handed on, to be drawn where the lines become dots: a row of dots has no beads, and room on
//! it is counted in dots.

use crate::units::{MmPoint, MmRect, MmVector};

/// Points, ticks and heads of arrows on the lines of a drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineMarks {
    /// Points, such as those of a number line.
    pub points: Vec<PointMark>,
    /// The ticks of each scale, in order along its line.
    pub scales: Vec<Vec<TickMark>>,
    /// The heads of arrows, those that are drawn already too.
    pub heads: Vec<HeadMark>,
}

/// A small round shape on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMark {
    /// Its middle.
    pub at: MmPoint,
    /// Its radius in the drawing, mm.
    pub radius: f32,
    /// Whether it is a disc, and not a ring.
    pub is_filled: bool,
    /// The number of the series that it is of, as the points of a curve.
    pub series: Option<usize>,
}

/// The head of an arrow at the end of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadMark {
    /// Its tip, where its line ends.
    pub at: MmPoint,
    /// Which way it points: of length 1.
    pub toward: MmVector,
    /// What it covers in the drawing.
    pub extent: MmRect,
    /// Whether it is among the lines already.
    pub is_drawn: bool,
}

/// A tick on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TickMark {
    /// Where it stands on its line, or crosses it.
    pub at: MmPoint,
    /// Which way its line runs there.
    pub along: MmVector,
    /// Its free ends: to the left of its line, as that runs, and to the right.
    pub ends: [Option<MmPoint>; 2],
}

impl TickMark {
    /// How far it goes to each side of its line, mm.
    pub fn sides(&self) -> [Option<f32>; 2] {
        self.ends.map(|end| end.map(|end| (end - self.at).length()))
    }

    /// Its length, mm.
    pub fn length(&self) -> f32 {
        self.sides().into_iter().flatten().sum()
    }

    /// Its first and its last place.
    pub fn segment(&self) -> (MmPoint, MmPoint) {
        (self.ends[0].unwrap_or(self.at), self.ends[1].unwrap_or(self.at))
    }
}
