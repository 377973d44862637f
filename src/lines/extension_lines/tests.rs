//! Tests of `extension_lines`.

use super::*;
use crate::units::{MmPoint, MmVector};

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

fn contour(points: &[(f32, f32)], closed: bool) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), ..Vertex::TEST };
    let mut line = Polyline { vertices: points.iter().map(vertex).collect(), closed };
    line.subdivide(0.5);
    line
}

/// How far a line from this place up to 20 mm is from a part whose upper left corner is at 40, 40 mm, where the head of
/// an arrow at this place points at it.
fn gap(x: f32, from: f32, head: (f32, f32), toward: (f32, f32)) -> f32 {
    let part = contour(&[(40.0, 40.0), (90.0, 40.0), (90.0, 70.0), (40.0, 70.0)], true);
    let mut polylines = vec![part, contour(&[(x, from), (x, 20.0)], false)];
    let head = HeadMark {
        at: head.into(),
        toward: MmVector::from(toward),
        extent: MmRect::zero(),
        strength: 30.0,
        shortened: 4.0,
        has_shaft: true,
        is_drawn: false,
    };
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    keep_apart(&mut polylines, &[head], area, &PARAMS);
    let ends = polylines[1].vertices.iter().map(|vertex| vertex.at.y);
    40.0 - ends.fold(0.0, f32::max)
}

#[test]
fn an_extension_line_begins_as_far_from_the_part_as_two_lines_are_apart() {
    let (head, left) = ((45.0, 24.0), (-1.0, 0.0));
    let clearance = PARAMS.max_clearance();
    assert!((clearance..clearance + 0.2).contains(&gap(40.0, 38.8, head, left)));
    let stays = |x: f32, from: f32, head: (f32, f32), toward: (f32, f32), why: &str| {
        let gap = gap(x, from, head, toward);
        assert!((gap - (40.0 - from)).abs() < 0.01, "{why}: {gap}");
    };
    stays(40.0, 40.0, head, left, "it touches the part");
    stays(40.0, 36.0, head, left, "there is no gap to be closed");
    stays(60.0, 38.8, (65.0, 24.0), left, "it does not lead to a corner");
    stays(40.0, 38.8, (45.0, 24.0), (1.0, 0.0), "no head points at it");
    stays(40.0, 38.8, (60.0, 24.0), left, "one that is far away does");
    stays(40.0, 38.8, (40.0, 30.0), (0.0, -1.0), "one that is its own");
    stays(40.0, 27.0, head, left, "it is farther");
}
