//! Empty dots between two lines: what is left of a lighter line where it comes too near to a weightier one, or to itself.
//!
//! Lines come with their distance in millimetres; rounding to a grid can take up to a step off it. Lines that meet stay
//! together: an end that touches another line may come as near as it must.

use std::collections::BTreeMap;

use super::cells::{Cell, apart, centre, within};
use super::{Params, dotted, thick, trace, walk, way};
use crate::devices::Grid;
use crate::geom::polyline;
use crate::lines::Line;
use crate::units::{MmPoint, MmRect};

/// Fewer dots than this are no line, and no piece of a second row.
const LEAST_DOTS: usize = 3;

/// Lines on a grid, the weightiest first.
pub(super) fn on_grid(lines: &[Line], area: MmRect, grid: &Grid, params: &Params) -> Vec<Line> {
    let [[left, right], [top, bottom]] = within(area, grid);
    if left > right || top > bottom {
        return Vec::new();
    }
    let mut taken = Taken { lines: BTreeMap::new(), gap: params.line_gap as i32 };
    let mut drawn: Vec<(&Line, Piece)> = Vec::new();
    for line in lines {
        let (points, closed) = way(line);
        let mut cells: Vec<Cell> = trace::trace(&points, closed, grid);
        cells.iter_mut().for_each(|cell| *cell = [cell[0].clamp(left, right), cell[1].clamp(top, bottom)]);
        cells.dedup();
        // ends that have become neighbours on the grid close the line
        let ends = cells.first().zip(cells.last()).filter(|_| cells.len() > 2 * LEAST_DOTS);
        let closed = closed || ends.is_some_and(|(&first, &last)| apart(first, last) <= 1);
        let cells = trace::thin(cells, closed);
        let is_long = |piece: &Piece| {
            let length = polyline::length(&centres(&piece.cells, grid));
            piece.cells.len() >= LEAST_DOTS && length + SAME >= params.min_length
        };
        let pieces: Vec<Piece> = taken.pieces(&cells, closed).into_iter().filter(is_long).collect();
        for piece in pieces {
            piece.cells.iter().for_each(|&cell| taken.take(cell, drawn.len()));
            drawn.push((line, piece));
        }
    }
    // Second rows come last and only where there is room, so that no line is cut for the sake of another's width.
    let inside = |cell: Cell| (left..=right).contains(&cell[0]) && (top..=bottom).contains(&cell[1]);
    let mut out = Vec::with_capacity(drawn.len());
    for (number, (line, piece)) in drawn.iter().enumerate() {
        let mut rows = vec![piece.cells.clone()];
        if params.is_wide(line) {
            let second = taken.second_row(number, piece, inside);
            second.iter().for_each(|&cell| taken.take(cell, number));
            rows.push(second);
        }
        rows.retain(|row| !row.is_empty());
        let run = |row: &Vec<Cell>| dotted(centres(row, grid), params.height(line), params);
        out.push(Line { strength: line.strength, runs: rows.iter().map(run).collect() });
    }
    out
}

fn centres(cells: &[Cell], grid: &Grid) -> Vec<MmPoint> {
    cells.iter().map(|&cell| centre(cell, grid)).collect()
}

/// A stretch of a line that is far enough from all others.
struct Piece {
    cells: Vec<Cell>,
    closed: bool,
}

/// Dots of lines, each with the number of the piece that it belongs to.
struct Taken {
    lines: BTreeMap<Cell, usize>,
    gap: i32,
}

impl Taken {
    fn take(&mut self, cell: Cell, piece: usize) {
        self.lines.entry(cell).or_insert(piece);
    }

    /// The places from which a dot is nearer than the gap allows.
    fn around(&self, cell: Cell) -> impl Iterator<Item = Cell> + use<> {
        let gap = self.gap;
        (-gap..=gap).flat_map(move |dy| (-gap..=gap).map(move |dx| [cell[0] + dx, cell[1] + dy]))
    }

