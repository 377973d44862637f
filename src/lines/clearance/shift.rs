//! How the vertices of a line move when some of them are pushed: the others follow, less the farther they are. Straight
//! stretches of a drawing move as a whole and stay straight, and an end on another line slides along that.

use super::passage::{Junction, Meeting, Passage, TOUCH};
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// A line swings back to its place within this length, mm, so that no corner is felt.
const FADE: f32 = 6.0;
/// Least cosine between the directions of the segments of a straight stretch: 1 degree.
const STRAIGHT_COSINE: f32 = 0.99985;
/// A straight stretch is at least this long, mm: shorter ones are parts of curves.
const STRETCH: f32 = 2.0;
/// Where two stretches, or a stretch and the line on which it ends, meet at an angle with a smaller sine, their common
/// point is not computed from their offsets, as it may be far away.
const STEEP: f32 = 0.35;

/// A displacement at a place of a line, given by its arc, mm.
type LinePush = (f32, MmVector);

/// A straight stretch of a line.
struct StraightPart {
    /// Its first vertex.
    first: usize,
    /// How many segments it has.
    count: usize,
    /// At right angles to it, of length 1.
    normal: MmVector,
    /// How far it moves along the normal, mm.
    offset: f32,
}

impl StraightPart {
    fn shift(&self) -> MmVector {
        self.normal * self.offset
    }
}

/// The displacement of every vertex of a line, of which some are pushed; the others' push is zero. Straight stretches
/// stay straight.
pub(super) fn shifts_of_drawing(polyline: &Polyline<Vertex>, pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    let mut shifts: Vec<Option<MmVector>> = vec![None; polyline.vertices.len()];
    let stretches = stretches(polyline, pushes, passage);
    move_stretches(polyline, &stretches, passage, &mut shifts);
    with_others(shifts, pushes, passage)
}

/// The same of a line that may bend anywhere.
pub(super) fn shifts_of_curve(pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    with_others(vec![None; pushes.len()], pushes, passage)
}

/// The shifts of all vertices, of which those of some are known: the others follow these and their own pushes.
fn with_others(shifts: Vec<Option<MmVector>>, pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    let given = |i: usize| shifts[i].unwrap_or(pushes[i]);
    let pushed = (0..pushes.len()).map(|i| (passage.arcs[i], given(i))).filter(|(_, push)| *push != MmVector::zero());
    let pushed: Vec<LinePush> = pushed.collect();
    shifts
        .iter()
        .zip(&passage.arcs)
        .map(|(shift, &arc)| shift.unwrap_or_else(|| faded(arc, &pushed, passage)))
        .collect()
}

/// The straight stretches of a line, and how far each must move.
fn stretches(polyline: &Polyline<Vertex>, pushes: &[MmVector], passage: &Passage) -> Vec<StraightPart> {
    let directions: Vec<MmVector> =
        polyline.segments().map(|(a, b)| (b.at - a.at).try_normalize().unwrap_or_default()).collect();
    let (n, count) = (polyline.vertices.len(), directions.len());
    let is_straight = |a: MmVector, b: MmVector| a.dot(b) >= STRAIGHT_COSINE;
    // of a ring from a corner on
    let corner = (0..count).find(|&i| !is_straight(directions[(i + count - 1) % count], directions[i]));
    let start = match (polyline.closed, corner) {
        (false, _) => 0,
        (true, Some(corner)) => corner,
        (true, None) => return Vec::new(),
    };
    let order: Vec<usize> = (0..count).map(|k| (start + k) % count).collect();
    let mut stretches = Vec::new();
    let mut rest = &order[..];
    while let Some(&first) = rest.first() {
        let alike = rest.iter().take_while(|&&i| is_straight(directions[first], directions[i])).count().max(1);
        let (these, others) = rest.split_at(alike);
        rest = others;
        let length: f32 = these.iter().map(|&i| passage.arcs[i + 1] - passage.arcs[i]).sum();
        if length < STRETCH {
            continue;
        }
        let normal = MmVector::new(-directions[first].y, directions[first].x);
        let vertices = || (0..=alike).map(|k| (first + k) % n);
        // pushed to both sides, it goes between
        let across = || vertices().map(|i| pushes[i].dot(normal));
        let (low, high) = (across().fold(0.0, f32::min), across().fold(0.0, f32::max));
        let (from, to) = (passage.arcs[these[0]], passage.arcs[these[alike - 1] + 1]);
        // what ends on it would come off
        let within = |arc: f32| if from < to { (from..=to).contains(&arc) } else { !(to..from).contains(&arc) };
        let carries = |j: &Junction| j.meeting == Meeting::LineEnds && within(j.arc);
        let offset = if passage.junctions.iter().any(carries) { 0.0 } else { low + high };
        stretches.push(StraightPart { first, count: alike, normal, offset });
    }
    stretches
}

