//! Tests of `near_line`.

use super::*;

/// How far along both lines, and how far apart, they are near; mm.
type Place = ([f32; 2], f32);

/// Whether lines of a drawing join at a place, of which one ends where the other begins. The other is closed if it
/// has a length.
fn joins(([arc, line_arc], distance): Place, line_ring_length: Option<f32>) -> bool {
    let (at, along) = (MmPoint::zero(), MmVector::zero());
    let junction = Junction { arc: 0.0, at, line: 0, line_arc: 0.0, along, meeting: Meeting::PolylineEnds };
    let passage = Passage { arcs: Vec::new(), ring_length: None, junctions: vec![junction], clusters: Vec::new() };
    let near = NearLine {
        segment: &Segment { a: at, b: at, half_width: 0.5, line: 0, index: 0, arc: line_arc },
        at,
        away: along,
        distance,
        clearance: 4.0,
        missing: 4.0 - distance,
        line_arc,
        approach: 12.0,
        cluster_approach: 7.0,
        arc,
        passage: &passage,
        line_ring_length,
        of_drawing: true,
    };
    near.joins()
}

#[test]
fn lines_join_within_an_approach_of_their_junction() {
    assert!(joins(([10.0, 10.0], 3.5), None));
    assert!(!joins(([13.0, 13.0], 3.9), None), "it should be apart by now");
    assert!(!joins(([10.0, 10.0], 1.5), None), "it runs beside the line");
}

#[test]
fn what_is_near_round_a_bend_does_not_join_unless_it_is_of_a_ring() {
    let round_a_bend = ([10.0, 2.5 * 12.0], 3.5);
    assert!(!joins(round_a_bend, None));
    assert!(joins(round_a_bend, Some(200.0)));
}
