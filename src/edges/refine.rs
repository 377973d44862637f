//! Where exactly the edge lies: noise smoothed out along the contour, and the shift taken back that blur gives to a bend.
//!
//! Around every mark a parabola is laid through its neighbours, as many as fit it within what noise explains: far along a
//! straight edge, close by on a bend, none across a corner. A parabola does not cut a bend short as a running mean does.
//!
//! The steepest place of a blurred edge lies inside its bend: for a disc of radius `R` blurred by `t` it is found at
//! `R - t^2 / (2 R)` (the gradient along a radius is `exp(-(r - R)^2 / 2 t^2) / sqrt(r)` but for higher orders). Radius and
//! blur are both measured, so the shift is known and taken back.

use super::path::Path;
use crate::units::{PxPoint, PxVector};

/// Half lengths of the windows that are tried, in scales.
const WINDOWS: [f32; 4] = [1.7, 3.2, 6.0, 11.0];
/// Root mean square distance from the parabola that is always allowed, px.
const LEAST_OFF: f32 = 0.02;
/// ... and for noise: this times the doubt of the marks.
const NOISE_OFF: f32 = 1.15;

/// How many times its variance the square of a bend must be to count at all; above that it counts the more the larger.
const SURE: f64 = 1.5;

struct Fit {
    at: PxPoint,
    /// Unit direction of the path.
    along: PxVector,
    /// Signed; positive bends to the right of the direction (y down).
    curvature: f32,
    /// How sure it is that the bend is no noise, 0..=1.
    sure: f32,
    off: f32,
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
    let mut best: Option<Fit> = None;
    for window in WINDOWS {
        let half = (window * scale).min(room);
        let Some(fit) = fit(path, arcs, i, half) else { break };
        let allowed = (NOISE_OFF * path.marks[i].doubt).hypot(LEAST_OFF);
        if best.is_some() && fit.off > allowed {
            break;
        }
        best = Some(fit);
        if half < window * scale {
            break;
        }
    }
    best
}

/// Least squares parabolas of x and y over the way along the path, within `half` pixels of mark `i`.
fn fit(path: &Path, arcs: &[f32], i: usize, half: f32) -> Option<Fit> {
    let n = path.marks.len();
    let (here, round) = (path.marks[i].at, arcs[n]);
    let mut moments = [0.0_f64; 5];
    let (mut xs, mut ys) = ([0.0_f64; 3], [0.0_f64; 3]);
    let (mut squares, mut doubts) = (0.0_f64, 0.0_f64);
    let mut add = |number: usize, way: f32| {
        let (s, v) = (f64::from(way), path.marks[number].at - here);
        let (x, y) = (f64::from(v.x), f64::from(v.y));
        let mut power = 1.0;
        for (k, moment) in moments.iter_mut().enumerate() {
            *moment += power;
            if k < 3 {
                xs[k] += power * x;
                ys[k] += power * y;
            }
            power *= s;
        }
        squares += x * x + y * y;
        doubts += f64::from(path.marks[number].doubt).powi(2);
    };
    add(i, 0.0);
    for forwards in [true, false] {
        let mut k = i;
        loop {
            let Some(to) = path.next(k, if forwards { 1 } else { -1 }) else { break };
            if to == i {
                break;
            }
            let mut way = arcs[to] - arcs[i];
            if forwards && way < 0.0 {
                way += round;
            } else if !forwards && way > 0.0 {
                way -= round;
            }
            if way.abs() > half {
                break;
            }
            add(to, way);
            k = to;
        }
    }
    let count = moments[0];
    if count < 4.0 {
        return None;
    }
    let x = solve(&moments, &xs)?;
    let y = solve(&moments, &ys)?;
    let left = squares - (0..3).map(|k| x[k] * xs[k] + y[k] * ys[k]).sum::<f64>();
    let speed = x[1].hypot(y[1]);
    if speed < 0.1 {
        return None;
    }
    let curvature = 2.0 * (x[1] * y[2] - y[1] * x[2]) / speed.powi(3);
    // neighbours err alike (they share their pixels), so only about one in two counts
    let variance = 2.0 * 45.0 * (doubts / count) / (count * f64::from(half).powi(4));
    // where the bend may be noise, a straight line is the better fit
    let straight =
        |t: &[f64; 3]| (t[0] * moments[2] - moments[1] * t[1]) / (moments[0] * moments[2] - moments[1] * moments[1]);
    let sure = (1.0 - SURE * variance / (curvature * curvature).max(1e-12)).max(0.0);
    let mix = |s: f64, q: f64| (s + (q - s) * sure) as f32;
    Some(Fit {
        at: here + PxVector::new(mix(straight(&xs), x[0]), mix(straight(&ys), y[0])),
        sure: sure as f32,
        along: PxVector::new((x[1] / speed) as f32, (y[1] / speed) as f32),
        curvature: curvature as f32,
        off: (left.max(0.0) / (count - 3.0).max(1.0)).sqrt() as f32,
    })
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
