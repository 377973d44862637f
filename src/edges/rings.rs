//! A line that comes back to itself is a ring, and what leads to the ring: where a leader meets a circle, the two may
//! have been found as one line.

use super::params::HEADING;
use super::tips::FoundContour;
use crate::geom::polyline::Polyline;

/// An end meets its own line where it is no farther from the middle of the stroke than half its width and this, px.
const NEAR: f32 = 2.0;
/// An end meets its own line also where that is so far ahead, px: an edge that meets a stroke ends before it.
const AHEAD_LENGTH: f32 = 8.0;
/// An end that meets its own line goes on in it: least cosine between their directions (37 degrees).
const SMOOTH: f32 = 0.8;
const BENT: f32 = 3.0;

/// A ring is at least this many least lengths of a contour long: what is shorter is felt as a dot at an end.
const RING: f32 = 3.0;

/// Contours of which those that come back to themselves are parted. `least` is the length of the shortest contour, px.
pub(super) fn split_at_contact(found: Vec<FoundContour>, least: f32) -> Vec<FoundContour> {
    let mut all = Vec::with_capacity(found.len());
    for found in found {
        let mut left = Some(found);
        // what leads to a ring may come from another one
        while let Some(found) = left {
            let (first, lead) = part(found, RING * least);
            all.push(first);
            left = lead;
        }
    }
    all
}

/// The ring, and what leads to it; or the contour itself.
fn part(mut found: FoundContour, least: f32) -> (FoundContour, Option<FoundContour>) {
    for turned in [false, true] {
        if turned {
            found.contour.reverse();
        }
        if let Some(at) = comes_back_to(&found, least) {
            let vertices = &found.contour.vertices;
            let ring = Polyline { vertices: vertices[at..].to_vec(), closed: true };
            let lead = Polyline::open(vertices[..=at].to_vec());
            let part = |contour| FoundContour { contour, ..found };
            let lead = (lead.length() >= HEADING).then(|| part(lead));
            return (part(ring), lead);
        }
    }
    found.contour.reverse();
    (found, None)
}

/// The vertex of an open contour to which its end comes back.
fn comes_back_to(found: &FoundContour, least: f32) -> Option<usize> {
    let contour = &found.contour;
    if contour.closed {
        return None;
    }
    let last = contour.vertices.len().checked_sub(1)?;
    let tip = contour.vertices[last].at;
    let along = |from: usize, forwards: bool| contour.heading(from, forwards, [BENT, BENT + HEADING]);
    let end = -along(last, false)?;
    let early = contour.walk(last, false).find(|(_, arc)| *arc >= least)?.0;
    let near = 0.5 * found.stroke.unwrap_or(0.0) + NEAR;
    let goes_on = |at: &usize| {
        let gap = contour.vertices[*at].at - tip;
        let is_ahead = end.dot(gap) >= SMOOTH * gap.length();
        (gap.length() <= near || gap.length() <= AHEAD_LENGTH && is_ahead)
            && along(*at, true).is_some_and(|on| end.dot(on) >= SMOOTH)
    };
    let distance = |i: &usize| (contour.vertices[*i].at - tip).length();
    (0..=early).filter(goes_on).min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

#[cfg(test)]
mod tests {
    use super::super::contour::ContourPoint;
    use super::super::contour::testing::polyline;
    use super::*;
    use crate::units::PxPoint;
    use std::f32::consts::TAU;

    const LEAST: f32 = 8.0;

    /// A leader that comes to a circle from the right and goes round it, as far as `round` of it.
    fn leader(round: f32) -> FoundContour {
        let turn = |k: u16| f32::from(k) / 60.0 * TAU * round;
        let circle = (0..=60).map(turn).map(|angle| (100.0 + 40.0 * angle.cos(), 100.0 + 40.0 * angle.sin()));
        let points: Vec<(f32, f32)> = std::iter::once((200.0, 100.0)).chain(circle).collect();
        FoundContour { stroke: Some(2.0), ..FoundContour::edge(polyline(&points)) }
    }

    #[test]
    fn a_circle_is_parted_from_its_leader_whichever_way_they_run() {
        let mut reversed = leader(0.98);
        reversed.contour.reverse();
        for found in [leader(1.0), leader(0.98), reversed] {
            let parts = split_at_contact(vec![found], LEAST);
            let [ring, lead] = &parts[..] else { panic!("{}", parts.len()) };
            assert!(ring.contour.closed && (ring.contour.length() - 40.0 * TAU).abs() < 4.0);
            assert!(!lead.contour.closed && (lead.contour.length() - 60.0).abs() < 4.0);
        }
    }

    #[test]
    fn two_rings_are_parted_from_the_line_between_them() {
        let right = leader(1.0).contour.vertices;
        let left = right.iter().skip(1).map(|vertex| {
            let at = PxPoint::new(400.0 - vertex.at.x, vertex.at.y);
            ContourPoint { at, ..*vertex }
        });
        let contour = Polyline::open(left.rev().chain(right.iter().copied()).collect());
        let parts = split_at_contact(vec![FoundContour { stroke: Some(2.0), ..FoundContour::edge(contour) }], LEAST);
        let [first, second, lead] = &parts[..] else { panic!("{}", parts.len()) };
        assert!([first, second].iter().all(|ring| ring.contour.closed));
        assert!([first, second].iter().all(|ring| (ring.contour.length() - 40.0 * TAU).abs() < 4.0));
        assert!(!lead.contour.closed && (lead.contour.length() - 120.0).abs() < 4.0, "{}", lead.contour.length());
    }

    #[test]
    fn a_line_that_ends_elsewhere_or_across_itself_stays_one() {
        let across = polyline(&[(200.0, 100.0), (100.0, 100.0), (100.0, 60.0), (150.0, 60.0), (150.0, 98.0)]);
        for found in [leader(0.8), FoundContour { stroke: Some(2.0), ..FoundContour::edge(across) }] {
            assert_eq!(split_at_contact(vec![found.clone()], LEAST), [found]);
        }
    }
}
