//! How contours as data agree with what people outlined: ODS, OIS and AP of the benchmark (Martin, Fowlkes and Malik
//! 2004; Arbelaez and others 2011).
//!
//! At each of 33 thresholds of strength the contours above it are drawn, thinned (Guo and Hall 1989), and matched with
//! what each person outlined: one pixel with one pixel, no farther apart than the tolerance, as many pairs as there can
//! be. A drawn pixel is right if anybody's is its partner; of all people's pixels those are found that have one. *ODS*
//! is F at the one threshold that is best for all pictures, *OIS* at the best of each picture, *AP* the area below
//! precision over recall.

use std::collections::VecDeque;

use tactograph::{PxPoint, Trace};

use crate::measure::{Bits, Outlined, TOLERANCE, disc};

/// Contours are drawn in steps of at most this, px.
const STEP: f32 = 0.3;
/// How many thresholds there are; they are denser where contours are strong, as the best one lies there.
const THRESHOLDS: usize = 33;
/// About so many pictures tell where the thresholds are, each by so many quantiles of its strengths.
const TELLING: usize = 24;
const QUANTILES: usize = 201;
/// Stands for a pixel that has no partner.
const NONE: usize = usize::MAX;

/// The greatest strength of the contours in each pixel of a picture; 0 where there are none.
pub(super) struct StrengthMap {
    width: usize,
    height: usize,
    strengths: Vec<f32>,
}

/// Pixels at one threshold.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Counts {
    drawn: usize,
    right: usize,
    wanted: usize,
    found: usize,
}

/// The three figures of a set of pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scores {
    pub(super) ods: f64,
    pub(super) ois: f64,
    pub(super) ap: f64,
}

impl StrengthMap {
    pub(super) fn of(trace: &Trace) -> Self {
        let (width, height) = (trace.size.width as usize, trace.size.height as usize);
        let mut map = Self { width, height, strengths: vec![0.0; width * height] };
        for polyline in &trace.polylines {
            let count = polyline.points.len();
            let pieces = if polyline.closed { count } else { count.saturating_sub(1) };
            let at = |number: usize| (polyline.points[number % count], polyline.strength[number % count]);
            (0..pieces).for_each(|number| map.draw(at(number), at(number + 1)));
        }
        map
    }

    /// Draws a piece of a contour between two points, each with its strength.
    fn draw(&mut self, (from, weak): (PxPoint, f32), (to, strong): (PxPoint, f32)) {
        let steps = ((to.x - from.x).hypot(to.y - from.y) / STEP).ceil().max(1.0);
        for step in 0..steps as usize {
            let share = (step as f32 + 0.5) / steps;
            let between = |a: f32, b: f32| a + share * (b - a);
            let x = (between(from.x, to.x).max(0.0) as usize).min(self.width - 1);
            let y = (between(from.y, to.y).max(0.0) as usize).min(self.height - 1);
            let strength = &mut self.strengths[y * self.width + x];
            *strength = strength.max(between(weak, strong));
        }
    }

    /// What is at least as strong as a threshold.
    fn above(&self, threshold: f32) -> Bits {
        let set = self.strengths.iter().map(|strength| *strength >= threshold).collect();
        Bits { width: self.width, height: self.height, set }
    }

    /// Quantiles of the strengths; none without contours.
    fn quantiles(&self) -> Vec<f32> {
        let mut strengths: Vec<f32> = self.strengths.iter().copied().filter(|strength| *strength > 0.0).collect();
        strengths.sort_by(f32::total_cmp);
        let shares = (0..QUANTILES).map(|number| number as f64 / (QUANTILES - 1) as f64);
        shares.filter_map(|share| quantile(&strengths, share)).collect()
    }
}

/// A quantile of sorted values, between two of them in proportion.
fn quantile(sorted: &[f32], share: f64) -> Option<f32> {
    let at = share * sorted.len().checked_sub(1)? as f64;
    let below = at.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    Some(sorted[below] + (at - at.floor()) as f32 * (sorted[above] - sorted[below]))
}

