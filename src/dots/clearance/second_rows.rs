//! The second rows of heavy lines on a grid. They come last, those of the strongest first, and only where they keep the
//! gap from all other lines, so that no line is cut for the sake of another's width.

use std::collections::{BTreeMap, BTreeSet};

use super::on_grid::{DrawnPiece, OccupiedDots, RowPiece};
use crate::dots::grid_dot::{GridBox, GridDot, distance};
use crate::dots::params::{LEAST_DOTS, Params};
use crate::dots::second_row;
use crate::lines::Line;

/// So many steps of an outline of a bar go aslant at most: at a corner, or where two of its parts lie a step apart.
const MOST_ASLANT: usize = 4;
/// One of so many steps of walls may, as the arc of a door may be one line with them. Chosen by us: of a circle every
/// second or third does.
const ASLANT_OF_WALLS: usize = 6;
/// At least half of the steps of walls are in stretches that are level or upright for so many steps: a straight line
/// that is a little aslant, as a curve of a chart, has shorter ones, one after the other. Chosen by us.
const STRETCH_OF_WALLS: usize = 12;

/// Outside of an outline with two corners a row has so many dots more than inside, at least: six, and three at one
/// corner.
const ROUND_BAR: usize = 5;

/// Share of a line along which a second row is that is to be whole, and the steps between two of its dots: at a corner
/// one may be missing.
const WHOLE: f32 = 0.9;
const AT_CORNER: i32 = 2;

impl RowPiece {
    /// Whether it is level and upright all along, as the outline of a bar, an axis or a box is.
    fn is_of_bar(&self) -> bool {
        self.aslant() <= MOST_ASLANT
    }

    /// Whether it is open and turns, as the outline of a bar on its axis does.
    fn has_corner(&self) -> bool {
        let goes_along = |axis: usize| self.cells.windows(2).any(|pair| pair[0][axis] == pair[1][axis]);
        !self.closed && goes_along(0) && goes_along(1)
    }

    /// Whether it is so for the most part, as walls with a door are.
    fn is_of_walls(&self) -> bool {
        let has_few_aslant = ASLANT_OF_WALLS * self.aslant() <= self.cells.len();
        self.is_of_bar() || has_few_aslant && 2 * self.in_stretches() >= self.cells.len()
    }

    /// How many of its steps are in long level or upright stretches.
    fn in_stretches(&self) -> usize {
        let stays = |pair: &[GridDot]| [0, 1].map(|axis| pair[0][axis] == pair[1][axis]);
        let ways: Vec<[bool; 2]> = self.cells.windows(2).map(stays).collect();
        let stretches = ways.chunk_by(|a, b| a == b).filter(|of| of[0] != [false, false]);
        stretches.map(<[[bool; 2]]>::len).filter(|&steps| steps >= STRETCH_OF_WALLS).sum()
    }

    /// Of the outline of a bar, whether its second row has dots outside; none of what does not go round three sides.
    fn has_outside(&self, row: &[GridDot]) -> Option<bool> {
        let back: Vec<GridDot> = self.cells.iter().rev().copied().collect();
        let [own, others] = [&self.cells, &back].map(|cells| second_row::on_grid(cells, self.closed).len());
        if self.closed || row.is_empty() || own.abs_diff(others) < ROUND_BAR {
            return None;
        }
        let is_beyond = |cell: &GridDot, axis: usize| {
            let own = || self.cells.iter().map(move |own| own[axis]);
            own().all(|own| own < cell[axis]) || own().all(|own| own > cell[axis])
        };
        Some(row.iter().any(|cell| (0..2).any(|axis| is_beyond(cell, axis))))
    }

    /// How many of its steps go aslant.
    fn aslant(&self) -> usize {
        self.cells.windows(2).filter(|pair| pair[0][0] != pair[1][0] && pair[0][1] != pair[1][1]).count()
    }
}

