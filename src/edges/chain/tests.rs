//! Tests of `chain`.

use super::super::ridge::EdgeProfile;
use super::*;
use crate::units::{PxPoint, PxVector};

const SIZE: Size = Size { width: 60, height: 60 };

/// Ridge points at positions with normals, in reading order.
fn ridge_points(positions: impl Iterator<Item = (PxPoint, PxVector)>) -> Vec<RidgePoint> {
    let profile = EdgeProfile { maximum: 5.0, curvature: 0.4, pedestal: [0.0; 2], distance: 4.5 };
    let point = |(at, normal): (PxPoint, PxVector)| {
        let (column, row) = (at.x as u32, at.y as u32);
        RidgePoint { at, normal, profile, height: 20.0, blur: 1.5, column, row }
    };
    let mut points: Vec<RidgePoint> = positions.map(point).collect();
    points.sort_by_key(|point| (point.row, point.column));
    points
}

/// Points a pixel apart on a horizontal line.
fn row_of_points(y: f32, columns: Range<u32>) -> impl Iterator<Item = (PxPoint, PxVector)> {
    columns.map(move |x| (PxPoint::new(x as f32 + 0.5, y), PxVector::new(0.0, 1.0)))
}

#[test]
fn points_on_a_circle_form_one_closed_chain() {
    let n = 94; // about a pixel apart
    let angles = (0..n).map(|k| k as f32 * std::f32::consts::TAU / n as f32);
    let normals = angles.map(|angle| PxVector::new(angle.cos(), angle.sin()));
    let points = ridge_points(normals.map(|normal| (PxPoint::new(30.0, 30.0) + normal * 15.0, normal)));
    let chains = link(&points, SIZE, 6.0);
    assert_eq!(chains.len(), 1);
    assert!(chains[0].closed && chains[0].vertices.len() == n);
    let round = std::f32::consts::TAU * 15.0;
    assert!((length(&points, &chains[0]) / round - 1.0).abs() < 1e-3, "{}", length(&points, &chains[0]));
}

#[test]
fn lines_side_by_side_and_beyond_a_gap_stay_apart_and_short_ones_are_dropped() {
    let lines = row_of_points(10.5, 5..30).chain(row_of_points(10.5, 34..55));
    let points = ridge_points(lines.chain(row_of_points(12.5, 5..55)).chain(row_of_points(40.5, 5..10)));
    let chains = link(&points, SIZE, 6.0);
    let mut lengths: Vec<usize> = chains.iter().map(|chain| chain.vertices.len()).collect();
    lengths.sort_unstable();
    assert_eq!(lengths, [21, 25, 50]);
    let rows = |chain: &Chain| chain.vertices.iter().map(|&number| points[number as usize].row).collect::<Vec<_>>();
    assert!(chains.iter().all(|chain| !chain.closed && rows(chain).windows(2).all(|pair| pair[0] == pair[1])));
}

#[test]
fn neighbours_go_round_a_closed_chain_and_stop_at_the_ends_of_an_open_one() {
    assert_eq!([0, 1, 3].map(|i| neighbours(4, true, i)), [[3, 1], [0, 2], [2, 0]]);
    assert_eq!([0, 1, 3].map(|i| neighbours(4, false, i)), [[0, 1], [0, 2], [2, 3]]);
}
