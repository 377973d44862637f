//! Which numbers in a picture's pixels were read wrongly: those that break the scale of their row.

use crate::labels::{is_number, off_scale};
use crate::units::PxPoint;

/// Where a text stands that was read.
#[derive(Debug, Clone, Copy)]
pub(super) struct ReadAt {
    pub(super) middle: PxPoint,
    /// Height of its letters, px.
    pub(super) height: f32,
}

/// Numbers of one row have their middles at one height up to so much, as a share of their own.
const ALIGNED: f32 = 0.5;

/// Which of these words are numbers that break the even steps of all others in their row, such as 0 between 0.4 and
/// 0.6, in their order.
pub(super) fn off_their_rows(words: &[String], places: &[ReadAt]) -> Vec<usize> {
    let numbers = words.iter().zip(places).enumerate().filter(|(_, (word, _))| is_number(word));
    let mut numbers: Vec<(usize, &str, ReadAt)> =
        numbers.map(|(at, (word, place))| (at, word.as_str(), *place)).collect();
    numbers.sort_by(|(_, _, a), (_, _, b)| a.middle.y.total_cmp(&b.middle.y));
    let rows = numbers.chunk_by(|(_, _, a), (_, _, b)| b.middle.y - a.middle.y <= ALIGNED * a.height.min(b.height));
    let odd = rows.filter_map(|row| {
        let mut row = row.to_vec();
        row.sort_by(|(_, _, a), (_, _, b)| a.middle.x.total_cmp(&b.middle.x));
        let texts: Vec<&str> = row.iter().map(|(_, word, _)| *word).collect();
        let positions: Vec<f32> = row.iter().map(|(_, _, place)| place.middle.x).collect();
        off_scale(&texts, &positions).map(|odd| row[odd].0)
    });
    let mut odd: Vec<usize> = odd.collect();
    odd.sort_unstable();
    odd
}

#[cfg(test)]
mod tests;
