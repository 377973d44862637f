//! The second row of dots of a heavy line, on one side of the first. It goes along with all of the line or is not
//! there: where a line is broad in part, a finger takes it for two.

use super::cell::{Cell, distance};
use super::rasterise::between;
use crate::geom::right_of;
use crate::units::{MmPoint, MmVector};

/// On which side of its line a second row lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RowSide {
    /// On the right of an open line as it runs, and inside a ring.
    Inner,
    /// On the other side.
    Outer,
}

impl RowSide {
    /// Both, the first choice first.
    pub(super) const ALL: [Self; 2] = [Self::Inner, Self::Outer];

    fn sign(self) -> i32 {
        if self == Self::Inner { 1 } else { -1 }
    }
}

/// The second row of a line on a grid, in its order: each dot with the index of the dot of the first row that it lies
/// beside.
///
/// ```text
///   # # # # #          # # # # #       # first row, o second, on the inner side
///   # o o o o          . . . . #
///   # o . . .          o o o . #
/// ```
pub(super) fn on_grid(cells: &[Cell], closed: bool, side: RowSide) -> Vec<(usize, Cell)> {
    let n = cells.len();
    let turn = side.sign() * if closed && signed_area(cells) < 0 { -1 } else { 1 };
    let mut out: Vec<(usize, Cell)> = Vec::with_capacity(n);
    for (i, &[x, y]) in cells.iter().enumerate() {
        let before = if closed { cells[(i + n - 1) % n] } else { cells[i.saturating_sub(1)] };
        let after = if closed { cells[(i + 1) % n] } else { cells[(i + 1).min(n - 1)] };
        let [dx, dy] = [after[0] - before[0], after[1] - before[1]];
        let cell = if dx.abs() >= dy.abs() { [x, y + turn * dx.signum()] } else { [x - turn * dy.signum(), y] };
        if let Some(&(_, last)) = out.last() {
            // around the outside of a corner
            out.extend(between(last, cell).map(|cell| (i, cell)));
        }
        out.push((i, cell));
    }
    let mut seen: Vec<Cell> = Vec::with_capacity(out.len());
    out.retain(|(_, cell)| {
        let is_new = !cells.contains(cell) && !seen.contains(cell);
        seen.push(*cell);
        is_new
    });
    out
}

/// Twice the signed area that a ring encloses; above 0 if it runs clockwise as a reader sees it.
fn signed_area(cells: &[Cell]) -> i32 {
    let n = cells.len();
    (0..n).map(|i| (cells[i], cells[(i + 1) % n])).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum()
}

/// The second row of dots that can be anywhere, a pitch beside the first, each dot with the index as above.
pub(super) fn anywhere(dots: &[MmPoint], closed: bool, side: RowSide, pitch: f32) -> Vec<(usize, MmPoint)> {
    let (n, pitch) = (dots.len(), side.sign() as f32 * pitch);
    let offset = |i: usize| {
        let before = if closed { dots[(i + n - 1) % n] } else { dots[i.saturating_sub(1)] };
        let after = if closed { dots[(i + 1) % n] } else { dots[(i + 1).min(n - 1)] };
        let along = (after - before).try_normalize().unwrap_or(MmVector::new(1.0, 0.0));
        right_of(along) * pitch
    };
    (0..n).map(|i| (i, dots[i] + offset(i))).collect()
}

/// Beside so many dots in a row a second row may be missing, and so many more for each empty dot between lines: as
/// many as where another line ends on this one, at a slant.
const MOST_MISSING: usize = 5;
const MOST_FOR_GAP: usize = 2;
/// At the ends of an open line so many times as many: other lines begin there at a sharp angle.
const AT_ENDS: usize = 2;
/// A second row has this share of the dots of its line at least.
const LEAST_SHARE: f32 = 0.6;

/// How much of a line is without its second row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RowGaps {
    /// The most dots in a row without one; at an end of an open line they count half.
    longest: usize,
    share: f32,
}

impl RowGaps {
    /// Of a line of so many dots, of which these have one.
    pub(super) fn of(with: impl Iterator<Item = usize>, count: usize, closed: bool) -> Self {
        let mut has = vec![false; count];
        with.for_each(|index| has[index] = true);
        let share = has.iter().filter(|has| **has).count() as f32 / count.max(1) as f32;
        let Some(first) = has.iter().position(|has| *has) else { return Self { longest: count, share } };
        let last = has.iter().rposition(|has| *has).unwrap_or(first);
        let between = has[first..=last].split(|has| *has).map(<[bool]>::len).max().unwrap_or(0);
        let (before, after) = (first, count - 1 - last);
        let at_ends = if closed { before + after } else { before.max(after) / AT_ENDS };
        Self { longest: between.max(at_ends), share }
    }

    /// Whether a finger takes the line for one of one breadth.
    pub(super) fn is_whole(self, gap: u32) -> bool {
        self.longest <= MOST_MISSING + MOST_FOR_GAP * gap as usize && self.share >= LEAST_SHARE
    }

    /// Whether less is missing.
    pub(super) fn is_less_than(self, other: Self) -> bool {
        self.longest < other.longest
    }
}

