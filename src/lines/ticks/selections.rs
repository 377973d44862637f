//! Which ticks of a scale are drawn where there is no room for all: those that are longer, or every so many-th.

use crate::lines::marks::TickMark;

/// Of a scale at most this share may lack room beside other lines: otherwise none of it is drawn.
pub(crate) const MOST_BLOCKED: f32 = 0.25;

/// Ticks are even if no two are this much farther apart than the nearest two.
pub(super) const EVEN: f32 = 1.3;
/// Every so many-th of even ticks is drawn, where there is no room for more.
const EVERY: [usize; 3] = [2, 5, 10];
/// A tick is long if it is this much longer than the shortest of its scale.
const LONG: f32 = 1.3;
/// Fewer ticks are no scale.
const LEAST: usize = 3;

/// All ticks of a scale, then fewer, in the order in which they are tried: each with the step from one to the next.
/// Where a scale goes round, as that of a clock, every so many-th is every so many-th from the last to the first too,
/// and it has long ticks: of those that are all alike nobody could say from which one they are counted. Of uneven ticks
/// those are all or the long ones.
pub(crate) fn tick_selections(scale: &[TickMark]) -> Vec<(usize, Vec<usize>)> {
    let numbers: Vec<usize> = (0..scale.len()).collect();
    let mut all = vec![(1, numbers.clone())];
    let (least, most) = steps(scale, &numbers);
    let shortest = scale.iter().map(TickMark::length).fold(f32::INFINITY, f32::min);
    let long: Vec<usize> = (0..scale.len()).filter(|&i| scale[i].length() >= LONG * shortest).collect();
    let of_long = long
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .min()
        .filter(|&every| long.windows(2).all(|pair| pair[1] - pair[0] == every));
    if most > EVEN * least {
        // on a logarithmic scale those at its numbers are long, and even
        let (least, most) = steps(scale, &long);
        let of_long = of_long.filter(|every| *every > 1 && long.len() >= LEAST && most <= EVEN * least);
        all.extend(of_long.map(|every| (every, long)));
        return all;
    }
    let goes_round = scale.first().zip(scale.last()).is_some_and(|(a, b)| (b.at - a.at).length() <= EVEN * least);
    if goes_round && long.is_empty() {
        return all;
    }
    let first = long.first().copied().unwrap_or(0);
    for every in of_long.into_iter().filter(|every| *every > 1).chain(EVERY) {
        let is_even = !goes_round || scale.len().is_multiple_of(every);
        if is_even && !all.iter().any(|(other, _)| *other == every) {
            all.push((every, (first % every..scale.len()).step_by(every).collect()));
        }
    }
    all.retain(|(every, members): &(usize, Vec<usize>)| *every == 1 || members.len() >= LEAST);
    all
}

/// The least and the greatest distance from one of these ticks to the next, mm.
fn steps(scale: &[TickMark], numbers: &[usize]) -> (f32, f32) {
    let apart = numbers.windows(2).map(|pair| (scale[pair[1]].at - scale[pair[0]].at).length());
    apart.fold((f32::INFINITY, 0.0_f32), |(least, most), at| (least.min(at), most.max(at)))
}
