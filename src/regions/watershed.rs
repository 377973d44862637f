//! Basins of a landscape: each cell belongs to the minimum that steepest descent reaches from it, over sides of cells,
//! without cells that stay between basins (drop of water principle: Cousty et al. 2009).

use crate::geom::components::four_neighbours;
use crate::raster::plane::Plane;

/// The basin of each cell, numbered from 0 in the order of their first cells, and how many there are.
pub(super) fn basins(landscape: &Plane) -> (Vec<u32>, usize) {
    let mut down = descents(landscape);
    cross_plains(landscape, &mut down);
    let mut basin = vec![u32::MAX; down.len()];
    let (mut count, mut descent) = (0, Vec::new());
    for start in 0..down.len() {
        let mut at = start;
        while basin[at] == u32::MAX && down[at] as usize != at {
            descent.push(at);
            at = down[at] as usize;
        }
        if basin[at] == u32::MAX {
            basin[at] = count;
            count += 1;
        }
        let number = basin[at];
        descent.drain(..).for_each(|cell| basin[cell] = number);
    }
    (basin, count as usize)
}

/// The lowest neighbour of each cell, or the cell itself where none is lower. Of equal ones it is that on the left,
/// then on the right, above, below.
fn descents(landscape: &Plane) -> Vec<u32> {
    let (width, height) = (landscape.size.width as usize, landscape.size.height as usize);
    let row = |y: usize| &landscape.values[y * width..][..width];
    let mut down = Vec::with_capacity(landscape.values.len());
    for y in 0..height {
        // beyond the edge of the picture is the cell itself, which is not lower
        let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
        let start = (y * width) as u32;
        for x in 0..width {
            let own = start + x as u32;
            let (mut lowest, mut cell) = (here[x], own);
            let mut look = |value: f32, other: u32| {
                let is_lower = value < lowest;
                lowest = if is_lower { value } else { lowest };
                cell = if is_lower { other } else { cell };
            };
            look(here[x.saturating_sub(1)], own.wrapping_sub(1));
            look(here[(x + 1).min(width - 1)], own + 1);
            look(above[x], own.wrapping_sub(width as u32));
            look(below[x], own + width as u32);
            down.push(cell);
        }
    }
    down
}

/// Leads the cells of plains to the nearest descent, or all to one cell where there is none.
fn cross_plains(landscape: &Plane, down: &mut [u32]) {
    let heights = &landscape.values;
    let is_stuck = |down: &[u32], cell: usize| down[cell] as usize == cell;
    let level = |a: usize, b: usize| heights[a].total_cmp(&heights[b]).is_eq();
    // from the rims of plains inwards, level by level
    let stuck: Vec<usize> = (0..down.len()).filter(|&cell| is_stuck(down, cell)).collect();
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
