//! The last look at the lines of a drawing: where two are nearer than fingers tell apart, the lesser is cut.
//!
//! Lines are kept apart before they are simplified, and before they become dots. In a crowded drawing what comes of
//! that may still be too near: lines that cross at flat angles, or rows of dots that were moved. The rules of the check
//! say where.

use super::lost_signs::extent;
use crate::geom::nearby::Nearby;
use crate::geom::ninths::ninth;
use crate::legibility::{MediumLimits, Near, RuleLimits, near_lines, short_lines};
use crate::lines::{Line, Lines, LostLine, Pen, Run};
use crate::page::Medium;
use crate::units::{MmPoint, MmRect};

/// How often lines are cut before those that are still too near to others are left out.
const ROUNDS: usize = 4;
/// Places of a stroke are looked at this often, mm.
const STEP: f32 = 0.2;
/// A cut ends that much beyond where it must, mm: numbers of a page are rounded.
const BEYOND: f32 = 0.05;

/// Cuts lines in `area` of a page of this medium that are too near to others, or to themselves, and leaves out what is
/// too short then. With `whole_rings` a ring is left out rather than cut.
pub(super) fn cut(drawn: &mut Lines, (area, medium): (MmRect, &Medium), limits: &RuleLimits, whole_rings: bool) {
    // what is left out may have joined two others: it ends, as from then on each round leaves out a line
    for round in 0.. {
        let (near, _) = near_lines(&drawn.lines, medium, limits);
        let short = short_lines(&drawn.lines, limits);
        if near.is_empty() && short.is_empty() {
            return;
        }
        let index = index(&drawn.lines, area, limits);
        let mut cuts: Vec<Vec<Cut>> = vec![Vec::new(); drawn.lines.len()];
        let mut is_out = vec![false; drawn.lines.len()];
        short.into_iter().for_each(|line| is_out[line] = true);
        for near in &near {
            let (line, other) = lesser_first(&drawn.lines, near.lines);
            is_out[line] |= round >= ROUNDS || whole_rings && is_ring(&drawn.lines[line]);
            cuts[line].push(Cut::of(near, (line, other), &drawn.lines, limits));
        }
        let mut kept = Vec::with_capacity(drawn.lines.len());
        for (number, line) in std::mem::take(&mut drawn.lines).into_iter().enumerate() {
            let pieces = match (is_out[number], &cuts[number][..]) {
                (true, _) => Vec::new(),
                (false, []) => vec![line.clone()],
                (false, cuts) => without(&line, cuts, &index),
            };
            tell_lost(&line, &pieces, area, drawn);
            kept.extend(pieces);
        }
        drawn.lines = kept;
    }
}

/// The two numbers of lines that are too near, that which is cut first: an open one before a closed one, and of two
/// the shorter.
fn lesser_first(lines: &[Line], (one, other): (usize, usize)) -> (usize, usize) {
    let rank = |number: usize| (is_ring(&lines[number]), lines[number].length());
    let ((one_closed, one_length), (other_closed, other_length)) = (rank(one), rank(other));
    let other_first = other_closed.cmp(&one_closed).then(other_length.total_cmp(&one_length)).is_lt();
    if other_first { (other, one) } else { (one, other) }
}

fn is_ring(line: &Line) -> bool {
    line.runs.iter().any(|run| run.closed) || line.is_ring_of_dots()
}

/// What is taken out of a line: the stretches along which it is near to another that reach into a box.
#[derive(Debug, Clone, Copy)]
struct Cut {
    within: MmRect,
    /// The other line and how near it must be, mm; none where the line is too near to itself.
    other: Option<(u32, f32)>,
}

impl Cut {
    fn of(near: &Near, (line, other): (usize, usize), lines: &[Line], limits: &RuleLimits) -> Self {
        let half = |number: usize| 0.5 * lines[number].runs.iter().map(|run| run.width).fold(0.0, f32::max);
        let reach = BEYOND
            + match limits.medium {
                MediumLimits::Print { line_gap, .. } => line_gap + half(line) + half(other),
                // also along a diagonal
                MediumLimits::Dots { line_gap, pitch, .. } => {
                    (line_gap as f32 + 0.5) * pitch * std::f32::consts::SQRT_2
                }
            };
        if line == other {
            return Self { within: near.extent.inflate(BEYOND, BEYOND), other: None };
        }
        Self { within: near.extent.inflate(reach, reach), other: Some((other as u32, reach)) }
    }

    fn is_near(&self, at: MmPoint, index: &Nearby) -> bool {
        match self.other {
            Some((other, reach)) => index.nearest_of_line(at, reach, other).is_some(),
            None => self.within.contains_inclusive(at),
        }
    }
}

/// The lines by place.
fn index(lines: &[Line], area: MmRect, limits: &RuleLimits) -> Nearby {
    let mut index = Nearby::new(area, limits.line_length);
    for (number, line) in (0..).zip(lines) {
        line.runs.iter().for_each(|run| index.insert_line(number, run.polyline(), 0.5 * run.width));
    }
    index
}

