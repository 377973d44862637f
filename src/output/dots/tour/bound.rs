//! How short a path can be at best.
//!
//! A path is a spanning tree, so that the least spanning tree is no longer than it. Held and Karp (1970, 1971) make the bound
//! tighter: a price on each place, paid for each way that ends there, changes all paths by the same amount but not all
//! trees; prices rise where the tree branches and fall where it ends, until the tree is nearly a path.

use super::{Place, distance};

/// Pairs of places looked at in all, which bounds the work: a few seconds. Enough for [`MOST_TREES`] of up to 4,400 places
/// and for five of 20,000.
const MOST_PAIRS: usize = 2_000_000_000;
/// Trees at most; three times as many raise the bound by 0.3 %.
const MOST_TREES: usize = 100;

/// A length that no path from the first of `places` through all others to the last is below; `known` is the length of one
/// such path, which sets how fast prices change. In the unit of the places.
pub(super) fn lower_bound(places: &[Place], known: f64) -> f64 {
    let count = places.len();
    let trees = (MOST_PAIRS / (count * count).max(1)).clamp(1, MOST_TREES);
    let mut price = vec![0.0_f64; count];
    let (mut best, mut best_price) = (0.0_f64, price.clone());
    let mut step = 1.0;
    let mut without_gain = 0;
    for _ in 0..trees {
        let (length, degrees) = tree(places, &price);
        // A path pays the price of each place twice, but of its ends once.
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
        let wanted = |place: usize| if place == 0 || place == count - 1 { 1 } else { 2 };
        let off = |place: usize| f64::from(degrees[place] - wanted(place));
        let square = (0..count).map(|place| off(place).powi(2)).sum::<f64>();
        if square == 0.0 {
            break; // the tree is a path: nothing is shorter
        }
        // Polyak's step.
        let change = step * (known - bound).max(0.0) / square;
        price.iter_mut().enumerate().for_each(|(place, price)| *price += change * off(place));
    }
    best
}

/// Length of the least spanning tree with prices, and how many of its ways end at each place (Prim 1957, as an array).
fn tree(places: &[Place], price: &[f64]) -> (f64, Vec<i32>) {
    let mut degrees = vec![0; places.len()];
    let mut length = 0.0;
    // Places that are not in the tree yet: which, how far, from where.
    let mut left: Vec<(usize, f64, usize)> = (1..places.len()).map(|place| (place, f64::INFINITY, 0)).collect();
    let mut newest = 0;
    while !left.is_empty() {
        let mut nearest = 0;
        let mut least = f64::INFINITY;
        for (index, (place, far, from)) in left.iter_mut().enumerate() {
            let way = distance(places[newest], places[*place]) + price[newest] + price[*place];
            if way < *far {
                (*far, *from) = (way, newest);
            }
            if *far < least {
                (least, nearest) = (*far, index);
            }
        }
        let (place, far, from) = left.swap_remove(nearest);
        length += far;
        degrees[place] += 1;
        degrees[from] += 1;
        newest = place;
    }
    (length, degrees)
}
