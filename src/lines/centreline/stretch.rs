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
mod tests {
    use super::super::opposite::opposites;
    use super::super::testing::{area, bar, side, stroke};
    use super::*;
    use crate::lines::params::Params;

    fn of(lines: &[Polyline<Vertex>]) -> Vec<StrokeSide> {
        stretches(lines, &opposites(lines, area(), &Params::TEST))
    }

    #[test]
    fn a_stretch_is_as_long_as_the_other_side_and_as_salient_as_it_is_long_and_strong() {
        let found = of(&stroke(3.0));
        let [long, short] = &found[..] else { panic!("{} stretches", found.len()) };
        assert_eq!([(long.polyline, long.other), (short.polyline, short.other)], [(0, 1), (1, 0)]);
        assert!((long.count as f32 * 0.4 - 20.0).abs() < 1.0 && (long.from as f32 * 0.4 - 10.0).abs() < 0.5);
        assert!((short.saliency - 20.0 * 60.0).abs() < 60.0, "{}", short.saliency);
    }

    #[test]
    fn the_stretches_of_a_ring_are_the_same_wherever_it_begins() {
        let count = bar(3.0, 0).vertices.len();
        let places = |start: usize| {
            let mut places: Vec<(usize, usize)> =
                of(&[bar(3.0, start)]).iter().map(|found| ((found.from + start) % count, found.count)).collect();
            places.sort_unstable();
            places
        };
        let first = places(0);
        assert_eq!(first.len(), 2, "both sides: {first:?}");
        for start in 1..count {
            // which of the vertices at the ends of the bar still have an opposite is a matter of rounding
            let is_alike =
                |(a, b): (&(usize, usize), &(usize, usize))| a.0.abs_diff(b.0) <= 1 && a.1.abs_diff(b.1) <= 2;
            let now = places(start);
            assert!(
                now.len() == 2 && now.iter().zip(&first).all(is_alike),
                "{now:?} from vertex {start}, not {first:?}"
            );
        }
    }

    #[test]
    fn a_side_shorter_than_one_and_a_half_widths_is_no_stroke() {
        let beside = |length: f32| {
            let short = side(&[(20.0, 23.0), (20.0 + length, 23.0)], false, -60.0);
            of(&[side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0), short]).len()
        };
        assert_eq!([beside(4.0), beside(5.2)], [0, 2]);
    }
}
