//! Empty dots between the lines on a grid: what is left of a weaker line where it comes too near to a stronger one,
//! or to itself.
//!
//! Lines come with their distance in millimetres; rounding to a grid can take up to a step off it. Lines that join stay
//! together: an end that touches another line may come nearer than the gap.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::order::order;
use crate::devices::Grid;
use crate::dots::grid_dot::{GridBox, GridDot, centre, distance, nearest, to_grid};
use crate::dots::marks::{self, Lattice, Placed, Row, Shown};
use crate::dots::params::{LEAST_DOTS, Params, ROUNDED_OFF, polyline_of};
use crate::dots::rasterise::{self, Rasterised};
use crate::geom::polyline;
use crate::lines::{Line, LineMarks, which_are_weak};
use crate::units::{MmPoint, MmRect, MmVector};

/// Lines on a grid, the strongest first.
pub(in crate::dots) fn on_grid(
    lines: &[Line],
    marks: &LineMarks,
    part: MmRect,
    grid: &Grid,
    params: &Params,
) -> (Vec<Line>, Shown) {
    let within = GridBox::within(part, grid);
    if within.is_empty() {
        return (Vec::new(), Shown::none_of(marks));
    }
    let mut taken = OccupiedDots::new(params.line_gap as i32);
    let mut drawn: Vec<DrawnPiece> = Vec::new();
    let weak = which_are_weak(lines, params.least_strength);
    for line in order(lines, &weak, part, params.centres()) {
        let (cells, closed) = cells_of(&lines[line], grid, within);
        let is_long = |piece: &RowPiece| {
            let length = polyline::length(&centres(&piece.cells, grid));
            let through = params.pitch * piece.through.saturating_sub(1) as f32;
            let is_long = length.max(through) + ROUNDED_OFF >= params.min_length || piece.is_link;
            is_long && piece.cells.len() >= LEAST_DOTS
        };
        for piece in taken.pieces(&cells, closed).into_iter().filter(is_long).collect::<Vec<_>>() {
            piece.cells.iter().for_each(|&cell| taken.take(cell, drawn.len()));
            if !piece.closed {
                taken.tips.extend([piece.cells.first(), piece.cells.last()].into_iter().flatten());
            }
            drawn.push(DrawnPiece { line, piece });
        }
    }
    let Placed { runs, has_points, alone, shown, .. } =
        taken.place(marks, (lines, &weak), &mut drawn, (grid, within), params);
    taken.drop_loose(&mut drawn, &has_points, grid, params);
    // Second rows come last, those of the strongest first, and only where they fit, so that no line is cut for the sake
    // of another's width.
    let mut by_strength: Vec<usize> = (0..drawn.len()).collect();
    by_strength.sort_by_key(|&number| drawn[number].line);
    let line_of = |number: usize| &lines[drawn[number].line];
    let has_row = |number: &usize| !has_points[*number] && !drawn[*number].piece.cells.is_empty();
    let heavy: Vec<usize> = by_strength.iter().copied().filter(has_row).collect();
    let mut second_rows = taken.second_rows(&heavy, &drawn, line_of, within, params);
    let mut out = Vec::with_capacity(drawn.len());
    for number in by_strength {
        let DrawnPiece { line, piece } = &drawn[number];
        let line = &lines[*line];
        let mut rows = vec![piece.cells.clone()];
        rows.extend(second_rows[number].take());
        rows.retain(|row| !row.is_empty());
        let rows = rows.iter().map(|row| centres(row, grid)).chain(runs[number].iter().cloned());
        let runs: Vec<_> = rows.map(|row| params.run(row, params.height(line))).collect();
        out.extend((!runs.is_empty()).then_some(Line { strength: line.strength, runs }));
    }
    out.extend(alone.into_iter().map(|point| point.line(params)));
    (out, shown)
}

/// The dots of a line within a part of the grid, one dot wide, and whether it is closed.
fn cells_of(line: &Line, grid: &Grid, within: GridBox) -> (Vec<GridDot>, bool) {
    let line = polyline_of(line);
    let Rasterised { mut cells, sharp } = rasterise::rasterise(line.view(), grid);
    cells.iter_mut().for_each(|cell| *cell = within.nearest(*cell));
    cells.dedup();
    let closed = line.closed || ends_touch(&cells);
    (rasterise::thin(cells, closed, &sharp), closed)
}

