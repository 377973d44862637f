//! Weak rows, such as gridlines, are interrupted at points beside them.

use super::Places;
use super::lattice::Owner;
use crate::dots::grid_dot::GridPoint;
use crate::dots::params::LEAST_DOTS;
use crate::units::MmPoint;

impl Places<'_> {
    /// Whether a row is interrupted where a point beside it is near: a weak one without marks.
    pub(super) fn gives_way(&self, row: usize) -> bool {
        self.rows[row].is_weak && self.placed.runs[row].is_empty()
    }

    /// The dots that are nearer to a dot than lines may be.
    pub(super) fn near(&self, dot: GridPoint) -> impl Iterator<Item = (GridPoint, Owner)> + '_ {
        let (lattice, gap) = (self.field.lattice, self.params.line_gap as f32);
        let all = self.field.around(dot, gap + 1.0);
        all.filter(move |(_, other, _)| lattice.are_near(dot, *other, gap)).map(|(_, other, owner)| (other, owner))
    }

    /// Takes the dots of weak rows out that are too near to these.
    pub(super) fn interrupt_weak(&mut self, dots: &[GridPoint]) {
        let near: Vec<(GridPoint, Owner)> = dots.iter().flat_map(|dot| self.near(*dot)).collect();
        for (dot, owner) in near {
            let Owner::Row(row, number) = owner else { continue };
            if self.gives_way(row) {
                let lattice = self.field.lattice;
                self.field.take_out(|other, of| lattice.are_one(other, dot) && of == owner, dot, 1.0);
                self.placed.hidden[row].push(self.rows[row].dots[number]);
            }
        }
    }

    /// Takes out what is left of interrupted rows between two points, where that is too short for a line.
    pub(super) fn drop_crumbs(&mut self) {
        for (row, hidden) in self.rows.iter().zip(&mut self.placed.hidden).filter(|(row, _)| row.is_weak) {
            let left = row.dots.chunk_by(|a, b| hidden.contains(a) == hidden.contains(b));
            let is_crumb = |part: &&[MmPoint]| part.len() < LEAST_DOTS && !hidden.contains(&part[0]);
            let crumbs: Vec<MmPoint> = left.filter(is_crumb).flatten().copied().collect();
            if !hidden.is_empty() {
                hidden.extend(crumbs);
            }
        }
    }
}
