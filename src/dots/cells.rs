//! Places on a device's grid: whole numbers for dots, and fractions for what lies between them.

use crate::devices::Grid;
use crate::units::{MmPoint, MmRect};

/// A dot's column and row.
pub(super) type Cell = [i32; 2];

/// A place in columns and rows.
pub(super) type Place = [f32; 2];

/// The columns and rows of a place; between two dots, and beyond the outermost, in proportion.
pub(super) fn place(at: MmPoint, grid: &Grid) -> Place {
    [step(at.x, &grid.columns), step(at.y, &grid.rows)]
}

fn step(mm: f32, centres: &[f32]) -> f32 {
    let [.., _, _] = centres else { return 0.0 };
    let after = centres.partition_point(|&centre| centre <= mm).clamp(1, centres.len() - 1);
    let (a, b) = (centres[after - 1], centres[after]);
    (after - 1) as f32 + (mm - a) / (b - a)
}

/// The dot nearest to a place.
pub(super) fn nearest([x, y]: Place) -> Cell {
    [x, y].map(|value| (value + 0.5).floor() as i32)
}

/// Where a dot is; one beyond the grid is moved to its edge.
pub(super) fn centre([column, row]: Cell, grid: &Grid) -> MmPoint {
    let at = |index: i32, centres: &[f32]| {
        let last = centres.len().saturating_sub(1) as i32;
        centres.get(index.clamp(0, last) as usize).copied().unwrap_or(0.0)
    };
    MmPoint::new(at(column, &grid.columns), at(row, &grid.rows))
}

/// The outermost dots within `area`: first and last column, first and last row; the last is before the first where there are none.
pub(super) fn within(area: MmRect, grid: &Grid) -> [[i32; 2]; 2] {
    let range = |from: f32, to: f32, centres: &[f32]| {
        let first = centres.partition_point(|&centre| centre < from) as i32;
        let end = centres.partition_point(|&centre| centre <= to) as i32;
        [first, end - 1]
    };
    [range(area.min.x, area.max.x, &grid.columns), range(area.min.y, area.max.y, &grid.rows)]
}

/// How many steps apart two dots are, diagonal ones included.
pub(super) fn apart(a: Cell, b: Cell) -> i32 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}
