//! Tests of `split`.

use super::super::draw;
use super::super::tests::{drawn, polyline};
use super::*;
use crate::lines::outlines::Rank;
use crate::lines::vertex::FoundIn;
use crate::units::{MmPoint, MmRect};

#[test]
#[expect(clippy::single_range_in_vec_init, reason = "lists of stretches, of which there may be one")]
fn stretches_end_where_a_near_one_has_something_too_near() {
    use LineState::{Free, Meets, TooNear};
    let all = |states: &[LineState]| clear_stretches(states);
    assert_eq!(all(&[Free, Free, Meets, TooNear, Meets, Free]), [0..2, 5..6]);
    assert_eq!(all(&[Meets, Free, Meets, Free]), [0..4], "junctions divide nothing");
    assert_eq!(all(&[TooNear, Free, TooNear]), [1..2]);
    assert_eq!(all(&[Free, Meets]), [0..2]);
    assert_eq!(all(&[TooNear]), []);
}

#[test]
fn an_axis_stays_where_bars_stand_on_it() {
    use LineState::{Free, Meets, TooNear};
    assert_eq!(apart_stretches(&[TooNear, Meets, Meets, TooNear, Free, Meets]), [1..3, 4..6]);
    assert_eq!(apart_stretches(&[TooNear]), []);
    // bars 9 mm apart, and what was drawn of the axis before them
    let legs: Vec<Vec<(f32, f32)>> =
        (0..5).map(|k| 20.0 + 9.0 * k as f32).map(|x| vec![(x, 20.0), (x, 50.0)]).collect();
    let before = vec![(5.0, 50.2), (17.0, 50.2)];
    let all: Vec<&[(f32, f32)]> = legs.iter().chain([&before]).map(Vec::as_slice).collect();
    let lines = drawn(&all);
    let axis = polyline(&[(14.0, 50.0), (62.0, 50.0)], false);
    let states = lines.states(&axis);
    assert!(states.contains(&LineState::TooNear));
    let mut stroke = axis;
    stroke.vertices.iter_mut().for_each(|vertex| vertex.contrast = [0.0; 3]);
    let pieces = split(&stroke, &states, PartEnds::AsCut, &lines);
    assert!(matches!(&pieces[..], [piece] if piece.length() > 38.0), "{pieces:?}");
}

#[test]
fn a_stub_beyond_a_crossing_goes() {
    let lines = drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]);
    let whole = polyline(&[(50.1, 10.1), (50.1, 52.0)], false);
    let shorter = without_stubs(&whole, &lines.passage(whole.view()), &lines).expect("2 mm beyond a line are a stub");
    assert!((shorter.length() - 39.9).abs() < 1e-3);
    let crossing = polyline(&[(50.1, 10.1), (50.1, 70.0)], false);
    assert_eq!(without_stubs(&crossing, &lines.passage(crossing.view()), &lines), None);
}

#[test]
fn what_is_left_of_a_line_ends_where_it_comes_near() {
    let lines = drawn(&[&[(40.0, 50.0), (60.0, 50.0)]]);
    let whole = polyline(&[(5.0, 52.0), (95.0, 52.0)], false);
    let pieces = split(&whole, &lines.states(&whole), PartEnds::Extended, &lines);
    assert_eq!(pieces.len(), 2);
    assert!(pieces.iter().all(|piece| piece.length() > 28.0 && piece.length() < 35.0));
    assert!(pieces.iter().all(|piece| !lines.states(piece).contains(&LineState::TooNear)));
}

#[test]
fn of_a_ring_that_is_mostly_too_near_nothing_is_left() {
    let lines = drawn(&[&[(30.0, 30.0), (70.0, 30.0), (70.0, 70.0), (30.0, 70.0)]]);
    let ring = polyline(&[(33.0, 33.0), (67.0, 33.0), (67.0, 67.0), (33.0, 67.0)], true);
    assert_eq!(split(&ring, &lines.states(&ring), PartEnds::Extended, &lines), []);
    let dot = polyline(&[(50.0, 31.0), (52.0, 31.0), (52.0, 33.0), (50.0, 33.0)], true);
    assert!(Params::TEST.is_dot(dot.length()));
    assert_eq!(split(&dot, &lines.states(&dot), PartEnds::Extended, &lines), []);
}

#[test]
fn of_a_line_that_is_near_everywhere_the_part_that_tells_most_stays() {
    let lines = [10.0, 40.0, 25.0].map(|length| polyline(&[(5.0, 5.0), (5.0 + length, 5.0)], false));
    let telling = |lines: &[Polyline<Vertex>], is_exact: bool| super::telling(lines.to_vec(), is_exact, &Params::TEST);
    assert_eq!(telling(&lines, false), [lines[1].clone()]);
    assert_eq!(telling(&[lines[0].clone(), lines[0].clone()], false).len(), 1);
    assert!(telling(&[], true).is_empty());
    let least = LONG * Params::TEST.min_length;
    let straight = |length: f32| polyline(&[(5.0, 5.0), (5.0 + length, 5.0)], false);
    let walls = [least + 1.0, least + 2.0, least - 1.0].map(straight);
    assert_eq!(telling(&walls, true), walls[..2], "both walls of a glass, and no stub");
}

#[test]
fn a_glass_keeps_both_walls_above_its_water() {
    let walls = |rim: f32| {
        let mut lines = DrawnLines::new(MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0)), &Params::TEST);
        let water = polyline(&[(43.0, 60.0), (157.0, 60.0), (157.0, 157.0), (43.0, 157.0)], true);
        draw(water, &[], Rank::Ordinary, &mut lines);
        let mut glass = polyline(&[(40.0, rim), (40.0, 160.0), (160.0, 160.0), (160.0, rim)], false);
        glass.vertices.iter_mut().for_each(|vertex| vertex.source = FoundIn::Vector);
        let pieces = split(&glass, &lines.states(&glass), PartEnds::AsCut, &lines);
        pieces.iter().map(|piece| piece.length().round()).collect::<Vec<f32>>()
    };
    assert!(matches!(walls(35.0)[..], [one, other] if one > 18.0 && other > 18.0), "{:?}", walls(35.0));
    assert_eq!(walls(42.0).len(), 1, "of two stubs one says where the glass was");
}

#[test]
fn a_tick_is_short_and_a_line_across_two_legs_of_another_is_none() {
    let params = Params { of_drawing: true, ..Params::TEST };
    let mut lines = DrawnLines::new(MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)), &params);
    let legs = polyline(&[(30.0, 20.0), (30.0, 80.0), (70.0, 80.0), (70.0, 20.0)], false);
    draw(legs, &[], Rank::Ordinary, &mut lines);
    let of = |from: f32, to: f32| {
        let line = polyline(&[(from, 40.1), (to, 40.1)], false);
        without_stubs(&line, &lines.passage(line.view()), &lines).map(|line| line.length())
    };
    assert!(of(28.0, 72.0).is_some_and(|length| (length - 40.0).abs() < 0.1), "{:?}", of(28.0, 72.0));
    assert_eq!(of(28.0, 32.0), None, "both stubs are the tick");
}
