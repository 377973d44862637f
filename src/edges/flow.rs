//! Colours that flow over the picture as far as no edge holds them back.
//!
//! A contour parts two areas; a blade of grass, a crease or a shadow's end can be walked round. So every cell of a coarse
//! grid takes the mean colour of all cells, each weighted with what is left of its colour after the way from there: a step
//! of height `h` on the way lets `exp(-h / 16)` through. Ways go along a row and then along a column, or first along the
//! column; both are averaged, so that the result turns with the picture. One pass is enough: two or three at shorter
//! ranges scored the same.
//!
//! This is the normalised convolution in the domain transform of Gastal and Oliveira (2011), with ridges found before as
//! the distance, without a limit to the range, and from both directions at once, so that it is the same in a mirror. It
//! does for a thousandth of the price what the eigenvectors of gPb do (Arbelaez et al. 2011): only what closes an area off
//! stays.

use super::chain::Chain;
use super::thin::Ridge;
use crate::units::Size;

/// A step this high lets 1/e of a colour through. On photographs 8 to 16 scored alike, 24 less by .003.
const HOLDS: f32 = 16.0;

/// Up to three colour axes, and the weight that they were summed with.
pub(super) type Cell = [f32; 4];

/// The colours of `cells` after they have flowed. `from` is the size of the picture in pixels.
pub(super) fn flow(cells: &[Cell], size: Size, from: Size, points: &[Ridge], chains: &[Chain]) -> Vec<Cell> {
    Walls::of(size, from, points, chains).flow(cells)
}

/// What passes from a cell to its neighbour, 0..=1.
struct Walls {
    width: usize,
    /// From each cell to the next on its right; the last of a row has none.
    right: Vec<f32>,
    /// From each cell to the one below; the last row has none.
    down: Vec<f32>,
}

impl Walls {
    /// Sums the steps between the centres of neighbouring cells. Points of a chain follow each other by one pixel along the
    /// edge's main axis, so an upright edge across a whole cell counts with its height, a slanting one with its share.
    fn of(size: Size, from: Size, points: &[Ridge], chains: &[Chain]) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let (x_scale, y_scale) = (size.width as f32 / from.width as f32, size.height as f32 / from.height as f32);
        let (mut right, mut down) = (vec![0.0; size.len()], vec![0.0; size.len()]);
        for chain in chains {
            let once = &chain[usize::from(chain.len() > 1 && chain.first() == chain.last())..];
            for point in once.iter().map(|&number| &points[number as usize]) {
                let (x, y) = (point.at.x * x_scale, point.at.y * y_scale);
                let [nx, ny] = point.normal.map(f32::abs);
                let step = point.step / nx.max(ny);
                for (row, share_y) in two((y - 0.5).clamp(0.0, (height - 1) as f32), height) {
                    for (column, share_x) in two(x - 1.0, width - 1) {
                        right[row * width + column] += share_x * share_y * step * nx * y_scale;
                    }
                }
                for (column, share_x) in two((x - 0.5).clamp(0.0, (width - 1) as f32), width) {
                    for (row, share_y) in two(y - 1.0, height - 1) {
                        down[row * width + column] += share_x * share_y * step * ny * x_scale;
                    }
                }
            }
        }
        let pass = |wall: &mut f32| *wall = (-*wall / HOLDS).exp();
        right.iter_mut().for_each(pass);
        down.iter_mut().for_each(pass);
        Self { width, right, down }
    }

    fn flow(&self, cells: &[Cell]) -> Vec<Cell> {
        let (rows_first, columns_first) =
            rayon::join(|| self.along_columns(&self.along_rows(cells)), || self.along_rows(&self.along_columns(cells)));
        let mean = |(a, b): (&Cell, &Cell)| std::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        rows_first.iter().zip(&columns_first).map(mean).collect()
    }

    fn along_rows(&self, cells: &[Cell]) -> Vec<Cell> {
        let mut out = cells.to_vec();
        for (row, pass) in out.chunks_exact_mut(self.width).zip(self.right.chunks_exact(self.width)) {
            let mut carried: Vec<Cell> = Vec::with_capacity(row.len());
            let mut sum = Cell::default();
            for x in (0..row.len()).rev() {
                carried.push(sum); // what comes from the right of the next cell
                sum = add(sum, row[x]);
                if x > 0 {
                    sum = sum.map(|v| v * pass[x - 1]);
                }
            }
            let mut sum = Cell::default();
            for (x, cell) in row.iter_mut().enumerate() {
                let own = *cell;
                *cell = normal(add(own, add(sum, carried[self.width - 1 - x])));
                sum = add(sum, own).map(|v| v * pass[x]);
            }
        }
        out
    }

    fn along_columns(&self, cells: &[Cell]) -> Vec<Cell> {
        let width = self.width;
        let mut out = cells.to_vec();
        // upwards first: in each cell what comes from below
        let mut sums = vec![Cell::default(); width];
        let mut below = vec![Cell::default(); cells.len()];
        for y in (0..cells.len() / width).rev() {
            let row = y * width..(y + 1) * width;
            below[row.clone()].copy_from_slice(&sums);
            if y > 0 {
                let pass = &self.down[(y - 1) * width..row.start];
                for ((sum, own), pass) in sums.iter_mut().zip(&cells[row]).zip(pass) {
                    *sum = add(*sum, *own).map(|v| v * pass);
                }
            }
        }
        sums.fill(Cell::default());
        for (i, cell) in out.iter_mut().enumerate() {
            let (sum, own) = (&mut sums[i % width], *cell);
            *cell = normal(add(own, add(*sum, below[i])));
            *sum = add(*sum, own).map(|v| v * self.down[i]);
        }
        out
    }
}

