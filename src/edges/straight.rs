//! A stroke goes straight on along the side of another contour that was found in its place.
//!
//! Of a house whose roof has eaves, one plane of colours shows the ring of the wall, and another the roof. The ring is
//! taken first, and of the roof's base line only the eaves are left, which end on corners of the ring: two lines nearer
//! to one another than fingers can tell apart. Of an axis that is thinner than a pixel, nothing can be told along the
//! bars that stand on it, whose borders are there, and short pieces are left between them. Through a junction the
//! straightest line goes on (see `stroke::arms`), so the side is given back to the line that runs along it, and the
//! wall and the bars end on it.

use super::params::HEADING;
use super::tips::FoundContour;
use crate::geom::polyline::Polyline;
use crate::units::{Px, PxVector};
use lyon::geom::euclid::Box2D;

/// An end goes straight on in one side of a corner if the cosine between their directions is at least this (15
/// degrees).
const STRAIGHT_COSINE: f32 = 0.966;
/// An end that goes straight on in one side of a corner does not go on in the other: cosine between their directions at
/// most (45 degrees).
const ASIDE: f32 = 0.707;
/// A stroke ends at most this much, px, and half its own width and this many scales of the edge detector, before the
/// contour that takes its place.
const BEFORE: f32 = 3.0;
const BEFORE_SCALES: f32 = 1.6;
/// Two lines are one if they are no farther aside from one another than half of each width and this much, px.
const OFF: f32 = 1.0;

/// A stroke's end that goes straight on in one side of a corner of another contour.
#[derive(Debug, Clone, Copy)]
struct Onward {
    piece: usize,
    at_start: bool,
    /// The vertex at the corner.
    corner: usize,
    /// Whether the side that goes on follows the corner, or leads to it.
    forwards: bool,
    /// Cosine between the directions of the end and of that side.
    cosine: f32,
}

/// Gives sides of contours to the strokes that go straight on in them: a side between two corners if strokes go on in
/// it at both, all of an open contour beyond a corner if one goes on there. What is left of the contour ends at the
/// corner. `sigma` is the scale of the edge detector, `least` the length of the shortest contour, px.
pub(super) fn reassign_sides(found: Vec<FoundContour>, sigma: f32, least: f32) -> Vec<FoundContour> {
    let piece = |found: FoundContour| OpenPart { free: [!found.contour.closed; 2], found };
    let mut pieces: Vec<OpenPart> = found.into_iter().map(piece).collect();
    give_sides(&mut pieces, least, |owner, pieces| {
        let ends @ [a, b] = facing(owner, pieces, sigma)?;
        let (side, rest) = between(&pieces[owner], a.corner, b.corner);
        Some(Reassignment::of(owner, &ends, side, rest, pieces))
    });
    give_sides(&mut pieces, least, |owner, pieces| {
        let end = straightest(owner, pieces, sigma)?;
        let (side, rest) = behind(&pieces[owner], end);
        Some(Reassignment::of(owner, &[end], side, vec![rest], pieces))
    });
    pieces.into_iter().map(|piece| piece.found).collect()
}

/// A side of a contour goes over to other pieces.
struct Reassignment {
    /// The pieces that are there no more: the contour, and those that get its side.
    gone: Vec<usize>,
    /// Those, as one line with the side.
    joined: OpenPart,
    /// What is left of the contour.
    rest: Vec<OpenPart>,
}

/// Lets all pieces give sides away for as long as they have any to give; what is left of one, if it is at least `least`
/// px long, has its turn once more.
fn give_sides(pieces: &mut Vec<OpenPart>, least: f32, handover: impl Fn(usize, &[OpenPart]) -> Option<Reassignment>) {
    let mut owner = 0;
    while owner < pieces.len() {
        let Some(Reassignment { mut gone, joined, rest }) = handover(owner, pieces) else {
            owner += 1;
            continue;
        };
        gone.sort_unstable();
        gone.dedup();
        owner -= gone.iter().filter(|number| **number < owner).count();
        gone.iter().rev().for_each(|number| {
            pieces.remove(*number);
        });
        pieces.push(joined);
        pieces.extend(rest.into_iter().filter(|piece| piece.found.contour.length() >= least));
    }
}

