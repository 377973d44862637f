//! Lines of the faint strokes of a vector drawing: as thin as lines can be, they give way to all others.

use super::clearance::Cleared;
use super::line::Line;
use super::outlines::Rank;
use super::params::{Params, RING_FARTHEST};
use super::vertex::{FoundIn, Vertex};
use crate::geom::gridlines::{straight_ends, which_are_gridlines, without_treads};
use crate::geom::polyline::Polyline;
use crate::units::MmPoint;

/// What is left of a faint line between two cuts and is shorter than so many least lengths is left out: it says
/// nothing, and is felt as something.
const SCRAP: f32 = 1.5;

/// A finished line is weak up to this share of the strength of the strongest. Chosen by us.
const WEAK: f32 = 0.1;
/// What rounding may add to the least strength.
const ROUNDED_UP: f32 = 1.001;

/// Which finished lines of a figure are weak, among them those that were drawn as faint strokes, which have the least
/// strength that contours must have.
pub fn which_are_weak(lines: &[Line], least_strength: f32) -> Vec<bool> {
    let strongest = lines.iter().map(|line| line.strength).fold(0.0, f32::max);
    let most = (WEAK * strongest).max(ROUNDED_UP * least_strength);
    lines.iter().map(|line| line.strength <= most).collect()
}

/// Makes a line faint.
pub(super) fn weaken(mut line: Polyline<Vertex>, params: &Params) -> Polyline<Vertex> {
    for vertex in &mut line.vertices {
        vertex.strength = vertex.strength.min(params.least_strength);
        vertex.source = FoundIn::FaintStroke;
    }
    line
}

/// Whether a line is faint.
pub(super) fn is_faint(line: &Polyline<Vertex>) -> bool {
    let faint = line.vertices.iter().filter(|vertex| vertex.source == FoundIn::FaintStroke).count();
    2 * faint > line.vertices.len()
}

/// Takes gridlines out, faint straight lines, and says how many these are. In an overview nobody could tell
/// them from the shapes before them, as its lines are of one width.
pub(super) fn take_gridlines(lines: &mut Vec<Polyline<Vertex>>) -> usize {
    let ends = |line: &Polyline<Vertex>| straight_ends(line.view()).filter(|_| is_faint(line));
    let ends: Vec<_> = lines.iter().map(ends).collect();
    let mut found = which_are_gridlines(&ends);
    let points: Vec<Vec<MmPoint>> = lines.iter().map(|line| line.path().map(|vertex| vertex.at).collect()).collect();
    without_treads(&mut found, &ends, &points);
    let mut are_gridlines = found.into_iter();
    let before = lines.len();
    lines.retain(|_| !are_gridlines.next().unwrap_or(false));
    before - lines.len()
}

/// Leaves out short pieces of faint lines that were cut.
pub(super) fn drop_short_faint(cleared: &mut Vec<Cleared>, lines: &[(Polyline<Vertex>, Rank)], params: &Params) {
    let faint = lines.iter().filter(|(line, rank)| *rank == Rank::Faint && !line.closed);
    let ends: Vec<MmPoint> =
        faint.flat_map(|(line, _)| [line.vertices.first(), line.vertices.last()]).flatten().map(|end| end.at).collect();
    let is_whole_there = |at: MmPoint| ends.iter().any(|end| (*end - at).length() <= 2.0 * RING_FARTHEST);
    cleared.retain(|Cleared { polyline, rank, .. }| {
        let mut own = [polyline.vertices.first(), polyline.vertices.last()].into_iter().flatten();
        *rank != Rank::Faint || polyline.length() >= SCRAP * params.min_length || own.all(|end| is_whole_there(end.at))
    });
}

#[cfg(test)]
mod tests;
