//! How much keeps the regions on both sides of a place apart: the height in the tree at which they become one, as in an
//! ultrametric contour map (Arbelaez et al. 2011).

use super::grid::{REACH, RegionGrid};
use super::tree::Tree;
use crate::units::PxPoint;

/// Most columns of cells that are within [`REACH`] of a place.
const MOST_COLUMNS: usize = 2 * REACH.ceil() as usize + 1;

/// Heights of all borders of basins.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    grid: RegionGrid,
    /// The greatest height of the cracks beside each cell; 0 inside basins.
    of_cell: Vec<f32>,
}

impl Heights {
    /// How much keeps the regions of a tree on both sides of each border apart.
    pub fn of(tree: &Tree) -> Self {
        let parent = parents(tree);
        let mut of_cell = vec![0.0_f32; tree.basin.len()];
        for arc in &tree.arcs {
            let height = tree.nodes[meeting(arc.ends, &parent) as usize].height as f32;
            for crack in &tree.cracks[arc.cracks.clone()] {
                for cell in crack.cells(tree.grid) {
                    of_cell[cell] = of_cell[cell].max(height);
                }
            }
        }
        Self { grid: tree.grid, of_cell }
    }

    /// The greatest height of the borders that pass near a place of the picture, in units of strength; 0 if none does.
    pub fn near(&self, at: PxPoint) -> f32 {
        let at = self.grid.to_cells(at);
        let width = self.grid.cells.width as usize;
        let [columns, rows] = self.grid.around(at, REACH);
        // squares of the distances of their middles, along each axis
        let square = |cell: usize, at: f32| (cell as f32 + 0.5 - at).powi(2);
        let mut across = [0.0; MOST_COLUMNS];
        across.iter_mut().zip(columns.clone()).for_each(|(across, x)| *across = square(x, at.x));
        let mut greatest = 0.0_f32;
        for y in rows {
            let down = square(y, at.y);
            for (&of_cell, across) in self.of_cell[y * width..][columns.clone()].iter().zip(&across) {
                if of_cell > greatest && across + down <= REACH * REACH {
                    greatest = of_cell;
                }
            }
        }
        greatest
    }
}

/// The node that each node was merged into; of the last, itself.
fn parents(tree: &Tree) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..tree.nodes.len() as u32).collect();
    for (number, node) in (0_u32..).zip(&tree.nodes) {
        for child in node.children.into_iter().flatten() {
            parent[child as usize] = number;
        }
    }
    parent
}

/// The first region that has both basins of an arc. Every parent has a greater number than its children, and basins
/// with an arc between them are merged at last.
fn meeting([mut a, mut b]: [u32; 2], parent: &[u32]) -> u32 {
    while a != b {
        let lower = if a < b { &mut a } else { &mut b };
        *lower = parent[*lower as usize];
    }
    a
}

#[cfg(test)]
mod tests;
