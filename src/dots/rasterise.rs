//! The dots of a line on a grid: one dot wide, each an 8-neighbour of the next.
//!
//! Wherever the line crosses the middle of a column or of a row, the dot nearest to it is taken. On a straight line
//! that is one dot a column where it is flat, one a row where it is steep: Bresenham's line, and no dot lies further
//! than half a step along an axis from the line, except at its ends and where the line wavers. Where a line bends, a
//! dot may be superfluous, since its two neighbours touch each other:
//!
//! ```text
//!   # #  .        # .  .        # # #        the last is a corner of the line itself, with two
//!   . # #    ->   . #  #        . . #        steps straight to and from it, and stays
//!                               . . #
//! ```
//!
//! A sharp corner keeps its dot, though the dots on both sides of it touch, as other lines may end there. One that is
//! sharper still would be a clot of dots. The corner of a box or a bar gets its dot wherever it lies: its sides may end
//! just before the middles of the column and the row that meet there.

use std::ops::RangeInclusive;

use lyon::geom::euclid::{Point2D, UnknownUnit};

use super::grid_dot::{GridDot, GridPoint, distance, nearest, to_grid};
use crate::devices::Grid;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::units::MmPoint;

/// The dots of a line.
#[derive(Debug)]
pub(super) struct Rasterised {
    /// In the order of the line. The last dot of a closed one is a neighbour of the first.
    pub(super) cells: Vec<GridDot>,
    /// Those at its sharp corners.
    pub(super) sharp: Vec<GridDot>,
}

/// The dots along a line.
pub(super) fn rasterise(line: PolylineRef<'_, MmPoint>, grid: &Grid) -> Rasterised {
    let closed = line.closed;
    let points: Vec<GridPoint> = line.path().map(|&at| to_grid(at, grid)).collect();
    let in_steps = in_steps(line, grid);
    let sharp = sharp_corners(&in_steps);
    let mut cells = Vec::new();
    if !closed {
        cells.extend(points.first().map(|&at| nearest(at)));
    }
    for (i, pair) in points.windows(2).enumerate() {
        crossed(pair[0], pair[1], &mut cells);
        let is_of_box = is_of_box(&in_steps, (i + 1) % in_steps.vertices.len());
        cells.extend(Some(nearest(pair[1])).filter(|corner| is_of_box || sharp.contains(corner)));
    }
    if !closed {
        cells.extend(points.last().map(|&at| nearest(at)));
    }
    if cells.is_empty() {
        // a ring so small that it crosses the middle of no column or row
        cells.extend(points.first().map(|&at| nearest(at)));
    }
    cells.dedup();
    let cells = smooth(thin(connected(cells, closed), closed, &sharp), closed, &sharp);
    Rasterised { cells, sharp }
}

/// The sides of a box are at least so many steps long, and this share of that off level or upright, at most.
const SIDE_OF_BOX: f32 = 2.0;
const OFF_LEVEL: f32 = 0.1;

/// It turns there at once, by 45 degrees at least (the cosine between its sides): a rounded corner is none.
const AT_ONCE: f32 = -0.707;

/// A line in steps of the grid.
type LineInSteps = Polyline<Point2D<f32, UnknownUnit>>;

fn in_steps(line: PolylineRef<'_, MmPoint>, grid: &Grid) -> LineInSteps {
    let vertices = line.vertices.iter().map(|&at| to_grid(at, grid).into()).collect();
    Polyline { vertices, closed: line.closed }
}

/// Whether a vertex of a line is a corner between a level side and an upright one. A side may have been found in parts
/// that lie a little aside of one another, and have a vertex there.
fn is_of_box(line: &LineInSteps, corner: usize) -> bool {
    let way = |forwards: bool, least: f32| {
        let others = line.walk(corner, forwards).skip(1);
        let mut ways = others.map(|(vertex, _)| line.vertices[vertex] - line.vertices[corner]);
        ways.find(|way| way.length() > 0.0 && way.length() >= least)
    };
    let is_along = |[along, across]: [f32; 2]| along.abs() >= SIDE_OF_BOX && across.abs() <= OFF_LEVEL * along.abs();
    let beside = way(true, 0.0).zip(way(false, 0.0));
    let turns = beside.is_some_and(|(on, back)| on.normalize().dot(back.normalize()) >= AT_ONCE);
    let sides = || way(true, SIDE_OF_BOX).zip(way(false, SIDE_OF_BOX));
    turns
        && sides().is_some_and(|(on, back)| {
            is_along([on.x, on.y]) && is_along([back.y, back.x]) || is_along([on.y, on.x]) && is_along([back.x, back.y])
        })
}

/// The sides of a corner are taken over so many steps of the grid.
const SIDE: f32 = 3.0;
/// A side is straight if its chord is at least this share of it.
const STRAIGHT: f32 = 0.95;
/// Cosines between the sides of such corners, from 80 degrees, as at a right angle no dots touch but its own, down to
/// 50, where its sides are two dots apart after three.
const SHARP: RangeInclusive<f32> = 0.17..=0.64;

/// The dots at the sharp corners of a line.
fn sharp_corners(line: &LineInSteps) -> Vec<GridDot> {
    let side = |i: usize, forwards: bool| {
        let at = line.vertices[i];
        let chord = |to: usize| line.vertices[to] - at;
        let (to, arc) = line.walk(i, forwards).find(|(to, _)| chord(*to).length() >= SIDE)?;
        (chord(to).length() >= STRAIGHT * arc).then(|| chord(to).normalize())
    };
    let is_sharp = |i: &usize| {
        let sides = side(*i, true).zip(side(*i, false));
        sides.is_some_and(|(on, back)| SHARP.contains(&on.dot(back)))
    };
    (0..line.vertices.len()).filter(is_sharp).map(|i| nearest(line.vertices[i].into())).collect()
}

