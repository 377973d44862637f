//! Ends that continue one another are joined: a contour that noise or a highlight broke is one line again.

use super::faint::is_faint;
use super::standing::StandingEnds;
use super::vertex::{Vertex, is_no_step};
use crate::geom::link::{End, LinkedChain, Part, link};
use crate::geom::polyline::Polyline;
use crate::geom::walk::first_beyond;
use crate::raster::contrast::dot;
use crate::units::{Mm, MmPoint, MmVector};

/// The direction of an end is taken over this much of its line, mm.
const JOINED_HEADING: f32 = 1.5;
/// Where a corner lies within that, as at the top of a bar right above a gridline, which parts it from its sides, the
/// direction is that over this much, mm.
const HOOK: f32 = 0.4;
/// Then they are farther from being one line by so many of the widest gaps: others are at most two from that, where
/// they meet at a corner.
const OF_HOOKS: f32 = 3.0;
/// Least cosine between an end's heading and the direction of the other end (45 degrees).
const AHEAD_COSINE: f32 = 0.7;
/// Least cosine between the headings of two ends, one of them turned round (60 degrees).
const FACING: f32 = 0.5;
/// A line whose own ends are joined is at least this many times as long as the gap between them.
const RING: f32 = 4.0;
/// Ends nearer than this need not point at one another, mm: their headings alone decide.
const TOUCHING: f32 = 0.5;

/// Ends nearer than this are one point, mm.
const MEETING: f32 = 0.05;

/// Two strokes that lead to one side of a line are no fan if they make less than 20 degrees (the cosine), as two lines
/// that meet must.
const BLADE: f32 = 0.94;

/// Ends that do not meet exactly bend towards one another over this length, mm.
const BEND: f32 = 4.0;

/// Joins open polylines over gaps of at most `gap` millimetres and closes those whose own ends meet. Of ends that are
/// `standing` on lines only those on one line are joined over it, and if both come from the same side, only where that
/// closes a ring. Of drawings the last bit of an end may tell its direction.
pub(super) fn join(
    polylines: Vec<Polyline<Vertex>>,
    gap: f32,
    standing: &StandingEnds,
    of_drawing: bool,
) -> Vec<Polyline<Vertex>> {
    join_but_ticks(polylines, &[], gap, standing, of_drawing)
}

/// The same where some of the lines are ticks (in their order; none where it says nothing), which are joined with one
/// another only: the side of a bar that ends on the other side of their line is no part of one.
pub(super) fn join_but_ticks(
    polylines: Vec<Polyline<Vertex>>,
    are_ticks: &[bool],
    gap: f32,
    standing: &StandingEnds,
    of_drawing: bool,
) -> Vec<Polyline<Vertex>> {
    let lengths: Vec<f32> = polylines.iter().map(Polyline::length).collect();
    // a gridline is no part of the axis at whose end it begins
    let faint: Vec<bool> = polylines.iter().map(is_faint).collect();
    let base = |end: &End<Mm>| standing.base(end.at, TOUCHING);
    let is_tick = |end: &End<Mm>| are_ticks.get(end.polyline).copied().unwrap_or(false);
    let is_parted =
        |a: &End<Mm>, b: &End<Mm>| is_tick(a) != is_tick(b) || (b.at - a.at).length() > TOUCHING && base(a) != base(b);
    let threads = link(polylines.len(), &ends(&polylines), gap, |a, b| {
        let of_hooks = || cost_of_hooks(a, b, &polylines, &lengths, gap).filter(|_| of_drawing);
        let cost = cost(a, b, &lengths, gap).or_else(of_hooks).filter(|_| faint[a.polyline] == faint[b.polyline])?;
        (!is_parted(a, b)).then_some(cost)
    });
    let parted = |thread: LinkedChain| without_fans(thread, &polylines, &lengths, standing);
    let threads: Vec<LinkedChain> = threads.into_iter().flat_map(parted).collect();
    let mut left: Vec<Option<Polyline<Vertex>>> = polylines.into_iter().map(Some).collect();
    threads.into_iter().filter_map(|thread| concatenate(&thread, &mut left)).collect()
}

