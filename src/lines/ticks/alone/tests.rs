//! Tests of `alone`.

use super::super::tests::{PARAMS, line};
use super::*;
use crate::lines::tests::area;

/// The lengths of two strokes, the second so far right of the first, in tenths of a mm.
fn strokes(first: f32, second: f32, apart: f32) -> [i32; 2] {
    let upright = |x: f32, length: f32| line((x, 50.0 - 0.5 * length), (x, 50.0 + 0.5 * length));
    let mut lines = vec![upright(40.0, first), upright(40.0 + apart, second)];
    lengthen(&mut lines, area(), &PARAMS);
    [0, 1].map(|number| (10.0 * lines[number].length()).round() as i32)
}

#[test]
fn strokes_that_stand_alone_are_as_long_as_a_line() {
    assert_eq!(strokes(7.0, 5.0, 10.0), [82, 82]);
    assert_eq!(strokes(7.0, 3.0, 10.0), [82, 30], "a crumb");
    assert_eq!(strokes(7.0, 12.0, 10.0), [82, 120], "long enough");
    assert_eq!(strokes(7.0, 7.0, 4.0), [70, 70], "too near to one another");
}

#[test]
fn a_stroke_beside_a_line_is_drawn_longer_away_from_it() {
    let mut lines = vec![line((10.0, 50.0), (90.0, 50.0)), line((40.0, 44.8), (40.0, 38.8))];
    lengthen(&mut lines, area(), &PARAMS);
    let ends = [0, lines[1].vertices.len() - 1].map(|end| (10.0 * lines[1].vertices[end].at.y).round() as i32);
    assert_eq!(ends, [448, 366]);
}

#[test]
fn a_plus_sign_stays_one() {
    let mut lines = vec![line((40.0, 50.0), (47.0, 50.0)), line((43.5, 46.5), (43.5, 53.5))];
    lengthen(&mut lines, area(), &PARAMS);
    assert!(lines.iter().all(|line| (line.length() - 7.0).abs() < 1e-3));
}

/// Where two strokes on one upright line end that begin at these heights and are 6 mm long, in tenths of a mm.
fn ends_of(begin: [f32; 2]) -> [[i32; 2]; 2] {
    let mut lines: Vec<Polyline<Vertex>> = begin.map(|y| line((40.0, y), (40.0, y + 6.0))).into();
    lengthen(&mut lines, area(), &PARAMS);
    [0, 1].map(|number| {
        let vertices = &lines[number].vertices;
        [0, vertices.len() - 1].map(|end| (10.0 * vertices[end].at.y).round() as i32)
    })
}

#[test]
fn a_stroke_at_the_border_is_drawn_longer_away_from_it() {
    assert_eq!(ends_of([1.0, 93.0]), [[10, 92], [908, 990]]);
    assert_eq!(ends_of([20.0, 60.0]), [[189, 271], [589, 671]], "in the middle of the area, about their middles");
}

#[test]
fn a_stroke_keeps_clear_of_one_that_was_drawn_longer_before_it() {
    let clearance = PARAMS.max_clearance();
    // each is led on by 1.1 mm at both ends, and one alone has room for that
    let second = 36.0 + clearance + 1.6;
    let tenths = |y: f32| (10.0 * y).round() as i32;
    assert_eq!(ends_of([30.0, second]), [[289, 371], [tenths(second), tenths(second + 8.2)]]);
}
