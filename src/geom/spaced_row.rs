//! Rows of dots of which every second one is left, as leader lines are drawn. A leader line is to be the weakest line
//! of a figure (BANA guidelines, 3.4.3.5, as quoted by others), and to differ from those that it leads to. In one row
//! of dots as high as all others only their distance is left to say so:
//!
//! ```text
//!   o o o o o o o o   an outline         o o   o   o   o   a leader line, from its label on the left
//! ```

use crate::units::MmPoint;

/// A row of fewer dots stays as it is: of five, which are 8 mm long on most embossers, three are left.
const LEAST: usize = 5;
/// A step so many times as long as dots are apart is a hole, as where another line crosses: a diagonal one is 1.42. On
/// both sides of it there are dots, so that no more than one is missing in one place.
pub const HOLE: f32 = 1.5;

/// Every second dot of a row from its last one on, where it touches what it names, and its first one, at its label.
/// Dots lie `pitch` mm apart. Every second one, chosen by us, is the least that differs from a line; a finger follows
/// it, as it does the band of a frame, whose dots are 4 mm apart. The dots on both sides of a hole are left too, so
/// that behind it two may be neighbours.
pub fn every_second(row: &[MmPoint], pitch: f32) -> Vec<MmPoint> {
    if stays_whole(row) {
        return row.to_vec();
    }
    let mut kept = Vec::with_capacity(row.len() / 2 + 1);
    let mut is_kept = false;
    for (number, at) in row.iter().enumerate().rev() {
        let is_hole = |other: &MmPoint| (*other - *at).length() > HOLE * pitch;
        let is_before = row.get(number + 1).is_some_and(is_hole);
        let is_behind = number.checked_sub(1).and_then(|before| row.get(before)).is_some_and(is_hole);
        is_kept = !is_kept || is_before || is_behind;
        kept.extend((is_kept || number == 0).then_some(*at));
    }
    kept.reverse();
    kept
}

/// Whether a row is so short that it stays as it is.
pub fn stays_whole(row: &[MmPoint]) -> bool {
    row.len() < LEAST
}

/// Every second dot of a row is no farther from the next than so many of the longest steps between neighbours.
const SPACED: f32 = 2.0;
/// What rounding may add to a step, mm: on the grid of an embosser a step can be just as long as that.
const ROUNDING: f32 = 0.05;

/// The longest step in a row that has every second dot only, mm, of those whose steps are up to `step` mm.
pub fn longest_step(step: f32) -> f32 {
    SPACED * step + ROUNDING
}

/// Whether a row of dots has every second one only, of those whose steps are up to `step` mm: two steps at least are
/// longer. The first and the second dot may be neighbours, and likewise behind a hole: one of any three steps.
pub fn has_every_second(row: &[MmPoint], step: f32) -> bool {
    let steps: Vec<f32> = row.windows(2).map(|pair| (pair[1] - pair[0]).length()).collect();
    let short = |steps: &[f32]| steps.iter().filter(|length| **length <= step).count();
    steps.len() >= 2 + short(&steps)
        && steps.windows(3).all(|three| short(three) <= 1)
        && steps.iter().all(|length| *length <= longest_step(step))
}

#[cfg(test)]
mod tests;
