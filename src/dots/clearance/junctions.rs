//! Where a line on a grid joins another, with an end or with a corner: dots of it may be nearer than the gap there.

use std::ops::Range;

use super::on_grid::{OccupiedDots, longest_approach, met};
use crate::dots::grid_dot::GridDot;

/// Where a line touches another that it ends on still with its dot of this number, counted from 0, it runs along it and
/// does not end there.
const fn longest_touch(gap: u32) -> u32 {
    longest_approach(gap) + 2
}

impl OccupiedDots {
    /// The junction of the first end of a line: the dots that [`OccupiedDots::junction`] tells are removed, and those
    /// from there until the gap is reached are allowed. Says whether there is one.
    pub(super) fn allow_junction(&self, cells: &mut Vec<GridDot>, distances: &mut Vec<Option<i32>>) -> bool {
        let Some((near, skipped)) = self.junction(cells, distances) else { return false };
        distances[..near].iter_mut().for_each(|distance| *distance = None);
        cells.drain(..skipped);
        distances.drain(..skipped);
        true
    }

    /// The junction of the first end of a line, if its first dots touch another line: how many of its dots are too near
    /// to that, from the one beside it until the gap is reached at most [`longest_approach`], and how many of these are
    /// on it or before it. Where it runs along the other there is none.
    fn junction(&self, cells: &[GridDot], distances: &[Option<i32>]) -> Option<(usize, usize)> {
        let near = distances.iter().take_while(|distance| distance.is_some()).count();
        let last = distances[..near].iter().rposition(|distance| distance.is_some_and(|steps| steps <= 1))?;
        let longest = longest_approach(self.gap as u32) as usize;
        if near - last > longest || last > longest_touch(self.gap as u32) as usize {
            return None;
        }
        let skipped = if distances[last] == Some(0) { last + 1 } else { last };
        // beside the lines that meet where it does it may lie, as a radius beside others, not beside a third one
        let within = |cell: GridDot| self.around(cell).filter_map(|near| self.piece_of.get(&near)).copied();
        let touched: Vec<usize> = within(cells[last]).collect();
        let is_beside_third = |cell: &GridDot| within(*cell).any(|other| !touched.contains(&other));
        let is_joined = !cells[skipped.min(near)..near].iter().any(is_beside_third);
        is_joined.then_some((near, skipped))
    }

    /// The dots of a line between two of its pieces that are left out where it has a corner on another line, as a
    /// triangle in a circle: each side joins the other line as an end does. `cut` are all the dots that are too near to
    /// that, by so many `steps`. None if a side does not join it.
    pub(super) fn corner(&self, cut: &[GridDot], steps: &[Option<i32>]) -> Option<Range<usize>> {
        let met = met(steps);
        if !self.is_near_one(cut) {
            return None;
        }
        if !steps.contains(&Some(0)) {
            return (steps.contains(&Some(1)) && self.has_short_arms(cut, steps)).then_some(met);
        }
        let back: Vec<GridDot> = cut[..=met.start].iter().rev().copied().collect();
        let steps_back: Vec<Option<i32>> = steps[..=met.start].iter().rev().copied().collect();
        let (_, before) = self.junction(&back, &steps_back)?;
        let on = met.end - 1;
        let (_, after) = self.junction(&cut[on..], &steps[on..])?;
        Some(met.start + 1 - before..on + after)
    }
}
