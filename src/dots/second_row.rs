//! The second row of dots of a heavy line, on one side of the first.

use super::grid_dot::{GridDot, distance};
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
pub(super) fn on_grid(cells: &[GridDot], closed: bool) -> Vec<(usize, GridDot)> {
    let n = cells.len();
    let turn = if closed && signed_area(cells) < 0 { -1 } else { 1 };
    let mut out: Vec<(usize, GridDot)> = Vec::with_capacity(n);
    for (i, &[x, y]) in cells.iter().enumerate() {
        let before = if closed { cells[(i + n - 1) % n] } else { cells[i.saturating_sub(1)] };
        let after = if closed { cells[(i + 1) % n] } else { cells[(i + 1).min(n - 1)] };
        let [dx, dy] = [after[0] - before[0], after[1] - before[1]];
        let cell = if dx.abs() >= dy.abs() { [x, y + turn * dx.signum()] } else { [x - turn * dy.signum(), y] };
        if let Some(&(_, last)) = out.last() {
            // around the outside of a corner, where of two dots that are as near one is the corner of the line itself
            let other = |at: GridDot| [0, 1].map(|axis| last[axis] + cell[axis] - at[axis]);
            out.extend(between(last, cell).map(|at| (i, if cells.contains(&at) { other(at) } else { at })));
        }
        out.push((i, cell));
    }
    let mut seen: Vec<GridDot> = Vec::with_capacity(out.len());
    out.retain(|(_, cell)| {
        let is_new = !cells.contains(cell) && !seen.contains(cell);
        seen.push(*cell);
        is_new
    });
    out
}

/// Twice the signed area that a ring encloses; above 0 if it runs clockwise as a reader sees it.
fn signed_area(cells: &[GridDot]) -> i32 {
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
pub(super) fn without_short_pieces(row: Vec<(usize, GridDot)>, least: usize) -> Vec<GridDot> {
    let mut out = Vec::with_capacity(row.len());
    let mut piece: Vec<GridDot> = Vec::new();
    let mut finish = |piece: &mut Vec<GridDot>| {
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
mod tests;
