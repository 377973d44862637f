//! Chosen regions as areas that can be drawn: no part of one, and nothing between two, narrower than two lines may be.

use super::disc::CellDisc;
use super::majority::majority;
use super::tree::Tree;
use crate::geom::distance::{FAR, squared_distances};
use crate::units::Size;

/// Sigma, mm, of the Gaussian within which the majority decides.
const MAJORITY: f32 = 0.5;
/// Side of the coarse cells in which widths are looked at, mm: a few to the distance of two lines.
const COARSE: f32 = 0.8;
/// So many cells of two maps are held beside one another at once.
const AT_ONCE: usize = 16;

/// For each cell the number of a chosen region, from 1 in their order, or 0 for the ground. `narrowest` is the least
/// width of an area or of what is between two, mm.
pub(super) fn label_map(tree: &Tree, chosen: &[u32], mm_per_cell: f32, narrowest: f32) -> Vec<u8> {
    if chosen.is_empty() {
        return vec![0; tree.basin.len()];
    }
    let cells = tree.grid.cells;
    let scale = (mm_per_cell / COARSE).min(1.0);
    let side = |cells: u32| ((cells as f32 * scale).round() as u32).clamp(1, cells);
    let coarse = Size::new(side(cells.width), side(cells.height));
    let labels = painted(tree, chosen);
    let small = majority(&labels, chosen.len(), [cells, coarse], MAJORITY / COARSE.max(mm_per_cell));
    let radius = 0.5 * narrowest / mm_per_cell * coarse.width as f32 / cells.width as f32;
    let opened = opened(&small, coarse, radius);
    with_fine_borders(&labels, cells, &opened, coarse)
}

/// The opened map in fine cells: an area that stays keeps its own fine border. `labels` are those before.
fn with_fine_borders(labels: &[u8], cells: Size, opened: &[OpenedCell], coarse: Size) -> Vec<u8> {
    let place = |i: usize, to: u32, from: u32| ((2 * i + 1) * to as usize) / (2 * from as usize);
    let (width, across, down) = (cells.width as usize, coarse.width as usize, coarse.height as usize);
    let around = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
    let columns: Vec<usize> = (0..width).map(|x| place(x, coarse.width, cells.width)).collect();
    let (mut out, mut of_row, mut last) = (Vec::with_capacity(labels.len()), Vec::new(), None);
    for (row, labels) in labels.chunks_exact(width).enumerate() {
        let y = place(row, coarse.height, cells.height);
        if last.replace(y) != Some(y) {
            of_row = columns.iter().map(|&x| opened[y * across + x].label).collect();
        }
        out.extend_from_slice(&of_row);
        let out = &mut out[row * width..];
        // most cells have the label that they had
        for start in (0..width).step_by(AT_ONCE) {
            let some = start..(start + AT_ONCE).min(width);
            if out[some.clone()] == labels[some.clone()] {
                continue;
            }
            for i in some {
                let own = OpenedCell { label: labels[i], is_in_reach: true };
                let stays = || around(y, down).any(|y| opened[y * across..][around(columns[i], across)].contains(&own));
                if out[i] != own.label && stays() {
                    out[i] = own.label;
                }
            }
        }
    }
    out
}

/// The regions, small ones on large ones.
fn painted(tree: &Tree, chosen: &[u32]) -> Vec<u8> {
    let mut order: Vec<usize> = (0..chosen.len()).collect();
    order.sort_by(|&a, &b| {
        let area = |i: usize| tree.nodes[chosen[i] as usize].area;
        area(b).total_cmp(&area(a)).then(a.cmp(&b))
    });
    let mut of_basin = vec![0_u8; tree.basins];
    for number in order {
        for (basin, label) in (0_u32..).zip(&mut of_basin) {
            if tree.has(chosen[number], basin) {
                *label = number as u8 + 1;
            }
        }
    }
    tree.basin.iter().map(|&basin| of_basin[basin as usize]).collect()
}

