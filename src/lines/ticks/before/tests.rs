//! Tests of `before`.

use super::*;

/// The place on a circle at this many degrees, and the way to its middle.
fn place(degrees: f32) -> (MmPoint, MmVector) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (MmPoint::new(50.0 + 40.0 * cos, 50.0 + 40.0 * sin), MmVector::new(-cos, -sin))
}

/// Which of the strokes in a circle are ticks; each is at so many degrees, and so far from the circle.
fn check(strokes: &[(f32, f32)]) -> Vec<bool> {
    let stroke = |&(degrees, gap): &(f32, f32)| {
        let (foot, way) = place(degrees);
        StrokeBefore { base: 7, gap, foot, arc: 40.0 * degrees.to_radians(), way }
    };
    are_ticks(&strokes.iter().map(stroke).collect::<Vec<_>>())
}

#[test]
fn strokes_evenly_before_a_circle_are_ticks_in_any_order() {
    assert_eq!(check(&[(90.0, 3.0), (30.0, 3.2), (120.0, 2.9), (60.0, 3.0)]), [true; 4]);
    assert_eq!(check(&[(30.0, 3.0), (60.0, 3.0), (90.0, 3.0)]), [false; 3], "three are too few");
    assert_eq!(check(&[(30.0, 3.0), (60.0, 3.0), (92.0, 3.0), (160.0, 3.0)]), [false; 4], "not evenly");
    assert_eq!(check(&[(30.0, 3.0), (60.0, 4.2), (90.0, 3.0), (120.0, 4.2)]), [false; 4], "not as far");
    assert_eq!(check(&[(30.0, 3.0); 5]), [false; 5], "all at one place");
}

#[test]
fn a_stroke_at_another_distance_or_a_missing_one_leaves_the_others_a_scale() {
    let mut strokes: Vec<(f32, f32)> = (0..10).map(|k| (6.0 * k as f32, 3.0)).collect();
    strokes[4].1 = 4.5;
    let are_ticks = check(&strokes);
    assert_eq!(are_ticks.iter().position(|is_tick| !is_tick), Some(4));
    assert_eq!(are_ticks.iter().filter(|is_tick| **is_tick).count(), 9);
}

#[test]
fn strokes_before_a_straight_line_are_no_ticks_as_they_may_be_a_tally() {
    let stroke = |k: usize| {
        let at = 6.0 * k as f32;
        StrokeBefore { base: 0, gap: 3.0, foot: MmPoint::new(at, 0.0), arc: at, way: MmVector::new(0.0, 1.0) }
    };
    assert_eq!(are_ticks(&(0..8).map(stroke).collect::<Vec<_>>()), [false; 8]);
}

#[test]
fn strokes_before_two_lines_are_two_scales() {
    let stroke = |k: usize| {
        let (foot, way) = place(20.0 * (k / 2) as f32);
        StrokeBefore { base: k % 2, gap: 3.0 + (k % 2) as f32, foot, arc: (k / 2) as f32, way }
    };
    assert_eq!(are_ticks(&(0..8).map(stroke).collect::<Vec<_>>()), [true; 8]);
    assert_eq!(are_ticks(&(0..6).map(stroke).collect::<Vec<_>>()), [false; 6]);
}
