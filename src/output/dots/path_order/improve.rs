//! Shortens a path by local search: 2-opt and Or-opt until neither is a gain, then double bridges, each undone unless
//! it leads to a gain.
//!
//! 2-opt (Croes 1958) reverses a part of the path; Or-opt (Or 1976) moves one to three positions elsewhere. Both look
//! only at neighbours and only where something has changed, which don't-look bits tell (Bentley 1992, Fast algorithms
//! for geometric traveling salesman problems). A double bridge exchanges two adjacent parts (Martin, Otto and Felten
//! 1991); the parts are short, so that repairing it stays local (Johnson and McGeoch 1997), and 2-opt and Or-opt run
//! again around it. Where double bridges are tried is a fixed sequence, so that the same dots give the same path.
//!
//! The path is an array. Each change is a series of reversals, which is undone by repeating it, last first; it costs
//! as many steps as there are positions between its two ends.

use std::collections::VecDeque;

use super::neighbours::{DotPosition, distance};

/// The longest part that Or-opt moves.
const LONGEST_PART: usize = 3;
/// What counts as a gain, in hundredths of a millimetre: well above the rounding of sums, well below what can be
/// measured.
const LEAST_GAIN: f64 = 1e-6;
/// Changes for each position before the first double bridge. Every change is a gain, so the search ends without this
/// limit; about one for each position is usual.
const MOST_CHANGES: usize = 30;
/// Double bridges for each position; twice as many would shorten paths by another 0.3 %.
const BRIDGES: usize = 10;
/// Double bridges at most, which bounds the time.
const MOST_BRIDGES: usize = 10_000;
/// The longest part that a double bridge exchanges; 50 is as good and takes longer.
const LONGEST_BRIDGED: usize = 20;
/// Steps of reversals after which no further double bridge is tried; bounds the time for very many dots.
const MOST_STEPS: u64 = 300_000_000;

/// A path through numbered positions whose first and last stay where they are.
struct DotPath<'a> {
    positions: &'a [DotPosition],
    neighbours: &'a [Vec<u32>],
    most_back: i32,
    order: Vec<u32>,
    /// Where in `order` each position is.
    at: Vec<u32>,
    /// Positions around which something has changed, and for each whether it is among them.
    queue: VecDeque<u32>,
    is_queued: Vec<bool>,
    /// The parts that were reversed since the last double bridge.
    reversals: Vec<(usize, usize)>,
    steps: u64,
}

/// Shortens `order`, which visits each of `positions` once; the first and the last stay. `neighbours` has the
/// candidates for a direct connection of each position but those two, nearest first. Along the path, no position
/// comes to lie more than `most_back` higher up (smaller second coordinate) than any before it, if that is so at the
/// beginning.
pub(super) fn shorten(positions: &[DotPosition], neighbours: &[Vec<u32>], order: Vec<u32>, most_back: i32) -> Vec<u32> {
    let mut at = vec![0; positions.len()];
    order.iter().enumerate().for_each(|(index, &position)| at[position as usize] = index as u32);
    let (queue, is_queued) = (VecDeque::new(), vec![false; positions.len()]);
    let mut path =
        DotPath { positions, neighbours, most_back, order, at, queue, is_queued, reversals: Vec::new(), steps: 0 };
    let inner = path.order.len().saturating_sub(2);
    (1..=inner).for_each(|index| path.enqueue(path.order[index]));
    path.search(MOST_CHANGES * inner);
    for number in 0..(BRIDGES * inner).min(MOST_BRIDGES) as u64 {
        if path.steps > MOST_STEPS {
            break;
        }
        path.reversals.clear();
        let Some(lost) = path.double_bridge(number) else { continue };
        if path.search(MOST_CHANGES) - lost < LEAST_GAIN {
            path.undo();
        }
    }
    path.order
}

