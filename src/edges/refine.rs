//! Refines positions: noise is smoothed out along the contour, and the shift that blur causes at a bend is undone.
//!
//! A parabola is fitted to the neighbours of every point, to as many of them as noise can explain the residuals of:
//! far along a straight edge, only near the point on a bend, never across a corner. A parabola does not cut bends
//! short as a running mean does.
//!
//! The steepest point of a blurred edge lies inside its bend: for a disc of radius `R` blurred by `t` it is found at
//! `R - t^2 / (2 R)` (up to higher orders, the gradient along a radius is `exp(-(r - R)^2 / 2 t^2) / sqrt(r)`). Radius
//! and blur are both measured, so the shift is known and is undone.

use super::contour::{Contour, ContourPoint};
use crate::geom::{self, right_of};
use crate::units::{PxPoint, PxVector};

/// Half lengths of the windows that are tried, in scales.
const WINDOWS: [f32; 4] = [1.7, 3.2, 6.0, 11.0];
/// Root mean square residual of the parabola that is always allowed, px.
const MIN_RMS: f32 = 0.02;
/// Residual allowed for noise, as a multiple of the position error of the points.
const NOISE_RMS: f32 = 1.15;

/// The squared curvature must be at least this many times its variance to count at all; beyond that it counts more and
/// more.
const MIN_SIGNIFICANCE: f64 = 1.5;

/// A window counts fully if the residual of its parabola is at most `FULL_WEIGHT` times the allowed one, and not at
/// all from `NO_WEIGHT` times on.
const FULL_WEIGHT: f32 = 0.8;
const NO_WEIGHT: f32 = 1.2;
/// Contours of fewer points are left as they are.
const MIN_POINTS: usize = 5;

/// A parabola fitted around a point of a contour.
#[derive(Debug, Clone, Copy)]
struct ParabolaFit {
    /// Where it passes the point.
    at: PxPoint,
    /// Direction of the contour, of length 1, or a little less where two fits are mixed.
    direction: PxVector,
    /// Signed curvature, 1/px: positive if it bends to the right of the direction (y down).
    curvature: f32,
    /// Confidence that the curvature is not noise, 0..=1.
    confidence: f32,
    /// Root mean square residual, px.
    rms: f32,
}

impl ParabolaFit {
    /// This fit mixed with that of a wider window, which gets the weight `share`.
    fn mixed(&self, wider: &Self, share: f32) -> Self {
        Self {
            at: self.at.lerp(wider.at, share),
            direction: self.direction.lerp(wider.direction, share),
            curvature: geom::mix(self.curvature, wider.curvature, share),
            confidence: geom::mix(self.confidence, wider.confidence, share),
            rms: wider.rms,
        }
    }

    /// The position of the edge, with the shift undone that a blur causes at a bend. `sigma` bounds the curvature.
    fn unshifted(&self, blur: f32, sigma: f32) -> PxPoint {
        let bend = self.curvature.abs().min(1.0 / sigma);
        let shift = if bend > 1e-5 {
            let radius = 1.0 / bend;
            0.5 * (radius + (radius * radius + 2.0 * blur * blur).sqrt()) - radius
        } else {
            0.0
        };
        // away from the centre, which lies on the right where the curvature is positive
        let right = right_of(self.direction);
        self.at - right * (shift * self.confidence * self.curvature.signum())
    }
}

/// Moves every point of a contour to where the edge is. `sigma` is the scale of the derivative, px.
pub(super) fn refine(contour: &mut Contour, sigma: f32) {
    let n = contour.vertices.len();
    if n < MIN_POINTS {
        return;
    }
    let arcs = contour.arc_lengths();
    let fits: Vec<Option<ParabolaFit>> = (0..n).map(|i| best_fit(contour, &arcs, i, sigma)).collect();
    for (point, fit) in contour.vertices.iter_mut().zip(fits) {
        if let Some(fit) = fit {
            point.at = fit.unshifted(point.blur, sigma);
        }
    }
}

/// The fit over the widest window whose residual noise explains. `arcs` are the arc lengths of the contour.
fn best_fit(contour: &Contour, arcs: &[f32], i: usize, sigma: f32) -> Option<ParabolaFit> {
    let total = *arcs.last()?;
    let max_half = if contour.closed { 0.45 * total } else { arcs[i].min(total - arcs[i]).max(WINDOWS[0] * sigma) };
    let max_rms = (NOISE_RMS * contour.vertices[i].position_sigma).hypot(MIN_RMS);
    let mut window = Window { contour, arcs, centre: i, last: [i; 2], sums: ParabolaSums::new(&contour.vertices[i]) };
    let mut best: Option<ParabolaFit> = None;
    for scales in WINDOWS {
        let half = (scales * sigma).min(max_half);
        window.widen(half);
        let Some(fit) = window.sums.fit(half) else { break };
        // from one window to the next gradually, so that a little more noise moves a point only a little
        let share = ((NO_WEIGHT - fit.rms / max_rms) / (NO_WEIGHT - FULL_WEIGHT)).clamp(0.0, 1.0);
        best = Some(best.map_or(fit, |best| best.mixed(&fit, share)));
        if share <= 0.0 || half < scales * sigma {
            break;
        }
    }
    best
}

