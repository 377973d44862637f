//! Leader lines of labels where all dots are as far apart as those of letters: in the cell right beside a label they
//! are read as a letter of it.

use super::finding::{FoundBreach, around};
use super::limits::RuleLimits;
use super::rules::LABEL_LINE;
use crate::page::cells::CellGrid;
use crate::page::{BrailleText, Page, text_name};

/// A leader line with fewer dots beyond that cell is not to be made shorter. More than convert leaves as it is, since
/// the cells of a label may reach beyond its dots.
const FEWEST: usize = 5;

/// Of each label whose leader line begins in the cell beside it, where that is.
pub(super) fn findings(page: &Page, limits: &RuleLimits) -> Vec<FoundBreach> {
    let cells = CellGrid::of(&page.medium, limits.cell);
    let radius = 0.5 * cells.diameter;
    let of = |text: &BrailleText| {
        let row = &text.leader.as_ref()?.points;
        let place = around(text.dots.at.iter().copied())?.inflate(radius, radius);
        let [begin, end] = cells.ends_beside(row, place);
        let left = row.len() - begin - end;
        let beside = row[..begin].iter().chain(&row[begin + left..]);
        let extent = around(beside.copied()).filter(|_| left >= FEWEST)?;
        let name = text_name(text);
        let what = format!(
            "the line that leads from {name} begins in the cell beside it, where its dots are read as a letter; a \
             blank cell belongs there"
        );
        Some(FoundBreach::at(LABEL_LINE, extent.center(), extent, 0.0, what).unmeasured().of(&name))
    };
    page.braille.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests;
