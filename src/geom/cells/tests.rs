//! Tests of `cells`.

use super::*;
use crate::units::MmPoint;

const SIZE: Size = Size::new(12, 10);

/// The cells along a path.
fn along(path: &[(f32, f32)], reach: f32) -> Vec<bool> {
    let mut is_set = vec![false; SIZE.len()];
    for pair in path.windows(2) {
        set_along(&mut is_set, SIZE, [pair[0], pair[1]].map(|(x, y)| MmPoint::new(x, y)), reach);
    }
    is_set
}

#[test]
fn cells_along_a_segment_are_those_whose_middles_are_near_it() {
    let level = along(&[(2.0, 4.5), (6.0, 4.5)], 1.0);
    let of_row = |y: usize| (0..12).filter(|x| level[y * 12 + x]).collect::<Vec<_>>();
    assert_eq!(of_row(4), [1, 2, 3, 4, 5, 6]);
    assert_eq!((of_row(3), of_row(5)), (vec![2, 3, 4, 5], vec![2, 3, 4, 5]));
    assert!(of_row(2).is_empty() && of_row(6).is_empty());
    // partly, and as a whole, beside the grid
    assert_eq!(along(&[(-3.0, 0.5), (1.5, 0.5)], 0.5).iter().filter(|is_set| **is_set).count(), 2);
    assert!(!along(&[(20.0, 20.0), (30.0, 30.0)], 2.0).contains(&true));
}

#[test]
fn what_a_ring_encloses_is_not_reached_from_the_edge_unless_it_is_open() {
    let ring = [(3.0, 2.0), (9.0, 2.5), (8.5, 7.5), (2.5, 7.0), (3.0, 2.0)];
    let middle = 5 * 12 + 6;
    let reached = |path: &[(f32, f32)]| {
        let is_line = along(path, COVERS);
        filled(SIZE, edge_cells(SIZE), |cell| !is_line[cell])
    };
    assert!(!reached(&ring)[middle] && reached(&ring[..4])[middle]);
    assert!(edge_cells(SIZE).all(|cell| reached(&ring)[cell]));
}

#[test]
fn a_grid_without_cells_has_no_edge() {
    let count = |width, height| edge_cells(Size::new(width, height)).count();
    assert_eq!([count(0, 0), count(4, 0), count(0, 4), count(2, 1)], [0, 0, 0, 6]);
}
