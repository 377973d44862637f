//! Step heights averaged along chains.
//!
//! Curvature and pedestal of a single gradient profile are as noisy as the point itself, so both are averaged along the
//! chain. Height and blur of each point are then computed anew from the means (see [`super::ridge`]).

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::chain::{Chain, neighbours};
use super::ridge::{EdgeProfile, RidgePoint};

/// Averages curvature and pedestal along every chain, over `window` points on both sides, and updates height and blur.
pub(super) fn average(points: &mut [RidgePoint], chains: &[Chain], window: usize, sigma: f32) {
    let averaged = |chain: &Chain| averaged(points, chain, window, sigma);
    let all: Vec<Vec<(f32, f32)>> = chains.par_iter().map(averaged).collect();
    for (&number, (height, blur)) in
        chains.iter().zip(all).flat_map(|(chain, values)| chain.vertices.iter().zip(values))
    {
        let point = &mut points[number as usize];
        (point.height, point.blur) = (height, blur);
    }
}

/// Height and blur of the points of a chain.
fn averaged(points: &[RidgePoint], chain: &Chain, window: usize, sigma: f32) -> Vec<(f32, f32)> {
    let n = chain.vertices.len();
    // the sums of a closed chain begin and end this many points beyond it
    let margin = if chain.closed { window.min((n - 1) / 2) } else { 0 };
    let sums = running_sums(points, chain, margin);
    let average = |(i, &number): (usize, &u32)| {
        let middle = i + margin;
        let (from, to) = (middle.saturating_sub(window), (middle + window + 1).min(n + 2 * margin));
        let mean = |k: usize| ((sums[to][k] - sums[from][k]) / (to - from) as f64) as f32;
        let point = &points[number as usize];
        let profile = EdgeProfile { curvature: mean(0), pedestal: [mean(1), mean(2)], ..point.profile };
        (profile.height(sigma), profile.blur(sigma))
    };
    chain.vertices.iter().enumerate().map(average).collect()
}

/// Running sums of curvature, left and right pedestal along a chain, from `margin` points before its first point to
/// `margin` points after its last.
fn running_sums(points: &[RidgePoint], chain: &Chain, margin: usize) -> Vec<[f64; 3]> {
    let n = chain.vertices.len();
    let mut sums = Vec::with_capacity(n + 2 * margin + 1);
    let mut sum = [0.0_f64; 3];
    sums.push(sum);
    for i in 0..n + 2 * margin {
        let index = (i + n - margin) % n;
        let [before, after] = neighbours(n, chain.closed, index).map(|k| points[chain.vertices[k] as usize].at);
        let point = &points[chain.vertices[index] as usize];
        let [left, right] = point.pedestal_left_right(after - before);
        let values = [point.profile.curvature, left, right].map(f64::from);
        sum = std::array::from_fn(|k| sum[k] + values[k]);
        sums.push(sum);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{PxPoint, PxVector};

    const SIGMA: f32 = 1.5;

    fn profile(curvature: f32) -> EdgeProfile {
        EdgeProfile { maximum: 8.0, curvature, pedestal: [0.05, 0.1], distance: 4.5 }
    }

    /// Points of an upright edge, each with its curvature, in a chain from the top down.
    fn averaged_over(curvatures: &[f32], closed: bool, window: usize) -> Vec<f32> {
        let point = |(row, &curvature): (u32, &f32)| RidgePoint {
            at: PxPoint::new(10.0, row as f32),
            normal: PxVector::new(1.0, 0.0),
            profile: profile(curvature),
            height: 0.0,
            blur: 0.0,
            column: 10,
            row,
        };
        let mut points: Vec<RidgePoint> = (0..).zip(curvatures).map(point).collect();
        let chain = Chain { vertices: (0..points.len() as u32).collect(), closed };
        average(&mut points, &[chain], window, SIGMA);
        points.iter().map(|point| point.height).collect()
    }

    fn height(curvature: f32) -> f32 {
        profile(curvature).height(SIGMA)
    }

    #[test]
    fn where_all_points_are_alike_each_keeps_its_height() {
        for closed in [false, true] {
            let heights = averaged_over(&[0.25; 9], closed, 3);
            assert!(heights.iter().all(|found| (found - height(0.25)).abs() < 1e-3), "{heights:?}");
        }
    }

    #[test]
    fn curvature_is_the_mean_over_the_window_and_at_ends_over_what_there_is_of_it() {
        let heights = averaged_over(&[0.2, 0.2, 0.2, 0.32, 0.2, 0.2], false, 1);
        let expected = [0.2, 0.2, 0.24, 0.24, 0.24, 0.2].map(height);
        assert!(heights.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{heights:?}, not {expected:?}");
        // a ring has no ends
        let ring = averaged_over(&[0.32, 0.2, 0.2, 0.2, 0.2, 0.2], true, 1);
        let expected = [0.24, 0.24, 0.2, 0.2, 0.2, 0.24].map(height);
        assert!(ring.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{ring:?}, not {expected:?}");
    }
}
