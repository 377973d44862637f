//! Rows of dots of which every second one is left, as leader lines are drawn. A leader line is to be the weakest line of
//! a figure (BANA guidelines, 3.4.3.5, as quoted by others), and to differ from those that it leads to. In one row of
//! dots as high as all others only their distance is left to say so:
//!
//! ```text
//!   o o o o o o o o   an outline         o o   o   o   o   a leader line, from its label on the left
//! ```

use crate::units::MmPoint;

/// A row of fewer dots stays as it is: of five, which are 8 mm long on most embossers, three are left.
const LEAST: usize = 5;
/// A step so many times as long as dots are apart is a hole, as where another line crosses: a diagonal one is 1.42. On
/// both sides of it there are dots, so that no more than one is left out of the row in one place.
pub const HOLE: f32 = 1.5;

/// Every second dot of a row from its last one on, where it touches what it names, and its first one, at its label.
/// Dots lie `pitch` mm apart. Every second one, chosen by us, is the least that differs from a line; a finger follows
/// it, as it does the band of a frame, whose dots are 4 mm apart.
pub fn every_second(row: &[MmPoint], pitch: f32) -> Vec<MmPoint> {
    if row.len() < LEAST {
        return row.to_vec();
    }
    let mut kept = Vec::with_capacity(row.len() / 2 + 1);
    let mut is_kept = false;
    for (number, at) in row.iter().enumerate().rev() {
        let is_next = row.get(number + 1).is_some_and(|after| (*after - *at).length() <= HOLE * pitch);
        is_kept = !(is_kept && is_next);
        kept.extend((is_kept || number == 0).then_some(*at));
    }
    kept.reverse();
    kept
}

/// Every second dot of a row is no farther from the next than so many of the longest steps between neighbours.
const SPACED: f32 = 2.0;

/// Whether a row of dots has every second one only, of those whose steps are up to `step` mm: but for one step, as the
/// first and the second dot may be neighbours, all are longer.
pub fn has_every_second(row: &[MmPoint], step: f32) -> bool {
    let steps = || row.windows(2).map(|pair| (pair[1] - pair[0]).length());
    steps().filter(|length| *length <= step).count() <= 1 && steps().all(|length| length <= SPACED * step)
}

#[cfg(test)]
mod tests;
