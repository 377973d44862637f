//! Tests of `ranked`.

use super::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

#[test]
fn the_highest_rank_comes_first_and_of_equal_ones_the_earlier() {
    let numbered = [2.0, -1.0, 2.0, f64::INFINITY, -0.0].into_iter().enumerate();
    let mut heap: BinaryHeap<Ranked<(TotalOrder, Reverse<usize>), f64>> =
        numbered.map(|(number, item)| Ranked { rank: (TotalOrder(item), Reverse(number)), item }).collect();
    let order: Vec<usize> = std::iter::from_fn(|| heap.pop()).map(|next| next.rank.1.0).collect();
    assert_eq!(order, [3, 0, 2, 4, 1]);
}
