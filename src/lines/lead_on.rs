//! T-junctions: an end that stops a little before another line and points at it is extended to it. The colour step that
//! makes a contour fades where a stronger one passes, so such a line always stops short.
//!
//! ```text
//!      |                |
//!   --  |      ->     ---|
//!      |                |
//! ```

use super::params::{HEADING, Params};
use super::vertex::{CORNER_ARMS, SPACING, Tip, Vertex, nearby};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::geom::walk::heading_of_end;
use crate::geom::{crossing, nearest_on_segment};
use crate::units::{MmPoint, MmRect, MmVector};

/// Least cosine between an end's heading and the direction to the line it is extended to (53 degrees).
const AHEAD_COSINE: f32 = 0.6;
/// Greatest cosine between that direction and the line it is extended to (50 degrees): flatter, the two would lie side
/// by side.
const STEEP: f32 = 0.64;
/// A segment in line with an end, by this sine at most, is not ahead of it: rounding alone would say whether and where
/// the two cross. So a side of a part of a bar that ends at a corner of the next part is led on to that corner.
const IN_LINE: f32 = 1e-3;
/// Places nearer than this, mm, are one.
const SAME: f32 = 1e-3;
/// A line is extended to itself only where the loop is at least this many gaps long.
const ROUND: f32 = 4.0;
/// A corner of a ring is put on a line that is so far before it or behind it, mm: about half a line's width. In bitmaps
/// strokes that meet grow together, and lie off their places there.
const CORNER_REACH: f32 = 0.5;
/// What lies beyond the line then, or so near before it, mm, goes.
const AT_LINE: f32 = 0.05;
/// How many vertices on either side of a corner that may be.
const BESIDE_CORNER: isize = 3;
/// How far beyond its ends a segment is still met, as a share of its length: a place between two is met by one of them.
pub(super) const VERTEX: f32 = 1e-3;

/// Extends ends over gaps of at most `gap` millimetres to what lies before them.
pub(super) fn extend(polylines: &mut [Polyline<Vertex>], area: MmRect, gap: f32) {
    let mut nearby = Nearby::new(area, gap);
    let mut totals = Vec::with_capacity(polylines.len());
    for (number, polyline) in polylines.iter().enumerate() {
        let arcs = polyline.arc_lengths();
        for (i, (a, b)) in polyline.segments().enumerate() {
            let (a, b) = (a.at, b.at);
            nearby.insert(Segment { a, b, half_width: 0.0, line: number as u32, index: i as u32, arc: arcs[i] });
        }
        totals.push(arcs.last().copied().unwrap_or(0.0));
    }
    // All ends are judged before any is extended, so that the order of the lines does not matter.
    let mut extensions = Vec::new();
    for (number, polyline) in
        polylines.iter().enumerate().filter(|(_, polyline)| !polyline.closed && polyline.vertices.len() > 1)
    {
        for which in Tip::BOTH {
            let arc = if which == Tip::First { 0.0 } else { totals[number] };
            let other = |segment: &Segment| segment.line as usize != number || (segment.arc - arc).abs() > ROUND * gap;
            let (Some(tip), Some(heading)) = (which.of(polyline), heading(polyline, which, HEADING)) else { continue };
            if let Some(target) = ahead(tip.at, heading, &nearby, gap, other) {
                extensions.push((number, which, straight(tip, target)));
            }
        }
    }
    for (number, which, path) in extensions {
        let polyline = &mut polylines[number];
        if polyline.closed {
            // its other end was extended to this one
            continue;
        }
        add(polyline, which, path);
        // an end that was extended to the other end of its line has closed it
        if let [first, .., last] = &polyline.vertices[..]
            && (last.at - first.at).length() < SPACING
        {
            polyline.vertices.pop();
            polyline.closed = true;
        }
    }
}

/// Puts the corners of rings that reach just beyond another line on that, and in bitmaps those that nearly reach it:
/// those of a triangle on the circle around it. Where they are off it, the two are no more than near to one another,
/// and one would have to give way.
pub(super) fn put_corners(polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) {
    let segments = nearby(polylines.iter(), area, params);
    for (number, ring) in polylines.iter_mut().enumerate().filter(|(_, line)| line.closed) {
        let is_other = |segment: &Segment| segment.line as usize != number;
        // what a path has before a line is meant
        let is_exact = ring.vertices.iter().any(|vertex| vertex.source.is_exact());
        let places: Vec<MmPoint> = ring.vertices.iter().map(|vertex| vertex.at).collect();
        let mut stays = vec![true; places.len()];
        let mut put: Vec<MmPoint> = Vec::new();
        let mut is_put = vec![false; places.len()];
        for corner in ring.view().corners_of_ring() {
            // a corner may be found at two vertices
            let is_new = put.iter().all(|before| (*before - places[corner]).length() >= CORNER_ARMS[1]);
            let target = if is_new { before_corner(ring, corner, &segments, is_other) } else { None };
            let is_beyond = |(to, heading): &(MmPoint, MmVector)| (*to - places[corner]).dot(*heading) < 0.0;
            let Some((to, heading)) = target.filter(|target| !is_exact || is_beyond(target)) else { continue };
            for step in [1, -1] {
                let beside = (1..=BESIDE_CORNER).filter_map(|k| ring.view().next(corner, k * step));
                let beyond = beside.take_while(|&i| !is_put[i] && (places[i] - to).dot(heading) > -AT_LINE);
                beyond.for_each(|i| stays[i] = false);
            }
            (stays[corner], is_put[corner]) = (true, true);
            ring.vertices[corner].at = to;
            put.push(to);
        }
        if !put.is_empty() {
            let mut stays = stays.into_iter();
            ring.vertices.retain(|_| stays.next().unwrap_or(true));
            ring.fill();
        }
    }
}

