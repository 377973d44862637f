//! Tests of `refine`.

use super::super::contour::testing::{circle, polyline};
use super::*;

const SIGMA: f32 = 1.5;

/// Random numbers in -1..=1.
fn noise() -> impl Iterator<Item = f32> {
    let next = |state: &u64| state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let states = std::iter::successors(Some(1_u64), move |state| Some(next(state)));
    states.skip(1).map(|state| (state >> 40) as f32 / (1_u64 << 23) as f32 - 1.0)
}

/// Root mean square of distances.
fn rms(distances: impl Iterator<Item = f32>) -> f32 {
    let (sum, count) = distances.fold((0.0, 0.0), |(sum, count), d| (sum + d * d, count + 1.0));
    f32::sqrt(sum / count)
}

#[test]
fn noise_is_smoothed_out_along_a_straight_line() {
    let mut line = polyline(&[(0.0, 10.0), (60.0, 10.0)]);
    for (point, noise) in line.vertices.iter_mut().zip(noise()) {
        (point.at.y, point.position_sigma) = (10.0 + 0.2 * noise, 0.12);
    }
    let before = rms(line.vertices.iter().map(|point| point.at.y - 10.0));
    refine(&mut line, SIGMA);
    let after = rms(line.vertices.iter().map(|point| point.at.y - 10.0));
    assert!(before > 0.1 && after < 0.4 * before, "{before} px before, {after} after");
}

#[test]
fn a_circle_gets_back_the_radius_that_blur_took() {
    for radius in [8.0_f32, 15.0, 30.0] {
        let blur = 1.5_f32;
        let mut found = circle(radius - blur * blur / (2.0 * radius));
        refine(&mut found, SIGMA);
        let radii = found.vertices.iter().map(|point| (point.at - PxPoint::new(50.0, 50.0)).length());
        let error = rms(radii.map(|found| found - radius));
        assert!(error < 0.02, "radius {radius}: off by {error} px, where blur took {}", 1.125 / radius);
    }
}

#[test]
fn a_corner_and_short_contours_stay() {
    let mut corner = polyline(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0)]);
    let before = corner.clone();
    refine(&mut corner, SIGMA);
    let moved = corner.vertices.iter().zip(&before.vertices).map(|(a, b)| (a.at - b.at).length());
    let moved: Vec<f32> = moved.collect();
    assert!(moved[..15].iter().chain(&moved[26..]).all(|&d| d < 1e-3), "{moved:?}");
    assert!(moved.iter().all(|&d| d < 0.6), "{moved:?}");
    let mut short = polyline(&[(0.0, 0.0), (3.0, 0.0)]);
    short.vertices[1].at.y = 0.5;
    let same = short.clone();
    refine(&mut short, SIGMA);
    assert_eq!(short, same);
}

#[test]
fn a_parabola_is_found_from_its_sums() {
    let places = [-2.0, -1.0, 0.5, 1.0, 3.0, 4.0_f64];
    let value = |s: f64| 2.0 - 3.0 * s + 0.5 * s * s;
    let moments = std::array::from_fn(|k| places.iter().map(|s| s.powi(k as i32)).sum());
    let sums = std::array::from_fn(|k| places.iter().map(|&s| s.powi(k as i32) * value(s)).sum());
    let found = parabola(&moments, &sums).expect("six places");
    assert!(found.iter().zip([2.0, -3.0, 0.5]).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
    assert_eq!(parabola(&[1.0, 2.0, 4.0, 8.0, 16.0], &[1.0, 2.0, 4.0]), None, "one place");
}
