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
        let lines: Vec<Vec<u8>> = text.lines.iter().map(|line| cells(line)).collect();
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

/// The cells of a line of Unicode braille.
fn cells(line: &str) -> Vec<u8> {
    line.chars().map(|c| u8::try_from((c as u32).saturating_sub(BLANK)).unwrap_or(0)).collect()
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
    let mut of_lines: Vec<Vec<MmPoint>> = vec![Vec::new(); wanted.len()];
    dots.iter().for_each(|at| of_lines[line_of(at)].push(*at));
    let off = |(have, want): (&Vec<MmPoint>, &Vec<MmPoint>)| {
        let right = low(&mut have.iter().map(|at| at.x)) - low(&mut want.iter().map(|at| at.x));
        let moved = MmVector::new(right, down);
        let to_nearest =
            |at: &MmPoint| (*at, want.iter().map(|want| (*want + moved - *at).length()).fold(f32::MAX, f32::min));
        have.iter().map(to_nearest).collect::<Vec<_>>()
    };
    let all = of_lines.iter().zip(wanted).flat_map(off);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((MmPoint::zero(), 0.0))
}