/// The thresholds for a set of pictures, the lowest first.
pub(super) fn thresholds(maps: &[&StrengthMap]) -> Vec<f32> {
    let step = (maps.len() / TELLING).max(1);
    let mut all: Vec<f32> = maps.iter().step_by(step).flat_map(|map| map.quantiles()).collect();
    all.sort_by(f32::total_cmp);
    let share = |number: usize| 1.0 - (1.0 - 0.97 * number as f64 / (THRESHOLDS - 1) as f64).powf(1.5);
    let mut thresholds: Vec<f32> = (0..THRESHOLDS).filter_map(|number| quantile(&all, share(number))).collect();
    thresholds.dedup_by(|a, b| a.total_cmp(b).is_eq());
    thresholds
}

/// What is counted in a picture at each threshold.
pub(super) fn counts(map: &StrengthMap, people: &[Outlined], thresholds: &[f32]) -> Vec<Counts> {
    let outlined: Vec<Bits> = people.iter().map(|person| Bits::of(&person.boundaries)).collect();
    let mut near = disc(TOLERANCE * (map.width as f64).hypot(map.height as f64));
    near.sort_by_key(|(x, y)| x * x + y * y);
    let at = |&threshold: &f32| {
        let drawn = thinned(map.above(threshold));
        let mut is_right = vec![false; drawn.set.len()];
        let mut counts = Counts { drawn: drawn.pixels().count(), ..Counts::default() };
        for of_person in &outlined {
            let matched = matched(&drawn, of_person, &near);
            counts.wanted += of_person.pixels().count();
            counts.found += matched.len();
            matched.into_iter().for_each(|pixel| is_right[pixel] = true);
        }
        Counts { right: is_right.iter().filter(|is_right| **is_right).count(), ..counts }
    };
    thresholds.iter().map(at).collect()
}

/// The drawn pixels that have a partner: one pixel with one pixel of those outlined, one of the offsets, the nearest
/// first, apart; as many pairs as there can be.
fn matched(drawn: &Bits, outlined: &Bits, offsets: &[(i64, i64)]) -> Vec<usize> {
    let own: Vec<usize> = (0..drawn.set.len()).filter(|at| drawn.set[*at]).collect();
    let mut number_of = vec![NONE; drawn.set.len()];
    (0..).zip(&own).for_each(|(number, &at)| number_of[at] = number);
    let in_reach = |(x, y): (i64, i64)| -> Vec<(usize, usize)> {
        let at = offsets.iter().map(|(dx, dy)| drawn.index(x + dx, y + dy).map_or(NONE, |at| number_of[at]));
        at.enumerate().filter(|(_, number)| *number != NONE).collect()
    };
    let near: Vec<Vec<(usize, usize)>> = outlined.pixels().map(in_reach).collect();
    let mut pairs: Vec<(usize, usize, usize)> = Vec::new();
    for (person, near) in near.iter().enumerate() {
        pairs.extend(near.iter().map(|&(rank, own)| (rank, person, own)));
    }
    pairs.sort_unstable();
    let (mut of_own, mut of_person) = (vec![NONE; own.len()], vec![NONE; near.len()]);
    for (_, person, own) in pairs {
        if of_person[person] == NONE && of_own[own] == NONE {
            (of_person[person], of_own[own]) = (own, person);
        }
    }
    // others may change partners so that one more has one
    let (mut seen_from, mut reached_by) = (vec![NONE; own.len()], vec![NONE; own.len()]);
    for start in 0..near.len() {
        if of_person[start] != NONE {
            continue;
        }
        let mut free = None;
        let mut open = VecDeque::from([start]);
        'search: while let Some(person) = open.pop_front() {
            for &(_, own) in &near[person] {
                if seen_from[own] == start {
                    continue;
                }
                (seen_from[own], reached_by[own]) = (start, person);
                if of_own[own] == NONE {
                    free = Some(own);
                    break 'search;
                }
                open.push_back(of_own[own]);
            }
        }
        while let Some(own) = free {
            let person = reached_by[own];
            let left = std::mem::replace(&mut of_person[person], own);
            of_own[own] = person;
            free = (left != NONE).then_some(left);
        }
    }
    own.into_iter().zip(of_own).filter(|(_, person)| *person != NONE).map(|(at, _)| at).collect()
}