/// A place of a line: of strokes every [`STEP`], of dots each.
#[derive(Debug, Clone, Copy)]
struct Place {
    at: MmPoint,
    /// Width from here on.
    width: f32,
    is_vertex: bool,
}

/// The places of a line in order; of a ring the first comes again at the end.
fn places(line: &Line) -> Vec<Place> {
    let mut all: Vec<Place> = Vec::new();
    for run in line.own_runs() {
        let width = run.width;
        if run.pen != Pen::Stroke {
            return run.points.iter().map(|&at| Place { at, width, is_vertex: true }).collect();
        }
        // each run begins where the one before it ends
        all.pop();
        for (a, b) in run.polyline().segments() {
            let steps = ((*b - *a).length() / STEP).ceil().max(1.0);
            let place = |k: u32| Place { at: a.lerp(*b, k as f32 / steps), width, is_vertex: k == 0 };
            all.extend((0..steps as u32).map(place));
        }
        all.extend(run.path().last().map(|at| Place { at, width, is_vertex: true }));
    }
    all
}

/// The pieces of a line that are left without the stretches of these cuts.
fn without(line: &Line, cuts: &[Cut], index: &Nearby) -> Vec<Line> {
    let mut places = places(line);
    let mut is_out = vec![false; places.len()];
    for cut in cuts {
        let near: Vec<bool> = places.iter().map(|place| cut.is_near(place.at, index)).collect();
        for stretch in stretches(&near, true) {
            if stretch.clone().any(|i| cut.within.contains_inclusive(places[i].at)) {
                is_out[stretch].fill(true);
            }
        }
    }
    let goes_round = matches!(&places[..], [first, .., last] if places.len() > 2 && first.at == last.at);
    if let Some(start) = is_out.iter().position(|is_out| *is_out).filter(|_| goes_round) {
        // the first piece goes on from the last
        places.pop();
        is_out.pop();
        let start = start % places.len().max(1);
        places.rotate_left(start);
        is_out.rotate_left(start);
    }
    let rows: Vec<_> = stretches(&is_out, false).collect();
    let mut pieces: Vec<Line> =
        rows.iter().map(|row| Line { runs: runs(&places[row.clone()], line), ..line.clone() }).collect();
    for run in line.runs.iter().skip(line.own_runs().len()) {
        let piece_of = |at: &MmPoint| {
            let distance = |i: &usize| (places[*i].at - *at).square_length();
            let nearest = (0..places.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
            rows.iter().position(|row| row.contains(&nearest))
        };
        let owners: Vec<Option<usize>> = run.points.iter().map(piece_of).collect();
        for (number, piece) in pieces.iter_mut().enumerate() {
            let own = run.points.iter().zip(&owners).filter(|(_, owner)| **owner == Some(number));
            let points: Vec<MmPoint> = own.map(|(at, _)| *at).collect();
            if !points.is_empty() {
                piece.runs.push(Run { points, ..run.clone() });
            }
        }
    }
    pieces.retain(|piece| piece.runs.iter().any(|run| run.points.len() > 1));
    pieces
}

/// The ranges in which all are `which`.
fn stretches(of: &[bool], which: bool) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut from = 0;
    let chunks = of.chunk_by(|a, b| a == b).map(move |chunk| {
        let range = from..from + chunk.len();
        from = range.end;
        (chunk[0], range)
    });
    chunks.filter(move |(is, _)| *is == which).map(|(_, range)| range)
}

/// The runs of a piece of a line.
fn runs(places: &[Place], line: &Line) -> Vec<Run> {
    if let Some(row) = line.row() {
        return vec![Run { points: places.iter().map(|place| place.at).collect(), ..row.clone() }];
    }
    let mut runs: Vec<(f32, Vec<MmPoint>)> = Vec::new();
    let last = places.len() - 1;
    for (i, place) in places.iter().enumerate() {
        if let Some((width, points)) = runs.last_mut() {
            if place.is_vertex || i == last {
                points.push(place.at);
            }
            if width.total_cmp(&place.width).is_eq() {
                continue;
            }
        }
        if i < last {
            runs.push((place.width, vec![place.at]));
        }
    }
    runs.into_iter().map(|(width, points)| Run::stroke(width, points)).collect()
}

/// Counts as lost what of a line is not in its pieces.
fn tell_lost(line: &Line, pieces: &[Line], area: MmRect, drawn: &mut Lines) {
    let (whole, left): (f32, f32) = (line.length(), pieces.iter().map(Line::length).sum());
    let (extent, lost) = (extent(line), &mut drawn.lost);
    lost.lost += (whole - left).max(0.0);
    lost.by_place[ninth(extent.center(), area)] += (whole - left).max(0.0);
    if pieces.is_empty() {
        let closed = is_ring(line);
        lost.rings += usize::from(closed);
        lost.gone.push(LostLine { extent, length: whole, closed, is_faint: false });
    }
}

#[cfg(test)]
mod tests;
