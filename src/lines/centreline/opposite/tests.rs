//! Tests of `opposite`.

use super::super::testing::{area, bar, side, stroke};
use super::*;

fn of(lines: &[Polyline<Vertex>]) -> Vec<Opposites> {
    opposites(lines, area(), &Params::TEST)
}

fn none(opposites: &[Opposites]) -> bool {
    opposites.iter().flatten().all(Option::is_none)
}

#[test]
fn the_opposite_lies_straight_across_on_the_other_side() {
    let lines = stroke(3.0);
    let all = of(&lines);
    for (i, (vertex, opposite)) in lines[0].vertices.iter().zip(&all[0]).enumerate() {
        let is_beside = (20.0..=40.0).contains(&vertex.at.x);
        let Some(opposite) = opposite else {
            assert!(!is_beside, "vertex {i}");
            continue;
        };
        assert!(opposite.polyline == 1 && (opposite.at - MmPoint::new(vertex.at.x, 23.0)).length() < 0.01);
        assert!((lines[1].vertices[opposite.index].at - opposite.at).length() <= 0.21);
    }
    assert!(all[1].iter().flatten().count() >= 49 && all[1].iter().flatten().all(|other| other.polyline == 0));
}

#[test]
fn sides_too_far_apart_askew_or_with_the_same_step_are_none() {
    assert!(none(&of(&stroke(Params::TEST.max_spacing() + 0.1))));
    let above = side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0);
    assert!(none(&of(&[above.clone(), side(&[(20.0, 23.0), (40.0, 23.0)], false, 60.0)])), "steps up twice");
    let askew = side(&[(30.0, 22.0), (36.0, 28.0)], false, -60.0);
    assert!(none(&of(&[above.clone(), askew])), "45 degrees");
    let faint = side(&[(20.0, 23.0), (40.0, 23.0)], false, -15.0);
    assert!(none(&of(&[above, faint])), "a quarter of the step");
}

#[test]
fn a_ring_has_its_own_other_side_and_the_sides_of_a_sharp_corner_are_none() {
    let thin = of(&[bar(3.0, 0)]);
    assert!(thin[0].iter().flatten().count() > 180 && thin[0].iter().flatten().all(|other| other.polyline == 0));
    // 25 degrees
    assert!(none(&of(&[side(&[(10.0, 50.0), (60.0, 38.9), (60.0, 61.1)], true, 60.0)])));
}
