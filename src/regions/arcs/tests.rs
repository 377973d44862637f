//! Tests of `arcs`.

use super::super::trace::{TracePoint, TracedContour};
use super::*;
use crate::units::Size;

const SIZE: Size = Size::new(16, 6);

/// Basins of rows of digits.
fn basins(rows: &[&str]) -> (Vec<u32>, RegionGrid) {
    let basin = rows.iter().flat_map(|row| row.bytes()).map(|digit| u32::from(digit - b'0')).collect();
    (basin, RegionGrid::new(Size::new(rows[0].len() as u32, rows.len() as u32)))
}

/// A trace through these points.
fn trace(points: impl Iterator<Item = (f32, f32)>, strength: f32) -> TracedContour {
    let vertices = points.map(|(x, y)| TracePoint { at: PxPoint::new(x, y), strength }).collect();
    TracedContour { vertices, closed: false }
}

/// The only arc between the left half, of lightness 20, and the right one, of 80; `left` is the basin on the left.
fn of_halves(left: u32, traces: &[TracedContour]) -> Arc {
    let is_left = |cell: usize| cell % 16 < 8;
    let basin: Vec<u32> = (0..SIZE.len()).map(|cell| if is_left(cell) { left } else { 1 - left }).collect();
    let values = (0..SIZE.len()).map(|cell| if is_left(cell) { 20.0 } else { 80.0 }).collect();
    let grid = RegionGrid::new(SIZE);
    let (cracks, mut arcs) = arcs(&basin, grid, &TraceMap::of(traces, grid), &[Plane { size: SIZE, values }]);
    assert_eq!((cracks.len(), arcs.len()), (6, 1));
    arcs.remove(0)
}

#[test]
fn cracks_lie_between_cells_of_different_basins_and_each_is_in_one_arc() {
    let (basin, grid) = basins(&["0011", "0011", "2222"]);
    let (cracks, arcs) = arcs(&basin, grid, &TraceMap::of(&[], grid), &[]);
    let ends: Vec<[u32; 2]> = arcs.iter().map(|arc| arc.ends).collect();
    assert_eq!(ends, [[0, 1], [0, 2], [1, 2]]);
    assert_eq!(arcs.iter().map(|arc| arc.cracks.clone()).collect::<Vec<_>>(), [0..2, 2..4, 4..6]);
    let places: Vec<[f32; 2]> = cracks.iter().map(|crack| crack.middle(grid).to_array()).collect();
    assert_eq!(places, [[2.0, 0.5], [2.0, 1.5], [0.5, 2.0], [1.5, 2.0], [2.5, 2.0], [3.5, 2.0]]);
    for arc in &arcs {
        for crack in &cracks[arc.cracks.clone()] {
            let [a, b] = crack.cells(grid).map(|cell| basin[cell]);
            assert_eq!([a.min(b), a.max(b)], arc.ends);
        }
    }
}

#[test]
fn a_trace_along_an_arc_is_seen_and_strong_ones_count_up_to_clear() {
    let border = |strength| trace((0..6).map(|y| (8.0, y as f32 + 0.5)), strength);
    let sums = |traces: &[TracedContour]| of_halves(0, traces).sums;
    let strong = sums(&[border(30.0)]);
    assert_eq!([strong.length, strong.strength, strong.clear, strong.seen], [6.0, 180.0, 120.0, 6.0]);
    assert_eq!([strong.mean(), strong.clearness()], [30.0, 1.0]);
    let weak = sums(&[border(4.0)]);
    assert_eq!([weak.strength, weak.clear, weak.seen], [24.0, 24.0, 0.0]);
    let none = sums(&[]);
    assert_eq!([none.length, none.strength, none.mean()], [6.0, 0.0, 0.0]);
}

#[test]
fn a_trace_that_crosses_an_arc_says_nothing_of_it() {
    let across = trace((0..16).map(|x| (x as f32 + 0.5, 3.0)), 30.0);
    assert!(of_halves(0, &[across]).sums.strength < 1e-3);
}

#[test]
fn colours_are_those_of_the_side_of_each_basin() {
    let lightness = |left| of_halves(left, &[]).sums.colours.map(|side| side[0]);
    assert_eq!(lightness(0), [120.0, 480.0]);
    assert_eq!(lightness(1), [480.0, 120.0], "the basin of the lower number is on the right");
}

#[test]
fn sums_add_up_with_sides_exchanged() {
    let one = Sums { length: 2.0, strength: 6.0, clear: 5.0, seen: 1.0, colours: [[1.0; 3], [4.0; 3]] };
    let mut both = one;
    both.add(&one, true);
    assert_eq!(both, Sums { length: 4.0, strength: 12.0, clear: 10.0, seen: 2.0, colours: [[5.0; 3]; 2] });
    both.add_times(&one, true, -1.0);
    assert_eq!(both, one);
}

#[test]
fn cracks_at_both_ends_of_a_wide_grid_are_far_from_one_another() {
    // the square of their distance, in halves of a cell, is more than 32 bits hold
    let size = Size::new(60_000, 2);
    let grid = RegionGrid { cells: size, picture: size };
    let cracks = [10, 46_010].map(|cell| Crack { cell, is_upright: true });
    let mut moments = ArcMoments::default();
    moments.find(&cracks, grid);
    let tangents = moments.of_cracks.iter().zip(&cracks).map(|(moments, crack)| tangent(moments, crack));
    assert!(tangents.into_iter().all(|tangent| tangent.x.abs() < 1e-6 && tangent.y.abs() > 0.9));
}

#[test]
fn sums_of_both_signs_come_out_of_one_number_as_they_went_in() {
    for sums in [[0, 0, 0], [5, -3, 180], [-900, 1200, 1], [-1, -1, -1], [11_000, -11_000, 11_000]] {
        let [a, b, c] = sums.map(i64::from);
        assert_eq!(sums_in(a + (b << FIELD) + (c << (2 * FIELD))), sums);
    }
}
