//! Where cells of braille can stand: anywhere on paper, on whole dots of a device.
//!
//! A grid of dots has no room between its dots, so cells take whole steps of it. What comes nearest to standard
//! braille:
//!
//! ```text
//! grid            dots in a cell   cells     lines
//! 1.27 (ViewPlus)    2  2.54 mm    5  6.35   8 10.16 mm
//! 1.6  (Index)       1  1.6        4  6.4    6  9.6     small
//! 2.0  (Index)       1  2.0        3  6.0    5 10.0     dots nearer than standard, cells and lines as standard
//! 2.5  (Index, pins) 1  2.5        3  7.5    4 10.0     cells further apart than standard
//! text cells         1  2.34       2 (6.2)   3 (10.0)   the embosser's own
//! anywhere           as the profile says
//! ```

use super::medium::{DotMedium, Medium};
use crate::braille::{CellSize, PRINTED};
use crate::devices::{DotArea, Grid};
use crate::units::{MmPoint, MmRect, MmVector};

/// Where cells can stand on a medium.
#[derive(Debug, Clone)]
pub struct CellGrid<'m> {
    /// Diameter of a dot, mm.
    pub diameter: f32,
    size: CellSize,
    on: Option<CellSteps<'m>>,
}

/// Cells on a grid of dots, in whole steps.
#[derive(Debug, Clone)]
struct CellSteps<'m> {
    grid: &'m Grid,
    dot: usize,
    cell: usize,
    line: usize,
    /// Cells begin in columns and rows that these divide.
    start: [usize; 2],
}

/// From the first column or row to the one so many steps further.
fn span(centres: &[f32], steps: usize) -> Option<f32> {
    Some(centres.get(steps)? - centres.first()?)
}

/// Dots of a cell that are farther apart than this many standard distances are those of jumbo braille. Chosen by us.
const JUMBO: f32 = 1.15;
/// Dots that are less far apart are read as no letters, mm: those of braille are 2.3 to 2.6 mm apart, and 1.9 mm at the
/// least that anybody embosses. Chosen by us.
pub const LEAST_OF_LETTERS: f32 = 1.9;
/// Places are rounded: a dot up to this share of a step beyond a cell is in it.
const OFF_COLUMN: f32 = 0.25;
/// Nearest dots of a cell that fingers still tell apart, mm: those of small braille.
const LEAST_DOT: f32 = 1.5;

impl<'m> CellGrid<'m> {
    /// Cells of this size on a medium, or as near to it as the medium's dots allow.
    pub fn of(medium: &'m Medium, size: CellSize) -> Self {
        match medium {
            Medium::Print(_) => Self::printed(size),
            Medium::Dots(dots) => Self::of_dots(dots, size),
        }
    }

    pub(super) fn printed(size: CellSize) -> Self {
        Self { diameter: PRINTED, size, on: None }
    }

    pub(super) fn of_dots(medium: &'m DotMedium, size: CellSize) -> Self {
        let diameter = medium.diameter();
        match &medium.area {
            DotArea::Free(_) => Self { diameter, size, on: None },
            DotArea::Grid(grid) => {
                let steps = CellSteps::of(grid, medium, size);
                let across = |steps: usize| span(&grid.columns, steps).unwrap_or(steps as f32 * medium.pitch);
                let down = |steps: usize| span(&grid.rows, steps).unwrap_or(steps as f32 * medium.pitch);
                let size =
                    CellSize { dot: across(steps.dot), cell: across(steps.cell), line: down(steps.line), ..size };
                Self { diameter, size, on: Some(steps) }
            }
        }
    }