/// Whether the ends of a line have become neighbours on the grid, which closes it.
fn ends_touch(cells: &[GridDot]) -> bool {
    let ends = cells.first().zip(cells.last()).filter(|_| cells.len() > 2 * LEAST_DOTS);
    ends.is_some_and(|(&first, &last)| distance(first, last) <= 1)
}

fn centres(cells: &[GridDot], grid: &Grid) -> Vec<MmPoint> {
    cells.iter().map(|&cell| centre(cell, grid)).collect()
}

/// A piece of a line that is far enough from all others.
pub(super) struct RowPiece {
    pub(super) cells: Vec<GridDot>,
    pub(super) closed: bool,
    /// Whether it is a whole line that leads from one line to another: an arrow or a bond between two shapes may be
    /// short. How short one may be that comes here, `lines/links` says.
    pub(super) is_link: bool,
    /// How many dots its line has from end to end where it only crosses others and goes on beyond them: an arm of a
    /// cross may be short.
    pub(super) through: usize,
}

/// A piece that is drawn, and the number of the line that it is of.
pub(super) struct DrawnPiece {
    pub(super) line: usize,
    pub(super) piece: RowPiece,
}

impl RowPiece {
    /// What is left of a line between two cuts: of one that comes back to itself, a ring without a spike.
    pub(super) fn cut_out(cells: Vec<GridDot>) -> Self {
        let (closed, through) = (ends_touch(&cells), cells.len());
        Self { cells: if closed { rasterise::thin(cells, true, &[]) } else { cells }, closed, is_link: false, through }
    }
}

/// From how many dots along a line on its distance from itself counts, with a gap of so many dots: at a right angle
/// both arms are near each other for so long.
pub const fn least_arc(gap: u32) -> u32 {
    4 * gap + 4
}

/// Most dots of a line beside another that it joins that may be too near to it, with a gap of so many dots: two for
/// each step of the gap.
pub const fn longest_approach(gap: u32) -> u32 {
    2 * gap
}

/// Most dots of a line that are left out where it crosses another one with a gap of so many dots: at no smaller angle
/// than makes the gap on both sides twice as long as at a right one.
pub const fn longest_cut(gap: u32) -> u32 {
    4 * gap + 1
}

/// Most dots of a line that are too near to another which it crosses at more than about 45 degrees: at a right angle
/// two fewer.
const fn longest_steep_cut(gap: u32) -> u32 {
    2 * gap + 3
}

/// A line goes on beyond another that it crosses if this is the least cosine between the step from piece to piece and
/// each of the two: 45 degrees.
pub const GOES_ON: f32 = 0.7;
/// Over so many dots the direction of a piece is taken: from one to the next it is a multiple of 45 degrees.
pub const STEPS: usize = 3;

/// Whether a piece of a line goes on in the next one without a bend, as far as each has a direction.
fn goes_on(one: &[GridDot], next: &[GridDot]) -> bool {
    let ([before @ .., tip], [begin, after @ ..]) = (one, next) else { return false };
    let point = |cell: &GridDot| MmPoint::new(cell[0] as f32, cell[1] as f32);
    let step = point(begin) - point(tip);
    let back = before.get(before.len().saturating_sub(STEPS)).map(|from| point(tip) - point(from));
    let on = after.get(STEPS.min(after.len()).saturating_sub(1)).map(|to| point(to) - point(begin));
    let is_straight = |way: MmVector| way.dot(step) >= GOES_ON * way.length() * step.length();
    back.is_none_or(is_straight) && on.is_none_or(is_straight)
}

/// Whether the dots of a line between two pieces, of these distances, only cross another: it is met, and soon left.
fn is_crossing(cut: &[Option<i32>], gap: i32) -> bool {
    cut.iter().flatten().any(|steps| *steps <= 1) && cut.len() <= longest_cut(gap as u32) as usize
}

