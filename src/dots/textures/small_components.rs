//! Removal of small components: a few dots that stand apart are no texture, a dot alone has no direction, and a
//! single row of dots is felt as a line.

use crate::geom::components;
use crate::textures::{Sign, unit};
use crate::units::{MmPoint, MmVector};

/// Two rows lie further apart than this, in pitches; the two halves of a thick row lie nearer.
const ONE_ROW: f32 = 1.5;

/// The least that is a texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Least {
    /// Rows beside one another.
    pub rows: usize,
    /// Dots in a row; fewer are left out.
    pub row: usize,
    /// Dots together.
    pub dots: usize,
}

impl Least {
    /// So many rows: on embossers two rows of three, of which two dots are enough to show a direction. Each row more
    /// asks for rows that are longer by two dots: where three rows are wanted, since a single row feels like a line,
    /// short rows do so too.
    pub fn of_rows(rows: usize) -> Self {
        let rows = rows.max(2);
        let row = 2 * (rows - 1);
        Self { rows, row, dots: rows * row.max(3) }
    }
}

/// Distances of the dots of one texture, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct LatticeSpacing {
    /// The pitch.
    pub(super) pitch: f32,
    /// In a row, at most.
    pub(super) along: f32,
    /// Off the middle of a row, from one dot to the next, at most.
    pub(super) off: f32,
    /// From a row or a dot to the next one of the sparsest texture, at most.
    pub(super) across: f32,
}

/// Leaves out dots alone in their row, and then components that are no texture: of few dots, or all in one row.
pub(super) fn leave_out(dots: &mut Vec<MmPoint>, sign: Sign, spacing: LatticeSpacing, least: Least) {
    let pitch = spacing.pitch;
    if let Sign::Rhombus { degrees } = sign {
        let (along, across) = (unit(degrees), unit(degrees + 90.0));
        let in_row =
            |step: MmVector| step.dot(across).abs() <= spacing.off && step.dot(along).abs() <= 1.01 * spacing.along;
        keep(dots, 1.1 * spacing.along, in_row, |row| row.len() >= least.row);
    }
    let across: &[f32] = match sign {
        Sign::Rhombus { degrees } => &[degrees + 90.0],
        Sign::Dot => &[0.0, 90.0],
    };
    let rows = |group: &[MmPoint], degrees: f32| {
        let axis = unit(degrees);
        let mut positions: Vec<f32> = group.iter().map(|at| at.to_vector().dot(axis)).collect();
        positions.sort_by(f32::total_cmp);
        let mut last = f32::NEG_INFINITY;
        let begin_rows = positions.into_iter().filter(|&position| {
            let begins = position - last >= ONE_ROW * pitch;
            if begins {
                last = position;
            }
            begins
        });
        begin_rows.count()
    };
    let is_wide = |group: &[MmPoint]| across.iter().all(|degrees| rows(group, *degrees) >= least.rows);
    let reach = 1.01 * spacing.along.max(spacing.across);
    let is_near = |step: MmVector| step.length() <= reach;
    keep(dots, reach, is_near, |group| group.len() >= least.dots && is_wide(group));
}

/// Keeps the components that `stays` accepts. Two dots are linked if they are no more than `reach` apart and `belong`
/// accepts the vector between them.
fn keep(dots: &mut Vec<MmPoint>, reach: f32, belong: impl Fn(MmVector) -> bool, stays: impl Fn(&[MmPoint]) -> bool) {
    let groups = components::of_points(dots, reach, belong);
    components::retain(dots, &groups, |dots, group| {
        let dots: Vec<MmPoint> = group.iter().map(|&dot| dots[dot]).collect();
        stays(&dots)
    });
}
