//! Lines that join a third one at nearly one place, as petals the middle of a flower.

use crate::units::{MmPoint, MmVector};

/// The greatest cosine of two directions of lines that do not run beside one another: 36 degrees, as
/// [`crate::lines::params::Params::cluster_approach`] has it.
pub(crate) const APART: f32 = 0.809;

/// A polyline joins a line where that joins a third one, or so near to that place that fingers feel one meeting of all
/// three. One of the polyline and the third line ends there. Only of drawings.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cluster {
    /// How far along the polyline its junction is, mm.
    pub(super) arc: f32,
    /// Whether it ends there.
    pub(super) ends: bool,
    /// Number of the third line.
    pub(super) line: u32,
    /// How far along that its junction is, mm.
    pub(super) line_arc: f32,
    /// Whether that ends there.
    pub(super) line_ends: bool,
    /// How far the two junctions are apart, along the line between, mm.
    pub(super) apart: f32,
}

/// Where a line joins the third one of a cluster.
#[derive(Clone, Copy)]
pub(super) struct AtThird<'a> {
    pub(super) path: &'a Path,
    pub(super) closed: bool,
    /// How far along the line, mm.
    pub(super) arc: f32,
    /// Whether the line ends there.
    pub(super) ends: bool,
}

/// Whether two lines that join a third one, `apart` mm along it from one another, make a cluster: they join it within
/// `spacing`, one of them ends there, and over that length they do not run beside one another.
pub(super) fn meet(one: AtThird<'_>, other: AtThird<'_>, apart: f32, spacing: f32) -> bool {
    let ways = |line: AtThird<'_>| leaves(line.path, line.closed, line.arc, spacing);
    apart <= spacing && (one.ends || other.ends) && are_apart(ways(one), ways(other))
}

/// A path with the arc length at each vertex, mm; of a closed one the first vertex comes again at the end.
pub(super) type Path = [(f32, MmPoint)];

/// The directions in which a path leaves a place of it, from there to `span` mm farther along, or to its end; none
/// where it ends.
fn leaves(path: &Path, closed: bool, arc: f32, span: f32) -> [Option<MmVector>; 2] {
    let length = path.last().map_or(0.0, |(arc, _)| *arc);
    [arc + span, arc - span].map(|to| {
        let to = if closed { to.rem_euclid(length) } else { to.clamp(0.0, length) };
        (place(path, to)? - place(path, arc)?).try_normalize()
    })
}

/// Whether no two of these directions are those of lines beside one another.
fn are_apart(one: [Option<MmVector>; 2], other: [Option<MmVector>; 2]) -> bool {
    let of_other = || other.iter().flatten();
    one.iter().flatten().all(|way| of_other().all(|with| way.dot(*with) <= APART))
}

/// The place of a path at an arc.
fn place(path: &Path, arc: f32) -> Option<MmPoint> {
    let next = path.partition_point(|(at, _)| *at < arc).clamp(1, path.len().max(2) - 1);
    let (&(from, a), &(to, b)) = path.get(next - 1).zip(path.get(next))?;
    Some(a.lerp(b, ((arc - from) / (to - from).max(f32::EPSILON)).clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests;
