//! Leader lines of labels where all dots are as far apart as those of letters: in the cell right beside a label they
//! are read as a letter of it.

use super::finding::{FoundBreach, around};
use super::limits::RuleLimits;
use super::rules::LABEL_LINE;
use crate::geom::spaced_row::{HOLE, has_every_second};
use crate::page::cells::CellGrid;
use crate::page::{BrailleText, Line, Page, Run, TextRole, text_name};
use crate::units::MmRect;

/// A leader line with fewer dots beyond that cell is not to be made shorter. More than convert leaves as it is, since
/// the cells of a label may reach beyond its dots.
const FEWEST: usize = 5;

/// Of each label whose leader line begins in the cell beside it, or beside which one of the drawing ends so, where that
/// is.
pub(super) fn findings(page: &Page, limits: &RuleLimits) -> Vec<FoundBreach> {
    let cells = CellGrid::of(&page.medium, limits.cell);
    let radius = 0.5 * cells.diameter;
    let step = HOLE * page.medium.pitch();
    let rows = page.figure.lines.iter().filter_map(Line::row);
    let drawn: Vec<&Run> = rows.filter(|row| has_every_second(&row.points, step)).collect();
    let of = |text: &BrailleText| {
        let place = around(text.dots.at.iter().copied())?.inflate(radius, radius);
        let name = text_name(text);
        let own = text.leader.as_ref().and_then(|row| beside(row, place, &cells));
        let own = own.map(|extent| (extent, format!("the line that leads from {name} begins in the cell beside it")));
        let of_drawing = || {
            let is_label = text.role == TextRole::Label;
            let extent = drawn.iter().filter(|_| is_label).find_map(|row| beside(row, place, &cells))?;
            Some((extent, format!("a leader line of the drawing ends in the cell beside {name}")))
        };
        let (extent, what) = own.or_else(of_drawing)?;
        let what = format!("{what}, where its dots are read as a letter; a blank cell belongs there");
        Some(FoundBreach::at(LABEL_LINE, extent.center(), extent, 0.0, what).unmeasured().of(&name))
    };
    page.braille.iter().filter_map(of).collect()
}

/// The dots of a leader line in the cells beside a label in this place, if there are enough beyond them.
fn beside(leader: &Run, label: MmRect, cells: &CellGrid<'_>) -> Option<MmRect> {
    let row = &leader.points;
    let [begin, end] = cells.ends_beside(row, label);
    let left = row.len() - begin - end;
    let beside = row[..begin].iter().chain(&row[begin + left..]);
    around(beside.copied()).filter(|_| left >= FEWEST)
}

#[cfg(test)]
mod tests;
