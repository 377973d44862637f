//! Shares of one whole in whole percent that add up: five colours may each be rounded up by half a percent.

use std::cmp::Reverse;

/// Shares count in steps of a hundredth of a percent, so that they are the same after a page was written and read.
const STEPS: f32 = 1e4;
/// Steps of a percent.
const PERCENT: i64 = 100;

/// Shares (0..=1) of one whole as they are told in whole percent: some are rounded the other way, those for which it
/// matters least, so that they add up to what they are together. Equal shares are rounded alike, so that a few percent
/// may still be missing or too much. What is told as under 1 or over 99 percent stays as it is.
pub(super) fn told(shares: &[f32]) -> Vec<f32> {
    let exact: Vec<i64> = shares.iter().map(|share| (STEPS * share).round() as i64).collect();
    let mut percents: Vec<i64> = shares.iter().map(|share| (100.0 * share).round() as i64).collect();
    let mut surplus = percents.iter().sum::<i64>() - (exact.iter().sum::<i64>() + PERCENT / 2) / PERCENT;
    let step = -surplus.signum();
    let error = |k: usize, percent: i64| (PERCENT * percent - exact[k]).abs();
    let is_whole = |percent: i64| (1..100).contains(&percent);
    let mut others: Vec<usize> = (0..shares.len())
        .filter(|&k| is_whole(percents[k]) && is_whole(percents[k] + step) && error(k, percents[k] + step) < PERCENT)
        .collect();
    others.sort_by_key(|&k| (error(k, percents[k] + step), Reverse(exact[k])));
    for equal in others.chunk_by(|&a, &b| exact[a] == exact[b]) {
        let count = equal.len() as i64;
        if count <= surplus.abs() {
            equal.iter().for_each(|&k| percents[k] += step);
            surplus += step * count;
        }
    }
    let told = |(share, percent): (&f32, i64)| if is_whole(percent) { percent as f32 / 100.0 } else { *share };
    shares.iter().zip(percents).map(told).collect()
}

#[cfg(test)]
mod tests;
