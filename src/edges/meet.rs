//! Junctions: a contour that ends just before another is led on to it.
//!
//! Where three edges meet the gradient has no one direction, and the weakest of them is found only up to a blur or two
//! before the others.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::path::{Flank, Mark, Path};
use crate::units::{PxPoint, PxVector, Size};

/// Farthest way that an end is led on, in blurs.
const REACH: f32 = 3.5;
/// The last part of a contour before a junction is bent by the other contours: this much of it, in blurs, is laid anew.
const BENT: f32 = 1.3;
/// Its direction is taken over this much before that, in blurs.
const FLANK: f32 = 4.0;
/// Side of the cells by which marks are found, px.
const CELL: f32 = 8.0;

/// Leads open ends on to the contours they point at.
pub(super) fn lead_on(paths: &mut [Path], size: Size) {
    let grid = Grid::new(paths, size);
    let ends = |number: usize| {
        let end = |at_start| meeting(paths, &grid, number, at_start).map(|(flank, at)| (number, at_start, flank, at));
        [true, false].map(end).into_iter().flatten()
    };
    let open =
        (0..paths.len()).into_par_iter().filter(|&number| !paths[number].closed && paths[number].marks.len() > 3);
    let wanted: Vec<_> = open.flat_map_iter(ends).collect();
    for (number, at_start, flank, at) in wanted {
        lay(&mut paths[number], at_start, &flank, at);
    }
}

/// Where an end meets another contour if it goes straight on, and the line it follows.
fn meeting(paths: &[Path], grid: &Grid, number: usize, at_start: bool) -> Option<(Flank, PxPoint)> {
    let path = &paths[number];
    let tip = if at_start { 0 } else { path.marks.len() - 1 };
    let Mark { at: end, blur, .. } = path.marks[tip];
    let flank = path
        .flank(tip, at_start, BENT * blur, (BENT + FLANK) * blur)
        .or_else(|| path.flank(tip, at_start, 0.0, FLANK * blur))?;
    let ahead = -flank.along; // flanks are directed away from the tip
    let from = flank.nearest(end) - ahead * (BENT * blur);
    let reach = (REACH + BENT) * blur;
    let own = |k: usize| path.walk(tip, at_start).take_while(|(_, way)| *way < 3.0 * reach).any(|(mark, _)| mark == k);
    let mut nearest: Option<f32> = None;
    grid.around(end, reach, |other, k| {
        let Some(next) = paths[other].next(k, 1) else { return };
        if other == number && (own(k) || own(next)) {
            return;
        }
        let (a, b) = (paths[other].marks[k].at, paths[other].marks[next].at);
        if let Some(way) = crossing(from, ahead, a, b)
            && way <= reach
            && nearest.is_none_or(|least| way < least)
        {
            nearest = Some(way);
        }
    });
    nearest.map(|way| (flank, from + ahead * way))
}

/// How far along the ray it crosses the segment.
fn crossing(from: PxPoint, ahead: PxVector, a: PxPoint, b: PxPoint) -> Option<f32> {
    let side = b - a;
    let sine = ahead.cross(side);
    if sine.abs() < 0.25 * side.length() {
        return None; // nearly parallel: a neighbour, no junction
    }
    let between = a - from;
    let (way, share) = (between.cross(side) / sine, between.cross(ahead) / sine);
    (way >= 0.0 && (-0.05..=1.05).contains(&share)).then_some(way)
}

/// Lays the last marks of a path on its flank, up to the place where it meets the other.
fn lay(path: &mut Path, at_start: bool, flank: &Flank, at: PxPoint) {
    if !at_start {
        path.reverse();
    }
    let blur = path.marks[0].blur;
    let bent = path.walk(0, true).take_while(|(_, way)| *way < BENT * blur).count();
    let mut first = path.marks[0];
    first.at = at;
    for mark in &mut path.marks[..bent] {
        mark.at = flank.nearest(mark.at);
    }
    let beyond = |mark: &Mark| flank.along.dot(mark.at - at) <= 0.2;
    let over = path.marks.iter().take_while(|mark| beyond(mark)).count().min(bent);
    path.marks.splice(..over, [first]);
    if !at_start {
        path.reverse();
    }
}

/// Marks by the cell they lie in.
struct Grid {
    columns: usize,
    starts: Vec<u32>,
    marks: Vec<(u32, u32)>,
}

impl Grid {
    fn new(paths: &[Path], size: Size) -> Self {
        let cells = |pixels: u32| (pixels as f32 / CELL) as usize + 1;
        let (columns, rows) = (cells(size.width), cells(size.height));
        let place = |at: PxPoint| {
            let index = |v: f32, n: usize| ((v / CELL).max(0.0) as usize).min(n - 1);
            index(at.y, rows) * columns + index(at.x, columns)
        };
        let all = || {
            let marks = paths.iter().enumerate();
            marks.flat_map(|(number, path)| path.marks.iter().enumerate().map(move |(k, mark)| (number, k, mark.at)))
        };
        let mut starts = vec![0_u32; columns * rows + 1];
        all().for_each(|(.., at)| starts[place(at) + 1] += 1);
        for cell in 0..columns * rows {
            starts[cell + 1] += starts[cell];
        }
        let mut next = starts.clone();
        let mut marks = vec![(0, 0); starts[columns * rows] as usize];
        for (number, k, at) in all() {
            let slot = &mut next[place(at)];
            marks[*slot as usize] = (number as u32, k as u32);
            *slot += 1;
        }
        Self { columns, starts, marks }
    }

    /// Calls `visit` with path and number of every mark within `reach` pixels, and some farther ones.
    fn around(&self, at: PxPoint, reach: f32, mut visit: impl FnMut(usize, usize)) {
        let rows = (self.starts.len() - 1) / self.columns;
        let range = |v: f32, n: usize| {
            let index = |v: f32| ((v / CELL).max(0.0) as usize).min(n - 1);
            index(v - reach)..index(v + reach) + 1
        };
        for row in range(at.y, rows) {
            for column in range(at.x, self.columns) {
                let cell = row * self.columns + column;
                for &(path, mark) in &self.marks[self.starts[cell] as usize..self.starts[cell + 1] as usize] {
                    visit(path as usize, mark as usize);
                }
            }
        }
    }
}
