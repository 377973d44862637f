//! Tests of `vector`.

use resvg::tiny_skia::{Path, PathBuilder, Rect, Stroke};

use super::PaintedPath;

fn polygon(corners: &[[f32; 2]]) -> Path {
    let mut path = PathBuilder::new();
    corners.iter().enumerate().for_each(|(i, &[x, y])| if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) });
    path.close();
    path.finish().expect("it has sides")
}

fn circle() -> Path {
    PathBuilder::from_circle(20.0, 20.0, 10.0).expect("it has a radius")
}

fn stroked(path: Path, filled_alike: bool) -> PaintedPath {
    PaintedPath { stroke: Some(Stroke::default()), filled_alike, ..PaintedPath::filled(path) }
}

const LETTER_L: [[f32; 2]; 6] = [[0.0, 0.0], [3.0, 0.0], [3.0, 9.0], [8.0, 9.0], [8.0, 12.0], [0.0, 12.0]];
const TRIANGLE: [[f32; 2]; 3] = [[0.0, 0.0], [8.0, 3.0], [0.0, 6.0]];

#[test]
fn bars_and_dots_are_no_letters() {
    let bar = || PathBuilder::from_rect(Rect::from_xywh(3.0, 4.0, 5.0, 20.0).expect("it has sides"));
    for solid in [bar(), circle(), polygon(&TRIANGLE)] {
        assert!(!PaintedPath::filled(solid.clone()).may_be_letters(), "{solid:?}");
        assert!(!stroked(solid.clone(), true).may_be_letters(), "{solid:?} with a stroke of its own colour");
        assert!(stroked(solid.clone(), false).may_be_letters(), "the outline of {solid:?}");
    }
}

#[test]
fn circles_are_no_letters_wherever_they_lie() {
    for number in 0..400_u16 {
        let [x, y, radius] =
            [100.0 + 1.37 * f32::from(number), 80.0 + 0.77 * f32::from(number), 5.0 + 0.013 * f32::from(number)];
        let circle = PathBuilder::from_circle(x, y, radius).expect("it has a radius");
        assert!(!PaintedPath::filled(circle).may_be_letters(), "{x} {y} {radius}");
    }
}

#[test]
fn what_is_not_convex_and_what_has_several_parts_may_be_letters() {
    // five sides that turn the same way, twice around
    let star: Vec<[f32; 2]> = (0..5)
        .map(|i| {
            let (y, x) = (2.0 * std::f32::consts::TAU / 5.0 * i as f32).sin_cos();
            [20.0 + 10.0 * x, 20.0 + 10.0 * y]
        })
        .collect();
    let mut ring = PathBuilder::new();
    ring.push_path(&circle());
    ring.push_circle(20.0, 20.0, 6.0);
    for letter in [polygon(&LETTER_L), polygon(&star), ring.finish().expect("it has two parts")] {
        assert!(PaintedPath::filled(letter.clone()).may_be_letters(), "{letter:?}");
    }
}

#[test]
fn straight_strokes_are_no_letters() {
    let mut path = PathBuilder::new();
    for x in [0.0, 10.0, 20.0] {
        path.move_to(x, 0.0);
        path.line_to(x, 8.0);
    }
    assert!(!stroked(path.finish().expect("it has lines"), false).may_be_letters());
}
