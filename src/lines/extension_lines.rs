//! Extension lines of dimensioned drawings: a side of a part goes on beyond its corner, up to the arrow that measures
//! it, after a gap. Led on to the part they would seem to be its outline, and a gap that fingers do not feel says no
//! more; so they begin farther from the part:
//!
//! ```text
//!      |   <-----             |   <-----
//!      |
//!                      ->
//!      +---------
//!      |                      +---------
//!      |                      |
//! ```

use super::lead_on::heading;
use super::marks::HeadMark;
use super::params::{HEADING, Params};
use super::ticks::found::is_straight;
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::geom::{nearest_on_segment, segment_distance};
use crate::units::MmRect;

/// The shortest gap that is one, mm: in bitmaps strokes that meet may end beside one another.
const SHORTEST: f32 = 0.5;
/// What is in line with another differs from its direction by at most 8 degrees (the cosine).
const IN_LINE: f32 = 0.99;
/// A side of a part is in line with what is before it over this length, mm, but for so many mm.
const SIDE: f32 = 4.0;
const OFF_LINE: f32 = 0.4;
/// So much more than the clearance is between an extension line and its part, mm.
const MARGIN: f32 = 0.1;

/// Widens the gaps between extension lines, at which heads of arrows point, and the corners of parts before them.
pub(super) fn keep_apart(polylines: &mut [Polyline<Vertex>], heads: &[HeadMark], area: MmRect, params: &Params) {
    let is_measured = |line: &Polyline<Vertex>| is_straight(line) && is_pointed_at(line, heads, params);
    let measured: Vec<usize> = (0..polylines.len()).filter(|&number| is_measured(&polylines[number])).collect();
    if measured.is_empty() {
        return;
    }
    let segments = nearby(polylines.iter(), area, params);
    for number in measured {
        let is_other = |segment: &Segment| segment.line as usize != number;
        for which in Tip::BOTH {
            let line = &polylines[number];
            if let Some(gap) = gap_before_corner(line, which, &segments, params.bridged_gap(), is_other) {
                // of a short one less is left than a line needs
                let most = (line.length() - SHORTEST).max(0.0);
                polylines[number] = line.shortened(which, (params.max_clearance() + MARGIN - gap).clamp(0.0, most));
            }
        }
    }
}

/// Whether the head of an arrow points at a straight line, or did before its shaft was shortened.
fn is_pointed_at(line: &Polyline<Vertex>, heads: &[HeadMark], params: &Params) -> bool {
    let (Some(first), Some(last)) = (line.vertices.first(), line.vertices.last()) else { return false };
    heads.iter().any(|head| {
        let farthest = head.at + head.toward * (head.shortened + params.bridged_gap());
        let is_across = (last.at - first.at).dot(head.toward).abs() < IN_LINE * line.length();
        is_across && segment_distance((head.at, farthest), (first.at, last.at)) <= OFF_LINE
    })
}

/// How far an end is from a corner before it beyond which a side goes on in line with it, mm, if that is in reach.
fn gap_before_corner(
    line: &Polyline<Vertex>,
    which: Tip,
    segments: &Nearby,
    reach: f32,
    is_other: impl Fn(&Segment) -> bool,
) -> Option<f32> {
    let (tip, heading) = (which.of(line)?.at, heading(line, which, HEADING)?);
    let (gap, corner, _) = segments.nearest(tip, reach, &is_other)?;
    let is_ahead = gap >= SHORTEST && (corner - tip).dot(heading) >= IN_LINE * gap;
    let mut turns = false;
    segments.around_point(corner, OFF_LINE, |segment| {
        let is_there = is_other(segment) && nearest_on_segment(corner, segment.a, segment.b).0 <= OFF_LINE;
        let along = (segment.b - segment.a).try_normalize();
        turns |= is_there && along.is_some_and(|along| along.dot(heading).abs() < IN_LINE);
    });
    let goes_on = segments.nearest(corner + heading * SIDE, OFF_LINE, &is_other).is_some();
    (is_ahead && turns && goes_on).then_some(gap)
}

#[cfg(test)]
mod tests;