/// Which of the dots of a line that crosses another, of these distances, lie on the other; if none does, an empty range
/// in the middle of those that touch it.
pub(super) fn met(cut: &[Option<i32>]) -> Range<usize> {
    let all_at = |steps: i32| (0..cut.len()).filter(move |&i| cut[i] == Some(steps));
    let range = |steps: i32| all_at(steps).next().zip(all_at(steps).next_back());
    let middle = |(first, last): (usize, usize)| (first + last).div_ceil(2)..(first + last).div_ceil(2);
    range(0).map_or_else(|| range(1).map_or(0..cut.len(), middle), |(first, last)| first..last + 1)
}

/// The dot at which a ring begins that has to be cut: where it touches another line, or else where it is too near to
/// one.
fn start_of_ring(distances: &[Option<i32>]) -> usize {
    let touching = (0..distances.len()).filter(|&i| distances[i].is_some_and(|steps| steps <= 1));
    let nearest = touching.min_by_key(|&i| distances[i]);
    nearest.or_else(|| distances.iter().position(Option::is_some)).unwrap_or(0)
}

/// The dots that are taken, and how many empty dots must lie between.
pub(super) struct OccupiedDots {
    /// The number of the piece of a line that each dot belongs to.
    pub(super) piece_of: BTreeMap<GridDot, usize>,
    /// The ends of pieces.
    tips: BTreeSet<GridDot>,
    pub(super) gap: i32,
}

impl OccupiedDots {
    pub(super) fn new(gap: i32) -> Self {
        Self { piece_of: BTreeMap::new(), tips: BTreeSet::new(), gap }
    }

    /// Finds room for the marks of lines, some of which are weak, and of which these pieces are drawn, within a part of
    /// the grid.
    fn place(
        &mut self,
        marks: &LineMarks,
        (lines, weak): (&[Line], &[bool]),
        drawn: &mut [DrawnPiece],
        (grid, within): (&Grid, GridBox),
        params: &Params,
    ) -> Placed {
        let row = |DrawnPiece { line, piece }: &DrawnPiece| Row {
            dots: centres(&piece.cells, grid),
            closed: piece.closed,
            is_heavy: params.has_second_row(&lines[*line]),
            is_weak: weak[*line],
        };
        let rows: Vec<Row> = drawn.iter().map(row).collect();
        let placed = marks::place(marks, &rows, Lattice::Grid { grid, within }, params);
        let cell = |at: &MmPoint| nearest(to_grid(*at, grid));
        for (number, DrawnPiece { piece, .. }) in drawn.iter_mut().enumerate() {
            let hidden: Vec<GridDot> = placed.hidden[number].iter().map(cell).collect();
            hidden.iter().for_each(|cell| {
                self.piece_of.remove(cell);
            });
            piece.cells.retain(|cell| !hidden.contains(cell));
            placed.runs[number].iter().flatten().for_each(|at| self.take(cell(at), number));
        }
        placed
    }

    /// Takes all dots of short pieces of which points on other lines have hidden the dots that they led to: those of
    /// the lines that a link joined, or of the other arm of a cross.
    fn drop_loose(&mut self, drawn: &mut [DrawnPiece], has_points: &[bool], grid: &Grid, params: &Params) {
        let reach = longest_cut(self.gap as u32) as i32 + 1;
        let ends = |piece: &RowPiece| [piece.cells.first().copied(), piece.cells.last().copied()];
        let is_short =
            |piece: &RowPiece| polyline::length(&centres(&piece.cells, grid)) + ROUNDED_OFF < params.min_length;
        loop {
            let is_loose = |number: usize, DrawnPiece { line, piece }: &DrawnPiece| {
                let is_other = |near: &GridDot| self.piece_of.get(near).is_some_and(|of| *of != number);
                let leads = |end: GridDot| self.around(end).any(|near| distance(near, end) <= 1 && is_other(&near));
                let own = || ends(piece).into_iter().flatten();
                let goes_on = || {
                    let arms = drawn.iter().enumerate().filter(|(of, other)| *of != number && other.line == *line);
                    let tips = arms.flat_map(|(_, other)| ends(&other.piece)).flatten();
                    tips.into_iter().any(|tip| own().any(|end| distance(tip, end) <= reach))
                };
                if piece.is_link { !own().all(leads) } else { !goes_on() }
            };
            let all = drawn.iter().enumerate();
            let short =
                all.filter(|(number, of)| !has_points[*number] && !of.piece.cells.is_empty() && is_short(&of.piece));
            let loose: Vec<usize> =
                short.filter(|(number, of)| is_loose(*number, of)).map(|(number, _)| number).collect();
            if loose.is_empty() {
                return;
            }
            for cell in loose.into_iter().flat_map(|number| std::mem::take(&mut drawn[number].piece.cells)) {
                self.piece_of.remove(&cell);
            }
        }
    }

