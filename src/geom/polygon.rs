//! Closed polygons: what they enclose; boxes, and circles as such.

use lyon::geom::LineSegment;
use lyon::geom::euclid::{Box2D, Point2D, Vector2D};
use std::f32::consts::{PI, TAU};

/// The area inside a ring, by the triangles that its sides make with its first point (the shoelace formula).
pub fn area<U>(points: &[Point2D<f32, U>]) -> f32 {
    let Some(&first) = points.first() else { return 0.0 };
    0.5 * points.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum::<f32>().abs()
}

/// How round a shape of this area and circumference is: 1 of a circle, 0.79 of a square, 0 of a line.
pub fn roundness(area: f32, length: f32) -> f32 {
    4.0 * PI * area / (length * length).max(f32::MIN_POSITIVE)
}

/// A circle as so many points, from the one on its right on, clockwise where y points down.
pub fn circle_points<U>(
    middle: Point2D<f32, U>,
    radius: f32,
    count: usize,
) -> impl Iterator<Item = Point2D<f32, U>> + Clone {
    (0..count).map(move |k| {
        let (y, x) = (k as f32 / count as f32 * TAU).sin_cos();
        middle + Vector2D::new(x, y) * radius
    })
}

/// The corners of a box, from its least one on: right, down and left of that.
pub fn corners<U>(of: Box2D<f32, U>) -> [Point2D<f32, U>; 4] {
    let [left, top, right, bottom] = [of.min.x, of.min.y, of.max.x, of.max.y];
    [(left, top), (right, top), (right, bottom), (left, bottom)].map(Point2D::from)
}

/// Whether a box lies in another one, also a box without area, as that around a level line.
pub fn holds_box<U>(outer: Box2D<f32, U>, inner: Box2D<f32, U>) -> bool {
    outer.contains_inclusive(inner.min) && outer.contains_inclusive(inner.max)
}

/// Distance of a point from a box; 0 inside.
pub fn distance_to_box<U>(at: Point2D<f32, U>, place: Box2D<f32, U>) -> f32 {
    (at - at.clamp(place.min, place.max)).length()
}

/// Where a segment crosses the border of a box, if one of its ends lies inside and the other outside.
pub fn exit<U>(a: Point2D<f32, U>, b: Point2D<f32, U>, place: Box2D<f32, U>) -> Option<Point2D<f32, U>> {
    let (from, to) = match [a, b].map(|end| place.contains_inclusive(end)) {
        [true, false] => (a, b),
        [false, true] => (b, a),
        _ => return None,
    };
    let segment = LineSegment { from: from.to_untyped(), to: to.to_untyped() };
    segment.clipped(&place.to_untyped()).map(|inside| Point2D::from_untyped(inside.to))
}

/// Whether a point lies in a convex polygon, or on its side.
pub fn is_in_convex<U>(at: Point2D<f32, U>, corners: &[Point2D<f32, U>]) -> bool {
    let side = |i: usize| (corners[(i + 1) % corners.len()] - corners[i]).cross(at - corners[i]);
    (0..corners.len()).all(|i| side(i) >= 0.0) || (0..corners.len()).all(|i| side(i) <= 0.0)
}

/// Where sides of polygons cross the row at height `y`, in no order.
fn crossings<'a, U: 'a>(
    sides: impl Iterator<Item = (&'a Point2D<f32, U>, &'a Point2D<f32, U>)>,
    y: f32,
) -> impl Iterator<Item = f32> {
    let crossed = sides.filter(move |(a, b)| (a.y > y) != (b.y > y));
    crossed.map(move |(a, b)| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
}

/// The parts of the row at height `y` that lie inside an odd number of polygons (the even-odd rule), given by all sides
/// of these: from where to where, from left to right.
pub fn row_inside<'a, U: 'a>(
    sides: impl Iterator<Item = (&'a Point2D<f32, U>, &'a Point2D<f32, U>)>,
    y: f32,
) -> Vec<[f32; 2]> {
    let mut crossings: Vec<f32> = crossings(sides, y).collect();
    crossings.sort_by(f32::total_cmp);
    crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Whether a point lies inside an odd number of polygons, given by all sides of these.
pub fn is_inside<'a, U: 'a>(
    sides: impl Iterator<Item = (&'a Point2D<f32, U>, &'a Point2D<f32, U>)>,
    at: Point2D<f32, U>,
) -> bool {
    crossings(sides, at.y).filter(|x| at.x < *x).count() % 2 == 1
}

#[cfg(test)]
mod tests;