impl OccupiedDots {
    /// The second row of each of these pieces that has one, the strongest first.
    pub(super) fn second_rows<'l>(
        &mut self,
        numbers: &[usize],
        drawn: &[DrawnPiece],
        line_of: impl Fn(usize) -> &'l Line,
        within: GridBox,
        params: &Params,
    ) -> Vec<Option<Vec<GridDot>>> {
        let mut rows: Vec<Option<Vec<GridDot>>> = vec![None; drawn.len()];
        for &number in numbers.iter().filter(|&&number| params.has_second_row(line_of(number))) {
            let piece = &drawn[number].piece;
            // a piece too short for a line is felt as texture, unless it is most of the row
            let least = (params.min_length / params.pitch).ceil() as usize + 1;
            let least = least.min(piece.cells.len() / 2).max(LEAST_DOTS);
            let mut second = self.wider_side((number, piece), least, params, |cell| within.holds(cell));
            // where a tick goes through it, it has a dot already
            second.retain(|cell| !self.piece_of.contains_key(cell));
            second.iter().for_each(|&cell| self.take(cell, number));
            rows[number] = Some(second);
        }
        if params.whole_rows {
            let strength = |number: usize| line_of(number).strength;
            let is_of_bar = |number: usize| drawn[number].piece.is_of_bar();
            let of_walls: Vec<usize> = numbers.iter().copied().filter(|&of| drawn[of].piece.is_of_walls()).collect();
            let of_bars: Vec<usize> = of_walls.iter().copied().filter(|&of| is_of_bar(of)).collect();
            let together = about_as_strong(&of_walls, &rows, strength);
            // open outlines of bars have strengths of their own, by their colours and by what is beside them
            let with_corners: Vec<usize> = of_bars.iter().copied().filter(|&of| drawn[of].piece.has_corner()).collect();
            alike(&with_corners, &mut rows, |_| 1.0);
            alike(&of_bars, &mut rows, strength);
            on_one_side(&of_bars, &mut rows, drawn, strength);
            as_others(&together, &mut rows, is_of_bar);
        }
        rows
    }

    /// The second row of a piece. Where it is to be whole, it is on the side on which more of it has room, if that is
    /// nearly all of it: at its ends other lines may be.
    fn wider_side(
        &self,
        (number, piece): (usize, &RowPiece),
        least: usize,
        params: &Params,
        inside: impl Fn(GridDot) -> bool,
    ) -> Vec<GridDot> {
        let own = self.second_row((number, piece), least, &inside);
        if !params.whole_rows || !piece.is_of_walls() {
            return own;
        }
        let others = || {
            let cells = piece.cells.iter().rev().copied().collect();
            let mut row = self.second_row((number, &RowPiece { cells, ..*piece }), least, &inside);
            row.reverse(); // as the line runs
            row
        };
        let others = if piece.closed { Vec::new() } else { others() };
        let row = if others.len() > own.len() { others } else { own };
        let at_ends = 2 * (self.gap + 1) as usize;
        let is_one = row.windows(2).all(|pair| distance(pair[0], pair[1]) <= AT_CORNER);
        if is_one && (row.len() + at_ends) as f32 >= WHOLE * piece.cells.len() as f32 { row } else { Vec::new() }
    }

    /// The second row of a piece, where it keeps the gap from all other lines and from the other arms of the piece
    /// itself, for at least so many dots.
    fn second_row(
        &self,
        (number, piece): (usize, &RowPiece),
        least: usize,
        inside: impl Fn(GridDot) -> bool,
    ) -> Vec<GridDot> {
        let (n, least_arc) = (piece.cells.len(), self.least_arc());
        // the dots of both rows, each with the index in the first row
        let mut own: BTreeMap<GridDot, usize> = piece.cells.iter().enumerate().map(|(i, &cell)| (cell, i)).collect();
        let mut row = second_row::on_grid(&piece.cells, piece.closed);
        row.retain(|&(i, cell)| {
            let is_other_arm = |j: usize| i.abs_diff(j) > least_arc && (!piece.closed || n - i.abs_diff(j) > least_arc);
            let is_free = |near: GridDot| match (own.get(&near), self.piece_of.get(&near)) {
                (Some(&j), _) => !is_other_arm(j),
                (None, other) => other.is_none_or(|&other| other == number),
            };
            let is_own = self.piece_of.get(&cell).is_none_or(|&of| of == number);
            let is_kept = inside(cell) && is_own && self.around(cell).all(is_free);
            if is_kept {
                own.insert(cell, i);
            }
            is_kept
        });
        second_row::without_short_pieces(row, least)
    }
}

