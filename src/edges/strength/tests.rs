//! Tests of `strength`.

use super::*;

#[test]
fn averages_keep_what_is_even_and_reach_less_far_near_free_ends() {
    for closed in [false, true] {
        assert_eq!(averaged(&[3.0; 7], closed, 2), [3.0; 7], "closed: {closed}");
    }
    let raw = [9.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(averaged(&raw, false, 1), [9.0, 3.0, 0.0, 0.0, 0.0, 0.0]);
    // round a ring the last value is beside the first
    assert_eq!(averaged(&raw, true, 1), [3.0, 3.0, 0.0, 0.0, 0.0, 3.0]);
    // however wide the window, a ring counts each value once
    assert_eq!(averaged(&[1.0, 2.0, 6.0], true, 100), [3.0; 3]);
}

#[test]
fn regions_weigh_as_a_geometric_mean() {
    let mean = |s: f32, b: f32| WITH_REGIONS * (s.powi(3) * b.powi(5)).powf(0.125);
    for (strength, height) in [(10.0, 10.0), (10.0, 40.0), (4.0, 90.0), (100.0, 26.0)] {
        let (found, expected) = (by_regions(strength, height), mean(strength, height));
        assert!((found / expected - 1.0).abs() < 1e-5, "{strength} and {height}: {found}, not {expected}");
    }
    // a wire, which separates no regions
    assert!((by_regions(10.0, 0.0) / mean(10.0, 2.5) - 1.0).abs() < 1e-5);
    assert!(by_regions(0.0, 0.0).abs() < 1e-6);
    // no overflow with the greatest heights that there are
    assert!(by_regions(300.0, 300.0).is_finite());
}