    pub(super) fn take(&mut self, cell: GridDot, piece: usize) {
        self.piece_of.entry(cell).or_insert(piece);
    }

    /// The cells that are nearer to `cell` than the gap allows.
    pub(super) fn around(&self, cell: GridDot) -> impl Iterator<Item = GridDot> + use<> {
        let gap = self.gap;
        (-gap..=gap).flat_map(move |dy| (-gap..=gap).map(move |dx| [cell[0] + dx, cell[1] + dy]))
    }

    /// Steps to the nearest dot of another line; none beyond the gap.
    fn to_others(&self, cell: GridDot) -> Option<i32> {
        self.around(cell).filter(|near| self.piece_of.contains_key(near)).map(|near| distance(near, cell)).min()
    }

    /// From how many dots along a line on its distance from itself counts.
    pub(super) fn least_arc(&self) -> usize {
        least_arc(self.gap as u32) as usize
    }

    /// Steps from each dot of a line to the nearest dot of other lines and of the parts of its own that came long
    /// before; none beyond the gap.
    fn distances(&self, cells: &[GridDot], closed: bool) -> Vec<Option<i32>> {
        let (n, least_arc) = (cells.len(), self.least_arc());
        let mut own: BTreeMap<GridDot, usize> = BTreeMap::new();
        let mut out = Vec::with_capacity(n);
        for (i, &cell) in cells.iter().enumerate() {
            let far = |j: usize| i - j > least_arc && (!closed || n - (i - j) > least_arc);
            let is_own = |near: &GridDot| own.get(near).is_some_and(|&j| *near == cell || far(j));
            let of_own = self.around(cell).filter(is_own).map(|near| distance(near, cell)).min();
            out.push(of_own.into_iter().chain(self.to_others(cell)).min());
            own.insert(cell, i);
        }
        out
    }

    /// The pieces of a line that keep the gap, but where they join others: at each end some dots may be nearer
    /// ([`OccupiedDots::allow_junction`]), and of a line so short that those of both ends are all that it has, all of
    /// them ([`OccupiedDots::short_link`]). Either way a whole line that joins others at both ends is a link.
    pub(super) fn pieces(&self, of_line: &[GridDot], closed: bool) -> Vec<RowPiece> {
        let (mut cells, mut distances) = (of_line.to_vec(), self.distances(of_line, closed));
        if distances.iter().all(Option::is_none) {
            return vec![RowPiece { through: cells.len(), cells, closed, is_link: false }];
        }
        if let Some(ring) = closed.then(|| self.touching_ring(of_line, &distances)).flatten() {
            return vec![ring];
        }
        if let Some(link) = self.short_link(of_line, &distances).filter(|_| !closed) {
            return vec![link];
        }
        if !closed {
            let linked = |cells: &[GridDot], distances: &[Option<i32>]| self.linked_end(cells, distances);
            let back = || {
                let (mut cells, mut distances) = (cells.clone(), distances.clone());
                cells.reverse();
                distances.reverse();
                linked(&cells, &distances)
            };
            if let Some(pieces) = linked(&cells, &distances).or_else(back) {
                return pieces;
            }
        }
        if closed {
            // starting where it touches another line, or is too near to one, it is an open line
            let start = start_of_ring(&distances);
            cells.rotate_left(start);
            distances.rotate_left(start);
            cells.push(cells[0]);
            distances.push(distances[0]);
        }
        let joins_start = self.allow_junction(&mut cells, &mut distances);
        cells.reverse();
        distances.reverse();
        let joins_end = self.allow_junction(&mut cells, &mut distances);
        cells.reverse();
        distances.reverse();
        if closed && cells.len() > 1 && cells.first() == cells.last() {
            cells.pop();
            distances.pop();
        }
        if joins_start && joins_end && distances.iter().all(Option::is_none) {
            let whole = RowPiece::cut_out(cells);
            // a ring that only touches another line is one
            return vec![RowPiece { is_link: !closed, closed: whole.closed || closed, ..whole }];
        }
        self.stretches(&cells, &distances)
    }

