//! The title in braille: how much room it takes at the top of a sheet, and its dots there.
//!
//! ```text
//!  margin
//!   |  first line, centred          \   the mark has its corner to itself
//!   |      second line               \
//!   |  gap
//!   |  ::::: frame :::::
//! ```

use super::cells::CellGrid;
use super::medium::Medium;
use crate::braille::{Braille, CellSize, wrap};
use crate::units::{MmPoint, MmRect, MmVector};

/// Most lines of a title.
pub const MOST_LINES: usize = 3;
/// Blank between the title and the frame, mm: the 1/4 inch that the TSBVI math project asks for between any two things,
/// and the dots of a frame must not be read as a line of braille.
const GAP: f32 = 8.0;
/// Most of a sheet's height that a title may take, as a share: a display of 40 rows of pins has room for one line.
const MOST_SHARE: f32 = 0.2;

/// Most cells of a title that is looked at: twice three lines of the widest sheet.
const MOST_CELLS: usize = 1000;

/// Where lines of braille begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Align {
    /// In the middle.
    #[default]
    Centre,
    /// On the left.
    Left,
}

impl Align {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Centre, Self::Left];

    /// Its name, as profiles have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Centre => "centre",
            Self::Left => "left",
        }
    }
}

/// What the layout needs to know of a title.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadingParams {
    /// In how many cells the title takes one line, two and three.
    pub widths: [usize; MOST_LINES],
    /// Measures of the cells.
    pub cell: CellSize,
    /// Where its lines begin.
    pub align: Align,
}

/// Room for a title on a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heading {
    /// Where its lines are.
    pub place: MmRect,
    /// How many cells a line holds.
    pub cells: usize,
    /// How many lines there are.
    pub lines: usize,
    params: HeadingParams,
}

impl HeadingParams {
    /// For this title; none for one without cells.
    pub fn of(title: &Braille, cell: CellSize, align: Align) -> Option<Self> {
        // a longer one fits on no sheet, and looking for its widths would take long
        let length = title.cells.len().min(MOST_CELLS);
        let lines = |width: usize| wrap(title, width).lines.len();
        let least = |most: usize| (1..=length).find(|&width| lines(width) <= most).unwrap_or(length);
        // a width that cuts no word, where there is one
        let whole = (1..=length).find(|&width| !wrap(title, width).cut).unwrap_or(length);
        let widths = match title.cells.len() {
            0 => return None,
            1..=MOST_CELLS => [1, 2, 3].map(|most| least(most).max(whole)),
            _ => [usize::MAX; MOST_LINES],
        };
        Some(Self { widths, cell, align })
    }
}

impl Heading {
    /// Room below the top margin of a sheet of this size, `beside` mm from its corners for the mark; none if there is
    /// too little, or the title is too long for three lines.
    pub(super) fn on(
        params: &HeadingParams,
        cells: &CellGrid<'_>,
        [width, height]: [f32; 2],
        margin: f32,
        beside: f32,
    ) -> Option<Self> {
        let inner = width - 2.0 * margin;
        let (left, free) = match params.align {
            Align::Centre => (margin + beside, inner - 2.0 * beside),
            Align::Left => (margin, inner - beside),
        };
        let most = cells.cells_in(free);
        let number = params.widths.iter().position(|&width| width <= most)?;
        let lines = number + 1;
        let extent = cells.extent(most, lines);
        let place = MmRect::new(MmPoint::new(left, margin), MmPoint::new(left + free, margin + extent.y));
        let is_low = extent.y + GAP <= MOST_SHARE * height;
        // lines of about one length rather than full ones and a short one
        is_low.then_some(Self { place, cells: params.widths[number], lines, params: *params })
    }

    /// How far below the margin the rest of the page begins, mm.
    pub(super) fn height(&self) -> f32 {
        self.place.height() + GAP
    }

    /// The same on a sheet whose corner lies elsewhere.
    pub(super) fn translated(self, by: MmVector) -> Self {
        Self { place: self.place.translate(by), ..self }
    }

    /// The lines of the title as they stand on the sheet.
    pub fn lines(&self, title: &Braille) -> Vec<Vec<u8>> {
        wrap(title, self.cells).lines
    }

    /// The dots of the title.
    pub fn dots(&self, title: &Braille, medium: &Medium) -> Vec<MmPoint> {
        let cells = CellGrid::of(medium, self.params.cell);
        let of_line = |(number, line): (usize, Vec<u8>)| {
            let indent = match self.params.align {
                Align::Centre => 0.5 * (self.place.width() - cells.extent(line.len(), 1).x),
                Align::Left => 0.0,
            };
            let down = number as f32 * cells.size().line;
            cells.dots(&[line], self.place.min + MmVector::new(indent.max(0.0), down))
        };
        self.lines(title).into_iter().enumerate().flat_map(of_line).collect()
    }
}
