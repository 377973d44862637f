//! Which traces a border runs along. If each of its vertices were put on the trace that is strongest there, the border
//! would leap between two that run side by side, as now the one is stronger and now the other, and have teeth. So it
//! takes the way on which least is lost of what is seen, where each leap costs something (dynamic programming: Amini et
//! al. 1990):
//!
//! ```text
//!    ---.  ,--.  ,-----                 ------------------
//!       |  |  |  |           becomes
//!    ==='--'=='--'======                 ==================   (it runs along one of them)
//! ```

use super::traces::{Seen, TraceMap};
use crate::units::{PxPoint, PxVector};

/// The direction of a border is taken over this many sides of cells before and after a place.
const SPAN: usize = 3;
/// What a leap costs for each cell that it goes aside or back: as much as so many vertices at which nothing is seen.
/// The outlines of a cat's eyes lost their teeth with 1 and with 5 alike.
const LEAP: f32 = 3.0;
/// A step from vertex to vertex may go so far aside, cells, and be no leap: traces bend, and borders run in stairs.
const ASIDE: f32 = 1.0;
/// Costs are counted in such parts of a vertex at which nothing is seen: sums of whole numbers are the same forwards
/// and backwards, so that a flipped picture has the flipped outlines.
const PARTS: f32 = 65_536.0;
/// A ring is followed so many times round, and the middle time counts, for which it does not matter where it begins.
const ROUNDS: usize = 3;

/// A trace that a vertex may lie on.
struct Choice {
    seen: Seen,
    /// What is lost by it.
    cost: u64,
}

/// What is seen of the traces that a border follows, vertex by vertex. `places` are those of the border, with the
/// region on the right.
pub(super) fn followed(traces: &TraceMap, places: &[PxPoint], closed: bool) -> Vec<Seen> {
    let headings = headings(places, closed);
    let beside = |(&place, &heading): (&PxPoint, &PxVector)| choices(traces, place, heading);
    let choices: Vec<Vec<Choice>> = places.iter().zip(&headings).map(beside).collect();
    let path = cheapest(&choices, &headings, closed);
    choices.iter().zip(path).map(|(choices, choice)| choices[choice].seen).collect()
}

/// The directions of a border at its places.
fn headings(places: &[PxPoint], closed: bool) -> Vec<PxVector> {
    let count = places.len();
    let heading = |i: usize| {
        let [before, after] = if closed {
            [(i + count - SPAN % count) % count, (i + SPAN) % count]
        } else {
            [i.saturating_sub(SPAN), (i + SPAN).min(count - 1)]
        };
        (places[after] - places[before]).try_normalize().unwrap_or(PxVector::new(1.0, 0.0))
    };
    (0..count).map(heading).collect()
}

/// The traces beside a place; there always is one, or the place itself.
fn choices(traces: &TraceMap, place: PxPoint, heading: PxVector) -> Vec<Choice> {
    let all = traces.all_seen(place, heading);
    let strongest = all.iter().map(|seen| seen.strength).fold(0.0, f32::max);
    let choice = |seen: Seen| {
        let lost = if strongest > 0.0 { 1.0 - seen.strength / strongest } else { 0.0 };
        // of two that are alike the one inside the region
        let is_outside = heading.cross(seen.at - place) < 0.0;
        Choice { seen, cost: parts(lost) + u64::from(is_outside) }
    };
    all.into_iter().map(choice).collect()
}

/// Costs are those of a few cells, far less than a number of 32 bits holds. Rounded to the nearest, of two to the
/// greater: a number of 64 bits holds the sum as it is.
fn parts(cost: f32) -> u64 {
    u64::from((f64::from(PARTS * cost) + 0.5) as u32)
}

/// Which choice of each vertex is on the way that costs least.
fn cheapest(choices: &[Vec<Choice>], headings: &[PxVector], closed: bool) -> Vec<usize> {
    let n = choices.len();
    let Some(first) = choices.first() else { return Vec::new() };
    let rounds = if closed { ROUNDS } else { 1 };
    let mut costs: Vec<u64> = first.iter().map(|choice| choice.cost).collect();
    // of each vertex but the first: from where each of its choices is reached
    let mut origins: Vec<Vec<usize>> = Vec::with_capacity(rounds * n);
    for i in 1..rounds * n {
        let (before, here) = ((i - 1) % n, i % n);
        let heading = (headings[before] + headings[here]).try_normalize().unwrap_or(PxVector::zero());
        let reach = |to: &Choice| reached(&choices[before], &costs, to, heading);
        let (next, of_vertex): (Vec<u64>, Vec<usize>) = choices[here].iter().map(reach).unzip();
        costs = next;
        origins.push(of_vertex);
    }
    let mut choice = (0..costs.len()).min_by_key(|&choice| costs[choice]).unwrap_or(0);
    let mut path = vec![choice];
    for of_vertex in origins.iter().rev() {
        choice = of_vertex[choice];
        path.push(choice);
    }
    path.reverse();
    path[rounds / 2 * n..][..n].to_vec()
}

/// The least cost of all up to a choice, and from which of those before it.
fn reached(before: &[Choice], costs: &[u64], to: &Choice, heading: PxVector) -> (u64, usize) {
    let mut least = (u64::MAX, 0);
    for (i, (from, &cost)) in before.iter().zip(costs).enumerate() {
        // most cost more even without a leap
        if cost < least.0 {
            let cost = cost + leap(from.seen, to.seen, heading);
            if cost < least.0 {
                least = (cost, i);
            }
        }
    }
    (least.0.saturating_add(to.cost), least.1)
}

/// What the step costs from one vertex to the next; nothing where a trace begins or ends.
fn leap(from: Seen, to: Seen, heading: PxVector) -> u64 {
    if from.strength <= 0.0 || to.strength <= 0.0 {
        return 0;
    }
    let step = to.at - from.at;
    let aside = (heading.cross(step).abs() - ASIDE).max(0.0);
    let back = (-heading.dot(step)).max(0.0);
    parts(LEAP * (aside + back))
}

#[cfg(test)]
mod tests;
