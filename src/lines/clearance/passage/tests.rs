//! Tests of `passage`.

use super::*;

/// A crossing with line 0 so far along the polyline and the line, to a side.
fn crossing(arc: f32, line_arc: f32, side: i8) -> Junction {
    let (at, along) = (MmPoint::new(arc, 0.0), MmVector::new(0.0, 1.0));
    Junction { arc, at, line: 0, line_arc, along, meeting: Meeting::Cross(side) }
}

#[test]
fn a_polyline_ends_on_a_line_that_it_touches() {
    let (a, b) = (MmPoint::new(10.0, 50.0), MmPoint::new(20.0, 50.0));
    let segment = Segment { a, b, half_width: 0.5, line: 3, index: 7, arc: 100.0 };
    let end = Junction::of_end(MmPoint::new(14.0, 50.0 + 0.9 * TOUCH), 25.0, &segment).expect("it is on the line");
    assert!(end.is_own_end() && end.line == 3 && (end.line_arc - 104.0).abs() < 1e-4);
    assert!((end.arc - 25.0).abs() < 1e-4 && end.along == MmVector::new(1.0, 0.0));
    assert!(Junction::of_end(MmPoint::new(14.0, 50.0 + 1.1 * TOUCH), 25.0, &segment).is_none());
}

#[test]
fn junctions_are_beside_one_another_if_they_are_so_on_both_lines() {
    let here = crossing(10.0, 40.0, 1);
    assert!(here.is_beside(&crossing(10.9, 39.1, -1)));
    assert!(!here.is_beside(&crossing(11.1, 40.0, -1)), "the polyline goes on for more");
    assert!(!here.is_beside(&crossing(10.0, 41.1, -1)), "so does the line");
    assert!(!here.is_beside(&Junction { line: 1, ..here }));
}

#[test]
fn round_a_ring_the_shorter_way_counts() {
    let passage = |ring_length| Passage { arcs: Vec::new(), ring_length, junctions: Vec::new(), clusters: Vec::new() };
    assert!((passage(None).between(2.0, 98.0) - 96.0).abs() < 1e-4);
    assert!((passage(Some(100.0)).between(2.0, 98.0) - 4.0).abs() < 1e-4);
    assert!((passage(Some(100.0)).between(30.0, 60.0) - 30.0).abs() < 1e-4);
}

#[test]
fn a_spike_crosses_nothing_and_a_way_there_and_back_crosses_twice() {
    let spike = [crossing(10.0, 40.0, 1), crossing(10.4, 40.1, -1)];
    assert_eq!(back_and_forth(&spike, None), [0, 1]);
    let apart = [crossing(10.0, 40.0, 1), crossing(20.0, 50.0, -1)];
    assert_eq!(back_and_forth(&apart, None), [0; 0]);
    let three = [crossing(10.0, 40.0, 1), crossing(10.4, 40.1, -1), crossing(10.8, 40.2, 1)];
    assert_eq!(back_and_forth(&three, None), [0; 0], "in the end it is on the other side");
    let of_two_lines = [crossing(10.0, 40.0, 1), Junction { line: 1, ..crossing(10.4, 40.1, -1) }];
    assert_eq!(back_and_forth(&of_two_lines, None), [0; 0]);
}

#[test]
fn a_spike_over_the_start_of_a_ring_is_one_too() {
    let spike = [crossing(0.3, 40.0, 1), crossing(50.0, 90.0, 1), crossing(99.6, 40.2, -1)];
    let mut found = back_and_forth(&spike, Some(100.0));
    found.sort_unstable();
    assert_eq!(found, [0, 2]);
    assert_eq!(back_and_forth(&spike, None), [0; 0], "an open line has no such place");
}

#[test]
fn a_crossing_at_a_vertex_counts_once_though_both_segments_have_it() {
    let twice = crossing(10.0, 40.0, 1);
    assert_eq!(back_and_forth(&[twice, twice, crossing(10.4, 40.1, -1)], None), [0, 1, 2]);
    assert_eq!(back_and_forth(&[twice, twice], None), [0; 0]);
}