/// The nearest place of the segments that `is_other` lets pass, straight before the corner of a ring or behind it, and
/// the direction in which the corner points; none if it would meet it flat.
fn before_corner(
    ring: &Polyline<Vertex>,
    corner: usize,
    segments: &Nearby,
    is_other: impl Fn(&Segment) -> bool,
) -> Option<(MmPoint, MmVector)> {
    let tip = ring.vertices[corner].at;
    let arm = |step: isize| {
        let along = (1..ring.vertices.len() as isize).filter_map(|k| ring.view().next(corner, k * step));
        let mut away = along.map(|i| ring.vertices[i].at - tip);
        away.find(|arm| arm.length() >= HEADING)?.try_normalize()
    };
    let heading = (-(arm(1)? + arm(-1)?)).try_normalize()?;
    let (from, to) = (tip - heading * CORNER_REACH, tip + heading * CORNER_REACH);
    let mut hit: Option<(f32, MmPoint)> = None;
    segments.around(from.min(to), from.max(to), 0.0, |segment| {
        let over = (segment.b - segment.a) * VERTEX;
        let is_steep = over.try_normalize().is_some_and(|along| along.dot(heading).abs() <= STEEP);
        let place = crossing((from, to), (segment.a - over, segment.b + over));
        if let Some(at) = place.filter(|_| is_steep && is_other(segment)) {
            let distance = (at - tip).length();
            if hit.is_none_or(|(least, _)| distance < least) {
                hit = Some((distance, at));
            }
        }
    });
    hit.map(|(_, at)| (at, heading))
}

/// The direction in which an end leaves its line, over the last `span` millimetres.
pub(super) fn heading(polyline: &Polyline<Vertex>, which: Tip, span: f32) -> Option<MmVector> {
    let n = polyline.vertices.len();
    let from_end = |i: usize| polyline.vertices[if which == Tip::First { i } else { n - 1 - i }].at;
    heading_of_end((0..n).map(from_end), span)
}

/// The place that an end at `tip` points at, on the nearest of the segments that `other` lets pass: straight ahead, or
/// a little aside. None if it lies on one already, or if it would run into it flat.
pub(super) fn ahead(
    tip: MmPoint,
    heading: MmVector,
    nearby: &Nearby,
    gap: f32,
    other: impl Fn(&Segment) -> bool,
) -> Option<MmPoint> {
    let mut hit: Option<(f32, MmPoint)> = None;
    let is_in_line = |segment: &Segment| {
        let along = segment.b - segment.a;
        along.cross(heading).abs() <= IN_LINE * along.length()
    };
    nearby.around(tip, tip, gap, |segment| {
        if let Some(at) = crossing((tip, tip + heading * gap), (segment.a, segment.b))
            && !is_in_line(segment)
        {
            let distance = (at - tip).length();
            if hit.is_none_or(|(least, _)| distance < least) && other(segment) {
                hit = Some((distance, at));
            }
        }
    });
    if hit.is_none() {
        // nothing straight ahead: the nearest place, if it lies in front
        let (distance, at, _) = nearby.nearest(tip, gap, |segment| {
            let (distance, at) = nearest_on_segment(tip, segment.a, segment.b);
            other(segment) && (at - tip).dot(heading) >= AHEAD_COSINE * distance
        })?;
        hit = Some((distance, at));
    }
    let (distance, at) = hit?;
    // where two segments share a vertex, the steeper one counts, not the one that was found first
    let mut least = f32::INFINITY;
    nearby.around(at, at, SAME, |segment| {
        if other(segment) && nearest_on_segment(at, segment.a, segment.b).0 <= SAME {
            let along = (segment.b - segment.a).try_normalize();
            least = least.min(along.map_or(f32::INFINITY, |along| along.dot(heading).abs()));
        }
    });
    (distance > SAME && least <= STEEP).then_some(at)
}

/// Vertices from a tip (without it) straight to a place.
pub(super) fn straight(tip: &Vertex, to: MmPoint) -> Vec<Vertex> {
    let steps = ((to - tip.at).length() / SPACING).ceil().max(1.0) as usize;
    let at = |k: usize| if k == steps { to } else { tip.at.lerp(to, k as f32 / steps as f32) };
    (1..=steps).map(|k| Vertex { at: at(k), ..*tip }).collect()
}

/// Extends a line at one end, straight to a place.
pub(super) fn extend_to(line: &mut Polyline<Vertex>, which: Tip, to: MmPoint) {
    if let Some(path) = which.of(line).map(|tip| straight(tip, to)) {
        add(line, which, path);
    }
}

/// Adds a path that leads on from an end of a line.
fn add(line: &mut Polyline<Vertex>, which: Tip, path: Vec<Vertex>) {
    if which == Tip::First {
        line.vertices.splice(0..0, path.into_iter().rev());
    } else {
        line.vertices.extend(path);
    }
}

#[cfg(test)]
mod tests;
