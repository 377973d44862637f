//! Tests of `bases`.

use super::super::lengthen;
use super::super::tests::{PARAMS, line};
use super::*;

/// A number line, the middle of which lies under an interval of another colour: that parts the ticks which it crosses.
#[test]
fn ticks_of_an_axis_in_pieces_are_one_scale() {
    let mut lines = vec![
        line((5.0, 50.0), (30.0, 50.0)),
        line((30.0, 50.0), (70.0, 50.0)),
        line((70.0, 50.0), (95.0, 50.0)),
        line((20.0, 47.0), (20.0, 53.0)),
        line((80.0, 47.0), (80.0, 53.0)),
    ];
    for x in [40.0, 60.0] {
        lines.extend([line((x, 47.0), (x, 49.3)), line((x, 53.0), (x, 50.7))]);
    }
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    lengthen(&mut lines, &[], area, &PARAMS);
    let ticks: Vec<f32> = lines[3..].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect();
    assert_eq!(ticks, [8.2; 4], "two of them of halves");
    let pieces = first_pieces(0..3, &lines, area);
    assert_eq!(pieces.into_values().collect::<Vec<_>>(), [0, 0, 0]);
}

#[test]
fn lines_that_meet_at_a_corner_or_lie_side_by_side_are_no_pieces_of_one() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let lines = [
        line((10.0, 50.0), (50.0, 50.0)),
        line((50.0, 50.0), (50.0, 10.0)),
        line((10.0, 52.0), (50.0, 52.0)),
        line((56.0, 50.0), (90.0, 50.0)),
    ];
    assert_eq!(first_pieces(0..4, &lines, area).into_values().collect::<Vec<_>>(), [0, 1, 2, 3]);
}
