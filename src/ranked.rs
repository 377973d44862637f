//! What waits in a heap, ordered by its rank alone.

use std::cmp::Ordering;

/// An item and its rank: of two the one of the higher rank is the greater, whatever they are.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ranked<K, T> {
    pub(crate) rank: K,
    pub(crate) item: T,
}

impl<K: Ord, T> Ord for Ranked<K, T> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank.cmp(&other.rank)
    }
}

impl<K: Ord, T> PartialOrd for Ranked<K, T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<K: Ord, T> PartialEq for Ranked<K, T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<K: Ord, T> Eq for Ranked<K, T> {}

/// A number as a part of a rank, in the order of [`f64::total_cmp`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct TotalOrder(pub(crate) f64);

impl Ord for TotalOrder {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for TotalOrder {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for TotalOrder {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for TotalOrder {}

#[cfg(test)]
mod tests;
