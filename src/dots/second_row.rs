//! The second row of dots of a heavy line, on one side of the first.

use super::cell::{Cell, distance};
use super::rasterise::between;
use crate::geom::right_of;
use crate::units::{MmPoint, MmVector};

/// The second row of a line on a grid, in its order: each dot with the index of the dot of the first row that it lies
/// beside. It is on the right of an open line as it runs, and inside a ring.
///
/// ```text
///   # # # # #          # # # # #       # first row, o second
///   # o o o o          . . . . #
///   # o . . .          o o o . #
/// ```
pub(super) fn on_grid(cells: &[Cell], closed: bool) -> Vec<(usize, Cell)> {
    let n = cells.len();
    let turn = if closed && signed_area(cells) < 0 { -1 } else { 1 };
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

/// The second row of dots that can be anywhere, a pitch to the right of the first, each dot with the index as above.
pub(super) fn anywhere(dots: &[MmPoint], closed: bool, pitch: f32) -> Vec<(usize, MmPoint)> {
    let n = dots.len();
    let offset = |i: usize| {
        let before = if closed { dots[(i + n - 1) % n] } else { dots[i.saturating_sub(1)] };
        let after = if closed { dots[(i + 1) % n] } else { dots[(i + 1).min(n - 1)] };
        let along = (after - before).try_normalize().unwrap_or(MmVector::new(1.0, 0.0));
        right_of(along) * pitch
    };
    (0..n).map(|i| (i, dots[i] + offset(i))).collect()
}

/// The dots of a second row without short pieces: those of fewer than `least` connected dots.
pub(super) fn without_short_pieces(row: Vec<(usize, Cell)>, least: usize) -> Vec<Cell> {
    let mut out = Vec::with_capacity(row.len());
    let mut piece: Vec<Cell> = Vec::new();
    let mut finish = |piece: &mut Vec<Cell>| {
        if piece.len() >= least {
            out.append(piece);
        }
        piece.clear();
    };
    for (_, cell) in row {
        if piece.last().is_some_and(|&last| distance(last, cell) > 1) {
            finish(&mut piece);
        }
        piece.push(cell);
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
        let second: BTreeSet<Cell> = on_grid(cells, closed).into_iter().map(|(_, cell)| cell).collect();
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
        let row = anywhere(&[at(0.0, 5.0), at(2.5, 5.0), at(5.0, 5.0)], false, 2.5);
        // y points down, so the right of a line that runs to the right lies below it
        assert_eq!(row, [(0, at(0.0, 7.5)), (1, at(2.5, 7.5)), (2, at(5.0, 7.5))]);
        let ring = anywhere(&[at(0.0, 0.0), at(10.0, 0.0), at(10.0, 10.0), at(0.0, 10.0)], true, 2.0);
        let is_inside = |(_, dot): &(usize, MmPoint)| (*dot - at(5.0, 5.0)).length() < 5.1;
        assert!(ring.len() == 4 && ring.iter().all(is_inside), "{ring:?}");
        assert_eq!(anywhere(&[at(1.0, 1.0)], false, 2.5).len(), 1);
    }

    #[test]
    fn short_pieces_of_a_second_row_are_left_out() {
        let row = [[0, 0], [1, 0], [5, 0], [6, 1], [7, 1], [12, 0]];
        let row: Vec<(usize, Cell)> = row.into_iter().enumerate().collect();
        assert_eq!(without_short_pieces(row.clone(), 3), [[5, 0], [6, 1], [7, 1]]);
        assert_eq!(without_short_pieces(row.clone(), 1).len(), row.len());
        assert_eq!(without_short_pieces(Vec::new(), 3), [[0; 2]; 0]);
    }
}
