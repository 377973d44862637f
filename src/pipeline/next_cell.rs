//! Leader lines begin a blank cell away from their labels, where all dots are as far apart as those of letters: those
//! in the cell beside a label would be read as a letter of it.
//!
//! ```text
//!      |cell |                              |cell |
//!  o   o  o  |  o o  a label,        o   o  |     |  o o
//!            |  o    read as                |     |  o
//!            |       a letter more          |     |
//! ```

use crate::geom::ALONG;
use crate::geom::spaced_row::{HOLE, has_every_second, longest_step, stays_whole};
use crate::lines::{Line, Pen};
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect};

/// A row of fewer dots would be felt as no line.
const FEWEST: usize = 3;
/// But where it goes on beyond a line that it crosses, so many before that.
const FEWEST_BEFORE_LINE: usize = 2;
/// A line on a page begins so near to where the leader line does for which it stands, mm, and a step of dots.
const DRAWN: f32 = 3.0;

/// The row of a leader line without its dots in the cell beside its label; the same row where too few would be left.
pub(super) fn off_next_cell(row: &[MmPoint], label: MmRect, cells: &CellGrid<'_>) -> Vec<MmPoint> {
    with_fewest(row, label, cells, FEWEST)
}

/// The same where so many dots are to be left at least.
fn with_fewest(row: &[MmPoint], label: MmRect, cells: &CellGrid<'_>, fewest: usize) -> Vec<MmPoint> {
    let [begin, end] = cells.ends_beside(row, label);
    let off = &row[begin..row.len() - end];
    if off.len() < fewest { row.to_vec() } else { off.to_vec() }
}

/// Takes those dots out of the leader lines among the lines of a figure; of each label there is where its leader line
/// begins, and its place. Dots lie `pitch` mm apart. What is left is a line by its length, at least `least` mm, and a
/// leader line by its steps, or is led on by one beyond a line that it crosses.
pub(super) fn begin_off_labels(
    lines: &mut [Line],
    labels: &[(MmPoint, MmRect)],
    cells: &CellGrid<'_>,
    (pitch, least): (f32, f32),
) {
    let is_leader = |row: &[MmPoint]| has_every_second(row, HOLE * pitch);
    let ends = |row: &[MmPoint]| row.first().copied().zip(row.last().copied());
    let spaced = lines.iter().filter_map(Line::row).filter(|row| is_leader(&row.points));
    let spaced: Vec<(MmPoint, MmPoint)> = spaced.filter_map(|row| ends(&row.points)).collect();
    for line in lines {
        let [run] = &mut line.runs[..] else { continue };
        let Some((first, last)) = ends(&run.points).filter(|_| run.pen != Pen::Stroke) else { continue };
        let is_spaced = is_leader(&run.points);
        if !is_spaced && !stays_whole(&run.points) {
            continue;
        }
        let far = |from: MmPoint, end: MmPoint| (end - from).length();
        let is_near = |from: MmPoint| [first, last].iter().any(|end| far(from, *end) <= DRAWN + pitch);
        for &(from, label) in labels.iter().filter(|(from, _)| is_near(*from)) {
            let way = if far(from, first) <= far(from, last) { (first, last) } else { (last, first) };
            let is_led_on = goes_on(way, &spaced, longest_step(HOLE * pitch));
            let fewest = if is_led_on { FEWEST_BEFORE_LINE } else { FEWEST };
            let off = with_fewest(&run.points, label, cells, fewest);
            // a dot stands for half a pitch to both sides
            let is_long = ends(&off).is_some_and(|(first, last)| far(first, last) + pitch >= least);
            if is_led_on || is_spaced && is_long && is_leader(&off) {
                run.points = off;
            }
        }
    }
}

/// Whether one of these rows leads on from the end of another, straight on and no further away than `reach` mm, as
/// beyond a line that a leader line crosses.
fn goes_on((begin, end): (MmPoint, MmPoint), rows: &[(MmPoint, MmPoint)], reach: f32) -> bool {
    let way = |from: MmPoint, to: MmPoint| (to - from).try_normalize().unwrap_or_default();
    let leads_on = |from: MmPoint, to: MmPoint| {
        let is_straight = |next| way(begin, end).dot(next) >= ALONG;
        (from - end).length() <= reach && is_straight(way(end, from)) && is_straight(way(from, to))
    };
    rows.iter().any(|&(a, b)| leads_on(a, b) || leads_on(b, a))
}

#[cfg(test)]
mod tests;