/// Around a pixel: from the right on, counter-clockwise.
const AROUND: [(i64, i64); 8] = [(1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1)];

/// Lines of one pixel in width (Guo and Hall 1989).
fn thinned(mut bits: Bits) -> Bits {
    loop {
        let before = bits.pixels().count();
        for first in [true, false] {
            let is_set = |x: i64, y: i64| bits.index(x, y).is_some_and(|at| bits.set[at]);
            let is_gone = |&(x, y): &(i64, i64)| goes(AROUND.map(|(dx, dy)| is_set(x + dx, y + dy)), first);
            let gone: Vec<usize> = bits.pixels().filter(is_gone).filter_map(|(x, y)| bits.index(x, y)).collect();
            gone.into_iter().for_each(|at| bits.set[at] = false);
        }
        if bits.pixels().count() == before {
            return bits;
        }
    }
}

/// Whether a pixel with these around it goes, in the first or in the second half of a round.
fn goes(around: [bool; 8], first: bool) -> bool {
    let at = |number: usize| around[number % 8];
    let parts = (0..4_usize).filter(|&k| !at(2 * k) && (at(2 * k + 1) || at(2 * k + 2))).count();
    let pairs = |shift: usize| (0..4_usize).filter(|&k| at(2 * k + shift) || at(2 * k + shift + 1)).count();
    let neighbours = pairs(0).min(pairs(1));
    let stays = if first { (at(1) || at(2) || !at(7)) && at(0) } else { (at(5) || at(6) || !at(3)) && at(4) };
    parts == 1 && (2..=3).contains(&neighbours) && !stays
}

impl Counts {
    fn plus(self, other: Self) -> Self {
        Self {
            drawn: self.drawn + other.drawn,
            right: self.right + other.right,
            wanted: self.wanted + other.wanted,
            found: self.found + other.found,
        }
    }

    fn precision(self) -> f64 {
        self.right as f64 / self.drawn.max(1) as f64
    }

    fn recall(self) -> f64 {
        self.found as f64 / self.wanted.max(1) as f64
    }

    fn f(self) -> f64 {
        f_of(self.precision(), self.recall())
    }
}

fn f_of(precision: f64, recall: f64) -> f64 {
    2.0 * precision * recall / (precision + recall).max(1e-12)
}

/// The figures of pictures of which each is counted at the same thresholds.
pub(super) fn scores(pictures: &[Vec<Counts>]) -> Scores {
    let thresholds = pictures.first().map_or(0, Vec::len);
    let all = |of: usize| pictures.iter().fold(Counts::default(), |sum, picture| sum.plus(picture[of]));
    let all: Vec<[f64; 2]> = (0..thresholds).map(all).map(|sum| [sum.recall(), sum.precision()]).collect();
    // between two thresholds in proportion, as the benchmark has it
    let between = |pair: &[[f64; 2]]| {
        let at = |share: f64| [0, 1].map(|k| pair[0][k] + share * (pair[1][k] - pair[0][k]));
        let steps = (0..100_u32).map(|step| at(f64::from(step) / 99.0));
        steps.map(|[recall, precision]| f_of(precision, recall)).fold(0.0, f64::max)
    };
    let best = |picture: &Vec<Counts>| picture.iter().copied().max_by(|a, b| a.f().total_cmp(&b.f()));
    let of_best = pictures.iter().filter_map(best).fold(Counts::default(), Counts::plus);
    Scores { ods: all.windows(2).map(between).fold(0.0, f64::max), ois: of_best.f(), ap: average_precision(all) }
}

/// The mean precision at the recalls 0, 0.01 to 1; 0 at those that are not reached.
fn average_precision(mut all: Vec<[f64; 2]>) -> f64 {
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let precision = |recall: f64| {
        let pair = all.windows(2).find(|pair| (pair[0][0]..=pair[1][0]).contains(&recall))?;
        let share = (recall - pair[0][0]) / (pair[1][0] - pair[0][0]).max(1e-12);
        Some(pair[0][1] + share * (pair[1][1] - pair[0][1]))
    };
    (0..=100_u32).filter_map(|percent| precision(f64::from(percent) / 100.0)).sum::<f64>() / 101.0
}

#[cfg(test)]
mod tests;
