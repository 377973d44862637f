//! Lines among textures: where all dots are of one height, a row of a texture feels as a line does, and a finger cannot
//! follow a line that has such rows close beside it on both sides. On the blank side of the outline of an area it can.
//!
//! ```text
//! o o o o o o o   a row of a texture
//!
//!   o o o o o o   a line: which of the three is it?
//!
//! o o o o o o o
//! ```

use super::finding::{FoundBreach, around};
use super::limits::{MOST_BESIDE_ROWS, MediumLimits, ROUNDING, ROWS_BESIDE, RuleLimits};
use super::rules::LINES_AMONG_ROWS;
use crate::geom::nearby::Index;
use crate::page::{Line, Medium, Page};
use crate::units::{Mm, MmPoint, MmRect, MmVector};

/// The breach of a page where rows of textures lie close on both sides of too many of the lines.
pub(super) fn findings(page: &Page, limits: &RuleLimits) -> Option<FoundBreach> {
    let percent = 100.0 * too_many(page, limits)?;
    let what = format!(
        "on both sides of {percent:.0} % of the length of the lines rows of textures are nearer than {ROWS_BESIDE} mm \
         and feel as lines do, so that these can hardly be followed; {:.0} % is the most",
        100.0 * MOST_BESIDE_ROWS
    );
    Some(FoundBreach::of_page(LINES_AMONG_ROWS, Some(percent), what))
}

/// What share of the length of a figure's lines, 0..=1, has rows of textures nearer than [`ROWS_BESIDE`] on both sides,
/// if that is too much for lines to be followed. On paper textures are of other marks than lines, and on devices with
/// heights they are lower.
pub(crate) fn too_many(page: &Page, limits: &RuleLimits) -> Option<f32> {
    let (Medium::Dots(medium), MediumLimits::Dots { .. }) = (&page.medium, limits.medium) else { return None };
    if medium.device.has_heights() {
        return None;
    }
    let next = limits.next_dot();
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let of_textures = indexed(glyphs.map(|glyph| glyph.at));
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let of_rows = indexed(glyphs.map(|glyph| glyph.at).filter(|at| has_other(&of_textures, *at, next)));
    // from middle to middle
    let near = ROWS_BESIDE + medium.diameter() - ROUNDING;
    let [mut all, mut beside] = [0_usize; 2];
    for line in &page.figure.lines {
        let Some(row) = line.row() else { continue };
        let second = indexed(beside_row(line));
        all += row.points.len();
        // a line of two rows is felt among single ones
        let last = row.points.len().saturating_sub(1);
        let is_drowned = |(k, at): &(usize, &MmPoint)| {
            let along = row.points[(k + 1).min(last)] - row.points[k.saturating_sub(1)];
            !has_other(&second, **at, next) && has_on_both_sides(&of_rows, **at, along, near)
        };
        beside += row.points.iter().enumerate().filter(is_drowned).count();
    }
    let share = beside as f32 / all.max(1) as f32;
    (share > MOST_BESIDE_ROWS).then_some(share)
}

/// The dots of a line that are not of its first row.
fn beside_row(line: &Line) -> impl Iterator<Item = MmPoint> + '_ {
    line.runs.iter().skip(1).flat_map(|run| run.points.iter().copied())
}

/// Dots, to be found by place.
fn indexed(dots: impl Iterator<Item = MmPoint>) -> Index<MmPoint, Mm> {
    let dots: Vec<MmPoint> = dots.collect();
    let area = around(dots.iter().copied()).unwrap_or_else(MmRect::zero);
    let mut index = Index::new(area, ROWS_BESIDE);
    dots.iter().for_each(|dot| index.put_at(*dot, *dot));
    index
}

/// Whether there is a dot nearer than `reach` to this place, but not at it.
fn has_other(dots: &Index<MmPoint, Mm>, at: MmPoint, reach: f32) -> bool {
    let mut has = false;
    dots.around(at, at, reach, |other| {
        let apart = (*other - at).length();
        has |= apart > ROUNDING && apart < reach;
    });
    has
}

/// Whether there are dots nearer than `reach` to a place of a line on both sides of that, which goes `along` there.
fn has_on_both_sides(dots: &Index<MmPoint, Mm>, at: MmPoint, along: MmVector, reach: f32) -> bool {
    let along = along.try_normalize().unwrap_or_default();
    let mut has = [false; 2];
    dots.around(at, at, reach, |other| {
        let away = *other - at;
        let aside = along.cross(away);
        if away.length() < reach && aside.abs() >= ASIDE * away.length() {
            has[usize::from(aside > 0.0)] = true;
        }
    });
    has == [true; 2]
}

/// A dot is beside a line, and not before its end, if the direction to it is off that of the line by at least 30
/// degrees: the sine.
const ASIDE: f32 = 0.5;

#[cfg(test)]
mod tests;
