//! How much keeps the regions on both sides of a place apart: the height in the tree at which they become one, as in an
//! ultrametric contour map (Arbelaez et al. 2011).

use super::grid::RegionGrid;
use super::tree::Tree;
use crate::units::PxPoint;

/// How far from a place a border may pass and still count there, cells.
const REACH: f32 = 2.5;

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
        let mut greatest = 0.0_f32;
        for y in rows {
            for (x, &of_cell) in columns.clone().zip(&self.of_cell[y * width..][columns.clone()]) {
                let centre = || PxPoint::new(x as f32 + 0.5, y as f32 + 0.5);
                if of_cell > greatest && (centre() - at).square_length() <= REACH * REACH {
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
mod tests {
    use super::super::tree::Detail;
    use super::*;
    use crate::raster::plane::Plane;
    use crate::units::Size;

    /// Three fields side by side: the first two unlike by 10, the third unlike them by 60.
    fn fields() -> Tree {
        let size = Size::new(90, 40);
        let of = |x: usize| [20.0, 30.0, 90.0][x / 30];
        let values = (0..size.len()).map(|cell| of(cell % size.width as usize)).collect();
        Tree::new(&[], &[Plane { size, values }], RegionGrid::new(size), Detail::CONTOURS)
    }

    #[test]
    fn a_border_is_as_high_as_what_keeps_its_two_sides_apart() {
        let heights = Heights::of(&fields());
        let [weak, strong, inside] = [30.0, 60.0, 15.0].map(|x| heights.near(PxPoint::new(x, 20.0)));
        assert!(strong > 1.5 * weak && weak > 0.0, "{weak} {strong}");
        assert!(inside < weak, "{inside} inside a field, {weak} at its border");
    }

    #[test]
    fn a_place_farther_than_the_reach_from_all_borders_has_none_and_one_outside_is_no_fault() {
        let heights = Heights { of_cell: vec![0.0; 100], grid: RegionGrid::new(Size::new(10, 10)) };
        let with = |cell: usize| {
            let mut of_cell = heights.of_cell.clone();
            of_cell[cell] = 7.0;
            Heights { of_cell, ..heights.clone() }
        };
        for (cell, at, height) in [
            (55, (5.5, 5.5), 7.0),
            (55, (5.5, 8.0), 7.0), // 2.5 cells away
            (55, (5.5, 8.1), 0.0),
            (0, (-1.0, -1.0), 7.0),
            (0, (f32::NAN, 1e9), 0.0),
            (9, (40.0, 0.5), 0.0), // right of the grid
            (90, (0.5, 40.0), 0.0),
        ] {
            let near = with(cell).near(PxPoint::from(at));
            assert!((near - height).abs() < 1e-6, "{near} at {at:?}, not {height}");
        }
    }

    #[test]
    fn heights_never_fall_towards_the_root() {
        let tree = fields();
        for node in &tree.nodes {
            for child in node.children.into_iter().flatten() {
                assert!(tree.nodes[child as usize].height <= node.height);
            }
        }
        assert!(tree.nodes.last().is_some_and(|root| root.height > 0.0));
    }
}
