//! Tests of `polygon`.

use super::*;
use crate::units::{MmPoint, MmRect};

fn points(of: &[(f32, f32)]) -> Vec<MmPoint> {
    of.iter().map(|&at| MmPoint::from(at)).collect()
}

fn sides(ring: &[MmPoint]) -> impl Iterator<Item = (&MmPoint, &MmPoint)> {
    ring.iter().zip(ring.iter().cycle().skip(1))
}

#[test]
fn circles_are_rounder_than_squares_and_those_than_lines() {
    let square = points(&[(1.0, 1.0), (5.0, 1.0), (5.0, 5.0), (1.0, 5.0)]);
    assert!((area(&square) - 16.0).abs() < 1e-6);
    assert!((roundness(16.0, 16.0) - 0.785).abs() < 0.001);
    let circle: Vec<MmPoint> = circle_points(MmPoint::new(9.0, 9.0), 2.0, 400).collect();
    let length: f32 = sides(&circle).map(|(a, b)| (*b - *a).length()).sum();
    assert!((area(&circle) - 4.0 * PI).abs() < 0.01 && (roundness(area(&circle), length) - 1.0).abs() < 0.001);
    assert_eq!((roundness(0.0, 8.0), roundness(0.0, 0.0), area::<()>(&[])), (0.0, 0.0, 0.0));
}

#[test]
fn a_box_holds_a_level_line_only_if_that_is_in_it() {
    let place = |x: f32, y: f32, wide: f32, high: f32| MmRect::new((x, y).into(), (x + wide, y + high).into());
    let ring = place(10.0, 10.0, 4.0, 4.0);
    assert!(holds_box(ring, place(11.0, 12.0, 2.0, 0.0)) && holds_box(ring, ring));
    assert!(!holds_box(ring, place(0.0, 12.0, 90.0, 0.0)) && !holds_box(ring, place(50.0, 12.0, 2.0, 0.0)));
}

#[test]
fn a_row_through_an_l_with_a_hole_is_inside_in_two_parts() {
    let outer = points(&[(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (4.0, 4.0), (4.0, 10.0), (0.0, 10.0)]);
    let hole = points(&[(2.0, 1.0), (6.0, 1.0), (6.0, 3.0), (2.0, 3.0)]);
    let all = || sides(&outer).chain(sides(&hole));
    assert_eq!(row_inside(all(), 2.0), [[0.0, 2.0], [6.0, 10.0]]);
    assert_eq!(row_inside(all(), 8.0), [[0.0, 4.0]]);
    assert!(row_inside(all(), 11.0).is_empty());
    let inside = [(1.0, 2.0), (3.0, 2.0), (7.0, 2.0), (7.0, 8.0)].map(|at| is_inside(all(), MmPoint::from(at)));
    assert_eq!(inside, [true, false, true, false]);
}

#[test]
fn boxes_have_corners_and_distances() {
    let of = MmRect::new(MmPoint::new(1.0, 2.0), MmPoint::new(4.0, 6.0));
    assert_eq!(corners(of).to_vec(), points(&[(1.0, 2.0), (4.0, 2.0), (4.0, 6.0), (1.0, 6.0)]));
    let far = |x: f32, y: f32| distance_to_box(MmPoint::new(x, y), of);
    let wanted = [(far(2.0, 3.0), 0.0), (far(4.0, 9.0), 3.0), (far(7.0, 10.0), 5.0)];
    assert!(wanted.iter().all(|(far, wanted)| (far - wanted).abs() < 1e-6), "{wanted:?}");
    let is_in = |x: f32, y: f32| is_in_convex(MmPoint::new(x, y), &corners(of));
    assert!(is_in(2.0, 3.0) && is_in(1.0, 2.0) && !is_in(0.9, 3.0));
    let mut turned = corners(of);
    turned.reverse();
    assert!(is_in_convex(MmPoint::new(2.0, 3.0), &turned));
}
