//! The dots of one page.

/// The dots of a page on a device's grid, each with a height class: 0 is none, 1 low (textures), 2 middle (the frame, weak
/// lines), 3 high (lines). Devices with one height raise every dot that is not 0.
///
/// What lies beyond the last column or row reads as blank.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Matrix {
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

impl Matrix {
    /// The highest class.
    pub const HIGHEST: u8 = 3;

    /// No dot anywhere. Takes a byte of memory a place.
    pub fn new(columns: usize, rows: usize) -> Self {
        Self { columns, heights: vec![0; columns * rows] }
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
        self.place(x, y).map_or(0, |place| self.heights[place])
    }

    /// Whether there is a dot at this column and row.
    pub fn is_raised(&self, x: usize, y: usize) -> bool {
        self.height(x, y) != 0
    }

    /// Raises the dot at this column and row to a height class; a higher one stays, so that it does not matter what is drawn
    /// first. Beyond the matrix nothing happens, and beyond [`Matrix::HIGHEST`] is the highest.
    pub fn raise(&mut self, x: usize, y: usize, height: u8) {
        if let Some(place) = self.place(x, y) {
            self.heights[place] = height.min(Self::HIGHEST).max(self.heights[place]);
        }
    }

    /// Takes the dot at this column and row away.
    pub fn clear(&mut self, x: usize, y: usize) {
        if let Some(place) = self.place(x, y) {
            self.heights[place] = 0;
        }
    }

    /// How many dots there are.
    pub fn count(&self) -> usize {
        self.heights.iter().filter(|&&height| height != 0).count()
    }

    /// The heights of a row from left to right; empty beyond the last one.
    pub fn row(&self, y: usize) -> &[u8] {
        self.place(0, y).map_or(&[], |first| &self.heights[first..first + self.columns])
    }

    /// Where a dot is in `heights`, if it is in the matrix.
    fn place(&self, x: usize, y: usize) -> Option<usize> {
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

    /// Raises the dots of a cell of two columns and `dots / 2` rows to the highest class.
    pub(super) fn raise_cell(&mut self, cx: usize, cy: usize, dots: usize, cell: u8) {
        for (bit, (x, y)) in CELL[..dots].iter().enumerate() {
            if cell >> bit & 1 == 1 {
                self.raise(2 * cx + x, cy * dots / 2 + y, Self::HIGHEST);
            }
        }
    }

    /// The matrix of a picture as `Display` draws it: `.` for none, `-` low, `+` middle, `#` high. Anything else is none, and
    /// short rows are filled up.
    pub fn drawn(picture: &str) -> Self {
        let columns = picture.lines().map(|row| row.chars().count()).max().unwrap_or(0);
        let mut matrix = Self::new(columns, picture.lines().count());
        for (y, row) in picture.lines().enumerate() {
            for (x, sign) in row.chars().enumerate() {
                matrix.raise(x, y, SIGNS.iter().position(|&known| known == sign).unwrap_or(0) as u8);
            }
        }
        matrix
    }
}

/// What `Display` draws for each height class.
const SIGNS: [char; 4] = ['.', '-', '+', '#'];

impl std::fmt::Display for Matrix {
    /// A picture with a sign a dot, a row a line.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for y in 0..self.rows() {
            let row: String = self.row(y).iter().filter_map(|&height| SIGNS.get(usize::from(height))).collect();
            writeln!(f, "{row}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_comes_back() {
        let picture = "#..-\n.+..\n....\n...#\n";
        let matrix = Matrix::drawn(picture);
        assert_eq!((matrix.columns(), matrix.rows(), matrix.count()), (4, 4, 4));
        assert_eq!(matrix.to_string(), picture);
        assert_eq!([(0, 0), (3, 0), (1, 1), (2, 2)].map(|(x, y)| matrix.height(x, y)), [3, 1, 2, 0]);
    }

    #[test]
    fn beyond_the_matrix_is_blank() {
        let mut matrix = Matrix::drawn("##\n##\n");
        for (x, y) in [(2, 0), (0, 2), (2, 1), (usize::MAX, 0), (0, usize::MAX)] {
            assert!(!matrix.is_raised(x, y), "{x} {y}");
            matrix.raise(x, y, 3);
            matrix.clear(x, y);
        }
        assert_eq!(matrix.to_string(), "##\n##\n");
        assert_eq!((matrix.cell8(0, 0), matrix.cell8(1, 0), matrix.cell6(0, 1)), (0x1b, 0, 0));
        assert!(matrix.row(2).is_empty());
        let none = Matrix::new(0, 5);
        assert_eq!((none.rows(), none.count(), none.cell8(0, 0)), (0, 0, 0));
    }

    #[test]
    fn the_higher_dot_stays() {
        let mut matrix = Matrix::new(1, 1);
        for (height, want) in [(2, 2), (1, 2), (3, 3), (9, 3), (0, 3)] {
            matrix.raise(0, 0, height);
            assert_eq!(matrix.height(0, 0), want);
        }
        matrix.clear(0, 0);
        assert_eq!(matrix.height(0, 0), 0);
    }

    #[test]
    fn cells_are_those_of_unicode() {
        // Braille's own numbers: 1 2 3 7 down the left side, 4 5 6 8 down the right one.
        let numbers = [[1, 4], [2, 5], [3, 6], [7, 8]];
        for (y, row) in numbers.iter().enumerate() {
            for (x, number) in row.iter().enumerate() {
                let mut matrix = Matrix::new(4, 8);
                matrix.raise(2 + x, 4 + y, 1);
                assert_eq!(matrix.cell8(1, 1), 1 << (number - 1));
                if y < 3 {
                    let mut matrix = Matrix::new(4, 6);
                    matrix.raise(2 + x, 3 + y, 1);
                    assert_eq!(matrix.cell6(1, 1), 1 << (number - 1));
                }
            }
        }
        for dots in [6, 8] {
            for cell in 0..=(1_u16 << dots) - 1 {
                let mut matrix = Matrix::new(6, 12);
                matrix.raise_cell(2, 1, dots, cell as u8);
                let back = if dots == 6 { matrix.cell6(2, 1) } else { matrix.cell8(2, 1) };
                assert_eq!((u16::from(back), matrix.count() as u32), (cell, cell.count_ones()));
            }
        }
    }
}
