//! Tests of `displace`.

use super::super::tests::{drawn, polyline};
use super::*;

/// What becomes of a line among others.
fn moved(polyline: &Polyline<Vertex>, lines: &DrawnLines<'_>) -> Option<Polyline<Vertex>> {
    displaced(polyline, lines.passage(polyline.view()), lines)
}

#[test]
fn a_line_a_little_too_near_gives_way_and_its_far_parts_stay() {
    let lines = drawn(&[&[(10.0, 50.0), (30.0, 50.0)]]);
    // at 1.5 mm wide, lines must be 4.88 mm apart
    let near = polyline(&[(10.0, 54.5), (70.0, 54.5)], false);
    let away = moved(&near, &lines).expect("0.4 mm are little");
    assert!(drawn_apart(&away, &lines));
    assert!(away.vertices.iter().zip(&near.vertices).all(|(a, b)| (a.at - b.at).length() < FARTHEST));
    assert_eq!(away.vertices.last(), near.vertices.last());
}

#[test]
fn a_line_is_displaced_no_farther_in_two_rounds_than_in_one() {
    let near = polyline(&[(10.0, 54.5), (90.0, 54.5)], false);
    let once = moved(&near, &drawn(&[&[(10.0, 50.0), (90.0, 50.0)]])).expect("0.4 mm are little");
    // another line, 0.6 mm too near to where it is now
    let lines = drawn(&[&[(10.0, 50.6), (90.0, 50.6)]]);
    let unmoved = Polyline {
        vertices: once.vertices.iter().map(|vertex| Vertex { displaced: MmVector::zero(), ..*vertex }).collect(),
        closed: false,
    };
    assert!(moved(&unmoved, &lines).is_some(), "a line that lies there is displaced");
    assert_eq!(moved(&once, &lines), None, "1 mm in all");
}

fn drawn_apart(polyline: &Polyline<Vertex>, lines: &DrawnLines<'_>) -> bool {
    lines.states(polyline).iter().all(|state| *state != super::super::drawn::LineState::TooNear)
}

#[test]
fn a_line_much_too_near_does_not_give_way_but_a_ring_may_by_more() {
    let lines = drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]);
    assert_eq!(moved(&polyline(&[(10.0, 53.0), (90.0, 53.0)], false), &lines), None);
    let sides = [(40.0, 53.8), (60.0, 53.8), (60.0, 75.0), (40.0, 75.0)];
    assert_eq!(moved(&polyline(&sides[..2], false), &lines), None);
    let ring = moved(&polyline(&sides, true), &lines).expect("1.1 mm are little for a ring");
    assert!(ring.closed && drawn_apart(&ring, &lines));
}
