//! Tests of `torn_lines`.

use super::*;
use crate::lines::{Height, Run};

fn stroke(from: (f32, f32), to: (f32, f32), strength: f32) -> Line {
    Line { strength, runs: vec![Run::stroke(1.0, vec![from.into(), to.into()])] }
}

/// Dots in steps of 2 mm.
fn row(from: (f32, f32), to: (f32, f32)) -> Line {
    let (from, to) = (MmPoint::from(from), MmPoint::from(to));
    let steps = ((to - from).length() / 2.0).round() as u32;
    let dots = (0..=steps).map(|step| from.lerp(to, step as f32 / steps as f32)).collect();
    Line { strength: 50.0, runs: vec![Run::dots(1.6, dots, Height::High)] }
}

#[test]
fn a_curve_of_which_dots_are_left_out_is_torn() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 120.0));
    let curve = stroke((10.0, 50.0), (90.0, 50.0), 50.0);
    let of = |line: &Line, pressed: &[Line], stand_for: &[Option<usize>]| {
        let torn = torn((std::slice::from_ref(line), &[0.8]), (pressed, stand_for), area, 2.0, 5.0);
        torn.iter().map(|of| (of.length.round(), of.extent.center().x.round())).collect::<Vec<_>>()
    };
    let [start, end] = [row((10.0, 50.0), (30.0, 50.0)), row((50.0, 50.0), (90.0, 50.0))];
    let whole = row((10.0, 50.0), (90.0, 50.0));
    assert!(of(&curve, std::slice::from_ref(&whole), &[Some(0)]).is_empty());
    assert_eq!(of(&curve, &[start.clone(), end.clone()], &[Some(0), Some(0)]), [(20.0, 40.0)]);
    let next = row((36.0, 50.0), (90.0, 50.0));
    assert!(of(&curve, &[start.clone(), next], &[Some(0), Some(0)]).is_empty(), "two dots are missing");
    // another line crosses it there, and has no part of it but the place where both meet
    let other = row((40.0, 20.0), (40.0, 80.0));
    let crossed = [start.clone(), end.clone(), other];
    assert_eq!(of(&curve, &crossed, &[Some(0), Some(0), None]), [(16.0, 40.0)]);
    let along = [start, end.clone(), row((30.0, 51.0), (50.0, 51.0))];
    assert!(of(&curve, &along, &[Some(0), Some(0), None]).is_empty(), "a line that runs along it stands for it");
    assert_eq!(of(&curve, std::slice::from_ref(&end), &[Some(0)]), [(40.0, 30.0)], "its end is missing");
    let strong = stroke((10.0, 90.0), (90.0, 90.0), 90.0);
    let weak = stroke((10.0, 50.0), (90.0, 50.0), 5.0);
    let both = [weak, strong];
    let pressed = [row((10.0, 50.0), (30.0, 50.0)), end];
    let torn = torn((&both, &[0.8, 0.8]), (&pressed, &[Some(0), Some(0)]), area, 2.0, 5.0);
    assert!(torn.is_empty(), "gridlines give way");
}

#[test]
fn the_end_of_a_line_that_meets_another_is_missed_sooner() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 120.0));
    let both = [stroke((10.0, 50.0), (90.0, 50.0), 50.0), stroke((90.0, 20.0), (90.0, 80.0), 50.0)];
    let of = |lines: &[Line], end: f32| {
        let pressed = [row((10.0, 50.0), (end, 50.0)), row((90.0, 20.0), (90.0, 80.0))];
        let stand_for = [Some(0), Some(1).filter(|_| lines.len() > 1)];
        torn((lines, &[0.9, 1.0][..lines.len()]), (&pressed, &stand_for), area, 2.0, 5.0).len()
    };
    assert_eq!(of(&both, 82.0), 1, "as the connector of a family tree before its box");
    assert_eq!(of(&both, 88.0), 0);
    assert_eq!(of(&both[..1], 82.0), 0, "an end that leads nowhere");
}
