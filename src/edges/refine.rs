//! Where exactly the edge lies: noise smoothed out along the contour, and the shift taken back that blur gives to a bend.
//!
//! Around every mark a parabola is laid through its neighbours, as many as fit it within what noise explains: far along a
//! straight edge, close by on a bend, none across a corner. A parabola does not cut a bend short as a running mean does.
//!
//! The steepest place of a blurred edge lies inside its bend: for a disc of radius `R` blurred by `t` it is found at
//! `R - t^2 / (2 R)` (the gradient along a radius is `exp(-(r - R)^2 / 2 t^2) / sqrt(r)` but for higher orders). Radius and
//! blur are both measured, so the shift is known and taken back.

use super::path::{Mark, Path};
use crate::units::{PxPoint, PxVector};

/// Half lengths of the windows that are tried, in scales.
const WINDOWS: [f32; 4] = [1.7, 3.2, 6.0, 11.0];
/// Root mean square distance from the parabola that is always allowed, px.
const LEAST_OFF: f32 = 0.02;
/// ... and for noise: this times the doubt of the marks.
const NOISE_OFF: f32 = 1.15;

/// How many times its variance the square of a bend must be to count at all; above that it counts the more the larger.
const SURE: f64 = 1.5;

/// A window counts fully as long as its parabola is off by no more than this many times what is allowed, and not at all
/// from the second on.
const FULLY: f32 = 0.8;
const NOT_AT_ALL: f32 = 1.2;

#[derive(Debug, Clone, Copy)]
struct Fit {
    at: PxPoint,
    /// Direction of the path; of length 1, or a little less where two fits are mixed.
    along: PxVector,
    /// Signed; positive bends to the right of the direction (y down).
    curvature: f32,
    /// How sure it is that the bend is no noise, 0..=1.
    sure: f32,
    off: f32,
}

impl Fit {
    /// The fit a share of the way from this one to `wider`.
    fn mixed(&self, wider: &Self, share: f32) -> Self {
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Self {
            at: self.at.lerp(wider.at, share),
            along: self.along.lerp(wider.along, share),
            curvature: mix(self.curvature, wider.curvature),
            sure: mix(self.sure, wider.sure),
            off: wider.off,
        }
    }
}

/// Moves every mark to where the edge is.
pub(super) fn refine(path: &mut Path, scale: f32) {
    let n = path.marks.len();
    if n < 5 {
        return;
    }
    let arcs = arcs(path);
    let fits: Vec<Option<Fit>> = (0..n).map(|i| best(path, &arcs, i, scale)).collect();
    for (mark, fit) in path.marks.iter_mut().zip(fits) {
        let Some(fit) = fit else { continue };
        let bend = fit.curvature.abs().min(1.0 / scale);
        let shift = if bend > 1e-5 {
            let radius = 1.0 / bend;
            0.5 * (radius + (radius * radius + 2.0 * mark.blur * mark.blur).sqrt()) - radius
        } else {
            0.0
        };
        // away from the centre, which lies to the right where the curvature is positive
        let right = PxVector::new(-fit.along.y, fit.along.x);
        mark.at = fit.at - right * (shift * fit.sure * fit.curvature.signum());
    }
}

/// Way from the first mark to each, and round to the first again at the end.
fn arcs(path: &Path) -> Vec<f32> {
    let mut arcs = Vec::with_capacity(path.marks.len() + 1);
    let mut way = 0.0;
    for (i, mark) in path.marks.iter().enumerate() {
        if i > 0 {
            way += (mark.at - path.marks[i - 1].at).length();
        }
        arcs.push(way);
    }
    let (first, last) = (path.marks[0].at, path.marks[path.marks.len() - 1].at);
    arcs.push(way + (first - last).length());
    arcs
}

