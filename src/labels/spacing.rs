//! How much blank there is between two labels.

use super::scale::Alone;
use crate::page::cells::CellGrid;

/// Blank between labels, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spacing {
    /// Side by side, whatever lies between.
    pub(super) aside: f32,
    /// One above the other.
    pub(super) above: f32,
    /// Side by side at one height, without a line between them: two blank cells at least, as one is the space between
    /// words of one text. They keep the columns of tables in braille apart (BANA, Braille Formats 2016, section 11).
    pub(super) in_line: f32,
}

/// The least blank side by side where there is room for no more, mm, whatever the cells.
pub(super) const LEAST_ASIDE: f32 = 6.0;
/// Within a word the dots of two cells are as far apart as the cells where one of them lacks a column: so much more is
/// the least between labels, mm, or two are read as one.
const MORE_THAN_CELLS: f32 = 0.5;
/// The least blank one above the other, mm.
pub(super) const LEAST_ABOVE: f32 = 3.5;
/// A hair for sums of floating point, mm.
const HAIR: f32 = 0.01;

impl Spacing {
    /// As columns of a table in braille, which two blank cells keep apart; one above the other, more than lines of one
    /// text.
    pub(super) fn wide(cells: &CellGrid<'_>) -> Self {
        Self { aside: blank(cells, 2), above: 7.0, in_line: blank(cells, 2) }
    }

    /// The least blank: where there is room for no more.
    pub(super) fn least(cells: &CellGrid<'_>) -> Self {
        let from_cell_to_cell = cells.extent(2, 1).x - cells.extent(1, 1).x;
        let aside = LEAST_ASIDE.max(from_cell_to_cell + MORE_THAN_CELLS);
        Self { aside, above: LEAST_ABOVE, ..Self::wide(cells) }
    }

    /// The same, less a hair.
    pub(super) fn least_rounded(cells: &CellGrid<'_>) -> Self {
        let Self { aside, above, in_line } = Self::least(cells);
        Self { aside: aside - HAIR, above: above - HAIR, in_line: in_line - HAIR }
    }

    /// Side by side as words of a text, which a blank cell keeps apart; only where they do not stand at one height.
    pub(super) fn narrow(cells: &CellGrid<'_>) -> Self {
        Self { aside: blank(cells, 1), ..Self::wide(cells) }
    }

    /// The same with the least blank side by side.
    pub(super) fn tight(cells: &CellGrid<'_>) -> Self {
        Self { aside: Self::least(cells).aside, ..Self::narrow(cells) }
    }

    /// The blank between two labels of these kinds, and whether they are read as two though they stand near to each
    /// other in one line. The signs of two poles may be as near as `narrow` says, as the plates of a battery are nearer
    /// than the columns of a table: one that stands farther off is of neither.
    pub(super) fn between(self, kinds: [Option<Alone>; 2], narrow: Self) -> (Self, bool) {
        match kinds {
            [Some(Alone::Sign), Some(Alone::Sign)] => (Self { aside: self.aside.min(narrow.aside), ..self }, true),
            [Some(Alone::Number), Some(Alone::Number)] => (self, true),
            _ => (self, false),
        }
    }
}

/// Blank between the dots of two cells with so many blank cells between them, mm.
fn blank(cells: &CellGrid<'_>, count: usize) -> f32 {
    let of_all = cells.extent(count + 2, 1).x;
    // a little less, for dots that lie off by rounding
    of_all - 2.0 * cells.extent(1, 1).x - 0.1
}

#[cfg(test)]
mod tests;