/// A thread, in pieces where two of its polylines are strokes of one fan, each long enough for a line: each ends on the
/// line to which it leads, where a bend would only touch it. What closes to a ring is a shape that stands there, unless
/// it touches itself: then it is parted wherever it bends.
fn without_fans(
    mut thread: LinkedChain,
    polylines: &[Polyline<Vertex>],
    lengths: &[f32],
    standing: &StandingEnds,
) -> Vec<LinkedChain> {
    if thread.parts.len() < 2 {
        return vec![thread];
    }
    let end = |part: &Part, at_start: bool| {
        let polyline = &polylines[part.polyline];
        let tip = if at_start { polyline.vertices.first() } else { polyline.vertices.last() };
        Some((tip?.at, direction(polyline, at_start, JOINED_HEADING)))
    };
    let ends = |before: &Part, next: &Part| end(before, before.reversed).zip(end(next, !next.reversed));
    let is_fan = |before: &Part, next: &Part| {
        let are_long = [before, next].iter().all(|part| lengths[part.polyline] >= standing.least);
        let are_of_fan = |(a, b): ((MmPoint, MmVector), (MmPoint, MmVector))| {
            a.1.dot(b.1) <= BLADE && standing.are_on_one_side([a, b], TOUCHING)
        };
        are_long && ends(before, next).is_some_and(are_of_fan)
    };
    if !thread.closed {
        let pieces = thread.parts.chunk_by(|before, next| !is_fan(before, next));
        return pieces.map(|parts| LinkedChain { parts: parts.to_vec(), closed: false }).collect();
    }
    let touches_itself = |number: &usize| {
        let (count, next) = (thread.parts.len(), &thread.parts[*number]);
        let crossed = |(at, a, b): (MmPoint, MmVector, MmVector)| {
            thread.parts.iter().any(|part| goes_through_between(&polylines[part.polyline], at, [-a, -b]))
        };
        ends(&thread.parts[(number + count - 1) % count], next).is_some_and(|(a, b)| crossed((a.0, a.1, b.1)))
    };
    let Some(first) = (0..thread.parts.len()).find(touches_itself) else { return vec![thread] };
    thread.parts.rotate_left(first);
    let bends = |before: &Part, next: &Part| ends(before, next).is_none_or(|(a, b)| a.1.dot(b.1) > -FACING);
    let pieces = thread.parts.chunk_by(|before, next| !bends(before, next));
    pieces.map(|parts| LinkedChain { parts: parts.to_vec(), closed: false }).collect()
}

/// Whether a polyline bends at a place from which lines lead away in two other directions, as at the corners of four
/// squares: no two of the four are nearer than 60 degrees, as some are in the middle of a pie chart.
fn goes_through_between(polyline: &Polyline<Vertex>, at: MmPoint, away: [MmVector; 2]) -> bool {
    let far = |vertex: &Vertex| (vertex.at - at).length();
    let ends = [polyline.vertices.first(), polyline.vertices.last()].into_iter().flatten();
    let nearest = (0..polyline.vertices.len())
        .min_by(|a, b| far(&polyline.vertices[*a]).total_cmp(&far(&polyline.vertices[*b])))
        .filter(|vertex| far(&polyline.vertices[*vertex]) <= TOUCHING && ends.clone().all(|end| far(end) > TOUCHING));
    let Some(nearest) = nearest else { return false };
    let side = |forwards: bool| {
        let points = polyline.walk(nearest, forwards).map(|(vertex, _)| polyline.vertices[vertex].at);
        first_beyond(points, at, JOINED_HEADING).and_then(|to| (to - at).try_normalize())
    };
    let Some((back, on)) = side(false).zip(side(true)) else { return false };
    let all = [back, on, away[0], away[1]];
    (0..all.len()).all(|i| all[..i].iter().all(|other| all[i].dot(*other) <= FACING))
}

/// Both ends of every open polyline.
fn ends(polylines: &[Polyline<Vertex>]) -> Vec<End<Mm>> {
    let mut ends = Vec::new();
    for (number, polyline) in polylines.iter().enumerate() {
        let vertices = &polyline.vertices;
        if polyline.closed || vertices.len() < 2 {
            continue;
        }
        for at_start in [true, false] {
            let from_end = |i: usize| &vertices[if at_start { i } else { vertices.len() - 1 - i }];
            let tip = from_end(0);
            let direction = direction(polyline, at_start, JOINED_HEADING);
            let contrast = if at_start { tip.contrast.map(|v| -v) } else { tip.contrast };
            ends.push(End { polyline: number, at_start, at: tip.at, direction, contrast });
        }
    }
    ends
}

