//! Tests of `contrast`.

use super::*;

#[test]
fn each_plane_counts() {
    let is = |value: f32, expected: f32| assert!((value - expected).abs() < 1e-6, "{value} {expected}");
    let (a, b) = ([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]);
    is(dot(a, b), 12.0);
    is(dot(less(a, b), [1.0, 10.0, 100.0]), -233.0);
    is(square([2.0, 3.0, 6.0]), 49.0);
    is(length([2.0, 3.0, 6.0]), 7.0);
    is(distance([3.0, -1.0, 7.0], [1.0, 2.0, 1.0]), 7.0);
}
