//! Tests of `maxima`.

use super::*;

#[test]
fn a_gaussian_profile_gives_its_own_position_and_height() {
    for shift in [-0.5_f32, -0.3, 0.0, 0.2, 0.49] {
        for blur in [1.5_f32, 2.0, 3.0] {
            let g = |x: f32| 40.0 / (std::f32::consts::TAU.sqrt() * blur) * (-0.5 * ((x - shift) / blur).powi(2)).exp();
            let (offset, maximum, curvature) = interpolate(g(-1.0), g(0.0), g(1.0)).unwrap();
            let pedestal = [g(shift + 4.5) / maximum; 2];
            let height = EdgeProfile { maximum, curvature, pedestal, distance: 4.5 }.height(1.5);
            assert!((offset - shift).abs() < 1e-3, "{offset} is not {shift}");
            assert!((height - 40.0).abs() < 0.1, "{height} at blur {blur}");
        }
    }
}

#[test]
fn the_logarithm_is_as_exact_as_documented() {
    for i in 1..=100_000 {
        let x = i as f32 / 50_000.0;
        assert!((f64::from(ln(x)) - f64::from(x).ln()).abs() < 1e-6, "{x}: {}", ln(x));
    }
}
