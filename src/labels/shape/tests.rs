//! Tests of `shape`.

use super::*;
use crate::labels::Params;
use crate::page::{Line, Run};

/// Two shapes side by side, each 40 mm wide and 30 mm high: the first from 60, 100 on.
fn room() -> Room {
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|&at| MmPoint::from(at)).collect();
        Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] }
    };
    let around = [(60.0, 100.0), (140.0, 100.0), (140.0, 130.0), (60.0, 130.0), (60.0, 100.0)];
    let lines = [line(&around), line(&[(100.0, 100.0), (100.0, 130.0)])];
    Room::new(&lines, &[], &Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0))))
}

fn box_at(x: f32, y: f32, width: f32) -> MmRect {
    MmRect::new(MmPoint::new(x, y), MmPoint::new(x + width, y + 6.0))
}

#[test]
fn a_label_stands_before_the_shape_of_its_text() {
    let (room, text) = (room(), box_at(80.0, 86.0, 18.0));
    let mut shape = Shape::before(text, 12.0, &room).expect("the first shape");
    assert!((shape.gap - 7.5).abs() < 1.0 && shape.holds(MmPoint::new(70.0, 120.0), &room));
    assert!(!shape.holds(MmPoint::new(120.0, 104.0), &room), "the other shape");
    shape.look_around(text.center(), 50.0, &room);
    assert!(shape.is_nearest(box_at(70.0, 86.0, 28.0)));
    assert!(shape.is_nearest(box_at(74.0, 88.0, 38.0)), "its end reaches before the other, its middle does not");
    assert!(!shape.is_nearest(box_at(92.0, 86.0, 28.0)), "its middle stands before the other");
    assert!(!shape.is_nearest(box_at(110.0, 88.0, 20.0)), "before the other");
}

#[test]
fn a_text_far_away_or_inside_stands_before_no_shape() {
    let room = room();
    assert_eq!(Shape::before(box_at(80.0, 80.0, 18.0), 12.0, &room), None, "13 mm away");
    assert_eq!(Shape::before(box_at(70.0, 112.0, 18.0), 12.0, &room), None, "in the first");
}