    /// The pieces of an open line between the dots that are too near to others, with these distances from them: where
    /// it only crosses others, another ends on it, or it has a corner there, up to that.
    fn stretches(&self, cells: &[GridDot], distances: &[Option<i32>]) -> Vec<RowPiece> {
        let stretches = distances.split(Option::is_some).scan(0, |at, stretch| {
            let from = *at;
            *at += stretch.len() + 1;
            Some(from..from + stretch.len())
        });
        let stretches: Vec<Range<usize>> = stretches.filter(|range| !range.is_empty()).collect();
        let crosses = |one: &Range<usize>, next: &Range<usize>| {
            is_crossing(&distances[one.end..next.start], self.gap) && goes_on(&cells[one.clone()], &cells[next.clone()])
        };
        let through = stretches.chunk_by(crosses).flat_map(|line| {
            let through = line.last().map_or(0, |last| last.end) - line.first().map_or(0, |first| first.start);
            line.iter().map(move |_| through)
        });
        let through: Vec<usize> = through.collect();
        let mut pieces: Vec<(Range<usize>, usize)> = Vec::with_capacity(stretches.len());
        for (number, stretch) in stretches.iter().enumerate() {
            let before = number.checked_sub(1).map(|before| &stretches[before]);
            let cut = before.map_or(0..0, |before| before.end..stretch.start);
            let (dots, steps) = (&cells[cut.clone()], &distances[cut.clone()]);
            let is_crossed =
                || before.is_some_and(|before| crosses(before, stretch)) && self.is_on_both_sides(dots, steps);
            let (meets_end, mut range) = (self.meets_end(dots), stretch.clone());
            let is_soon_left = || self.is_steep(dots) || !meets_end && self.has_short_arms(dots, steps);
            let turns = before.is_some_and(|before| !goes_on(&cells[before.clone()], &cells[stretch.clone()]));
            if let Some((last, _)) = pieces.last_mut() {
                let is_met = is_soon_left() && (meets_end || is_crossed());
                if is_met && meets_end && !steps.contains(&Some(0)) {
                    // the other line ends beside it and shares no dot with it: it is not interrupted
                    last.end = range.end;
                    continue;
                }
                let left_out = match (is_met, turns) {
                    (true, _) => vec![met(steps)],
                    (false, true) => self.corner(dots, steps).into_iter().collect(),
                    (false, false) => self.crossings(dots, steps).unwrap_or_default(),
                };
                if let Some((first, end)) = left_out.first().zip(left_out.last()) {
                    (last.end, range.start) = (cut.start + first.start, cut.start + end.end);
                }
                let whole = before.map_or(0, |before| stretch.end - before.start);
                let between = left_out.windows(2).map(|pair| cut.start + pair[0].end..cut.start + pair[1].start);
                pieces.extend(between.filter(|range| !range.is_empty()).map(|range| (range, whole)));
            }
            pieces.push((range, through[number]));
        }
        let piece =
            |(range, through): (Range<usize>, usize)| RowPiece { through, ..RowPiece::cut_out(cells[range].to_vec()) };
        pieces.into_iter().map(piece).collect()
    }

    /// A ring that only touches another line, with these distances from it, without the dots that both share.
    fn touching_ring(&self, cells: &[GridDot], distances: &[Option<i32>]) -> Option<RowPiece> {
        let free = distances.iter().position(Option::is_none)?;
        let from_free = || (0..cells.len()).map(|i| (free + i) % cells.len());
        let near: Vec<usize> = from_free().skip_while(|&i| distances[i].is_none()).collect();
        let run = near.iter().take_while(|&&i| distances[i].is_some()).count();
        let (run, rest) = near.split_at(run);
        let touches = run.iter().any(|&i| distances[i].is_some_and(|steps| steps <= 1));
        let cut: Vec<GridDot> = run.iter().map(|&i| cells[i]).collect();
        if !touches || rest.iter().any(|&i| distances[i].is_some()) || !self.is_steep(&cut) {
            return None;
        }
        // it begins where it touches the other, as what ends there does
        let last_at = |steps: i32| run.iter().rfind(|&&i| distances[i] == Some(steps));
        let start = last_at(0).map(|shared| shared + 1).or(last_at(1).copied()).unwrap_or(0);
        let ring = (0..cells.len()).map(|i| (start + i) % cells.len()).filter(|&i| distances[i] != Some(0));
        let cells: Vec<GridDot> = ring.map(|i| cells[i]).collect();
        Some(RowPiece { through: cells.len(), cells, closed: true, is_link: false })
    }

