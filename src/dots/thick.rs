//! Heavy lines are two dots wide: a second row beside the first.

use std::collections::BTreeSet;

use super::cells::Cell;
use crate::units::{MmPoint, MmVector};

/// The second row of a line on a grid: below what runs flat, to the right of what runs steep, so that both rows have the same
/// direction everywhere and the band is two dots wide throughout.
pub(super) fn beside(cells: &[Cell], closed: bool) -> Vec<Cell> {
    let n = cells.len();
    let first: BTreeSet<Cell> = cells.iter().copied().collect();
    let mut seen = BTreeSet::new();
    let mut out = Vec::with_capacity(n);
    for (i, &[x, y]) in cells.iter().enumerate() {
        let before = if closed { cells[(i + n - 1) % n] } else { cells[i.saturating_sub(1)] };
        let after = if closed { cells[(i + 1) % n] } else { cells[(i + 1).min(n - 1)] };
        let is_flat = (after[0] - before[0]).abs() >= (after[1] - before[1]).abs();
        let cell = if is_flat { [x, y + 1] } else { [x + 1, y] };
        if !first.contains(&cell) && seen.insert(cell) {
            out.push(cell);
        }
    }
    out
}

/// Two rows on both sides of a line whose dots can be anywhere, half a pitch from it each.
pub(super) fn both_sides(dots: &[MmPoint], closed: bool, pitch: f32) -> [Vec<MmPoint>; 2] {
    let n = dots.len();
    let aside = |i: usize| {
        let before = if closed { dots[(i + n - 1) % n] } else { dots[i.saturating_sub(1)] };
        let after = if closed { dots[(i + 1) % n] } else { dots[(i + 1).min(n - 1)] };
        let along = (after - before).try_normalize().unwrap_or(MmVector::new(1.0, 0.0));
        MmVector::new(-along.y, along.x) * (0.5 * pitch)
    };
    [1.0, -1.0].map(|side| (0..n).map(|i| dots[i] + aside(i) * side).collect())
}
