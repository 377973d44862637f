//! Axes in pieces: a stroke of another colour that lies on a part of one, as an interval on a number line, makes pieces
//! of it, and parts the ticks that it crosses.

use std::collections::BTreeMap;

use super::super::lead_on::heading;
use super::super::params::HEADING;
use super::super::vertex::{Tip, Vertex};
use crate::geom::nearby::Index;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, MmVector};

/// Ends of two pieces of an axis are so near to one another, mm: a point of a number line may lie between them.
const ENDS: f32 = 5.0;
/// Ends that face one another are no further aside of one another's line than this, mm.
const ASIDE: f32 = 0.5;
/// Pieces go straight on in one another: the cosine between their directions (11 degrees).
const AHEAD: f32 = 0.98;

/// An end that points at others: where it is, its direction, and of which line.
type End = (MmPoint, MmVector, usize);

/// The half of a tick: its line, the end that stands on another, and how far it is from that, mm.
pub(super) struct Half {
    pub(super) line: usize,
    pub(super) foot: Tip,
    pub(super) gap: f32,
}

/// Of each of these straight lines, the first of those that are pieces of one line with it.
pub(super) fn first_pieces(
    bases: impl Iterator<Item = usize>,
    polylines: &[Polyline<Vertex>],
    area: MmRect,
) -> BTreeMap<usize, usize> {
    let mut first: BTreeMap<usize, usize> = bases.map(|base| (base, base)).collect();
    let ends: Vec<End> =
        first.keys().flat_map(|&base| Tip::BOTH.map(|which| end(&polylines[base], which, base))).flatten().collect();
    for (a, b) in facing(&ends, area, ENDS) {
        let (a, b) = (root(&first, ends[a].2), root(&first, ends[b].2));
        first.insert(a.max(b), a.min(b));
    }
    first.keys().map(|&base| (base, root(&first, base))).collect()
}

/// Between the feet of two halves is no more than the line on which they stand, mm.
const BETWEEN: f32 = 1.0;

/// Joins ticks that stand on one line on both sides, at one place, to one across it; the other half is empty then.
/// Returns whether there were any.
pub(super) fn join_halves(halves: &[Half], polylines: &mut [Polyline<Vertex>], area: MmRect) -> bool {
    // where a half stands, pointing at the other
    let feet = halves.iter().filter_map(|half| Some((end(&polylines[half.line], half.foot, half.line)?, half)));
    let feet: Vec<(End, &Half)> = feet.collect();
    let ends: Vec<End> = feet.iter().map(|(end, _)| *end).collect();
    let reach = 2.0 * halves.iter().map(|half| half.gap).fold(0.0, f32::max) + BETWEEN;
    let mut joined = vec![false; feet.len()];
    for (a, b) in facing(&ends, area, reach) {
        let ((from, half), (to, other)) = (feet[a], feet[b]);
        if joined[a] || joined[b] || (to.0 - from.0).length() > half.gap + other.gap + BETWEEN {
            continue;
        }
        (joined[a], joined[b]) = (true, true);
        let mut rest = std::mem::replace(&mut polylines[to.2], Polyline::open(Vec::new()));
        if other.foot == Tip::Last {
            rest.reverse();
        }
        let line = &mut polylines[from.2];
        if half.foot == Tip::First {
            line.reverse();
        }
        line.vertices.append(&mut rest.vertices);
    }
    joined.contains(&true)
}

/// An end of a line.
fn end(line: &Polyline<Vertex>, which: Tip, number: usize) -> Option<End> {
    Some((which.of(line)?.at, heading(line, which, HEADING)?, number))
}

/// The pairs of ends of two lines that are near to one another and point at one another.
fn facing(ends: &[End], area: MmRect, reach: f32) -> Vec<(usize, usize)> {
    let mut index = Index::new(area, reach);
    (0..).zip(ends).for_each(|(number, (at, ..)): (usize, _)| index.put_at(*at, number));
    let mut pairs = Vec::new();
    for (number, (at, ahead, line)) in ends.iter().enumerate() {
        let mut near = Vec::new();
        index.around(*at, *at, reach, |&other| near.push(other));
        near.sort_unstable();
        pairs.extend(near.into_iter().filter(|&other| other > number).filter_map(|other| {
            let (its, its_ahead, its_line) = ends[other];
            let way = its - *at;
            let faces = ahead.dot(its_ahead) <= -AHEAD && way.cross(*ahead).abs() <= ASIDE;
            (its_line != *line && way.length() <= reach && faces).then_some((number, other))
        }));
    }
    pairs
}

/// The first of all lines that a line was joined with.
fn root(first: &BTreeMap<usize, usize>, mut line: usize) -> usize {
    while let Some(&before) = first.get(&line).filter(|before| **before != line) {
        line = before;
    }
    line
}

#[cfg(test)]
mod tests;
