//! What is left of a line that comes too near to others.

use std::ops::Range;

use super::branch::{branch, near_branch};
use super::drawn::{DrawnLines, LineState};
use super::extend::{Extended, extension};
use super::passage::{Junction, Passage};
use crate::geom::polyline::Polyline;
use crate::lines::links;
use crate::lines::params::Params;
use crate::lines::saliency::saliency;
use crate::lines::vertex::{FoundIn, Vertex};

/// A line that joins another this near to its end, mm, ends there.
const TIP: f32 = 0.01;
/// A line of which less than this share is left in pieces keeps only the first of them, and a ring none: stubs say
/// where something was, not what.
const WHOLE: f32 = 0.5;
/// The same of a line of a vector drawing: every one is meant, and what is left of a petal is still a petal.
const WHOLE_EXACT: f32 = 0.25;
/// A piece of so many least lengths is no stub: it is longer than a fingertip is broad. (With three a glass on a burner
/// lost one of the two walls above its water, of 21 mm.)
const LONG: f32 = 2.0;

/// A line that ends before it is apart from one that it has crossed ends on it instead: the stub beyond is felt as a
/// blot. None if it has no stubs.
pub(super) fn without_stubs(
    polyline: &Polyline<Vertex>,
    passage: &Passage,
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    let near = |vertex: Option<&Vertex>| vertex.is_some_and(|vertex| drawn.may_be_near(vertex.at));
    if polyline.closed || !(near(polyline.vertices.first()) || near(polyline.vertices.last())) {
        return None;
    }
    let total = passage.arcs.last().copied().unwrap_or(0.0);
    // a line that is not yet apart from the other where it ends
    let stub = |junction: &Junction, end: f32, tip: Option<&Vertex>| {
        let to_end = (junction.arc - end).abs();
        to_end > TIP && to_end <= drawn.params.max_stub() && tip.is_some_and(|tip| drawn.is_near(tip, junction.line))
    };
    let junctions = || passage.junctions.iter();
    let first = junctions().filter(|m| stub(m, 0.0, polyline.vertices.first())).max_by(|a, b| a.arc.total_cmp(&b.arc));
    let last = junctions().filter(|m| stub(m, total, polyline.vertices.last())).min_by(|a, b| a.arc.total_cmp(&b.arc));
    let is_tick = match (first, last) {
        (None, None) => return None,
        (Some(first), Some(last)) => first.line == last.line && (first.arc - last.arc).abs() < TIP,
        (Some(_), None) | (None, Some(_)) => false,
    };
    // a tick across an axis is nothing but two stubs, and in a drawing it is meant
    if is_tick && drawn.params.of_drawing {
        return None;
    }
    let (from, to) = (first.map_or(-1.0, |junction| junction.arc), last.map_or(f32::MAX, |junction| junction.arc));
    let kept = polyline.vertices.iter().zip(&passage.arcs).filter(|(_, arc)| (from..to).contains(*arc));
    let mut vertices: Vec<Vertex> = kept.map(|(vertex, _)| *vertex).collect();
    if let (Some(junction), Some(&next)) = (first, vertices.first()) {
        vertices.insert(0, Vertex { at: junction.at, ..next });
    }
    if let (Some(junction), Some(&before)) = (last, vertices.last()) {
        vertices.push(Vertex { at: junction.at, ..before });
    }
    let mut shorter = Polyline::open(vertices);
    // put back on the place where it was, it would be shortened for ever
    drawn.snap(&mut shorter);
    (shorter.length() + TIP < polyline.length()).then_some(shorter)
}

/// How the parts of a line end that was split.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PartEnds {
    /// With segments to the lines that they join.
    Extended,
    /// Where they are free.
    AsCut,
}

/// What is left of a line that is too near to others: its parts between.
pub(super) fn split(
    polyline: &Polyline<Vertex>,
    states: &[LineState],
    ends: PartEnds,
    drawn: &DrawnLines<'_>,
) -> Vec<Polyline<Vertex>> {
    let params = drawn.params;
    let length = polyline.length();
    // of a small ring, which is felt as a dot, no part says anything
    if polyline.closed && params.is_dot(length) {
        return Vec::new();
    }
    let (open, open_states) = match states.iter().position(|state| *state == LineState::TooNear) {
        Some(start) if polyline.closed => {
            let count = states.len();
            (polyline.opened_at(start), (0..=count).map(|k| states[(start + k) % count]).collect())
        }
        _ => (polyline.clone(), states.to_vec()),
    };
    let is_exact = polyline.vertices.iter().all(|vertex| vertex.source.is_exact());
    let least = if is_exact { WHOLE_EXACT } else { WHOLE } * length;
    let kept = |pieces: &[Polyline<Vertex>]| pieces.iter().map(Polyline::length).sum::<f32>();
    let coarse = pieces(&open.vertices, clear_stretches(&open_states), ends, drawn);
    if kept(&coarse) < WHOLE * length
        && let Some(branch) = branch(polyline, states, drawn)
    {
        return vec![branch];
    }
    if ends == PartEnds::Extended
        && loses_end(polyline, &coarse, drawn)
        && let Some(branch) = near_branch(polyline, states, drawn)
        && !drawn.states(&branch).contains(&LineState::TooNear)
    {
        return vec![branch];
    }
    if kept(&coarse) >= least {
        return coarse;
    }
    // a stroke on which many lines end, as bars on an axis, is nowhere free; what is left is judged once more
    let in_stroke = polyline.vertices.iter().filter(|vertex| vertex.is_in_stroke()).count();
    let fine = match 2 * in_stroke > polyline.vertices.len() {
        true => pieces(&open.vertices, apart_stretches(&open_states), ends, drawn),
        false => Vec::new(),
    };
    if kept(&fine) >= least && !fine.is_empty() {
        fine
    } else if polyline.closed {
        Vec::new()
    } else {
        telling(coarse, is_exact, params)
    }
}

