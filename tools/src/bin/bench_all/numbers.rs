//! Fits.

/// The exponent e of `y = c x^e` that fits best by least squares on the logarithms. Nothing of fewer than two places.
pub(crate) fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
    let along: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let spread: f64 = logs.iter().map(|(x, _)| (x - mean_x).powi(2)).sum();
    (spread > 0.0).then(|| along / spread)
}

/// Rounded to hundredths: more digits of an exponent near 0 say nothing. Never minus 0.
pub(crate) fn hundredths(value: f64) -> f64 {
    (1e2 * value).round() / 1e2 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_those_of_known_numbers() {
        let square: Vec<(f64, f64)> = [1.0, 2.0, 5.0].map(|x: f64| (x, 3.0 * x * x)).to_vec();
        assert!((exponent(&square).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(exponent(&[(1.0, 2.0)]), None);
        assert_eq!([-0.002, 0.588].map(|value| format!("{:?}", hundredths(value))), ["0.0", "0.59"]);
    }
}
