//! Tests of `rows`.

use super::*;

#[test]
fn labels_stand_side_by_side_as_near_as_they_can() {
    let cases = [
        ([0.0, 10.0, 20.0], [0.0, 10.0, 20.0]),
        // the first two share what they lack; the third has room
        ([0.0, 4.0, 30.0], [-2.0, 6.0, 30.0]),
        // a pool that grows back over the one before it
        ([0.0, 8.0, 8.0], [-8.0 / 3.0, 16.0 / 3.0, 40.0 / 3.0]),
    ];
    for (wanted, placed) in cases {
        let starts = side_by_side(&wanted, &[8.0, 8.0, 8.0]);
        assert!(starts.iter().zip(&placed).all(|(start, at)| (start - at).abs() < 1e-4), "{starts:?}");
        assert_eq!(starts.len(), 3);
    }
}

#[test]
fn numbers_move_by_a_step_before_a_tick_is_in_the_cell_beside_them() {
    let order = |asides: [f32; 2]| -> Vec<[i32; 2]> {
        let offsets = both_ways(0, 3).map(|step| 2.5 * step as f32);
        let hundredths = |mm: f32| (100.0 * mm).round() as i32;
        with_blanks(offsets, asides).iter().map(|offset| [offset.mm, offset.aside].map(hundredths)).collect()
    };
    assert_eq!(order([1.75, 4.25])[..4], [[0, 425], [250, 425], [-250, 425], [0, 175]]);
    // on an embosser, and in print
    assert_eq!(order([1.75, 1.75])[..4], [[0, 175], [250, 175], [-250, 175], [0, 0]]);
    assert_eq!(order([0.0; 2])[..2], [[0, 0], [250, 0]]);
}
