//! Tests of `heights`.

use super::super::tree::Detail;
use super::*;
use crate::raster::plane::Plane;
use crate::units::Size;

/// Three fields side by side: the first two unlike by 10, the third unlike them by 60.
fn fields() -> Tree {
    let size = Size::new(90, 40);
    let of = |x: usize| [20.0, 30.0, 90.0][x / 30];
    let values = (0..size.len()).map(|cell| of(cell % size.width as usize)).collect();
    Tree::new(&[], &[Plane { size, values }], RegionGrid::new(size), Detail::CONTOURS)
}

#[test]
fn a_border_is_as_high_as_what_keeps_its_two_sides_apart() {
    let heights = Heights::of(&fields());
    let [weak, strong, inside] = [30.0, 60.0, 15.0].map(|x| heights.near(PxPoint::new(x, 20.0)));
    assert!(strong > 1.5 * weak && weak > 0.0, "{weak} {strong}");
    assert!(inside < weak, "{inside} inside a field, {weak} at its border");
}

#[test]
fn a_place_farther_than_the_reach_from_all_borders_has_none_and_one_outside_is_no_fault() {
    let heights = Heights { of_cell: vec![0.0; 100], grid: RegionGrid::new(Size::new(10, 10)) };
    let with = |cell: usize| {
        let mut of_cell = heights.of_cell.clone();
        of_cell[cell] = 7.0;
        Heights { of_cell, ..heights.clone() }
    };
    for (cell, at, height) in [
        (55, (5.5, 5.5), 7.0),
        (55, (5.5, 8.0), 7.0), // 2.5 cells away
        (55, (5.5, 8.1), 0.0),
        (0, (-1.0, -1.0), 7.0),
        (0, (f32::NAN, 1e9), 0.0),
        (9, (40.0, 0.5), 0.0), // right of the grid
        (90, (0.5, 40.0), 0.0),
    ] {
        let near = with(cell).near(PxPoint::from(at));
        assert!((near - height).abs() < 1e-6, "{near} at {at:?}, not {height}");
    }
}

#[test]
fn heights_never_fall_towards_the_root() {
    let tree = fields();
    for node in &tree.nodes {
        for child in node.children.into_iter().flatten() {
            assert!(tree.nodes[child as usize].height <= node.height);
        }
    }
    assert!(tree.nodes.last().is_some_and(|root| root.height > 0.0));
}
