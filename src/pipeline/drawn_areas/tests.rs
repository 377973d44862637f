//! Tests of `drawn_areas`.

use super::*;

#[test]
fn a_shape_with_a_hole_has_its_cells() {
    let place = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(50.0, 60.0));
    let square = |x: f32, y: f32, side: f32| {
        [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(a, b)| MmPoint::new(x + a, y + b)).to_vec()
    };
    let size = Size::new(cells_along(40.0), cells_along(40.0));
    let found = inside(&[square(15.0, 25.0, 20.0), square(20.0, 30.0, 5.0)], place, size);
    let cells: usize = found.iter().map(|(_, columns)| columns.len()).sum();
    assert!((cells as f32 * CELL * CELL - (400.0 - 25.0)).abs() < 1e-3);
    let has = |x: f32, y: f32| {
        let [column, row] = [x - place.min.x, y - place.min.y].map(|mm| (mm / CELL) as usize);
        found.iter().any(|(own, columns)| *own == row && columns.contains(&column))
    };
    assert!(has(16.0, 26.0) && !has(22.0, 32.0) && !has(36.0, 26.0));
    assert!(found.iter().all(|(row, _)| (10..50).contains(row)), "no other row is looked at");
    assert!(inside(&[square(100.0, 100.0, 20.0)], place, size).is_empty());
}
