//! Clouds of points, such as those of a scatter plot: many filled ones that are alike, and are drawn as discs.

use super::by_place::PointIndex;
use super::point::{LEAST_IN_PIXELS, MAGNIFIED, Point, disc_radius, is_like};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::lines::marks::SERIES;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::units::MmRect;

/// Filled points beside lines that are many and alike, such as those of a scatter plot: they are discs, each at its own
/// place, and so are those like them that happen to lie on lines, which are no points of these. Gives those beside
/// lines, with their numbers. In pixels they are circles of some size and apart from all lines, as noise has many that
/// are alike, and have no other outline inside, as a broad ring has. Where lines become dots there are none.
pub(super) fn scattered(
    points: &mut [Point],
    alone: &[(usize, Point)],
    polylines: &[Polyline<Vertex>],
    params: &Params,
) -> Vec<(usize, Point)> {
    if params.on_dots() {
        return Vec::new();
    }
    let mut are_discs = which_are_discs(alone, params);
    leave_out_beside_lines(&mut are_discs, alone, polylines, params);
    // the outline of a disc beside its stroke is no other disc
    let mut found = PointIndex::over(alone, params);
    let mut apart: Vec<Point> = Vec::new();
    for (&(number, point), _) in alone.iter().zip(&are_discs).filter(|(_, is_disc)| **is_disc) {
        if !found.is_any_same(number, &point) {
            found.put(number, point);
            apart.push(point);
        }
    }
    // no more are looked at than are needed
    let is_of_cloud = |point: &Point| apart.iter().filter(|other| is_like(point, other)).take(SERIES).count() == SERIES;
    for point in points.iter_mut().filter(|point| is_of_cloud(point)) {
        (point.is_disc, point.series) = (true, None);
    }
    let disc = |(number, point): &(usize, Point)| (*number, Point { is_alone: true, is_disc: true, ..*point });
    let is_one = |point: &Point, is_disc: bool| (point.is_exact || is_disc) && is_of_cloud(point);
    let ones = alone.iter().zip(are_discs).filter(|((_, point), is_disc)| is_one(point, *is_disc));
    ones.map(|(one, _)| disc(one)).collect()
}

/// Which of these points beside lines are discs. A bitmap of a halftone has ten thousand, so what is cheap is asked
/// first, and what is near is found by its place.
fn which_are_discs(alone: &[(usize, Point)], params: &Params) -> Vec<bool> {
    let mut all = PointIndex::over(alone, params);
    alone.iter().for_each(|(number, point)| all.put(*number, *point));
    let is_disc = |(number, point): &(usize, Point)| {
        let share = if point.is_exact { 1.0 / MAGNIFIED } else { LEAST_IN_PIXELS };
        let is_large = point.is_filled && point.radius >= share * disc_radius(params);
        is_large && (point.is_exact || point.is_sure && !all.is_any_same(*number, point))
    };
    alone.iter().map(is_disc).collect()
}

/// Of discs in pixels those beside lines, or other rings, are none; nor are any where that is so of more than a
/// quarter.
fn leave_out_beside_lines(
    are_discs: &mut [bool],
    alone: &[(usize, Point)],
    polylines: &[Polyline<Vertex>],
    params: &Params,
) {
    let in_pixels: Vec<usize> = (0..alone.len()).filter(|&i| are_discs[i] && !alone[i].1.is_exact).collect();
    if in_pixels.is_empty() {
        return;
    }
    let mut is_other = vec![true; polylines.len()];
    in_pixels.iter().for_each(|&i| is_other[alone[i].0] = false);
    let others = polylines.iter().zip(is_other).filter(|(_, is_other)| *is_other);
    let area = MmRect::from_points(alone.iter().map(|(_, point)| point.at));
    let mut lines: Nearby = Nearby::new(area, params.max_spacing());
    others.for_each(|(line, _)| lines.insert_line(0, line.view(), 0.0));
    let is_beside = |point: &Point| {
        let reach = point.radius.max(disc_radius(params)) + params.max_spacing();
        lines.nearest(point.at, reach, |_| true).is_some()
    };
    let beside: Vec<usize> = in_pixels.iter().copied().filter(|&i| is_beside(&alone[i].1)).collect();
    let left_out = if 4 * beside.len() > in_pixels.len() { in_pixels } else { beside };
    left_out.into_iter().for_each(|i| are_discs[i] = false);
}
