//! Noise of the picture: thresholds and scale are adapted to it, so that noise is not drawn and noisy edges are found.

use pulp::Arch;

use super::gradient::derivative;
use super::params::Params;
use crate::raster::Raster;
use crate::raster::lab;
use crate::raster::plane::gauss;

/// Side of the tiles, px. Each tile gives one sample: the median of its values.
const TILE: usize = 8;
/// Approximate number of samples, spread evenly about the centre of the picture, so that a turned or flipped picture
/// gives the same samples.
const SAMPLES: usize = 400;
/// Greatest distance between samples, px.
const MAX_SPACING: usize = 48;
/// The quantile of the samples that is used. Where a picture has texture, only its smooth parts show its noise.
const QUANTILE: f32 = 0.2;
/// That quantile lies below the mean of the samples of pure noise by this factor: measured on flat pictures with noise
/// of 2 to 20 of 255.
const BIAS: f32 = 1.12;
/// Median absolute value of a normal distribution, in standard deviations.
const MEDIAN: f32 = 0.6745;

/// A colour axis gets a lower weight if its noise is greater than this (about 1.5 of 255 in every channel) and greater
/// than that of lightness. With full weight, a camera's colour noise would drown every grey edge.
const MAX_COLOUR_NOISE: f32 = 2.0;
/// The scale is multiplied with the noise times this factor, but at least by 1 and at most by `MAX_SCALE_GROWTH`: it
/// grows between 2 units of noise (5 of 255) and 2.7. A larger scale rounds corners and merges near edges, a smaller
/// one breaks contours: measured on scenes with noise of 5 and 10 of 255 (2 and 4 units).
const SCALE_GROWTH: f32 = 0.5;
const MAX_SCALE_GROWTH: f32 = 1.35;
/// The thresholds are at least this many standard deviations of the step heights that noise causes. The greatest of a
/// million such heights is about five.
const MIN_LOW: f32 = 2.0;
const MIN_HIGH: f32 = 4.5;
/// The least length of a contour grows by `EXTRA_LENGTH` px for each unit of the standard deviation of step heights
/// beyond `QUIET`: a short chain may be noise on a slope. For photographs this deviation is 0.2 to 0.4.
const QUIET: f32 = 0.5;
const EXTRA_LENGTH: f32 = 25.0;

/// The estimated noise of a picture.
#[derive(Debug, Clone)]
pub(super) struct Noise {
    /// Weight of each colour plane, 0..=1.
    pub(super) weights: Vec<f32>,
    /// Standard deviation of a pixel in the noisiest plane after weighting, in units of strength.
    pub(super) pixel: f32,
    /// Standard deviation of a pixel in lightness.
    pub(super) lightness: f32,
    /// Standard deviation of a pixel in all planes together, after weighting.
    total: f32,
}

impl Noise {
    pub(super) fn of(raster: &Raster) -> Self {
        let noise = estimate(raster);
        let lightness = noise.first().copied().unwrap_or(0.0);
        let most = lightness.max(MAX_COLOUR_NOISE);
        let weights: Vec<f32> = noise.iter().map(|&n| if n > most { most / n } else { 1.0 }).collect();
        let weighted = || noise.iter().zip(&weights).map(|(n, weight)| n * weight);
        let total = weighted().map(|n| n * n).sum::<f32>().sqrt();
        Self { pixel: weighted().fold(0.0, f32::max), weights, lightness, total }
    }

    /// Standard deviation of the step heights that this noise causes at the scale `sigma`.
    pub(super) fn height_sigma(&self, sigma: f32) -> f32 {
        height_sigma(self.total, sigma)
    }

    /// The parameters adapted to this noise.
    pub(super) fn adapted(&self, params: &Params) -> Params {
        let sigma = params.sigma * (SCALE_GROWTH * self.lightness).clamp(1.0, MAX_SCALE_GROWTH);
        let floor = self.height_sigma(sigma);
        Params {
            sigma,
            low: params.low.max(MIN_LOW * floor),
            high: params.high.max(MIN_HIGH * floor),
            min_length: params.min_length + EXTRA_LENGTH * (floor - QUIET).max(0.0),
            ..*params
        }
    }
}

