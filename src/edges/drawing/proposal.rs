//! What a drawing proposes as a contour, what of it is confirmed, and stretches of either.

use crate::edges::edgel::Edgel;
use crate::geom::polyline::Polyline;
use crate::units::PxPoint;

/// A line that the drawing proposes as a contour.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Proposal {
    pub(super) line: Polyline<PxPoint>,
    /// Width of the stroke of which it is the centre line, px; none of an outline.
    pub(super) stroke: Option<f32>,
    /// Whether the stroke is dashed; the line has no gaps.
    pub(super) dashed: bool,
}

/// A proposal, or a part of one, that the picture confirms.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Confirmed {
    pub(super) line: Polyline<Edgel>,
    pub(super) stroke: Option<f32>,
    /// At how many of its segments it is a stroke along the border of a darker or lighter area.
    pub(super) on_borders: usize,
    /// Whether it is a stroke that is much thinner and paler than others.
    pub(super) faint: bool,
}

/// Segments that follow one another, in a ring perhaps over its first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SegmentRun {
    pub(super) first: usize,
    pub(super) count: usize,
    /// Whether it is all of a ring.
    pub(super) whole_ring: bool,
}

impl SegmentRun {
    /// Numbers of its segments; those of a ring go on after the last.
    pub(super) fn indices(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }
}

/// The longest stretches of segments that are wanted.
pub(super) fn stretches(wanted: &[bool], closed: bool) -> Vec<SegmentRun> {
    let n = wanted.len();
    if n > 0 && wanted.iter().all(|wanted| *wanted) {
        return vec![SegmentRun { first: 0, count: n, whole_ring: closed }];
    }
    // a ring is gone round from a segment that is not wanted
    let start = if closed { wanted.iter().position(|wanted| !wanted).unwrap_or(0) } else { 0 };
    let mut found: Vec<SegmentRun> = Vec::new();
    let mut before = false;
    for k in start..start + n {
        let here = wanted[k % n];
        if here {
            match found.last_mut() {
                Some(stretch) if before => stretch.count += 1,
                _ => found.push(SegmentRun { first: k, count: 1, whole_ring: false }),
            }
        }
        before = here;
    }
    found
}

#[cfg(test)]
mod tests;
