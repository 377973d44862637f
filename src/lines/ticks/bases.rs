//! Axes in pieces: a stroke of another colour that lies on a part of one, as an interval on a number line, makes pieces
//! of it, and parts the ticks that it crosses.

use std::collections::BTreeMap;

use super::super::lead_on::heading;
use super::super::params::HEADING;
use super::super::vertex::{Tip, Vertex};
use super::{Tick, is_straight};
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

/// Of each of these lines, the first of those straight ones that are pieces of one line with it.
pub(super) fn first_pieces(
    bases: impl Iterator<Item = usize>,
    polylines: &[Polyline<Vertex>],
    area: MmRect,
) -> BTreeMap<usize, usize> {
    let mut first: BTreeMap<usize, usize> = bases.map(|base| (base, base)).collect();
    let ends: Vec<End> = first
        .keys()
        .filter(|base| is_straight(&polylines[**base]))
        .flat_map(|&base| Tip::BOTH.map(|which| end(&polylines[base], which, base)))
        .flatten()
        .collect();
    for (a, b) in facing(&ends, area, ENDS) {
        let (a, b) = (root(&first, ends[a].2), root(&first, ends[b].2));
        first.insert(a.max(b), a.min(b));
    }
    first.keys().map(|&base| (base, root(&first, base))).collect()
}

/// Joins ticks that stand on one line on both sides, at one place, to one across it; the other half is empty then.
/// Returns whether there were any.
pub(super) fn join_halves(ticks: &[Tick], polylines: &mut [Polyline<Vertex>], area: MmRect) -> bool {
    // where a half stands, pointing at the other
    let feet: Vec<(End, f32, Tip)> = ticks
        .iter()
        .filter_map(|tick| {
            let (which, gap) = match tick.stands {
                [Some(gap), None] => (Tip::First, gap),
                [None, Some(gap)] => (Tip::Last, gap),
                _ => return None,
            };
            Some((end(&polylines[tick.number], which, tick.number)?, gap, which))
        })
        .collect();
    let ends: Vec<End> = feet.iter().map(|(end, ..)| *end).collect();
    let reach = 2.0 * super::STANDS;
    let mut joined = vec![false; feet.len()];
    for (a, b) in facing(&ends, area, reach) {
        let ((from, gap, of_a), (to, other_gap, of_b)) = (feet[a], feet[b]);
        // nothing but the line that both stand on lies between
        if joined[a] || joined[b] || (to.0 - from.0).length() > gap + other_gap + super::ONE {
            continue;
        }
        (joined[a], joined[b]) = (true, true);
        let mut half = std::mem::replace(&mut polylines[to.2], Polyline::open(Vec::new()));
        if of_b == Tip::Last {
            half.reverse();
        }
        let line = &mut polylines[from.2];
        if of_a == Tip::First {
            line.reverse();
        }
        line.vertices.append(&mut half.vertices);
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
