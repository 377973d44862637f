//! What is summed over scenes, and the figures made of it. Lengths and distances in pixels.

use std::collections::BTreeMap;

use crate::scene::Family;

/// Width of the classes of true steps, code values; class 0 is around 0.
pub(crate) const STEP_CLASS: f64 = 4.0;

/// Sums over scenes; the quotients are made at the end.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sums {
    /// Distances of traced places to the truth, those within the gate of [`crate::measure`].
    pub(crate) errors: Vec<f32>,
    pub(crate) true_length: f64,
    pub(crate) found_length: f64,
    pub(crate) traced_length: f64,
    pub(crate) right_length: f64,
    /// Contours that were found at all, and chains on them.
    pub(crate) contours: f64,
    pub(crate) pieces: f64,
    pub(crate) rings: f64,
    pub(crate) closed_rings: f64,
    /// Distances from true corners and junctions to the nearest traced line.
    pub(crate) corners: Vec<f64>,
    pub(crate) junctions: Vec<f64>,
    /// How much of each branch of a junction is missing near it.
    pub(crate) branches: Vec<f64>,
    /// Rank correlation of strength with the true step, a scene each.
    pub(crate) ranks: Vec<f64>,
    /// True and found length by the true step, in classes of [`STEP_CLASS`].
    pub(crate) by_step: [[f64; 2]; 24],
    /// All traced length and the area, px; of use where nothing is true.
    pub(crate) all_length: f64,
    pub(crate) area: f64,
}

impl Sums {
    pub(crate) fn add(&mut self, other: &Self) {
        self.errors.extend(&other.errors);
        self.corners.extend(&other.corners);
        self.junctions.extend(&other.junctions);
        self.branches.extend(&other.branches);
        self.ranks.extend(&other.ranks);
        for (to, from) in self.by_step.iter_mut().zip(&other.by_step) {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += from);
        }
        for (to, from) in [
            (&mut self.true_length, other.true_length),
            (&mut self.found_length, other.found_length),
            (&mut self.traced_length, other.traced_length),
            (&mut self.right_length, other.right_length),
            (&mut self.contours, other.contours),
            (&mut self.pieces, other.pieces),
            (&mut self.rings, other.rings),
            (&mut self.closed_rings, other.closed_rings),
            (&mut self.all_length, other.all_length),
            (&mut self.area, other.area),
        ] {
            *to += from;
        }
    }

    /// The sums of several families in one.
    pub(crate) fn over(by_family: &BTreeMap<Family, Self>, families: &[Family]) -> Self {
        let mut sums = Self::default();
        families.iter().filter_map(|family| by_family.get(family)).for_each(|family| sums.add(family));
        sums
    }

    /// Share of the true length that is found.
    pub(crate) fn recall(&self) -> f64 {
        self.found_length / self.true_length
    }

    /// Share of the traced length that is right.
    pub(crate) fn precision(&self) -> f64 {
        self.right_length / self.traced_length
    }

    /// All traced length for a million pixels.
    pub(crate) fn per_megapixel(&self) -> f64 {
        1e6 * (self.all_length + 0.0) / self.area // an empty sum is -0
    }

    /// Root of the mean square distance of traced places to the truth.
    pub(crate) fn rms(&self) -> f64 {
        let squares: f64 = self.errors.iter().map(|&e| f64::from(e).powi(2)).sum();
        (squares / self.errors.len() as f64).sqrt()
    }

    /// The distance that 95 of 100 traced places do not exceed.
    pub(crate) fn p95(&self) -> f64 {
        let mut errors = self.errors.clone();
        let place = (0.95 * errors.len() as f64) as usize;
        if errors.is_empty() {
            return f64::NAN;
        }
        f64::from(*errors.select_nth_unstable_by(place, f32::total_cmp).1)
    }

    /// The smallest step (code values) from which on more than half of the true length is found.
    pub(crate) fn smallest_step(&self) -> f64 {
        let lost = self.by_step.iter().rposition(|[length, found]| *length > 0.0 && *found <= 0.5 * length);
        lost.map_or(0.0, |class| (class + 1) as f64 * STEP_CLASS)
    }

    /// Mean of a list; not a number if it is empty.
    pub(crate) fn mean(list: &[f64]) -> f64 {
        list.iter().sum::<f64>() / list.len() as f64
    }
}

/// Spearman's: the correlation of ranks, equal values sharing the mean of theirs.
pub(crate) fn rank_correlation(pairs: &[(f64, f64)]) -> f64 {
    let first = ranks(pairs.iter().map(|pair| pair.0).collect());
    let second = ranks(pairs.iter().map(|pair| pair.1).collect());
    let mean = 0.5 * (pairs.len() as f64 - 1.0);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>();
    product(&first, &second) / (product(&first, &first) * product(&second, &second)).sqrt()
}

fn ranks(values: Vec<f64>) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    for equal in order.chunk_by(|&a, &b| values[a].total_cmp(&values[b]).is_eq()) {
        let mean = first as f64 + 0.5 * (equal.len() as f64 - 1.0);
        equal.iter().for_each(|&i| ranks[i] = mean);
        first += equal.len();
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(got: f64, want: f64, within: f64) {
        assert!((got - want).abs() <= within, "{got} is not {want}");
    }

    #[test]
    fn ranks_ignore_any_growing_law_and_share_ties() {
        let law: Vec<(f64, f64)> = (0..50).map(|i| (f64::from(i), f64::from(i).powi(3))).collect();
        close(rank_correlation(&law), 1.0, 1e-12);
        let against: Vec<(f64, f64)> = law.iter().map(|(a, b)| (*a, -b)).collect();
        close(rank_correlation(&against), -1.0, 1e-12);
        assert_eq!(ranks(vec![5.0, 1.0, 5.0]), [1.5, 0.0, 1.5]);
    }

    #[test]
    fn the_smallest_step_is_the_one_above_the_last_that_is_lost() {
        let mut sums = Sums::default();
        sums.by_step[1] = [10.0, 0.0];
        sums.by_step[2] = [10.0, 4.0];
        sums.by_step[3] = [10.0, 6.0];
        close(sums.smallest_step(), 12.0, 0.0);
    }
}
