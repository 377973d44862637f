//! The fewest points within a tolerance.
//!
//! Of all choices of dropping points that keep the rest within the tolerance, the one that keeps the fewest (Imai and
//! Iri 1988: a shortest path over the steps that are allowed). Which steps are allowed from a point is found by one
//! walk along the line with a wedge of directions that narrows as it goes (Williams 1978), so that the whole is linear
//! but for straight lines:
//!
//! ```text
//!            ___,o      every point passed narrows the wedge of directions
//!     ___,--o           that pass it within the tolerance; a step may end at a
//!    o---o---o---o      point inside the wedge, and the walk ends when the
//!     `--.____          wedge is empty
//! ```

use lyon::geom::euclid::{Point2D, Vector2D};

use super::polyline::PolylineRef;

/// The longest step, in points. Only straight lines reach it; they keep one point more for it.
const LOOK_AHEAD: usize = 512;

/// The indices of the vertices to keep: as few as can be so that the polyline through them and the one given are
/// nowhere farther from one another than `tolerance` (Hausdorff distance). The first vertex, and of an open polyline
/// the last, always stay; a ring keeps at least three, so that it does not collapse.
pub fn simplify<U>(polyline: PolylineRef<'_, Point2D<f32, U>>, tolerance: f32) -> Vec<usize> {
    if !polyline.closed {
        return along(polyline.vertices, tolerance, LOOK_AHEAD);
    }
    let path: Vec<_> = polyline.path().copied().collect();
    let mut kept = along(&path, tolerance, polyline.vertices.len().div_ceil(3).min(LOOK_AHEAD));
    kept.pop(); // the first vertex again
    kept
}

/// The indices of the points to keep of an open path, each step over at most `longest` points.
///
/// A point is not looked on from where no way by it can be better than one that is known (branch and bound): the fewest
/// steps that may be left are those over `longest` points each. Of a straight line that leaves next to nothing.
fn along<U>(points: &[Point2D<f32, U>], tolerance: f32, longest: usize) -> Vec<usize> {
    let n = points.len();
    if n <= 2 {
        return (0..n).collect();
    }
    // fewest[j]: steps from the first point to point j, the step before it, and how far those steps lie from the points
    let mut fewest = vec![(u32::MAX, 0, 0.0_f32); n];
    fewest[0] = (0, 0, 0.0);
    let most = greedy_steps(points, tolerance, longest);
    for i in 0..n - 1 {
        let (steps, _, off) = fewest[i];
        let in_all = steps.saturating_add((n - 1 - i).div_ceil(longest) as u32);
        let (known, _, known_off) = fewest[n - 1];
        if in_all > most || in_all > known || (in_all == known && off >= known_off) {
            continue;
        }
        each_step(points, i, tolerance, longest, |j, farthest| {
            let (least, _, least_off) = fewest[j];
            // of two ways with as few points the one that stays nearer
            let sum = off + farthest;
            if steps + 1 < least || (steps + 1 == least && sum < least_off) {
                fewest[j] = (steps + 1, i, sum);
            }
        });
    }
    let mut kept = vec![n - 1];
    while let Some(&last) = kept.last()
        && last > 0
    {
        kept.push(fewest[last].1);
    }
    kept.reverse();
    kept
}

/// How many steps there are if each goes as far as it can: hardly more than the fewest.
fn greedy_steps<U>(points: &[Point2D<f32, U>], tolerance: f32, longest: usize) -> u32 {
    let (mut at, mut steps) = (0, 0);
    while at + 1 < points.len() {
        let mut farthest = at + 1;
        each_step(points, at, tolerance, longest, |j, _| farthest = j);
        (at, steps) = (farthest, steps + 1);
    }
    steps
}

