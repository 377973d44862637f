//! Tests of `crossbars`.

use super::super::tests::{PARAMS, line};
use super::*;
use crate::lines::tests::area;

/// The lengths of the plates of a battery, in tenths of a mm, of which the short one is so long, and so far from
/// the long one.
fn plates(short: f32, apart: f32) -> [i32; 2] {
    let plate = |y: f32, length: f32| line((50.0 - 0.5 * length, y), (50.0 + 0.5 * length, y));
    let mut lines = vec![
        line((50.0, 10.0), (50.0, 40.0)),
        plate(40.0, 2.0 * short),
        plate(40.0 + apart, short),
        line((50.0, 40.0 + apart), (50.0, 90.0)),
    ];
    lengthen(&mut lines, area(), &PARAMS);
    [1, 2].map(|plate| (10.0 * lines[plate].length()).round() as i32)
}

#[test]
fn a_short_plate_of_a_battery_is_drawn_longer_and_the_long_one_by_as_much() {
    assert_eq!(plates(6.0, 6.0), [142, 82]);
    assert_eq!(plates(9.0, 6.0), [180, 90], "it is long enough");
    assert_eq!(plates(6.0, 3.0), [120, 60], "too near to one another");
    assert_eq!(plates(1.4, 6.0), [28, 14], "crumbs");
}

#[test]
fn the_last_tick_of_a_scale_is_none() {
    let mut lines = vec![line((10.0, 50.0), (90.0, 50.0))];
    lines.extend([10.0, 30.0, 50.0, 70.0, 90.0].map(|x| line((x, 47.0), (x, 53.0))));
    lengthen(&mut lines, area(), &PARAMS);
    assert!(lines[1..].iter().all(|tick| (tick.length() - 6.0).abs() < 0.01));
}
