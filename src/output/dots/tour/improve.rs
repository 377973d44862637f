//! Makes a path shorter by small changes until none helps, then by small upsets that are taken back unless they help.
//!
//! 2-opt (Croes 1958) turns a part of the path round; Or-opt (Or 1976) moves one to three places elsewhere. Both look only
//! at neighbours and only where something has changed (Bentley 1992, Fast algorithms for geometric traveling salesman
//! problems). Then two parts that follow each other change places, the double bridge of Martin, Otto and Felten 1991, kept
//! short so that mending it stays in one spot (Johnson and McGeoch 1997), and the two changes set to work again around it.
//! Where to upset is a fixed sequence, so that the same dots give the same path.
//!
//! The path is an array. Each change is made of parts turned round, which is undone by doing it again, last first; it costs
//! as many steps as places between its two ends.

use std::collections::VecDeque;

use super::{Place, distance};

/// The longest part that is moved as one.
const LONGEST_PART: usize = 3;
/// What counts as a gain, in hundredths of a millimetre: well above the rounding of sums, well below what can be measured.
const LEAST_GAIN: f64 = 1e-6;
/// Changes for each place before the first upset. Every change is a gain, so that the search ends without this limit; about
/// one for each place is usual.
const MOST_CHANGES: usize = 30;
/// Upsets for each place; twice as many would shorten paths by another 0.3 %.
const UPSETS: usize = 10;
/// Upsets at most, which bounds the time.
const MOST_UPSETS: usize = 10_000;
/// The longest part that changes places in an upset; 50 is as good and takes longer.
const LONGEST_UPSET: usize = 20;
/// Steps in turning parts round after which no further upset is tried; bounds the time for very many dots.
const MOST_STEPS: u64 = 300_000_000;

/// A path through numbered places whose first and last place stay where they are.
struct Path<'a> {
    places: &'a [Place],
    neighbours: &'a [Vec<u32>],
    most_back: i32,
    order: Vec<u32>,
    /// Where in `order` each place is.
    at: Vec<u32>,
    /// Places around which something has changed.
    waiting: VecDeque<u32>,
    waits: Vec<bool>,
    /// The parts that were turned round since the last upset.
    turned: Vec<(usize, usize)>,
    steps: u64,
}

/// Shortens `order`, which visits each of `places` once; the first and the last stay. `neighbours` has the places worth a
/// direct way from each place but those two, nearest first. Going down the path, no place comes to lie more than
/// `most_back` higher up (smaller second coordinate) than any before it, if that is so at the beginning.
pub(super) fn shorten(places: &[Place], neighbours: &[Vec<u32>], order: Vec<u32>, most_back: i32) -> Vec<u32> {
    let mut at = vec![0; places.len()];
    order.iter().enumerate().for_each(|(index, &place)| at[place as usize] = index as u32);
    let (waiting, waits) = (VecDeque::new(), vec![false; places.len()]);
    let mut path = Path { places, neighbours, most_back, order, at, waiting, waits, turned: Vec::new(), steps: 0 };
    let inner = path.order.len().saturating_sub(2);
    (1..=inner).for_each(|index| path.wait(path.order[index]));
    path.settle(MOST_CHANGES * inner);
    for number in 0..(UPSETS * inner).min(MOST_UPSETS) as u64 {
        if path.steps > MOST_STEPS {
            break;
        }
        path.turned.clear();
        let Some(lost) = path.upset(number) else { continue };
        if path.settle(MOST_CHANGES) - lost < LEAST_GAIN {
            path.undo();
        }
    }
    path.order
}