impl Reassignment {
    /// To the pieces of one or two ends. The side runs away from the first of them, and up to the second.
    fn of(owner: usize, ends: &[Onward], side: OpenPart, rest: Vec<OpenPart>, pieces: &[OpenPart]) -> Self {
        let gone = std::iter::once(owner).chain(ends.iter().map(|end| end.piece)).collect();
        let (first, last) = (ends[0], ends.get(1));
        let is_ring = last.is_some_and(|last| last.piece == first.piece);
        let mut parts = vec![pieces[first.piece].directed(!first.at_start)];
        parts.extend(last.filter(|_| !is_ring).map(|last| pieces[last.piece].directed(last.at_start)));
        let stroke = width(parts.iter().map(|part| &part.found), &side.found);
        let mut side = side;
        if stroke.is_some() {
            // a stroke has no step
            side.found.contour.vertices.iter_mut().for_each(|vertex| vertex.contrast = [0.0; 3]);
        }
        parts.insert(1, side);
        let free = if is_ring { [false; 2] } else { [parts[0].free[0], parts[parts.len() - 1].free[1]] };
        let whole = parts.iter().map(|part| part.found.whole).fold(0.0, f32::max);
        let tint = parts[0].found.tint;
        let vertices = parts.into_iter().flat_map(|part| part.found.contour.vertices).collect();
        let contour = Polyline { vertices, closed: is_ring };
        let found = FoundContour { whole: contour.length().max(whole), contour, stroke, tint };
        Self { gone, joined: OpenPart { found, free }, rest }
    }
}

/// Of the ends that go straight on in a side of an open contour, the straightest.
fn straightest(owner: usize, pieces: &[OpenPart], sigma: f32) -> Option<Onward> {
    let onward = if pieces[owner].found.contour.closed { Vec::new() } else { all_onward(owner, pieces, sigma) };
    onward
        .into_iter()
        .max_by(|a, b| a.cosine.total_cmp(&b.cosine).then((b.piece, b.at_start).cmp(&(a.piece, a.at_start))))
}

/// All ends that go straight on in a side of a contour.
fn all_onward(owner: usize, pieces: &[OpenPart], sigma: f32) -> Vec<Onward> {
    let contour = &pieces[owner].found.contour;
    let bounds = Box2D::from_points(contour.vertices.iter().map(|vertex| vertex.at));
    let ends = (0..pieces.len()).filter(|piece| *piece != owner).flat_map(|piece| [(piece, true), (piece, false)]);
    let free = ends.filter(|&(piece, at_start)| pieces[piece].free[usize::from(!at_start)]);
    free.filter_map(|end| onward(end, (owner, &bounds), pieces, sigma)).collect()
}

/// A contour.
#[derive(Debug, Clone)]
struct OpenPart {
    found: FoundContour,
    /// Whether its start and its end are those with which it was found and may go on. Those that were made by dividing
    /// may not, so that dividing comes to an end: each takes one or two away.
    free: [bool; 2],
}

/// The ends of strokes that go straight on along a contour, if there are two that do so towards one another in one
/// side.
fn facing(owner: usize, pieces: &[OpenPart], sigma: f32) -> Option<[Onward; 2]> {
    let contour = &pieces[owner].found.contour;
    let onward = all_onward(owner, pieces, sigma);
    let pairs = onward.iter().flat_map(|a| onward.iter().map(move |b| [*a, *b]));
    let facing = pairs.filter(|[a, b]| {
        let in_order = if contour.closed { a.corner != b.corner } else { a.corner < b.corner };
        a.forwards && !b.forwards && in_order && (a.piece != b.piece || a.at_start != b.at_start)
    });
    // the nearest two, so that no third lies between
    let count = contour.vertices.len();
    facing.min_by_key(|[a, b]| (b.corner + count - a.corner) % count)
}

