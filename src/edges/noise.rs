//! How noisy the picture is, so that noise is not drawn, and noisy edges are looked for at a scale that sees them.

use pulp::Arch;

use super::gradient::derivative;
use super::{Params, lab};
use crate::raster::Raster;
use crate::raster::plane::gauss;

/// Squares of this many pixels give one reading each: their median.
const TILE: usize = 8;
/// About so many of them are read, evenly about the middle of the picture, so that a picture turned or flipped reads the
/// same,
const READINGS: usize = 400;
/// ... at most this far apart, px.
const FARTHEST: usize = 48;
/// The reading that counts, as a share of all from the smoothest: where a picture has texture, the smooth parts tell its
/// noise.
const SMOOTHEST: f32 = 0.2;
/// That reading lies below the mean of the readings of pure noise: measured on flat pictures with noise of 2 to 20 of 255.
const BIAS: f32 = 1.12;
/// Median of the size of a normal number, in standard deviations.
const MEDIAN: f32 = 0.6745;

/// Noise of the colour axes beyond this (about 1.5 of 255 in every channel) and beyond that of lightness makes them count
/// less: counted in full, a camera's colour noise would drown every grey edge.
const COLOUR_NOISE: f32 = 2.0;
/// The scale is the noise times this, but at least 1 and at most this much: it grows from 2 units of noise (5 of 255) to 2.7.
/// A larger scale rounds corners and merges near edges, a smaller one breaks contours: measured on scenes with noise of 5
/// and 10 of 255 (2 and 4 units).
const GROWTH: f32 = 0.5;
const MOST_GROWTH: f32 = 1.35;
/// Thresholds are at least this many standard deviations of the step height that noise pretends. The highest of a million
/// such heights is about five.
const LOW: f32 = 2.0;
const HIGH: f32 = 4.5;
/// Contours are the longer, px for each unit that noise pretends beyond the first number: a short chain may be noise on a
/// slope. Photographs pretend 0.2 to 0.4.
const QUIET: f32 = 0.5;
const LENGTH: f32 = 25.0;

/// What is known of a picture's noise.
#[derive(Debug, Clone)]
pub(super) struct Noise {
    /// What each colour plane counts, 0..=1.
    pub(super) weights: Vec<f32>,
    /// Standard deviation of a pixel in the noisiest plane, in units of strength, after weighting.
    pub(super) pixel: f32,
    lightness: f32,
    total: f32,
}

impl Noise {
    pub(super) fn of(raster: &Raster) -> Self {
        let noise = estimate(raster);
        let lightness = noise.first().copied().unwrap_or(0.0);
        let most = lightness.max(COLOUR_NOISE);
        let weights: Vec<f32> = noise.iter().map(|&n| if n > most { most / n } else { 1.0 }).collect();
        let weighted = || noise.iter().zip(&weights).map(|(n, weight)| n * weight);
        let total = weighted().map(|n| n * n).sum::<f32>().sqrt();
        Self { pixel: weighted().fold(0.0, f32::max), weights, lightness, total }
    }

    /// Standard deviation of the step height that this noise pretends at scale `scale`.
    pub(super) fn pretended(&self, scale: f32) -> f32 {
        step(self.total, scale)
    }

    /// The parameters for this much noise.
    pub(super) fn adapted(&self, params: &Params) -> Params {
        let sigma = params.sigma * (GROWTH * self.lightness).clamp(1.0, MOST_GROWTH);
        let floor = step(self.total, sigma);
        Params {
            sigma,
            low: params.low.max(LOW * floor),
            high: params.high.max(HIGH * floor),
            min_length: params.min_length + LENGTH * (floor - QUIET).max(0.0),
            ..*params
        }
    }
}

