//! Where a line on a grid joins another, with an end or with a corner, or crosses several in a row: dots of it may be
//! nearer than the gap there.

use std::collections::BTreeSet;
use std::ops::Range;

use super::on_grid::{OccupiedDots, RowPiece, longest_approach, met};
use crate::dots::grid_dot::{GridDot, distance};

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

    /// The pieces of a line that crosses another and soon ends at a third, as from the bar of a family tree to a box:
    /// what lies beyond the other line is a link, and may be too short to have a dot that is far enough from both. None
    /// if it is none, or if the line does not come up to the other.
    pub(super) fn linked_end(&self, cells: &[GridDot], distances: &[Option<i32>]) -> Option<Vec<RowPiece>> {
        let on_last = distances.iter().rev().take_while(|steps| **steps == Some(0)).count();
        let crossed = distances[..distances.len() - on_last].iter().rposition(|steps| *steps == Some(0))?;
        let (own, crossed_piece) = (&cells[crossed..], *self.piece_of.get(&cells[crossed])?);
        let link = self.short_link(own, &distances[crossed..])?;
        let end = *link.cells.last()?;
        let ends_at =
            self.around(end).filter(|near| distance(*near, end) <= 1).filter_map(|near| self.piece_of.get(&near));
        let mut ends_at = ends_at.peekable();
        let leads_on = ends_at.peek().is_some() && ends_at.all(|piece| *piece != crossed_piece);
        let mut pieces = if leads_on { self.pieces(&cells[..=crossed], false) } else { Vec::new() };
        let comes_up =
            pieces.last().and_then(|piece| piece.cells.last()).is_some_and(|dot| distance(*dot, own[0]) <= 1);
        comes_up.then(|| {
            pieces.push(link);
            pieces
        })
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
        let is_joined = !cells[skipped..near].iter().any(is_beside_third);
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

    /// The dots of a line between two of its pieces that are left out where it crosses several others one after the
    /// other, as an axis the other axis and then a line of the chart, with no dot between that is far enough from all.
    /// `cut` are all the dots that are too near to those, by so many `steps`. None where one of them is near to two at
    /// once, or where the line runs along one of them.
    pub(super) fn crossings(&self, cut: &[GridDot], steps: &[Option<i32>]) -> Option<Vec<Range<usize>>> {
        let near = |cell: &GridDot| -> BTreeSet<usize> {
            self.around(*cell).filter_map(|near| self.piece_of.get(&near)).copied().collect()
        };
        let others: Vec<BTreeSet<usize>> = cut.iter().map(near).collect();
        let (mut from, mut all_met) = (0, Vec::new());
        for run in others.chunk_by(|one, next| one == next) {
            let of_run = from..from + run.len();
            let (dots, steps) = (&cut[of_run.clone()], &steps[of_run]);
            let touches = steps.iter().flatten().any(|steps| *steps <= 1);
            if !touches || !self.has_short_arms(dots, steps) || !self.is_on_both_sides(dots, steps) {
                return None;
            }
            let met = met(steps);
            all_met.push(from + met.start..from + met.end);
            from += run.len();
        }
        (all_met.len() > 1).then_some(all_met)
    }
}
