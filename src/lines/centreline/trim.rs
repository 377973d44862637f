//! What is left of a polyline when it is known which of its vertices go to the middle of a stroke and which are
//! removed.
//!
//! ```text
//!   ,---------------------.
//!   |                     |      ->      -----------------------     as long as the stroke, without hooks
//!   `---------------------'
//! ```

use std::collections::HashSet;

use super::assign::Assignment;
use crate::geom::polyline::{Polyline, smooth};
use crate::geom::walk::runs;
use crate::geom::{crossing, right_of};
use crate::lines::lead_on;
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmVector};

/// A line moves over to the middle of a stroke within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;
/// The longest blunt end, in clearances: the stroke's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// A gap between two stretches of a side is a corner if it is at most so many widths of the stroke long: at an angle of
/// 60 degrees the outer side has none opposite for 3.5 widths.
const CORNER: f32 = 4.0;
/// Such a gap is a corner only if the line turns there by at least 30 degrees: cosine.
const TURN: f32 = 0.866;
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

/// The vertices with these numbers, moved over smoothly, each at right angles to the line.
fn shifted(polyline: &Polyline<Vertex>, assignment: &Assignment, indices: &[usize], closed: bool) -> Polyline<Vertex> {
    let mut part = Polyline { vertices: indices.iter().map(|&i| polyline.vertices[i]).collect(), closed };
    if indices.iter().all(|&i| assignment.offsets[i].is_none()) {
        return part;
    }
    let tangents = (0..indices.len()).map(|k| part.tangent(k));
    let normals: Vec<MmVector> = tangents.map(right_of).collect();
    let distance = |(&i, normal): (&usize, &MmVector)| {
        assignment.offsets[i].map(|offset| offset.length().copysign(offset.dot(*normal)))
    };
    let mut distances: Vec<Option<f32>> = indices.iter().zip(&normals).map(distance).collect();
    let arcs = part.arc_lengths();
    let gaps = fill_corners(&mut distances, &normals, &arcs, closed);
    let smoothed = smooth(&arcs, closed, TRANSITION, |k| [distances[k].unwrap_or(0.0)]);
    for (((vertex, [distance]), normal), own) in part.vertices.iter_mut().zip(smoothed).zip(normals).zip(&distances) {
        vertex.at += normal * distance;
        // The middle has the same colour on both sides, so it goes on from either side of the stroke.
        if let Some(own) = own {
            (vertex.contrast, vertex.bar) = ([0.0; 3], 2.0 * own.abs());
        }
    }
    let looped: HashSet<usize> = gaps.iter().flat_map(|gap| cut_loop(&mut part, gap)).collect();
    let left = (0..).zip(&part.vertices).filter(|(k, _)| !looped.contains(k));
    Polyline { vertices: left.map(|(_, vertex)| *vertex).collect(), closed }
}

/// A run of vertices at a corner, where the outer side of a stroke has no opposite, and so many before and after it.
struct Gap {
    run: Vec<usize>,
    beside: usize,
}

/// Gives the vertices of a corner between two stretches the distance to the middle that lies between those of their
/// neighbours: its outer side has no opposite, and the line would go out to its tip.
fn fill_corners(distances: &mut [Option<f32>], normals: &[MmVector], arcs: &[f32], closed: bool) -> Vec<Gap> {
    let total = arcs.last().copied().unwrap_or(0.0);
    let runs = runs(distances.len(), closed, |a, b| distances[a].is_some() == distances[b].is_some());
    let mut gaps = Vec::new();
    for (place, run) in runs.iter().enumerate() {
        let over_seam = |neighbour| if closed { neighbour } else { None };
        let before = if place > 0 { runs.get(place - 1) } else { over_seam(runs.last()) };
        let after = runs.get(place + 1).or(over_seam(runs.first()));
        let (Some(before), Some(after)) = (before.and_then(|run| run.last().copied()), after.map(|run| run[0])) else {
            continue;
        };
        let (None, Some(first), Some(last)) = (distances[run[0]], distances[before], distances[after]) else {
            continue;
        };
        let arc = |to: usize| (arcs[to] - arcs[before]).rem_euclid(total.max(f32::EPSILON));
        let (length, width) = (arc(after), first.abs() + last.abs());
        let turns = normals[before].dot(normals[after]) <= TURN;
        // what has no length is no corner
        if turns && first.signum() == last.signum() && length > 0.0 && length <= CORNER * width {
            for &k in run {
                distances[k] = Some(first + (last - first) * arc(k) / length);
            }
            let beside = ((width * run.len() as f32 / length).ceil() as usize).min(distances.len());
            gaps.push(Gap { run: run.clone(), beside });
        }
    }
    gaps
}

/// Cuts off the loop that a line makes on the inner side of a corner when both its legs move there: moves one of its
/// vertices to where they cross, and returns those that go.
fn cut_loop(part: &mut Polyline<Vertex>, Gap { run, beside }: &Gap) -> Vec<usize> {
    let ahead = part.view();
    let back = |steps: usize| ahead.next(run[0], -(steps as isize));
    let Some(first) = (0..=*beside).rev().find_map(back) else { return Vec::new() };
    let most = (run.len() + 2 * beside).min(part.vertices.len());
    let these: Vec<usize> = (0..most as isize).map_while(|step| ahead.next(first, step)).collect();
    let segment = |k: usize| (part.vertices[these[k]].at, part.vertices[these[k + 1]].at);
    let last = these.len().saturating_sub(1);
    let crossed = (0..last)
        .find_map(|i| (i + 2..last).rev().find_map(|j| crossing(segment(i), segment(j)).map(|place| (i, j, place))));
    let Some((i, j, place)) = crossed else { return Vec::new() };
    part.vertices[these[i + 1]].at = place;
    these[i + 2..=j].to_vec()
}

/// How many vertices, from a cut on, belong to the blunt end of the stroke that follows; 0 if none follows within
/// `reach`.
fn blunt_end<'a>(
    polyline: &Polyline<Vertex>,
    assignment: &Assignment,
    reach: f32,
    piece: impl Iterator<Item = &'a usize>,
) -> usize {
    let mut length = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = polyline.vertices[i].at;
        length += last.map_or(0.0, |last| (at - last).length());
        if assignment.offsets[i].is_some() {
            return count;
        }
        if length > BLUNT * reach {
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
        vertices.extend(lead_on::straight(&tip, tip.at + heading * reaches));
    }
}

#[cfg(test)]
mod tests;