    /// A line from one to another that is so short that all its dots are near to one of them, without the dots on
    /// these; none if it runs beside one, or is near to a third. Its junctions are not looked at one by one: the dots
    /// near to the line at its first end are also those near to the line at its last.
    pub(super) fn short_link(&self, cells: &[GridDot], distances: &[Option<i32>]) -> Option<RowPiece> {
        let on_other = |distance: &&Option<i32>| **distance == Some(0);
        let (first, last) =
            (distances.iter().take_while(on_other).count(), distances.iter().rev().take_while(on_other).count());
        let range = first..distances.len().checked_sub(last)?;
        let (cells, distances) = (cells.get(range.clone())?, distances.get(range)?);
        let ([begin, .., end], [to_first, .., to_last]) = (cells, distances) else { return None };
        let touches = |distance: &Option<i32>| *distance == Some(1);
        let is_beside = distances.iter().skip(2).take(distances.len().saturating_sub(4)).any(touches);
        let near = |cell: &GridDot| -> BTreeSet<usize> {
            self.around(*cell).filter_map(|near| self.piece_of.get(&near)).copied().collect()
        };
        let joined = &near(begin) | &near(end);
        let is_link = cells.len() >= LEAST_DOTS
            && distances.iter().all(Option::is_some)
            && touches(to_first)
            && touches(to_last)
            && !is_beside
            && cells.iter().all(|cell| near(cell).is_subset(&joined));
        is_link.then(|| RowPiece { is_link: true, ..RowPiece::cut_out(cells.to_vec()) })
    }

    /// Whether these dots of a line, which are too near to others, are near to a single piece of a line, and the line
    /// is soon away from it: at more than about 45 degrees.
    fn is_steep(&self, cut: &[GridDot]) -> bool {
        cut.len() <= longest_steep_cut(self.gap as u32) as usize && self.is_near_one(cut)
    }

    pub(super) fn is_near_one(&self, cut: &[GridDot]) -> bool {
        let near = cut.iter().flat_map(|&cell| self.around(cell)).filter_map(|near| self.piece_of.get(&near));
        near.copied().collect::<BTreeSet<usize>>().len() == 1
    }

    /// Whether of dots that are near to a single piece no more lie on either side of it than beside an end that joins.
    pub(super) fn has_short_arms(&self, cut: &[GridDot], steps: &[Option<i32>]) -> bool {
        let (met, longest) = (met(steps), longest_approach(self.gap as u32) as usize);
        met.start.max(cut.len() - met.end) <= longest && self.is_near_one(cut)
    }

    /// Whether the line that these dots are near to, by so many steps, is on both sides of them, or shares one.
    pub(super) fn is_on_both_sides(&self, cut: &[GridDot], steps: &[Option<i32>]) -> bool {
        let ([first, .., last], false) = (cut, steps.contains(&Some(0))) else { return true };
        let side =
            |dot: GridDot| (last[0] - first[0]) * (dot[1] - first[1]) - (last[1] - first[1]) * (dot[0] - first[0]);
        let others = || cut.iter().flat_map(|&cell| self.around(cell)).filter(|near| self.piece_of.contains_key(near));
        others().any(|dot| side(dot) > 0) && others().any(|dot| side(dot) < 0)
    }

    /// Whether a line ends beside one of these dots, or on it.
    fn meets_end(&self, cut: &[GridDot]) -> bool {
        let is_met =
            |cell: &GridDot| self.around(*cell).any(|near| distance(near, *cell) <= 1 && self.tips.contains(&near));
        cut.iter().any(is_met)
    }
}

#[cfg(test)]
pub(super) mod tests;