/// The two whole numbers around a place with their shares in it; what is not within 0..count has none. Shared out, because
/// an edge of a drawing may lie just between two cells, and in a mirror too.
fn two(at: f32, count: usize) -> impl Iterator<Item = (usize, f32)> {
    let first = at.floor();
    let share = at - first;
    [(first, 1.0 - share), (first + 1.0, share)]
        .into_iter()
        .filter(move |(i, _)| *i >= 0.0 && *i < count as f32)
        .map(|(i, share)| (i as usize, share))
}

fn add(a: Cell, b: Cell) -> Cell {
    std::array::from_fn(|i| a[i] + b[i])
}

/// Divided by its weight, which is at least its own cell's.
fn normal(cell: Cell) -> Cell {
    cell.map(|v| v / cell[3])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 12;

    /// Light on the left half and dark on the right, with a wall between them from the top down to `end`.
    fn scene(end: usize) -> (Walls, Vec<Cell>) {
        let mut walls = Walls { width: SIDE, right: vec![1.0; SIDE * SIDE], down: vec![1.0; SIDE * SIDE] };
        (0..end).for_each(|y| walls.right[y * SIDE + SIDE / 2 - 1] = 0.01);
        let light = |i: usize| if i % SIDE < SIDE / 2 { 80.0 } else { 20.0 };
        (walls, (0..SIDE * SIDE).map(|i| [light(i), 0.0, 0.0, 1.0]).collect())
    }

    fn difference(end: usize, row: usize) -> f32 {
        let (walls, cells) = scene(end);
        let flowed = walls.flow(&cells);
        flowed[row * SIDE + SIDE / 2 - 1][0] - flowed[row * SIDE + SIDE / 2][0]
    }

    #[test]
    fn what_closes_an_area_off_keeps_its_colours_apart_and_what_can_be_walked_round_does_not() {
        let (closed, short, open) = (difference(SIDE, 2), difference(4, 2), difference(0, 2));
        assert!(closed > 0.9 * 60.0, "{closed} of 60 is left beside a wall without a gap");
        assert!(short < 0.7 * closed, "{short} beside a short wall, {closed} beside a whole one");
        assert!(open.abs() < 1e-3, "{open} without a wall");
    }

    #[test]
    fn the_flow_is_the_same_in_a_mirror_and_turned_over_the_diagonal() {
        let value = |i: usize| ((i * 7919 + i * i * 31) % 97) as f32;
        let cells: Vec<Cell> = (0..SIDE * SIDE).map(|i| [value(i), value(i + 5), value(i + 9), 1.0]).collect();
        let pass = |i: usize| (-value(i) / 30.0).exp();
        let walls = Walls {
            width: SIDE,
            right: (0..SIDE * SIDE).map(|i| pass(i + 1)).collect(),
            down: (0..SIDE * SIDE).map(|i| pass(i + 3)).collect(),
        };
        let flowed = walls.flow(&cells);
        let map = |to: &dyn Fn(usize, usize) -> usize| -> Vec<usize> {
            (0..SIDE * SIDE).map(|i| to(i % SIDE, i / SIDE)).collect()
        };
        let mirror = map(&|x, y| y * SIDE + SIDE - 1 - x);
        // the wall between two cells belongs to the left one, which is the other one in the mirror
        let mirrored = Walls {
            width: SIDE,
            right: map(&|x, y| y * SIDE + (2 * SIDE - 2 - x) % SIDE).iter().map(|&i| walls.right[i]).collect(),
            down: mirror.iter().map(|&i| walls.down[i]).collect(),
        };
        let seen: Vec<Cell> = mirrored.flow(&mirror.iter().map(|&i| cells[i]).collect::<Vec<_>>());
        assert_eq!(seen, mirror.iter().map(|&i| flowed[i]).collect::<Vec<_>>(), "mirrored");
        let turn = map(&|x, y| x * SIDE + y);
        let turned = Walls {
            width: SIDE,
            right: turn.iter().map(|&i| walls.down[i]).collect(),
            down: turn.iter().map(|&i| walls.right[i]).collect(),
        };
        let seen: Vec<Cell> = turned.flow(&turn.iter().map(|&i| cells[i]).collect::<Vec<_>>());
        assert_eq!(seen, turn.iter().map(|&i| flowed[i]).collect::<Vec<_>>(), "turned over the diagonal");
    }
}