    /// Steps to the nearest dot of another line; none beyond the gap.
    fn distance(&self, cell: Cell) -> Option<i32> {
        self.around(cell).filter(|near| self.lines.contains_key(near)).map(|near| apart(near, cell)).min()
    }

    /// How many dots of a line further on it may come near itself again: at a right angle both arms are near for so long.
    fn long(&self) -> usize {
        (4 * self.gap + 4) as usize
    }

    /// How near each dot of a line is to other lines, and to the parts of its own that came long before.
    fn distances(&self, cells: &[Cell], closed: bool) -> Vec<Option<i32>> {
        let (n, long) = (cells.len(), self.long());
        let mut own: BTreeMap<Cell, usize> = BTreeMap::new();
        let mut out = Vec::with_capacity(n);
        for (i, &cell) in cells.iter().enumerate() {
            let far = |j: usize| i - j > long && (!closed || n - (i - j) > long);
            let is_own = |near: &Cell| own.get(near).is_some_and(|&j| *near == cell || far(j));
            let of_own = self.around(cell).filter(is_own).map(|near| apart(near, cell)).min();
            out.push(of_own.into_iter().chain(self.distance(cell)).min());
            own.insert(cell, i);
        }
        out
    }

    /// The second row of a piece, where it keeps the gap from all other lines and from what lies across the piece itself.
    fn second_row(&self, number: usize, piece: &Piece, inside: impl Fn(Cell) -> bool) -> Vec<Cell> {
        let (n, long) = (piece.cells.len(), self.long());
        // at which dots of the piece there is a dot of it, of either row
        let mut own: BTreeMap<Cell, usize> = piece.cells.iter().enumerate().map(|(i, &cell)| (cell, i)).collect();
        let mut row = thick::beside(&piece.cells, piece.closed);
        row.retain(|&(i, cell)| {
            let across = |j: usize| i.abs_diff(j) > long && (!piece.closed || n - i.abs_diff(j) > long);
            let is_free = |near: Cell| match (own.get(&near), self.lines.get(&near)) {
                (Some(&j), _) => !across(j),
                (None, other) => other.is_none_or(|&other| other == number),
            };
            let is_kept = inside(cell) && !self.lines.contains_key(&cell) && self.around(cell).all(is_free);
            if is_kept {
                own.insert(cell, i);
            }
            is_kept
        });
        thick::without_crumbs(row, LEAST_DOTS)
    }

    /// What is left of a line.
    fn pieces(&self, cells: &[Cell], closed: bool) -> Vec<Piece> {
        let mut distances = self.distances(cells, closed);
        if distances.iter().all(Option::is_none) {
            return vec![Piece { cells: cells.to_vec(), closed }];
        }
        let mut cells = cells.to_vec();
        if closed {
            // begun where it is too near, it is an open line
            let start = distances.iter().position(Option::is_some).unwrap_or(0);
            cells.rotate_left(start);
            distances.rotate_left(start);
        } else {
            self.allow_meeting(&mut cells, &mut distances);
            cells.reverse();
            distances.reverse();
            self.allow_meeting(&mut cells, &mut distances);
            cells.reverse();
            distances.reverse();
        }
        let stretches = distances.split(Option::is_some).scan(0, |at, stretch| {
            let from = *at;
            *at += stretch.len() + 1;
            Some(from..from + stretch.len())
        });
        stretches
            .filter(|range| !range.is_empty())
            .map(|range| Piece { cells: cells[range].to_vec(), closed: false })
            .collect()
    }

