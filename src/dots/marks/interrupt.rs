//! Rows that give way to points: weak ones, such as gridlines, are interrupted beside them, and others end before them.

use std::ops::Range;

use super::lattice::{Lattice, Owner};
use super::{Places, Row, row_of};
use crate::dots::grid_dot::GridPoint;
use crate::dots::params::LEAST_DOTS;
use crate::units::MmPoint;

/// What is left of a row between two points and is shorter than this share of the shortest line says nothing. Chosen by
/// us.
const SCRAP: f32 = 0.5;
/// A dot of another row so near to the end of one, in steps, is where both meet.
const NEXT: f32 = 1.5;
/// A row leads to a point if it has a dot no farther than this from the outermost of the point, in steps. On a grid it
/// is one of these; elsewhere dots are seldom quite in their places.
const LEADS_ON_GRID: f32 = 0.25;
const LEADS: f32 = 0.8;

/// A row that ends beside a point on another, as the arc of a jump along a number line does, is shortened by so many
/// dots at most: as much as the gap of two dots and the side of a small point. Chosen by us.
const SHORTENED: usize = 4;

impl Places<'_> {
    /// The dots of a row from this one to its end, if it may end before them: its end is near, in the blank, and what
    /// is left is a line.
    pub(super) fn free_end(&self, row: usize, dot: usize) -> Option<Range<usize>> {
        let (Row { dots, closed, .. }, lattice) = (&self.rows[row], self.field.lattice);
        let last = dots.len().checked_sub(1)?;
        let (range, end) = if 2 * dot <= last { (0..dot + 1, dots[0]) } else { (dot..dots.len(), dots[last]) };
        let is_other = |owner: Owner| !matches!(owner, Owner::Row(of, _) if of == row);
        let is_free = || !self.field.around(lattice.to_steps(end), NEXT).any(|(.., owner)| is_other(owner));
        // both of its ends may be shortened
        let left = dots.len().saturating_sub(2 * SHORTENED + 1) as f32 * self.params.pitch;
        let may_end = !closed && self.placed.runs[row].is_empty() && range.len() <= SHORTENED;
        (may_end && left >= self.params.min_length && is_free()).then_some(range)
    }

    /// Ends rows before these dots of a point, but for those that lead to it.
    pub(super) fn shorten(&mut self, dots: &[GridPoint], leads: &[usize]) {
        let near = dots.iter().flat_map(|dot| self.near(*dot));
        let ends = near.filter_map(|(_, owner)| match owner {
            Owner::Row(row, number) if !leads.contains(&row) && !self.gives_way(row, number) => {
                Some((row, self.free_end(row, number)?))
            }
            Owner::Row(..) | Owner::Tick(..) => None,
        });
        let ends: Vec<(usize, Range<usize>)> = ends.collect();
        for (row, range) in ends {
            range.for_each(|number| self.hide(row, number));
        }
    }

    /// Whether a row may be interrupted where points beside it are near: a weak one without marks.
    fn may_give_way(&self, row: usize) -> bool {
        self.rows[row].is_weak && self.placed.runs[row].is_empty()
    }

    /// Whether a row is interrupted at this one of its dots, by its number: where it goes on on both sides, so that a
    /// finger finds the rest, or anywhere if it is level or upright, as gridlines and ticks are.
    pub(super) fn gives_way(&self, row: usize, dot: usize) -> bool {
        let (Row { dots, closed, .. }, pitch) = (&self.rows[row], self.params.pitch);
        let beyond = dot.min(dots.len().saturating_sub(dot + 1));
        let goes_on = || *closed || beyond.saturating_sub(1) as f32 * pitch >= SCRAP * self.params.min_length;
        self.may_give_way(row) && (self.level[row] || goes_on())
    }

    /// The dots that are nearer to a dot than lines may be.
    pub(super) fn near(&self, dot: GridPoint) -> impl Iterator<Item = (GridPoint, Owner)> + '_ {
        let (lattice, gap) = (self.field.lattice, self.params.line_gap as f32);
        let all = self.field.around(dot, gap + 1.0);
        all.filter(move |(_, other, _)| lattice.are_near(dot, *other, gap)).map(|(_, other, owner)| (other, owner))
    }

    /// The rows that lead to a point.
    pub(super) fn leads_to(&self, middle: GridPoint, radius: i32) -> Vec<usize> {
        let dots = self.field.around(middle, self.leading(radius));
        dots.filter_map(|(.., owner)| row_of(owner)).collect()
    }

    /// How far from the middle of a point of this radius the dots of rows that lead to it are, in steps.
    fn leading(&self, radius: i32) -> f32 {
        let beyond = match self.field.lattice {
            Lattice::Grid { .. } => LEADS_ON_GRID,
            Lattice::Free { .. } => LEADS,
        };
        radius as f32 + beyond
    }

    /// The one weak row that ends at a point, beside its `own`, among those that lead to it: the thin line from the
    /// point to its name, or from an axis up to it. Where two end there one may be what is left of the other beyond the
    /// point, as of a gridline.
    pub(super) fn stem(&self, leads: &[usize], own: usize, (middle, radius): (GridPoint, i32)) -> Option<usize> {
        let mut weak = leads.iter().copied().filter(|&row| row != own && self.may_give_way(row));
        let row = weak.next()?;
        let (Row { dots, closed, .. }, lattice) = (&self.rows[row], self.field.lattice);
        let is_at = |dot: &MmPoint| lattice.steps(lattice.to_steps(*dot), middle) <= self.leading(radius);
        let mut ends = [dots.first(), dots.last()].into_iter().flatten();
        (weak.all(|other| other == row) && !closed && ends.any(is_at)).then_some(row)
    }

    /// Takes the dots of weak rows out that are too near to these of a point, but for those rows that stay.
    pub(super) fn interrupt_weak(&mut self, dots: &[GridPoint], stays: &[usize]) {
        let near: Vec<(GridPoint, Owner)> = dots.iter().flat_map(|dot| self.near(*dot)).collect();
        for (_, owner) in near {
            if let Owner::Row(row, number) = owner
                && !stays.contains(&row)
                && self.gives_way(row, number)
            {
                self.hide(row, number);
            }
        }
    }

    /// Takes out what is left of interrupted rows between two points, where that is too short for a line.
    pub(super) fn drop_scraps(&mut self) {
        for row in 0..self.rows.len() {
            let (Row { dots, closed, .. }, hidden) = (&self.rows[row], &self.placed.hidden[row]);
            let first_hidden = dots.iter().position(|dot| hidden.contains(dot));
            let Some(first) = first_hidden.filter(|_| self.may_give_way(row)) else {
                continue;
            };
            let mut dots = dots.clone();
            // what is left of a ring goes on over its begin
            dots.rotate_left(if *closed { first } else { 0 });
            let parts = dots.chunk_by(|a, b| hidden.contains(a) == hidden.contains(b));
            let length = |part: &[MmPoint]| part.len().saturating_sub(1) as f32 * self.params.pitch;
            let is_short = |part: &[MmPoint]| part.len() < LEAST_DOTS || length(part) < SCRAP * self.params.min_length;
            let is_scrap = |part: &&[MmPoint]| is_short(part) && !hidden.contains(&part[0]);
            let scraps: Vec<MmPoint> = parts.filter(is_scrap).flatten().copied().collect();
            self.placed.hidden[row].extend(scraps);
        }
    }
}
