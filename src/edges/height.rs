//! How high the colour step is, however soft, and whatever slope it stands on.
//!
//! The gradient across a step of height `D` and blur `t` is the bump `D / (sqrt(tau) t) exp(-x^2 / 2 t^2)`: its top and its
//! sharpness `1 / t^2` give the height. Under the bump may lie a pedestal, the slope of a shaded surface; only what
//! stands above it is the step. Shading has no contours: where the colour goes on changing on both sides as it does on the
//! "edge", nothing is left.
//!
//! A single reading of sharpness and pedestal is as noisy as the point itself, so both are averaged along the chain. Of the
//! two sides the lower pedestal counts, as on the other there may be an edge of its own.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::chain::Chain;
use super::thin::Ridge;
use crate::units::PxVector;

/// The widest edge whose height is measured, in scales: a step blurred more than this counts as shading, the less the
/// wider, and nothing from one and a half times this on.
pub(super) const WIDEST: f32 = 2.5;
/// A pedestal up to this share of the top is let pass: noise alone has it.
const FREE: f32 = 0.1;

/// What is read across an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Profile {
    /// The greatest gradient, per pixel.
    pub(super) top: f32,
    /// `1 / t^2` for the blur `t`, which has the scale of the derivative in it, px^-2.
    pub(super) sharpness: f32,
    /// The gradient beyond the edge, to the left of it or above, and to the right or below, as a share of
    /// that at the pixel of the edge.
    pub(super) beyond: [f32; 2],
    /// How far from the edge these were read, px.
    pub(super) distance: f32,
}

impl Profile {
    /// Blur, px, at least that of the derivative itself and at most the widest that is measured.
    pub(super) fn blur(&self, scale: f32) -> f32 {
        self.sharpness.max(1e-6).sqrt().recip().clamp(scale, WIDEST * scale)
    }

    /// Height of the step, in units of strength.
    pub(super) fn step(&self, scale: f32) -> f32 {
        let wide = self.sharpness.max(1e-6).sqrt().recip() / (WIDEST * scale);
        let no_shading = (3.0 - 2.0 * wide).clamp(0.0, 1.0);
        let blur = self.blur(scale);
        std::f32::consts::TAU.sqrt() * blur * self.top * no_shading * self.above_pedestal(blur)
    }

    /// What stands above the pedestal, as a share of the step.
    fn above_pedestal(&self, blur: f32) -> f32 {
        let lower = self.beyond[0].min(self.beyond[1]);
        if lower <= FREE {
            return 1.0;
        }
        // what a lone edge of this blur has there itself does not count
        let own = (-0.5 * (self.distance / blur).powi(2)).exp();
        let pedestal = ((lower - own) / (1.0 - own)).clamp(0.0, 1.0);
        ((1.0 - pedestal) / (1.0 - FREE)).min(1.0)
    }
}

impl Ridge {
    /// The gradients beyond the edge on the left and on the right of a chain that goes on `along` here.
    fn sides(&self, along: PxVector) -> [f32; 2] {
        let [low, high] = self.profile.beyond;
        let upright = self.normal[0].abs() >= self.normal[1].abs();
        // with y down, right of the way (x, y) is (-y, x)
        let high_is_right = if upright { -along.y > 0.0 } else { along.x > 0.0 };
        if high_is_right { [low, high] } else { [high, low] }
    }
}

/// Averages sharpness and pedestal along every chain, over `window` points to both sides.
pub(super) fn even_out(points: &mut [Ridge], chains: &[Chain], window: usize, scale: f32) {
    let even = |chain: &Chain| evened(points, chain, window, scale);
    let all: Vec<Vec<(f32, f32)>> = chains.par_iter().map(even).collect();
    for (&number, (step, blur)) in chains.iter().zip(all).flat_map(|(chain, even)| chain.iter().zip(even)) {
        let point = &mut points[number as usize];
        (point.step, point.blur) = (step, blur);
    }
}

/// Step and blur of the points of a chain (of a ring without the repeated one), evened out.
fn evened(points: &[Ridge], chain: &Chain, window: usize, scale: f32) -> Vec<(f32, f32)> {
    let closed = chain.first() == chain.last();
    let n = chain.len() - usize::from(closed);
    // running sums; round a ring they go on for a window beyond both its ends
    let around = if closed { window.min((n - 1) / 2) } else { 0 };
    let mut sums = Vec::with_capacity(n + 2 * around + 1);
    let mut sum = [0.0_f64; 3];
    sums.push(sum);
    for i in 0..n + 2 * around {
        let place = (i + n - around) % n;
        let (before, after) = if closed {
            (chain[(place + n - 1) % n], chain[(place + 1) % n])
        } else {
            (chain[place.saturating_sub(1)], chain[(place + 1).min(n - 1)])
        };
        let point = &points[chain[place] as usize];
        let [left, right] = point.sides(points[after as usize].at - points[before as usize].at);
        let values = [point.profile.sharpness, left, right].map(f64::from);
        sum = std::array::from_fn(|k| sum[k] + values[k]);
        sums.push(sum);
    }
    let even = |(i, &number): (usize, &u32)| {
        let place = i + around;
        let (from, to) = (place.saturating_sub(window), (place + window + 1).min(n + 2 * around));
        let mean = |k: usize| ((sums[to][k] - sums[from][k]) / (to - from) as f64) as f32;
        let point = &points[number as usize];
        let profile = Profile { sharpness: mean(0), beyond: [mean(1), mean(2)], ..point.profile };
        (profile.step(scale), profile.blur(scale))
    };
    chain[..n].iter().enumerate().map(even).collect()
}
