//! Tests of `grid`.

use super::*;

#[test]
fn small_pictures_have_their_pixels_as_cells_and_large_ones_about_the_most() {
    for (picture, cells) in [((481, 321), (481, 321)), ((4000, 3000), (516, 387)), ((5, 1), (5, 1)), ((0, 0), (1, 1))] {
        let grid = RegionGrid::new(Size::new(picture.0, picture.1));
        assert_eq!(grid.cells, Size::new(cells.0, cells.1), "{picture:?}");
    }
}

#[test]
fn corners_of_the_picture_are_corners_of_the_cells_and_there_is_a_way_back() {
    let grid = RegionGrid::new(Size::new(4000, 3000));
    for (picture, cells) in
        [((0.0, 0.0), (0.0, 0.0)), ((4000.0, 3000.0), (516.0, 387.0)), ((2000.0, 0.0), (258.0, 0.0))]
    {
        let [picture, cells] = [picture, cells].map(|(x, y)| PxPoint::new(x, y));
        assert!((grid.to_cells(picture) - cells).length() < 0.01, "{picture:?}");
        assert!((grid.to_picture(cells) - picture).length() < 0.01, "{cells:?}");
    }
}

#[test]
fn a_place_outside_of_the_picture_has_no_cell() {
    let grid = RegionGrid::new(Size::new(10, 4));
    for (at, cell) in [
        ((0.0, 0.0), Some(0)),
        ((9.9, 0.5), Some(9)),
        ((0.5, 1.0), Some(10)),
        ((9.9, 3.9), Some(39)),
        ((10.0, 0.5), None),
        ((0.5, 4.0), None),
        ((-0.1, 0.5), None),
        ((0.5, -0.1), None),
        ((f32::NAN, 0.5), None),
    ] {
        assert_eq!(grid.cell_at(PxPoint::new(at.0, at.1)), cell, "{at:?}");
    }
}

#[test]
fn all_cells_of_which_a_part_is_nearer_than_the_reach_are_around_a_place() {
    let grid = RegionGrid::new(Size::new(7, 5));
    for (i, j) in (0..34).flat_map(|i| (0..30).map(move |j| (i, j))) {
        let at = PxPoint::new(0.5 * i as f32 - 5.0, 0.5 * j as f32 - 5.0);
        for reach in [0.4, 1.5, REACH] {
            let [columns, rows] = grid.around(at, reach);
            assert!(columns.end <= 7 && rows.end <= 5, "{at:?}: {columns:?}, {rows:?}");
            assert!([&columns, &rows].iter().all(|range| range.len() as f32 <= 2.0 * reach + 2.0), "{at:?}");
            for (x, y) in (0..7_u8).flat_map(|x| (0..5_u8).map(move |y| (x, y))) {
                let nearest = |v: f32, cell: u8| v.clamp(f32::from(cell), f32::from(cell) + 1.0);
                let is_near = (PxPoint::new(nearest(at.x, x), nearest(at.y, y)) - at).length() < reach;
                let is_around = columns.contains(&usize::from(x)) && rows.contains(&usize::from(y));
                assert!(!is_near || is_around, "cell {x}, {y} within {reach} of {at:?}");
            }
        }
    }
}
