//! The squares in which a figure is looked at: which of them are marked, and sums over those in a box.

use std::sync::OnceLock;

use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmRect, MmVector};

/// Side of the squares that the figure is looked at in, mm. Chosen by us: a sixth of the distance that labels keep.
pub(super) const SQUARE: f32 = 0.5;

/// Blocks of so many squares by as many are looked at as a whole: a way through the blank takes few steps then.
const BLOCK: usize = 4;

/// The squares of a figure, row by row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Squares {
    pub(super) area: MmRect,
    columns: usize,
    rows: usize,
}

/// Some of the squares.
#[derive(Debug)]
pub(super) struct MarkedSquares {
    marked: Vec<bool>,
    /// For each block how many blocks off the nearest is that has one of them, across, down or both.
    far: OnceLock<Vec<u8>>,
}

/// For each corner of squares the sum over all of them above and to the left of it (a summed-area table), so that a box
/// is looked at in one step.
#[derive(Debug)]
pub(super) struct SquareSums(Vec<u32>);

impl Squares {
    pub(super) fn of(area: MmRect) -> Self {
        let count = |mm: f32| (mm / SQUARE).ceil().max(1.0) as usize;
        Self { area, columns: count(area.width()), rows: count(area.height()) }
    }

    fn count(&self) -> usize {
        self.columns * self.rows
    }

    /// The squares within `reach` of the ink of segments, each with its width.
    pub(super) fn near(&self, segments: impl Iterator<Item = ([MmPoint; 2], f32)>, reach: f32) -> MarkedSquares {
        let mut near = MarkedSquares::none_of(self);
        for ([a, b], width) in segments {
            self.around(a, b, 0.5 * width + reach, |index| near.mark(index));
        }
        near
    }

    /// Calls `visit` with the numbers of the squares whose middle is nearer than `reach` to a segment.
    pub(super) fn around(&self, a: MmPoint, b: MmPoint, reach: f32, mut visit: impl FnMut(usize)) {
        let (low, high) = (a.min(b) - MmVector::new(reach, reach), a.max(b) + MmVector::new(reach, reach));
        let range = |low: f32, high: f32, count: usize| {
            let at = |mm: f32| (mm / SQUARE).floor().clamp(0.0, count as f32) as usize;
            at(low)..(at(high) + 1).min(count)
        };
        for row in range(low.y - self.area.min.y, high.y - self.area.min.y, self.rows) {
            for column in range(low.x - self.area.min.x, high.x - self.area.min.x, self.columns) {
                let middle = self.area.min + MmVector::new(column as f32 + 0.5, row as f32 + 0.5) * SQUARE;
                if nearest_on_segment(middle, a, b).0 < reach {
                    visit(row * self.columns + column);
                }
            }
        }
    }

    /// The number of the square of a place; none outside of the figure.
    pub(super) fn index(&self, at: MmPoint) -> Option<usize> {
        self.column_and_row(at).map(|[column, row]| row * self.columns + column)
    }

    fn column_and_row(&self, at: MmPoint) -> Option<[usize; 2]> {
        let from = (at - self.area.min) / SQUARE;
        let inside = from.x >= 0.0 && from.y >= 0.0 && from.x < self.columns as f32 && from.y < self.rows as f32;
        inside.then_some([from.x as usize, from.y as usize])
    }

    /// How many squares a place lies off the figure at least.
    fn off(&self, at: MmPoint) -> u32 {
        let from = (at - self.area.min) / SQUARE;
        let off = |at: f32, count: usize| (-at).max(at - count as f32);
        off(from.x, self.columns).max(off(from.y, self.rows)).max(0.0) as u32
    }

    /// How many blocks there are across and down.
    fn blocks(&self) -> [usize; 2] {
        [self.columns.div_ceil(BLOCK), self.rows.div_ceil(BLOCK)]
    }
}

impl MarkedSquares {
    pub(super) fn none_of(squares: &Squares) -> Self {
        Self { marked: vec![false; squares.count()], far: OnceLock::new() }
    }

    pub(super) fn mark(&mut self, index: usize) {
        debug_assert!(self.far.get().is_none(), "all are marked before any is looked for");
        self.marked[index] = true;
    }

    /// Whether the square of a place is one of them.
    pub(super) fn holds(&self, at: MmPoint, squares: &Squares) -> bool {
        squares.index(at).is_some_and(|index| self.marked[index])
    }

    /// How far the first of them lies in a direction (a vector no longer than 1), mm.
    pub(super) fn first_in(&self, squares: &Squares, at: MmPoint, direction: MmVector, reach: f32) -> Option<f32> {
        let steps = (2.0 * reach / SQUARE).ceil() as u32;
        let mut step = 0;
        while step <= steps {
            let distance = 0.5 * SQUARE * step as f32;
            if distance > reach {
                break;
            }
            let Some(blank) = self.blank_around(at + direction * distance, squares) else { return Some(distance) };
            step += (2 * blank.saturating_sub(1)).max(1);
        }
        None
    }