/// Moves single dots back into their row: where a line runs midway between two rows, noise moves dots from one to the
/// other.
///
/// ```text
///   . . # . .        . . . . .
///   # # . # #   ->   # # # # #
/// ```
fn smooth(mut cells: Vec<GridDot>, closed: bool, sharp: &[GridDot]) -> Vec<GridDot> {
    let n = cells.len();
    if n < 5 {
        return cells;
    }
    let range = if closed { 0..n } else { 1..n - 1 };
    for i in range {
        if sharp.contains(&cells[i]) {
            continue;
        }
        let (before, after) = (cells[(i + n - 1) % n], cells[(i + 1) % n]);
        for axis in 0..2 {
            let same_row = before[1 - axis] == after[1 - axis];
            if same_row && (after[axis] - before[axis]).abs() == 2 && cells[i][1 - axis] != before[1 - axis] {
                cells[i][1 - axis] = before[1 - axis];
            }
        }
    }
    cells
}

/// The dots nearest to where a straight piece crosses the middles of columns and rows, in order along it.
fn crossed(a: GridPoint, b: GridPoint, cells: &mut Vec<GridDot>) {
    let mut crossings: Vec<(f32, GridDot)> = Vec::new();
    for axis in 0..2 {
        let (from, to) = (a[axis], b[axis]);
        let (low, high) = (from.min(to), from.max(to));
        for middle in low.ceil() as i32..=high.floor() as i32 {
            let share = if high > low { (middle as f32 - from) / (to - from) } else { 0.0 };
            let across = a[1 - axis] + (b[1 - axis] - a[1 - axis]) * share;
            let mut at = [0.0; 2];
            (at[axis], at[1 - axis]) = (middle as f32, across);
            crossings.push((share, nearest(at)));
        }
    }
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    cells.extend(crossings.into_iter().map(|(_, cell)| cell));
}

/// The same dots with those between that make each a neighbour of the next.
fn connected(cells: Vec<GridDot>, closed: bool) -> Vec<GridDot> {
    let first = cells.first().copied();
    let mut out: Vec<GridDot> = Vec::with_capacity(cells.len());
    let end = first.filter(|_| closed && cells.len() > 1);
    for cell in cells.into_iter().chain(end) {
        if let Some(&last) = out.last() {
            out.extend(between(last, cell));
        }
        out.push(cell);
    }
    if end.is_some() {
        out.pop();
    }
    out.dedup();
    out
}

/// A line that returns to itself within this many dots makes a clot, not a shape; the smallest ring around an empty
/// dot has eight.
const CURL: usize = 7;

/// The dots between two, each a neighbour of the next.
pub(super) fn between(a: GridDot, b: GridDot) -> impl Iterator<Item = GridDot> {
    let steps = distance(a, b);
    (1..steps).map(move |step| {
        let share = step as f32 / steps as f32;
        nearest([0, 1].map(|axis| a[axis] as f32 + (b[axis] - a[axis]) as f32 * share))
    })
}

/// Removes dots whose two neighbours touch each other, except true corners and sharp ones.
pub(super) fn thin(mut cells: Vec<GridDot>, closed: bool, sharp: &[GridDot]) -> Vec<GridDot> {
    loop {
        let before = cells.len();
        let mut out: Vec<GridDot> = Vec::with_capacity(before);
        let ahead = |i: usize| match closed {
            true => cells.get(i % before.max(1)),
            false => cells.get(i),
        };
        for (i, &cell) in cells.iter().enumerate() {
            // a curl: the line returns to where it was a few dots ago
            let recent = out.len().saturating_sub(CURL)..out.len().saturating_sub(2);
            let has_sharp = |j: usize| out[j + 1..].iter().any(|cell| sharp.contains(cell));
            if let Some(j) = recent.into_iter().find(|&j| distance(out[j], cell) <= 1 && !has_sharp(j)) {
                out.truncate(j + 1);
            }
            while let [.., a, b] = out[..]
                && distance(a, cell) <= 1
                && !sharp.contains(&b)
                && !is_corner(out.len().checked_sub(3).map(|i| out[i]), a, b, cell, ahead(i + 1).copied())
            {
                out.pop();
            }
            if out.last() != Some(&cell) {
                out.push(cell);
            }
        }
        if closed {
            // across the seam: the last dot, then the first
            while let [first, second, .., a, b] = out[..]
                && out.len() > 4
                && (b == first
                    || distance(a, first) <= 1
                        && !sharp.contains(&b)
                        && !is_corner(out.len().checked_sub(3).map(|i| out[i]), a, b, first, Some(second)))
            {
                out.pop();
            }
            if let [first, second, .., last] = out[..]
                && out.len() > 4
                && distance(last, second) <= 1
                && !sharp.contains(&first)
                && !is_corner(out.get(out.len() - 2).copied(), last, first, second, out.get(2).copied())
            {
                out.remove(0);
            }
        }
        cells = out;
        if cells.len() == before {
            return cells;
        }
    }
}

/// Whether `b` is a right angle of the line: two steps straight to it and two straight from it, along the axes.
fn is_corner(before: Option<GridDot>, a: GridDot, b: GridDot, c: GridDot, after: Option<GridDot>) -> bool {
    let (Some(before), Some(after)) = (before, after) else { return false };
    let step = |from: GridDot, to: GridDot| [to[0] - from[0], to[1] - from[1]];
    let (to, from) = (step(a, b), step(b, c));
    let is_straight = |step: [i32; 2]| step[0].abs() + step[1].abs() == 1;
    is_straight(to)
        && is_straight(from)
        && to[0] * from[0] + to[1] * from[1] == 0
        && step(before, a) == to
        && step(c, after) == from
}

#[cfg(test)]
mod tests;