impl Path<'_> {
    /// Makes changes where places wait until none is a gain. Gives what was gained.
    fn settle(&mut self, most_changes: usize) -> f64 {
        let (mut gained, mut changes) = (0.0, 0);
        while let Some(place) = self.waiting.pop_front() {
            self.waits[place as usize] = false;
            while changes < most_changes {
                let Some((gain, touched)) = self.turn(place).or_else(|| self.shift(place)) else { break };
                changes += 1;
                gained += gain;
                touched.into_iter().for_each(|place| self.wait(place));
            }
        }
        gained
    }

    /// The ends of the path have no neighbours and never wait.
    fn wait(&mut self, place: u32) {
        if (place as usize) < self.neighbours.len() && !std::mem::replace(&mut self.waits[place as usize], true) {
            self.waiting.push_back(place);
        }
    }

    /// Lets two parts that follow each other change places; which, the number says. Gives what is lost, or nothing if the
    /// parts do not fit or must not change places.
    fn upset(&mut self, number: u64) -> Option<f64> {
        // Weyl's sequences: multiples of the golden section and of roots of 2 and 3 fill their range evenly.
        let pick = |factor: u64, below: usize| {
            ((u128::from(number.wrapping_add(1).wrapping_mul(factor)) * below as u128) >> 64) as usize
        };
        let last = self.order.len() - 2;
        let low = 1 + pick(0x9e37_79b9_7f4a_7c15, last);
        let gap = low + 1 + pick(0x6a09_e667_f3bc_c909, LONGEST_UPSET);
        let high = gap + pick(0xbb67_ae85_84ca_a73b, LONGEST_UPSET);
        if high > last || !self.may_shift(low, gap - 1, high + 1, false) {
            return None;
        }
        let ends = [low - 1, low, gap - 1, gap, high, high + 1].map(|index| self.order[index]);
        let [before, a, b, c, d, behind] = ends;
        let old = self.length(before, a) + self.length(b, c) + self.length(d, behind);
        let new = self.length(before, c) + self.length(d, a) + self.length(b, behind);
        self.exchange(low, gap, high);
        ends.into_iter().for_each(|place| self.wait(place));
        Some(new - old)
    }

    fn undo(&mut self) {
        while let Some((low, high)) = self.turned.pop() {
            self.reverse(low, high);
        }
    }

    fn index(&self, place: u32) -> usize {
        self.at[place as usize] as usize
    }

    fn length(&self, a: u32, b: u32) -> f64 {
        distance(self.places[a as usize], self.places[b as usize])
    }

    fn down(&self, place: u32) -> i32 {
        self.places[place as usize][1]
    }

    /// 2-opt: looks for a neighbour of `a` that is worth a direct way from it, and turns round what lies between. Gives the
    /// gain and the ends of the ways that have changed.
    fn turn(&mut self, a: u32) -> Option<(f64, [u32; 6])> {
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
                if self.may_turn(low, high) {
                    self.reverse(low, high);
                    self.turned.push((low, high));
                    return Some((gain, [a, b, c, d, a, b]));
                }
            }
        }
        None
    }

    /// Or-opt: looks for a better place for a part of the path that begins or ends at `a`. Gives the gain and the ends of
    /// the ways that have changed.
    fn shift(&mut self, a: u32) -> Option<(f64, [u32; 6])> {
        let near = &self.neighbours[a as usize];
        let i = self.index(a);
        let last = self.order.len() - 2;
        for (length, forward) in (1..=LONGEST_PART).flat_map(|length| [(length, true), (length, false)]) {
            // The part: `a` is its first place if it goes forward, its last if not.
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
                // `a` comes next to `c`, the other end next to the place before or behind `c`.
                for after in [true, false] {
                    let d = self.order[if after { j + 1 } else { j - 1 }];
                    if (low..=high).contains(&self.index(d)) {
                        continue; // the part already lies there
                    }
                    let gain = freed - new - self.length(other, d) + self.length(c, d);
                    if gain < LEAST_GAIN {
                        continue;
                    }
                    let turned = forward != after;
                    // Between which two indices it goes: behind `gap - 1`, before `gap`.
                    let gap = if after { j + 1 } else { j };
                    if self.may_shift(low, high, gap, turned) {
                        self.move_part(low, high, gap, turned);
                        return Some((gain, [a, other, before, behind, c, d]));
                    }
                }
            }
        }
        None
    }

    fn move_part(&mut self, low: usize, high: usize, gap: usize, turned: bool) {
        if turned {
            self.reverse(low, high);
            self.turned.push((low, high));
        }
        if gap > high { self.exchange(low, high + 1, gap - 1) } else { self.exchange(gap, low, high) }
    }

    /// The parts before and from `gap` change places: each is turned round, then both together.
    fn exchange(&mut self, low: usize, gap: usize, high: usize) {
        for (low, high) in [(low, gap - 1), (gap, high), (low, high)] {
            self.reverse(low, high);
            self.turned.push((low, high));
        }
    }

    fn reverse(&mut self, low: usize, high: usize) {
        self.order[low..=high].reverse();
        for index in low..=high {
            self.at[self.order[index] as usize] = index as u32;
        }
        self.steps += (high - low + 1) as u64;
    }

    /// Whether a part can be turned round: each of its places then comes before or behind each other, so that none may lie
    /// farther down than `most_back` from any.
    fn may_turn(&self, low: usize, high: usize) -> bool {
        let (mut least, mut most) = (i32::MAX, i32::MIN);
        self.most_back == i32::MAX
            || self.order[low..=high].iter().all(|&place| {
                (least, most) = (least.min(self.down(place)), most.max(self.down(place)));
                most.saturating_sub(least) <= self.most_back
            })
    }

    /// Whether a part can change places with what lies between it and the gap.
    fn may_shift(&self, low: usize, high: usize, gap: usize, turned: bool) -> bool {
        if self.most_back == i32::MAX {
            return true;
        }
        let downs = || self.order[low..=high].iter().map(|&place| self.down(place));
        let (least, most) = (downs().min().unwrap_or(0), downs().max().unwrap_or(0));
        let fits = |between: &u32| {
            let down = self.down(*between);
            if gap > high {
                least >= down.saturating_sub(self.most_back)
            } else {
                down >= most.saturating_sub(self.most_back)
            }
        };
        (!turned || most.saturating_sub(least) <= self.most_back)
            && if gap > high {
                self.order[high + 1..gap].iter().all(fits)
            } else {
                self.order[gap..low].iter().rev().all(fits)
            }
    }
}