/// Side of a tile with the border that the second differences need, px.
const SIDE: usize = TILE + 2;

/// Standard deviation of the noise of a pixel in each plane of [`lab`], in units of strength.
///
/// The measure is that of Immerkaer (1996): the second difference along x of the second difference along y, which is 0
/// on even slopes and straight edges along the axes. In place of its mean over the picture, the median over small
/// tiles and a low quantile of these medians are used.
fn estimate(raster: &Raster) -> Vec<f32> {
    let planes = lab::planes(raster);
    let (width, height) = (raster.size().width as usize, raster.size().height as usize);
    let spacing = (((width * height / SAMPLES) as f32).sqrt() as usize).clamp(TILE, MAX_SPACING);
    let arch = Arch::new();
    let mut samples = vec![Vec::new(); planes];
    let mut tile = vec![vec![0.0_f32; SIDE * SIDE]; planes];
    let mut lab = tile.clone();
    for top in tile_starts(height, spacing) {
        for left in tile_starts(width, spacing) {
            for (plane, tile) in raster.planes().iter().zip(&mut tile) {
                for (y, row) in tile.chunks_exact_mut(SIDE).enumerate() {
                    row.copy_from_slice(&plane[(top + y) * width + left..][..SIDE]);
                }
            }
            let from: Vec<&[f32]> = tile.iter().map(Vec::as_slice).collect();
            lab::convert(arch, &from, &mut lab);
            samples.iter_mut().zip(&lab).for_each(|(samples, plane)| samples.push(tile_noise(plane)));
        }
    }
    samples.iter_mut().map(|samples| low_quantile(samples)).collect()
}

/// Where tiles begin along an axis of `pixels` pixels: evenly about its middle.
fn tile_starts(pixels: usize, spacing: usize) -> impl Iterator<Item = usize> {
    let count = (pixels.saturating_sub(SIDE) / spacing) + usize::from(pixels >= SIDE);
    let first = pixels.saturating_sub(SIDE + spacing * count.saturating_sub(1)) / 2;
    (0..count).map(move |k| first + k * spacing)
}

/// The standard deviation of the noise in a tile of `SIDE` x `SIDE` values, by the median of its second differences.
fn tile_noise(plane: &[f32]) -> f32 {
    let at = |x: usize, y: usize| plane[y * SIDE + x];
    let down = |x: usize, y: usize| (at(x, y) + at(x, y + 2)) - 2.0 * at(x, y + 1);
    let mut differences: [f32; TILE * TILE] = std::array::from_fn(|i| {
        let (x, y) = (i % TILE, i / TILE);
        ((down(x, y) + down(x + 2, y)) - 2.0 * down(x + 1, y)).abs()
    });
    let (_, median, _) = differences.select_nth_unstable_by(TILE * TILE / 2, f32::total_cmp);
    *median / (6.0 * MEDIAN) // the squares of the weights sum to 36
}

/// The noise by the low quantile of the samples; 0 without samples.
fn low_quantile(samples: &mut [f32]) -> f32 {
    let index = (QUANTILE * samples.len() as f32) as usize;
    if index < samples.len() { BIAS * *samples.select_nth_unstable_by(index, f32::total_cmp).1 } else { 0.0 }
}

/// Standard deviation of the step heights that noise of standard deviation `noise` per pixel causes at the scale
/// `sigma`.
fn height_sigma(noise: f32, sigma: f32) -> f32 {
    let smooth = gauss(sigma);
    let square = |half: &[f32]| half[0] * half[0] + 2.0 * half[1..].iter().map(|weight| weight * weight).sum::<f32>();
    let gradient = (square(&smooth) * square(&derivative(&smooth))).sqrt();
    std::f32::consts::TAU.sqrt() * sigma * gradient * noise
}

#[cfg(test)]
mod tests;
