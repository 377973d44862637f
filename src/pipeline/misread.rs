//! Which numbers in a picture's pixels were read wrongly: those that break the scale of their row or column.

use crate::labels::{is_number, off_scale};
use crate::units::PxPoint;

/// Where a text stands that was read.
#[derive(Debug, Clone, Copy)]
pub(super) struct ReadAt {
    pub(super) middle: PxPoint,
    /// Height of its letters, px.
    pub(super) height: f32,
}

/// Numbers of one row have their middles at one height up to so much, as a share of their own, and those of a column
/// one below the other: in line at their right ends, of one digit more or less.
const ALIGNED: f32 = 0.5;

/// Which of these words are numbers that break the even steps of all others in their row or column, such as 0 between
/// 0.4 and 0.6, in their order.
pub(super) fn off_their_scales(words: &[String], places: &[ReadAt]) -> Vec<usize> {
    let numbers = words.iter().zip(places).enumerate().filter(|(_, (word, _))| is_number(word));
    let numbers: Vec<(usize, &str, ReadAt)> = numbers.map(|(at, (word, place))| (at, word.as_str(), *place)).collect();
    let in_rows = off_in_line(numbers.clone(), |at| at.y, |at| at.x);
    let mut odd = [in_rows, off_in_line(numbers, |at| at.x, |at| at.y)].concat();
    odd.sort_unstable();
    odd.dedup();
    odd
}

/// The same of numbers that stand in line: those that are alike in the first coordinate, along the second.
fn off_in_line(
    mut numbers: Vec<(usize, &str, ReadAt)>,
    across: impl Fn(PxPoint) -> f32,
    along: impl Fn(PxPoint) -> f32,
) -> Vec<usize> {
    numbers.sort_by(|(_, _, a), (_, _, b)| across(a.middle).total_cmp(&across(b.middle)));
    let are_in_line = |a: &ReadAt, b: &ReadAt| across(b.middle) - across(a.middle) <= ALIGNED * a.height.min(b.height);
    let lines = numbers.chunk_by(|(_, _, a), (_, _, b)| are_in_line(a, b));
    let odd = lines.filter_map(|line| {
        let mut line = line.to_vec();
        line.sort_by(|(_, _, a), (_, _, b)| along(a.middle).total_cmp(&along(b.middle)));
        let texts: Vec<&str> = line.iter().map(|(_, word, _)| *word).collect();
        let positions: Vec<f32> = line.iter().map(|(_, _, place)| along(place.middle)).collect();
        off_scale(&texts, &positions).map(|odd| line[odd].0)
    });
    odd.collect()
}

#[cfg(test)]
mod tests;