/// Moves the vertices of straight stretches.
fn move_stretches(
    polyline: &Polyline<Vertex>,
    stretches: &[StraightPart],
    passage: &Passage,
    shifts: &mut [Option<MmVector>],
) {
    let n = polyline.vertices.len();
    let (mut after, mut before) = (vec![None; n], vec![None; n]);
    for stretch in stretches {
        after[stretch.first] = Some(stretch);
        before[(stretch.first + stretch.count) % n] = Some(stretch);
    }
    for vertex in 0..n {
        shifts[vertex] = match (before[vertex], after[vertex]) {
            (Some(a), Some(b)) => Some(common(a, b)),
            (Some(one), None) | (None, Some(one)) => {
                let end =
                    passage.junctions.iter().find(|j| j.is_own_end() && (j.arc - passage.arcs[vertex]).abs() < TOUCH);
                Some(end.map_or(one.shift(), |end| slid(one, end.along)))
            }
            (None, None) => None,
        };
    }
    for stretch in stretches {
        let at = |k: usize| (stretch.first + k) % n;
        let (Some(from), Some(to)) = (shifts[at(0)], shifts[at(stretch.count)]) else { continue };
        for k in 1..stretch.count {
            shifts[at(k)] = Some(from.lerp(to, k as f32 / stretch.count as f32));
        }
    }
}

/// How the common vertex of two stretches moves: to where they cross when both have moved.
fn common(a: &StraightPart, b: &StraightPart) -> MmVector {
    let sine = a.normal.cross(b.normal);
    if sine.abs() < STEEP {
        return (a.shift() + b.shift()) * 0.5;
    }
    // the point d with d . a = offset of a and d . b = offset of b
    MmVector::new(
        (a.offset * b.normal.y - b.offset * a.normal.y) / sine,
        (b.offset * a.normal.x - a.offset * b.normal.x) / sine,
    )
}

/// How the end of a stretch moves that lies on a line with this direction: it stays on it.
fn slid(stretch: &StraightPart, along: MmVector) -> MmVector {
    let sine = along.dot(stretch.normal);
    if sine.abs() < STEEP { MmVector::zero() } else { along * (stretch.offset / sine) }
}

/// The longest of the displacements at `arc`, each of which fades along the line; near junctions the line stays where
/// it is.
fn faded(arc: f32, pushes: &[LinePush], passage: &Passage) -> MmVector {
    let mut longest = MmVector::zero();
    // those farther away have faded: of an open line the others are a run, of a ring there may be two more
    let at = |arc: f32| pushes.partition_point(|(there, _)| *there < arc);
    let first = at(arc - FADE - TOUCH);
    let last = at(arc + FADE + TOUCH).max(first);
    let over_start = passage.ring_length.map(|ring_length| {
        let before = at(arc + FADE + TOUCH - ring_length).min(first);
        let after = at(arc - FADE - TOUCH + ring_length).max(last);
        (&pushes[..before], &pushes[after..])
    });
    let (before, after) = over_start.unwrap_or_default();
    for &(there, push) in before.iter().chain(&pushes[first..last]).chain(after) {
        let push = push * (1.0 - passage.between(arc, there) / FADE).max(0.0);
        if push.square_length() > longest.square_length() {
            longest = push;
        }
    }
    let junction = passage.junctions.iter().map(|j| passage.between(j.arc, arc)).fold(f32::MAX, f32::min);
    longest * (junction / FADE).min(1.0)
}

#[cfg(test)]
mod tests;
