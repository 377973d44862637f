//! Tests of `ticks`.

use super::*;
use crate::lines::vertex::{FoundIn, SPACING};

pub(super) const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

pub(super) fn line(from: (f32, f32), to: (f32, f32)) -> Polyline<Vertex> {
    let vertex =
        |(x, y): (f32, f32)| Vertex { at: MmPoint::new(x, y), strength: 60.0, source: FoundIn::Vector, ..Vertex::TEST };
    let mut line = Polyline::open(vec![vertex(from), vertex(to)]);
    line.subdivide(SPACING);
    line
}

/// The lengths of ticks on an axis along y = 50, after they were made longer; `ticks` has their upper and lower
/// ends.
fn lengths(step: f32, ticks: &[(f32, f32)], more: Option<Polyline<Vertex>>) -> Vec<f32> {
    let tick = |(k, &(from, to)): (usize, &(f32, f32))| {
        let x = 20.0 + step * k as f32;
        line((x, from), (x, to))
    };
    let mut lines: Vec<_> = ticks.iter().enumerate().map(tick).collect();
    lines.push(line((10.0, 50.0), (90.0, 50.0)));
    lines.extend(more);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    lengthen(&mut lines, area, &PARAMS);
    lines[..ticks.len()].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect()
}

#[test]
fn ticks_across_a_line_and_on_it_are_longer_by_the_same() {
    assert_eq!(lengths(10.0, &[(47.0, 53.0), (46.5, 53.5), (47.0, 53.0)], None), [8.2, 9.2, 8.2]);
    assert_eq!(lengths(10.0, &[(47.6, 49.4), (47.0, 49.4), (47.6, 49.4)], None), [8.2, 8.8, 8.2], "both ends are near");
    // those that end at the side of a broad line are led on to its middle
    assert_eq!(lengths(10.0, &[(45.0, 49.0), (43.0, 49.0), (45.0, 49.0)], None), [8.2, 10.2, 8.2]);
}

#[test]
fn all_of_a_scale_or_none() {
    let ticks = [(47.0, 53.0); 3];
    assert_eq!(lengths(4.0, &ticks, None), [6.0; 3], "too near to one another");
    assert_eq!(lengths(10.0, &ticks[..2], None), [6.0; 2], "no scale");
    let beside = line((35.0, 57.0), (60.0, 57.0));
    assert_eq!(lengths(10.0, &ticks, Some(beside.clone())), [6.0; 3], "one is in the way of a line");
    assert_eq!(lengths(10.0, &[(47.0, 53.0); 5], Some(beside)), [6.0; 5], "two are");
    let head = line((62.0, 53.0), (70.0, 57.0));
    assert_eq!(lengths(10.0, &[(47.0, 53.0); 5], Some(head)), [8.2, 8.2, 8.2, 8.2, 6.0], "the last one is");
    assert_eq!(lengths(10.0, &[(60.0, 66.0); 3], None), [6.0; 3], "on no line");
}

#[test]
fn ticks_of_a_scale_are_taken_in_order_and_those_parted_by_a_point_are_one() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let mut lines = vec![
        line((60.0, 47.0), (60.0, 53.0)),
        line((20.0, 47.0), (20.0, 53.0)),
        // two halves of one, on both sides of the axis
        line((40.0, 47.0), (40.0, 50.0)),
        line((40.0, 53.0), (40.0, 50.0)),
        line((10.0, 50.0), (90.0, 50.0)),
    ];
    // the side of a box ends on another line
    lines.extend([line((70.0, 44.0), (70.0, 50.0)), line((65.0, 44.0), (78.0, 44.0))]);
    let scales = take(&mut lines, area, &PARAMS);
    let [scale] = &scales[..] else { panic!("{scales:?}") };
    let ticks: Vec<(f32, f32)> = scale.iter().map(|tick| (tick.at.x, tick.length())).collect();
    assert_eq!(ticks, [(20.0, 6.0), (40.0, 6.0), (60.0, 6.0)]);
    assert!(scale.iter().all(|tick| tick.ends[0].is_some_and(|end| end.y < 50.0)), "the same side is the left one");
    assert_eq!(lines.len(), 3, "the axis and the box");
}
