//! Tests of `spacing`.

use super::*;
use crate::geom::polyline::Polyline;

#[test]
fn steps_are_even_and_ends_have_dots() {
    for (length, pitch, want) in [(25.0, 2.5, 11), (26.0, 2.5, 11), (24.0, 2.5, 11), (3.0, 2.5, 2), (1.0, 2.5, 1)] {
        let points =
            [MmPoint::new(10.0, 10.0), MmPoint::new(10.0 + 0.4 * length, 10.0), MmPoint::new(10.0 + length, 10.0)];
        let dots = evenly(PolylineRef { vertices: &points, closed: false }, pitch);
        assert_eq!(dots.len(), want, "{length} mm");
        assert!(dots.windows(2).all(|pair| ((pair[1] - pair[0]).length() - length / (want as f32 - 1.0)).abs() < 1e-3));
        assert!((dots[0] - points[0]).length() < 1e-4);
        assert!(want == 1 || (dots[want - 1] - points[2]).length() < 1e-4);
    }
}

#[test]
fn a_closed_line_has_no_seam() {
    let angle = |i: i32| (i % 90) as f32 * std::f32::consts::TAU / 90.0;
    let ring: Vec<MmPoint> =
        (0..=90).map(|i| MmPoint::new(50.0 + 20.0 * angle(i).cos(), 50.0 + 20.0 * angle(i).sin())).collect();
    let dots = evenly(Polyline::from_path(ring).view(), 2.5);
    assert_eq!(dots.len(), 50);
    for i in 0..dots.len() {
        let step = (dots[(i + 1) % dots.len()] - dots[i]).length();
        assert!((step - 2.51).abs() < 0.01, "step {i} is {step} mm");
    }
}
