//! What is left of a line that comes too near to others.

use super::field::{Field, Meeting, State};
use super::lead::lead_on;
use super::{Params, saliency};
use crate::lines::trail::{Trail, Vertex};

/// A line that meets another this near to its end, mm, ends there.
const TIP: f32 = 0.01;
/// A line of which less than this share is left in pieces keeps only the first of them, and a ring none: stubs say where
/// something was, not what.
const WHOLE: f32 = 0.5;

/// A line that ends before it is apart from one that it has crossed ends on it instead: the stub beyond is felt as a blot.
/// None if it has no stubs.
pub(super) fn without_stubs(trail: &Trail, field: &Field<'_>) -> Option<Trail> {
    let near = |vertex: Option<&Vertex>| vertex.is_some_and(|vertex| field.may_be_near(vertex.at));
    if trail.closed || !(near(trail.vertices.first()) || near(trail.vertices.last())) {
        return None;
    }
    let places = field.places(&trail.vertices, false);
    let total = places.arcs.last().copied().unwrap_or(0.0);
    // a line that is not yet apart from the other where it ends
    let stub = |meeting: &Meeting, end: f32, tip: Option<&Vertex>| {
        let way = (meeting.arc - end).abs();
        way > TIP && way <= field.longest_stub() && tip.is_some_and(|tip| field.is_near(tip, meeting.line))
    };
    let meetings = || places.meetings.iter();
    let first = meetings().filter(|m| stub(m, 0.0, trail.vertices.first())).max_by(|a, b| a.arc.total_cmp(&b.arc));
    let last = meetings().filter(|m| stub(m, total, trail.vertices.last())).min_by(|a, b| a.arc.total_cmp(&b.arc));
    if first.is_none() && last.is_none() {
        return None;
    }
    let (from, to) = (first.map_or(-1.0, |meeting| meeting.arc), last.map_or(f32::MAX, |meeting| meeting.arc));
    let kept = trail.vertices.iter().zip(&places.arcs).filter(|(_, arc)| (from..to).contains(*arc));
    let mut vertices: Vec<Vertex> = kept.map(|(vertex, _)| *vertex).collect();
    if let (Some(meeting), Some(&next)) = (first, vertices.first()) {
        vertices.insert(0, Vertex { at: meeting.at, ..next });
    }
    if let (Some(meeting), Some(&before)) = (last, vertices.last()) {
        vertices.push(Vertex { at: meeting.at, ..before });
    }
    Some(Trail { vertices, closed: false })
}

/// What is left of a line that is too near to others: its parts between, led on to the lines that they meet.
pub(super) fn pieces(trail: &Trail, states: &[State], field: &Field<'_>, params: &Params) -> Vec<Trail> {
    let ring = trail.closed;
    // of a small ring, which is felt as a dot, no part says anything
    if ring && trail.length() < std::f32::consts::PI * (params.min_gap + params.width_max) {
        return Vec::new();
    }
    let (trail, states) = match states.iter().position(|state| *state == State::TooNear) {
        Some(start) if trail.closed => {
            let ring = states.len() - 1;
            (&opened(trail, start), (0..=ring).map(|k| states[(start + k) % ring]).collect())
        }
        _ => (trail, states.to_vec()),
    };
    let vertices = &trail.vertices;
    let length = trail.length();
    let mut left = Vec::new();
    let mut i = 0;
    // where the stretch begins that is free of others, after the last one that is too near
    let mut kept_from = 0;
    while i <= vertices.len() {
        // the next stretch that is near
        let Some(near) = (i..vertices.len()).find(|&k| states[k] != State::Free) else {
            left.push((kept_from, vertices.len()));
            break;
        };
        let until = (near..vertices.len()).find(|&k| states[k] == State::Free).unwrap_or(vertices.len());
        if states[near..until].contains(&State::TooNear) {
            left.push((kept_from, near));
            kept_from = until;
        }
        i = until;
        if i == vertices.len() {
            left.push((kept_from, i));
            break;
        }
    }
    let mut pieces = Vec::new();
    for (from, until) in left.into_iter().filter(|(from, until)| from < until) {
        let mut piece = vertices[from..until].to_vec();
        if until < vertices.len() {
            let path = &vertices[until..];
            piece.extend(lead_on(&piece, path, true, field, None, params).unwrap_or_default());
        }
        if from > 0 {
            piece.reverse();
            let path: Vec<Vertex> = vertices[..from].iter().rev().copied().collect();
            piece.extend(lead_on(&piece, &path, true, field, None, params).unwrap_or_default());
            piece.reverse();
        }
        let piece = Trail { vertices: piece, closed: false };
        if piece.length() >= params.min_length {
            pieces.push(piece);
        }
    }
    let kept: f32 = pieces.iter().map(Trail::length).sum();
    if kept < WHOLE * length {
        if ring {
            pieces.clear();
        }
        let first = (0..pieces.len())
            .max_by(|&a, &b| saliency(&pieces[a], params).total_cmp(&saliency(&pieces[b], params)).then(b.cmp(&a)));
        pieces = first.map(|first| pieces.swap_remove(first)).into_iter().collect();
    }
    pieces
}

/// A ring cut open at a vertex, which comes at both its ends.
pub(super) fn opened(trail: &Trail, start: usize) -> Trail {
    let ring = trail.vertices.len() - 1;
    Trail { vertices: (0..=ring).map(|k| trail.vertices[(start + k) % ring]).collect(), closed: false }
}
