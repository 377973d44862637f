//! Junctions: a contour that ends just before another one is extended to it.
//!
//! Where three edges meet, the gradient has no single direction, and the weakest edge is found only up to a blur or two
//! before the others.

use lyon::geom::euclid::Box2D;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::contour::{Contour, ContourPoint, LineFit};
use crate::geom::nearby::Index;
use crate::units::{Px, PxPoint, PxVector, Size};

/// Greatest distance over which an end is extended, in blurs.
const MAX_EXTENSION: f32 = 3.5;
/// The last part of a contour before a junction is bent by the other contours: this much of it, in blurs, is replaced.
const BENT: f32 = 1.3;
/// A line is fitted to this much of the contour before that, in blurs.
const FIT_LENGTH: f32 = 4.0;
/// Least sine between a contour and the one that it is extended to: one nearly parallel is a neighbour, not a junction.
const MIN_SINE: f32 = 0.25;
/// How far beyond its ends a segment is still met, as a share of its length.
const TOLERANCE: f32 = 0.05;
/// Points this little beyond the junction, px, are removed too.
const TOO_CLOSE: f32 = 0.2;
/// Side of the cells of the index of points, px.
const CELL: f32 = 8.0;

/// An end of a contour with the line that it follows and the junction to which the line leads.
struct Extension {
    contour: usize,
    at_start: bool,
    line: LineFit,
    junction: PxPoint,
}

/// Extends open ends to the contours at which they point, in a picture of `size`.
pub(super) fn extend(contours: &mut [Contour], size: Size) {
    let index = index_of(contours, size);
    let is_open = |&number: &usize| !contours[number].closed && contours[number].vertices.len() > 3;
    let both_ends = |number| [true, false].into_iter().map(move |at_start| (number, at_start));
    let ends = (0..contours.len()).into_par_iter().filter(is_open).flat_map_iter(both_ends);
    let found: Vec<_> = ends.filter_map(|(number, at_start)| extension(contours, &index, number, at_start)).collect();
    for extension in found {
        apply(&mut contours[extension.contour], &extension);
    }
}

/// Where an end meets another contour if it continues straight on.
fn extension(contours: &[Contour], index: &PointIndex, number: usize, at_start: bool) -> Option<Extension> {
    let contour = &contours[number];
    let tip = if at_start { 0 } else { contour.vertices.len() - 1 };
    let ContourPoint { at: end, blur, .. } = contour.vertices[tip];
    let line = contour
        .line_fit(tip, at_start, BENT * blur, (BENT + FIT_LENGTH) * blur)
        .or_else(|| contour.line_fit(tip, at_start, 0.0, FIT_LENGTH * blur))?;
    let ahead = -line.direction; // the line is directed away from the tip
    let from = line.nearest(end) - ahead * (BENT * blur);
    let reach = (MAX_EXTENSION + BENT) * blur;
    // the last part of the contour itself does not count
    let is_own =
        |k: usize| contour.walk(tip, at_start).take_while(|(_, arc)| *arc < 3.0 * reach).any(|(own, _)| own == k);
    let mut nearest: Option<f32> = None;
    index.around(end, end, reach, |&(other, k)| {
        let (other, k) = (other as usize, k as usize);
        let Some(next) = contours[other].next(k, 1) else { return };
        if other == number && (is_own(k) || is_own(next)) {
            return;
        }
        let (a, b) = (contours[other].vertices[k].at, contours[other].vertices[next].at);
        if let Some(distance) = crossing(from, ahead, a, b)
            && distance <= reach
            && nearest.is_none_or(|least| distance < least)
        {
            nearest = Some(distance);
        }
    });
    nearest.map(|distance| Extension { contour: number, at_start, line, junction: from + ahead * distance })
}

/// Distance along the ray at which it crosses the segment `a`-`b`, if it does.
fn crossing(from: PxPoint, ahead: PxVector, a: PxPoint, b: PxPoint) -> Option<f32> {
    let side = b - a;
    let sine = ahead.cross(side);
    if sine.abs() < MIN_SINE * side.length() {
        return None;
    }
    let between = a - from;
    let (distance, share) = (between.cross(side) / sine, between.cross(ahead) / sine);
    (distance >= 0.0 && (-TOLERANCE..=1.0 + TOLERANCE).contains(&share)).then_some(distance)
}

