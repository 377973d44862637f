//! Values in order: their median, the one in the middle, and their quantiles.

/// The median; of an even number of values the mean of the two in the middle, so that the median of what lies to the
/// left changes its sign alone when a picture is flipped. 0 of none.
pub fn median(values: impl Iterator<Item = f32>) -> f32 {
    let values = sorted(values);
    let [low, high] = [values.len().saturating_sub(1) / 2, values.len() / 2];
    values.get(low).zip(values.get(high)).map_or(0.0, |(low, high)| 0.5 * (low + high))
}

/// The value in the middle; of an even number of values the higher one of two, so that it is one of those that there
/// are, as the height of a letter. 0 of none.
pub fn middle(mut values: Vec<f32>) -> f32 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f32::total_cmp).1
}

/// The value below which a share of sorted values lies; 0 of none.
pub fn quantile(sorted: &[f32], share: f32) -> f32 {
    sorted.get((share * sorted.len() as f32) as usize).copied().unwrap_or(0.0)
}

/// The values from the least to the greatest.
pub fn sorted(values: impl Iterator<Item = f32>) -> Vec<f32> {
    let mut values: Vec<f32> = values.collect();
    values.sort_by(f32::total_cmp);
    values
}

#[cfg(test)]
mod tests;
