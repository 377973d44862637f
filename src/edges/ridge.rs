//! Ridge points of the gradient, and the gradient profile across the edge at each of them.
//!
//! The gradient across a step of height `D` and blur `t` is the bump `D / (sqrt(tau) t) exp(-x^2 / 2 t^2)`. Its
//! maximum and its curvature `1 / t^2` give the height of the step, however soft the edge is. Under the bump may lie a
//! pedestal: the slope of a shaded surface. Only what stands above the pedestal is the step. Where the colour changes
//! on both sides as fast as it does on the "edge", nothing is left: smooth shading has no contours.

use crate::units::{PxPoint, PxVector};

/// The widest edge whose height is measured, in scales of the derivative. A wider step counts as shading: its height is
/// reduced, to 0 from one and a half times this width on.
pub(super) const MAX_BLUR: f32 = 2.5;
/// A pedestal of up to this share of the maximum is ignored: noise alone causes as much.
const FREE_PEDESTAL: f32 = 0.1;

/// A point where the gradient is greatest across the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RidgePoint {
    pub(super) at: PxPoint,
    /// Unit vector across the edge. Its sign has no meaning (a colour difference has no up and down).
    pub(super) normal: PxVector,
    pub(super) profile: EdgeProfile,
    /// Height of the colour step, in units of strength.
    pub(super) height: f32,
    /// Blur of the step including the scale of the derivative, px.
    pub(super) blur: f32,
    /// Column of the pixel it was found at.
    pub(super) column: u32,
    /// Row of the pixel it was found at.
    pub(super) row: u32,
}

impl RidgePoint {
    /// The gradients beyond the edge on the left and on the right of a chain that runs in the direction `along` here.
    pub(super) fn pedestal_left_right(&self, along: PxVector) -> [f32; 2] {
        let [low, high] = self.profile.pedestal;
        let upright = self.normal.x.abs() >= self.normal.y.abs();
        // with y down, right of the direction (x, y) is (-y, x)
        let high_is_right = if upright { -along.y > 0.0 } else { along.x > 0.0 };
        if high_is_right { [low, high] } else { [high, low] }
    }
}

/// The gradient across an edge, described by a few numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EdgeProfile {
    /// The greatest gradient, per pixel.
    pub(super) maximum: f32,
    /// `1 / t^2` for the blur `t`, which includes the scale of the derivative, px^-2.
    pub(super) curvature: f32,
    /// The gradient beyond the edge on its left or above it, and on its right or below it, as a share of the gradient
    /// at the pixel of the edge.
    pub(super) pedestal: [f32; 2],
    /// Distance from the edge at which the pedestal was read, px.
    pub(super) distance: f32,
}

impl EdgeProfile {
    /// Blur, px: at least that of the derivative itself, at most the widest that is measured.
    pub(super) fn blur(&self, sigma: f32) -> f32 {
        self.curvature.max(1e-6).sqrt().recip().clamp(sigma, MAX_BLUR * sigma)
    }

    /// Height of the step, in units of strength.
    pub(super) fn height(&self, sigma: f32) -> f32 {
        let width = self.curvature.max(1e-6).sqrt().recip() / (MAX_BLUR * sigma);
        let no_shading = (3.0 - 2.0 * width).clamp(0.0, 1.0);
        let blur = self.blur(sigma);
        std::f32::consts::TAU.sqrt() * blur * self.maximum * no_shading * self.share_above_pedestal(blur)
    }

    /// The part of the step that stands above the pedestal, 0..=1.
    fn share_above_pedestal(&self, blur: f32) -> f32 {
        // Of the two sides the lower one counts, since there may be another edge on the higher one.
        let lower = self.pedestal[0].min(self.pedestal[1]);
        if lower <= FREE_PEDESTAL {
            return 1.0;
        }
        // the gradient that an isolated edge of this blur has there itself does not count
        let own = (-0.5 * (self.distance / blur).powi(2)).exp();
        let pedestal = ((lower - own) / (1.0 - own)).clamp(0.0, 1.0);
        ((1.0 - pedestal) / (1.0 - FREE_PEDESTAL)).min(1.0)
    }
}

#[cfg(test)]
mod tests;
