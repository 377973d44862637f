//! Tests of `order`.

use super::*;
use crate::lines::Run;
use crate::units::MmPoint;

fn line(points: &[(f32, f32)]) -> Line {
    Line { strength: 50.0, runs: vec![Run::stroke(1.0, points.iter().copied().map(MmPoint::from).collect())] }
}

fn order_of(lines: &[Line]) -> Vec<usize> {
    order_of_those(lines, &vec![false; lines.len()])
}

fn order_of_those(lines: &[Line], weak: &[bool]) -> Vec<usize> {
    order(lines, weak, MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)), 5.0)
}

fn bar(x: f32) -> Line {
    line(&[(x, 80.0), (x, 30.0), (x + 10.0, 30.0), (x + 10.0, 80.0)])
}

#[test]
fn an_axis_goes_before_the_bars_that_stand_on_it_and_no_other_line_changes_its_place() {
    let axis = line(&[(10.0, 10.0), (10.0, 80.0), (90.0, 80.0)]);
    let (alone, tick) = (line(&[(20.0, 95.0), (80.0, 95.0)]), line(&[(30.0, 30.0), (30.0, 22.0)]));
    // a tick on a bar, the bar on the axis
    assert_eq!(order_of(&[alone.clone(), tick, bar(50.0), bar(25.0), axis.clone()]), [0, 4, 3, 1, 2]);
    assert_eq!(order_of(&[axis, bar(50.0), alone]), [0, 1, 2]);
}

#[test]
fn a_line_of_a_grid_goes_before_no_shape_whose_corner_lies_on_it() {
    let lines = [bar(50.0), line(&[(10.0, 80.0), (90.0, 80.0)])];
    assert_eq!(order_of_those(&lines, &[false, false]), [1, 0]);
    assert_eq!(order_of_those(&lines, &[false, true]), [0, 1]);
    assert_eq!(order_of_those(&lines, &[true, true]), [1, 0]);
}

#[test]
fn corners_and_circles_of_lines_change_nothing_for_ever() {
    let corner = [line(&[(10.0, 10.0), (50.0, 10.0)]), line(&[(50.0, 50.0), (50.0, 10.0)])];
    assert_eq!(order_of(&corner), [0, 1]);
    let circle = [
        line(&[(10.0, 30.0), (70.0, 30.0)]),
        line(&[(70.0, 10.0), (70.0, 70.0)]),
        line(&[(90.0, 70.0), (30.0, 70.0)]),
        line(&[(30.0, 90.0), (30.0, 30.0)]),
    ];
    let mut numbers = order_of(&circle);
    numbers.sort_unstable();
    assert_eq!(numbers, [0, 1, 2, 3]);
}
