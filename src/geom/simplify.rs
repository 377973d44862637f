//! Fewer points within a tolerance (Ramer 1972, Douglas & Peucker 1973).

use super::nearest_on_segment;
use lyon::geom::euclid::Point2D;

/// The indices of the points to keep so that no dropped point is farther than `tolerance` from the polyline that is left.
/// The first and the last point always stay. A closed polyline (first point = last point) is split at the point farthest
/// from its first, so that a ring does not collapse.
pub fn simplify<U>(points: &[Point2D<f32, U>], tolerance: f32) -> Vec<usize> {
    let n = points.len();
    if n <= 2 {
        return (0..n).collect();
    }
    let mut keep = vec![false; n];
    keep[0] = true;
    keep[n - 1] = true;
    let mut open = vec![(0, n - 1)];
    if points[0] == points[n - 1] {
        let far = farthest(points, 0, n - 1).0;
        keep[far] = true;
        open = vec![(0, far), (far, n - 1)];
    }
    while let Some((first, last)) = open.pop() {
        if last - first < 2 {
            continue;
        }
        let (far, distance) = farthest(points, first, last);
        if distance > tolerance {
            keep[far] = true;
            open.push((first, far));
            open.push((far, last));
        }
    }
    (0..n).filter(|&i| keep[i]).collect()
}

fn farthest<U>(points: &[Point2D<f32, U>], first: usize, last: usize) -> (usize, f32) {
    let mut best = (first + 1, -1.0);
    for i in first + 1..last {
        let distance = nearest_on_segment(points[i], points[first], points[last]).0;
        if distance > best.1 {
            best = (i, distance);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;
    use proptest::prelude::*;

    #[test]
    fn a_straight_run_needs_its_ends_only() {
        let points: Vec<MmPoint> = (0..50).map(|i| MmPoint::new(i as f32, 0.5 * i as f32)).collect();
        assert_eq!(simplify(&points, 0.01), [0, 49]);
    }

    #[test]
    fn a_ring_keeps_its_corners() {
        let at = |x: f32, y: f32| MmPoint::new(x, y);
        let ring = [at(0., 0.), at(1., 0.), at(2., 0.), at(2., 2.), at(1., 2.), at(0., 2.), at(0., 1.), at(0., 0.)];
        assert_eq!(simplify(&ring, 0.1), [0, 2, 3, 5, 7]);
    }

    proptest! {
        #[test]
        fn no_point_is_farther_than_the_tolerance(
            raw in prop::collection::vec((-50.0_f32..50.0, -50.0_f32..50.0), 2..60),
            tolerance in 0.01_f32..5.0,
        ) {
            let points: Vec<MmPoint> = raw.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
            let kept = simplify(&points, tolerance);
            for (i, &p) in points.iter().enumerate() {
                let at = kept.partition_point(|&k| k <= i).clamp(1, kept.len() - 1);
                let (a, b) = (points[kept[at - 1]], points[kept[at]]);
                prop_assert!(nearest_on_segment(p, a, b).0 <= tolerance + 1e-3);
            }
        }
    }
}
