//! Lines that give way to others, and how far.

use super::super::passage::Meeting;
use super::*;
use crate::lines::vertex::FoundIn;
use crate::units::MmPoint;

fn polyline(points: &[[f32; 2]], closed: bool) -> Polyline<Vertex> {
    let vertex = |&[x, y]: &[f32; 2]| Vertex {
        at: MmPoint::new(x, y),
        strength: 10.0,
        width: 1.0,
        source: FoundIn::Vector,
        ..Vertex::TEST
    };
    Polyline { closed, vertices: points.iter().map(vertex).collect() }
}

fn passage(polyline: &Polyline<Vertex>, junctions: Vec<Junction>) -> Passage {
    let mut arcs = vec![0.0];
    for (a, b) in polyline.segments() {
        arcs.push(arcs[arcs.len() - 1] + (b.at - a.at).length());
    }
    let ring_length = polyline.closed.then(|| arcs[arcs.len() - 1]);
    Passage { arcs, ring_length, junctions, clusters: Vec::new() }
}

/// A junction at an arc, with a line of this direction.
fn junction(arc: f32, along: [f32; 2], meeting: Meeting) -> Junction {
    Junction { arc, at: MmPoint::zero(), line: 0, line_arc: 0.0, along: along.into(), meeting }
}

/// A straight line along x with a vertex each millimetre, from 0 to 20.
fn straight() -> Polyline<Vertex> {
    polyline(&std::array::from_fn::<_, 21, _>(|i| [i as f32, 0.0]), false)
}

/// No push but one.
fn pushed(count: usize, at: usize, push: [f32; 2]) -> Vec<MmVector> {
    (0..count).map(|i| if i == at { push.into() } else { MmVector::zero() }).collect()
}

fn is_near(a: MmVector, [x, y]: [f32; 2]) -> bool {
    (a - MmVector::new(x, y)).length() < 1e-3
}

#[test]
fn a_push_fades_along_a_curve() {
    let line = straight();
    let shifts = shifts_of_curve(&pushed(21, 10, [0.0, 1.0]), &passage(&line, Vec::new()));
    for (i, shift) in shifts.iter().enumerate() {
        let expected = (1.0 - (i as f32 - 10.0).abs() / FADE).max(0.0);
        assert!(is_near(*shift, [0.0, expected]), "{i}: {shift:?}");
    }
}

#[test]
fn a_push_fades_over_the_start_of_a_ring() {
    let ring: Vec<[f32; 2]> = (0..40).map(|i| (i as f32 * 0.157).sin_cos()).map(|(y, x)| [6.4 * x, 6.4 * y]).collect();
    let ring = polyline(&ring, true);
    let shifts = shifts_of_curve(&pushed(40, 0, [1.0, 0.0]), &passage(&ring, Vec::new()));
    for i in 1..8 {
        assert!((shifts[i] - shifts[40 - i]).length() < 0.02, "{i}: {:?} and {:?}", shifts[i], shifts[40 - i]);
    }
    assert!(shifts[1].x > 0.8 && shifts[20] == MmVector::zero());
}

#[test]
fn near_a_junction_a_line_stays() {
    let line = straight();
    let junctions = vec![junction(10.0, [0.0, 1.0], Meeting::Cross(1))];
    let shifts = shifts_of_curve(&pushed(21, 8, [0.0, 1.0]), &passage(&line, junctions));
    assert_eq!(shifts[10], MmVector::zero());
    assert!(shifts[7].y > shifts[9].y, "{:?} and {:?}", shifts[7], shifts[9]);
}

#[test]
fn a_straight_stretch_moves_as_a_whole_and_its_corner_with_it() {
    let angle = polyline(&[[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, 5.0], [10.0, 10.0]], false);
    let shifts = shifts_of_drawing(&angle, &pushed(5, 1, [0.3, 1.0]), &passage(&angle, Vec::new()));
    // across the stretch only, the corner along the other side, whose far end stays
    for (i, expected) in [[0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 0.5], [0.0, 0.0]].into_iter().enumerate() {
        assert!(is_near(shifts[i], expected), "{i}: {:?}", shifts[i]);
    }
}

#[test]
fn pushed_to_both_sides_it_goes_between() {
    let line = straight();
    let mut pushes = pushed(21, 4, [0.0, 1.0]);
    pushes[16] = MmVector::new(0.0, -0.4);
    let shifts = shifts_of_drawing(&line, &pushes, &passage(&line, Vec::new()));
    assert!(shifts.iter().all(|shift| is_near(*shift, [0.0, 0.6])), "{shifts:?}");
}

#[test]
fn an_end_slides_along_the_line_that_it_lies_on() {
    let line = straight();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let ends = |along| vec![junction(20.0, along, Meeting::PolylineEnds)];
    let last = |along| shifts_of_drawing(&line, &pushed(21, 10, [0.0, 1.0]), &passage(&line, ends(along)))[20];
    assert!(is_near(last([half, half]), [1.0, 1.0]));
    // on a line of nearly its own direction it would slide far away
    assert_eq!(last([0.98, 0.2]), MmVector::zero());
}

#[test]
fn what_carries_the_end_of_another_line_stays() {
    let line = straight();
    let junctions = vec![junction(10.0, [0.0, 0.0], Meeting::LineEnds)];
    let shifts = shifts_of_drawing(&line, &pushed(21, 4, [0.0, 1.0]), &passage(&line, junctions));
    assert!(shifts.iter().all(|shift| *shift == MmVector::zero()), "{shifts:?}");
}
