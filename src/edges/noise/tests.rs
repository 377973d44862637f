//! Tests of `noise`.

use super::*;
use crate::units::Size;

/// A grey with white noise of standard deviation `n` (code values of 255), the same in all channels or not.
fn noisy(n: f32, equal: bool) -> Raster {
    let size = Size::new(256, 256);
    let mut state = 1_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1_u64 << 24) as f32
    };
    let mut plane = || -> Vec<f32> {
        let mut normal = || (0..12).map(|_| uniform()).sum::<f32>() - 6.0;
        (0..size.len()).map(|_| ((0.5 + n / 255.0 * normal() + 0.055) / 1.055).powf(2.4)).collect()
    };
    let first = plane();
    if equal {
        Raster::colour(size, [first.clone(), first.clone(), first])
    } else {
        Raster::colour(size, [first, plane(), plane()])
    }
}

#[test]
fn white_noise_is_measured_within_a_tenth() {
    for n in [2.0, 5.0, 10.0, 20.0] {
        let (found, want) = (estimate(&noisy(n, true))[0], n / 2.55);
        assert!((found - want).abs() < 0.1 * want, "{found} is not {want}");
    }
}

#[test]
fn noise_of_single_channels_lowers_the_weight_of_the_colour_axes() {
    let noise = Noise::of(&noisy(10.0, false));
    assert!((noise.weights[0] - 1.0).abs() < 1e-6 && noise.weights[1] < 0.4 && noise.weights[2] < 0.4, "{noise:?}");
    // the luminance of three such channels has 0.74 of the noise of one
    assert!((noise.lightness - 0.74 * 10.0 / 2.55).abs() < 0.4 && noise.pixel < 10.0 / 2.55, "{noise:?}");
}

#[test]
fn without_noise_the_parameters_stay() {
    let params = Params::default();
    let flat = Raster::grey(Size::new(200, 200), vec![0.3; 40_000]);
    assert_eq!(Noise::of(&flat).adapted(&params), params);
}

#[test]
fn stripes_are_no_noise() {
    let size = Size::new(200, 200);
    let level = |i: usize| 0.2 + 0.1 * ((i * i) % 7) as f32;
    let upright = Raster::grey(size, (0..size.len()).map(|i| level(i % 200)).collect());
    let level_ones = Raster::grey(size, (0..size.len()).map(|i| level(i / 200)).collect());
    for stripes in [upright, level_ones] {
        assert!(estimate(&stripes)[0] < 1e-3, "{:?}", estimate(&stripes));
    }
}