/// Takes second rows away where of lines that are about as strong, as the bars of a chart, too few have one: the others
/// would be taken for lines of another kind.
fn alike(numbers: &[usize], rows: &mut [Option<Vec<GridDot>>], strength: impl Fn(usize) -> f32) {
    for lines in about_as_strong(numbers, rows, strength) {
        let has_row = |number: &&usize| rows[**number].as_ref().is_some_and(|row| !row.is_empty());
        if (lines.iter().filter(has_row).count() as f32) < MOST_OF_THEM * lines.len() as f32 {
            lines.iter().for_each(|&number| rows[number] = None);
        }
    }
}

/// Takes second rows away where of lines that are about as strong some bars have theirs inside and others outside: the
/// ends of these lie a row further on, beside the tick or the gridline at which they end in the drawing.
fn on_one_side(
    numbers: &[usize],
    rows: &mut [Option<Vec<GridDot>>],
    drawn: &[DrawnPiece],
    strength: impl Fn(usize) -> f32,
) {
    for lines in about_as_strong(numbers, rows, strength) {
        let has_outside = |&number: &usize| rows[number].as_ref().and_then(|row| drawn[number].piece.has_outside(row));
        let sides: BTreeSet<bool> = lines.iter().filter_map(has_outside).collect();
        if sides.len() > 1 {
            lines.iter().for_each(|&number| rows[number] = None);
        }
    }
}

/// Takes second rows away from walls that are one line with the arc of a door where no bar or wall that is as strong
/// has one.
fn as_others(together: &[Vec<usize>], rows: &mut [Option<Vec<GridDot>>], is_of_bar: impl Fn(usize) -> bool) {
    for lines in together {
        let (of_bars, others): (Vec<usize>, Vec<usize>) = lines.iter().partition(|&&number| is_of_bar(number));
        let has_none = |number: &usize| rows[*number].as_ref().is_none_or(Vec::is_empty);
        if !of_bars.is_empty() && of_bars.iter().all(has_none) {
            others.into_iter().for_each(|number| rows[number] = None);
        }
    }
}

/// The lines with second rows, those together that are about as strong: by their strength, as the lines come by their
/// weight, a long bar of one colour between two of another.
fn about_as_strong(
    numbers: &[usize],
    rows: &[Option<Vec<GridDot>>],
    strength: impl Fn(usize) -> f32,
) -> Vec<Vec<usize>> {
    let mut heavy: Vec<usize> = numbers.iter().copied().filter(|&number| rows[number].is_some()).collect();
    heavy.sort_by(|a, b| strength(*b).total_cmp(&strength(*a)));
    let is_near = |a: &usize, b: &usize| {
        let [a, b] = [a, b].map(|number| strength(*number));
        a.max(b) <= ABOUT_AS_STRONG * a.min(b)
    };
    heavy.chunk_by(is_near).map(<[usize]>::to_vec).collect()
}

/// Lines of which the stronger is so many times as strong as the other, at most, are about as strong: bars of several
/// colours.
const ABOUT_AS_STRONG: f32 = 1.25;
/// Share of lines that are about as strong that have a second row, or none has.
const MOST_OF_THEM: f32 = 0.9;

#[cfg(test)]
mod tests;
