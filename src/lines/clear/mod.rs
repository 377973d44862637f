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
use self::pieces::{opened, pieces, without_stubs};
use super::saliency::saliency;
use super::trail::{Trail, Vertex};
use super::{Params, meet, weight};
use crate::geom::nearby::Nearby;
use crate::units::MmRect;

/// A piece that is still too near after this many cuts is given up. None of the samples needs more than three.
const MOST_CUTS: u8 = 8;

/// A line that is drawn.
pub(super) struct Cleared {
    pub(super) trail: Trail,
    pub(super) saliency: f32,
    /// For each vertex whether another line ends there.
    pub(super) pinned: Vec<bool>,
}

struct Candidate {
    saliency: f32,
    number: usize,
    cuts: u8,
    trail: Trail,
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
    fn push(&mut self, trail: Trail, cuts: u8) {
        if trail.vertices.len() < 2 || trail.length() < self.params.min_length || cuts > MOST_CUTS {
            return;
        }
        let saliency = saliency(&trail, self.params);
        self.heap.push(Candidate { saliency, number: self.count, cuts, trail });
        self.count += 1;
    }
}

/// Clears lines, the one that says most first; the result is in that order.
pub(super) fn clear(trails: Vec<Trail>, area: MmRect, params: &Params) -> Vec<Cleared> {
    let mut queue = Queue { heap: BinaryHeap::with_capacity(trails.len()), count: 0, params };
    // Where a line comes near itself its earlier part stays.
    trails.into_iter().for_each(|trail| queue.push(trail.stronger_half_first(), 0));
    let mut field = Field::new(area, params);
    let mut own = Nearby::new(area, params.min_gap + params.width_max);
    let mut cleared: Vec<Cleared> = Vec::new();
    while let Some(Candidate { cuts, mut trail, .. }) = queue.heap.pop() {
        if let Some(shorter) = without_stubs(&trail, &field) {
            queue.push(shorter, cuts + 1);
            continue;
        }
        let near = states(&trail, &field);
        if near.contains(&State::TooNear) {
            if let Some(aside) = nudge::nudged(&trail, &field) {
                queue.push(aside, cuts + 1);
                continue;
            }
            pieces(&trail, &near, &field, params).into_iter().for_each(|piece| queue.push(piece, cuts + 1));
            continue;
        }
        let mut rest = None;
        if let Some(back) = returns(&trail, &field, &mut own) {
            if trail.closed {
                // begun after the stretch that is too near, it comes last
                let mut open = opened(&trail, back.end % (trail.vertices.len() - 1));
                open.vertices.pop();
                queue.push(open, cuts + 1);
                continue;
            }
            let mut path = trail.vertices.split_off(back.start);
            // an end that lay on the line itself, and made what is near it a junction, may be gone
            while let Some(back) = returns(&trail, &field, &mut own) {
                path.splice(0..0, trail.vertices.split_off(back.start));
            }
            // What was joined to a line by a meeting beyond the cut is so no longer.
            if trail.length() < params.min_length || states(&trail, &field).contains(&State::TooNear) {
                queue.push(trail, cuts + 1);
                queue.push(Trail { vertices: path, closed: false }, cuts + 1);
                continue;
            }
            rest = Some(path);
        }
        snap(&mut trail, &field);
        let line = field.begin(&trail);
        if let Some(path) = rest {
            let body = trail.vertices.len();
            if let Some(on) = lead_on(&trail.vertices, &path, false, &field, Some(line), params) {
                trail.vertices.extend(on);
                if returns(&trail, &field, &mut own).is_none() {
                    field.go_on(&trail, body - 1, line);
                } else {
                    trail.vertices.truncate(body);
                }
            }
            queue.push(Trail { vertices: path, closed: false }, cuts + 1);
        }
        field.finish(&trail, line);
        // what was cut off where it came near itself says no more
        let saliency = saliency(&trail, params);
        cleared.push(Cleared { saliency, pinned: vec![false; trail.vertices.len()], trail });
    }
    pin::pin(&mut cleared, &field);
    // what gave way or lost a stub may say more than before
    cleared.sort_by(|a, b| b.saliency.total_cmp(&a.saliency));
    cleared
}

/// Puts the ends of a line that touch others exactly on them.
fn snap(trail: &mut Trail, field: &Field<'_>) {
    if let ([first, .., last], false) = (&mut trail.vertices[..], trail.closed) {
        for end in [first, last] {
            let on_line = || field.segments().nearest(end.at, TOUCH, |_| true).map(|(_, at, _)| at);
            end.at = field.nearest_tip(end.at, TOUCH).or_else(on_line).unwrap_or(end.at);
        }
    }
}

/// The state of every vertex.
fn states(trail: &Trail, field: &Field<'_>) -> Vec<State> {
    if !trail.vertices.iter().any(|vertex| field.may_be_near(vertex.at)) {
        return vec![State::Free; trail.vertices.len()];
    }
    let places = field.places(&trail.vertices, trail.closed);
    let state = |(i, vertex): (usize, &Vertex)| field.state(vertex, places.arcs[i], &places);
    trail.vertices.iter().enumerate().map(state).collect()
}
