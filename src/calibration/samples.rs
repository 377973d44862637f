//! The samples themselves, each with its label.

use super::flow::{Block, SheetMarks};
use super::headings::BLANK as LABEL_GAP;
use crate::braille::{self, CellSize};
use crate::classes::Class;
use crate::lines::{Line, Run};
use crate::page::Dots;
use crate::page::frame as frames;
use crate::page::layout::FrameParams;
use crate::textures;
use crate::units::{MmPoint, MmRect, MmVector};

/// Length of a sample of lines, mm, round ends included. Chosen by us: twice 12.5 mm, which is quoted from BANA for
/// main lines.
const LENGTH: f32 = 25.0;
/// Blank between the samples of a table, mm. A study of guide maps found 5 mm between textures easiest to read.
const CELL_GAP: f32 = 5.0;
/// Least side of a texture's sample, mm: 13 x 13 mm is quoted as the smallest area whose texture can be identified.
const SIDE: f32 = 13.0;
/// Inner width and height of a frame's sample, mm.
const FRAMED: [f32; 2] = [20.0, 10.0];

/// Dots of some cells as a block.
fn label(cells: &[u8]) -> Block {
    of_cells(cells, CellSize::MARBURG)
}

/// The same in cells of these measures.
fn of_cells(cells: &[u8], size: CellSize) -> Block {
    let labels = vec![Dots { diameter: braille::PRINTED, at: size.dots(cells, braille::PRINTED) }];
    Block {
        size: size.extent(cells.len(), braille::PRINTED),
        marks: SheetMarks { labels, ..SheetMarks::default() },
        ..Block::default()
    }
}

/// A sample above its number, both centred.
pub(super) fn numbered(number: usize, sample: &Block) -> Block {
    let label = label(&braille::number(number));
    let width = label.size.x.max(sample.size.x);
    let mut block = Block { size: MmVector::new(width, sample.size.y + LABEL_GAP + label.size.y), ..Block::default() };
    block.marks.add(&sample.marks, MmVector::new(0.5 * (width - sample.size.x), 0.0));
    block.marks.add(&label.marks, MmVector::new(0.5 * (width - label.size.x), sample.size.y + LABEL_GAP));
    block
}

/// A sample with additional blank after it, mm, so that it is not taken for a part of the next.
pub(super) fn apart(blank: f32, block: Block) -> Block {
    Block { size: block.size + MmVector::new(blank, 0.0), ..block }
}

/// How many cells of braille a line of this width holds.
pub(super) fn cells_in(width: f32) -> usize {
    CellSize::MARBURG.cells_in(width, braille::PRINTED)
}

/// What stands above a section, in lines of cells.
pub(super) fn heading(lines: &[Vec<u8>]) -> Block {
    let mut block = Block { starts_row: true, keeps: true, ..Block::default() };
    for (i, line) in lines.iter().enumerate() {
        let line = label(line);
        let top = i as f32 * CellSize::MARBURG.line;
        block.marks.add(&line.marks, MmVector::new(0.0, top));
        block.size = block.size.max(line.size + MmVector::new(0.0, top));
    }
    block
}

/// Upright lines of these widths side by side, with `gap` between their edges.
pub(super) fn lines(widths: &[f32], gap: f32, strength: f32) -> Block {
    let mut block = Block::default();
    let mut left = 0.0;
    for &width in widths {
        let x = left + 0.5 * width;
        let points = [0.5 * width, LENGTH - 0.5 * width].map(|y| MmPoint::new(x, y)).to_vec();
        block.marks.lines.push(Line { strength, runs: vec![Run::stroke(width, points)] });
        left += width + gap;
    }
    block.size = MmVector::new(left - gap, LENGTH);
    block
}

/// A few braille cells of these measures.
pub(super) fn braille_trial(cell: CellSize) -> Block {
    of_cells(&braille::TRIAL, cell)
}

/// An empty frame.
pub(super) fn frame(params: &FrameParams) -> Block {
    let corner = MmPoint::new(params.width, params.width);
    let inner = MmRect::new(corner, corner + MmVector::from(FRAMED));
    let at = frames::printed(inner, &FrameParams { gap: 0.0, ..*params }).at;
    let size = MmVector::from(FRAMED) + MmVector::splat(2.0 * params.width);
    Block { size, marks: SheetMarks { frame: at, ..SheetMarks::default() }, ..Block::default() }
}

/// Side of a texture's sample, mm: three rows of the sparse texture, which has every other row, fit into it.
pub(super) fn side(params: &textures::Params) -> f32 {
    SIDE.max(6.0 * params.along.max(params.across).max(params.dot_pitch))
}

/// A square of the texture that pages have for a colour of this class and lightness where lines have this density,
/// 0..=1.
pub(super) fn texture(class: Class, lightness: f32, density: f32, side: f32, params: &textures::Params) -> Block {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(side, side));
    let textures = vec![textures::sample(class, lightness, density, area, params)];
    Block { size: area.size().to_vector(), marks: SheetMarks { textures, ..SheetMarks::default() }, ..Block::default() }
}

/// Two samples, one above the other.
pub(super) fn stacked(above: &Block, below: &Block) -> Block {
    let top = above.size.y + LABEL_GAP;
    let size = MmVector::new(above.size.x.max(below.size.x), top + below.size.y);
    let mut block = Block { size, ..Block::default() };
    block.marks.add(&above.marks, MmVector::zero());
    block.marks.add(&below.marks, MmVector::new(0.0, top));
    block
}

/// A table of samples of one size with the numbers of the columns above and of the rows to the left.
pub(super) fn table(rows: &[Vec<Block>]) -> Block {
    let number = |n: usize| label(&braille::number(n + 1));
    let cell = rows.iter().flatten().fold(MmVector::zero(), |size, block| size.max(block.size));
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let (left, top) = (number(0).size.x + LABEL_GAP, number(0).size.y + LABEL_GAP);
    let at = |column: usize, row: usize| {
        MmVector::new(left + column as f32 * (cell.x + CELL_GAP), top + row as f32 * (cell.y + CELL_GAP))
    };
    let mut block = Block { size: at(columns, rows.len()) - MmVector::splat(CELL_GAP), ..Block::default() };
    for column in 0..columns {
        let number = number(column);
        block.marks.add(&number.marks, MmVector::new(at(column, 0).x + 0.5 * (cell.x - number.size.x), 0.0));
    }
    for (i, row) in rows.iter().enumerate() {
        let number = number(i);
        block.marks.add(&number.marks, MmVector::new(0.0, at(0, i).y + 0.5 * (cell.y - number.size.y)));
        for (column, sample) in row.iter().enumerate() {
            block.marks.add(&sample.marks, at(column, i));
        }
    }
    block
}
