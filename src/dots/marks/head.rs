//! Heads of arrows on rows of dots:
//!
//! ```text
//!            #                #
//!              #              #
//!   # # # # # # #    or     # # # #
//!              #          #
//!            #          #
//! ```

use super::{Places, RowDot};
use crate::dots::grid_dot::GridPoint;
use crate::dots::marks::lattice::{Lattice, Owner};
use crate::lines::HeadMark;
use crate::units::{MmPoint, MmVector};

/// Length of each of its two rows, mm, and the least dots of one.
const LENGTH: f32 = 7.0;
const LEAST: usize = 2;
/// A row leads to its head as its line did, but for 45 degrees: the cosine.
const ALONG: f32 = 0.7;
/// The direction of a row is taken over this length, mm.
const HEADING: f32 = 8.0;

/// The angle between a row and each of those of its head: on a grid and anywhere.
const SPREAD_ON_GRID: f32 = 45.0;
const SPREAD: f32 = 38.0;

impl Places<'_> {
    /// Draws the head of an arrow if there is room for it at the end of its row.
    pub(super) fn head(&mut self, mark: &HeadMark) -> bool {
        let is_end = |RowDot { row, number, .. }: RowDot| {
            let row = &self.rows[row];
            !row.closed && (number == 0 || number == row.dots.len() - 1)
        };
        let leads = |dot: RowDot| self.heading(dot).is_some_and(|way| way.dot(mark.toward) >= ALONG);
        let nearest = mark.has_shaft.then(|| self.nearest(mark.at, |dot| is_end(dot) && leads(dot)));
        let Some(tip) = nearest.flatten() else { return false };
        let Some(toward) = self.heading(tip).map(|way| self.on_lattice(way)) else { return false };
        let legs = self.legs(tip.at, toward);
        let count = legs.iter().map(Vec::len).sum();
        let is_free = |dot: &GridPoint| self.is_free(*dot, tip, count, None);
        if legs.iter().any(|leg| leg.len() < LEAST) || !legs.iter().flatten().all(is_free) {
            return false;
        }
        let [one, other] = legs;
        // from one end to the other, as it is read again
        let run: Vec<GridPoint> = one.into_iter().rev().chain(other).collect();
        let row = tip.row;
        run.iter().for_each(|dot| self.field.put(*dot, Owner::Row(row, tip.number)));
        let lattice = self.field.lattice;
        self.placed.runs[row].push(run.into_iter().map(|dot| lattice.to_mm(dot)).collect());
        self.placed.has_points[row] = true;
        true
    }

    /// Which way a row leads at one of its ends.
    fn heading(&self, RowDot { row, number, .. }: RowDot) -> Option<MmVector> {
        let dots = &self.rows[row].dots;
        let tip = *dots.get(number)?;
        let far = |at: &&MmPoint| (**at - tip).length() >= HEADING;
        let inner = if number == 0 { dots.iter().find(far) } else { dots.iter().rev().find(far) };
        (tip - *inner?).try_normalize()
    }

    /// A direction in which dots are even.
    fn on_lattice(&self, way: MmVector) -> MmVector {
        match self.field.lattice {
            Lattice::Free { .. } => way,
            Lattice::Grid { .. } => {
                let turn = std::f32::consts::FRAC_PI_4;
                let (sin, cos) = ((way.angle_from_x_axis().radians / turn).round() * turn).sin_cos();
                MmVector::new(cos, sin)
            }
        }
    }

    /// The dots of the two rows of a head, from its tip on, without that.
    fn legs(&self, tip: GridPoint, toward: MmVector) -> [Vec<GridPoint>; 2] {
        let (lattice, pitch) = (self.field.lattice, self.params.pitch);
        let spread = if matches!(lattice, Lattice::Grid { .. }) { SPREAD_ON_GRID } else { SPREAD };
        let at = lattice.to_mm(tip);
        [spread, -spread].map(|degrees| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let way = -MmVector::new(toward.x * cos - toward.y * sin, toward.x * sin + toward.y * cos);
            let most = (LENGTH / pitch).ceil() as usize;
            let mut dots = lattice.outward(tip, way, most);
            let far = |dot: GridPoint| (lattice.to_mm(dot) - at).length();
            let count = dots.iter().filter(|dot| far(**dot) <= LENGTH + 0.5 * pitch).count();
            dots.truncate(count.clamp(LEAST, most.max(LEAST)));
            dots
        })
    }
}
