//! Which points on lines get room first.

use super::{Places, RowDot};
use crate::lines::PointMark;

/// A line has no end left at a point if its nearest dot is farther off than this, in steps: rounding to the grid moves
/// both by less. Chosen by us.
const OFF: f32 = 1.5;

impl Places<'_> {
    /// Draws those points on lines that are wanted and have room; says which. Last come those whose line ends before
    /// them now, as it was too near to another: what is nearest to them may be that other line, at the mark of which
    /// they would be felt, as the second contact of a switch at the end of its lever.
    pub(super) fn points_on_rows(&mut self, points: &[PointMark], wanted: &[bool]) -> Vec<bool> {
        let is_off: Vec<bool> = points.iter().map(|point| !point.is_alone && self.is_off(point)).collect();
        let mut are_drawn = vec![false; points.len()];
        for last in [false, true] {
            for (number, point) in points.iter().enumerate().filter(|(number, _)| is_off[*number] == last) {
                are_drawn[number] = wanted[number] && !point.is_alone && self.point(point);
            }
        }
        are_drawn
    }

    /// Whether no row runs through a point, but near it.
    fn is_off(&self, point: &PointMark) -> bool {
        let lattice = self.field.lattice;
        let far = |RowDot { at, .. }: RowDot| lattice.steps(lattice.to_steps(point.at), at);
        self.nearest(point.at, |_| true).is_some_and(|dot| far(dot) > OFF)
    }
}
