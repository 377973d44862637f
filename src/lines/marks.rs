//! Marks on lines that are handed on, to be drawn where the lines become dots: a row of dots has no beads, and room on
//! it is counted in dots.

use crate::units::{MmPoint, MmRect, MmVector};

/// So many points that are alike on one line are a series, as the months of a curve in a chart.
pub(super) const SERIES: usize = 4;
/// A series is drawn if there is room for at least this share of its points.
const MOSTLY: f32 = 0.75;

/// Points, ticks and heads of arrows on the lines of a drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineMarks {
    /// Points, such as those of a number line.
    pub points: Vec<PointMark>,
    /// The ticks of each scale that are to be drawn where its line becomes dots, in order along it.
    pub scales: Vec<Vec<TickMark>>,
    /// The ticks that are left out of scales whose others are drawn as lines: what they are is told of the scale.
    pub left_out: Vec<TickMark>,
    /// The heads of arrows, those that are drawn already too.
    pub heads: Vec<HeadMark>,
}

/// Points are of one size if their radii differ by no more than this share.
const SAME_SIZE: f32 = 0.2;

/// A small round shape on a line, or by itself.
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
    /// Whether it lies beside all lines, as those of a scatter plot do.
    pub is_alone: bool,
    /// Height of its colour step.
    pub strength: f32,
}

impl PointMark {
    /// Whether two points look alike.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        self.is_filled == other.is_filled && (self.radius / other.radius - 1.0).abs() <= SAME_SIZE
    }
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
    /// Strength of its line at that end.
    pub strength: f32,
    /// By how much its line ends before what it points at, for the head to have room there, mm.
    pub shortened: f32,
    /// Whether its line is among those that are drawn.
    pub has_shaft: bool,
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

/// Which points are drawn, where there is room for these: none of a series of which too few have room. A few of them
/// are felt as special ones; without them the line still says where it bends. `series` has the number of the series of
/// each point.
pub fn whole_series(series: &[Option<usize>], has_room: &[bool]) -> Vec<bool> {
    let is_whole = |of: usize| {
        let own = || series.iter().zip(has_room).filter(|(series, _)| **series == Some(of));
        own().filter(|(_, has_room)| **has_room).count() as f32 >= MOSTLY * own().count() as f32
    };
    series.iter().zip(has_room).map(|(of, has_room)| *has_room && of.is_none_or(is_whole)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_series_without_room_nothing_is_drawn() {
        let series = [Some(7), Some(7), None, Some(7), Some(7), Some(2), Some(2), Some(2), Some(2)];
        let has_room = [true, false, true, false, true, true, true, false, true];
        let drawn = [false, false, true, false, false, true, true, false, true];
        assert_eq!(whole_series(&series, &has_room), drawn);
    }
}
