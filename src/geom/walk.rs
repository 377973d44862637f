//! Going along polylines: vertex by vertex with the length gone, in a direction, and run by run.

use lyon::geom::euclid::{Point2D, Vector2D};

use super::polyline::{Located, Polyline};

impl<V: Located> Polyline<V> {
    /// The vertices from `i` on, forwards or backwards, each with its arc length from `i`; around a ring once.
    pub fn walk(&self, i: usize, forwards: bool) -> impl Iterator<Item = (usize, f32)> {
        let mut arc = 0.0;
        let mut here = i;
        (0..self.vertices.len() as isize).map_while(move |step| {
            let to = self.view().next(i, if forwards { step } else { -step })?;
            arc += (self.vertices[to].at() - self.vertices[here].at()).length();
            here = to;
            Some((to, arc))
        })
    }

    /// The unit direction in which the polyline leaves vertex `i`, forwards or backwards: from its first vertex at
    /// least `near` away, along itself, to its first at least `far` away. What lies nearer may be bent. None where it
    /// ends before that. Lengths are those along the polyline; [`first_beyond`] takes straight ones.
    pub fn heading(&self, i: usize, forwards: bool, [near, far]: [f32; 2]) -> Option<Vector2D<f32, V::Unit>> {
        let first_at = |least: f32| self.walk(i, forwards).find(|(_, arc)| *arc >= least);
        let [from, to] = [first_at(near)?, first_at(far)?].map(|(vertex, _)| self.vertices[vertex].at());
        (to - from).try_normalize()
    }
}

/// The first of some points that is at least `far` from `from`, or the last of them; none of none.
pub fn first_beyond<U>(
    points: impl Iterator<Item = Point2D<f32, U>>,
    from: Point2D<f32, U>,
    far: f32,
) -> Option<Point2D<f32, U>> {
    let mut last = None;
    for at in points {
        last = Some(at);
        if (at - from).length() >= far {
            break;
        }
    }
    last
}

/// The unit direction in which a line ends whose points from the end inwards these are: from the first that is at least
/// `far` from the end, or the last of them.
pub fn heading_of_end<U>(mut points: impl Iterator<Item = Point2D<f32, U>>, far: f32) -> Option<Vector2D<f32, U>> {
    let tip = points.next()?;
    (tip - first_beyond(points, tip, far)?).try_normalize()
}

/// Length along a line between two places, given as lengths from its beginning; of a ring, which is so long
/// (`ring_length`), the shorter way round.
pub fn arc_between(s: f32, t: f32, ring_length: Option<f32>) -> f32 {
    let apart = (s - t).abs();
    ring_length.map_or(apart, |ring_length| apart.min(ring_length - apart))
}

/// The first number from 1 on that is unlike the one before it, of so many round a ring; none if all are alike.
fn first_change(count: usize, is_alike: &impl Fn(usize, usize) -> bool) -> Option<usize> {
    (1..count).find(|&i| !is_alike(i - 1, i))
}

/// Numbers up to `count`, as those of the vertices of a polyline, in order; of a ring from a change on, so that nothing
/// that belongs together lies on both sides of its seam, and the result does not depend on where the ring begins.
pub fn in_order(count: usize, closed: bool, is_alike: impl Fn(usize, usize) -> bool) -> Vec<usize> {
    let start = if closed { first_change(count, &is_alike).unwrap_or(0) } else { 0 };
    (start..count).chain(0..start).collect()
}

/// Numbers up to `count` in runs of such as are alike, each with the next. See [`in_order`].
pub fn runs(count: usize, closed: bool, is_alike: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let order = in_order(count, closed, &is_alike);
    order.chunk_by(|&a, &b| is_alike(a, b)).map(<[usize]>::to_vec).collect()
}

#[cfg(test)]
mod tests;
