//! A line that is a little too near to others gives way instead of being cut: a ring stays a ring. It moves by less than a
//! finger notices, and swings back to its place on both sides.

use super::field::Field;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// The farthest that a line gives way, mm: the index finger tells places from about 0.94 mm (Van Boven and Johnson 1994).
const FARTHEST: f32 = 0.8;
/// A ring may give way by more, mm: that it closes says more than where exactly its side runs.
pub(in crate::lines) const RING_FARTHEST: f32 = 1.6;
/// It swings back within this length, mm, so that no corner is felt.
const FADE: f32 = 6.0;
/// A little more than it must, mm, so that it need not do so again.
const MORE: f32 = 0.02;
/// Giving way to one line can lead towards another: after so many times it is cut after all.
const ROUNDS: usize = 4;

/// The line moved away from those it is too near to; none if that asks for more than [`FARTHEST`], for a ring
/// [`RING_FARTHEST`], somewhere.
pub(super) fn nudged(polyline: &Polyline<Vertex>, field: &Field<'_>) -> Option<Polyline<Vertex>> {
    let mut polyline = polyline.clone();
    let farthest = if polyline.closed { RING_FARTHEST } else { FARTHEST };
    let mut moved = vec![MmVector::zero(); polyline.vertices.len()];
    for _ in 0..ROUNDS {
        let places = field.places(polyline.view());
        let mut pushes: Vec<(f32, MmVector)> = Vec::new();
        for (vertex, &arc) in polyline.vertices.iter().zip(&places.arcs) {
            let mut push = MmVector::zero();
            field.each_near(vertex, arc, &places, |near, away, joins| {
                if !joins && near.missing + MORE > push.length() {
                    push = away * ((near.missing + MORE) / near.distance.max(MORE));
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
        if pushes.is_empty() {
            return Some(polyline);
        }
        for ((vertex, moved), &arc) in polyline.vertices.iter_mut().zip(&mut moved).zip(&places.arcs) {
            let mut most = MmVector::zero();
            for &(there, push) in &pushes {
                let push = push * (1.0 - places.way(arc, there) / FADE).max(0.0);
                if push.square_length() > most.square_length() {
                    most = push;
                }
            }
            // where it meets others it stays
            let meeting = places.meetings.iter().map(|m| places.way(m.arc, arc)).fold(f32::MAX, f32::min);
            let most = most * (meeting / FADE).min(1.0);
            vertex.at += most;
            *moved += most;
            if moved.length() > farthest {
                return None;
            }
        }
    }
    None
}
