//! Tests of `order`.

use super::*;

#[test]
fn the_median_of_opposite_values_is_opposite() {
    for values in [&[0.5, -1.0, 2.0, 0.25][..], &[3.0, -1.0, 0.5], &[0.75, -2.0], &[]] {
        let sum = median(values.iter().copied()) + median(values.iter().map(|value| -value));
        assert!(sum.abs() < f32::EPSILON, "{values:?}");
    }
}

#[test]
fn the_value_in_the_middle_is_one_of_them_and_of_two_the_higher_one() {
    for (values, is) in [(&[3.0, 1.0, 2.0][..], 2.0), (&[4.0, 1.0, 3.0, 2.0], 3.0), (&[1.0, 2.0], 2.0), (&[], 0.0)] {
        assert!((middle(values.to_vec()) - is).abs() < f32::EPSILON, "{values:?}");
    }
}

#[test]
fn a_share_of_the_values_lies_below_a_quantile() {
    let values = sorted([3.0, 1.0, 4.0, 2.0].into_iter());
    let is = |share: f32, value: f32| (quantile(&values, share) - value).abs() < f32::EPSILON;
    assert!(is(0.0, 1.0) && is(0.25, 2.0) && is(0.75, 4.0), "{values:?}");
    assert!(quantile(&[], 0.5).abs() < f32::EPSILON);
}
