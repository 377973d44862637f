//! Where a line comes too near to itself.

use std::ops::Range;

use super::field::{APPROACH, Field, LESS, TOUCH, segment};
use crate::geom::nearby::Nearby;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;

/// A line that comes back to itself is its own rival where the way along it is longer than the way across by this factor,
/// and by this length, mm. A corner of 33 degrees or more is none (its factor is 1 / sin 16.5 = 3.5).
const BEND: f32 = 3.5;
const BEND_LEAST: f32 = 1.5;

/// The first vertices of a polyline that come back too near to an earlier part of it. `own` is an empty grid, and empty again
/// afterwards.
pub(super) fn returns(polyline: &Polyline<Vertex>, field: &Field<'_>, own: &mut Nearby) -> Option<Range<usize>> {
    let arcs = polyline.arc_lengths();
    let total = arcs.last().copied().unwrap_or(0.0);
    if total <= BEND_LEAST {
        return None;
    }
    let apart = |s: f32, t: f32| if polyline.closed { (s - t).abs().min(total - (s - t).abs()) } else { (s - t).abs() };
    // its own ends may lie on it
    let tips: Vec<f32> =
        if polyline.closed { Vec::new() } else { own_meetings(polyline, &arcs, field.longest_stub(), own) };
    let mut found: Option<Range<usize>> = None;
    let mut last: Option<&Vertex> = None;
    // a ring is gone round until its first vertex has been looked at with the others before it
    for (i, vertex) in polyline.path().enumerate() {
        let half = 0.5 * vertex.width;
        let mut near = false;
        own.around(vertex.at, vertex.at, field.farthest(), |segment| {
            if near || apart(arcs[i], segment.arc) <= BEND_LEAST {
                return;
            }
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let there = segment.arc + (at - segment.a).length();
            let way = apart(arcs[i], there);
            if distance >= field.clearance(half + segment.half_width) || is_bend(way, distance) {
                return;
            }
            let limit = APPROACH * (field.params.min_gap + half + segment.half_width) - LESS;
            near = !tips.iter().any(|tip| (tip - arcs[i]).abs() <= limit || (tip - there).abs() <= limit);
        });
        if near {
            found.get_or_insert(i..i).end = i + 1;
        } else if found.is_some() {
            break;
        } else if let Some(last) = last {
            own.insert(segment(last, vertex, i - 1, 0, arcs[i - 1]));
        }
        last = Some(vertex);
    }
    own.clear();
    found
}

/// Which ends of an open polyline, as places along it, lie on the polyline itself, at the end of a loop that is longer than `knot`.
fn own_meetings(polyline: &Polyline<Vertex>, arcs: &[f32], knot: f32, own: &mut Nearby) -> Vec<f32> {
    let (Some(first), Some(last), Some(&total)) = (polyline.vertices.first(), polyline.vertices.last(), arcs.last())
    else {
        return Vec::new();
    };
    for (i, (a, b)) in polyline.segments().enumerate() {
        own.insert(segment(a, b, i, 0, arcs[i]));
    }
    let mut tips = Vec::new();
    for (at, arc) in [(first.at, 0.0), (last.at, total)] {
        own.around(at, at, TOUCH, |segment| {
            let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
            let there = segment.arc + (touched - segment.a).length();
            if distance <= TOUCH && (there - arc).abs() > knot {
                tips.push(arc);
            }
        });
    }
    own.clear();
    tips
}

/// Whether two places of one line are near one another only because it bends there.
pub(super) fn is_bend(way: f32, distance: f32) -> bool {
    way <= BEND * distance + BEND_LEAST
}
