//! Empty dots between two lines: what is left of a lighter line where it comes too near to a weightier one, or to itself.
//!
//! Lines come with their distance in millimetres; rounding to a grid can take up to a step off it. Lines that meet stay
//! together: an end that touches another line may come as near as it must.

use std::collections::BTreeMap;

use super::cells::{Cell, apart, centre, within};
use super::{Params, dotted, thick, trace, walk, way};
use crate::devices::Grid;
use crate::lines::Line;
use crate::units::{MmPoint, MmRect};

/// Fewer dots than this are no line.
const LEAST_DOTS: usize = 3;

/// Lines on a grid, the weightiest first.
pub(super) fn on_grid(lines: &[Line], area: MmRect, grid: &Grid, params: &Params) -> Vec<Line> {
    let [[left, right], [top, bottom]] = within(area, grid);
    if left > right || top > bottom {
        return Vec::new();
    }
    let gap = params.line_gap as i32;
    let least = LEAST_DOTS.max((params.min_length / params.pitch).floor() as usize);
    let mut taken = Taken { lines: BTreeMap::new(), gap };
    let mut out = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        let (points, closed) = way(line);
        let mut cells: Vec<Cell> = trace::trace(&points, closed, grid);
        cells.iter_mut().for_each(|cell| *cell = [cell[0].clamp(left, right), cell[1].clamp(top, bottom)]);
        cells.dedup();
        // ends that have become neighbours on the grid close the line
        let ends = cells.first().zip(cells.last()).filter(|_| cells.len() > 2 * LEAST_DOTS);
        let closed = closed || ends.is_some_and(|(&first, &last)| apart(first, last) <= 1);
        let cells = trace::thin(cells, closed);
        let is_wide = params.is_wide(line);
        let mut drawn = Vec::new();
        for piece in taken.pieces(&cells, closed, is_wide) {
            if piece.cells.len() < least {
                continue;
            }
            let mut rows = vec![piece.cells.clone()];
            if is_wide {
                let mut second = thick::beside(&piece.cells, piece.closed);
                second.retain(|&cell| {
                    (left..=right).contains(&cell[0]) && (top..=bottom).contains(&cell[1]) && !taken.is_near(cell)
                });
                rows.push(second);
            }
            drawn.push(rows);
        }
        for mut rows in drawn {
            // what the line itself has there already
            rows[1..].iter_mut().for_each(|row| row.retain(|cell| !taken.lines.contains_key(cell)));
            rows.iter().flatten().for_each(|&cell| taken.take(cell, number));
            let run = |cells: &Vec<Cell>| {
                dotted(cells.iter().map(|&cell| centre(cell, grid)).collect(), params.height(line), params)
            };
            let runs = rows.iter().filter(|row| !row.is_empty()).map(run).collect();
            out.push(Line { strength: line.strength, runs });
        }
    }
    out
}

/// A stretch of a line that is far enough from all others.
struct Piece {
    cells: Vec<Cell>,
    closed: bool,
}

/// Dots of lines, each with the number of its line.
struct Taken {
    lines: BTreeMap<Cell, usize>,
    gap: i32,
}

impl Taken {
    fn take(&mut self, cell: Cell, line: usize) {
        self.lines.entry(cell).or_insert(line);
    }

    /// Steps to the nearest dot of another line; none beyond the gap.
    fn distance(&self, cell: Cell) -> Option<i32> {
        let around = (-self.gap..=self.gap).flat_map(|dy| (-self.gap..=self.gap).map(move |dx| [dx, dy]));
        let near = around.map(|[dx, dy]| [cell[0] + dx, cell[1] + dy]).filter(|near| self.lines.contains_key(near));
        near.map(|near| apart(near, cell)).min()
    }

    fn is_near(&self, cell: Cell) -> bool {
        self.distance(cell).is_some()
    }

