//! Bridges gaps: ends of contours that belong together are joined, over weak parts of a contour and around corners so
//! sharp that the gradient has no clear direction there.

use super::contour::{Contour, ContourPoint};
use crate::geom::link::{End, LinkedChain, link};
use crate::geom::polyline::Blend;
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
pub(super) fn join(contours: Vec<Contour>, sigma: f32) -> Vec<Contour> {
    let lengths: Vec<f32> = contours.iter().map(Contour::length).collect();
    let cost = |a: &End<Px>, b: &End<Px>| cost(a, b, &lengths, sigma);
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
fn cost(a: &End<Px>, b: &End<Px>, lengths: &[f32], sigma: f32) -> Option<f32> {
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
    let same_sides = a.contrast.iter().zip(&b.contrast).map(|(a, b)| a * b).sum::<f32>() < 0.0;
    let in_front = cosine_a.min(cosine_b) >= NOT_BEHIND || distance <= OVERSHOOT * sigma;
    (same_sides && distance <= MAX_CORNER_GAP * sigma && in_front).then_some(cost)
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
mod tests {
    use super::super::contour::testing::polyline;
    use super::*;

    const SIGMA: f32 = 1.5;

    /// The joined contours: number of points, and whether they are closed.
    fn joined(contours: &[Contour]) -> Vec<(usize, bool)> {
        join(contours.to_vec(), SIGMA).iter().map(|contour| (contour.vertices.len(), contour.closed)).collect()
    }

    #[test]
    fn aligned_ends_are_joined_over_a_gap_with_points_of_large_position_error() {
        let (left, right) = (polyline(&[(0.0, 0.0), (20.0, 0.0)]), polyline(&[(26.0, 0.0), (46.0, 0.0)]));
        // whatever the directions in which the contours run
        for contours in [[left.clone(), right.clone()], [right.clone().reversed(), left.clone()]] {
            let whole = join(contours.to_vec(), SIGMA);
            assert_eq!(whole.len(), 1);
            assert_eq!((whole[0].vertices.len(), whole[0].closed), (47, false));
            assert!((whole[0].length() - 46.0).abs() < 1e-3, "{}", whole[0].length());
            let bridged = whole[0].vertices.iter().filter(|point| point.position_sigma >= GAP_SIGMA);
            assert!(bridged.map(|point| point.at.x).all(|x| x > 20.5 && x < 25.5), "only the gap is uncertain");
        }
        let far = polyline(&[(30.0, 0.0), (46.0, 0.0)]);
        assert_eq!(joined(&[left.clone(), far]).len(), 2, "the gap is too wide");
        let aside = polyline(&[(24.0, 4.0), (44.0, 4.0)]);
        assert_eq!(joined(&[left, aside]).len(), 2, "the ends do not point at one another");
    }

    #[test]
    fn ends_at_a_corner_are_joined_only_with_the_same_colours_on_the_same_sides() {
        let (along, down) = (polyline(&[(0.0, 0.0), (20.0, 0.0)]), polyline(&[(21.5, 1.5), (21.5, 20.0)]));
        assert_eq!(joined(&[along.clone(), down.clone()]).len(), 1);
        let mut opposite = down;
        opposite.vertices.iter_mut().for_each(|point| *point = point.reversed());
        assert_eq!(joined(&[along, opposite]).len(), 2);
    }

    #[test]
    fn a_contour_whose_ends_meet_is_closed_and_a_short_one_is_not() {
        let square = polyline(&[(3.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0), (0.0, 0.0), (1.0, 0.0)]);
        assert_eq!(joined(std::slice::from_ref(&square)), [(square.vertices.len() + 1, true)]);
        let hook = polyline(&[(3.0, 0.0), (3.0, 2.0), (0.0, 2.0), (0.0, 0.0)]);
        assert_eq!(joined(std::slice::from_ref(&hook)), [(hook.vertices.len(), false)]);
    }

    #[test]
    fn halves_of_a_ring_become_one_closed_contour() {
        let upper = polyline(&[(0.0, 9.0), (0.0, 0.0), (30.0, 0.0), (30.0, 9.0)]);
        let lower = polyline(&[(30.0, 12.0), (30.0, 20.0), (0.0, 20.0), (0.0, 12.0)]);
        let whole = join(vec![upper, lower.reversed()], SIGMA);
        assert_eq!(whole.len(), 1);
        assert!(whole[0].closed && (whole[0].length() - 100.0).abs() < 1e-3, "{}", whole[0].length());
    }
}
