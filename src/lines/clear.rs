//! No two lines nearer than fingers can part them: of two rivals the more salient stays, the other is trimmed where it
//! comes too near. Lines that truly join may meet.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::near::{Field, Meeting, State, TOUCH, is_bend, returns};
use super::saliency::saliency;
use super::trail::{Trail, Vertex};
use super::{Params, meet, nudge};
use crate::geom::crossing;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmRect, MmVector};

/// A line whose path comes this near to another, in join gaps, may be led over to it.
const MEETS: f32 = 0.5;
/// ... if it does not turn aside for it: least cosine between its heading and the way over.
const AHEAD: f32 = 0.5;
/// ... where the way over is longer than this, mm; shorter ones have no direction worth asking for.
const TURN: f32 = 0.75;
/// A line that meets another this near to its end, mm, ends there.
const TIP: f32 = 0.01;
/// The heading is taken over this much of the line, mm.
const HEADING: f32 = 2.0;
/// A line that would meet another this near to where a third one does is led to the same place, mm.
const SNAP: f32 = 1.5;
/// A line of which less than this share is left in pieces keeps only the first of them, and a ring none: stubs say where
/// something was, not what.
const WHOLE: f32 = 0.5;
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
    while let Some(Candidate { saliency, cuts, mut trail, .. }) = queue.heap.pop() {
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
        cleared.push(Cleared { saliency, pinned: vec![false; trail.vertices.len()], trail });
    }
    pin(&mut cleared, &field);
    // what gave way or lost a stub may say more than before
    cleared.sort_by(|a, b| b.saliency.total_cmp(&a.saliency));
    cleared
}

