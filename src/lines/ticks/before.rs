//! Strokes that end before a round line, farther from it than a tick that stands on it, as the marks of a clock face
//! well inside of its rim. One by one they may be anything, so they are ticks only together: each as far from the line
//! as the others, evenly along it, and turned from one to the next. Before a straight line they may be tally marks in a
//! table, or a fence.

use super::selections::{EVEN, MOST_BLOCKED};
use crate::geom::order::median;
use crate::units::{MmPoint, MmVector};

/// Ticks of one scale are as far before their line but for this, mm: in a bitmap an end of a stroke may lie two pixels
/// off.
const AS_FAR: f32 = 0.5;
/// Fewer of them are no scale: a clock face has four marks at least.
const LEAST: usize = 4;
/// Strokes nearer to one another than this, mm, are one that is there twice.
const ONE: f32 = 0.5;
/// From one to the next they turn by this at least: the sine (1.7 degrees). Marks of minutes turn by 6.
const TURNED: f32 = 0.03;

/// A stroke before a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct StrokeBefore {
    /// The line.
    pub(super) base: usize,
    /// How far the stroke ends before it, mm.
    pub(super) gap: f32,
    /// The place on it that is nearest to that end.
    pub(super) foot: MmPoint,
    /// How far that is along it, mm.
    pub(super) arc: f32,
    /// Which way the stroke leads from there: of length 1.
    pub(super) way: MmVector,
}

/// Which of these strokes are ticks.
pub(super) fn are_ticks(strokes: &[StrokeBefore]) -> Vec<bool> {
    let mut order: Vec<usize> = (0..strokes.len()).collect();
    let place = |number: usize| (strokes[number].base, strokes[number].arc);
    order.sort_by(|&a, &b| place(a).0.cmp(&place(b).0).then(place(a).1.total_cmp(&place(b).1)));
    let mut are_ticks = vec![false; strokes.len()];
    for of_line in order.chunk_by(|&a, &b| strokes[a].base == strokes[b].base) {
        let gap = median(of_line.iter().map(|&number| strokes[number].gap));
        let is_as_far = |number: &usize| (strokes[*number].gap - gap).abs() <= AS_FAR;
        let as_far: Vec<usize> = of_line.iter().copied().filter(is_as_far).collect();
        let are_most = as_far.len() as f32 >= (1.0 - MOST_BLOCKED) * of_line.len() as f32;
        let own: Vec<StrokeBefore> = as_far.iter().map(|&number| strokes[number]).collect();
        if own.len() >= LEAST && are_most && are_even(&own) {
            as_far.into_iter().for_each(|number| are_ticks[number] = true);
        }
    }
    are_ticks
}

/// Whether strokes, in order along their line, are as far from one another and turn the same way, but for a few, as
/// where an arc is open, or where something covers a tick.
fn are_even(strokes: &[StrokeBefore]) -> bool {
    let steps: Vec<(f32, f32)> = strokes
        .windows(2)
        .map(|pair| ((pair[1].foot - pair[0].foot).length(), pair[0].way.cross(pair[1].way)))
        .collect();
    let step = median(steps.iter().map(|(step, _)| *step));
    let way = steps.iter().map(|(_, turn)| turn.signum()).sum::<f32>().signum();
    let is_even = |&(other, turn): &(f32, f32)| {
        let is_as_far = other <= EVEN * step && step <= EVEN * other;
        is_as_far && turn * way >= TURNED
    };
    let uneven = steps.iter().filter(|of| !is_even(of)).count();
    step >= ONE && uneven as f32 <= MOST_BLOCKED * steps.len() as f32
}

#[cfg(test)]
mod tests;
