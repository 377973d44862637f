//! Leader lines begin a blank cell away from their labels, where all dots are as far apart as those of letters: those
//! in the cell beside a label would be read as a letter of it.
//!
//! ```text
//!      |cell |                              |cell |
//!  o   o  o  |  o o  a label,        o   o  |     |  o o
//!            |  o    read as                |     |  o
//!            |       a letter more          |     |
//! ```

use crate::geom::spaced_row::{HOLE, has_every_second};
use crate::lines::{Line, Pen};
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect};

/// A row of fewer dots would be felt as no line.
const FEWEST: usize = 3;
/// A line on a page begins so near to where the leader line does for which it stands, mm, and a step of dots.
const DRAWN: f32 = 3.0;

/// The row of a leader line without its dots in the cell beside its label; the same row where too few would be left.
pub(super) fn off_next_cell(row: &[MmPoint], label: MmRect, cells: &CellGrid<'_>) -> Vec<MmPoint> {
    let [begin, end] = cells.ends_beside(row, label);
    let off = &row[begin..row.len() - end];
    if off.len() < FEWEST { row.to_vec() } else { off.to_vec() }
}

/// Takes those dots out of the leader lines among the lines of a figure; of each label there is where its leader line
/// begins, and its place. Dots lie `pitch` mm apart. What is left is a line by its length, at least `least` mm, and a
/// leader line by its steps.
pub(super) fn begin_off_labels(
    lines: &mut [Line],
    labels: &[(MmPoint, MmRect)],
    cells: &CellGrid<'_>,
    (pitch, least): (f32, f32),
) {
    let is_leader = |row: &[MmPoint]| has_every_second(row, HOLE * pitch);
    let ends = |row: &[MmPoint]| row.first().copied().zip(row.last().copied());
    for line in lines {
        let [run] = &mut line.runs[..] else { continue };
        let Some((first, last)) = ends(&run.points).filter(|_| run.pen != Pen::Stroke && is_leader(&run.points)) else {
            continue;
        };
        let is_near = |from: MmPoint| [first, last].iter().any(|end| (*end - from).length() <= DRAWN + pitch);
        for (_, label) in labels.iter().filter(|(from, _)| is_near(*from)) {
            let off = off_next_cell(&run.points, *label, cells);
            if is_leader(&off) && ends(&off).is_some_and(|(first, last)| (last - first).length() >= least) {
                run.points = off;
            }
        }
    }
}

#[cfg(test)]
mod tests;
