//! Tests of `cut_out`.

use super::*;

const SIZE: Size = Size::new(400, 300);

/// Sides of a thing (left, top, right, bottom), and its level at a place.
type Thing<'a> = ([usize; 4], &'a dyn Fn(usize, usize) -> f32);

/// A white picture with things on it.
fn picture(things: &[Thing<'_>]) -> Raster {
    let width = SIZE.width as usize;
    let level = |i: usize| {
        let (x, y) = (i % width, i / width);
        let on = things
            .iter()
            .find(|([left, top, right, bottom], _)| (*left..*right).contains(&x) && (*top..*bottom).contains(&y));
        on.map_or(1.0, |(_, level)| level(x, y))
    };
    Raster::grey(SIZE, (0..SIZE.len()).map(level).collect())
}

/// Soft shading all over, as of fur.
fn fur(x: usize, y: usize) -> f32 {
    0.4 + 0.06 * ((x as f32) / 5.0).sin() + 0.06 * ((y as f32) / 7.0).cos()
}

#[test]
fn a_thing_that_is_flat_nowhere_is_a_photograph() {
    assert!(is_cut_out(&picture(&[([120, 80, 280, 220], &fur)])));
}

#[test]
fn areas_of_one_colour_and_strokes_are_a_drawing() {
    let even = |_: usize, _: usize| 0.4;
    assert!(!is_cut_out(&picture(&[([120, 80, 280, 220], &even)])));
    let strokes = |x: usize, _: usize| if x % 12 < 3 { 0.1 } else { 1.0 };
    assert!(!is_cut_out(&picture(&[([120, 80, 280, 220], &strokes)])), "a hatched area");
    assert!(!is_cut_out(&picture(&[])), "nothing but ground");
}

#[test]
fn strokes_that_fill_two_rows_of_squares_by_half_are_a_drawing() {
    let black = |_: usize, _: usize| 0.0_f32;
    let axes: Vec<Thing<'_>> = (0..12).map(|i| ([20, 18 + 20 * i, 380, 22 + 20 * i], &black as _)).collect();
    assert!(!is_cut_out(&picture(&axes)));
}

#[test]
fn a_photograph_beside_as_much_of_a_drawing_is_a_drawing() {
    let even = |_: usize, _: usize| 0.2;
    assert!(!is_cut_out(&picture(&[([20, 80, 180, 220], &fur), ([220, 80, 380, 220], &even)])));
}

#[test]
fn a_speck_tells_nothing() {
    assert!(!is_cut_out(&picture(&[([180, 140, 204, 164], &fur)])));
}

#[test]
fn pale_strokes_are_a_drawing_as_well() {
    let pale = |_: usize, _: usize| 0.8_f32;
    let curves: Vec<Thing<'_>> = (0..12).map(|i| ([20, 19 + 20 * i, 380, 20 + 20 * i], &pale as _)).collect();
    assert!(!is_cut_out(&picture(&curves)));
}
