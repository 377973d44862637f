//! Tests of `plane`.

use super::*;

#[test]
fn a_blurred_constant_stays_and_a_blurred_point_keeps_its_sum() {
    let size = Size::new(31, 31);
    let flat = Plane::filled(size, 3.0).blurred(2.0);
    assert!(flat.values.iter().all(|v| (v - 3.0).abs() < 1e-5));
    let mut point = Plane::filled(size, 0.0);
    point.values[15 * 31 + 15] = 1.0;
    let sum: f32 = point.blurred(2.0).values.iter().sum();
    assert!((sum - 1.0).abs() < 1e-4);
}