/// Standard deviation of the noise of a pixel in each plane of [`lab`], in units of strength.
///
/// The measure is Immerkaer's (1996): the second difference along x of the second difference along y, which is blind to
/// plain slopes and straight edges along the axes; in place of its mean over the picture, the median over small squares and
/// a low quantile of these.
fn estimate(raster: &Raster) -> Vec<f32> {
    const SIDE: usize = TILE + 2;
    let planes = lab::planes(raster);
    let (width, height) = (raster.size().width as usize, raster.size().height as usize);
    let every = (((width * height / READINGS) as f32).sqrt() as usize).clamp(TILE, FARTHEST);
    let starts = |pixels: usize| {
        let count = (pixels.saturating_sub(SIDE) / every) + usize::from(pixels >= SIDE);
        let first = pixels.saturating_sub(SIDE + every * count.saturating_sub(1)) / 2;
        (0..count).map(move |k| first + k * every)
    };
    let mut readings = vec![Vec::new(); planes];
    let arch = Arch::new();
    let mut square = vec![vec![0.0_f32; SIDE * SIDE]; planes];
    let mut lab = square.clone();
    let mut sizes = [0.0_f32; TILE * TILE];
    for top in starts(height) {
        for left in starts(width) {
            for (plane, square) in raster.planes().iter().zip(&mut square) {
                for (y, row) in square.chunks_exact_mut(SIDE).enumerate() {
                    row.copy_from_slice(&plane[(top + y) * width + left..][..SIDE]);
                }
            }
            let from: Vec<&[f32]> = square.iter().map(Vec::as_slice).collect();
            lab::convert(arch, &from, &mut lab);
            for (plane, readings) in lab.iter().zip(&mut readings) {
                let at = |x: usize, y: usize| plane[y * SIDE + x];
                let down = |x: usize, y: usize| (at(x, y) + at(x, y + 2)) - 2.0 * at(x, y + 1);
                for (i, size) in sizes.iter_mut().enumerate() {
                    let (x, y) = (i % TILE, i / TILE);
                    *size = ((down(x, y) + down(x + 2, y)) - 2.0 * down(x + 1, y)).abs();
                }
                let (_, median, _) = sizes.select_nth_unstable_by(TILE * TILE / 2, f32::total_cmp);
                readings.push(*median / (6.0 * MEDIAN)); // the weights' squares sum to 36
            }
        }
    }
    readings
        .into_iter()
        .map(|mut readings| {
            let place = (SMOOTHEST * readings.len() as f32) as usize;
            if place < readings.len() { BIAS * *readings.select_nth_unstable_by(place, f32::total_cmp).1 } else { 0.0 }
        })
        .collect()
}

/// Standard deviation of the step height that noise of standard deviation `noise` per pixel pretends at scale `scale`.
fn step(noise: f32, scale: f32) -> f32 {
    let smooth = gauss(scale);
    let square = |half: &[f32]| half[0] * half[0] + 2.0 * half[1..].iter().map(|weight| weight * weight).sum::<f32>();
    let gradient = (square(&smooth) * square(&derivative(&smooth))).sqrt();
    std::f32::consts::TAU.sqrt() * scale * gradient * noise
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Size;

    /// White noise of standard deviation `n` code values of 255 on a grey; equal in all channels or not.
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
    fn noise_of_single_channels_takes_weight_from_the_colour_axes() {
        let noise = Noise::of(&noisy(10.0, false));
        assert!((noise.weights[0] - 1.0).abs() < 1e-6 && noise.weights[1] < 0.4 && noise.weights[2] < 0.4, "{noise:?}");
        // the luminance of three such channels has 0.74 of the noise of one
        assert!((noise.lightness - 0.74 * 10.0 / 2.55).abs() < 0.4 && noise.pixel < 10.0 / 2.55, "{noise:?}");
    }

    #[test]
    fn without_noise_nothing_changes() {
        let params = Params::default();
        let flat = Raster::grey(Size::new(200, 200), vec![0.3; 40_000]);
        assert_eq!(Noise::of(&flat).adapted(&params), params);
    }
}
