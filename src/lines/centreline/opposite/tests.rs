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
fn the_middle_of_a_stroke_is_no_side_and_hides_none() {
    let [above, below] = <[_; 2]>::try_from(stroke(3.0)).expect("two sides");
    let middle = side(&[(10.0, 21.0), (50.0, 21.0)], false, 0.0);
    let all = of(&[above, middle, below]);
    assert!(none(&all[1..2]));
    let others: Vec<usize> = all[0].iter().flatten().map(|other| other.polyline).collect();
    assert!(others.len() >= 49 && others.iter().all(|other| *other == 2));
}

#[test]
fn a_ring_has_its_own_other_side_and_the_sides_of_a_sharp_corner_are_none() {
    let thin = of(&[bar(3.0, 0)]);
    assert!(thin[0].iter().flatten().count() > 180 && thin[0].iter().flatten().all(|other| other.polyline == 0));
    // 25 degrees
    assert!(none(&of(&[side(&[(10.0, 50.0), (60.0, 38.9), (60.0, 61.1)], true, 60.0)])));
}

#[test]
fn of_lines_side_by_side_the_nearest_is_the_opposite_in_cells_of_any_side() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(10.0, 10.0));
    let level = |number: usize, apart: f32| {
        let y = 0.5 + apart * number as f32;
        side(&[(0.0, y), (10.0, y)], false, if number.is_multiple_of(2) { 60.0 } else { -60.0 })
    };
    for (count, apart, cell) in [(10, 0.9, CELL), (60, 0.15, CELL_OF_DENSE)] {
        let lines: Vec<Polyline<Vertex>> = (0..count).map(|number| level(number, apart)).collect();
        assert!((cell_of(&lines, area) - cell).abs() < 0.01, "{count}");
        for (number, of) in opposites(&lines, area, &Params::TEST).iter().enumerate() {
            for (vertex, opposite) in lines[number].vertices.iter().zip(of).skip(1).rev().skip(1) {
                let opposite = opposite.expect("lines on one side at least");
                assert!(opposite.polyline.abs_diff(number) == 1, "{number}: {}", opposite.polyline);
                assert!(((opposite.at - vertex.at).length() - apart).abs() < 0.01);
            }
        }
    }
}
