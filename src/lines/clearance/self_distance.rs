//! Where a line comes too near to itself.

use std::ops::Range;

use super::drawn::segment;
use super::passage::TOUCH;
use crate::geom::nearby::Nearby;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::geom::walk::arc_between;
use crate::lines::corner::is_corner;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// A line that comes back to itself is its own rival where the length along it is more than the distance across by this
/// factor and this length, mm. A corner of 33 degrees or more is none (its factor is 1 / sin 16.5 = 3.5), nor is a
/// sharper one with straight sides.
pub(crate) const BEND: f32 = 3.5;
pub(crate) const BEND_LEAST: f32 = 1.5;

/// The first vertices of a polyline that come back too near to an earlier part of it. `own` is an empty index, and
/// empty again afterwards.
pub(super) fn self_approach(polyline: &Polyline<Vertex>, params: &Params, own: &mut Nearby) -> Option<Range<usize>> {
    let arcs = polyline.arc_lengths();
    let total = arcs.last().copied().unwrap_or(0.0);
    if total <= BEND_LEAST {
        return None;
    }
    let ring = polyline.view().goes_round();
    let apart = |s: f32, t: f32| arc_between(s, t, ring.then_some(total));
    // its own ends may lie on it
    let tips: Vec<f32> = if ring { Vec::new() } else { own_junctions(polyline, &arcs, params.max_stub(), own) };
    let mut found: Option<Range<usize>> = None;
    let mut last: Option<&Vertex> = None;
    // a ring is gone round until its first vertex has been looked at with the others before it
    for (i, vertex) in polyline.path().enumerate() {
        let half = 0.5 * vertex.width;
        let mut near = false;
        own.around_point(vertex.at, params.max_clearance(), |segment| {
            if near || apart(arcs[i], segment.arc) <= BEND_LEAST {
                return;
            }
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let line_arc = segment.arc + (at - segment.a).length();
            let is_near = distance < params.clearance(half + segment.half_width);
            if !is_near || !is_rival(polyline, &arcs, [(arcs[i], vertex.at), (line_arc, at)], distance) {
                return;
            }
            let limit = params.approach(half, segment.half_width);
            near = !tips.iter().any(|tip| (tip - arcs[i]).abs() <= limit || (tip - line_arc).abs() <= limit);
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

/// Whether two places of a polyline that are too near to one another, at this distance, are not beside a bend or a
/// corner. Each is given as its arc and its point.
pub(super) fn is_rival(polyline: &Polyline<Vertex>, arcs: &[f32], places: [(f32, MmPoint); 2], distance: f32) -> bool {
    let (ring, total) = (polyline.view().goes_round(), arcs.last().copied().unwrap_or(0.0));
    let apart = arc_between(places[0].0, places[1].0, ring.then_some(total));
    !is_bend(apart, distance) && !is_corner(polyline, arcs, ring, places)
}

/// The arcs of those ends of an open polyline that lie on the polyline itself, at the end of a loop longer than `knot`.
fn own_junctions(polyline: &Polyline<Vertex>, arcs: &[f32], knot: f32, own: &mut Nearby) -> Vec<f32> {
    let (Some(first), Some(last), Some(&total)) = (polyline.vertices.first(), polyline.vertices.last(), arcs.last())
    else {
        return Vec::new();
    };
    for (i, (a, b)) in polyline.segments().enumerate() {
        own.insert(segment(a, b, i, 0, arcs[i]));
    }
    let mut tips = Vec::new();
    for (at, arc) in [(first.at, 0.0), (last.at, total)] {
        own.around_point(at, TOUCH, |segment| {
            let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
            let line_arc = segment.arc + (touched - segment.a).length();
            if distance <= TOUCH && (line_arc - arc).abs() > knot {
                tips.push(arc);
            }
        });
    }
    own.clear();
    tips
}

/// Whether two points of one line, this length apart along it, are near one another only because it bends there.
pub(super) fn is_bend(length: f32, distance: f32) -> bool {
    length <= BEND * distance + BEND_LEAST
}

#[cfg(test)]
mod tests;
