//! Removal of small components: a few dots that stand apart are no texture, a dot alone has no direction, and a
//! single row of dots is felt as a line.

use crate::geom::components;
use crate::textures::{Sign, unit};
use crate::units::{MmPoint, MmVector};

/// Fewer dots than this together are no texture: two rows of three.
const LEAST_GROUP: usize = 6;
/// Fewer dots than this in a row have no direction.
const LEAST_ROW: usize = 2;
/// Two rows lie further apart than this, in pitches; the two halves of a thick row lie nearer.
const ONE_ROW: f32 = 1.5;

/// Distances of the dots of one texture, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spacing {
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
pub(super) fn leave_out(dots: &mut Vec<MmPoint>, sign: Sign, spacing: Spacing) {
    let pitch = spacing.pitch;
    if let Sign::Rhombus { degrees } = sign {
        let (along, across) = (unit(degrees), unit(degrees + 90.0));
        let in_row =
            |step: MmVector| step.dot(across).abs() <= spacing.off && step.dot(along).abs() <= 1.01 * spacing.along;
        keep(dots, 1.1 * spacing.along, in_row, |row| row.len() >= LEAST_ROW);
    }
    let across: &[f32] = match sign {
        Sign::Rhombus { degrees } => &[degrees + 90.0],
        Sign::Dot => &[0.0, 90.0],
    };
    let is_wide = |group: &[MmPoint]| {
        across.iter().all(|degrees| {
            let axis = unit(*degrees);
            let positions = group.iter().map(|at| at.to_vector().dot(axis));
            let (low, high) = positions.fold((f32::MAX, f32::MIN), |(low, high), at| (low.min(at), high.max(at)));
            high - low >= ONE_ROW * pitch
        })
    };
    let reach = 1.01 * spacing.along.max(spacing.across);
    let is_near = |step: MmVector| step.length() <= reach;
    keep(dots, reach, is_near, |group| group.len() >= LEAST_GROUP && is_wide(group));
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
