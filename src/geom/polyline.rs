//! Measures of polylines.

use std::sync::LazyLock;

use lyon::geom::euclid::Point2D;

/// Length of a polyline.
pub fn length<U>(points: &[Point2D<f32, U>]) -> f32 {
    points.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum()
}

/// Length of the way from the first point to each point; the first entry is 0.
pub fn arc_lengths<U>(points: &[Point2D<f32, U>]) -> Vec<f32> {
    let mut at = 0.0;
    let mut arcs = Vec::with_capacity(points.len());
    for (i, &point) in points.iter().enumerate() {
        if i > 0 {
            at += (point - points[i - 1]).length();
        }
        arcs.push(at);
    }
    arcs
}

/// A Gaussian mean along a line: values `0..n` at the places `arcs`, blurred with `sigma` in the unit of `arcs`.
///
/// `value(i)` gives an array of numbers. A closed line (its last place is its first again) wraps round. At the ends of an
/// open line the window is cut to the same reach on both sides, so that end points stay where they are and nothing
/// shrinks towards the middle. The Gaussian is lowered so that it ends at 0, and what lies at the window's end to a rounding
/// is inside: at even distances many places do, and a rounding must not decide.
pub fn smooth<const N: usize>(
    arcs: &[f32],
    closed: bool,
    sigma: f32,
    value: impl Fn(usize) -> [f32; N],
) -> Vec<[f32; N]> {
    let n = arcs.len();
    if n < 3 || sigma <= 0.0 {
        return (0..n).map(value).collect();
    }
    // A closed line repeats its first point at the end; the repeat is not a sample of its own.
    let ring = if closed { n - 1 } else { n };
    let total = arcs[n - 1];
    let (bell, per_sigma) = (&*BELL, STEPS as f32 / sigma);
    let reach = if closed { (3.0 * sigma).min(total / 2.0) } else { 3.0 * sigma };
    let values: Vec<[f64; N]> = (0..ring).map(|i| value(i).map(f64::from)).collect();
    let mut out = Vec::with_capacity(n);
    for i in 0..ring {
        let reach = if closed { reach } else { reach.min(arcs[i]).min(total - arcs[i]) } + ROUNDING * sigma;
        let mut sum = values[i];
        let mut weight = 1.0_f64;
        // Adds what lies within reach; says whether there may be more behind it.
        let mut add = |distance: f32, value: &[f64; N]| {
            if distance > reach {
                return false;
            }
            let k = bell[(distance * per_sigma) as usize];
            sum.iter_mut().zip(value).for_each(|(sum, v)| *sum += k * v);
            weight += k;
            true
        };
        let here = arcs[i];
        let (before, after) = (arcs[..i].iter().zip(&values[..i]), arcs[i + 1..ring].iter().zip(&values[i + 1..]));
        // forwards, in a ring over its seam to the places before; then the same backwards
        if after.clone().all(|(arc, value)| add(arc - here, value)) && closed {
            before.clone().all(|(arc, value)| add(arc + total - here, value));
        }
        if before.rev().all(|(arc, value)| add(here - arc, value)) && closed {
            after.rev().all(|(arc, value)| add(here + total - arc, value));
        }
        out.push(sum.map(|s| (s / weight) as f32));
    }
    if closed {
        out.push(out[0]);
    }
    out
}

/// Steps for one sigma in the table of the Gaussian: its values are right within 0.005.
const STEPS: usize = 64;
/// What rounding may add to a distance, in sigmas.
const ROUNDING: f32 = 1e-3;

/// The Gaussian from its middle to three sigma, where it is 0, and a step; each value that of the middle of its step.
static BELL: LazyLock<[f64; 3 * STEPS + 2]> = LazyLock::new(|| {
    let gaussian = |x: f64| (-0.5 * x * x).exp();
    std::array::from_fn(|i| (gaussian((i as f64 + 0.5) / STEPS as f64) - gaussian(3.0)).max(0.0))
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;

    #[test]
    fn a_straight_line_stays_straight_and_keeps_its_ends() {
        let points: Vec<MmPoint> = (0..20).map(|i| MmPoint::new(i as f32, 2.0 * i as f32)).collect();
        let smoothed = smooth(&arc_lengths(&points), false, 2.0, |i| [points[i].x, points[i].y]);
        for (p, s) in points.iter().zip(&smoothed) {
            assert!((p.x - s[0]).abs() < 1e-4 && (p.y - s[1]).abs() < 1e-4, "{p:?} moved to {s:?}");
        }
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "the seam is one point, to the bit")]
    fn a_closed_line_has_no_seam() {
        let ring: Vec<MmPoint> = (0..=40)
            .map(|i| (i % 40) as f32 * std::f32::consts::TAU / 40.0)
            .map(|a| MmPoint::new(10.0 * a.cos(), 10.0 * a.sin()))
            .collect();
        let smoothed = smooth(&arc_lengths(&ring), true, 1.0, |i| [ring[i].x, ring[i].y]);
        let radii: Vec<f32> = smoothed.iter().map(|[x, y]| x.hypot(*y)).collect();
        let (least, most) = radii.iter().fold((f32::MAX, 0.0_f32), |(a, b), &r| (a.min(r), b.max(r)));
        assert!(most - least < 1e-3, "radii from {least} to {most}");
        assert!(smoothed[0] == smoothed[40], "the ring does not close");
    }
}
