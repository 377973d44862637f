//! Tests of `around`: a head of 12 px along u from -6 to 6.

use super::*;
use crate::geom::nearest_on_segment;
use crate::units::PxPoint;

const HEAD: Measures = Measures { length: 12.0, half_width: 5.0, shaft: 2.0 };

/// Whether one stroke leaves from the head, with its shaft and with lines.
fn leaves(lines: &[[[f32; 2]; 2]]) -> bool {
    let is_on = |u: f32, v: f32, [a, b]: [[f32; 2]; 2]| {
        let [at, a, b] = [[u, v], a, b].map(|[x, y]| PxPoint::new(x, y));
        nearest_on_segment(at, a, b).0 <= 1.0
    };
    let is_head = |u: f32, v: f32| (-6.0..=6.0).contains(&u) && v.abs() <= 5.0 / 12.0 * (6.0 - u);
    let shaft = [[-30.0, 0.0], [0.0, 0.0]];
    let is_ink = |u: f32, v: f32| is_head(u, v) || lines.iter().chain([&shaft]).any(|line| is_on(u, v, *line));
    one_stroke_leaves(|u, v| f32::from(u8::from(is_ink(u, v))), HEAD)
}

#[test]
fn a_curve_that_goes_on_from_a_sign_leaves_it_and_the_side_of_a_box_does_not() {
    assert!(leaves(&[[[0.0, 0.0], [20.0, 20.0]]]) && leaves(&[[[0.0, 0.0], [5.0, -30.0]]]));
    assert!(!leaves(&[]), "nothing before it");
    assert!(!leaves(&[[[6.0, -30.0], [6.0, 30.0]]]) && !leaves(&[[[-10.0, -24.0], [22.0, 24.0]]]), "a box");
    assert!(!leaves(&[[[6.0, 0.0], [26.0, 14.0]], [[6.0, 0.0], [26.0, -14.0]]]), "the corner of a rhombus");
    assert!(!leaves(&[[[14.0, -30.0], [14.0, 30.0]]]), "beyond a gap");
}
