//! A coarse map of where something may be near at all: a question that most vertices are done with.

use crate::units::{MmPoint, MmRect};

/// Side of a cell, mm.
const CELL: f32 = 1.0;
/// A path is marked at points at most this far apart, mm.
pub(super) const MARK: f32 = 1.5;

/// For each cell of an area whether a marked path may be within reach of a position in it.
pub(super) struct NearMap {
    area: MmRect,
    reach: f32,
    marked: Vec<bool>,
    columns: usize,
    rows: usize,
}

impl NearMap {
    /// An empty map.
    pub(super) fn new(area: MmRect, reach: f32) -> Self {
        let cells = |mm: f32| (mm / CELL).ceil().max(1.0) as usize;
        let (columns, rows) = (cells(area.width()), cells(area.height()));
        // more by half the diagonal of a cell, rounded up, and half the distance to the next mark
        let reach = reach + CELL + 0.5 * MARK;
        Self { area, reach, marked: vec![false; columns * rows], columns, rows }
    }

    /// Marks what is in reach of a point of a path. All points that are [`MARK`] apart along it must be marked.
    pub(super) fn mark(&mut self, at: MmPoint) {
        let reach = self.reach;
        // what lies outside counts as on the border, as in `may_be_near`: that brings no two points further apart
        let at = at.clamp(self.area.min, self.area.max);
        let (x, y) = ((at.x - self.area.min.x) / CELL, (at.y - self.area.min.y) / CELL);
        let range = |middle: f32, count: usize| {
            ((middle - reach / CELL).max(0.0) as usize)..(((middle + reach / CELL).max(0.0) as usize + 1).min(count))
        };
        for row in range(y, self.rows) {
            let is_in = |column: &usize| {
                let (dx, dy) = (*column as f32 + 0.5 - x, row as f32 + 0.5 - y);
                (dx * dx + dy * dy) * CELL * CELL <= reach * reach
            };
            let mut columns = range(x, self.columns);
            // a run of each row is in reach
            if let Some(first) = columns.find(is_in) {
                let last = columns.rfind(is_in).unwrap_or(first);
                self.marked[row * self.columns..][first..=last].fill(true);
            }
        }
    }

    /// Whether a marked path may be within reach.
    pub(super) fn may_be_near(&self, at: MmPoint) -> bool {
        let index = |value: f32, count: usize| ((value / CELL).max(0.0) as usize).min(count - 1);
        let (column, row) = (index(at.x - self.area.min.x, self.columns), index(at.y - self.area.min.y, self.rows));
        self.marked[row * self.columns + column]
    }
}

#[cfg(test)]
mod tests;
