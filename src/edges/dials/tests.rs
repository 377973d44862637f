//! Tests of `dials`.

use super::*;
use crate::edges::contour::testing::{circle, polyline};
use crate::units::Size;

/// The rim of a dial around (50, 50).
fn rim() -> FoundContour {
    FoundContour::edge(circle(46.0))
}

/// White, with ink where this says so of a place, from the middle of the dial.
fn picture(is_ink: &dyn Fn(f32, f32) -> bool) -> Vec<Plane> {
    let size = Size::new(100, 100);
    let value = |cell: usize| {
        let (x, y) = ((cell % 100) as f32 + 0.5 - 50.0, (cell / 100) as f32 + 0.5 - 50.0);
        if is_ink(x, y) { 0.0 } else { 100.0 }
    };
    vec![Plane { size, values: (0..size.len()).map(value).collect() }]
}

/// The ends of the strokes from the middle of a dial, rounded, and how many contours there are in all.
fn hands_of(found: Vec<FoundContour>, is_ink: &dyn Fn(f32, f32) -> bool) -> (Vec<[i32; 2]>, usize) {
    let found = with_hands(found, &mut Vec::new(), &[], &picture(is_ink), &Params::default());
    let from_middle = |found: &&FoundContour| (found.contour.vertices[0].at - PxPoint::new(50.0, 50.0)).length() < 1.0;
    let tip = |found: &FoundContour| {
        let at = found.contour.vertices[found.contour.vertices.len() - 1].at;
        [at.x.round() as i32 - 50, at.y.round() as i32 - 50]
    };
    (found.iter().filter(from_middle).map(tip).collect(), found.len())
}

fn is_hub(x: f32, y: f32) -> bool {
    x.hypot(y) <= 4.5
}

/// A broad hand to the right, and a long one down that is pointed.
fn is_clock(x: f32, y: f32) -> bool {
    let right = (0.0..=20.0).contains(&x) && y.abs() <= 3.0;
    let down = (0.0..=32.0).contains(&y) && x.abs() <= 3.0 - 0.06 * y;
    is_hub(x, y) || right || down
}

#[test]
fn each_hand_of_a_clock_is_a_stroke_from_its_middle_and_no_outline() {
    let outline = polyline(&[(50.0, 47.0), (70.0, 47.0), (70.0, 53.0), (53.0, 53.0), (51.5, 82.0), (48.5, 82.0)]);
    let beside = polyline(&[(20.0, 25.0), (35.0, 25.0)]);
    let found = vec![rim(), FoundContour::edge(outline), FoundContour::edge(beside)];
    let (mut tips, count) = hands_of(found, &is_clock);
    tips.sort_unstable();
    let [down, right] = tips[..] else { panic!("{tips:?}") };
    let is_near = |[x, y]: [i32; 2], at: [i32; 2]| (x - at[0]).abs() <= 1 && (y - at[1]).abs() <= 1;
    assert!(is_near(down, [0, 32]) && is_near(right, [20, 0]), "{tips:?}");
    assert_eq!(count, 4, "the rim, both hands and what is beside them");
}

#[test]
fn spokes_blots_and_a_line_in_no_dial_are_no_hands() {
    let spokes = |x: f32, y: f32| is_hub(x, y) || x.abs() <= 1.5 && y.abs() <= 46.0;
    let blot = |x: f32, y: f32| x.hypot(y) <= 14.0;
    let bent = |x: f32, y: f32| is_hub(x, y) || (0.0..=16.0).contains(&x) && (y - 0.1 * x * x).abs() <= 3.0;
    for is_ink in [&spokes as &dyn Fn(f32, f32) -> bool, &blot, &bent] {
        assert_eq!(hands_of(vec![rim()], is_ink), (Vec::new(), 1));
    }
    let half = polyline(&[(4.0, 50.0), (50.0, 4.0), (96.0, 50.0)]);
    assert_eq!(hands_of(vec![FoundContour::edge(half)], &is_clock), (Vec::new(), 1));
}

#[test]
fn marks_of_one_kind_inside_of_the_rim_are_strokes() {
    // a broad mark at (50, 14), as a ring, turned by quarters
    let ring = |quarters: usize| {
        let turned = |(x, y): (f32, f32)| (0..quarters).fold((x - 50.0, y - 50.0), |(x, y), _| (-y, x));
        let corners = [(48.0, 10.0), (52.0, 10.0), (52.0, 18.0), (48.0, 18.0)].map(turned);
        let mut contour = polyline(&corners.map(|(x, y)| (x + 50.0, y + 50.0)));
        contour.closed = true;
        FoundContour::edge(contour)
    };
    let strokes = |count: usize| {
        let found = [rim()].into_iter().chain((0..count).map(ring)).collect();
        let found = with_hands(found, &mut Vec::new(), &[], &picture(&is_clock), &Params::default());
        found.iter().filter(|found| found.stroke.is_some()).count()
    };
    assert_eq!([strokes(3), strokes(4)], [2, 6], "two hands, and the marks where there are enough");
}
