//! Stretches: parts of a polyline that run beside one other polyline, or beside another part of their own.

use super::opposite::{Opposite, Opposites};
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;

/// The shortest stretch of two sides that counts as a stroke, in widths of the stroke; shorter ones are the ends of
/// other shapes.
pub(super) const MIN_STRETCH: f32 = 1.5;

/// A stretch of one polyline along which it has opposites on one other.
pub(super) struct Stretch {
    pub(super) polyline: usize,
    pub(super) other: usize,
    pub(super) from: usize,
    /// Number of vertices; in a ring it may continue over its first.
    pub(super) count: usize,
    /// Length times strength.
    pub(super) saliency: f32,
}

impl Stretch {
    /// Its vertices with their opposites.
    pub(super) fn opposites(&self, all: &[Opposites]) -> impl Iterator<Item = (usize, Opposite)> {
        let own = &all[self.polyline];
        let index = |k: usize| (self.from + k) % own.len();
        (0..self.count).map(index).filter_map(|i| own[i].map(|opposite| (i, opposite)))
    }
}

/// Stretches of vertices with opposites on the same polyline that are long enough for a stroke.
pub(super) fn stretches(polylines: &[Polyline<Vertex>], opposites: &[Opposites]) -> Vec<Stretch> {
    let mut found = Vec::new();
    for (number, (polyline, opposites)) in polylines.iter().zip(opposites).enumerate() {
        let count = opposites.len();
        let other = |k: usize| opposites[k % count].map(|opposite| opposite.polyline);
        // a ring is gone round from where a stretch begins
        let goes_on = |k: usize| other(k).is_some() && other(k) == other(k + count - 1);
        let start = if polyline.closed { (0..count).find(|&k| !goes_on(k)).unwrap_or(0) } else { 0 };
        let mut k = start;
        while k < start + count {
            let Some(first) = other(k) else {
                k += 1;
                continue;
            };
            let from = k;
            let (mut length, mut across, mut saliency) = (0.0, 0.0, 0.0);
            while k < start + count && other(k) == Some(first) {
                let here = &polyline.vertices[k % count];
                if k > from {
                    let before = &polyline.vertices[(k - 1) % count];
                    let step = (here.at - before.at).length();
                    length += step;
                    saliency += step * here.strength.min(before.strength);
                }
                across += opposites[k % count].map_or(0.0, |opposite| (opposite.at - here.at).length());
                k += 1;
            }
            let length_in_vertices = k - from;
            if length >= MIN_STRETCH * across / length_in_vertices as f32 {
                found.push(Stretch {
                    polyline: number,
                    other: first,
                    from: from % count,
                    count: length_in_vertices,
                    saliency,
                });
            }
        }
    }
    found
}