    /// Cells of the same measures that can stand anywhere.
    pub fn anywhere(&self) -> CellGrid<'static> {
        CellGrid { diameter: self.diameter, size: self.size, on: None }
    }

    /// The measures that cells have here.
    pub fn size(&self) -> CellSize {
        self.size
    }

    /// The steps in which cells can stand on a grid, across and down, mm; none where they stand anywhere.
    pub fn steps(&self) -> Option<MmVector> {
        let steps = self.on.as_ref()?;
        let step = |centres: &[f32], start: usize| span(centres, start).unwrap_or(0.0);
        Some(MmVector::new(step(&steps.grid.columns, steps.start[0]), step(&steps.grid.rows, steps.start[1])))
    }

    /// Blank that keeps braille off the cells of other marks, mm: where all dots are those of cells, a whole cell
    /// wherever it comes to stand among them, or what stands beside a text is read as a part of it.
    pub(super) fn blank_before_cells(&self) -> f32 {
        let is_of_cells = self.on.as_ref().is_some_and(|steps| steps.start[0] == steps.cell);
        if is_of_cells { 1.5 * self.size.cell } else { 0.0 }
    }

    /// Whether all dots of a grid are as far apart as those of a cell, so that any beside one another are read as a
    /// letter.
    pub fn is_of_letters(&self) -> bool {
        self.on.as_ref().is_some_and(|steps| steps.dot == 1) && self.size.dot >= LEAST_OF_LETTERS
    }

    /// How many dots at both ends of a row lie in the cells right beside lines of braille in this place, where they are
    /// read as a letter; none where dots are not those of letters.
    pub fn ends_beside(&self, row: &[MmPoint], place: MmRect) -> [usize; 2] {
        if !self.is_of_letters() {
            return [0, 0];
        }
        let reach = self.size.cell - 0.5 * self.diameter + OFF_COLUMN * self.size.dot;
        let is_beside = |at: &&MmPoint| {
            let is_level = (place.min.y..=place.max.y).contains(&at.y);
            let aside = (place.min.x - at.x).max(at.x - place.max.x);
            is_level && (0.0..=reach).contains(&aside)
        };
        let begin = row.iter().take_while(is_beside).count();
        [begin, row[begin..].iter().rev().take_while(is_beside).count()]
    }

    /// Width and height of lines of so many cells, from the edges of the outermost dots.
    pub fn extent(&self, cells: usize, lines: usize) -> MmVector {
        let line = self.size.extent(cells, self.diameter);
        line + MmVector::new(0.0, lines.saturating_sub(1) as f32 * self.size.line)
    }

    /// How many cells a line of this width holds.
    pub fn cells_in(&self, width: f32) -> usize {
        self.size.cells_in(width, self.diameter)
    }

    /// The dots of lines of cells, their corner as near to this one as dots can be. Blank columns and rows beside the
    /// dots count, so that lines of one text stand below one another.
    pub fn dots(&self, lines: &[Vec<u8>], corner: MmPoint) -> Vec<MmPoint> {
        let of_line = |(number, cells): (usize, &Vec<u8>)| -> Vec<MmPoint> {
            match &self.on {
                None => {
                    let below = MmVector::new(0.0, number as f32 * self.size.line);
                    self.size.dots(cells, self.diameter).into_iter().map(|at| at + below + corner.to_vector()).collect()
                }
                Some(steps) => steps.dots(cells, number, steps.start_at(corner, self.diameter)),
            }
        };
        lines.iter().enumerate().flat_map(of_line).collect()
    }

    /// The same box moved to where its cells would stand.
    pub fn snapped(&self, place: MmRect) -> MmRect {
        let Some(steps) = &self.on else { return place };
        let [column, row] = steps.start_at(place.min, self.diameter);
        let half = 0.5 * self.diameter;
        match steps.grid.at(column, row) {
            Some(at) => {
                let min = at - MmVector::new(half, half);
                MmRect::new(min, min + place.size().to_vector())
            }
            None => place,
        }
    }
}

impl<'m> CellSteps<'m> {
    fn of(grid: &'m Grid, medium: &DotMedium, size: CellSize) -> Self {
        if let Some([cell, line]) = medium.device.cell_dots() {
            return Self { grid, dot: 1, cell, line, start: [cell, line] };
        }
        let nearest = |mm: f32| ((mm / medium.pitch).round() as usize).max(1);
        let mut dot = nearest(size.dot);
        // further apart than standard is jumbo braille, which few read; rather small
        if dot as f32 * medium.pitch > JUMBO * size.dot && (dot - 1) as f32 * medium.pitch >= LEAST_DOT {
            dot -= 1;
        }
        // a wider step between cells than within them, and a wider one between lines
        let cell = nearest(size.cell).max(2 * dot + 1);
        let line = nearest(size.line).max(3 * dot + 1);
        Self { grid, dot, cell, line, start: [1, 1] }
    }

    /// The column and row of dot 1 for a corner of the box around dots.
    fn start_at(&self, corner: MmPoint, diameter: f32) -> [usize; 2] {
        let nearest = |mm: f32, centres: &[f32], step: usize| {
            let wanted = mm + 0.5 * diameter;
            let starts = (0..centres.len()).step_by(step);
            let distance = |&index: &usize| (centres[index] - wanted).abs();
            starts.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };
        [nearest(corner.x, &self.grid.columns, self.start[0]), nearest(corner.y, &self.grid.rows, self.start[1])]
    }

    fn dots(&self, cells: &[u8], line: usize, [column, row]: [usize; 2]) -> Vec<MmPoint> {
        let of_cell = |(i, &cell): (usize, &u8)| {
            let raised = (0..6_usize).filter(move |dot| cell & (1 << dot) != 0);
            raised.filter_map(move |dot| {
                let x = column + i * self.cell + dot / 3 * self.dot;
                let y = row + line * self.line + dot % 3 * self.dot;
                self.grid.at(x, y)
            })
        };
        cells.iter().enumerate().flat_map(of_cell).collect()
    }
}

#[cfg(test)]
mod tests;