/// The points around a point of a contour.
struct Window<'a> {
    contour: &'a Contour,
    arcs: &'a [f32],
    centre: usize,
    /// The last point that was added forwards, and backwards.
    last: [usize; 2],
    sums: ParabolaSums,
}

impl Window<'_> {
    /// Adds the points up to `half` pixels along the contour, in both directions.
    fn widen(&mut self, half: f32) {
        let total = self.arcs[self.arcs.len() - 1];
        for (side, step) in [1, -1].into_iter().enumerate() {
            let forwards = step > 0;
            while let Some(to) = self.contour.next(self.last[side], step)
                && to != self.centre
            {
                let mut arc = self.arcs[to] - self.arcs[self.centre];
                if forwards && arc < 0.0 {
                    arc += total;
                } else if !forwards && arc > 0.0 {
                    arc -= total;
                }
                if arc.abs() > half {
                    break;
                }
                self.sums.add(&self.contour.vertices[to], arc);
                self.last[side] = to;
            }
        }
    }
}

/// Sums for least squares parabolas of x and y over the arc length.
struct ParabolaSums {
    origin: PxPoint,
    /// Sums of the powers 0 to 4 of the arc length.
    moments: [f64; 5],
    /// Sums of x times the powers 0 to 2 of the arc length.
    xs: [f64; 3],
    ys: [f64; 3],
    /// Sum of the squared distances from the origin.
    squares: f64,
    /// Sum of the variances of the positions.
    variances: f64,
}

impl ParabolaSums {
    /// The sums of one point alone, which becomes the origin.
    fn new(point: &ContourPoint) -> Self {
        let (moments, xs, ys) = ([0.0; 5], [0.0; 3], [0.0; 3]);
        let mut sums = Self { origin: point.at, moments, xs, ys, squares: 0.0, variances: 0.0 };
        sums.add(point, 0.0);
        sums
    }

    fn add(&mut self, point: &ContourPoint, arc: f32) {
        let (s, v) = (f64::from(arc), point.at - self.origin);
        let (x, y) = (f64::from(v.x), f64::from(v.y));
        let powers = [1.0, s, s * s, s * s * s, s * s * s * s];
        self.moments.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power);
        self.xs.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power * x);
        self.ys.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power * y);
        self.squares += x * x + y * y;
        self.variances += f64::from(point.position_sigma * point.position_sigma);
    }

    /// The parabola over a window of half length `half`; none for too few points.
    fn fit(&self, half: f32) -> Option<ParabolaFit> {
        let Self { moments, xs, ys, .. } = self;
        let count = moments[0];
        if count < 4.0 {
            return None;
        }
        let (x, y) = (parabola(moments, xs)?, parabola(moments, ys)?);
        let residual = self.squares - (0..3).map(|k| x[k] * xs[k] + y[k] * ys[k]).sum::<f64>();
        let speed = (x[1] * x[1] + y[1] * y[1]).sqrt();
        if speed < 0.1 {
            return None;
        }
        let curvature = 2.0 * (x[1] * y[2] - y[1] * x[2]) / (speed * speed * speed);
        // The curvature of a parabola has the variance 45 v / (n h^4). The errors of neighbours are correlated (they
        // share pixels), so only every second point counts.
        let variance = 2.0 * 45.0 * (self.variances / count) / (count * f64::from(half).powi(4));
        // where the curvature may be noise, a straight line fits better
        let straight = |t: &[f64; 3]| {
            (t[0] * moments[2] - moments[1] * t[1]) / (moments[0] * moments[2] - moments[1] * moments[1])
        };
        let confidence = (1.0 - MIN_SIGNIFICANCE * variance / (curvature * curvature).max(1e-12)).max(0.0);
        let mix = |s: f64, q: f64| (s + (q - s) * confidence) as f32;
        Some(ParabolaFit {
            at: self.origin + PxVector::new(mix(straight(xs), x[0]), mix(straight(ys), y[0])),
            confidence: confidence as f32,
            direction: PxVector::new((x[1] / speed) as f32, (y[1] / speed) as f32),
            curvature: curvature as f32,
            rms: (residual.max(0.0) / (count - 3.0).max(1.0)).sqrt() as f32,
        })
    }
}

/// The coefficients of a least squares parabola, from its normal equations; none if they are singular.
fn parabola(m: &[f64; 5], t: &[f64; 3]) -> Option<[f64; 3]> {
    let minors = [m[2] * m[4] - m[3] * m[3], m[1] * m[4] - m[2] * m[3], m[1] * m[3] - m[2] * m[2]];
    let det = m[0] * minors[0] - m[1] * minors[1] + m[2] * minors[2];
    if det.abs() < 1e-9 {
        return None;
    }
    let a = t[0] * minors[0] - m[1] * (t[1] * m[4] - m[3] * t[2]) + m[2] * (t[1] * m[3] - m[2] * t[2]);
    let b = m[0] * (t[1] * m[4] - m[3] * t[2]) - t[0] * minors[1] + m[2] * (m[1] * t[2] - m[2] * t[1]);
    let c = m[0] * (m[2] * t[2] - m[3] * t[1]) - m[1] * (m[1] * t[2] - m[2] * t[1]) + t[0] * minors[2];
    Some([a / det, b / det, c / det])
}

#[cfg(test)]
mod tests;
