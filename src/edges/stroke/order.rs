//! Values in order: their median and their quantiles.

/// The median; of an even number of values the mean of the two in the middle, so that the median of what lies to the
/// left changes its sign alone when a picture is flipped. 0 of none.
pub(super) fn median(values: impl Iterator<Item = f32>) -> f32 {
    let values = sorted(values);
    let [low, high] = [values.len().saturating_sub(1) / 2, values.len() / 2];
    values.get(low).zip(values.get(high)).map_or(0.0, |(low, high)| 0.5 * (low + high))
}

/// The value below which a share of sorted values lies; 0 of none.
pub(super) fn quantile(sorted: &[f32], share: f32) -> f32 {
    sorted.get((share * sorted.len() as f32) as usize).copied().unwrap_or(0.0)
}

pub(super) fn sorted(values: impl Iterator<Item = f32>) -> Vec<f32> {
    let mut values: Vec<f32> = values.collect();
    values.sort_by(f32::total_cmp);
    values
}

#[cfg(test)]
mod tests;
