//! Tests of `ridge`.

use super::*;

/// The profile of a step of height 40 and blur 2 on a slope of `slope` per pixel, read 4.5 pixels from the edge.
fn profile(slope: f32) -> EdgeProfile {
    let maximum = 40.0 / (std::f32::consts::TAU.sqrt() * 2.0);
    let beyond = maximum * (-0.5 * (4.5_f32 / 2.0).powi(2)).exp();
    let total = maximum + slope;
    EdgeProfile { maximum: total, curvature: 0.25, pedestal: [(beyond + slope) / total; 2], distance: 4.5 }
}

#[test]
fn the_height_of_a_step_on_flat_ground_is_measured_and_on_a_steep_slope_it_shrinks() {
    let flat = profile(0.0).height(1.5);
    assert!((flat - 40.0).abs() < 0.1, "{flat} on flat ground");
    let [gentle, steep] = [2.0, 40.0].map(|slope| profile(slope).height(1.5) / profile(slope).maximum);
    assert!(steep < 0.3 * gentle, "{steep} and {gentle} of the maximum are above the pedestal");
}

#[test]
fn a_step_much_wider_than_the_scale_is_shading() {
    let wide = EdgeProfile { curvature: (1.6_f32 * MAX_BLUR * 1.5).powi(-2), ..profile(0.0) };
    assert!(wide.height(1.5) < 1e-6, "{}", wide.height(1.5));
}
