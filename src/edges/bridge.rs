//! Bridges gaps: ends of contours that belong together are joined, over weak parts of a contour and around corners so
//! sharp that the gradient has no clear direction there.

use super::contour::{Contour, ContourPoint};
use crate::geom::link::{End, LinkedChain, link};
use crate::geom::polyline::Blend;
use crate::raster::contrast::dot;
use crate::units::Px;

/// Ends that point at one another are joined over gaps of up to this many scales.
const MAX_GAP: f32 = 6.0;
/// They do if the cosine between the direction of each end and the gap is at least this (37 degrees).
const ALIGNED: f32 = 0.8;
/// Other ends, as at a corner, are joined over gaps of up to this many scales, if both have the same colours on the
/// same sides.
const MAX_CORNER_GAP: f32 = 3.2;
/// Neither of them may have the other end behind it: least cosine between the direction of an end and the gap.
const NOT_BEHIND: f32 = -0.35;
/// At the tip of a wedge one side is often found farther than the other, and the other end is nearly beside it or
/// behind: this cosine (143 degrees), where both lead to one tip and make a corner of at most 45 degrees (cosine).
const BEHIND_AT_TIP: f32 = -0.8;
const SHARP: f32 = 0.707;
/// This does not hold for ends that just overshoot a sharp corner: gaps of up to this many scales.
const OVERSHOOT: f32 = 1.3;
/// Ends nearer than this are joined whatever their directions, px.
const COINCIDENT: f32 = 0.8;
/// The two ends of one contour are joined only if it is at least this many times as long as the gap, plus two scales.
const MIN_RING: f32 = 3.0;
/// The direction of an end is measured over this many scales.
const DIRECTION_LENGTH: f32 = 3.0;
/// Least position error of points in a gap, px: nothing was measured there.
const GAP_SIGMA: f32 = 0.3;

/// Joins open contours end to end, and closes those whose own ends meet. `sigma` is the scale of the derivative, px.
/// Those of a drawing are also joined at the tips of wedges.
pub(super) fn join(contours: Vec<Contour>, sigma: f32, of_drawing: bool) -> Vec<Contour> {
    let lengths: Vec<f32> = contours.iter().map(Contour::length).collect();
    let cost = |a: &End<Px>, b: &End<Px>| cost(a, b, &lengths, sigma, of_drawing);
    let threads = link(contours.len(), &ends(&contours, sigma), MAX_GAP * sigma, cost);
    let mut left: Vec<Option<Contour>> = contours.into_iter().map(Some).collect();
    threads.into_iter().filter_map(|thread| concatenate(&thread, &mut left)).collect()
}

/// Both ends of every open contour of at least three points.
fn ends(contours: &[Contour], sigma: f32) -> Vec<End<Px>> {
    let mut ends = Vec::new();
    for (number, contour) in contours.iter().enumerate().filter(|(_, c)| !c.closed && c.vertices.len() > 2) {
        for at_start in [true, false] {
            let tip = if at_start { 0 } else { contour.vertices.len() - 1 };
            let inner = contour.walk(tip, at_start).take_while(|(_, arc)| *arc <= DIRECTION_LENGTH * sigma).last();
            let point = &contour.vertices[tip];
            let direction = inner.and_then(|(inner, _)| (point.at - contour.vertices[inner].at).try_normalize());
            let contrast = if at_start { point.contrast.map(|v| -v) } else { point.contrast };
            ends.push(End {
                polyline: number,
                at_start,
                at: point.at,
                direction: direction.unwrap_or_default(),
                contrast,
            });
        }
    }
    ends
}

/// Cost of joining two ends; none if they may not be joined.
fn cost(a: &End<Px>, b: &End<Px>, lengths: &[f32], sigma: f32, of_drawing: bool) -> Option<f32> {
    let gap = b.at - a.at;
    let distance = gap.length();
    if distance > MAX_GAP * sigma
        || (a.polyline == b.polyline && lengths[a.polyline] < MIN_RING * distance + 2.0 * sigma)
    {
        return None;
    }
    if distance < COINCIDENT {
        return Some(distance);
    }
    let gap = gap / distance;
    let (cosine_a, cosine_b) = (a.direction.dot(gap), -b.direction.dot(gap));
    let cost = distance * (3.0 - cosine_a - cosine_b);
    if cosine_a.min(cosine_b) >= ALIGNED {
        return Some(cost);
    }
    // A contour that leaves through one end enters through the other, where right and left change places.
    let same_sides = dot(a.contrast, b.contrast) < 0.0;
    let least = if of_drawing && is_wedge(a, b) { BEHIND_AT_TIP } else { NOT_BEHIND };
    let in_front = cosine_a.min(cosine_b) >= least || distance <= OVERSHOOT * sigma;
    (same_sides && distance <= MAX_CORNER_GAP * sigma && in_front).then_some(cost)
}

/// Whether two ends point at the tip of a wedge.
fn is_wedge(a: &End<Px>, b: &End<Px>) -> bool {
    let is_sharp = a.direction.dot(b.direction) >= SHARP;
    is_sharp && (b.at - a.at).dot(a.direction - b.direction) > 0.0
}

/// The contours of a thread as one, with points in the gaps; each is taken from `left`.
fn concatenate(thread: &LinkedChain, left: &mut [Option<Contour>]) -> Option<Contour> {
    let mut whole = thread.concatenate(left, |before, next| {
        if let (Some(last), Some(first)) = (before.last().copied(), next.first()) {
            before.extend(between(&last, first));
        }
        before.extend(next);
    })?;
    // the gap of a ring that is closed by links; one that was a ring before has none
    if thread.closed
        && whole.closed
        && let [first, .., last] = whole.vertices[..]
    {
        whole.vertices.extend(between(&last, &first));
    }
    Some(whole)
}

/// Points about a pixel apart in the gap between two points.
fn between(from: &ContourPoint, to: &ContourPoint) -> impl Iterator<Item = ContourPoint> + use<> {
    let (from, to) = (*from, *to);
    let steps = (to.at - from.at).length().round() as usize;
    let position_sigma = from.position_sigma.max(to.position_sigma).max(GAP_SIGMA);
    (1..steps).map(move |k| ContourPoint { position_sigma, ..from.between(&to, k as f32 / steps as f32) })
}

#[cfg(test)]
mod tests;
