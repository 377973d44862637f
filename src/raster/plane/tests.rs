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

#[test]
fn values_at_several_positions_are_those_at_each() {
    for size in [Size::new(5, 4), Size::new(1, 4), Size::new(5, 1), Size::new(1, 1)] {
        let values = (0..size.len()).map(|i| (i * i % 7) as f32 / 3.0).collect();
        let plane = Plane { size, values };
        for k in 0..60 {
            let x = [-1.0, 0.2, 0.5, 1.7, 3.0].map(|x| x + k as f32 / 13.0);
            let y = [4.5, 0.3, 2.2, -0.5, 0.5].map(|y| y - k as f32 / 17.0);
            let one_by_one = [0, 1, 2, 3, 4].map(|i| plane.at(x[i], y[i]).to_bits());
            assert_eq!(plane.at_each(x, y).map(f32::to_bits), one_by_one, "{size:?} {x:?} {y:?}");
        }
    }
}
