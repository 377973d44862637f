//! Braille: whether its dots lie where a standard cell has them.

use super::finding::{Found, around};
use super::limits::{BRAILLE_OFF, Limits};
use super::rules::BRAILLE_CELL;
use crate::page::cells::CellGrid;
use crate::page::{BrailleText, Page};
use crate::units::{MmPoint, MmRect, MmVector};

/// The first sign of Unicode braille; the others follow it by their dots.
const BLANK: u32 = 0x2800;

pub(super) fn findings(page: &Page, limits: &Limits) -> Vec<Found> {
    let grid = CellGrid::of(&page.medium, limits.cell);
    let size = grid.size();
    let of = |(number, text): (usize, &BrailleText)| {
        let name = super::marks::Part::Braille(number as u32).name(page);
        let lines: Vec<Vec<u8>> = text.lines.iter().map(|line| cells(line)).collect();
        let wanted: Vec<MmPoint> = (0..)
            .zip(&lines)
            .flat_map(|(number, cells): (u32, _)| {
                let down = MmVector::new(0.0, number as f32 * size.line);
                size.dots(cells, 0.0).into_iter().map(move |at| at + down)
            })
            .collect();
        let extent = around(text.dots.at.iter().copied())?;
        if wanted.is_empty() {
            return None;
        }
        if wanted.len() != text.dots.at.len() {
            let (have, need) = (text.dots.at.len(), wanted.len());
            let what = format!("{name} has {have} dots, and its cells have {need}");
            return Some(Found::at(BRAILLE_CELL, extent.center(), extent, 0.0, what));
        }
        let (at, off) = farthest_off(&text.dots.at, &wanted);
        let what = || {
            let measures = format!(
                "{} mm from dot to dot, {} from cell to cell, {} from line to line",
                size.dot, size.cell, size.line
            );
            format!("{name}: a dot lies {off:.1} mm off its place in a standard cell ({measures})")
        };
        (off > BRAILLE_OFF).then(|| Found::at(BRAILLE_CELL, at, extent, off, what()))
    };
    page.braille.iter().enumerate().filter_map(of).collect()
}

/// The cells of a line of Unicode braille.
fn cells(line: &str) -> Vec<u8> {
    line.chars().map(|c| u8::try_from((c as u32).saturating_sub(BLANK)).unwrap_or(0)).collect()
}

/// Which dot lies farthest from where it should, and how far, if the two sets are laid on one another as well as moving
/// alone can do.
fn farthest_off(dots: &[MmPoint], wanted: &[MmPoint]) -> (MmPoint, f32) {
    let middle = |points: &[MmPoint]| around(points.iter().copied()).unwrap_or_else(MmRect::zero).center();
    let moved = middle(dots) - middle(wanted);
    let off = |at: &MmPoint| {
        let nearest = wanted.iter().map(|want| (*want + moved - *at).length()).fold(f32::MAX, f32::min);
        (*at, nearest)
    };
    dots.iter().map(off).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((MmPoint::zero(), 0.0))
}