    /// Whether one of them lies between two places; `end` mm before the second it does not count.
    pub(super) fn meets(&self, squares: &Squares, from: MmPoint, to: MmPoint, end: f32) -> bool {
        let length = (to - from).length();
        let steps = (length / SQUARE).ceil().max(1.0);
        let mut step = 0;
        while step <= steps as u32 {
            let along = step as f32 / steps;
            if (1.0 - along) * length <= end {
                break;
            }
            let Some(blank) = self.blank_around(from.lerp(to, along), squares) else { return true };
            step += blank.saturating_sub(1).max(1);
        }
        false
    }

    /// None if the square of a place is one of them; else so many squares around it are none, in all directions.
    fn blank_around(&self, at: MmPoint, squares: &Squares) -> Option<u32> {
        let Some([column, row]) = squares.column_and_row(at) else { return Some(squares.off(at)) };
        let far = self.far.get_or_init(|| self.far_blocks(squares));
        let [across, _] = squares.blocks();
        let blocks = u32::from(far[row / BLOCK * across + column / BLOCK]);
        // those of the blocks that lie between
        let blank = BLOCK as u32 * blocks.saturating_sub(1);
        (blank > 0 || !self.marked[row * squares.columns + column]).then_some(blank)
    }

    /// Distances of blocks, by two passes over them (Rosenfeld and Pfaltz 1966).
    fn far_blocks(&self, squares: &Squares) -> Vec<u8> {
        let [across, down] = squares.blocks();
        let mut far = vec![u8::MAX; across * down];
        for (row, of_row) in self.marked.chunks_exact(squares.columns).enumerate() {
            for (column, of_block) in of_row.chunks(BLOCK).enumerate() {
                if of_block.contains(&true) {
                    far[row / BLOCK * across + column] = 0;
                }
            }
        }
        let mut pass = |block: usize, beside: [(isize, isize); 4]| {
            let (column, row) = (block % across, block / across);
            let at = |(x, y): (isize, isize)| {
                let (column, row) = (column.checked_add_signed(x)?, row.checked_add_signed(y)?);
                (column < across && row < down).then(|| far[row * across + column])
            };
            let least = beside.into_iter().filter_map(at).min().unwrap_or(u8::MAX);
            far[block] = far[block].min(least.saturating_add(1));
        };
        (0..across * down).for_each(|block| pass(block, [(-1, 0), (-1, -1), (0, -1), (1, -1)]));
        (0..across * down).rev().for_each(|block| pass(block, [(1, 0), (1, 1), (0, 1), (-1, 1)]));
        far
    }

    /// How many of them there are, as sums.
    pub(super) fn sums(&self, squares: &Squares) -> SquareSums {
        SquareSums::of(squares, self.marked.iter().map(|is_marked| u32::from(*is_marked)).enumerate())
    }
}

impl SquareSums {
    /// The sums of what squares hold, each given by its number, some perhaps more than once.
    pub(super) fn of(squares: &Squares, held: impl Iterator<Item = (usize, u32)>) -> Self {
        let mut all = vec![0; squares.count()];
        held.for_each(|(index, count)| all[index] += count);
        let wide = squares.columns + 1;
        let mut sums = vec![0; wide * (squares.rows + 1)];
        for (row, of_row) in all.chunks_exact(squares.columns).enumerate() {
            let mut sum = 0;
            for (column, count) in of_row.iter().enumerate() {
                sum += count;
                sums[(row + 1) * wide + column + 1] = sums[row * wide + column + 1] + sum;
            }
        }
        Self(sums)
    }

    /// The sum over all squares that a box touches.
    pub(super) fn within(&self, place: MmRect, squares: &Squares) -> u32 {
        let at = |mm: f32, count: usize| mm.clamp(0.0, count as f32) as usize;
        let low = (place.min - squares.area.min) / SQUARE;
        let high = (place.max - squares.area.min) / SQUARE;
        let (left, top) = (at(low.x.floor(), squares.columns), at(low.y.floor(), squares.rows));
        let (right, bottom) = (at(high.x.ceil(), squares.columns), at(high.y.ceil(), squares.rows));
        if right <= left || bottom <= top {
            return 0;
        }
        let sum = |row: usize, column: usize| self.0[row * (squares.columns + 1) + column];
        sum(bottom, right) + sum(top, left) - sum(top, right) - sum(bottom, left)
    }
}

#[cfg(test)]
mod tests;
