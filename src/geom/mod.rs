//! Plane geometry that several stages share. Lengths are in the unit of the points given: pixels up to the page
//! transform, millimetres after it.

pub mod cells;
pub mod components;
pub mod distance;
pub mod form;
pub mod gridlines;
pub mod link;
pub mod nearby;
pub mod ninths;
pub mod order;
pub mod polygon;
pub mod polyline;
pub mod simplify;
pub mod spaced_row;
pub mod walk;

use lyon::geom::euclid::{Point2D, Vector2D};

/// A line runs along another if their directions differ by no more than 40 degrees: the cosine. What crosses it or
/// ends at it does not. Chosen by us: a line drawn by eye or moved aside is some degrees off, and a grid of dots has
/// steps of 45 degrees.
pub const ALONG: f32 = 0.77;

/// Unit vector along the first eigenvector of the symmetric matrix `[[xx, xy], [xy, yy]]`; none if all directions are
/// equal. Its sign has no meaning.
#[inline(always)]
pub fn first_eigenvector<U>(xx: f32, xy: f32, yy: f32) -> Option<Vector2D<f32, U>> {
    let difference = 0.5 * (xx - yy);
    let root = (difference * difference + xy * xy).sqrt();
    // of the two formulas of the eigenvector, the one without cancellation
    let along = if difference >= 0.0 { (difference + root, xy) } else { (xy, root - difference) };
    Vector2D::from(along).try_normalize()
}

/// The vector turned by a right angle to its right, with y down.
#[inline(always)]
pub fn right_of<U>(vector: Vector2D<f32, U>) -> Vector2D<f32, U> {
    Vector2D::new(-vector.y, vector.x)
}

/// The number a share, 0..=1, of the step from `a` to `b`.
#[inline(always)]
pub fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}

/// Distance from `p` to the segment `a`-`b`, and the nearest point on it.
pub fn nearest_on_segment<U>(p: Point2D<f32, U>, a: Point2D<f32, U>, b: Point2D<f32, U>) -> (f32, Point2D<f32, U>) {
    let ab = b - a;
    let square = ab.square_length();
    let t = if square > 0.0 { ((p - a).dot(ab) / square).clamp(0.0, 1.0) } else { 0.0 };
    let nearest = a + ab * t;
    ((p - nearest).length(), nearest)
}

/// Least distance between the segments `a`-`b` and `c`-`d`; 0 where they cross.
pub fn segment_distance<U>(
    (a, b): (Point2D<f32, U>, Point2D<f32, U>),
    (c, d): (Point2D<f32, U>, Point2D<f32, U>),
) -> f32 {
    if crosses((a, b), (c, d)) {
        return 0.0;
    }
    let distance = |p, s, e| nearest_on_segment(p, s, e).0;
    distance(a, c, d).min(distance(b, c, d)).min(distance(c, a, b)).min(distance(d, a, b))
}

/// The circle that lies nearest to some places, by least squares (Kasa 1976): its middle and its radius; none if they
/// lie on a line.
pub fn circle<U>(places: impl Iterator<Item = Point2D<f32, U>> + Clone) -> Option<(Point2D<f32, U>, f32)> {
    let count = places.clone().count() as f32;
    let mean = (places.clone().fold(Vector2D::zero(), |sum, at| sum + at.to_vector()) / count).to_point();
    let (mut xx, mut xy, mut yy, mut xz, mut yz, mut z) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for at in places {
        let from: Vector2D<f32, U> = at - mean;
        let square = from.square_length();
        xx += from.x * from.x;
        xy += from.x * from.y;
        yy += from.y * from.y;
        xz += from.x * square;
        yz += from.y * square;
        z += square;
    }
    let determinant = xx * yy - xy * xy;
    if determinant <= f32::EPSILON * (xx + yy) * (xx + yy) {
        return None;
    }
    let middle = Vector2D::new(xz * yy - yz * xy, yz * xx - xz * xy) / (2.0 * determinant);
    Some((mean + middle, (middle.square_length() + z / count).sqrt()))
}

/// Where two lines cross, each given by a point and its direction, as distances from those points in lengths of the
/// directions; none if the cross product of these is less than `least_sine`, as they are nearly parallel.
pub fn line_crossing<U>(
    a: (Point2D<f32, U>, Vector2D<f32, U>),
    b: (Point2D<f32, U>, Vector2D<f32, U>),
    least_sine: f32,
) -> Option<(f32, f32)> {
    let sine = a.1.cross(b.1);
    let between = b.0 - a.0;
    (sine.abs() >= least_sine).then(|| (between.cross(b.1) / sine, between.cross(a.1) / sine))
}

/// Where two segments cross, if they do, in a point inside both.
pub fn crossing<U>(
    (a, b): (Point2D<f32, U>, Point2D<f32, U>),
    (c, d): (Point2D<f32, U>, Point2D<f32, U>),
) -> Option<Point2D<f32, U>> {
    if !crosses((a, b), (c, d)) {
        return None;
    }
    let (ab, cd) = (b - a, d - c);
    Some(a + ab * ((c - a).cross(cd) / ab.cross(cd)).clamp(0.0, 1.0))
}

/// Whether two segments cross in a point inside both.
fn crosses<U>((a, b): (Point2D<f32, U>, Point2D<f32, U>), (c, d): (Point2D<f32, U>, Point2D<f32, U>)) -> bool {
    let side = |p: Point2D<f32, U>, q: Point2D<f32, U>, r: Point2D<f32, U>| (q - p).cross(r - p);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[cfg(test)]
mod tests;
