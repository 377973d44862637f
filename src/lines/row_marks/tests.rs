//! Tests of `row_marks`.

use super::*;
use crate::lines::Height;

fn run(dots: &[(f32, f32)]) -> Run {
    Run::dots(1.6, dots.iter().map(|&(x, y)| MmPoint::new(2.0 * x, 2.0 * y)).collect(), Height::High)
}

fn row(y: f32, columns: std::ops::Range<u32>) -> Vec<(f32, f32)> {
    columns.map(|x| (x as f32, y)).collect()
}

#[test]
fn ticks_and_points_are_told_from_a_second_row() {
    let around = |x: f32| {
        [(-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)]
            .map(|(dx, dy)| (x + dx, 10.0 + dy))
    };
    let mut axis = row(10.0, 0..40);
    axis.remove(30);
    let parts = [&axis[..], &row(11.0, 0..8), &[(5.0, 12.0), (5.0, 13.0)], &around(20.0), &around(30.0)];
    let line = Line { strength: 100.0, runs: parts.into_iter().map(run).collect() };
    let ticks: Vec<MmPoint> = line.row_ticks().map(|(_, at)| at).collect();
    assert_eq!(ticks, [MmPoint::new(10.0, 20.0)]);
    let points: Vec<(MmPoint, bool)> = line.row_points().map(|point| (point.at, point.is_filled)).collect();
    assert_eq!(points, [(MmPoint::new(40.0, 20.0), true), (MmPoint::new(60.0, 20.0), false)]);
}

#[test]
fn the_second_row_of_a_ring_is_no_point() {
    let ring = |radius: f32| -> Vec<(f32, f32)> {
        let at = |k: u32| (k as f32 * std::f32::consts::TAU / 24.0).sin_cos();
        (0..24).map(at).map(|(y, x)| (10.0 + radius * x, 10.0 + radius * y)).collect()
    };
    let line = Line { strength: 100.0, runs: vec![run(&ring(5.0)), run(&ring(4.0))] };
    assert_eq!((line.row_points().count(), line.row_ticks().count()), (0, 0));
    let outside = Line { strength: 100.0, runs: vec![run(&ring(4.0)), run(&ring(5.0))] };
    assert_eq!(outside.row_points().count(), 0);
    // of an oval one the middle is nearer to the row above and below than the second row is on the whole
    let oval = |radius: f32| ring(radius).into_iter().map(|(x, y)| (10.0 + 1.2 * (x - 10.0), y)).collect::<Vec<_>>();
    let oval = Line { strength: 100.0, runs: vec![run(&oval(10.0)), run(&oval(9.2))] };
    assert_eq!(oval.row_points().count(), 0);
    let stroke = Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![MmPoint::zero(), MmPoint::new(9.0, 0.0)])] };
    assert_eq!((stroke.row_points().count(), stroke.row_ticks().count()), (0, 0));
}
