//! Tests of `step_height`.

use super::*;
use crate::units::{PxPoint, PxVector};

const SIGMA: f32 = 1.5;

fn profile(curvature: f32) -> EdgeProfile {
    EdgeProfile { maximum: 8.0, curvature, pedestal: [0.05, 0.1], distance: 4.5 }
}

/// Points of an upright edge, each with its curvature, in a chain from the top down.
fn averaged_over(curvatures: &[f32], closed: bool, window: usize) -> Vec<f32> {
    let point = |(row, &curvature): (u32, &f32)| RidgePoint {
        at: PxPoint::new(10.0, row as f32),
        normal: PxVector::new(1.0, 0.0),
        profile: profile(curvature),
        height: 0.0,
        blur: 0.0,
        column: 10,
        row,
    };
    let mut points: Vec<RidgePoint> = (0..).zip(curvatures).map(point).collect();
    let chain = Chain { vertices: (0..points.len() as u32).collect(), closed };
    average(&mut points, &[chain], window, SIGMA);
    points.iter().map(|point| point.height).collect()
}

fn height(curvature: f32) -> f32 {
    profile(curvature).height(SIGMA)
}

#[test]
fn where_all_points_are_alike_each_keeps_its_height() {
    for closed in [false, true] {
        let heights = averaged_over(&[0.25; 9], closed, 3);
        assert!(heights.iter().all(|found| (found - height(0.25)).abs() < 1e-3), "{heights:?}");
    }
}

#[test]
fn curvature_is_the_mean_over_the_window_and_at_ends_over_what_there_is_of_it() {
    let heights = averaged_over(&[0.2, 0.2, 0.2, 0.32, 0.2, 0.2], false, 1);
    let expected = [0.2, 0.2, 0.24, 0.24, 0.24, 0.2].map(height);
    assert!(heights.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{heights:?}, not {expected:?}");
    // a ring has no ends
    let ring = averaged_over(&[0.32, 0.2, 0.2, 0.2, 0.2, 0.2], true, 1);
    let expected = [0.24, 0.24, 0.2, 0.2, 0.2, 0.24].map(height);
    assert!(ring.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{ring:?}, not {expected:?}");
}
