//! What is left of a line that comes too near to others.

use super::field::{Field, Meeting, State};
use super::lead::lead_on;
use super::{Params, saliency};
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;

/// A line that meets another this near to its end, mm, ends there.
const TIP: f32 = 0.01;
/// A line of which less than this share is left in pieces keeps only the first of them, and a ring none: stubs say where
/// something was, not what.
const WHOLE: f32 = 0.5;

/// A line that ends before it is apart from one that it has crossed ends on it instead: the stub beyond is felt as a blot.
/// None if it has no stubs.
pub(super) fn without_stubs(polyline: &Polyline<Vertex>, field: &Field<'_>) -> Option<Polyline<Vertex>> {
    let near = |vertex: Option<&Vertex>| vertex.is_some_and(|vertex| field.may_be_near(vertex.at));
    if polyline.closed || !(near(polyline.vertices.first()) || near(polyline.vertices.last())) {
        return None;
    }
    let places = field.places(polyline.view());
    let total = places.arcs.last().copied().unwrap_or(0.0);
    // a line that is not yet apart from the other where it ends
    let stub = |meeting: &Meeting, end: f32, tip: Option<&Vertex>| {
        let way = (meeting.arc - end).abs();
        way > TIP && way <= field.longest_stub() && tip.is_some_and(|tip| field.is_near(tip, meeting.line))
    };
    let meetings = || places.meetings.iter();
    let first = meetings().filter(|m| stub(m, 0.0, polyline.vertices.first())).max_by(|a, b| a.arc.total_cmp(&b.arc));
    let last = meetings().filter(|m| stub(m, total, polyline.vertices.last())).min_by(|a, b| a.arc.total_cmp(&b.arc));
    if first.is_none() && last.is_none() {
        return None;
    }
    let (from, to) = (first.map_or(-1.0, |meeting| meeting.arc), last.map_or(f32::MAX, |meeting| meeting.arc));
    let kept = polyline.vertices.iter().zip(&places.arcs).filter(|(_, arc)| (from..to).contains(*arc));
    let mut vertices: Vec<Vertex> = kept.map(|(vertex, _)| *vertex).collect();
    if let (Some(meeting), Some(&next)) = (first, vertices.first()) {
        vertices.insert(0, Vertex { at: meeting.at, ..next });
    }
    if let (Some(meeting), Some(&before)) = (last, vertices.last()) {
        vertices.push(Vertex { at: meeting.at, ..before });
    }
    Some(Polyline::open(vertices))
}

/// What is left of a line that is too near to others: its parts between, led on to the lines that they meet.
pub(super) fn pieces(
    polyline: &Polyline<Vertex>,
    states: &[State],
    field: &Field<'_>,
    params: &Params,
) -> Vec<Polyline<Vertex>> {
    let ring = polyline.closed;
    // of a small ring, which is felt as a dot, no part says anything
    if ring && polyline.length() < std::f32::consts::PI * (params.min_gap + params.width_max) {
        return Vec::new();
    }
    let (polyline, states) = match states.iter().position(|state| *state == State::TooNear) {
        Some(start) if polyline.closed => {
            let count = states.len();
            (&polyline.opened_at(start), (0..=count).map(|k| states[(start + k) % count]).collect())
        }
        _ => (polyline, states.to_vec()),
    };
    let vertices = &polyline.vertices;
    let length = polyline.length();
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
        let piece = Polyline::open(piece);
        if piece.length() >= params.min_length {
            pieces.push(piece);
        }
    }
    let kept: f32 = pieces.iter().map(Polyline::length).sum();
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
