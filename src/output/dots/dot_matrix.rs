//! The dots of one page: on its device's grid as a dot matrix, or where they lie.

use crate::devices::DotArea;
use crate::page::{DotMedium, Dots, Height, Medium, Page, Pen, Run};
use crate::units::MmPoint;

/// The dots of a page on a device's grid, each with a height class: 0 is none, 1 low (textures), 2 middle (the frame,
/// weak lines), 3 high (lines). Devices with one height raise every dot that is not 0.
///
/// What lies beyond the last column or row reads as blank.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DotMatrix {
    columns: usize,
    /// Row by row from the top left corner.
    heights: Vec<u8>,
}

/// The eight dots of a cell as Unicode numbers its bits: column and row of each.
///
/// ```text
///  0 3
///  1 4
///  2 5
///  6 7
/// ```
const CELL: [(usize, usize); 8] = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3)];

/// Most dots of a matrix: some thousand times those of any device.
const MOST_DOTS: usize = 100_000_000;

impl DotMatrix {
    /// The highest class.
    pub const HIGHEST: u8 = 3;

    /// No dot anywhere. Takes a byte of memory a dot; `None` if that is more than [`MOST_DOTS`].
    pub fn new(columns: usize, rows: usize) -> Option<Self> {
        let dots = columns.checked_mul(rows).filter(|&dots| dots <= MOST_DOTS)?;
        Some(Self { columns, heights: vec![0; dots] })
    }

    /// The dots of a page of dots, each at its height. `None` if the page is printed, or its device
    /// has no grid.
    pub fn of(page: &Page) -> Option<Self> {
        let Medium::Dots(DotMedium { area: DotArea::Grid(grid), .. }) = &page.medium else { return None };
        let mut matrix = Self::new(grid.columns.len(), grid.rows.len())?;
        for (at, height) in dots(page) {
            if let Some([x, y]) = grid.nearest(at) {
                matrix.raise(x, y, class(height));
            }
        }
        Some(matrix)
    }

    /// Dots from left to right.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Dots from top to bottom.
    pub fn rows(&self) -> usize {
        self.heights.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The height class at this column and row.
    pub fn height(&self, x: usize, y: usize) -> u8 {
        self.index(x, y).map_or(0, |index| self.heights[index])
    }

    /// Whether there is a dot at this column and row.
    pub fn is_raised(&self, x: usize, y: usize) -> bool {
        self.height(x, y) != 0
    }

    /// Raises the dot at this column and row to a height class, unless it is higher already, so that the order of
    /// drawing does not matter. Beyond the matrix nothing happens; a class beyond [`DotMatrix::HIGHEST`] counts as
    /// the highest.
    pub fn raise(&mut self, x: usize, y: usize, height: u8) {
        if let Some(index) = self.index(x, y) {
            self.heights[index] = height.min(Self::HIGHEST).max(self.heights[index]);
        }
    }

    /// How many dots there are.
    pub fn count(&self) -> usize {
        self.heights.iter().filter(|&&height| height != 0).count()
    }

    /// The heights of a row from left to right; empty beyond the last one.
    pub fn row(&self, y: usize) -> &[u8] {
        self.index(0, y).map_or(&[], |first| &self.heights[first..first + self.columns])
    }

    /// The index of a dot in `heights`, if it is in the matrix.
    fn index(&self, x: usize, y: usize) -> Option<usize> {
        (x < self.columns && y < self.rows()).then(|| y * self.columns + x)
    }

    /// The cell of two columns and four rows at column `cx` and row `cy` of such cells, as the low byte of its Unicode
    /// character (U+2800 to U+28FF).
    pub fn cell8(&self, cx: usize, cy: usize) -> u8 {
        self.cell(2 * cx, 4 * cy, 8)
    }

    /// The cell of two columns and three rows at column `cx` and row `cy` of such cells, as the low byte of its Unicode
    /// character (U+2800 to U+283F).
    pub fn cell6(&self, cx: usize, cy: usize) -> u8 {
        self.cell(2 * cx, 3 * cy, 6)
    }

    fn cell(&self, left: usize, top: usize, dots: usize) -> u8 {
        let raised = CELL[..dots].iter().map(|(x, y)| u8::from(self.is_raised(left + x, top + y)));
        raised.enumerate().fold(0, |cell, (bit, raised)| cell | raised << bit)
    }

    /// The matrix of a picture in characters: `.` for none, `-` low, `+` middle, `#` high. Anything else is
    /// none, and short rows are filled up.
    #[cfg(test)]
    pub(super) fn drawn(picture: &str) -> Self {
        let columns = picture.lines().map(|row| row.chars().count()).max().unwrap_or(0);
        let mut matrix = Self::new(columns, picture.lines().count()).expect("a small picture");
        for (y, row) in picture.lines().enumerate() {
            for (x, sign) in row.chars().enumerate() {
                matrix.raise(x, y, ".-+#".find(sign).unwrap_or(0) as u8);
            }
        }
        matrix
    }
}

/// The centres of all dots of a page of dots with their heights, layer by layer.
pub fn dots(page: &Page) -> Vec<(MmPoint, Height)> {
    let mut out = Vec::new();
    let mut all = |dots: &[MmPoint], height| out.extend(dots.iter().map(|&at| (at, height)));
    let run = |run: &Run| match run.pen {
        Pen::Dots(height) => height,
        Pen::Stroke => Height::High,
    };
    let marks = page.orientation_mark.iter().chain(&page.registration);
    marks.for_each(|mark| all(&mark.points, run(mark)));
    all(&page.frame.at, page.height_of_frame());
    for texture in &page.figure.textures {
        texture.glyphs.iter().for_each(|glyph| all(&[glyph.at], page.height_of_textures()));
    }
    page.figure.lines.iter().flat_map(|line| &line.runs).for_each(|piece| all(&piece.points, run(piece)));
    let labels = |dots: &Dots| dots.at.clone();
    let braille = page.braille.iter().map(|text| &text.dots);
    page.braille.iter().filter_map(|text| text.leader.as_ref()).for_each(|leader| all(&leader.points, run(leader)));
    page.labels.iter().chain(braille).for_each(|dots| all(&labels(dots), Height::High));
    out
}

/// The class of a height in a [`DotMatrix`].
fn class(height: Height) -> u8 {
    match height {
        Height::Low => 1,
        Height::Middle => 2,
        Height::High => DotMatrix::HIGHEST,
    }
}

#[cfg(test)]
mod tests;