/// Moves the last points of a contour onto its line, up to the junction.
fn apply(contour: &mut Contour, extension: &Extension) {
    let Extension { at_start, line, junction, .. } = extension;
    if !at_start {
        contour.reverse();
    }
    let blur = contour.vertices[0].blur;
    let bent = contour.walk(0, true).take_while(|(_, arc)| *arc < BENT * blur).count();
    let tip = ContourPoint { at: *junction, ..contour.vertices[0] };
    for point in &mut contour.vertices[..bent] {
        point.at = line.nearest(point.at);
    }
    let is_beyond = |point: &ContourPoint| line.direction.dot(point.at - *junction) <= TOO_CLOSE;
    let beyond = contour.vertices.iter().take_while(|point| is_beyond(point)).count().min(bent);
    contour.vertices.splice(..beyond, [tip]);
    if !at_start {
        contour.reverse();
    }
}

/// The points of all contours by place, each as its contour and its number there.
type PointIndex = Index<(u32, u32), Px>;

fn index_of(contours: &[Contour], size: Size) -> PointIndex {
    let picture = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    let mut index = PointIndex::new(picture, CELL);
    for (number, contour) in contours.iter().enumerate() {
        for (k, point) in contour.vertices.iter().enumerate() {
            index.put_at(point.at, (number as u32, k as u32));
        }
    }
    index
}

#[cfg(test)]
mod tests {
    use super::super::contour::testing::{circle, polyline};
    use super::*;

    const SIZE: Size = Size { width: 100, height: 100 };

    /// The contours with their ends extended.
    fn extended(contours: &[Contour]) -> Vec<Contour> {
        let mut contours = contours.to_vec();
        extend(&mut contours, SIZE);
        contours
    }

    #[test]
    fn an_end_before_another_contour_is_extended_to_it() {
        let bar = polyline(&[(50.0, 20.0), (50.0, 80.0)]);
        let stem = polyline(&[(20.0, 50.3), (47.0, 50.3)]);
        for stem in [stem.clone(), stem.clone().reversed()] {
            let found = extended(&[bar.clone(), stem.clone()]);
            assert_eq!(found[0], bar, "the other contour stays");
            let ends = [0, found[1].vertices.len() - 1].map(|k| found[1].vertices[k]);
            let tip = if ends[0].at.x > ends[1].at.x { ends[0] } else { ends[1] };
            assert!((tip.at - PxPoint::new(50.0, 50.3)).length() < 1e-3, "{:?}", tip.at);
            let unchanged = tip.contrast.iter().zip(stem.vertices[0].contrast).all(|(a, b)| (a - b).abs() < 1e-6);
            assert!(unchanged, "{:?}", tip.contrast);
            assert!((found[1].length() - 30.0).abs() < 1e-3, "{}", found[1].length());
        }
    }

    #[test]
    fn a_bent_end_is_straightened_first() {
        let mut stem = polyline(&[(20.0, 50.0), (48.0, 50.0)]);
        let n = stem.vertices.len();
        stem.vertices[n - 1].at.y = 51.0;
        let found = extended(&[polyline(&[(50.0, 20.0), (50.0, 80.0)]), stem]);
        assert!(found[1].vertices.iter().all(|point| (point.at.y - 50.0).abs() < 1e-3), "{:?}", found[1].vertices);
        assert!((found[1].length() - 30.0).abs() < 1e-3);
    }

    #[test]
    fn ends_that_are_far_away_or_parallel_and_closed_contours_stay() {
        let bar = polyline(&[(50.0, 20.0), (50.0, 80.0)]);
        let far = polyline(&[(10.0, 50.0), (40.0, 50.0)]);
        let parallel = polyline(&[(47.0, 10.0), (47.0, 40.0)]);
        let away = polyline(&[(52.0, 50.0), (53.0, 50.0), (53.0, 90.0)]);
        for other in [far, parallel, circle(2.0)] {
            let contours = [bar.clone(), other];
            assert_eq!(extended(&contours), contours);
        }
        let found = extended(&[bar.clone(), away.clone()]);
        let last = away.vertices.len() - 1;
        assert_eq!(found[1].vertices[found[1].vertices.len() - 1], away.vertices[last], "it points at nothing");
    }
}
