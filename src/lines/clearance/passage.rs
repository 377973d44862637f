//! Where a polyline meets the lines that are drawn.

use super::cluster::Cluster;
use crate::geom::nearby::Segment;
use crate::geom::nearest_on_segment;
use crate::geom::walk::arc_between;
use crate::units::{MmPoint, MmVector};

/// A line ends on another if it comes this near, mm: twice the tolerance of simplification that profiles have (0.05),
/// so that it is drawn so (see [`super::anchor`], which gives the other a vertex there), and far less than a finger
/// notices.
pub(crate) const TOUCH: f32 = 0.1;
/// Crossings of one line with this much arc length between them, mm, or less, are those of one spike.
pub(super) const SPIKE: f32 = 1.0;
/// Crossings nearer than this, mm, are one.
const SAME: f32 = 0.01;

/// A junction of a polyline with a drawn line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Junction {
    /// How far along the polyline, mm.
    pub(super) arc: f32,
    pub(super) at: MmPoint,
    /// Number of the line.
    pub(super) line: u32,
    /// How far along the line, mm.
    pub(super) line_arc: f32,
    /// The direction of the line there; zero if it ends there.
    pub(super) along: MmVector,
    pub(super) meeting: Meeting,
}

/// How a polyline and a drawn line meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meeting {
    /// The polyline ends on the line.
    PolylineEnds,
    /// The line ends on the polyline.
    LineEnds,
    /// They cross, and the polyline goes to this side of the line: 1 or -1.
    Cross(i8),
}

impl Junction {
    /// The junction of a polyline that ends at `at` with the line of a segment, if it ends on that.
    pub(super) fn of_end(at: MmPoint, arc: f32, segment: &Segment) -> Option<Self> {
        let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
        let (line, line_arc) = (segment.line, segment.arc + (touched - segment.a).length());
        let along = (segment.b - segment.a).try_normalize().unwrap_or_default();
        (distance <= TOUCH).then_some(Self { arc, at, line, line_arc, along, meeting: Meeting::PolylineEnds })
    }

    /// Whether it is an end of the polyline that lies here.
    pub(super) fn is_own_end(&self) -> bool {
        self.meeting == Meeting::PolylineEnds
    }

    /// Whether the other junction, with the same line, is so near that only one of them will be drawn.
    pub(super) fn is_beside(&self, other: &Self) -> bool {
        self.line == other.line && (self.arc - other.arc).abs().max((self.line_arc - other.line_arc).abs()) <= SPIKE
    }
}

/// A polyline among the drawn lines.
pub(super) struct Passage {
    /// Arc length at each vertex, mm.
    pub(super) arcs: Vec<f32>,
    /// Its whole length if it is closed.
    pub(super) ring_length: Option<f32>,
    /// Its junctions with the lines.
    pub(super) junctions: Vec<Junction>,
    /// Its meetings with lines that these lines join close by.
    pub(super) clusters: Vec<Cluster>,
}

impl Passage {
    /// Length along the polyline between two arcs, of a ring along the shorter arc, mm.
    pub(super) fn between(&self, s: f32, t: f32) -> f32 {
        arc_between(s, t, self.ring_length)
    }

    /// Whether there is a junction with a line within `reach` of a place of the polyline, mm along it.
    pub(super) fn joins(&self, line: u32, arc: f32, reach: f32) -> bool {
        self.junctions.iter().any(|j| j.line == line && self.between(j.arc, arc) <= reach)
    }
}

/// Numbers of the crossings that lead to no other side of a line. A polyline that crosses a line and is back within
/// [`SPIKE`] has only touched it, and simplification may part the two; `ring_length` is the length of a closed one.
///
/// ```text
///       line
///   ------|---.
///         |    > spike: two crossings that are none
///   ------|---´
/// ```
pub(super) fn back_and_forth(crossings: &[Junction], ring_length: Option<f32>) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..crossings.len()).collect();
    numbers.sort_by(|&a, &b| {
        let (a, b) = (&crossings[a], &crossings[b]);
        a.line.cmp(&b.line).then(a.arc.total_cmp(&b.arc))
    });
    let mut found = Vec::new();
    for of_line in numbers.chunk_by(|&a, &b| crossings[a].line == crossings[b].line) {
        let arc = |i: &usize| crossings[*i].arc;
        let mut spikes: Vec<Vec<usize>> =
            of_line.chunk_by(|a, b| arc(b) - arc(a) <= SPIKE).map(<[usize]>::to_vec).collect();
        // one over the start of a ring
        if let (Some(ring_length), [first, .., last]) = (ring_length, of_line)
            && arc(first) + ring_length - arc(last) <= SPIKE
            && spikes.len() > 1
        {
            let before_the_start = spikes.pop().unwrap_or_default();
            spikes[0].splice(0..0, before_the_start);
        }
        for spike in spikes {
            let side = |i: &usize| match crossings[*i].meeting {
                Meeting::Cross(side) => side,
                Meeting::PolylineEnds | Meeting::LineEnds => 0,
            };
            // where it passes a vertex of either it crosses both segments there
            let mut once: Vec<usize> = Vec::with_capacity(spike.len());
            for &i in &spike {
                let same = |j: &usize| side(j) == side(&i) && (crossings[*j].at - crossings[i].at).length() <= SAME;
                if !once.iter().any(same) {
                    once.push(i);
                }
            }
            if once.iter().map(side).map(i32::from).sum::<i32>() == 0 {
                found.extend(spike);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests;