/// Where an end of a stroke, given by its number and whether it is the start, goes straight on in a side of a contour,
/// given by its number and its bounds.
fn onward(
    (number, at_start): (usize, bool),
    (owner, bounds): (usize, &Box2D<f32, Px>),
    pieces: &[OpenPart],
    sigma: f32,
) -> Option<Onward> {
    let (stroke, contour) = (&pieces[number].found.contour, &pieces[owner].found.contour);
    let [piece, other] = [number, owner].map(|of| &pieces[of].found);
    if piece.differs_in_tint(other) || piece.differs_in_breadth(other) {
        return None;
    }
    let [width, other_width] = [number, owner].map(|of| pieces[of].found.stroke.unwrap_or(0.0));
    let tip = if at_start { 0 } else { stroke.vertices.len() - 1 };
    let at = stroke.vertices.get(tip)?.at;
    let near = 0.5 * (width + other_width) + BEFORE_SCALES * sigma + BEFORE;
    if !bounds.inflate(near, near).contains(at) {
        return None;
    }
    let around = (0..contour.vertices.len()).filter(|&i| (contour.vertices[i].at - at).length() <= near);
    let direction = -stroke.heading(tip, at_start, [0.0, HEADING])?;
    let sides = around.filter_map(|i| {
        let [after, before] = [true, false].map(|forwards| contour.heading(i, forwards, [0.0, HEADING]));
        let (after, before) = after.zip(before)?;
        Some((after.dot(before), i, [after, before]))
    });
    // the sharpest turn nearby is the corner
    let (_, corner, [after, before]) = sides.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let aside = direction.cross(contour.vertices[corner].at - at).abs();
    if aside > 0.5 * (width + other_width) + OFF {
        return None;
    }
    // where the sides go on in one another, straighter than it in either, there is no corner
    let goes_on = |side: PxVector, other: PxVector| {
        direction.dot(side) >= STRAIGHT_COSINE.max(-after.dot(before)) && direction.dot(other) <= ASIDE
    };
    let forwards = goes_on(after, before);
    let cosine = direction.dot(if forwards { after } else { before });
    (forwards || goes_on(before, after)).then_some(Onward { piece: number, at_start, corner, forwards, cosine })
}

/// The width of the line that the pieces of some ends make with a side: that of a stroke, if most of its length is one.
/// The side is a part of what goes on in it.
fn width<'a>(ends: impl Iterator<Item = &'a FoundContour>, side: &FoundContour) -> Option<f32> {
    let (mut strokes, mut edges, mut sum) = (0.0, 0.0, 0.0);
    for FoundContour { contour, stroke, .. } in ends {
        match stroke {
            Some(width) => (strokes, sum) = (strokes + contour.length(), sum + width * contour.length()),
            None => edges += contour.length(),
        }
    }
    let width = if strokes > 0.0 { Some(sum / strokes) } else { side.stroke };
    width.filter(|_| strokes + side.contour.length() >= edges)
}

impl OpenPart {
    fn reverse(&mut self) {
        self.found.contour.reverse();
        self.free.reverse();
    }

    /// The same piece, forwards or backwards.
    fn directed(&self, forwards: bool) -> Self {
        let mut piece = self.clone();
        if !forwards {
            piece.reverse();
        }
        piece
    }

    /// A run of its vertices, from one of them on; over the start, if it is a ring.
    fn run(&self, from: usize, count: usize, free: [bool; 2]) -> Self {
        let vertices = &self.found.contour.vertices;
        let run = (from..from + count).map(|i| vertices[i % vertices.len()]).collect();
        Self { found: FoundContour { contour: Polyline::open(run), ..self.found.clone() }, free }
    }
}

/// A contour divided at two of its vertices, both of which stay in all parts: the side between them, and what is left.
fn between(piece: &OpenPart, from: usize, to: usize) -> (OpenPart, Vec<OpenPart>) {
    let count = piece.found.contour.vertices.len();
    if piece.found.contour.closed {
        let run = |from: usize, to: usize| piece.run(from, (to + count - from) % count + 1, [false; 2]);
        (run(from, to), vec![run(to, from)])
    } else {
        let [start, end] = piece.free;
        let rest = vec![piece.run(0, from + 1, [start, false]), piece.run(to, count - to, [false, end])];
        (piece.run(from, to - from + 1, [false; 2]), rest)
    }
}

/// An open contour divided at a corner: the side in which an end goes on, directed away from it, and what is left.
fn behind(piece: &OpenPart, end: Onward) -> (OpenPart, OpenPart) {
    let count = piece.found.contour.vertices.len();
    let [start, last] = piece.free;
    let before = piece.run(0, end.corner + 1, [start, false]);
    let after = piece.run(end.corner, count - end.corner, [false, last]);
    if end.forwards {
        return (after, before);
    }
    (before.directed(false), after)
}

#[cfg(test)]
mod tests;
