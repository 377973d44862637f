//! Which of its places each label takes, so that as many as possible have one.
//!
//! Greedy, in several orders; then a search that moves labels out of the way of one that
//! has none, and others out of theirs; then each to its best place that is free. On small cases it is held against
//! all possibilities.

/// A label in one of its places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// The label.
    pub label: usize,
    /// Its place.
    pub candidate: usize,
}

/// How often all labels are gone through. Few cases need more than two.
const ROUNDS: usize = 6;

/// The place of each label, if it has one, of places given by their costs (the cheapest first). `conflict` says whether
/// two labels cannot be in these places together.
pub fn choose(costs: &[Vec<f32>], conflict: &dyn Fn(Choice, Choice) -> bool) -> Vec<Option<usize>> {
    let in_order: Vec<usize> = (0..costs.len()).collect();
    let mut fewest_first = in_order.clone();
    fewest_first.sort_by_key(|&label| costs[label].len());
    let mut orders = vec![fewest_first];
    if costs.len() <= MOST_IN_ALL_ORDERS {
        orders.push(orders[0].iter().rev().copied().collect());
        orders.push(in_order.iter().rev().copied().collect());
        orders.push(in_order);
    }
    let found = orders.iter().map(|order| in_one_order(costs, conflict, order));
    // the first of the best: most labels, then least cost
    let value = |chosen: &[Option<usize>]| {
        let cost: f32 = chosen.iter().zip(costs).filter_map(|(chosen, costs)| Some(costs[(*chosen)?])).sum();
        (chosen.iter().flatten().count(), cost)
    };
    let better = |a: Vec<Option<usize>>, b: Vec<Option<usize>>| {
        let ((count_a, cost_a), (count_b, cost_b)) = (value(&a), value(&b));
        if count_b > count_a || count_b == count_a && cost_b < cost_a { b } else { a }
    };
    found.reduce(better).unwrap_or_default()
}

/// Up to so many labels are tried in several orders.
const MOST_IN_ALL_ORDERS: usize = 60;

fn in_one_order(costs: &[Vec<f32>], conflict: &dyn Fn(Choice, Choice) -> bool, order: &[usize]) -> Vec<Option<usize>> {
    let mut search = Search { costs, conflict, chosen: vec![None; costs.len()], tries: MOST_TRIES };
    for &label in order {
        search.take_best(label);
    }
    for _ in 0..ROUNDS {
        let missing: Vec<usize> = order.iter().copied().filter(|&label| search.chosen[label].is_none()).collect();
        let mut changed = false;
        for label in missing {
            changed |= search.displace_others(label, DEPTH, &mut Vec::new());
        }
        for &label in order {
            changed |= search.take_best(label);
        }
        if !changed {
            break;
        }
    }
    search.chosen
}

/// How many labels make way for one.
const MOST_MOVED: usize = 2;
/// How many labels in a row make way for one another.
const DEPTH: usize = 3;
/// Most places that are tried while labels make way: a second's work on a page of two hundred labels.
const MOST_TRIES: usize = 100_000;

struct Search<'a> {
    costs: &'a [Vec<f32>],
    conflict: &'a dyn Fn(Choice, Choice) -> bool,
    chosen: Vec<Option<usize>>,
    /// How many places may still be tried.
    tries: usize,
}

impl Search<'_> {
    /// The labels that stand in the way of a choice.
    fn blockers_of(&self, choice: Choice) -> impl Iterator<Item = usize> {
        let stands = move |&label: &usize| {
            let other = self.chosen[label].map(|candidate| Choice { label, candidate });
            label != choice.label && other.is_some_and(|other| (self.conflict)(choice, other))
        };
        (0..self.costs.len()).filter(stands)
    }

    /// Puts a label to its cheapest place that is free; whether that is another than before.
    fn take_best(&mut self, label: usize) -> bool {
        let before = self.chosen[label];
        let end = before.unwrap_or(self.costs[label].len());
        let best = (0..end).find(|&candidate| self.blockers_of(Choice { label, candidate }).next().is_none());
        self.chosen[label] = best.or(before);
        self.chosen[label] != before
    }

    /// Finds a place for a label that has none by moving one or two others, and for these by moving others again, but
    /// none of `held`.
    fn displace_others(&mut self, label: usize, depth: usize, held: &mut Vec<usize>) -> bool {
        for candidate in 0..self.costs[label].len() {
            if self.tries == 0 {
                return false;
            }
            self.tries -= 1;
            let blockers: Vec<usize> = self.blockers_of(Choice { label, candidate }).take(MOST_MOVED + 1).collect();
            if blockers.len() > MOST_MOVED || blockers.iter().any(|other| held.contains(other)) {
                continue;
            }
            let before = self.chosen.clone();
            blockers.iter().for_each(|&other| self.chosen[other] = None);
            self.chosen[label] = Some(candidate);
            held.push(label);
            let all_placed = blockers.iter().all(|&other| {
                self.take_best(other);
                self.chosen[other].is_some() || depth > 0 && self.displace_others(other, depth - 1, held)
            });
            held.pop();
            if all_placed {
                return true;
            }
            self.chosen = before;
        }
        false
    }
}

#[cfg(test)]
mod tests;
