//! Tests of `rings`.

use super::super::contour::ContourPoint;
use super::super::contour::testing::polyline;
use super::*;
use crate::units::PxPoint;
use std::f32::consts::TAU;

const LEAST: f32 = 8.0;

/// A leader that comes to a circle from the right and goes round it, as far as `round` of it.
fn leader(round: f32) -> FoundContour {
    let turn = |k: u16| f32::from(k) / 60.0 * TAU * round;
    let circle = (0..=60).map(turn).map(|angle| (100.0 + 40.0 * angle.cos(), 100.0 + 40.0 * angle.sin()));
    let points: Vec<(f32, f32)> = std::iter::once((200.0, 100.0)).chain(circle).collect();
    FoundContour { stroke: Some(2.0), ..FoundContour::edge(polyline(&points)) }
}

#[test]
fn a_circle_is_parted_from_its_leader_whichever_way_they_run() {
    let mut reversed = leader(0.98);
    reversed.contour.reverse();
    for found in [leader(1.0), leader(0.98), reversed] {
        let parts = split_at_contact(vec![found], LEAST);
        let [ring, lead] = &parts[..] else { panic!("{}", parts.len()) };
        assert!(ring.contour.closed && (ring.contour.length() - 40.0 * TAU).abs() < 4.0);
        assert!(!lead.contour.closed && (lead.contour.length() - 60.0).abs() < 4.0);
    }
}

#[test]
fn two_rings_are_parted_from_the_line_between_them() {
    let right = leader(1.0).contour.vertices;
    let left = right.iter().skip(1).map(|vertex| {
        let at = PxPoint::new(400.0 - vertex.at.x, vertex.at.y);
        ContourPoint { at, ..*vertex }
    });
    let contour = Polyline::open(left.rev().chain(right.iter().copied()).collect());
    let parts = split_at_contact(vec![FoundContour { stroke: Some(2.0), ..FoundContour::edge(contour) }], LEAST);
    let [first, second, lead] = &parts[..] else { panic!("{}", parts.len()) };
    assert!([first, second].iter().all(|ring| ring.contour.closed));
    assert!([first, second].iter().all(|ring| (ring.contour.length() - 40.0 * TAU).abs() < 4.0));
    assert!(!lead.contour.closed && (lead.contour.length() - 120.0).abs() < 4.0, "{}", lead.contour.length());
}

#[test]
fn a_line_that_ends_elsewhere_or_across_itself_stays_one() {
    let across = polyline(&[(200.0, 100.0), (100.0, 100.0), (100.0, 60.0), (150.0, 60.0), (150.0, 98.0)]);
    for found in [leader(0.8), FoundContour { stroke: Some(2.0), ..FoundContour::edge(across) }] {
        assert_eq!(split_at_contact(vec![found.clone()], LEAST), [found]);
    }
}
