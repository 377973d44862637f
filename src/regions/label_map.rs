//! Chosen regions as areas that can be drawn: no part of one, and nothing between two, narrower than two lines may be.

use super::members::Members;
use super::tree::Tree;
use crate::geom::distance::squared_distances;
use crate::raster::shrink::Shrinker;
use crate::units::Size;

/// Sigma, mm, of the Gaussian within which the majority decides.
const MAJORITY: f32 = 0.5;
/// Side of the coarse cells in which widths are looked at, mm: a few to the distance of two lines.
const COARSE: f32 = 0.8;

/// For each cell the number of a chosen region, from 1 in their order, or 0 for the ground. `mm` is the side of a cell
/// on the sheet, `narrowest` the least width of an area or of what is between two, mm.
pub(super) fn label_map(tree: &Tree, chosen: &[u32], mm: f32, narrowest: f32) -> Vec<u8> {
    if chosen.is_empty() {
        return vec![0; tree.basin.len()];
    }
    let cells = tree.grid.cells;
    let scale = (mm / COARSE).min(1.0);
    let side = |cells: u32| ((cells as f32 * scale).round() as u32).clamp(1, cells);
    let coarse = Size::new(side(cells.width), side(cells.height));
    let labels = painted(tree, chosen);
    let small = majority(&labels, chosen.len(), [cells, coarse], MAJORITY / COARSE.max(mm));
    let radius = 0.5 * narrowest / mm * coarse.width as f32 / cells.width as f32;
    let opened = opened(&small, chosen.len(), coarse, radius);
    // an area that stays keeps its own fine border
    let place = |i: usize, to: u32, from: u32| ((2 * i + 1) * to as usize) / (2 * from as usize);
    let (width, across, down) = (cells.width as usize, coarse.width as usize, coarse.height as usize);
    let label = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        let (x, y) = (place(x, coarse.width, cells.width), place(y, coarse.height, cells.height));
        let around = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
        let stays = |y: usize, x: usize| opened[y * across + x] == (labels[cell], true);
        let stays = around(y, down).any(|y| around(x, across).any(|x| stays(y, x)));
        if stays { labels[cell] } else { opened[y * across + x].0 }
    };
    (0..labels.len()).map(label).collect()
}

/// The regions, small ones on large ones.
fn painted(tree: &Tree, chosen: &[u32]) -> Vec<u8> {
    let members = Members::of(tree);
    let mut order: Vec<usize> = (0..chosen.len()).collect();
    order.sort_by(|&a, &b| {
        let area = |i: usize| tree.nodes[chosen[i] as usize].area;
        area(b).total_cmp(&area(a)).then(a.cmp(&b))
    });
    let mut of_basin = vec![0_u8; tree.basins];
    for number in order {
        for (basin, label) in (0_u32..).zip(&mut of_basin) {
            if members.has(chosen[number], basin) {
                *label = number as u8 + 1;
            }
        }
    }
    tree.basin.iter().map(|&basin| of_basin[basin as usize]).collect()
}

/// The label that is most frequent around each cell of a coarse grid, within a Gaussian of `sigma` of its cells.
fn majority(labels: &[u8], count: usize, [fine, coarse]: [Size; 2], sigma: f32) -> Vec<u8> {
    let mut best = vec![0.0_f32; coarse.len()];
    let mut winner = vec![0; coarse.len()];
    let mut row = vec![0.0; fine.width as usize];
    for label in 0..=count as u8 {
        let mut shrinker = Shrinker::new(fine, coarse);
        for labels in labels.chunks_exact(fine.width as usize) {
            row.iter_mut().zip(labels).for_each(|(share, &other)| *share = f32::from(u8::from(other == label)));
            shrinker.push(&row);
        }
        let shares = shrinker.finish().blurred(sigma);
        for ((best, winner), share) in best.iter_mut().zip(&mut winner).zip(shares.values) {
            if share > *best {
                (*best, *winner) = (share, label);
            }
        }
    }
    winner
}

/// Opens every area with a disc of this radius, cells: for each cell the label of the nearest core that is left, and
/// whether the cell is in reach of its own. The frame of the picture narrows nothing.
fn opened(labels: &[u8], count: usize, size: Size, radius: f32) -> Vec<(u8, bool)> {
    let square = radius * radius;
    let (labels, padded, margin) = padded(labels, size, radius.ceil() as usize + 1);
    let mut nearest_core: Vec<(u8, u32, bool)> = labels.iter().map(|&label| (label, u32::MAX, false)).collect();
    for label in 0..=count as u8 {
        let is_other: Vec<bool> = labels.iter().map(|&other| other != label).collect();
        let is_core: Vec<bool> = squared_distances(&is_other, padded).iter().map(|to| *to as f32 > square).collect();
        let to_core = squared_distances(&is_core, padded);
        for ((core, own), distance) in nearest_core.iter_mut().zip(&labels).zip(to_core) {
            // of two that are as near, its own
            if distance < core.1 || (distance == core.1 && label == *own) {
                *core = (label, distance, distance as f32 <= square);
            }
        }
    }
    let (width, across) = (size.width as usize, padded.width as usize);
    let label = |cell: usize| {
        let (label, _, in_reach) = nearest_core[(cell / width + margin) * across + cell % width + margin];
        (label, in_reach)
    };
    (0..size.len()).map(label).collect()
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
mod tests {
    use super::*;

    /// A map of digits, opened.
    fn check(rows: &[&str], radius: f32, expected: &[&str]) {
        let size = Size::new(rows[0].len() as u32, rows.len() as u32);
        let labels: Vec<u8> = rows.iter().flat_map(|row| row.bytes()).map(|digit| digit - b'0').collect();
        let opened = opened(&labels, 2, size, radius);
        let found: Vec<String> = opened
            .chunks(rows[0].len())
            .map(|row| row.iter().map(|(label, _)| char::from(b'0' + label)).collect())
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn what_is_thin_goes_and_what_is_between_two_is_shared_by_them() {
        let bar = ["000000000", "000111000", "000111000", "000111000", "000010000", "000010000", "000000000"];
        let stout = ["000000000", "000111000", "000111000", "000111000", "000010000", "000000000", "000000000"];
        check(&bar, 1.0, &stout);
        let gap = ["111110222", "111110222", "111110222", "111110222"];
        let shared = ["111111222", "111111222", "111111222", "111111222"];
        check(&gap, 1.0, &shared);
    }

    #[test]
    fn the_frame_narrows_nothing() {
        let strip = ["0111", "0111", "0111", "0111"];
        check(&strip, 2.0, &strip);
    }
}
