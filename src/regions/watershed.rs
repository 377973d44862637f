//! Basins of a landscape: each cell belongs to the minimum that steepest descent reaches from it, over sides of cells,
//! without cells that stay between basins (drop of water principle: Cousty et al. 2009).

use crate::geom::components::four_neighbours;
use crate::raster::plane::Plane;

/// The basin of each cell, numbered from 0 in the order of their first cells, and how many there are.
pub(super) fn basins(landscape: &Plane) -> (Vec<u32>, usize) {
    let mut down = descents(landscape);
    cross_plains(landscape, &mut down);
    const NONE: u32 = u32::MAX;
    let mut basin = vec![NONE; down.len()];
    let mut count = 0;
    for start in 0..down.len() {
        if basin[start] != NONE {
            continue;
        }
        let mut at = start;
        while basin[at] == NONE && down[at] as usize != at {
            at = down[at] as usize;
        }
        if basin[at] == NONE {
            basin[at] = count;
            count += 1;
        }
        // the same way again
        let (number, mut at) = (basin[at], start);
        while basin[at] == NONE {
            basin[at] = number;
            at = down[at] as usize;
        }
    }
    (basin, count as usize)
}

/// The lowest neighbour of each cell, or the cell itself where none is lower. Of equal ones it is that on the left,
/// then on the right, above, below.
fn descents(landscape: &Plane) -> Vec<u32> {
    let (width, height) = (landscape.size.width as usize, landscape.size.height as usize);
    let row = |y: usize| &landscape.values[y * width..][..width];
    let mut down = Vec::with_capacity(landscape.values.len());
    // of several cells at once: the way to the neighbour, added to the cell's own number
    let [left, right, above, below] = [1_u32.wrapping_neg(), 1, (width as u32).wrapping_neg(), width as u32];
    let mut padded = Vec::with_capacity(width + 2);
    for y in 0..height {
        // beyond the edge of the picture is the cell itself, which is not lower
        let here = row(y);
        padded.clear();
        padded.extend_from_slice(&here[..1]);
        padded.extend_from_slice(here);
        padded.extend_from_slice(&here[width - 1..]);
        let beside = padded.iter().zip(&padded[2..]);
        let beyond = row(y.saturating_sub(1)).iter().zip(row((y + 1).min(height - 1)));
        let cells = here.iter().zip(beside.zip(beyond)).enumerate();
        down.extend(cells.map(|(x, (&here, ((&on_left, &on_right), (&on_top, &at_bottom))))| {
            let (mut lowest, mut way) = (here, 0);
            for (value, to) in [(on_left, left), (on_right, right), (on_top, above), (at_bottom, below)] {
                let is_lower = value < lowest;
                lowest = if is_lower { value } else { lowest };
                way = if is_lower { to } else { way };
            }
            ((y * width + x) as u32).wrapping_add(way)
        }));
    }
    down
}

/// Leads the cells of plains to the nearest descent, or all to one cell where there is none.
fn cross_plains(landscape: &Plane, down: &mut [u32]) {
    let heights = &landscape.values;
    let level = |a: usize, b: usize| heights[a].total_cmp(&heights[b]).is_eq();
    // from the rims of plains inwards, level by level
    let stuck: Vec<usize> =
        down.iter().enumerate().filter(|(cell, to)| **to as usize == *cell).map(|(cell, _)| cell).collect();
    let mut reached = vec![true; down.len()];
    stuck.iter().for_each(|&cell| reached[cell] = false);
    let rim = |&cell: &usize| four_neighbours(cell, landscape.size).filter(move |&next| level(cell, next));
    let mut front: Vec<usize> = stuck.iter().flat_map(rim).filter(|&cell| reached[cell]).collect();
    front.sort_unstable();
    front.dedup();
    while !front.is_empty() {
        let mut next_front = Vec::new();
        for &cell in &front {
            for next in four_neighbours(cell, landscape.size) {
                if !reached[next] && level(cell, next) {
                    reached[next] = true;
                    down[next] = cell as u32;
                    next_front.push(next);
                }
            }
        }
        front = next_front;
    }
    // what is left are minima of several cells
    for start in stuck {
        if !reached[start] {
            reached[start] = true;
            let mut todo = vec![start];
            while let Some(cell) = todo.pop() {
                for next in four_neighbours(cell, landscape.size) {
                    if !reached[next] && level(cell, next) {
                        reached[next] = true;
                        down[next] = start as u32;
                        todo.push(next);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
