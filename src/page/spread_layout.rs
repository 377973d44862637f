//! How many sheets a picture is spread over, and where on them it lies; [`spread`](super::spread) says how.

use std::str::FromStr;

use super::heading::Heading;
use super::medium::Medium;
use super::parts::Run;
use super::sheet::{self, MarkParams, Params};
use crate::Error;
use crate::units::{MmPoint, MmRect, MmVector};

/// How many sheets there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SheetGrid {
    pub(super) across: u32,
    pub(super) down: u32,
}

impl SheetGrid {
    /// Most sheets across or down: the label of a row is a letter, that of a column a digit.
    pub const MOST: u32 = 9;

    /// `across` sheets by `down` sheets.
    ///
    /// # Errors
    /// [`Error::NotASheetGrid`] unless both are from 1 to [`SheetGrid::MOST`] and there are at least two sheets.
    pub fn new(across: u32, down: u32) -> Result<Self, Error> {
        let good = |count| (1..=Self::MOST).contains(&count);
        let fits = good(across) && good(down) && across * down > 1;
        fits.then_some(Self { across, down }).ok_or(Error::NotASheetGrid)
    }

    /// How many sheets lie side by side.
    pub fn across(self) -> u32 {
        self.across
    }

    /// How many sheets lie one above the other.
    pub fn down(self) -> u32 {
        self.down
    }

    /// All grids, those of fewer sheets first; of as many sheets, the nearer to a square.
    pub fn by_number() -> impl Iterator<Item = Self> {
        let all =
            (1..=Self::MOST).flat_map(|across| (1..=Self::MOST).filter_map(move |down| Self::new(across, down).ok()));
        let mut all: Vec<Self> = all.collect();
        all.sort_by_key(|grid| (grid.across * grid.down, grid.across.abs_diff(grid.down)));
        all.into_iter()
    }

    /// Every sheet as (column, row), row by row from the top left.
    pub fn sheets(self) -> impl Iterator<Item = (u32, u32)> {
        (0..self.down).flat_map(move |row| (0..self.across).map(move |column| (column, row)))
    }
}

impl FromStr for SheetGrid {
    type Err = Error;

    /// How many sheets lie side by side and how many one above the other, such as `2x3`.
    ///
    /// # Errors
    /// [`Error::NotASheetGrid`] for a text that says no number of sheets.
    fn from_str(text: &str) -> Result<Self, Error> {
        let counts =
            text.split_once(['x', 'X']).and_then(|(a, b)| Some((a.trim().parse().ok()?, b.trim().parse().ok()?)));
        counts.ok_or(Error::NotASheetGrid).and_then(|(across, down)| Self::new(across, down))
    }
}

impl std::fmt::Display for SheetGrid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}", self.across, self.down)
    }
}

/// Length of a tick, mm. Chosen by us: a fingertip covers all of it, so that it is not followed as a line.
pub(super) const TICK: f32 = 5.0;
/// Blank between ticks and the window, and between them and what lies above, mm: the 1/8 inch rule (L. Hasty), the
/// least between any two things.
pub(super) const GAP: f32 = 3.2;

/// Where a picture lies on its sheets.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    pub(super) grid: SheetGrid,
    /// Width and height of every sheet as it lies.
    pub sheet: [f32; 2],
    /// The picture in the space of all sheets together.
    pub figure: MmRect,
    /// The orientation mark of every sheet.
    pub mark: Option<Run>,
    /// Title and page number of every sheet, beside the braille that says which it is.
    pub heading: Option<Heading>,
    /// What a sheet is made for.
    pub medium: Medium,
    /// The same of all sheets together: on a grid, with the dots of all.
    pub together: Medium,
    /// The first window in the space of all sheets.
    pub(super) first: MmRect,
    /// The top left corner of a window on its sheet.
    pub(super) corner: MmPoint,
    /// From window to window.
    pub(super) step: MmVector,
    /// From the edges of a window to the middle of an overlap.
    pub(super) half: MmVector,
    /// From the edge of a window to both ends of its ticks, mm.
    pub(super) tick: [f32; 2],
    /// Where the braille begins that says which sheet it is.
    pub(super) label: MmPoint,
}

/// Most cells of the braille that says which sheet it is: a letter, the number sign and a digit.
pub const LABEL_CELLS: usize = 3;

/// What is laid out.
#[derive(Clone, Copy)]
pub(super) struct SpreadPicture {
    pub(super) aspect: f32,
    pub(super) widest: f32,
    pub(super) grid: SheetGrid,
    pub(super) overlap: f32,
}

impl SpreadPicture {
    /// Its place in the middle of a rectangle, with this border around it; none without room.
    pub(super) fn within(&self, total: MmRect, border: f32) -> Option<MmRect> {
        let width = (total.width() - 2.0 * border).min((total.height() - 2.0 * border) * self.aspect).min(self.widest);
        let half = MmVector::new(0.5 * width, 0.5 * width / self.aspect);
        (width > 0.0).then(|| MmRect::new(total.center() - half, total.center() + half))
    }

    /// All windows together, of which this is the first.
    pub(super) fn total(&self, first: MmRect, step: MmVector) -> MmRect {
        let steps = MmVector::new((self.grid.across - 1) as f32, (self.grid.down - 1) as f32);
        MmRect::new(first.min, first.max + steps.component_mul(step))
    }
}

/// How far below the margin a window begins with its ticks: below the mark, the title and the braille that says which
/// sheet it is.
pub(super) fn above(params: &Params, label: f32, heading: Option<&Heading>) -> f32 {
    let mark = |mark: MarkParams| (sheet::reach(mark), mark.gap.max(GAP));
    let (mark_height, gap) = params.mark.map_or((0.0, GAP), mark);
    mark_height.max(label).max(heading.map_or(0.0, |heading| heading.place.height())) + gap
}

#[cfg(test)]
mod tests;
