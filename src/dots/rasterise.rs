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

use super::cell::{Cell, GridPoint, distance, nearest, to_grid};
use crate::devices::Grid;
use crate::geom::polyline::PolylineRef;
use crate::units::MmPoint;

/// The dots along a line, in its order. The last dot of a closed line is a neighbour of the first.
pub(super) fn rasterise(line: PolylineRef<'_, MmPoint>, grid: &Grid) -> Vec<Cell> {
    let closed = line.closed;
    let points: Vec<GridPoint> = line.path().map(|&at| to_grid(at, grid)).collect();
    let mut cells = Vec::new();
    if !closed {
        cells.extend(points.first().map(|&at| nearest(at)));
    }
    for pair in points.windows(2) {
        crossed(pair[0], pair[1], &mut cells);
    }
    if !closed {
        cells.extend(points.last().map(|&at| nearest(at)));
    }
    if cells.is_empty() {
        // a ring so small that it crosses the middle of no column or row
        cells.extend(points.first().map(|&at| nearest(at)));
    }
    cells.dedup();
    smooth(thin(connected(cells, closed), closed), closed)
}

/// Moves single dots back into their row: where a line runs midway between two rows, noise moves dots from one to the
/// other.
///
/// ```text
///   . . # . .        . . . . .
///   # # . # #   ->   # # # # #
/// ```
fn smooth(mut cells: Vec<Cell>, closed: bool) -> Vec<Cell> {
    let n = cells.len();
    if n < 5 {
        return cells;
    }
    let range = if closed { 0..n } else { 1..n - 1 };
    for i in range {
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
fn crossed(a: GridPoint, b: GridPoint, cells: &mut Vec<Cell>) {
    let mut crossings: Vec<(f32, Cell)> = Vec::new();
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
fn connected(cells: Vec<Cell>, closed: bool) -> Vec<Cell> {
    let first = cells.first().copied();
    let mut out: Vec<Cell> = Vec::with_capacity(cells.len());
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
pub(super) fn between(a: Cell, b: Cell) -> impl Iterator<Item = Cell> {
    let steps = distance(a, b);
    (1..steps).map(move |step| {
        let share = step as f32 / steps as f32;
        nearest([0, 1].map(|axis| a[axis] as f32 + (b[axis] - a[axis]) as f32 * share))
    })
}

/// Removes dots whose two neighbours touch each other, except true corners.
pub(super) fn thin(mut cells: Vec<Cell>, closed: bool) -> Vec<Cell> {
    loop {
        let before = cells.len();
        let mut out: Vec<Cell> = Vec::with_capacity(before);
        let ahead = |i: usize| match closed {
            true => cells.get(i % before.max(1)),
            false => cells.get(i),
        };
        for (i, &cell) in cells.iter().enumerate() {
            // a curl: the line returns to where it was a few dots ago
            let recent = out.len().saturating_sub(CURL)..out.len().saturating_sub(2);
            if let Some(j) = recent.into_iter().find(|&j| distance(out[j], cell) <= 1) {
                out.truncate(j + 1);
            }
            while let [.., a, b] = out[..]
                && distance(a, cell) <= 1
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
                        && !is_corner(out.len().checked_sub(3).map(|i| out[i]), a, b, first, Some(second)))
            {
                out.pop();
            }
            if let [first, second, .., last] = out[..]
                && out.len() > 4
                && distance(last, second) <= 1
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
fn is_corner(before: Option<Cell>, a: Cell, b: Cell, c: Cell, after: Option<Cell>) -> bool {
    let (Some(before), Some(after)) = (before, after) else { return false };
    let step = |from: Cell, to: Cell| [to[0] - from[0], to[1] - from[1]];
    let (to, from) = (step(a, b), step(b, c));
    let is_straight = |step: [i32; 2]| step[0].abs() + step[1].abs() == 1;
    is_straight(to)
        && is_straight(from)
        && to[0] * from[0] + to[1] * from[1] == 0
        && step(before, a) == to
        && step(c, after) == from
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::polyline::Polyline;

    fn grid() -> Grid {
        let even = |count: usize| (0..count).map(|i| 2.5 * i as f32).collect();
        Grid { columns: even(60), rows: even(60) }
    }

    fn at(x: f32, y: f32) -> MmPoint {
        MmPoint::new(2.5 * x, 2.5 * y)
    }

    fn ring(radius: f32, x: f32, y: f32) -> Vec<MmPoint> {
        let angle = |i: i32| (i % 180) as f32 * std::f32::consts::TAU / 180.0;
        (0..=180).map(|i| at(x + radius * angle(i).cos(), y + radius * angle(i).sin())).collect()
    }

    /// Each dot is a neighbour of the next and of no other than those before and after it.
    fn is_one_dot_wide(cells: &[Cell], closed: bool) -> bool {
        let n = cells.len();
        (0..n).all(|i| {
            (0..i).all(|j| {
                let steps = if closed { (i - j).min(n - (i - j)) } else { i - j };
                (distance(cells[i], cells[j]) <= 1) == (steps == 1)
            })
        })
    }

    #[test]
    fn straight_lines_at_any_angle_are_one_dot_wide_and_near_the_line() {
        for degrees in 0..360 {
            let (sin, cos) = (degrees as f32).to_radians().sin_cos();
            for (x, y) in [(30.0, 30.0), (30.3, 29.6), (30.5, 30.5)] {
                let end = [x + 20.0 * cos, y + 20.0 * sin];
                let cells = rasterise(Polyline::open(vec![at(x, y), at(end[0], end[1])]).view(), &grid());
                assert!(is_one_dot_wide(&cells, false), "{degrees}: {cells:?}");
                assert!(cells.len() >= 14 && cells.len() <= 22, "{degrees}: {}", cells.len());
                for cell in cells {
                    let aside = (cell[0] as f32 - x) * sin - (cell[1] as f32 - y) * cos;
                    assert!(aside.abs() <= 0.72, "{degrees}: {cell:?} lies {aside} steps aside");
                }
            }
        }
    }

    #[test]
    fn rings_close_and_are_one_dot_wide() {
        for tenth in 25..200 {
            for (x, y) in [(30.0, 30.0), (29.7, 30.2), (30.5, 30.5)] {
                let radius = tenth as f32 / 10.0;
                let cells = rasterise(Polyline::from_path(ring(radius, x, y)).view(), &grid());
                assert!(is_one_dot_wide(&cells, true), "radius {radius}: {cells:?}");
                for cell in &cells {
                    let off = (cell[0] as f32 - x).hypot(cell[1] as f32 - y) - radius;
                    assert!(off.abs() < 0.75, "radius {radius}: {cell:?} lies {off} steps off");
                }
            }
        }
    }

    #[test]
    fn a_rectangle_keeps_its_corners() {
        let points = [at(10.0, 10.0), at(20.2, 10.0), at(20.2, 16.4), at(10.0, 16.4), at(10.0, 10.0)];
        let cells = rasterise(Polyline::from_path(points.to_vec()).view(), &grid());
        for corner in [[20, 10], [20, 16], [10, 16]] {
            assert!(cells.contains(&corner), "{corner:?} is not in {cells:?}");
        }
        assert_eq!(cells.len(), 32);
    }
}
