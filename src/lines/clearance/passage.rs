//! Where a polyline meets the lines that are drawn.

use crate::geom::nearby::Segment;
use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmVector};

/// A line ends on another if it comes this near, mm: twice the tolerance of simplification, so that it is drawn so (see
/// [`super::anchor`], which gives the other a vertex there), and far less than a finger notices.
pub(super) const TOUCH: f32 = 0.1;
/// Crossings of one line with this much arc length between them, mm, or less, are those of one spike.
pub(super) const SPIKE: f32 = 1.0;
/// Crossings nearer than this, mm, are one.
const SAME: f32 = 0.01;

/// A junction of a polyline with a drawn line.
#[derive(Debug, Clone, Copy)]
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
}

/// Length along a line between two arcs, mm; of a closed one, which is so long (`ring_length`), along the shorter arc.
pub(super) fn arc_between(s: f32, t: f32, ring_length: Option<f32>) -> f32 {
    let apart = (s - t).abs();
    ring_length.map_or(apart, |ring_length| apart.min(ring_length - apart))
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
mod tests {
    use super::*;

    /// A crossing with line 0 so far along the polyline and the line, to a side.
    fn crossing(arc: f32, line_arc: f32, side: i8) -> Junction {
        let (at, along) = (MmPoint::new(arc, 0.0), MmVector::new(0.0, 1.0));
        Junction { arc, at, line: 0, line_arc, along, meeting: Meeting::Cross(side) }
    }

    #[test]
    fn a_polyline_ends_on_a_line_that_it_touches() {
        let (a, b) = (MmPoint::new(10.0, 50.0), MmPoint::new(20.0, 50.0));
        let segment = Segment { a, b, half_width: 0.5, line: 3, index: 7, arc: 100.0 };
        let end = Junction::of_end(MmPoint::new(14.0, 50.0 + 0.9 * TOUCH), 25.0, &segment).expect("it is on the line");
        assert!(end.is_own_end() && end.line == 3 && (end.line_arc - 104.0).abs() < 1e-4);
        assert!((end.arc - 25.0).abs() < 1e-4 && end.along == MmVector::new(1.0, 0.0));
        assert!(Junction::of_end(MmPoint::new(14.0, 50.0 + 1.1 * TOUCH), 25.0, &segment).is_none());
    }

    #[test]
    fn junctions_are_beside_one_another_if_they_are_so_on_both_lines() {
        let here = crossing(10.0, 40.0, 1);
        assert!(here.is_beside(&crossing(10.9, 39.1, -1)));
        assert!(!here.is_beside(&crossing(11.1, 40.0, -1)), "the polyline goes on for more");
        assert!(!here.is_beside(&crossing(10.0, 41.1, -1)), "so does the line");
        assert!(!here.is_beside(&Junction { line: 1, ..here }));
    }

    #[test]
    fn round_a_ring_the_shorter_way_counts() {
        let passage = |ring_length| Passage { arcs: Vec::new(), ring_length, junctions: Vec::new() };
        assert!((passage(None).between(2.0, 98.0) - 96.0).abs() < 1e-4);
        assert!((passage(Some(100.0)).between(2.0, 98.0) - 4.0).abs() < 1e-4);
        assert!((passage(Some(100.0)).between(30.0, 60.0) - 30.0).abs() < 1e-4);
    }

    #[test]
    fn a_spike_crosses_nothing_and_a_way_there_and_back_crosses_twice() {
        let spike = [crossing(10.0, 40.0, 1), crossing(10.4, 40.1, -1)];
        assert_eq!(back_and_forth(&spike, None), [0, 1]);
        let apart = [crossing(10.0, 40.0, 1), crossing(20.0, 50.0, -1)];
        assert_eq!(back_and_forth(&apart, None), [0; 0]);
        let three = [crossing(10.0, 40.0, 1), crossing(10.4, 40.1, -1), crossing(10.8, 40.2, 1)];
        assert_eq!(back_and_forth(&three, None), [0; 0], "in the end it is on the other side");
        let of_two_lines = [crossing(10.0, 40.0, 1), Junction { line: 1, ..crossing(10.4, 40.1, -1) }];
        assert_eq!(back_and_forth(&of_two_lines, None), [0; 0]);
    }

    #[test]
    fn a_spike_over_the_start_of_a_ring_is_one_too() {
        let spike = [crossing(0.3, 40.0, 1), crossing(50.0, 90.0, 1), crossing(99.6, 40.2, -1)];
        let mut found = back_and_forth(&spike, Some(100.0));
        found.sort_unstable();
        assert_eq!(found, [0, 2]);
        assert_eq!(back_and_forth(&spike, None), [0; 0], "an open line has no such place");
    }

    #[test]
    fn a_crossing_at_a_vertex_counts_once_though_both_segments_have_it() {
        let twice = crossing(10.0, 40.0, 1);
        assert_eq!(back_and_forth(&[twice, twice, crossing(10.4, 40.1, -1)], None), [0, 1, 2]);
        assert_eq!(back_and_forth(&[twice, twice], None), [0; 0]);
    }
}
