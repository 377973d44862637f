//! Where a polyline joins lines that are drawn, and where it is too near to them.

use super::super::drawn::LineState;
use super::super::tests::{drawn, polyline};
use super::*;
use crate::lines::params::Params;
use crate::lines::vertex::FoundIn;

/// A line to be joined, from left to right.
const LINE: &[(f32, f32)] = &[(10.0, 50.0), (90.0, 50.0)];

/// In how many places a polyline has junctions with lines; at a vertex there may be several.
fn junctions(lines: &[&[(f32, f32)]], points: &[(f32, f32)], closed: bool) -> usize {
    let mut places: Vec<MmPoint> = Vec::new();
    for Junction { at, .. } in drawn(lines).passage(polyline(points, closed).view()).junctions {
        if places.iter().all(|place| (*place - at).length() > TOUCH) {
            places.push(at);
        }
    }
    places.len()
}

#[test]
fn a_polyline_joins_a_line_again_where_it_was_apart_from_it_between() {
    assert_eq!(junctions(&[LINE], &[(20.0, 70.0), (20.0, 20.0), (60.0, 20.0), (60.0, 70.0)], false), 2);
    assert_eq!(junctions(&[LINE], &[(20.0, 30.0), (40.0, 30.0), (40.0, 70.0), (20.0, 70.0)], true), 2, "a ring");
}

#[test]
fn one_that_keeps_beside_the_line_between_two_crossings_winds_round_it_and_joins_it_nowhere() {
    let along = [(20.0, 70.0), (20.0, 48.0), (40.0, 48.0), (40.0, 70.0)];
    assert_eq!(junctions(&[LINE], &along, false), 0);
}

#[test]
fn a_line_that_keeps_beside_the_polyline_between_two_crossings_winds_round_that() {
    // the same two with their parts exchanged
    let along: &[(f32, f32)] = &[(20.0, 70.0), (20.0, 48.0), (40.0, 48.0), (40.0, 70.0)];
    assert_eq!(junctions(&[along], LINE, false), 0);
}

#[test]
fn a_ring_on_a_stem_joins_the_line_that_crosses_the_stem_only_where_they_cross() {
    let ring = |x: f32| {
        [(50.0, 52.0), (50.0, 46.0), (x, 46.0), (x, 36.0), (50.0 + (50.0 - x), 36.0), (50.0 + (50.0 - x), 46.0)]
    };
    let states = |points: &[(f32, f32)]| {
        let line = polyline(&[(30.0, 50.0), (70.0, 50.0)], false);
        drawn(&[points]).states(&line).contains(&LineState::TooNear)
    };
    assert!(!states(&ring(50.0)[..2]), "the stem alone");
    assert!(states(&ring(43.0)), "the ring is 4 mm from the line");
}

#[test]
fn a_line_that_ends_hardly_beyond_another_neither_crosses_it_nor_ends_on_it() {
    let stem = |end: f32| [(50.0, 70.0), (50.0, end)];
    assert_eq!(junctions(&[&stem(48.0)], LINE, false), 1);
    assert_eq!(junctions(&[&stem(50.0 - 1.5 * TOUCH)], LINE, false), 0);
    assert_eq!(junctions(&[&stem(50.0 - 0.5 * TOUCH)], LINE, false), 1);
}

#[test]
fn the_legs_of_a_narrow_bar_join_its_axis_though_they_are_near_to_one_another() {
    let width = Params::TEST.max_clearance();
    assert_eq!(junctions(&[LINE], &[(30.0, 50.0), (30.0, 20.0), (30.0 + width, 20.0), (30.0 + width, 50.0)], false), 2);
}

#[test]
fn a_spike_over_a_line_is_no_crossing_and_one_through_it_is() {
    assert_eq!(junctions(&[LINE], &[(20.0, 70.0), (30.0, 49.9), (30.2, 70.0)], false), 0);
    assert_eq!(junctions(&[LINE], &[(20.0, 70.0), (30.0, 30.0)], false), 1);
}

#[test]
fn a_wheel_on_the_road_touches_it_and_a_ring_that_keeps_beside_a_line_does_not() {
    let params = Params { of_drawing: true, ..Params::TEST };
    let states = |radius: f32, above: f32, road: &[(f32, f32)]| {
        let mut lines = DrawnLines::new(crate::lines::tests::area(), &params);
        super::super::draw(polyline(road, false), &[], crate::lines::outlines::Rank::Ordinary, &mut lines);
        let turn = |k: u32| std::f32::consts::TAU * k as f32 / 80.0;
        let at = |k: u32| (50.0 + radius * turn(k).cos(), 50.0 - above - radius + radius * turn(k).sin());
        let mut ring = polyline(&(0..80).map(at).collect::<Vec<_>>(), true);
        ring.vertices.iter_mut().for_each(|vertex| vertex.source = FoundIn::Vector);
        lines.states(&ring).contains(&LineState::TooNear)
    };
    for above in [0.0, 0.1, 0.3, 0.6] {
        assert!(!states(13.0, above, LINE), "{above} mm above the road");
    }
    assert!(states(13.0, 2.0, LINE), "it is beside the road and does not touch it");
    assert!(states(2.0, 0.3, LINE), "no part of it is apart");
    assert!(states(40.0, 0.3, LINE), "it keeps beside the road for too long");
}
