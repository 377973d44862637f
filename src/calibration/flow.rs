//! Samples placed on sheets, row by row.

use crate::lines::{Line, Run};
use crate::page::{Dots, Glyph, Texture};
use crate::units::{MmPoint, MmVector};

/// Marks in the coordinates of a sample, a block or a sheet, mm.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct SheetMarks {
    pub(super) lines: Vec<Line>,
    pub(super) textures: Vec<Texture>,
    pub(super) frame: Vec<MmPoint>,
    pub(super) labels: Vec<Dots>,
}

/// A rectangle of marks, which lie between (0, 0) and `size`; it is placed as a whole.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Block {
    pub(super) size: MmVector,
    pub(super) marks: SheetMarks,
    /// Index of its section.
    pub(super) section: usize,
    /// Whether it begins a new row.
    pub(super) starts_row: bool,
    /// Whether its row stays on one sheet with the next.
    pub(super) keeps: bool,
}

/// Blank between blocks side by side, mm. Chosen by us: well over 3.2 mm, the least gap of the guidelines.
const BETWEEN: f32 = 5.0;
/// Blank between rows, mm. Chosen by us: wider than any gap within a row, so that a finger finds the rows.
const BETWEEN_ROWS: f32 = 8.0;

/// A sheet: each block with its corner.
pub(super) type SheetOfSamples = Vec<(Block, MmVector)>;

/// A block of this size is larger than the sheet without its margins.
#[derive(Debug)]
pub(super) struct TooLarge(pub(super) MmVector);

impl SheetMarks {
    /// Adds the marks of `other`, translated by `by`.
    pub(super) fn add(&mut self, other: &Self, by: MmVector) {
        let moved = |points: &[MmPoint]| points.iter().map(|&at| at + by).collect::<Vec<_>>();
        self.lines.extend(other.lines.iter().map(|line| Line {
            strength: line.strength,
            runs: line.runs.iter().map(|run| Run { points: moved(&run.points), ..run.clone() }).collect(),
        }));
        self.textures.extend(other.textures.iter().map(|texture| {
            let glyphs = texture.glyphs.iter().map(|glyph| Glyph { at: glyph.at + by, ..*glyph });
            Texture { glyphs: glyphs.collect(), ..texture.clone() }
        }));
        self.frame.extend(moved(&other.frame));
        for label in &other.labels {
            let same = |own: &&mut Dots| own.diameter.total_cmp(&label.diameter).is_eq();
            match self.labels.iter_mut().find(same) {
                Some(own) => own.at.extend(moved(&label.at)),
                None => self.labels.push(Dots { diameter: label.diameter, at: moved(&label.at) }),
            }
        }
    }
}

/// Places blocks in their order, from left to right and from top to bottom, on as many sheets as needed; `area` is the
/// size of a sheet without its margins, mm.
///
/// # Errors
/// If a block is larger than the area.
pub(super) fn place(blocks: Vec<Block>, area: MmVector) -> Result<Vec<SheetOfSamples>, TooLarge> {
    let mut rows: Vec<(f32, f32, SheetOfSamples)> = Vec::new(); // width, height, blocks
    for block in blocks {
        if block.size.x > area.x || block.size.y > area.y {
            return Err(TooLarge(block.size));
        }
        match rows.last_mut() {
            Some((width, height, row)) if !block.starts_row && *width + BETWEEN + block.size.x <= area.x => {
                let corner = MmVector::new(*width + BETWEEN, 0.0);
                *width = corner.x + block.size.x;
                *height = height.max(block.size.y);
                row.push((block, corner));
            }
            _ => rows.push((block.size.x, block.size.y, vec![(block, MmVector::zero())])),
        }
    }
    let mut sheets: Vec<SheetOfSamples> = Vec::new();
    let mut bottom = f32::INFINITY;
    let heights: Vec<f32> = rows.iter().map(|(_, height, _)| *height).collect();
    for (number, (_, height, row)) in rows.into_iter().enumerate() {
        let mut top = bottom + BETWEEN_ROWS;
        let keeps = row.iter().any(|(block, _)| block.keeps);
        let with_next = heights.get(number + 1).filter(|_| keeps).map_or(0.0, |next| BETWEEN_ROWS + next);
        if top + height + with_next > area.y {
            sheets.push(Vec::new());
            top = 0.0;
        }
        bottom = top + height;
        if let Some(sheet) = sheets.last_mut() {
            sheet.extend(row.into_iter().map(|(block, corner)| (block, corner + MmVector::new(0.0, top))));
        }
    }
    Ok(sheets)
}

#[cfg(test)]
mod tests;
