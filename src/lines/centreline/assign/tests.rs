//! Tests of `assign`.

use super::super::opposite::opposites;
use super::super::stretch::stretches;
use super::super::testing::{area, side, stroke};
use super::*;

fn of(lines: &[Polyline<Vertex>]) -> Vec<Assignment> {
    let opposites = opposites(lines, area(), &Params::TEST);
    assign(lines, &opposites, stretches(lines, &opposites), &Params::TEST)
}

fn removed(assignment: &Assignment) -> usize {
    assignment.removed.iter().filter(|removed| **removed).count()
}

#[test]
fn the_more_salient_side_moves_by_half_the_width_and_the_other_goes() {
    let lines = stroke(3.0);
    for turned in [false, true] {
        let mut lines = lines.clone();
        if turned {
            lines.reverse();
        }
        let assigned = of(&lines);
        let (stays, goes) = if turned { (&assigned[1], &assigned[0]) } else { (&assigned[0], &assigned[1]) };
        assert!(removed(stays) == 0 && removed(goes) == goes.removed.len());
        let moved: Vec<MmVector> = stays.offsets.iter().flatten().copied().collect();
        assert!(moved.len() >= 49 && moved.iter().all(|offset| (*offset - MmVector::new(0.0, 1.5)).length() < 0.01));
    }
}

#[test]
fn of_rings_in_one_another_one_stays_all_round() {
    let square =
        |low: f32, high: f32, step: f32| side(&[(low, low), (high, low), (high, high), (low, high)], true, step);
    let assigned = of(&[square(10.0, 50.0, 60.0), square(13.0, 47.0, -60.0)]);
    assert!(removed(&assigned[0]) == 0 && !is_rest(&assigned[0]));
    assert!(is_rest(&assigned[1]), "{} of {}", removed(&assigned[1]), assigned[1].removed.len());
}

#[test]
fn a_ring_that_is_a_side_of_a_stroke_on_its_lesser_part_stays_whole() {
    // far more salient than the ring
    let long = side(&[(5.0, 20.0), (95.0, 20.0)], false, 90.0);
    // 8 by 20 mm, with a short side beside the line: as far away as a ring can move, and nearer than that
    let beside = |gap: f32| {
        let (top, bottom) = (20.0 + gap, 40.0 + gap);
        side(&[(30.0, top), (38.0, top), (38.0, bottom), (30.0, bottom)], true, -60.0)
    };
    let removed_beside = |gap: f32| of(&[long.clone(), beside(gap)]).iter().map(removed).sum::<usize>();
    assert_eq!(removed_beside(3.5), 0);
    assert!(removed_beside(2.5) > 15, "{}", removed_beside(2.5));
}
