//! The title and the page number in braille: how much room they take at the top of a sheet, and their dots there.
//!
//! ```text
//!  margin
//!   |  first line, centred   12     \   the mark has its corner to itself
//!   |      second line               \
//!   |  gap
//!   |  ::::: frame :::::
//! ```

use super::cells::CellGrid;
use super::medium::Medium;
use crate::braille::{Braille, CellSize, Divide, wrap, wrap_beside};
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
    /// In how many cells the title takes one line, two and three: with whole words, and with divided ones.
    widths: [[usize; MOST_LINES]; 2],
    /// The same where its first line in the middle leaves `blank` cells on either side to what stands there.
    widths_beside: [[usize; MOST_LINES]; 2],
    /// How many cells these are.
    blank: usize,
    /// How many cells the title has; 0 without one.
    title: usize,
    /// How many cells the page number has; 0 without one.
    number: usize,
    /// Measures of the cells.
    pub cell: CellSize,
    /// Where its lines begin.
    pub align: Align,
}

/// Blank cells between a title and the page number: as transcribers leave between a running head and the number.
const BEFORE_NUMBER: usize = 3;

/// Room for a title and a page number on a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heading {
    /// Where its lines are.
    pub place: MmRect,
    /// How many cells a line holds.
    pub cells: usize,
    /// How many the first one holds.
    first: usize,
    /// How many lines the title has; 0 without one, or if it has no room.
    pub lines: usize,
    /// Where the page number begins.
    number: MmPoint,
    divide: Divide,
    params: HeadingParams,
}

impl HeadingParams {
    /// For this title, with a page number of so many cells; none for neither.
    pub fn of(title: &Braille, number: usize, cell: CellSize, align: Align) -> Option<Self> {
        // a longer one fits on no sheet, and looking for its widths would take long
        let length = title.cells.len().min(MOST_CELLS);
        if length == 0 && number == 0 {
            return None;
        }
        let widths = [Divide::Never, Divide::Words].map(|divide| {
            let lines = |width: usize| wrap(title, width, divide).lines.len();
            let least = |most: usize| (1..=length).find(|&width| lines(width) <= most).unwrap_or(length);
            // a width that cuts no word, where there is one
            let whole = (1..=length).find(|&width| !wrap(title, width, divide).cut).unwrap_or(length);
            match title.cells.len() {
                ..=MOST_CELLS => [1, 2, 3].map(|most| least(most).max(whole)),
                _ => [usize::MAX; MOST_LINES],
            }
        });
        let blank = if number == 0 { 0 } else { number + BEFORE_NUMBER };
        let widths_beside = match (blank, title.cells.len()) {
            (0, _) => widths,
            (_, ..=MOST_CELLS) => [Divide::Never, Divide::Words].map(|divide| least_beside(title, blank, divide)),
            _ => [[usize::MAX; MOST_LINES]; 2],
        };
        Some(Self { widths, widths_beside, blank, title: title.cells.len(), number, cell, align })
    }

    /// The same where so many cells stand in each corner, if not those of the page number.
    pub fn beside(self, cells: usize) -> Self {
        Self { number: self.number.max(cells), ..self }
    }

    /// In how many lines the title has room, with how many cells in the first one and in the others: if the first holds
    /// `first`, and the others `others` where it stands in the middle.
    fn lines_of(&self, divide: Divide, first: usize, others: usize) -> Option<(usize, [usize; 2])> {
        let which = usize::from(divide == Divide::Words);
        let (alike, beside) = (self.widths[which], self.widths_beside[which]);
        let of_lines = |at: usize| {
            let is_beside = || {
                let of_first = beside[at].saturating_sub(2 * self.blank);
                (beside[at] <= others && of_first <= first).then_some([of_first, beside[at]])
            };
            let cells = if alike[at] <= first { Some([alike[at]; 2]) } else { is_beside() };
            cells.map(|cells| (at + 1, cells))
        };
        (0..MOST_LINES).find_map(of_lines)
    }
}

/// In how many cells a title takes one line, two and three without a word cut, if its first line has `blank` cells less
/// on either side.
fn least_beside(title: &Braille, blank: usize, divide: Divide) -> [usize; MOST_LINES] {
    let wrapped = |width: usize| wrap_beside(title, width - 2 * blank, width, divide);
    let mut least = [usize::MAX; MOST_LINES];
    for width in 2 * blank + 1..=2 * blank + title.cells.len() {
        let with_width = wrapped(width);
        let lines = with_width.lines.len();
        // as few lines are in as many as well
        for of_lines in least.iter_mut().skip(lines.saturating_sub(1)).filter(|_| !with_width.cut) {
            *of_lines = width.min(*of_lines);
        }
        if least[0] < usize::MAX {
            break;
        }
    }
    least
}

impl Heading {
    /// Room below the top margin of a sheet of this size, `beside` mm from its corners for the mark; none if there is
    /// too little, or the title is too long for three lines and there is no number.
    pub(super) fn on(
        params: &HeadingParams,
        cells: &CellGrid<'_>,
        size: [f32; 2],
        margin: f32,
        beside: f32,
    ) -> Option<Self> {
        let as_asked = Self::aligned(params, cells, size, margin, beside);
        let has_title = |heading: &Self| heading.lines > 0;
        if params.title == 0 || params.number == 0 || as_asked.as_ref().is_some_and(has_title) {
            return as_asked;
        }
        // in the middle a title leaves as much blank on its left as the number takes: on the left it has more room
        let left = HeadingParams { align: Align::Left, ..*params };
        Self::aligned(&left, cells, size, margin, beside).filter(has_title).or(as_asked)
    }

