//! How high the colour step is, however soft, and whatever slope it stands on.
//!
//! The gradient across a step of height `D` and blur `t` is the bump `D / (sqrt(tau) t) exp(-x^2 / 2 t^2)`: its top and its
//! sharpness `1 / t^2` give the height. Under the bump may lie a pedestal, the slope of a shaded surface; only what
//! stands above it is the step. Shading has no contours: where the colour goes on changing on both sides as it does on the
//! "edge", nothing is left.
//!
//! A single reading of sharpness and pedestal is as noisy as the point itself, so both are averaged along the chain. Of the
//! two sides the lower pedestal counts, as on the other there may be an edge of its own.

use super::chain::Chain;
use super::thin::Ridge;

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
    /// The gradient beyond the edge on either side, as a share of the top.
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

/// Averages sharpness and pedestal along every chain, over `window` points to both sides.
pub(super) fn even_out(points: &mut [Ridge], chains: &[Chain], window: usize, scale: f32) {
    let mut sums: Vec<[f32; 3]> = Vec::new();
    for chain in chains {
        let closed = chain.first() == chain.last();
        let n = chain.len() - usize::from(closed);
        sums.clear();
        let mut sum = [0.0; 3];
        sums.push(sum);
        for &number in &chain[..n] {
            let Profile { sharpness, beyond, .. } = points[number as usize].profile;
            sum = [sum[0] + sharpness, sum[1] + beyond[0], sum[2] + beyond[1]];
            sums.push(sum);
        }
        for (i, &number) in chain[..n].iter().enumerate() {
            let (from, to) = (i.saturating_sub(window), (i + window + 1).min(n));
            let mean = |k: usize| (sums[to][k] - sums[from][k]) / (to - from) as f32;
            let point = &mut points[number as usize];
            let profile = Profile { sharpness: mean(0), beyond: [mean(1), mean(2)], ..point.profile };
            (point.step, point.blur) = (profile.step(scale), profile.blur(scale));
        }
    }
}
