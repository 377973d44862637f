//! Tests of `split`.

use super::super::tests::{drawn, polyline};
use super::*;

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
