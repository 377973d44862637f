//! Lines among textures: where all dots are of one height, a row of a texture feels as a line does, and a finger cannot
//! follow a line that has such rows close beside it.
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
use crate::units::{Mm, MmPoint, MmRect};

/// The breach of a page where rows of textures lie close beside most of the lines.
pub(super) fn findings(page: &Page, limits: &RuleLimits) -> Option<FoundBreach> {
    let percent = 100.0 * too_many(page, limits)?;
    let what = format!(
        "beside {percent:.0} % of the length of the lines rows of textures are nearer than {ROWS_BESIDE} mm and feel \
         as lines do, so that these can hardly be followed; {:.0} % is the most",
        100.0 * MOST_BESIDE_ROWS
    );
    Some(FoundBreach::of_page(LINES_AMONG_ROWS, Some(percent), what))
}

/// What share of the length of a figure's lines, 0..=1, has rows of textures nearer than [`ROWS_BESIDE`], if that is
/// too much for lines to be followed. On paper textures are of other marks than lines, and on devices with heights they
/// are lower.
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
        let is_drowned = |at: &&MmPoint| !has_other(&second, **at, next) && has_other(&of_rows, **at, near);
        beside += row.points.iter().filter(is_drowned).count();
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

#[cfg(test)]
mod tests;
