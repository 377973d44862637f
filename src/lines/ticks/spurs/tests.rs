//! Tests of `spurs`.

use super::super::tests::{PARAMS, line};
use super::*;
use crate::units::MmPoint;

#[test]
fn a_tick_across_from_the_end_of_another_line_is_taken_and_the_others_stay() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    // an axis with ticks on its left, and the top of a bar that begins at it on its right
    let drawing = |bar: f32| {
        let mut lines: Vec<_> = [20.0, 40.0, 60.0, 80.0].map(|y| line((17.0, y), (20.0, y))).to_vec();
        lines.extend([line((20.0, 10.0), (20.0, 90.0)), line((20.0, bar), (40.0, bar))]);
        lines
    };
    let taken = |mut lines: Vec<Polyline<Vertex>>| -> Vec<f32> {
        let count = lines.len();
        let spurs = take(&mut lines, area, &PARAMS);
        assert_eq!(lines.len() + spurs.len(), count);
        spurs.iter().map(|spur| spur.vertices[0].at.y).collect()
    };
    assert_eq!(taken(drawing(60.0)), [60.0]);
    assert!(taken(drawing(50.0)).is_empty(), "the bar ends beside all of them");
    let mut bones = drawing(50.0);
    bones.extend([20.0, 40.0, 60.0, 80.0].map(|y| line((20.0, y), (23.0, y))));
    assert!(taken(bones).is_empty(), "halves of ticks across the axis");
    assert!(taken(drawing(60.0).split_off(2)).is_empty(), "two are no scale");
}