/// A line that ends before it is apart from one that it has crossed ends on it instead: the stub beyond is felt as a blot.
/// None if it has no stubs.
fn without_stubs(trail: &Trail, field: &Field<'_>) -> Option<Trail> {
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

/// What is left of a line that is too near to others: its parts between, led on to the lines that they meet.
fn pieces(trail: &Trail, states: &[State], field: &Field<'_>, params: &Params) -> Vec<Trail> {
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
    // between[k]: from the end of one stretch with vertices that are too near to the start of the next
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
fn opened(trail: &Trail, start: usize) -> Trail {
    let ring = trail.vertices.len() - 1;
    Trail { vertices: (0..=ring).map(|k| trail.vertices[(start + k) % ring]).collect(), closed: false }
}

/// The vertices that lead a line on along its old `path`, to a line that it meets soon and not too flat. `own` is the line
/// itself if it is drawn already, which it may meet as well.
fn lead_on(
    body: &[Vertex],
    path: &[Vertex],
    ends: bool,
    field: &Field<'_>,
    own: Option<u32>,
    params: &Params,
) -> Option<Vec<Vertex>> {
    let start = body.last()?;
    let length: f32 = body.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
    let own_bend = |segment: &Segment, way: f32, distance: f32| {
        own == Some(segment.line) && is_bend(length + way - segment.arc, distance)
    };
    // a line that is led back to itself makes a loop that a finger finds
    let own_knot = |segment: &Segment, way: f32, distance: f32| {
        own == Some(segment.line) && is_bend(length + way - segment.arc - field.longest_stub(), distance)
    };
    let longest = field.longest_approach();
    let mut led: Vec<Vertex> = Vec::new();
    let mut way = 0.0;
    // the place to be led to, how many vertices come before it, and how far it is from the last of them
    let mut target: Option<(MmPoint, usize, f32)> = None;
    for vertex in path {
        let last = led.last().unwrap_or(start).at;
        let mut hit: Option<(f32, MmPoint)> = None;
        field.segments().around(last.min(vertex.at), last.max(vertex.at), 0.0, |segment| {
            if let Some(at) = crossing((last, vertex.at), (segment.a, segment.b)) {
                let distance = (at - last).length();
                if hit.is_none_or(|(least, _)| distance < least) && !own_knot(segment, way + distance, 0.0) {
                    hit = Some((distance, at));
                }
            }
        });
        if let Some((_, at)) = hit {
            target = Some((at, led.len(), 0.0));
            break;
        }
        way += (vertex.at - last).length();
        if way > longest {
            break;
        }
        led.push(*vertex);
        let reach = target.map_or(MEETS * params.join_gap, |(.., distance)| distance);
        let near = field.segments().nearest(vertex.at, reach, |segment| {
            !own_knot(segment, way, nearest_on_segment(vertex.at, segment.a, segment.b).0)
        });
        if let Some((distance, at, _)) = near {
            target = Some((at, led.len(), distance));
            if distance < 1e-3 {
                break;
            }
        }
    }
    if target.is_none() && ends && way <= longest {
        // the contour itself ends: what it points at
        let tip = led.last().unwrap_or(start);
        let heading = heading(body, &led)?;
        let at = meet::ahead(tip.at, heading, field.segments(), params.join_gap, |_| true)?;
        target = Some((at, led.len(), (at - tip.at).length()));
    }
    let (mut at, count, _) = target?;
    led.truncate(count);
    if let Some(tip) = field.nearest_tip(at, SNAP) {
        at = tip;
        while led.last().is_some_and(|vertex| (vertex.at - tip).length() < SNAP) {
            led.pop();
        }
    }
    if own.is_some() && body.first().is_some_and(|first| (first.at - at).length() < SNAP) {
        return None; // it would close the ring that was cut open because its sides are too near
    }
    let tip = *led.last().unwrap_or(start);
    let over = at - tip.at;
    let turns = heading(body, &led).is_some_and(|heading| over.dot(heading) < AHEAD * over.length());
    if over.length() > params.join_gap || (over.length() > TURN && turns) {
        return None;
    }
    led.extend(meet::way(&tip, at));
    let mut whole = vec![*start];
    whole.extend(&led);
    let places = field.arriving(&whole);
    let joins = whole.iter().zip(&places.arcs).skip(1).all(|(vertex, &arc)| {
        let mut fits = true;
        field.each_near(vertex, arc, &places, |near, _, joins| {
            fits = joins || own_bend(near.segment, arc, near.distance);
            fits
        });
        fits
    });
    (joins && places.arcs.last().is_some_and(|&arc| arc <= longest)).then_some(led)
}

/// The direction of a line that goes on with `led`.
fn heading(body: &[Vertex], led: &[Vertex]) -> Option<MmVector> {
    let mut back = led.iter().rev().chain(body.iter().rev());
    let tip = back.next()?.at;
    let inner = back.find(|vertex| (vertex.at - tip).length() >= HEADING).or(body.first())?.at;
    (tip - inner).try_normalize()
}

/// Puts a vertex into a line where another one ends on it, so that they still meet after simplification.
fn pin(cleared: &mut [Cleared], field: &Field<'_>) {
    // line, vertex before, way from it, place
    let mut pins: Vec<(usize, usize, f32, MmPoint)> = Vec::new();
    for (number, line) in cleared.iter().enumerate().filter(|(_, line)| !line.trail.closed) {
        let vertices = &line.trail.vertices;
        for (at, inner) in [(vertices.first(), 1), (vertices.last(), vertices.len().saturating_sub(2))] {
            let Some(at) = at.map(|vertex| vertex.at) else { continue };
            field.segments().around(at, at, TOUCH, |segment| {
                let (distance, _) = nearest_on_segment(at, segment.a, segment.b);
                let itself = segment.line as usize == number && (segment.index as usize).abs_diff(inner) <= 2;
                if distance <= TOUCH && !itself {
                    let pin = (segment.line as usize, segment.index as usize, (at - segment.a).length(), at);
                    pins.push(pin);
                }
            });
        }
    }
    // from the last vertex back, so that the numbers before stay right
    pins.sort_by(|a, b| (b.0, b.1).cmp(&(a.0, a.1)).then(b.2.total_cmp(&a.2)));
    pins.dedup_by(|a, b| a.0 == b.0 && a.1.abs_diff(b.1) <= 1 && a.3 == b.3);
    for (line, index, _, at) in pins {
        let Cleared { trail, pinned, .. } = &mut cleared[line];
        let near = |i: usize| {
            let vertex = trail.vertices[i].at;
            let is_end = !trail.closed && (i == 0 || i + 1 == trail.vertices.len());
            vertex == at || (!pinned[i] && !is_end && (vertex - at).length() <= TOUCH)
        };
        if near(index) || near(index + 1) {
            let vertex = if near(index) { index } else { index + 1 };
            trail.vertices[vertex].at = at;
            pinned[vertex] = true;
            // a ring begins where it ends
            let last = trail.vertices.len() - 1;
            if trail.closed && (vertex == 0 || vertex == last) {
                trail.vertices[last - vertex].at = at;
            }
        } else {
            let (before, after) = (trail.vertices[index], trail.vertices[index + 1]);
            // as wide as the piece of line that it parts
            let width = before.width.min(after.width);
            trail.vertices.insert(index + 1, Vertex { at, width, ..before });
            pinned.insert(index + 1, true);
        }
    }
}
