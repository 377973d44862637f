//! Tests of `line`.

use super::*;

/// The gap between two digits 20 px high, from 10 to 20 px along their line, with these shapes among others.
fn gap(boxes: &[[PixelPoint; 2]]) -> Option<f32> {
    let digit = |of, along| RotatedLetter { of, along, across: [0.0, 20.0] };
    // digits, and a dot elsewhere
    let others = [[[0.0, 0.0], [10.0, 20.0]], [[20.0, 0.0], [30.0, 20.0]], [[40.0, 18.0], [42.0, 20.0]]];
    let small = SmallShapes::sorted(others.iter().chain(boxes).copied().collect());
    gap_at_point(&small, &digit(0, [0.0, 10.0]), &digit(1, [20.0, 30.0]), 20.0)
}

#[test]
fn the_gap_at_a_point_is_the_wider_one_beside_it() {
    let point = [[13.0, 18.0], [15.0, 20.0]];
    assert_eq!(gap(&[point]), Some(5.0));
    let comma = [[14.0, 18.0], [16.0, 23.0]];
    assert_eq!(gap(&[comma]), Some(4.0));
    // of several the first, in whatever order they were found
    assert_eq!(gap(&[point, [[17.0, 17.0], [18.0, 19.0]]]), Some(5.0));
    assert_eq!(gap(&[[[17.0, 19.0], [18.0, 21.0]], point]), Some(5.0));
}

#[test]
fn what_does_not_stand_on_the_line_of_digits_is_no_point() {
    assert_eq!(gap(&[]), None);
    for no_point in [
        [[14.0, 8.0], [16.0, 10.0]],
        [[14.0, 20.0], [16.0, 22.0]],
        [[14.0, 26.0], [16.0, 29.0]],
        [[14.0, 11.0], [16.0, 20.0]],
        [[9.0, 18.0], [12.0, 20.0]],
    ] {
        assert_eq!(gap(&[no_point]), None, "{no_point:?}");
    }
}
