//! How short a path can be at best: the bound of Held and Karp.
//!
//! A path is a spanning tree, so that the minimum spanning tree is no longer than it. Held and Karp (1970, 1971) make
//! the bound tighter: a multiplier (here price) of each position, paid for each edge that ends there, changes all
//! paths by the same amount but not all trees; prices rise where the tree branches and fall where it ends, until the
//! tree is nearly a path.

use tactograph::internals::output::dots::path_order::{self, DotPosition};

use super::orders::{distance, length, sorted};

/// Pairs of positions looked at in all, which bounds the work: a few seconds. Enough for [`MOST_TREES`] of up to
/// 4,400 positions and for five of 20,000.
const MOST_PAIRS: usize = 2_000_000_000;
/// Trees at most; three times as many raise the bound by 0.3 %.
const MOST_TREES: usize = 100;

/// A length that no path through all `dots` from `ends[0]` to `ends[1]` is below, whatever its order: some 1 to 3 %
/// below the shortest path for up to 4,000 dots; for more dots the work is cut, and the bound falls towards that of
/// the minimum spanning tree, some 10 % below. Takes seconds.
pub fn lower_bound(dots: &[DotPosition], ends: [DotPosition; 2]) -> f64 {
    let dots = sorted(dots);
    let known = length(&path_order::order(&dots, ends, i32::MAX), ends);
    let positions: Vec<DotPosition> = [ends[0]].into_iter().chain(dots).chain([ends[1]]).collect();
    of_positions(&positions, known)
}

/// A length that no path from the first of `positions` through all others to the last is below; `known` is the length
/// of one such path, which sets how fast prices change. In the unit of the positions.
fn of_positions(positions: &[DotPosition], known: f64) -> f64 {
    let count = positions.len();
    let trees = (MOST_PAIRS / (count * count).max(1)).clamp(1, MOST_TREES);
    let mut price = vec![0.0_f64; count];
    let (mut best, mut best_price) = (0.0_f64, price.clone());
    let mut step = 1.0;
    let mut without_gain = 0;
    for _ in 0..trees {
        let (length, degrees) = tree(positions, &price);
        // A path pays the price of each position twice, but of its ends once.
        let paid = 2.0 * price.iter().sum::<f64>() - price[0] - price[count - 1];
        let bound = length - paid;
        if bound > best {
            (best, best_price) = (bound, price.clone());
            without_gain = 0;
        } else {
            without_gain += 1;
            if without_gain == 8 {
                (step, without_gain) = (step / 2.0, 0);
                price.clone_from(&best_price);
                continue;
            }
        }
        let wanted = |position: usize| if position == 0 || position == count - 1 { 1 } else { 2 };
        let off = |position: usize| f64::from(degrees[position] - wanted(position));
        let square = (0..count).map(|position| off(position).powi(2)).sum::<f64>();
        if square == 0.0 {
            break; // the tree is a path: nothing is shorter
        }
        // The step length of Polyak (1969).
        let change = step * (known - bound).max(0.0) / square;
        price.iter_mut().enumerate().for_each(|(position, price)| *price += change * off(position));
    }
    best
}

/// Length of the minimum spanning tree with prices, and how many of its edges end at each position (Prim 1957, as an
/// array).
fn tree(positions: &[DotPosition], price: &[f64]) -> (f64, Vec<i32>) {
    let mut degrees = vec![0; positions.len()];
    let mut length = 0.0;
    // Positions that are not in the tree yet: which, how far, from where.
    let mut left: Vec<(usize, f64, usize)> =
        (1..positions.len()).map(|position| (position, f64::INFINITY, 0)).collect();
    let mut newest = 0;
    while !left.is_empty() {
        let mut nearest = 0;
        let mut least = f64::INFINITY;
        for (index, (position, far, from)) in left.iter_mut().enumerate() {
            let length_with_prices =
                distance(positions[newest], positions[*position]) + price[newest] + price[*position];
            if length_with_prices < *far {
                (*far, *from) = (length_with_prices, newest);
            }
            if *far < least {
                (least, nearest) = (*far, index);
            }
        }
        let (position, far, from) = left.swap_remove(nearest);
        length += far;
        degrees[position] += 1;
        degrees[from] += 1;
        newest = position;
    }
    (length, degrees)
}