/// What an opening makes of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct OpenedCell {
    /// The label of the nearest core that is left.
    label: u8,
    /// Whether that is no farther than the radius: the cell belongs to the opened area, and does not only lie between
    /// some.
    is_in_reach: bool,
}

/// Opens every area with a disc of this radius, cells. The edge of the picture narrows nothing.
fn opened(labels: &[u8], size: Size, radius: f32) -> Vec<OpenedCell> {
    let square = radius * radius;
    let (labels, padded, margin) = padded(labels, size, radius.ceil() as usize + 1);
    let is_core = cores(&labels, padded, square);
    let to_core = squared_distances(&is_core, padded);
    let (width, across) = (size.width as usize, padded.width as usize);
    let label = |cell: usize| {
        let cell = (cell / width + margin) * across + cell % width + margin;
        let own = labels[cell];
        match to_core[cell] {
            0 => OpenedCell { label: own, is_in_reach: true },
            FAR => OpenedCell { label: own, is_in_reach: false },
            distance => OpenedCell {
                label: nearest(cell, distance, &labels, &is_core, padded),
                is_in_reach: distance as f32 <= square,
            },
        }
    };
    (0..size.len()).map(label).collect()
}

/// Whether each cell is farther than a distance, given as its square, from all cells with another label.
fn cores(labels: &[u8], size: Size, square: f32) -> Vec<bool> {
    let disc = CellDisc::new(size, |of_cell| of_cell as f32 <= square);
    let mut is_core = vec![true; labels.len()];
    // the nearest cell with another label has a neighbour with the own one
    let width = size.width as usize;
    let mut at_border = vec![false; labels.len()];
    for cell in 0..labels.len() {
        let (right, below) = ((cell + 1) % width > 0, labels.get(cell + width));
        if right && labels[cell + 1] != labels[cell] {
            (at_border[cell], at_border[cell + 1]) = (true, true);
        }
        if below.is_some_and(|below| *below != labels[cell]) {
            (at_border[cell], at_border[cell + width]) = (true, true);
        }
    }
    for cell in (0..labels.len()).filter(|&cell| at_border[cell]) {
        for row in disc.around(cell) {
            let of_row = is_core[row.clone()].iter_mut().zip(&labels[row]);
            of_row.for_each(|(is_core, label)| *is_core &= *label == labels[cell]);
        }
    }
    is_core
}

/// The label of the core cells at a distance, given as its square, at which there is one; of several its own, or the
/// lowest.
fn nearest(cell: usize, distance: u32, labels: &[u8], is_core: &[bool], size: Size) -> u8 {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    let mut lowest = u8::MAX;
    for dx in 0..=distance.isqrt() {
        let dy = (distance - dx * dx).isqrt();
        if dx * dx + dy * dy != distance {
            continue;
        }
        let (dx, dy) = (dx as usize, dy as usize);
        for x in [x.checked_sub(dx), Some(x + dx).filter(|x| *x < width)].into_iter().flatten() {
            for y in [y.checked_sub(dy), Some(y + dy).filter(|y| *y < height)].into_iter().flatten() {
                let other = y * width + x;
                if is_core[other] && labels[other] == labels[cell] {
                    return labels[cell];
                }
                if is_core[other] {
                    lowest = lowest.min(labels[other]);
                }
            }
        }
    }
    lowest
}

/// A map with its outermost cells repeated around it.
fn padded(labels: &[u8], size: Size, margin: usize) -> (Vec<u8>, Size, usize) {
    let (width, height) = (size.width as usize, size.height as usize);
    let inside = |at: usize, end: usize| at.saturating_sub(margin).min(end - 1);
    let rows = (0..height + 2 * margin).map(|y| inside(y, height) * width);
    let all = rows.flat_map(|row| (0..width + 2 * margin).map(move |x| row + inside(x, width)));
    let padded = Size::new((width + 2 * margin) as u32, (height + 2 * margin) as u32);
    (all.map(|cell| labels[cell]).collect(), padded, margin)
}

#[cfg(test)]
mod tests;