/// Calls `visit` with every point that one step from point `i` may lead to, and how far off the middle of the wedge it
/// is, 0..=1: a measure of how far the points passed lie beside the step.
fn each_step<U>(
    points: &[Point2D<f32, U>],
    i: usize,
    tolerance: f32,
    longest: usize,
    mut visit: impl FnMut(usize, f32),
) {
    let mut wedge: Option<[Vector2D<f32, U>; 2]> = None; // unit vectors along its two sides, by the sign of cross
    let mut reached = 0.0_f32; // farthest of the points passed
    let end = points.len().min(i + 1 + longest);
    let mut j = i + 1;
    while j < end {
        let views = Views::of(points[i], &points[j..end], tolerance);
        for k in 0..views.count {
            let (chord, distance) = (Vector2D::new(views.x[k], views.y[k]), views.distance[k]);
            let inside = wedge.is_none_or(|[low, high]| {
                low.cross(chord) >= 0.0 && chord.cross(high) >= 0.0 && (low + high).dot(chord) > 0.0
            });
            // A point that does not lie beyond all that were passed would leave those sticking out over its end.
            if j == i + 1 || (inside && distance >= reached) {
                let off = |[low, high]: [Vector2D<f32, U>; 2]| {
                    let (aside, open) = ((low + high).cross(chord).abs(), low.cross(high) * distance);
                    (aside / open.max(f32::MIN_POSITIVE)).min(1.0)
                };
                visit(j, wedge.map_or(0.0, off));
            }
            j += 1;
            reached = reached.max(distance);
            if distance <= tolerance {
                continue; // any direction passes it
            }
            let low = Vector2D::new(views.low_x[k], views.low_y[k]);
            let high = Vector2D::new(views.high_x[k], views.high_y[k]);
            wedge = Some(match wedge {
                None => [low, high],
                Some([old_low, old_high]) => {
                    if (old_low + old_high).dot(chord) <= 0.0 {
                        return; // it turns back
                    }
                    let low = if old_low.cross(low) > 0.0 { low } else { old_low };
                    let high = if high.cross(old_high) > 0.0 { high } else { old_high };
                    if low.cross(high) < 0.0 {
                        return;
                    }
                    [low, high]
                }
            });
        }
    }
}

/// So many points are seen from another at once, by the vectors of the processor.
const AT_ONCE: usize = 8;

/// Points as they are seen from another: the vectors to them, and the two sides of the wedge of directions that pass
/// each within the tolerance, as unit vectors.
#[derive(Default)]
struct Views {
    count: usize,
    x: [f32; AT_ONCE],
    y: [f32; AT_ONCE],
    distance: [f32; AT_ONCE],
    low_x: [f32; AT_ONCE],
    low_y: [f32; AT_ONCE],
    high_x: [f32; AT_ONCE],
    high_y: [f32; AT_ONCE],
}

impl Views {
    /// The first of these points as seen from this one.
    #[inline(always)]
    fn of<U>(from: Point2D<f32, U>, points: &[Point2D<f32, U>], tolerance: f32) -> Self {
        let mut views = Self { count: points.len().min(AT_ONCE), ..Self::default() };
        for (k, at) in points.iter().take(AT_ONCE).enumerate() {
            (views.x[k], views.y[k]) = (at.x - from.x, at.y - from.y);
        }
        for k in 0..AT_ONCE {
            let (x, y) = (views.x[k], views.y[k]);
            let distance = (x * x + y * y).sqrt();
            // where there is no point, or one within the tolerance, these are no numbers, and are not asked for
            let (sin, unit_x, unit_y) = (tolerance / distance, x / distance, y / distance);
            let cos = (1.0 - sin * sin).sqrt();
            let (along_x, along_y) = (unit_x * cos, unit_y * cos);
            let (aside_x, aside_y) = (-unit_y * sin, unit_x * sin);
            views.distance[k] = distance;
            (views.low_x[k], views.low_y[k]) = (along_x - aside_x, along_y - aside_y);
            (views.high_x[k], views.high_y[k]) = (along_x + aside_x, along_y + aside_y);
        }
        views
    }
}

#[cfg(test)]
mod tests;