/// The direction in which an end leaves its polyline over the last `span` millimetres.
fn direction(polyline: &Polyline<Vertex>, at_start: bool, span: f32) -> MmVector {
    let vertices = &polyline.vertices;
    let from_end = |i: usize| vertices[if at_start { i } else { vertices.len() - 1 - i }].at;
    let tip = from_end(0);
    let mut inner = (1..vertices.len()).map(from_end);
    let inner = inner.find(|at| (*at - tip).length() >= span).unwrap_or_else(|| from_end(vertices.len() - 1));
    (tip - inner).try_normalize().unwrap_or(MmVector::zero())
}

/// How far two ends of steps between colours that are near to one another are from being one line by the last bit of
/// each; farther than any that point at one another as a whole, see [`OF_HOOKS`].
fn cost_of_hooks(a: &End<Mm>, b: &End<Mm>, polylines: &[Polyline<Vertex>], lengths: &[f32], gap: f32) -> Option<f32> {
    // of steps the same colours lie on the same side
    if (b.at - a.at).length() > JOINED_HEADING || dot(a.contrast, b.contrast) >= 0.0 {
        return None;
    }
    let hook = |of: &End<Mm>| End { direction: direction(&polylines[of.polyline], of.at_start, HOOK), ..*of };
    Some(cost(&hook(a), &hook(b), lengths, gap)? + OF_HOOKS * gap)
}

/// How far two ends are from being one line, if they can be joined at all.
fn cost(a: &End<Mm>, b: &End<Mm>, lengths: &[f32], gap: f32) -> Option<f32> {
    let displacement = b.at - a.at;
    let distance = displacement.length();
    if distance > gap || (a.polyline == b.polyline && lengths[a.polyline] < RING * distance) {
        return None;
    }
    // at a corner, one of whose sides is a stroke
    let is_stroke = |end: &End<Mm>| is_no_step(end.contrast);
    if distance <= MEETING && (is_stroke(a) || is_stroke(b)) {
        return Some(distance + gap * (1.0 + a.direction.dot(b.direction)));
    }
    // Leaving through a one enters through b, where right and left change places. A stroke's centreline has no step.
    if dot(a.contrast, b.contrast) > 0.0 || a.direction.dot(b.direction) > -FACING {
        return None;
    }
    if distance <= TOUCHING {
        return Some(distance);
    }
    let displacement = displacement / distance;
    let (ahead_a, ahead_b) = (a.direction.dot(displacement), -b.direction.dot(displacement));
    (ahead_a >= AHEAD_COSINE && ahead_b >= AHEAD_COSINE).then_some(distance * (3.0 - ahead_a - ahead_b))
}

/// Two joined ends that lie beside one another (one is a stroke's centreline, the other came from its side) bend
/// towards one another over [`BEND`] millimetres, so that the line has no step there. `seam` is the first vertex of the
/// second.
fn meet_halfway(vertices: &mut [Vertex], seam: usize) {
    let (first, second) = vertices.split_at_mut(seam);
    let inner = |side: &[Vertex], at: usize| side[at].at;
    let ahead = inner(second, second.len().min(4) - 1) - inner(first, first.len().saturating_sub(4));
    let Some(ahead) = ahead.try_normalize() else { return };
    let gap = second[0].at - first[first.len() - 1].at;
    let aside = (gap - ahead * gap.dot(ahead)) * 0.5;
    let tips = (first[first.len() - 1].at, second[0].at);
    for vertex in first.iter_mut().rev() {
        let share = 1.0 - (vertex.at - tips.0).length() / BEND;
        if share <= 0.0 {
            break;
        }
        vertex.at += aside * share;
    }
    for vertex in second {
        let share = 1.0 - (vertex.at - tips.1).length() / BEND;
        if share <= 0.0 {
            break;
        }
        vertex.at -= aside * share;
    }
}

/// The polylines of a thread as one that bends over its gaps; each is taken from `left`.
fn concatenate(thread: &LinkedChain, left: &mut [Option<Polyline<Vertex>>]) -> Option<Polyline<Vertex>> {
    let mut whole = thread.concatenate(left, |before, next| {
        let seam = before.len();
        before.extend(next);
        meet_halfway(before, seam);
    })?;
    // one that was a ring before has no gap
    if thread.closed || !whole.closed {
        whole.fill();
    }
    Some(whole)
}

#[cfg(test)]
mod tests;
