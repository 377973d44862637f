//! No two lines nearer than fingers can part them: of two rivals the more salient stays, the other is trimmed where it
//! comes too near. Lines that truly join may meet.

mod field;
mod lead;
mod nudge;
mod own;
mod pieces;
mod pin;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

pub(super) use nudge::RING_FARTHEST;

use self::field::{Field, State, TOUCH};
use self::lead::lead_on;
use self::own::returns;
use self::pieces::{pieces, without_stubs};
use super::saliency::saliency;
use super::vertex::Vertex;
use super::{Params, meet, weight};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// A piece that is still too near after this many cuts is given up. None of the samples needs more than three.
const MOST_CUTS: u8 = 8;

/// A line that is drawn.
pub(super) struct Cleared {
    pub(super) polyline: Polyline<Vertex>,
    pub(super) saliency: f32,
    /// For each vertex whether another line ends there.
    pub(super) pinned: Vec<bool>,
}

struct Candidate {
    saliency: f32,
    number: usize,
    cuts: u8,
    polyline: Polyline<Vertex>,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.saliency.total_cmp(&other.saliency).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

/// Lines that wait for their turn.
struct Queue<'a> {
    heap: BinaryHeap<Candidate>,
    count: usize,
    params: &'a Params,
}

impl Queue<'_> {
    fn push(&mut self, polyline: Polyline<Vertex>, cuts: u8) {
        if polyline.vertices.len() < 2 || polyline.length() < self.params.min_length || cuts > MOST_CUTS {
            return;
        }
        let saliency = saliency(&polyline, self.params);
        self.heap.push(Candidate { saliency, number: self.count, cuts, polyline });
        self.count += 1;
    }
}

/// Clears lines, the one that says most first; the result is in that order.
pub(super) fn clear(polylines: Vec<Polyline<Vertex>>, area: MmRect, params: &Params) -> Vec<Cleared> {
    let mut queue = Queue { heap: BinaryHeap::with_capacity(polylines.len()), count: 0, params };
    // Where a line comes near itself its earlier part stays.
    polylines.into_iter().for_each(|polyline| queue.push(polyline.stronger_half_first(), 0));
    let mut field = Field::new(area, params);
    let mut own = Nearby::new(area, params.min_gap + params.width_max);
    let mut cleared: Vec<Cleared> = Vec::new();
    while let Some(Candidate { cuts, mut polyline, .. }) = queue.heap.pop() {
        if let Some(shorter) = without_stubs(&polyline, &field) {
            queue.push(shorter, cuts + 1);
            continue;
        }
        let near = states(&polyline, &field);
        if near.contains(&State::TooNear) {
            if let Some(aside) = nudge::nudged(&polyline, &field) {
                queue.push(aside, cuts + 1);
                continue;
            }
            pieces(&polyline, &near, &field, params).into_iter().for_each(|piece| queue.push(piece, cuts + 1));
            continue;
        }
        let mut rest = None;
        if let Some(back) = returns(&polyline, &field, &mut own) {
            if polyline.closed {
                // begun after the stretch that is too near, it comes last
                let mut open = polyline.opened_at(back.end % polyline.vertices.len());
                open.vertices.pop();
                queue.push(open, cuts + 1);
                continue;
            }
            let mut path = polyline.vertices.split_off(back.start);
            // an end that lay on the line itself, and made what is near it a junction, may be gone
            while let Some(back) = returns(&polyline, &field, &mut own) {
                path.splice(0..0, polyline.vertices.split_off(back.start));
            }
            // What was joined to a line by a meeting beyond the cut is so no longer.
            if polyline.length() < params.min_length || states(&polyline, &field).contains(&State::TooNear) {
                queue.push(polyline, cuts + 1);
                queue.push(Polyline::open(path), cuts + 1);
                continue;
            }
            rest = Some(path);
        }
        snap(&mut polyline, &field);
        let line = field.begin(&polyline);
        if let Some(path) = rest {
            let body = polyline.vertices.len();
            if let Some(on) = lead_on(&polyline.vertices, &path, false, &field, Some(line), params) {
                polyline.vertices.extend(on);
                if returns(&polyline, &field, &mut own).is_none() {
                    field.go_on(&polyline, body - 1, line);
                } else {
                    polyline.vertices.truncate(body);
                }
            }
            queue.push(Polyline::open(path), cuts + 1);
        }
        field.finish(&polyline, line);
        // what was cut off where it came near itself says no more
        let saliency = saliency(&polyline, params);
        cleared.push(Cleared { saliency, pinned: vec![false; polyline.vertices.len()], polyline });
    }
    pin::pin(&mut cleared, &field);
    // what gave way or lost a stub may say more than before
    cleared.sort_by(|a, b| b.saliency.total_cmp(&a.saliency));
    cleared
}

/// Puts the ends of a line that touch others exactly on them.
fn snap(polyline: &mut Polyline<Vertex>, field: &Field<'_>) {
    if let ([first, .., last], false) = (&mut polyline.vertices[..], polyline.closed) {
        for end in [first, last] {
            let on_line = || field.segments().nearest(end.at, TOUCH, |_| true).map(|(_, at, _)| at);
            end.at = field.nearest_tip(end.at, TOUCH).or_else(on_line).unwrap_or(end.at);
        }
    }
}

/// The state of every vertex.
fn states(polyline: &Polyline<Vertex>, field: &Field<'_>) -> Vec<State> {
    if !polyline.vertices.iter().any(|vertex| field.may_be_near(vertex.at)) {
        return vec![State::Free; polyline.vertices.len()];
    }
    let places = field.places(polyline.view());
    let state = |(i, vertex): (usize, &Vertex)| field.state(vertex, places.arcs[i], &places);
    polyline.vertices.iter().enumerate().map(state).collect()
}
