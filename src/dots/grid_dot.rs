//! Positions on a device's grid: whole columns and rows for dots, and fractions for points between them.

use crate::devices::Grid;
use crate::units::{MmPoint, MmRect};

/// A dot's column and row.
pub(super) type GridDot = [i32; 2];

/// A position in columns and rows, in fractions of their distances.
pub(super) type GridPoint = [f32; 2];

/// The position of a point on the grid: linear between two dots, and extrapolated beyond the outermost.
pub(super) fn to_grid(at: MmPoint, grid: &Grid) -> GridPoint {
    [index(at.x, &grid.columns), index(at.y, &grid.rows)]
}

fn index(mm: f32, centres: &[f32]) -> f32 {
    let [.., _, _] = centres else { return 0.0 };
    let after = centres.partition_point(|&centre| centre <= mm).clamp(1, centres.len() - 1);
    let (a, b) = (centres[after - 1], centres[after]);
    (after - 1) as f32 + (mm - a) / (b - a)
}

/// The dot nearest to a position.
pub(super) fn nearest([x, y]: GridPoint) -> GridDot {
    [x, y].map(|value| (value + 0.5).floor() as i32)
}

/// The centre of a dot; one beyond the grid is moved to its edge.
pub(super) fn centre([column, row]: GridDot, grid: &Grid) -> MmPoint {
    let at = |index: i32, centres: &[f32]| {
        let last = centres.len().saturating_sub(1) as i32;
        centres.get(index.clamp(0, last) as usize).copied().unwrap_or(0.0)
    };
    MmPoint::new(at(column, &grid.columns), at(row, &grid.rows))
}

/// A part of a grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct GridBox {
    /// The first column and row.
    first: GridDot,
    /// The last ones; before the first where there are none.
    last: GridDot,
}

impl GridBox {
    /// The dots within `part` of the sheet.
    pub(super) fn within(part: MmRect, grid: &Grid) -> Self {
        let first = |from: f32, centres: &[f32]| centres.partition_point(|&centre| centre < from) as i32;
        let last = |to: f32, centres: &[f32]| centres.partition_point(|&centre| centre <= to) as i32 - 1;
        Self {
            first: [first(part.min.x, &grid.columns), first(part.min.y, &grid.rows)],
            last: [last(part.max.x, &grid.columns), last(part.max.y, &grid.rows)],
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        (0..2).any(|axis| self.first[axis] > self.last[axis])
    }

    pub(super) fn holds(&self, cell: GridDot) -> bool {
        (0..2).all(|axis| (self.first[axis]..=self.last[axis]).contains(&cell[axis]))
    }

    /// The dot nearest to another; there has to be one.
    pub(super) fn nearest(&self, cell: GridDot) -> GridDot {
        [0, 1].map(|axis| cell[axis].clamp(self.first[axis], self.last[axis]))
    }
}

/// The distance of two dots in steps, diagonal ones included (Chebyshev).
pub(super) fn distance(a: GridDot, b: GridDot) -> i32 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

#[cfg(test)]
mod tests;
