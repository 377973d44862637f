//! The cells within a distance of a cell.

use std::ops::Range;

use crate::units::Size;

/// The cells around one whose squared distance is small enough.
pub(super) struct CellDisc {
    /// How many columns it reaches to both sides, by the number of rows above or below its middle.
    reach: Vec<usize>,
    size: Size,
}

impl CellDisc {
    /// All cells of a grid of this size whose squared distance from the middle, in cells, `is_in`; so are those that
    /// are nearer.
    pub(super) fn new(size: Size, is_in: impl Fn(u32) -> bool) -> Self {
        let (width, height) = (size.width, size.height);
        let rows = (0..height).take_while(|dy| is_in(dy * dy));
        let reach = rows.map(|dy| (1..width).take_while(|dx| is_in(dx * dx + dy * dy)).count()).collect();
        Self { reach, size }
    }

    /// The cells of the grid that are in it, row by row, where its middle is at `cell`.
    pub(super) fn around(&self, cell: usize) -> impl Iterator<Item = Range<usize>> {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let (x, y) = (cell % width, cell / width);
        let farthest = self.reach.len().wrapping_sub(1);
        let rows =
            if self.reach.is_empty() { 0..0 } else { y.saturating_sub(farthest)..(y + farthest + 1).min(height) };
        rows.map(move |row| {
            let reach = self.reach[row.abs_diff(y)];
            row * width + x.saturating_sub(reach)..row * width + (x + reach + 1).min(width)
        })
    }

    /// The cells of the grid that are in it where its middle is at some cell that `is_set`.
    pub(super) fn spread(&self, is_set: &[bool]) -> Vec<bool> {
        let mut is_in = is_set.to_vec();
        let width = self.size.width as usize;
        let is_unset = |cell: usize| is_set.get(cell).is_some_and(|is_set| !is_set);
        for (y, row) in is_set.chunks_exact(width).enumerate() {
            for x in (0..width).filter(|&x| row[x]) {
                let cell = y * width + x;
                // the nearest one to a cell that is not set has a neighbour that is not
                if x > 0 && !row[x - 1]
                    || x + 1 < width && !row[x + 1]
                    || cell >= width && is_unset(cell - width)
                    || is_unset(cell + width)
                {
                    self.around(cell).for_each(|row| is_in[row].fill(true));
                }
            }
        }
        is_in
    }
}

#[cfg(test)]
mod tests;
