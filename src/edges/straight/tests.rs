//! Straight strokes and edges, and where they are put together again.

use super::super::contour::{Contour, ContourPoint};
use super::*;
use crate::units::PxPoint;

const SIGMA: f32 = 1.8;
const LEAST: f32 = 8.0;

/// A stroke 2 px wide through some points, with a vertex on every pixel.
fn stroke(corners: &[(f32, f32)], closed: bool) -> FoundContour {
    let point = |&(x, y): &(f32, f32)| ContourPoint {
        at: PxPoint::new(x, y),
        strength: 1.0,
        contrast: [0.0; 3],
        blur: 1.0,
        position_sigma: 0.1,
    };
    let mut contour = Polyline { vertices: corners.iter().map(point).collect(), closed };
    contour.subdivide(1.0);
    FoundContour { stroke: Some(2.0), ..FoundContour::edge(contour) }
}

fn wall() -> FoundContour {
    stroke(&[(20.0, 50.0), (80.0, 50.0), (80.0, 90.0), (20.0, 90.0)], true)
}

fn eaves(y: f32) -> [FoundContour; 2] {
    [stroke(&[(0.0, y), (15.0, y)], false), stroke(&[(85.0, y), (98.0, y)], false)]
}

fn is_near(contour: &Contour, x: f32, y: f32) -> bool {
    contour.vertices.iter().any(|vertex| (vertex.at - PxPoint::new(x, y)).length() < 0.6)
}

#[test]
fn a_roof_gets_its_base_line_back_from_the_wall() {
    let roof = stroke(&[(15.0, 50.0), (5.0, 50.0), (50.0, 20.0), (95.0, 50.0), (85.0, 50.0)], false);
    let found = reassign_sides(vec![wall(), roof], SIGMA, LEAST);
    let (rings, open): (Vec<_>, Vec<_>) = found.iter().partition(|found| found.contour.closed);
    let ([roof], [wall]) = (&rings[..], &open[..]) else { panic!("a ring and an open line: {found:?}") };
    assert!(is_near(&roof.contour, 50.0, 50.0) && !is_near(&wall.contour, 50.0, 50.0));
    assert!((roof.contour.length() - (90.0 + 2.0 * 54.08)).abs() < 1.0, "{}", roof.contour.length());
    assert!((wall.contour.length() - 140.0).abs() < 1.0, "{}", wall.contour.length());
}

#[test]
fn two_strokes_become_one_with_the_side_between_whichever_way_they_run() {
    for turned in [false, true] {
        let [mut left, mut right] = eaves(50.0);
        if turned {
            left.contour.reverse();
            right.contour.reverse();
        }
        let found = reassign_sides(vec![left, wall(), right], SIGMA, LEAST);
        let mut lengths: Vec<f32> = found.iter().map(|found| found.contour.length()).collect();
        lengths.sort_by(f32::total_cmp);
        assert!(matches!(lengths[..], [base, wall] if (base - 98.0).abs() < 1.0 && (wall - 140.0).abs() < 1.0));
    }
}

#[test]
fn what_two_ends_make_with_a_side_does_not_depend_on_the_direction_of_any() {
    let [left, right] = eaves(50.0);
    let with = |of: &FoundContour, stroke: Option<f32>| FoundContour { stroke, ..of.clone() };
    for widths in [[Some(2.0), Some(4.0)], [None, Some(2.0)], [None, None]] {
        let mut seen: Vec<Option<f32>> = Vec::new();
        for turned in 0..8 {
            let mut all = [with(&left, widths[0]), with(&wall(), None), with(&right, widths[1])];
            for (k, found) in all.iter_mut().enumerate() {
                if turned & (1 << k) != 0 {
                    found.contour.reverse();
                }
            }
            let found = reassign_sides(all.to_vec(), SIGMA, LEAST);
            assert_eq!(found.len(), 2, "{turned:b} turned");
            let base = found.iter().find(|found| is_near(&found.contour, 50.0, 50.0)).expect("it has the side");
            let corners = [(20.0, 50.0), (80.0, 50.0), (15.0, 50.0), (85.0, 50.0)];
            assert!(corners.iter().all(|&(x, y)| is_near(&base.contour, x, y)), "no vertex is lost");
            seen.push(base.stroke);
        }
        let expected = match widths {
            [Some(_), Some(_)] => Some((15.0 * 2.0 + 13.0 * 4.0) / 28.0),
            [None, width] => width,
            _ => unreachable!("not among them"),
        };
        let is_expected = |stroke: &Option<f32>| match (stroke, expected) {
            (Some(stroke), Some(expected)) => (stroke - expected).abs() < 0.05,
            (stroke, expected) => stroke.is_none() && expected.is_none(),
        };
        assert!(seen.iter().all(is_expected), "{seen:?}");
    }
}