/// Whether an end of a line on paper lies on another one, and that of its `pieces` on none, so that fingers find
/// nothing there. Thin, pale lines give way to all others.
fn loses_end(line: &Polyline<Vertex>, pieces: &[Polyline<Vertex>], drawn: &DrawnLines<'_>) -> bool {
    let is_joined = |end: Option<&Vertex>| end.is_some_and(|end| drawn.is_on_line(end.at));
    let lost = |own: Option<&Vertex>, left: Option<&Vertex>| is_joined(own) && !is_joined(left);
    let is_faint = || line.vertices.iter().any(|vertex| vertex.source == FoundIn::FaintStroke);
    let may_lose = !line.closed && !drawn.params.on_dots() && !is_faint();
    may_lose
        && (lost(line.vertices.first(), pieces.first().and_then(|piece| piece.vertices.first()))
            || lost(line.vertices.last(), pieces.last().and_then(|piece| piece.vertices.last())))
}

/// The parts of an open line that are long enough.
fn pieces(
    vertices: &[Vertex],
    stretches: Vec<Range<usize>>,
    ends: PartEnds,
    drawn: &DrawnLines<'_>,
) -> Vec<Polyline<Vertex>> {
    let mut pieces = Vec::new();
    for Range { start, end } in stretches {
        let mut piece = vertices[start..end].to_vec();
        if ends == PartEnds::Extended && end < vertices.len() {
            piece.extend(extension(&piece, &vertices[end..], Extended::Piece, drawn).unwrap_or_default());
        }
        if ends == PartEnds::Extended && start > 0 {
            piece.reverse();
            let path: Vec<Vertex> = vertices[..start].iter().rev().copied().collect();
            piece.extend(extension(&piece, &path, Extended::Piece, drawn).unwrap_or_default());
            piece.reverse();
        }
        let piece = Polyline::open(piece);
        let is_link = || links::is_piece(&piece, drawn.params, |end| drawn.is_on_line(end));
        if piece.length() >= drawn.params.min_length || is_link() {
            pieces.push(piece);
        }
    }
    pieces
}

/// The stretches of vertices between those that are too near to lines.
fn apart_stretches(states: &[LineState]) -> Vec<Range<usize>> {
    let mut stretches = Vec::new();
    let mut at = 0;
    for alike in states.chunk_by(|a, b| (*a == LineState::TooNear) == (*b == LineState::TooNear)) {
        if !alike.contains(&LineState::TooNear) {
            stretches.push(at..at + alike.len());
        }
        at += alike.len();
    }
    stretches
}

/// The stretches of vertices between those that are near to lines so that some are too near. A stretch that
/// is near, but nowhere too near, divides nothing.
fn clear_stretches(states: &[LineState]) -> Vec<Range<usize>> {
    let mut stretches = Vec::new();
    let (mut start, mut at) = (0, 0);
    for near in states.chunk_by(|a, b| (*a == LineState::Free) == (*b == LineState::Free)) {
        let end = at + near.len();
        if near.contains(&LineState::TooNear) {
            stretches.push(start..at);
            start = end;
        }
        at = end;
    }
    stretches.push(start..at);
    stretches.retain(|stretch| !stretch.is_empty());
    stretches
}

/// Of pieces of a line of which little is left, the most salient, of equal ones the first; of an exact line also those
/// that are long by themselves, as the walls of a glass above what is in it.
fn telling(mut pieces: Vec<Polyline<Vertex>>, is_exact: bool, params: &Params) -> Vec<Polyline<Vertex>> {
    let of = |piece: usize| saliency(&pieces[piece], params);
    let first = (0..pieces.len()).max_by(|&a, &b| of(a).total_cmp(&of(b)).then(b.cmp(&a)));
    let mut number = 0;
    pieces.retain(|piece| {
        number += 1;
        Some(number - 1) == first || is_exact && piece.length() >= LONG * params.min_length
    });
    pieces
}

#[cfg(test)]
mod tests;
