//! Dots on a device's grid, and the files that embossers, braille programs and pin displays take.
//!
//! Every writer takes the pages of a document, in order, and gives the same bytes for the same dots.
//!
//! | module | for whom | dots |
//! |---|---|---|
//! | [`ubrl`] | CUPS, and whoever reads Unicode | cells of 8 |
//! | [`pef`] | programs and embossers that know the Portable Embosser Format | cells of 8 |
//! | [`brf`] | every other embosser | cells of 6, which do not lie evenly on paper |
//! | [`index`] | Index embossers, straight | bands of 4 rows |
//! | [`art`] | eyes, braille displays, screen readers | a letter a dot |
//! | [`greys`] | ViewPlus's own driver, pin displays | a pixel a dot, with heights |
//! | [`gcode`] | BrailleRAP | anywhere, in the order of [`path_order`] |

pub mod art;
pub mod brf;
pub mod gcode;
pub mod greys;
pub mod index;
mod matrix;
mod of_page;
pub mod path_order;
pub mod pef;
pub mod ubrl;

pub use matrix::Matrix;
pub use of_page::dots;

/// What a document is called, for formats that say so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Words<'a> {
    /// Its name.
    pub title: &'a str,
    /// What is on it, in plain words; may be empty.
    pub description: &'a str,
    /// The language of both as in BCP 47, such as `en`; empty if nobody knows.
    pub language: &'a str,
}

/// What is between pages, and after the last one.
const FORM_FEED: char = '\u{c}';

/// How a text of braille cells is read: how many dots a cell has, and what each character says.
struct Reading {
    dots: usize,
    cell: fn(char) -> Option<u8>,
    /// What every character should have been.
    wanted: &'static str,
}

/// The pages of a text of cells: lines end with LF or CR LF, and a form feed ends a page. The last page may do without.
fn read(text: &str, reading: &Reading) -> Result<Vec<Matrix>, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.is_empty() {
        return Ok(Vec::new());
    }
    let text = text.strip_suffix(FORM_FEED).unwrap_or(text);
    let mut pages = Vec::new();
    let mut line_number = 0;
    for page in text.split(FORM_FEED) {
        let mut rows = Vec::new();
        for line in page.lines() {
            line_number += 1;
            let cell = |(i, c): (usize, char)| {
                (reading.cell)(c)
                    .ok_or_else(|| format!("line {line_number}, character {}: {c:?} is not {}", i + 1, reading.wanted))
            };
            rows.push(line.chars().enumerate().map(cell).collect::<Result<Vec<_>, _>>()?);
        }
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut matrix = Matrix::new(2 * columns, reading.dots / 2 * rows.len());
        for (cy, row) in rows.iter().enumerate() {
            for (cx, &cell) in row.iter().enumerate() {
                matrix.raise_cell(cx, cy, reading.dots, cell);
            }
        }
        pages.push(matrix);
    }
    Ok(pages)
}
