//! Tests of `crossbars`.

use super::super::tests::{PARAMS, line};
use super::*;
use crate::lines::tests::area;
use crate::lines::{HeavyStrokes, LineMedium};

/// The lengths of the plates of a battery, in tenths of a mm, of which the short one is so long, and so far from
/// the long one.
fn plates(short: f32, apart: f32) -> [i32; 2] {
    plates_with(short, apart, &PARAMS)
}

fn plates_with(short: f32, apart: f32, params: &Params) -> [i32; 2] {
    let plate = |y: f32, length: f32| line((50.0 - 0.5 * length, y), (50.0 + 0.5 * length, y));
    let mut lines = vec![
        line((50.0, 10.0), (50.0, 40.0)),
        plate(40.0, 2.0 * short),
        plate(40.0 + apart, short),
        line((50.0, 40.0 + apart), (50.0, 90.0)),
    ];
    lengthen(&mut lines, area(), params);
    [1, 2].map(|plate| (10.0 * lines[plate].length()).round() as i32)
}

#[test]
fn a_short_plate_of_a_battery_is_drawn_longer_and_the_long_one_by_as_much() {
    assert_eq!(plates(6.0, 6.0), [142, 82]);
    assert_eq!(plates(9.0, 6.0), [180, 90], "it is long enough");
    assert_eq!(plates(6.0, 3.0), [120, 60], "too near to one another");
    assert_eq!(plates(1.4, 6.0), [28, 14], "crumbs");
}

/// Seven dots of an embosser are 12 mm long.
#[test]
fn on_a_grid_a_plate_is_as_long_as_a_row_has_to_be_wherever_it_lies() {
    let medium = LineMedium::Dots(HeavyStrokes { from: 50.0, width: 2.0 });
    let on_dots = Params { min_length: 12.5, medium, ..PARAMS };
    assert_eq!(plates_with(9.4, 6.0, &on_dots), [236, 142]);
    assert_eq!(plates_with(13.0, 6.0, &on_dots), [272, 142], "its row may be too short");
    assert_eq!(plates_with(14.2, 6.0, &on_dots), [284, 142]);
}

/// A wire through four plates, of which the second is longer than the third: with something in the way of the second
/// all of them stay, as that would be shorter than the third otherwise.
#[test]
fn of_plates_that_belong_together_all_are_longer_or_none() {
    let lengths = |beside: f32| -> Vec<i32> {
        let plate = |y: f32, length: f32| line((50.0 - 0.5 * length, y), (50.0 + 0.5 * length, y));
        let mut lines = vec![plate(36.0, 7.0), plate(30.0, 4.0), plate(44.5, 4.0), plate(50.0, 7.0)];
        lines.extend([line((50.0, 10.0), (50.0, 30.0)), line((50.0, 36.0), (50.0, 44.5))]);
        lines.extend([line((50.0, 50.0), (50.0, 90.0)), line((beside, 36.0), (95.0, 36.0))]);
        lengthen(&mut lines, area(), &PARAMS);
        lines[..4].iter().map(|plate| (10.0 * plate.length()).round() as i32).collect()
    };
    assert_eq!(lengths(65.0), [112, 82, 82, 112]);
    assert_eq!(lengths(59.0), [70, 40, 40, 70]);
}

#[test]
fn the_last_tick_of_a_scale_is_none() {
    let mut lines = vec![line((10.0, 50.0), (90.0, 50.0))];
    lines.extend([10.0, 30.0, 50.0, 70.0, 90.0].map(|x| line((x, 47.0), (x, 53.0))));
    lengthen(&mut lines, area(), &PARAMS);
    assert!(lines[1..].iter().all(|tick| (tick.length() - 6.0).abs() < 0.01));
}
