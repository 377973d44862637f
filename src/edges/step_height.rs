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
mod tests;