    /// A line whose first dots touch another line may begin there: dots on the other line go, but one beside it stays, and it is
    /// allowed the way out of its neighbourhood, two dots for each step away. A line that runs along the other is not.
    fn allow_meeting(&self, cells: &mut Vec<Cell>, distances: &mut Vec<Option<i32>>) {
        let near = distances.iter().take_while(|distance| distance.is_some()).count();
        let touches = distances[..near].iter().rposition(|distance| distance.is_some_and(|steps| steps <= 1));
        let Some(last) = touches else { return };
        if near - last > (2 * self.gap) as usize || last > (2 * self.gap + 2) as usize {
            return;
        }
        let skipped = if distances[last] == Some(0) { last + 1 } else { last };
        distances[..near].iter_mut().for_each(|distance| *distance = None);
        cells.drain(..skipped);
        distances.drain(..skipped);
    }
}

/// Dots nearer than this share of the pitch to one already there are left out: two needles' marks would run together.
const LEAST_STEP: f32 = 0.75;
/// What rounding may take off a length, mm.
const SAME: f32 = 1e-3;

/// Lines whose dots can be anywhere in `area`, the weightiest first. Their middles keep their distance already; where they meet, dots
/// would fall on dots. Second rows come last, where they keep the gap from all other lines.
pub(super) fn anywhere(lines: &[Line], area: MmRect, params: &Params) -> Vec<Line> {
    let area = area.inflate(SAME, SAME);
    let mut placed = Placed { squares: BTreeMap::new(), side: params.pitch };
    let mut drawn: Vec<(&Line, Vec<MmPoint>, bool)> = Vec::new();
    for line in lines {
        let (points, closed) = way(line);
        let mut dots = walk::along(&points, closed, params.pitch);
        let own = drawn.len();
        let least = LEAST_STEP * params.pitch;
        dots.retain(|&at| area.contains_inclusive(at) && placed.is_free(at, least, |_| true));
        if dots.len() >= LEAST_DOTS && polyline::length(&dots) + params.pitch >= params.min_length {
            // a line may come near itself at a corner
            dots.retain(|&at| {
                let is_free = placed.is_free(at, least, |_| true);
                is_free.then(|| placed.place(at, own)).is_some()
            });
            drawn.push((line, dots, closed));
        }
    }
    let mut out = Vec::with_capacity(drawn.len());
    for (own, (line, dots, closed)) in drawn.iter().enumerate() {
        let mut rows = vec![dots.clone()];
        if params.is_wide(line) && dots.len() >= LEAST_DOTS {
            let gap = (params.line_gap + 1) as f32 * params.pitch - SAME;
            let mut second = Vec::new();
            for (_, at) in thick::beside_anywhere(dots, *closed, params.pitch) {
                let is_free = placed.is_free(at, LEAST_STEP * params.pitch, |_| true);
                if area.contains_inclusive(at) && is_free && placed.is_free(at, gap, |piece| piece != own) {
                    placed.place(at, own);
                    second.push(at);
                }
            }
            if second.len() >= LEAST_DOTS {
                rows.push(second);
            }
        }
        let runs = rows.into_iter().map(|row| dotted(row, params.height(line), params)).collect();
        out.push(Line { strength: line.strength, runs });
    }
    out
}

/// Dots by the square that they lie in, each with the number of its line.
struct Placed {
    squares: BTreeMap<[i32; 2], Vec<(MmPoint, usize)>>,
    /// Side of the squares, mm.
    side: f32,
}

impl Placed {
    fn square(&self, at: MmPoint) -> [i32; 2] {
        [at.x, at.y].map(|mm| (mm / self.side).floor() as i32)
    }

    fn place(&mut self, at: MmPoint, line: usize) {
        self.squares.entry(self.square(at)).or_default().push((at, line));
    }

    /// Whether no dot of the lines that matter is nearer than `gap` mm.
    fn is_free(&self, at: MmPoint, gap: f32, matters: impl Fn(usize) -> bool) -> bool {
        let [x, y] = self.square(at);
        let reach = (gap / self.side).ceil() as i32;
        let around = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| [x + dx, y + dy]));
        let mut near = around.filter_map(|square| self.squares.get(&square)).flatten();
        near.all(|&(other, line)| !matters(line) || (other - at).length() >= gap)
    }
}
