//! Tests of `simplify`.

use super::*;
use crate::geom::nearest_on_segment;
use crate::units::MmPoint;
use proptest::prelude::*;

fn open(points: &[MmPoint]) -> PolylineRef<'_, MmPoint> {
    PolylineRef { vertices: points, closed: false }
}

fn ring(points: &[MmPoint]) -> PolylineRef<'_, MmPoint> {
    PolylineRef { vertices: points, closed: true }
}

#[test]
fn a_straight_run_needs_its_ends_only() {
    let points: Vec<MmPoint> = (0..50).map(|i| MmPoint::new(i as f32, 0.5 * i as f32)).collect();
    assert_eq!(simplify(open(&points), 0.01), [0, 49]);
}

#[test]
fn a_ring_keeps_its_corners() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let square = [at(0., 0.), at(1., 0.), at(2., 0.), at(2., 2.), at(1., 2.), at(0., 2.), at(0., 1.)];
    assert_eq!(simplify(ring(&square), 0.1), [0, 2, 3, 5]);
}

#[test]
fn a_small_ring_does_not_collapse() {
    let circle: Vec<MmPoint> = (0..12)
        .map(|i| i as f32 * std::f32::consts::TAU / 12.0)
        .map(|a| MmPoint::new(0.01 * a.cos(), 0.01 * a.sin()))
        .collect();
    assert!(simplify(ring(&circle), 0.05).len() >= 3);
}

/// Douglas and Peucker's way keeps more: the circle's arcs start at points of its choosing.
#[test]
fn an_arc_has_as_few_points_as_its_curvature_asks_for() {
    let arc: Vec<MmPoint> =
        (0..=400).map(|i| i as f32 * 0.02).map(|a| MmPoint::new(20.0 * a.cos(), 20.0 * a.sin())).collect();
    // a chord over the angle b lies 20 (1 - cos(b / 2)) from its arc
    let widest = 2.0 * (1.0_f32 - 0.05 / 20.0).acos();
    assert!(simplify(open(&arc), 0.05).len() as f32 <= (8.0 / widest).ceil() * 1.15 + 1.0);
}

/// How far the points of `from`, and those between them, lie from the polyline `to`.
fn distance(from: &[MmPoint], to: &[MmPoint]) -> f32 {
    let between = from.windows(2).flat_map(|pair| (0..=20).map(|k| pair[0].lerp(pair[1], k as f32 / 20.0)));
    let nearest = |p| to.windows(2).map(|s| nearest_on_segment(p, s[0], s[1]).0).fold(f32::MAX, f32::min);
    between.map(nearest).fold(0.0, f32::max)
}

proptest! {
    #[test]
    fn neither_line_is_farther_from_the_other_than_the_tolerance(
        raw in prop::collection::vec((-50.0_f32..50.0, -50.0_f32..50.0), 2..60),
        tolerance in 0.01_f32..5.0,
    ) {
        let points: Vec<MmPoint> = raw.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        let kept: Vec<MmPoint> = simplify(open(&points), tolerance).into_iter().map(|i| points[i]).collect();
        prop_assert!(distance(&points, &kept) <= tolerance + 2e-3);
        prop_assert!(distance(&kept, &points) <= tolerance + 2e-3);
    }

    #[test]
    fn a_simplified_ring_stays_a_ring_within_the_tolerance(
        radii in prop::collection::vec(2.0_f32..9.0, 3..80),
        tolerance in 0.01_f32..2.0,
    ) {
        let angle = |i: usize| i as f32 * std::f32::consts::TAU / radii.len() as f32;
        let at = |(i, r): (usize, &f32)| MmPoint::new(r * angle(i).cos(), r * angle(i).sin());
        let points: Vec<MmPoint> = radii.iter().enumerate().map(at).collect();
        let indices = simplify(ring(&points), tolerance);
        prop_assert!(indices.len() >= 3 && indices[0] == 0 && indices.is_sorted());
        let kept: Vec<MmPoint> = indices.into_iter().map(|i| points[i]).collect();
        let [whole, simple] = [&points, &kept].map(|points| ring(points).path().copied().collect::<Vec<_>>());
        prop_assert!(distance(&whole, &simple) <= tolerance + 2e-3);
        prop_assert!(distance(&simple, &whole) <= tolerance + 2e-3);
    }

    #[test]
    fn a_wandering_line_keeps_its_distance_and_its_ends(
        turns in prop::collection::vec(-0.6_f32..0.6, 3..300),
        tolerance in 0.02_f32..0.2,
    ) {
        let mut points = vec![MmPoint::zero()];
        let mut heading = 0.0_f32;
        for turn in turns {
            heading += turn;
            let last = points[points.len() - 1];
            points.push(MmPoint::new(last.x + 0.4 * heading.cos(), last.y + 0.4 * heading.sin()));
        }
        let indices = simplify(open(&points), tolerance);
        prop_assert_eq!((indices[0], indices[indices.len() - 1]), (0, points.len() - 1));
        let kept: Vec<MmPoint> = indices.into_iter().map(|i| points[i]).collect();
        prop_assert!(distance(&points, &kept) <= tolerance + 1e-3);
        prop_assert!(distance(&kept, &points) <= tolerance + 1e-3);
    }
}