    fn aligned(
        params: &HeadingParams,
        cells: &CellGrid<'_>,
        [width, height]: [f32; 2],
        margin: f32,
        beside: f32,
    ) -> Option<Self> {
        let inner = width - 2.0 * margin;
        let of_number = cells.extent(params.number, 1).x;
        // on either side, so that a title in the middle stays there
        let taken = match params.number {
            0 => beside,
            _ => beside + of_number + BEFORE_NUMBER as f32 * cells.size().cell,
        };
        let (left, free) = match params.align {
            Align::Centre => (margin + taken, inner - 2.0 * taken),
            Align::Left => (margin, inner - taken),
        };
        let number_at = MmPoint::new(width - margin - beside - of_number, margin);
        if number_at.x < margin {
            return None;
        }
        let most = cells.cells_in(free);
        // only the first line of a title in the middle stands beside the number
        let most_below = match params.align {
            Align::Centre => cells.cells_in(inner - 2.0 * beside),
            Align::Left => 0,
        };
        // whole words, if three lines are enough for them
        let fits = |divide: Divide| Some((divide, params.lines_of(divide, most, most_below)?));
        let fitting = (params.title > 0).then(|| fits(Divide::Never).or_else(|| fits(Divide::Words))).flatten();
        let of_lines = |lines: usize| {
            let extent = cells.extent(most, lines.max(1));
            let place = MmRect::new(MmPoint::new(left, margin), MmPoint::new(left + free.max(0.0), margin + extent.y));
            (extent.y + GAP <= MOST_SHARE * height).then_some(place)
        };
        // lines of about one length rather than full ones and a short one
        let with_title = fitting.and_then(|(divide, (lines, [first, cells]))| {
            let place = of_lines(lines)?;
            Some(Self { place, cells, first, lines, number: number_at, divide, params: *params })
        });
        let number_alone = || {
            let place = of_lines(0).filter(|_| params.number > 0)?;
            let divide = Divide::Never;
            Some(Self { place, cells: 0, first: 0, lines: 0, number: number_at, divide, params: *params })
        };
        with_title.or_else(number_alone)
    }

    /// How far below the margin the rest of the page begins, mm.
    pub(super) fn height(&self) -> f32 {
        self.place.height() + GAP
    }

    /// The same with the cells of a label in the left corner: lines that begin there move behind it, as far as the page
    /// number is wide, for which there is room.
    pub(super) fn after_label(self, cells: &CellGrid<'_>) -> Self {
        let by = match self.params.align {
            Align::Centre => 0.0,
            Align::Left => cells.extent(self.params.number, 1).x + BEFORE_NUMBER as f32 * cells.size().cell,
        };
        Self { place: self.place.translate(MmVector::new(by, 0.0)), ..self }
    }

    /// The same on a sheet whose corner lies elsewhere.
    pub(super) fn translated(self, by: MmVector) -> Self {
        Self { place: self.place.translate(by), number: self.number + by, ..self }
    }

    /// The lines of the title as they stand on the sheet.
    pub fn lines(&self, title: &Braille) -> Vec<Vec<u8>> {
        if self.lines == 0 {
            return Vec::new();
        }
        let wrapped = |width: usize| wrap_beside(title, self.first.min(width), width, self.divide);
        // beside a number the first line is shorter, and the others no longer than they must be
        let is_enough = |width: &usize| {
            let wrapped = wrapped(*width);
            wrapped.lines.len() <= self.lines && !wrapped.cut
        };
        let least = (self.first..self.cells).find(is_enough).unwrap_or(self.cells);
        wrapped(least).lines
    }

    /// The dots of the page number, which has these cells.
    pub fn dots_of_number(&self, number: &[u8], medium: &Medium) -> Vec<MmPoint> {
        // one that has a digit less ends where the others end
        let cells = CellGrid::of(medium, self.params.cell);
        let shorter = cells.extent(self.params.number, 1).x - cells.extent(number.len(), 1).x;
        cells.dots(&[number.to_vec()], self.number + MmVector::new(shorter.max(0.0), 0.0))
    }

    /// The dots of the title.
    pub fn dots(&self, title: &Braille, medium: &Medium) -> Vec<MmPoint> {
        let cells = CellGrid::of(medium, self.params.cell);
        let of_line = |(number, line): (usize, Vec<u8>)| {
            let indent = match self.params.align {
                Align::Centre => 0.5 * (self.place.width() - cells.extent(line.len(), 1).x),
                Align::Left => 0.0,
            };
            // below the first line, which has this place to itself, others may begin before it
            let indent = if number == 0 { indent.max(0.0) } else { indent };
            let down = number as f32 * cells.size().line;
            cells.dots(&[line], self.place.min + MmVector::new(indent, down))
        };
        self.lines(title).into_iter().enumerate().flat_map(of_line).collect()
    }
}

#[cfg(test)]
mod tests;
