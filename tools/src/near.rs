//! The nearest of many points, through a grid.

use crate::P;

/// Points sorted into square cells.
pub struct Near {
    points: Vec<P>,
    /// Side of a cell, px; also how far [`Near::nearest`] sees.
    reach: f64,
    columns: usize,
    rows: usize,
    /// Numbers of points, cell after cell, and where each cell starts.
    order: Vec<u32>,
    starts: Vec<u32>,
}

impl Near {
    /// Points of a picture of `size` pixels, sorted for searches as far as `reach`.
    pub fn new(points: Vec<P>, size: [usize; 2], reach: f64) -> Self {
        let [columns, rows] = size.map(|n| (n as f64 / reach).ceil() as usize + 1);
        let mut near = Self { points, reach, columns, rows, order: Vec::new(), starts: vec![0; columns * rows + 1] };
        let cells: Vec<usize> = near.points.iter().map(|&p| near.cell(p)).collect();
        cells.iter().for_each(|&cell| near.starts[cell + 1] += 1);
        (1..near.starts.len()).for_each(|i| near.starts[i] += near.starts[i - 1]);
        let mut next = near.starts.clone();
        near.order = vec![0; cells.len()];
        for (number, &cell) in cells.iter().enumerate() {
            near.order[next[cell] as usize] = number as u32;
            next[cell] += 1;
        }
        near
    }

    fn cell(&self, p: P) -> usize {
        let [column, row] = self.place(p);
        row * self.columns + column
    }

    fn place(&self, p: P) -> [usize; 2] {
        // a negative number turns to 0
        [((p[0] / self.reach) as usize).min(self.columns - 1), ((p[1] / self.reach) as usize).min(self.rows - 1)]
    }

    /// Number and distance of the nearest point, if it is not farther than the reach.
    pub fn nearest(&self, p: P) -> Option<(usize, f64)> {
        let [column, row] = self.place(p);
        let mut best = (usize::MAX, self.reach * self.reach);
        for row in row.saturating_sub(1)..(row + 2).min(self.rows) {
            let cells =
                row * self.columns + column.saturating_sub(1)..row * self.columns + (column + 2).min(self.columns);
            let range = self.starts[cells.start] as usize..self.starts[cells.end] as usize;
            for &number in &self.order[range] {
                let at = self.points[number as usize];
                let square = (at[0] - p[0]).powi(2) + (at[1] - p[1]).powi(2);
                if square < best.1 || (best.0 == usize::MAX && square <= best.1) {
                    best = (number as usize, square);
                }
            }
        }
        (best.0 != usize::MAX).then(|| (best.0, best.1.sqrt()))
    }
}