/// The dots of a second row without short pieces: those of fewer than `least` connected dots.
pub(super) fn without_short_pieces(row: Vec<(usize, Cell)>, least: usize) -> Vec<(usize, Cell)> {
    let mut out = Vec::with_capacity(row.len());
    let mut piece: Vec<(usize, Cell)> = Vec::new();
    let mut finish = |piece: &mut Vec<(usize, Cell)>| {
        if piece.len() >= least {
            out.append(piece);
        }
        piece.clear();
    };
    for (index, cell) in row {
        if piece.last().is_some_and(|&(_, last)| distance(last, cell) > 1) {
            finish(&mut piece);
        }
        piece.push((index, cell));
    }
    finish(&mut piece);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn drawn(cells: &[Cell], closed: bool) -> String {
        let first: BTreeSet<Cell> = cells.iter().copied().collect();
        let second: BTreeSet<Cell> = on_grid(cells, closed, RowSide::Inner).into_iter().map(|(_, cell)| cell).collect();
        let all: Vec<Cell> = first.union(&second).copied().collect();
        let range = |axis: usize| {
            let values = all.iter().map(|cell| cell[axis]);
            values.clone().min().unwrap_or(0)..=values.max().unwrap_or(0)
        };
        let sign = |cell: Cell| match (first.contains(&cell), second.contains(&cell)) {
            (true, _) => '#',
            (_, true) => 'o',
            _ => '.',
        };
        range(1).map(|y| range(0).map(|x| sign([x, y])).collect::<String>() + "\n").collect()
    }

    #[test]
    fn a_line_is_two_dots_wide_around_corners() {
        let right_and_down: Vec<Cell> = (0..5).map(|x| [x, 0]).chain((1..5).map(|y| [4, y])).collect();
        assert_eq!(drawn(&right_and_down, false), "#####\noooo#\n...o#\n...o#\n...o#\n");
        let back: Vec<Cell> = right_and_down.into_iter().rev().collect();
        assert_eq!(drawn(&back, false), "ooooo.\n#####o\n....#o\n....#o\n....#o\n....#o\n");
    }

    #[test]
    fn a_ring_has_its_second_row_inside_whichever_way_it_runs() {
        let side = |from: Cell, step: Cell| (0..5).map(move |i| [from[0] + i * step[0], from[1] + i * step[1]]);
        let ring: Vec<Cell> = side([0, 0], [1, 0])
            .chain(side([5, 0], [0, 1]))
            .chain(side([5, 5], [-1, 0]))
            .chain(side([0, 5], [0, -1]))
            .collect();
        let want = "######\n#oooo#\n#o..o#\n#o..o#\n#oooo#\n######\n";
        assert_eq!(drawn(&ring, true), want);
        let back: Vec<Cell> = ring.into_iter().rev().collect();
        assert_eq!(drawn(&back, true), want);
    }

    #[test]
    fn slanting_lines_have_no_holes() {
        let slanting: Vec<Cell> = (0..6).map(|i| [i, i / 2]).collect();
        assert_eq!(drawn(&slanting, false), "##....\noo##..\n..oo##\n....oo\n");
        let steep: Vec<Cell> = (0..4).map(|i| [i, i]).collect();
        assert_eq!(drawn(&steep, false), "#...\no#..\n.o#.\n..o#\n...o\n");
    }

    #[test]
    fn anywhere_the_second_row_lies_a_pitch_to_the_right() {
        let at = |x: f32, y: f32| MmPoint::new(x, y);
        let row = anywhere(&[at(0.0, 5.0), at(2.5, 5.0), at(5.0, 5.0)], false, RowSide::Inner, 2.5);
        // y points down, so the right of a line that runs to the right lies below it
        assert_eq!(row, [(0, at(0.0, 7.5)), (1, at(2.5, 7.5)), (2, at(5.0, 7.5))]);
        let ring = anywhere(&[at(0.0, 0.0), at(10.0, 0.0), at(10.0, 10.0), at(0.0, 10.0)], true, RowSide::Inner, 2.0);
        let is_inside = |(_, dot): &(usize, MmPoint)| (*dot - at(5.0, 5.0)).length() < 5.1;
        assert!(ring.len() == 4 && ring.iter().all(is_inside), "{ring:?}");
        assert_eq!(anywhere(&[at(1.0, 1.0)], false, RowSide::Inner, 2.5).len(), 1);
    }

    #[test]
    fn short_pieces_of_a_second_row_are_left_out() {
        let row = [[0, 0], [1, 0], [5, 0], [6, 1], [7, 1], [12, 0]];
        let row: Vec<(usize, Cell)> = row.into_iter().enumerate().collect();
        assert_eq!(without_short_pieces(row.clone(), 3), [(2, [5, 0]), (3, [6, 1]), (4, [7, 1])]);
        assert_eq!(without_short_pieces(row.clone(), 1).len(), row.len());
        assert_eq!(without_short_pieces(Vec::new(), 3), []);
    }

    #[test]
    fn a_second_row_is_whole_but_for_where_lines_join() {
        let gaps = |missing: std::ops::Range<usize>, closed: bool| {
            RowGaps::of((0..40).filter(|index| !missing.contains(index)), 40, closed)
        };
        assert!(gaps(0..0, true).is_whole(1) && gaps(10..17, false).is_whole(1) && !gaps(10..18, false).is_whole(1));
        assert!(gaps(0..15, false).is_whole(1) && !gaps(0..15, true).is_whole(1), "sharp angles at an end");
        assert!(!RowGaps::of(0..20, 40, false).is_whole(2), "half of it");
        assert!(!RowGaps::of((0..40).filter(|index| index % 2 == 0), 40, false).is_whole(2), "too little in all");
        assert!(gaps(3..5, false).is_less_than(gaps(3..9, false)) && !RowGaps::of(0..0, 40, true).is_whole(2));
    }
}
