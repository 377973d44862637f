//! Points beside all lines, such as those of a scatter plot, the towns of a map or the pips of a die. Each is a ring of
//! dots, with dots inside if it is filled, or, filled, a block of four where rings have no room:
//!
//! ```text
//!   # # #     # # #     # #
//!   # # #     # . #     # #
//!   # # #     # # #
//! ```
//!
//! Those that are alike in a picture are alike on a page: in the larger of two forms if all have room in it, or else in
//! the one in which more of them have.

use std::collections::VecDeque;

use super::lattice::{DotDisc, Lattice, Owner};
use super::{DrawnPoint, Places, PointAlone};
use crate::dots::grid_dot::GridPoint;
use crate::lines::PointMark;

/// A point may be so many steps beside its place where it has no room there.
const BESIDE: [[f32; 2]; 9] =
    [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
/// Ways along the sheet.
const WAYS: [[f32; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
/// From the middle of a block to its dots, in steps.
const OF_BLOCK: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// In what form points are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// A ring of this radius, in steps.
    Ring(i32),
    Block,
}

/// A point in dots.
struct DotSign {
    place: DrawnPoint,
    /// Its ring or block in order, and the dots inside.
    runs: Vec<Vec<GridPoint>>,
}

impl Places<'_> {
    /// Draws numbered points beside all rows but weak ones, where there is room for them.
    pub(super) fn alone(&mut self, mut points: VecDeque<(usize, &PointMark)>) {
        while let Some((number, first)) = points.pop_front() {
            let (alike, others): (VecDeque<_>, VecDeque<_>) =
                points.into_iter().partition(|(_, point)| point.is_like(first));
            points = others;
            let group: Vec<_> = std::iter::once((number, first)).chain(alike).collect();
            self.group(&group);
        }
    }

    /// Draws points that are alike, in the first form for which most of them have room.
    fn group(&mut self, group: &[(usize, &PointMark)]) {
        let radius = group.iter().map(|(_, point)| self.radius(point)).max().unwrap_or(1);
        let smallest = self.smallest_radius();
        let is_filled = group.iter().any(|(_, point)| point.is_filled);
        let forms: &[Form] = match radius > smallest {
            true => &[Form::Ring(radius), Form::Ring(radius - 1)],
            false if is_filled => &[Form::Ring(smallest), Form::Block],
            // a block is felt as a filled one
            false => &[Form::Ring(smallest)],
        };
        let count = |signs: &[Option<DotSign>]| signs.iter().flatten().count();
        let mut best: Vec<Option<DotSign>> = Vec::new();
        for &form in forms {
            let signs = self.signs(group, form);
            if best.is_empty() || count(&signs) > count(&best) {
                best = signs;
            }
            if count(&best) == group.len() {
                break;
            }
        }
        let lattice = self.field.lattice;
        for (&(number, point), sign) in group.iter().zip(best) {
            let Some(DotSign { place, runs }) = sign else { continue };
            self.interrupt_weak(&runs[0], &[]);
            let runs = runs.into_iter().map(|row| row.into_iter().map(|dot| lattice.to_mm(dot)).collect()).collect();
            self.placed.alone.push(PointAlone { runs, strength: point.strength });
            self.placed.shown.points[number] = true;
            self.points.push(place);
        }
    }

    /// The points that have room in this form, one after the other: in their own order, or if some have no room then,
    /// in that along the sheet in which most have.
    fn signs(&self, group: &[(usize, &PointMark)], form: Form) -> Vec<Option<DotSign>> {
        let count = |signs: &[Option<DotSign>]| signs.iter().flatten().count();
        let mut best = self.signs_in_order(group, 0..group.len(), form);
        for way in WAYS {
            if count(&best) == group.len() {
                break;
            }
            let along = |number: &usize| way[0] * group[*number].1.at.x + way[1] * group[*number].1.at.y;
            let mut order: Vec<usize> = (0..group.len()).collect();
            order.sort_by(|a, b| along(a).total_cmp(&along(b)));
            let signs = self.signs_in_order(group, order, form);
            if count(&signs) > count(&best) {
                best = signs;
            }
        }
        best
    }

    fn signs_in_order(
        &self,
        group: &[(usize, &PointMark)],
        order: impl IntoIterator<Item = usize>,
        form: Form,
    ) -> Vec<Option<DotSign>> {
        let mut taken: Vec<DrawnPoint> = Vec::new();
        let mut signs: Vec<Option<DotSign>> = group.iter().map(|_| None).collect();
        for number in order {
            let (_, point) = group[number];
            let at = self.field.lattice.to_steps(point.at);
            let beside = BESIDE.iter().map(|[dx, dy]| sign([at[0] + dx, at[1] + dy], form, point, self.field.lattice));
            let free = beside.into_iter().find(|sign| self.has_room_alone(&sign.runs[0], &taken));
            taken.extend(free.as_ref().map(|sign| sign.place));
            signs[number] = free;
        }
        signs
    }

    /// Whether dots are apart from all points, and from all rows but those that give way.
    fn has_room_alone(&self, dots: &[GridPoint], taken: &[DrawnPoint]) -> bool {
        let lattice = self.field.lattice;
        let stays = |owner: Owner| !matches!(owner, Owner::Row(row, dot) if self.gives_way(row, dot));
        dots.iter().all(|dot| {
            lattice.holds(*dot)
                && !self.near(*dot).any(|(_, owner)| stays(owner))
                && !self.points.iter().chain(taken).any(|other| self.is_close_to(*dot, other))
        })
    }
}

/// A point whose middle is at a place, in steps, or at the dot nearest to it.
fn sign(at: GridPoint, form: Form, point: &PointMark, lattice: Lattice<'_>) -> DotSign {
    match form {
        Form::Ring(radius) => {
            let (middle, DotDisc { around, inside }) = lattice.ring(at, radius);
            let inside = if point.is_filled { inside } else { Vec::new() };
            let runs = [around, inside].into_iter().filter(|row| !row.is_empty()).collect();
            DotSign { place: DrawnPoint { middle, radius: radius as f32 }, runs }
        }
        Form::Block => {
            let corner = match lattice {
                Lattice::Grid { .. } => at.map(f32::floor),
                Lattice::Free { .. } => at.map(|at| at - 0.5),
            };
            let block = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            let dots = block.map(|[dx, dy]| [corner[0] + dx, corner[1] + dy]).to_vec();
            DotSign { place: DrawnPoint { middle: corner.map(|at| at + 0.5), radius: OF_BLOCK }, runs: vec![dots] }
        }
    }
}