impl DotPath<'_> {
    /// Makes changes at queued positions until none is a gain. Returns what was gained.
    fn search(&mut self, most_changes: usize) -> f64 {
        let (mut gained, mut changes) = (0.0, 0);
        while let Some(position) = self.queue.pop_front() {
            self.is_queued[position as usize] = false;
            while changes < most_changes {
                let Some((gain, touched)) = self.two_opt(position).or_else(|| self.or_opt(position)) else { break };
                changes += 1;
                gained += gain;
                touched.into_iter().for_each(|position| self.enqueue(position));
            }
        }
        gained
    }

    /// The ends of the path have no neighbours and are never queued.
    fn enqueue(&mut self, position: u32) {
        if (position as usize) < self.neighbours.len()
            && !std::mem::replace(&mut self.is_queued[position as usize], true)
        {
            self.queue.push_back(position);
        }
    }

    /// Exchanges two adjacent parts, which depend on the number. Returns what is lost, or nothing if the parts do not
    /// fit or must not be exchanged.
    fn double_bridge(&mut self, number: u64) -> Option<f64> {
        // Weyl sequences: multiples of the golden ratio and of the roots of 2 and 3 fill their range evenly.
        let pick = |factor: u64, below: usize| {
            ((u128::from(number.wrapping_add(1).wrapping_mul(factor)) * below as u128) >> 64) as usize
        };
        let last = self.order.len() - 2;
        let low = 1 + pick(0x9e37_79b9_7f4a_7c15, last);
        let gap = low + 1 + pick(0x6a09_e667_f3bc_c909, LONGEST_BRIDGED);
        let high = gap + pick(0xbb67_ae85_84ca_a73b, LONGEST_BRIDGED);
        if high > last || !self.may_move(low, gap - 1, high + 1, false) {
            return None;
        }
        let ends = [low - 1, low, gap - 1, gap, high, high + 1].map(|index| self.order[index]);
        let [before, a, b, c, d, behind] = ends;
        let old = self.length(before, a) + self.length(b, c) + self.length(d, behind);
        let new = self.length(before, c) + self.length(d, a) + self.length(b, behind);
        self.exchange(low, gap, high);
        ends.into_iter().for_each(|position| self.enqueue(position));
        Some(new - old)
    }

    fn undo(&mut self) {
        while let Some((low, high)) = self.reversals.pop() {
            self.reverse(low, high);
        }
    }

    fn index(&self, position: u32) -> usize {
        self.at[position as usize] as usize
    }

    fn length(&self, a: u32, b: u32) -> f64 {
        distance(self.positions[a as usize], self.positions[b as usize])
    }

    fn down(&self, position: u32) -> i32 {
        self.positions[position as usize][1]
    }

    /// 2-opt: connects `a` to a neighbour directly where that is a gain, and reverses the part between. Returns the
    /// gain and the ends of the edges that have changed.
    fn two_opt(&mut self, a: u32) -> Option<(f64, [u32; 6])> {
        let near = &self.neighbours[a as usize];
        let i = self.index(a);
        for after in [true, false] {
            let beside = |index: usize| if after { index + 1 } else { index - 1 };
            let b = self.order[beside(i)];
            let old = self.length(a, b);
            for &c in near {
                let new = self.length(a, c);
                if new >= old {
                    break;
                }
                let j = self.index(c);
                let d = self.order[beside(j)];
                let gain = old + self.length(c, d) - new - self.length(b, d);
                if gain < LEAST_GAIN {
                    continue;
                }
                let (low, high) = (i.min(j), i.max(j));
                let (low, high) = if after { (low + 1, high) } else { (low, high - 1) };
                if self.may_reverse(low, high) {
                    self.reverse(low, high);
                    self.reversals.push((low, high));
                    return Some((gain, [a, b, c, d, a, b]));
                }
            }
        }
        None
    }

    /// Or-opt: moves a part of the path that begins or ends at `a` to where that is a gain. Returns the gain and the
    /// ends of the edges that have changed.
    fn or_opt(&mut self, a: u32) -> Option<(f64, [u32; 6])> {
        let near = &self.neighbours[a as usize];
        let i = self.index(a);
        let last = self.order.len() - 2;
        for (length, forward) in (1..=LONGEST_PART).flat_map(|length| [(length, true), (length, false)]) {
            // `a` is the first position of the part if it goes forward, its last if not.
            let (low, high) = if forward { (i, i + length - 1) } else { ((i + 1).saturating_sub(length), i) };
            if low < 1 || high > last || (length == 1 && !forward) {
                continue;
            }
            let other = self.order[if forward { high } else { low }];
            let (before, behind) = (self.order[low - 1], self.order[high + 1]);
            let freed = self.length(before, self.order[low]) + self.length(self.order[high], behind)
                - self.length(before, behind);
            for &c in near {
                let new = self.length(a, c);
                if new >= freed {
                    break;
                }
                let j = self.index(c);
                if (low..=high).contains(&j) {
                    continue;
                }
                // `a` comes next to `c`, the other end next to the position before or behind `c`.
                for after in [true, false] {
                    let d = self.order[if after { j + 1 } else { j - 1 }];
                    if (low..=high).contains(&self.index(d)) {
                        continue; // the part already lies there
                    }
                    let gain = freed - new - self.length(other, d) + self.length(c, d);
                    if gain < LEAST_GAIN {
                        continue;
                    }
                    let reversed = forward != after;
                    // Between which two indices it goes: behind `gap - 1`, before `gap`.
                    let gap = if after { j + 1 } else { j };
                    if self.may_move(low, high, gap, reversed) {
                        self.move_part(low, high, gap, reversed);
                        return Some((gain, [a, other, before, behind, c, d]));
                    }
                }
            }
        }
        None
    }

    fn move_part(&mut self, low: usize, high: usize, gap: usize, reversed: bool) {
        if reversed {
            self.reverse(low, high);
            self.reversals.push((low, high));
        }
        if gap > high { self.exchange(low, high + 1, gap - 1) } else { self.exchange(gap, low, high) }
    }

    /// Exchanges the parts before and from `gap`: each is reversed, then both together.
    fn exchange(&mut self, low: usize, gap: usize, high: usize) {
        for (low, high) in [(low, gap - 1), (gap, high), (low, high)] {
            self.reverse(low, high);
            self.reversals.push((low, high));
        }
    }

    fn reverse(&mut self, low: usize, high: usize) {
        self.order[low..=high].reverse();
        for index in low..=high {
            self.at[self.order[index] as usize] = index as u32;
        }
        self.steps += (high - low + 1) as u64;
    }

    /// Whether a part can be reversed: any of its positions may then come before any other, so that none may lie
    /// farther down than `most_back` from any.
    fn may_reverse(&self, low: usize, high: usize) -> bool {
        let (mut least, mut most) = (i32::MAX, i32::MIN);
        self.most_back == i32::MAX
            || self.order[low..=high].iter().all(|&position| {
                (least, most) = (least.min(self.down(position)), most.max(self.down(position)));
                most.saturating_sub(least) <= self.most_back
            })
    }

    /// Whether a part can be exchanged with what lies between it and the gap, and reversed with it.
    fn may_move(&self, low: usize, high: usize, gap: usize, reversed: bool) -> bool {
        if self.most_back == i32::MAX {
            return true;
        }
        let downs = || self.order[low..=high].iter().map(|&position| self.down(position));
        let (least, most) = (downs().min().unwrap_or(0), downs().max().unwrap_or(0));
        let fits = |between: &u32| {
            let down = self.down(*between);
            if gap > high {
                least >= down.saturating_sub(self.most_back)
            } else {
                down >= most.saturating_sub(self.most_back)
            }
        };
        (!reversed || most.saturating_sub(least) <= self.most_back)
            && if gap > high {
                self.order[high + 1..gap].iter().all(fits)
            } else {
                self.order[gap..low].iter().rev().all(fits)
            }
    }
}

#[cfg(test)]
mod tests;
