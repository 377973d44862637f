//! Makes a path shorter by small changes until none helps.
//!
//! 2-opt (Croes 1958) turns a part of the path round; Or-opt (Or 1976) moves one to three places elsewhere. Both look only
//! at neighbours and only where something has changed (Bentley 1992, Fast algorithms for geometric traveling salesman
//! problems). The path is an array, so that a change costs as many steps as places between its two ends.

use std::collections::VecDeque;

use super::{Place, distance};

/// The longest part that is moved as one.
const LONGEST_PART: usize = 3;
/// What counts as a gain, in hundredths of a millimetre: well above the rounding of sums, well below what can be measured.
const LEAST_GAIN: f64 = 1e-6;
/// Changes for each place. Every change is a gain, so that the search ends without it; about one for each place is usual.
const MOST_CHANGES: usize = 30;

/// A path through numbered places whose first and last place stay where they are.
struct Path<'a> {
    places: &'a [Place],
    most_back: i32,
    order: Vec<u32>,
    /// Where in `order` each place is.
    at: Vec<u32>,
}

/// Shortens `order`, which visits each of `places` once; the first and the last stay. `neighbours` has the places worth a
/// direct way from each place, nearest first. Going down the path, no place comes to lie more than `most_back` higher up
/// (smaller second coordinate) than any before it, if that is so at the beginning.
pub(super) fn shorten(places: &[Place], neighbours: &[Vec<u32>], order: Vec<u32>, most_back: i32) -> Vec<u32> {
    let mut at = vec![0; places.len()];
    order.iter().enumerate().for_each(|(index, &place)| at[place as usize] = index as u32);
    let mut path = Path { places, most_back, order, at };
    let inner = path.order.len().saturating_sub(2);
    let mut waiting: VecDeque<u32> = path.order.iter().copied().skip(1).take(inner).collect();
    let mut waits = vec![true; places.len()];
    let mut changes = MOST_CHANGES * inner;
    while let Some(place) = waiting.pop_front() {
        waits[place as usize] = false;
        let near = &neighbours[place as usize];
        while changes > 0 {
            let Some(touched) = path.turn(place, near).or_else(|| path.shift(place, near)) else { break };
            changes -= 1;
            for place in touched {
                if (place as usize) < neighbours.len() && !std::mem::replace(&mut waits[place as usize], true) {
                    waiting.push_back(place);
                }
            }
        }
    }
    path.order
}

impl Path<'_> {
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
    /// ends of the ways that have changed.
    fn turn(&mut self, a: u32, near: &[u32]) -> Option<[u32; 6]> {
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
                if old + self.length(c, d) - new - self.length(b, d) < LEAST_GAIN {
                    continue;
                }
                let (low, high) = (i.min(j), i.max(j));
                let (low, high) = if after { (low + 1, high) } else { (low, high - 1) };
                if self.may_turn(low, high) {
                    self.order[low..=high].reverse();
                    self.renumber(low, high);
                    return Some([a, b, c, d, a, b]);
                }
            }
        }
        None
    }

    /// Or-opt: looks for a better place for the part of the path that begins or ends at `a`. Gives the ends of the ways that
    /// have changed.
    fn shift(&mut self, a: u32, near: &[u32]) -> Option<[u32; 6]> {
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
                    let added = new + self.length(other, d) - self.length(c, d);
                    if freed - added < LEAST_GAIN {
                        continue;
                    }
                    let turned = forward != after;
                    // Between which two indices it goes: behind `gap - 1`, before `gap`.
                    let gap = if after { j + 1 } else { j };
                    if self.may_shift(low, high, gap, turned) {
                        self.move_part(low, high, gap, turned);
                        return Some([a, other, before, behind, c, d]);
                    }
                }
            }
        }
        None
    }

    fn move_part(&mut self, low: usize, high: usize, gap: usize, turned: bool) {
        if turned {
            self.order[low..=high].reverse();
        }
        if gap > high {
            self.order[low..gap].rotate_left(high - low + 1);
            self.renumber(low, gap - 1);
        } else {
            self.order[gap..=high].rotate_right(high - low + 1);
            self.renumber(gap, high);
        }
    }

    fn renumber(&mut self, low: usize, high: usize) {
        for index in low..=high {
            self.at[self.order[index] as usize] = index as u32;
        }
    }

    /// Whether a part can be turned round: each of its places then comes before or behind each other, so that none may lie
    /// farther down than `most_back` from any.
    fn may_turn(&self, low: usize, high: usize) -> bool {
        let (mut least, mut most) = (i32::MAX, i32::MIN);
        self.most_back == i32::MAX
            || self.order[low..=high].iter().all(|&place| {
                (least, most) = (least.min(self.down(place)), most.max(self.down(place)));
                most - least <= self.most_back
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
            if gap > high { least >= down - self.most_back } else { down >= most - self.most_back }
        };
        (!turned || most - least <= self.most_back)
            && if gap > high {
                self.order[high + 1..gap].iter().all(fits)
            } else {
                self.order[gap..low].iter().rev().all(fits)
            }
    }
}
