//! Texts of braille cells and pictures in characters, read into dot matrices: what writers are checked with.

use tactograph::internals::output::dots::DotMatrix;

/// Columns and rows of the eight dots of a cell in the order of their bits in Unicode.
const BITS: [(usize, usize); 8] = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3)];

/// The characters of ASCII braille (North American table) for the cells U+2800 to U+283F.
const ASCII: &str = r##" A1B'K2L@CIF/MSP"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\0Z7(_?W]#Y)="##;

/// The pages of Unicode braille.
pub fn ubrl(text: &str) -> Vec<DotMatrix> {
    pages(text, 8, |c| u32::from(c).checked_sub(0x2800))
}

/// The pages of ASCII braille.
pub fn brf(text: &str) -> Vec<DotMatrix> {
    pages(text, 6, |c| ASCII.chars().position(|known| known == c).map(|cell| cell as u32))
}

/// The pages of a text of cells of so many dots.
fn pages(text: &str, dots: usize, cell: impl Fn(char) -> Option<u32>) -> Vec<DotMatrix> {
    let page = |page: &str| {
        let columns = page.lines().map(|line| line.chars().count()).max().unwrap_or(0);
        let mut matrix = matrix(2 * columns, dots / 2 * page.lines().count());
        for (row, line) in page.lines().enumerate() {
            for (column, c) in line.chars().enumerate() {
                let cell = cell(c).filter(|&cell| cell < 1 << dots).unwrap_or_else(|| panic!("{c:?} is no cell"));
                for (_, (x, y)) in BITS.iter().enumerate().filter(|(bit, _)| cell >> bit & 1 == 1) {
                    matrix.raise(2 * column + x, dots / 2 * row + y, DotMatrix::HIGHEST);
                }
            }
        }
        matrix
    };
    text.split_terminator('\u{c}').map(page).collect()
}

/// The matrix of a picture in characters: a full stop or a space is no dot, anything else a high one.
pub fn drawn(picture: &str) -> DotMatrix {
    let columns = picture.lines().map(|row| row.chars().count()).max().unwrap_or(0);
    let mut matrix = matrix(columns, picture.lines().count());
    for (y, row) in picture.lines().enumerate() {
        for (x, _) in row.chars().enumerate().filter(|(_, c)| !['.', ' '].contains(c)) {
            matrix.raise(x, y, DotMatrix::HIGHEST);
        }
    }
    matrix
}

/// A matrix without dots.
pub fn matrix(columns: usize, rows: usize) -> DotMatrix {
    DotMatrix::new(columns, rows).expect("not more dots than there can be")
}
