//! The squares in which a figure is looked at: which of them are marked, and sums over those in a box.

use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmRect, MmVector};

/// Side of the squares that the figure is looked at in, mm. Chosen by us: a sixth of the distance that labels keep.
pub(super) const SQUARE: f32 = 0.5;

/// The squares of a figure, row by row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Squares {
    pub(super) area: MmRect,
    columns: usize,
    rows: usize,
}

/// Some of the squares.
#[derive(Debug)]
pub(super) struct MarkedSquares(Vec<bool>);

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
        let from = (at - self.area.min) / SQUARE;
        let inside = from.x >= 0.0 && from.y >= 0.0 && from.x < self.columns as f32 && from.y < self.rows as f32;
        inside.then(|| from.y as usize * self.columns + from.x as usize)
    }
}

impl MarkedSquares {
    pub(super) fn none_of(squares: &Squares) -> Self {
        Self(vec![false; squares.count()])
    }

    pub(super) fn mark(&mut self, index: usize) {
        self.0[index] = true;
    }

    /// Whether the square of a place is one of them.
    pub(super) fn holds(&self, at: MmPoint, squares: &Squares) -> bool {
        squares.index(at).is_some_and(|index| self.0[index])
    }

    /// How many of them there are, as sums.
    pub(super) fn sums(&self, squares: &Squares) -> SquareSums {
        SquareSums::of(squares, self.0.iter().map(|is_marked| u32::from(*is_marked)).enumerate())
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
