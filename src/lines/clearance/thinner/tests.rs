//! Tests of `thinner`.

use super::super::tests::{clear_all, polyline};
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::units::{MmPoint, MmRect};

/// Length and width of a line of a drawing between two others, each so far from it, mm; none if it is not drawn.
fn between(apart: f32) -> Option<(f32, f32)> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let upright = |x: f32, from: f32| (polyline(&[(x, from), (x, 90.0)], false), Rank::Ordinary);
    let lines = vec![upright(50.0 - apart, 10.0), upright(50.0 + apart, 10.0), upright(50.0, 30.0)];
    let cleared = clear_all(lines, area, &Params { of_drawing: true, ..Params::TEST });
    let line = cleared.into_iter().find(|line| (line.polyline.vertices[0].at.x - 50.0).abs() < 0.1)?;
    Some((line.polyline.length(), line.polyline.vertices[0].width))
}

#[test]
fn a_line_with_a_little_too_little_room_between_two_is_whole_and_thinner() {
    let (widest, thinnest) = (Params::TEST.width_max, Params::TEST.thin().width_max);
    let clearance = Params::TEST.max_clearance();
    let [wide, thin, gone] = [0.02, -0.05, -0.3].map(|more| between(clearance + more));
    assert!(wide.is_some_and(|(length, width)| length > 59.9 && width >= widest), "{wide:?}");
    let is_thinner = |width: f32| (thinnest..widest - 0.09).contains(&width);
    assert!(thin.is_some_and(|(length, width)| length > 59.9 && is_thinner(width)), "{thin:?}");
    assert_eq!(gone, None);
}
