//! Tests of `params`.

use super::*;

#[test]
fn distances_follow_from_gap_and_widths() {
    let params = Params::TEST;
    assert!((params.max_spacing() - 4.7).abs() < 1e-6 && (params.max_offset() - 2.35).abs() < 1e-6);
    // two lines that are drawn a tolerance nearer each still keep the gap
    assert!(params.clearance(1.0) - 2.0 * params.tolerance >= params.min_gap + 1.0);
    assert!(params.max_clearance() >= params.clearance(0.5 * (params.width_min + params.width_max)));
    // whatever is let through at the least width is let through at any
    assert!(params.min_approach() < params.approach(0.5 * params.width_min, 0.5 * params.width_min));
    assert!(params.approach(0.75, 0.75) < params.max_stub());
    assert!(params.is_dot(14.0) && !params.is_dot(15.0));
}
