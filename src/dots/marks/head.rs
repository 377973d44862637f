//! Heads of arrows on rows of dots:
//!
//! ```text
//!            #                #
//!              #              #
//!   # # # # # # #    or     # # # #
//!              #          #
//!            #          #
//! ```

use super::{DIRECTION_SPAN, Places, RowDot};
use crate::dots::grid_dot::GridPoint;
use crate::dots::marks::lattice::{Lattice, Owner};
use crate::lines::HeadMark;
use crate::units::{MmPoint, MmVector};

/// Length of each of its two rows, mm, and the least dots of one.
const LENGTH: f32 = 7.0;
const LEAST: usize = 2;
/// A row leads to its head as its line did, but for 45 degrees: the cosine.
const ALONG: f32 = 0.7;
/// The direction of a row is taken over this length, mm, or up to its last bend: where it leads otherwise than its head
/// points by more than 60 degrees, the cosine.
const HEADING: f32 = 8.0;
const BENDS: f32 = 0.5;
/// So many empty dots lie between a head and its row before that bend.
const BEFORE_BEND: f32 = 1.0;

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
        let heading = |dot: RowDot| heading(&self.inward(dot), mark.toward);
        let leads = |dot: RowDot| heading(dot).is_some_and(|way| way.dot(mark.toward) >= ALONG);
        let nearest = mark.has_shaft.then(|| self.nearest(mark.at, |dot| is_end(dot) && leads(dot)));
        let Some(tip) = nearest.flatten() else { return false };
        let Some(toward) = heading(tip).map(|way| self.on_lattice(way)) else { return false };
        let legs = self.legs(tip.at, toward);
        let count = legs.iter().map(Vec::len).sum();
        let is_free = |dot: &GridPoint| self.is_free(*dot, (tip, None), count, None);
        if legs.iter().any(|leg| leg.len() < LEAST) || !legs.iter().flatten().all(is_free) {
            return false;
        }
        if self.is_at_bend(&legs, &self.inward(tip), mark.toward) {
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

    /// The dots of a row from one of its ends on.
    fn inward(&self, RowDot { row, number, .. }: RowDot) -> Vec<MmPoint> {
        let dots = &self.rows[row].dots;
        if number == 0 { dots.clone() } else { dots.iter().rev().copied().collect() }
    }

    /// Whether a head lies at its own row before the last bend of that: it would be felt as a part of the bend.
    fn is_at_bend(&self, legs: &[Vec<GridPoint>; 2], inward: &[MmPoint], toward: MmVector) -> bool {
        let lattice = self.field.lattice;
        let before = &inward[last_piece(inward, toward).len()..];
        let is_near =
            |dot: &GridPoint| before.iter().any(|other| lattice.are_near(*dot, lattice.to_steps(*other), BEFORE_BEND));
        legs.iter().flatten().any(is_near)
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

/// The dots of a row, from one of its ends on, up to its last bend.
fn last_piece(inward: &[MmPoint], toward: MmVector) -> &[MmPoint] {
    let bends = |dots: &[MmPoint]| {
        let way = dots[0] - dots[DIRECTION_SPAN];
        way.dot(toward) < BENDS * way.length()
    };
    let corner = inward.windows(DIRECTION_SPAN + 1).position(bends);
    corner.map_or(inward, |corner| &inward[..=corner])
}

/// Which way a row leads at one of its ends, at which a head points this way.
fn heading(inward: &[MmPoint], toward: MmVector) -> Option<MmVector> {
    let (tip, piece) = (*inward.first()?, last_piece(inward, toward));
    let is_bent = piece.len() < inward.len();
    let far = piece.iter().find(|at| (**at - tip).length() >= HEADING);
    let inner = far.or(piece.last().filter(|_| is_bent))?;
    (tip - *inner).try_normalize()
}
