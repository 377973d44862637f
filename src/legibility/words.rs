//! Braille: whether its dots lie where a standard cell has them.

use super::finding::{FoundBreach, around};
use super::limits::{BRAILLE_OFF, RuleLimits};
use super::rules::BRAILLE_CELL;
use crate::page::cells::CellGrid;
use crate::page::{BrailleText, Names, Page};
use crate::units::{MmPoint, MmVector};

/// The first sign of Unicode braille; the others follow it by their dots.
const BLANK: u32 = 0x2800;

pub(super) fn findings(page: &Page, names: &Names, limits: &RuleLimits) -> Vec<FoundBreach> {
    let grid = CellGrid::of(&page.medium, limits.cell);
    let size = grid.size();
    // on a page for the back of the sheet cells run from right to left
    let mirror_sum = page.is_mirrored().then(|| page.mirror_sum());
    let as_felt = |at: MmPoint| mirror_sum.map_or(at, |sum| MmPoint::new(sum - at.x, at.y));
    let of = |(number, text): (usize, &BrailleText)| {
        let name = super::marks::PageObject::Braille(number as u32).name(page, names);
        if let Some(letter) = text.lines.iter().flat_map(|line| line.chars()).find(|c| cell(*c).is_none()) {
            let at = around(text.dots.at.iter().copied())?;
            let what = format!("{name} is said to be in braille, and \"{letter}\" in it is no sign of that");
            return Some(FoundBreach::at(BRAILLE_CELL, at.center(), at, 0.0, what).unmeasured().of(&name));
        }
        let lines: Vec<Vec<u8>> = text.lines.iter().map(|line| line.chars().filter_map(cell).collect()).collect();
        let wanted: Vec<Vec<MmPoint>> = (0..)
            .zip(&lines)
            .map(|(number, cells): (u32, _)| {
                let down = MmVector::new(0.0, number as f32 * size.line);
                size.dots(cells, 0.0).into_iter().map(|at| at + down).collect()
            })
            .collect();
        let count = wanted.iter().map(Vec::len).sum::<usize>();
        let extent = around(text.dots.at.iter().copied())?;
        if count == 0 {
            return None;
        }
        if count != text.dots.at.len() {
            let (have, need) = (text.dots.at.len(), count);
            let dots = if have == 1 { "1 dot".to_owned() } else { format!("{have} dots") };
            let what = format!("{name} has {dots}, and its cells have {need}");
            return Some(FoundBreach::at(BRAILLE_CELL, extent.center(), extent, 0.0, what).unmeasured().of(&name));
        }
        let dots: Vec<MmPoint> = text.dots.at.iter().copied().map(as_felt).collect();
        let (at, off) = farthest_off(&dots, &wanted);
        let at = as_felt(at);
        let what = || {
            let measures = format!(
                "{} mm from dot to dot, {} from cell to cell, {} from line to line",
                size.dot, size.cell, size.line
            );
            format!("{name}: a dot lies {off:.1} mm off its place in a standard cell ({measures})")
        };
        (off > BRAILLE_OFF).then(|| FoundBreach::at(BRAILLE_CELL, at, extent, off, what()).of(&name))
    };
    page.braille.iter().enumerate().filter_map(of).collect()
}

/// The cell of a sign of Unicode braille; none of other letters.
fn cell(sign: char) -> Option<u8> {
    u32::from(sign).checked_sub(BLANK).and_then(|cell| u8::try_from(cell).ok())
}

/// Which dot lies farthest from where it should, and how far. Each line may begin anywhere, as titles stand in the
/// middle, but all of them lie as far apart as lines do.
fn farthest_off(dots: &[MmPoint], wanted: &[Vec<MmPoint>]) -> (MmPoint, f32) {
    let low = |points: &mut dyn Iterator<Item = f32>| points.fold(f32::MAX, f32::min);
    let down = low(&mut dots.iter().map(|at| at.y)) - low(&mut wanted.iter().flatten().map(|at| at.y));
    let line_of = |at: &MmPoint| {
        let off = |line: &&Vec<MmPoint>| line.iter().map(|want| (want.y + down - at.y).abs()).fold(f32::MAX, f32::min);
        wanted.iter().enumerate().min_by(|a, b| off(&a.1).total_cmp(&off(&b.1))).map_or(0, |(number, _)| number)
    };
    let across = low(&mut dots.iter().map(|at| at.x)) - low(&mut wanted.iter().flatten().map(|at| at.x));
    let mut of_lines: Vec<Vec<MmPoint>> = vec![Vec::new(); wanted.len()];
    dots.iter().for_each(|at| of_lines[line_of(at)].push(*at));
    let nearest = |at: MmPoint, to: &[MmPoint]| to.iter().map(|to| (*to - at).length()).fold(f32::MAX, f32::min);
    let off = |(have, want): (&Vec<MmPoint>, &Vec<MmPoint>)| {
        let right = low(&mut have.iter().map(|at| at.x)) - low(&mut want.iter().map(|at| at.x));
        let moved = MmVector::new(if have.is_empty() { across } else { right }, down);
        let places: Vec<MmPoint> = want.iter().map(|want| *want + moved).collect();
        let of_dots = have.iter().map(|at| (*at, nearest(*at, &places)));
        // two dots may lie on one another, and another place be empty
        let of_places = places.iter().map(|place| (*place, nearest(*place, dots)));
        of_dots.chain(of_places).collect::<Vec<_>>()
    };
    let all = of_lines.iter().zip(wanted).flat_map(off);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((MmPoint::zero(), 0.0))
}

#[cfg(test)]
mod tests;