    /// How near each dot of a line is to other lines, and to the parts of its own that came long before.
    fn distances(&self, cells: &[Cell], closed: bool, is_wide: bool) -> Vec<Option<i32>> {
        // At a right angle both arms are this near for so long.
        let long = (4 * self.gap + 4) as usize;
        let n = cells.len();
        let mut own: BTreeMap<Cell, usize> = BTreeMap::new();
        let mut out = Vec::with_capacity(n);
        for (i, &cell) in cells.iter().enumerate() {
            let around = (-self.gap..=self.gap).flat_map(|dy| (-self.gap..=self.gap).map(move |dx| [dx, dy]));
            let of_own = around
                .map(|[dx, dy]| [cell[0] + dx, cell[1] + dy])
                .filter(|&near| {
                    let far = |j: usize| i - j > long && (!closed || n - (i - j) > long);
                    own.get(&near).is_some_and(|&j| near == cell || far(j))
                })
                .map(|near| apart(near, cell))
                .min();
            let mut of_others = self.distance(cell);
            if is_wide {
                let second = [[cell[0] + 1, cell[1]], [cell[0], cell[1] + 1]];
                of_others = second.into_iter().filter_map(|cell| self.distance(cell)).chain(of_others).min();
            }
            out.push(of_own.into_iter().chain(of_others).min());
            own.insert(cell, i);
        }
        out
    }

    /// What is left of a line.
    fn pieces(&self, cells: &[Cell], closed: bool, is_wide: bool) -> Vec<Piece> {
        let mut distances = self.distances(cells, closed, is_wide);
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
    /// allowed the way out of its neighbourhood. A line that runs along the other is not.
    fn allow_meeting(&self, cells: &mut Vec<Cell>, distances: &mut Vec<Option<i32>>) {
        let near = distances.iter().take_while(|distance| distance.is_some()).count();
        let touches = distances[..near].iter().rposition(|distance| distance.is_some_and(|steps| steps <= 1));
        let Some(last) = touches else { return };
        if near - last > (2 * self.gap + 2) as usize || last > (2 * self.gap + 2) as usize {
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
/// What rounding may take off a place, mm.
const SAME: f32 = 1e-3;

/// Lines in `area` whose dots can be anywhere, the weightiest first. They keep their distance already; only where they meet, dots would
/// fall on dots.
pub(super) fn anywhere(lines: &[Line], area: MmRect, params: &Params) -> Vec<Line> {
    let area = area.inflate(SAME, SAME);
    let mut placed = Placed { squares: BTreeMap::new(), least: LEAST_STEP * params.pitch };
    let mut out = Vec::new();
    for line in lines {
        let (points, closed) = way(line);
        let dots = walk::along(&points, closed, params.pitch);
        let rows = match params.is_wide(line) {
            true => thick::both_sides(&dots, closed, params.pitch).into(),
            false => vec![dots],
        };
        let free = |row: Vec<MmPoint>, placed: &mut Placed| {
            row.into_iter().filter(|&at| area.contains_inclusive(at) && placed.place(at)).collect()
        };
        let rows: Vec<Vec<MmPoint>> = rows.into_iter().map(|row| free(row, &mut placed)).collect();
        let runs = rows.into_iter().filter(|row| !row.is_empty());
        let runs: Vec<_> = runs.map(|row| dotted(row, params.height(line), params)).collect();
        if runs.iter().any(|run| run.points.len() >= LEAST_DOTS) {
            out.push(Line { strength: line.strength, runs });
        }
    }
    out
}

/// Dots by the square that they lie in.
struct Placed {
    squares: BTreeMap<[i32; 2], Vec<MmPoint>>,
    least: f32,
}

impl Placed {
    /// Places a dot if there is room for it.
    fn place(&mut self, at: MmPoint) -> bool {
        let [x, y] = [at.x, at.y].map(|mm| (mm / self.least).floor() as i32);
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy]));
        let mut near = around.filter_map(|square| self.squares.get(&square)).flatten();
        let free = near.all(|other| (*other - at).length() >= self.least);
        if free {
            self.squares.entry([x, y]).or_default().push(at);
        }
        free
    }
}
