//! A line that is a little too near to others is displaced instead of being cut: a ring stays a ring. It moves by less
//! than a finger notices, and swings back to its place on both sides.

use super::drawn::DrawnLines;
use super::passage::Passage;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// The farthest that a line is displaced, mm: the index finger tells places from about 0.94 mm (Van Boven and Johnson
/// 1994).
const FARTHEST: f32 = 0.8;
/// A ring may be displaced by more, mm: that it closes says more than where exactly its side runs.
pub(in crate::lines) const RING_FARTHEST: f32 = 1.6;
/// It swings back within this length, mm, so that no corner is felt.
const FADE: f32 = 6.0;
/// A little more than it must, mm, so that it need not do so again.
const MORE: f32 = 0.02;
/// What rounding may put outside of the picture, mm.
const OUTSIDE: f32 = 0.01;
/// Away from one line can be towards another: after so many rounds it is cut after all.
const ROUNDS: usize = 4;

/// A displacement that a vertex needs, and its arc.
type Push = (f32, MmVector);

/// The line moved away from those it is too near to; none if that asks for more than [`FARTHEST`], for a ring
/// [`RING_FARTHEST`], somewhere.
pub(super) fn displaced(polyline: &Polyline<Vertex>, drawn: &DrawnLines<'_>) -> Option<Polyline<Vertex>> {
    let mut polyline = polyline.clone();
    let farthest = if polyline.closed { RING_FARTHEST } else { FARTHEST };
    let mut moved = vec![MmVector::zero(); polyline.vertices.len()];
    for _ in 0..ROUNDS {
        let passage = drawn.passage(polyline.view());
        let pushes = pushes(&polyline, &passage, drawn, farthest)?;
        if pushes.is_empty() {
            return Some(polyline);
        }
        for ((vertex, moved), &arc) in polyline.vertices.iter_mut().zip(&mut moved).zip(&passage.arcs) {
            let push = faded(arc, &pushes, &passage);
            vertex.at += push;
            *moved += push;
            // an outline may end on the border of the picture
            if moved.length() > farthest || !drawn.area.inflate(OUTSIDE, OUTSIDE).contains_inclusive(vertex.at) {
                return None;
            }
        }
    }
    None
}

/// The displacements of the vertices that are too near to a line; none if one is longer than `farthest`.
fn pushes(polyline: &Polyline<Vertex>, passage: &Passage, drawn: &DrawnLines<'_>, farthest: f32) -> Option<Vec<Push>> {
    let mut pushes = Vec::new();
    for (vertex, &arc) in polyline.vertices.iter().zip(&passage.arcs) {
        let mut push = MmVector::zero();
        drawn.each_near(vertex, arc, passage, |near| {
            if !near.joins && near.missing + MORE > push.length() {
                push = near.away * ((near.missing + MORE) / near.distance.max(MORE));
            }
            true
        });
        if push.length() > farthest {
            return None;
        }
        if push != MmVector::zero() {
            pushes.push((arc, push));
        }
    }
    Some(pushes)
}

/// The longest of the displacements at `arc`, each of which fades along the line; near junctions the line stays where
/// it is.
fn faded(arc: f32, pushes: &[Push], passage: &Passage) -> MmVector {
    let mut longest = MmVector::zero();
    for &(there, push) in pushes {
        let push = push * (1.0 - passage.between(arc, there) / FADE).max(0.0);
        if push.square_length() > longest.square_length() {
            longest = push;
        }
    }
    let junction = passage.junctions.iter().map(|j| passage.between(j.arc, arc)).fold(f32::MAX, f32::min);
    longest * (junction / FADE).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{drawn, polyline};
    use super::*;

    #[test]
    fn a_line_a_little_too_near_gives_way_and_its_far_parts_stay() {
        let lines = drawn(&[&[(10.0, 50.0), (30.0, 50.0)]]);
        // at 1.5 mm wide, lines must be 4.88 mm apart
        let near = polyline(&[(10.0, 54.5), (70.0, 54.5)], false);
        let away = displaced(&near, &lines).expect("0.4 mm are little");
        assert!(drawn_apart(&away, &lines));
        assert!(away.vertices.iter().zip(&near.vertices).all(|(a, b)| (a.at - b.at).length() < FARTHEST));
        assert_eq!(away.vertices.last(), near.vertices.last());
    }

    fn drawn_apart(polyline: &Polyline<Vertex>, lines: &DrawnLines<'_>) -> bool {
        lines.states(polyline).iter().all(|state| *state != super::super::drawn::State::TooNear)
    }

    #[test]
    fn a_line_much_too_near_does_not_give_way_but_a_ring_may_by_more() {
        let lines = drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]);
        assert_eq!(displaced(&polyline(&[(10.0, 53.0), (90.0, 53.0)], false), &lines), None);
        let sides = [(40.0, 53.8), (60.0, 53.8), (60.0, 75.0), (40.0, 75.0)];
        assert_eq!(displaced(&polyline(&sides[..2], false), &lines), None);
        let ring = displaced(&polyline(&sides, true), &lines).expect("1.1 mm are little for a ring");
        assert!(ring.closed && drawn_apart(&ring, &lines));
    }
}