#[test]
fn an_axis_gets_back_the_sides_of_all_bars() {
    let bar = |x: f32| FoundContour {
        stroke: None,
        ..stroke(&[(x, 50.0), (x, 10.0), (x + 30.0, 10.0), (x + 30.0, 50.0)], true)
    };
    let piece = |from: f32, to: f32| stroke(&[(from, 50.0), (to, 50.0)], false);
    let all = vec![piece(0.0, 20.0), bar(20.0), piece(50.0, 70.0), bar(70.0), piece(100.0, 130.0)];
    let found = reassign_sides(all, SIGMA, LEAST);
    assert!(found.iter().all(|found| !found.contour.closed));
    let mut lengths: Vec<f32> = found.iter().map(|found| found.contour.length()).collect();
    lengths.sort_by(f32::total_cmp);
    let [a, b, axis] = lengths[..] else { panic!("two bars and an axis: {lengths:?}") };
    assert!([a - 110.0, b - 110.0, axis - 130.0].iter().all(|difference| difference.abs() < 0.5), "{lengths:?}");
}

#[test]
fn an_open_line_gives_the_side_behind_its_corner_to_the_end_that_goes_straight_on() {
    // a bar's side and the axis behind it were found as one line
    let corner = stroke(&[(50.0, 10.0), (50.0, 50.0), (98.0, 50.0)], false);
    for turned in [false, true] {
        let mut axis = stroke(&[(0.0, 50.0), (46.0, 50.0)], false);
        if turned {
            axis.contour.reverse();
        }
        let found = reassign_sides(vec![corner.clone(), axis], SIGMA, LEAST);
        let mut lengths: Vec<f32> = found.iter().map(|found| found.contour.length()).collect();
        lengths.sort_by(f32::total_cmp);
        let [side, axis] = lengths[..] else { panic!("a side and an axis: {lengths:?}") };
        assert!((side - 40.0).abs() < 0.5 && (axis - 98.0).abs() < 0.5, "{lengths:?}");
    }
}

#[test]
fn a_ring_with_one_straight_end_or_with_ends_aside_stays_a_ring() {
    let [left, _] = eaves(50.0);
    let [high_left, high_right] = eaves(46.0);
    for others in [vec![left], vec![high_left, high_right]] {
        let all: Vec<FoundContour> = std::iter::once(wall()).chain(others).collect();
        assert_eq!(reassign_sides(all.clone(), SIGMA, LEAST), all);
    }
}

#[test]
fn of_two_ends_the_one_that_goes_straighter_on_has_the_side() {
    let corner = stroke(&[(50.0, 10.0), (50.0, 50.0), (98.0, 50.0)], false);
    let (level, slanted) = (stroke(&[(0.0, 50.0), (46.0, 50.0)], false), stroke(&[(2.0, 58.5), (46.0, 51.0)], false));
    for ends in [[level.clone(), slanted.clone()], [slanted.clone(), level.clone()]] {
        let found = reassign_sides(ends.into_iter().chain([corner.clone()]).collect(), SIGMA, LEAST);
        let longest = found.iter().max_by(|a, b| a.contour.length().total_cmp(&b.contour.length())).expect("three");
        assert!(found.len() == 3 && is_near(&longest.contour, 0.0, 50.0) && is_near(&longest.contour, 98.0, 50.0));
    }
}
