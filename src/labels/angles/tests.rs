//! Tests of `angles`.

use super::*;
use crate::page::Run;

fn line(points: &[(f32, f32)]) -> Line {
    let points: Vec<MmPoint> = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    Line { strength: 1.0, runs: vec![Run::stroke(1.0, points)] }
}

fn around(x: f32, y: f32, lines: &[Line]) -> Option<(f32, f32)> {
    Angle::around(MmPoint::new(x, y), &of(lines)).map(|angle| (angle.vertex.x.round(), angle.vertex.y.round()))
}

#[test]
fn texts_stand_in_the_angles_of_a_triangle_and_not_outside() {
    let triangle = [line(&[(20.0, 100.0), (120.0, 100.0), (50.0, 30.0), (20.0, 100.0)])];
    assert_eq!(of(&triangle).len(), 3);
    assert_eq!(around(32.0, 95.0, &triangle), Some((20.0, 100.0)));
    assert_eq!(around(52.0, 45.0, &triangle), Some((50.0, 30.0)));
    assert_eq!(around(32.0, 105.0, &triangle), None, "below its side");
    assert_eq!(around(60.0, 75.0, &triangle), None, "in the middle of it");
    let angle = Angle::around(MmPoint::new(32.0, 95.0), &of(&triangle)).expect("an angle");
    let place = |x: f32, y: f32| MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 10.0, y + 6.0));
    assert!(angle.holds_box(place(45.0, 90.0)) && !angle.holds_box(place(45.0, 98.0)));
}

#[test]
fn letters_and_sizes_name_angles_and_words_and_bare_numbers_do_not() {
    for name in ["a", "β", "C'", "b1", "35°", "62.5°", "?"] {
        assert!(is_name(name), "{name}");
    }
    for other in ["pond", "35", "0 €", "x = ?", "to", "9 cm", ""] {
        assert!(!is_name(other), "{other}");
    }
}

#[test]
fn lines_that_cross_have_four_angles_and_ticks_none() {
    let cross = [line(&[(20.0, 20.0), (80.0, 80.0)]), line(&[(20.0, 80.0), (80.0, 20.0)])];
    assert_eq!(of(&cross).len(), 4);
    assert_eq!(around(50.0, 40.0, &cross), Some((50.0, 50.0)));
    let axis = [line(&[(20.0, 50.0), (80.0, 50.0)]), line(&[(50.0, 47.0), (50.0, 53.0)])];
    assert!(of(&axis).is_empty());
}
