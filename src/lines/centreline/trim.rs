//! What is left of a polyline when it is known which of its vertices go to the middle of a stroke and which are
//! removed.
//!
//! ```text
//!   ,---------------------.
//!   |                     |      ->      -----------------------     as long as the stroke, without hooks
//!   `---------------------'
//! ```

use super::assign::Assignment;
use crate::geom::polyline::{Polyline, smooth};
use crate::geom::walk::runs;
use crate::lines::junction;
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmVector};

/// A line moves over to the middle of a stroke within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;
/// The longest blunt end, in clearances: the stroke's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// The direction of a centreline is taken over this much of it, mm.
const HEADING: f32 = 3.0;

/// Moves a polyline over to the middle where it is the side of a stroke, and cuts out what is removed. Where a cut
/// follows closely on the end of a stroke, what lies between is the stroke's blunt end: the centreline goes straight on
/// as far as that reaches instead of hooking round it.
pub(super) fn trim(polyline: &Polyline<Vertex>, assignment: &Assignment, reach: f32, out: &mut Vec<Polyline<Vertex>>) {
    let count = polyline.vertices.len();
    if !assignment.removed.contains(&true) {
        let indices: Vec<usize> = (0..count).collect();
        out.push(shifted(polyline, assignment, &indices, polyline.closed));
        return;
    }
    let removed = &assignment.removed;
    for piece in runs(count, polyline.closed, |a, b| removed[a] == removed[b]) {
        let (first, last) = (piece[0], piece[piece.len() - 1]);
        if removed[first] {
            continue;
        }
        let (cut_before, cut_after) = (polyline.closed || first > 0, polyline.closed || last + 1 < count);
        let from = if cut_before { blunt_end(polyline, assignment, reach, piece.iter()) } else { 0 };
        let after = if cut_after { blunt_end(polyline, assignment, reach, piece.iter().rev()) } else { 0 };
        let until = piece.len() - after;
        if from < until {
            let mut vertices = shifted(polyline, assignment, &piece[from..until], false).vertices;
            extend_to_the_end(&mut vertices, polyline, &piece[until..]);
            vertices.reverse();
            extend_to_the_end(&mut vertices, polyline, &piece[..from]);
            vertices.reverse();
            out.push(Polyline::open(vertices));
        }
    }
}

/// The vertices with these numbers, moved over smoothly.
fn shifted(polyline: &Polyline<Vertex>, assignment: &Assignment, indices: &[usize], closed: bool) -> Polyline<Vertex> {
    let mut part = Polyline { vertices: indices.iter().map(|&i| polyline.vertices[i]).collect(), closed };
    if indices.iter().all(|&i| assignment.offsets[i].is_none()) {
        return part;
    }
    let shift = |k: usize| assignment.offsets[indices[k]].map_or([0.0, 0.0], |v| [v.x, v.y]);
    let smoothed = smooth(&part.arc_lengths(), closed, TRANSITION, shift);
    for ((vertex, [x, y]), &i) in part.vertices.iter_mut().zip(smoothed).zip(indices) {
        vertex.at += MmVector::new(x, y);
        // The middle has the same colour on both sides, so it goes on from either side of the stroke.
        if assignment.offsets[i].is_some() {
            vertex.contrast = [0.0; 3];
        }
    }
    part
}

/// How many vertices, from a cut on, belong to the blunt end of the stroke that follows; 0 if none follows within
/// `reach`.
fn blunt_end<'a>(
    polyline: &Polyline<Vertex>,
    assignment: &Assignment,
    reach: f32,
    piece: impl Iterator<Item = &'a usize>,
) -> usize {
    let mut way = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = polyline.vertices[i].at;
        way += last.map_or(0.0, |last| (at - last).length());
        if assignment.offsets[i].is_some() {
            return count;
        }
        if way > BLUNT * reach {
            break;
        }
        last = Some(at);
    }
    0
}

/// Extends a centreline straight as far as the blunt end of its stroke reaches.
fn extend_to_the_end(vertices: &mut Vec<Vertex>, polyline: &Polyline<Vertex>, blunt: &[usize]) {
    let Some(tip) = vertices.last().copied() else { return };
    let inner = vertices.iter().rev().find(|vertex| (vertex.at - tip.at).length() >= HEADING).or(vertices.first());
    let Some(heading) = inner.and_then(|inner| (tip.at - inner.at).try_normalize()) else { return };
    let reaches = blunt.iter().map(|&i| (polyline.vertices[i].at - tip.at).dot(heading)).fold(0.0, f32::max);
    if reaches > 0.0 {
        vertices.extend(junction::straight(&tip, tip.at + heading * reaches));
    }
}
