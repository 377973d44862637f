//! Stretches: parts of a polyline that run beside one other polyline, or beside another part of their own.

use super::opposite::{Opposite, Opposites};
use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::lines::vertex::Vertex;

/// The shortest stretch of two sides that counts as a stroke, in widths of the stroke; shorter ones are the ends of
/// other shapes.
pub(super) const MIN_STRETCH: f32 = 1.5;

/// A stretch of one polyline along which it has opposites on one other.
pub(super) struct StrokeSide {
    pub(super) polyline: usize,
    pub(super) other: usize,
    pub(super) from: usize,
    /// Number of vertices; in a ring it may continue over its first.
    pub(super) count: usize,
    /// Length times strength.
    pub(super) saliency: f32,
}

impl StrokeSide {
    /// Its vertices with their opposites.
    pub(super) fn opposites(&self, all: &[Opposites]) -> impl Iterator<Item = (usize, Opposite)> {
        let own = &all[self.polyline];
        let index = |k: usize| (self.from + k) % own.len();
        (0..self.count).map(index).filter_map(|i| own[i].map(|opposite| (i, opposite)))
    }
}

/// Stretches of vertices with opposites on the same polyline that are long enough for a stroke.
pub(super) fn stretches(polylines: &[Polyline<Vertex>], opposites: &[Opposites]) -> Vec<StrokeSide> {
    let mut found = Vec::new();
    for (number, (polyline, opposites)) in polylines.iter().zip(opposites).enumerate() {
        let other = |i: usize| opposites[i].map(|opposite| opposite.polyline);
        for run in runs(opposites.len(), polyline.closed, |a, b| other(a) == other(b)) {
            let Some(beside) = other(run[0]) else { continue };
            let steps = run.windows(2).map(|pair| {
                let (before, here) = (&polyline.vertices[pair[0]], &polyline.vertices[pair[1]]);
                ((here.at - before.at).length(), here.strength.min(before.strength))
            });
            let (length, saliency) =
                steps.fold((0.0, 0.0), |(length, saliency), (step, least)| (length + step, saliency + step * least));
            let across =
                |&i: &usize| opposites[i].map_or(0.0, |opposite| (opposite.at - polyline.vertices[i].at).length());
            let across: f32 = run.iter().map(across).sum();
            if length >= MIN_STRETCH * across / run.len() as f32 {
                found.push(StrokeSide { polyline: number, other: beside, from: run[0], count: run.len(), saliency });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests;