/// The fit over the widest window that noise explains.
fn best(path: &Path, arcs: &[f32], i: usize, scale: f32) -> Option<Fit> {
    let n = path.marks.len();
    let room = if path.closed { 0.45 * arcs[n] } else { arcs[i].min(arcs[n - 1] - arcs[i]).max(WINDOWS[0] * scale) };
    let allowed = (NOISE_OFF * path.marks[i].doubt).hypot(LEAST_OFF);
    let mut sums = Sums::at(&path.marks[i]);
    let mut best: Option<Fit> = None;
    let mut tips = [(i, 0.0), (i, 0.0)];
    for window in WINDOWS {
        let half = (window * scale).min(room);
        for (tip, forwards) in tips.iter_mut().zip([true, false]) {
            widen(path, arcs, i, half, tip, forwards, &mut sums);
        }
        let Some(fit) = sums.fit(half) else { break };
        // from one window to the next gradually, so that a little more noise moves a mark but a little
        let share = ((NOT_AT_ALL - fit.off / allowed) / (NOT_AT_ALL - FULLY)).clamp(0.0, 1.0);
        best = Some(best.map_or(fit, |best| best.mixed(&fit, share)));
        if share <= 0.0 || half < window * scale {
            break;
        }
    }
    best
}

/// Adds the marks up to `half` pixels along the path from mark `i`, beyond `tip`, the last one added and its way.
fn widen(path: &Path, arcs: &[f32], i: usize, half: f32, tip: &mut (usize, f32), forwards: bool, sums: &mut Sums) {
    let round = arcs[path.marks.len()];
    while let Some(to) = path.next(tip.0, if forwards { 1 } else { -1 })
        && to != i
    {
        let mut way = arcs[to] - arcs[i];
        if forwards && way < 0.0 {
            way += round;
        } else if !forwards && way > 0.0 {
            way -= round;
        }
        if way.abs() > half {
            return;
        }
        sums.add(&path.marks[to], way);
        *tip = (to, way);
    }
}

/// Sums for least squares parabolas of x and y over the way along a path.
struct Sums {
    from: PxPoint,
    moments: [f64; 5],
    xs: [f64; 3],
    ys: [f64; 3],
    squares: f64,
    doubts: f64,
}

impl Sums {
    fn at(mark: &Mark) -> Self {
        let mut sums = Self { from: mark.at, moments: [0.0; 5], xs: [0.0; 3], ys: [0.0; 3], squares: 0.0, doubts: 0.0 };
        sums.add(mark, 0.0);
        sums
    }

    fn add(&mut self, mark: &Mark, way: f32) {
        let (s, v) = (f64::from(way), mark.at - self.from);
        let (x, y) = (f64::from(v.x), f64::from(v.y));
        let powers = [1.0, s, s * s, s * s * s, s * s * s * s];
        self.moments.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power);
        self.xs.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power * x);
        self.ys.iter_mut().zip(&powers).for_each(|(sum, power)| *sum += power * y);
        self.squares += x * x + y * y;
        self.doubts += f64::from(mark.doubt * mark.doubt);
    }

    fn fit(&self, half: f32) -> Option<Fit> {
        let Self { moments, xs, ys, .. } = self;
        let count = moments[0];
        if count < 4.0 {
            return None;
        }
        let (x, y) = (solve(moments, xs)?, solve(moments, ys)?);
        let left = self.squares - (0..3).map(|k| x[k] * xs[k] + y[k] * ys[k]).sum::<f64>();
        let speed = (x[1] * x[1] + y[1] * y[1]).sqrt();
        if speed < 0.1 {
            return None;
        }
        let curvature = 2.0 * (x[1] * y[2] - y[1] * x[2]) / (speed * speed * speed);
        // of a parabola's curvature, 45 v / (n h^4); neighbours err alike (they share pixels), so one in two counts
        let variance = 2.0 * 45.0 * (self.doubts / count) / (count * f64::from(half).powi(4));
        // where the bend may be noise, a straight line is the better fit
        let straight = |t: &[f64; 3]| {
            (t[0] * moments[2] - moments[1] * t[1]) / (moments[0] * moments[2] - moments[1] * moments[1])
        };
        let sure = (1.0 - SURE * variance / (curvature * curvature).max(1e-12)).max(0.0);
        let mix = |s: f64, q: f64| (s + (q - s) * sure) as f32;
        Some(Fit {
            at: self.from + PxVector::new(mix(straight(xs), x[0]), mix(straight(ys), y[0])),
            sure: sure as f32,
            along: PxVector::new((x[1] / speed) as f32, (y[1] / speed) as f32),
            curvature: curvature as f32,
            off: (left.max(0.0) / (count - 3.0).max(1.0)).sqrt() as f32,
        })
    }
}

/// Solves the normal equations of a parabola.
fn solve(m: &[f64; 5], t: &[f64; 3]) -> Option<[f64; 3]> {
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
