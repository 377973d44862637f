//! Which dots lie near a position: a grid index of square cells, for queries of the nearest dot that is left and of
//! neighbour lists.
//!
//! It is not the index of `geom::nearby`: positions are whole numbers over the whole range of `i32`, so that the order
//! is the same on every computer; they are taken out one by one; and a search goes outwards ring by ring until nothing
//! nearer can come, where the other looks at everything within a reach that is known before.

/// Where a dot is: across and down, in hundredths of a millimetre.
pub type DotPosition = [i32; 2];

/// The Euclidean distance of two positions, hundredths of a millimetre.
pub(super) fn distance(a: DotPosition, b: DotPosition) -> f64 {
    let (x, y) = (f64::from(a[0]) - f64::from(b[0]), f64::from(a[1]) - f64::from(b[1]));
    (x * x + y * y).sqrt()
}

/// Positions for each cell on average: few enough that a cell is searched quickly, enough that few cells are empty.
const PER_CELL: usize = 2;
/// Nearest neighbours, whatever their direction.
const NEAREST: usize = 6;
/// Nearest neighbours in each quadrant: in a line of dots the nearest all belong to the line, and these lead to the
/// next line (Johnson and McGeoch 1997, The Traveling Salesman Problem: a case study, section 3.3).
const PER_QUADRANT: usize = 2;
/// How many rings of cells are searched for neighbours; bounds the work where dots are sparse.
const MOST_RINGS: i32 = 10;

/// Positions by cells; those that are removed are found no more.
pub(super) struct PositionGrid<'a> {
    positions: &'a [DotPosition],
    low: DotPosition,
    cell: i64,
    columns: i32,
    rows: i32,
    /// Numbers of the positions in each cell, lowest first.
    cells: Vec<Vec<u32>>,
}

impl<'a> PositionGrid<'a> {
    pub(super) fn new(positions: &'a [DotPosition]) -> Self {
        let extreme =
            |axis: usize, pick: fn(i32, i32) -> i32| positions.iter().map(|p| p[axis]).reduce(pick).unwrap_or(0);
        let low = [extreme(0, i32::min), extreme(1, i32::min)];
        let size = |axis: usize, high: i32| i64::from(high) - i64::from(low[axis]) + 1;
        let (width, height) = (size(0, extreme(0, i32::max)), size(1, extreme(1, i32::max)));
        let wanted = (positions.len() / PER_CELL).max(1) as f64;
        // A row of dots has no area: its cells are no shorter than the row over their number.
        let area = width as f64 * height as f64;
        let cell = (area / wanted).sqrt().max(width.max(height) as f64 / wanted).ceil().max(1.0) as i64;
        let (columns, rows) = (((width - 1) / cell) as i32 + 1, ((height - 1) / cell) as i32 + 1);
        let mut grid = Self { positions, low, cell, columns, rows, cells: vec![Vec::new(); (columns * rows) as usize] };
        for (number, &position) in positions.iter().enumerate() {
            let [column, row] = grid.cell_of(position);
            grid.cells[(row * columns + column) as usize].push(number as u32);
        }
        grid
    }

    fn cell_of(&self, position: DotPosition) -> [i32; 2] {
        let index = |axis: usize, count: i32| {
            let cells = (i64::from(position[axis]) - i64::from(self.low[axis])).div_euclid(self.cell);
            cells.clamp(0, i64::from(count) - 1) as i32
        };
        [index(0, self.columns), index(1, self.rows)]
    }

    /// Removes a position.
    pub(super) fn remove(&mut self, number: u32) {
        let [column, row] = self.cell_of(self.positions[number as usize]);
        self.cells[(row * self.columns + column) as usize].retain(|&other| other != number);
    }

    /// The nearest position that was not removed and whose second coordinate is at most `lowest`; of several the first.
    pub(super) fn nearest(&self, to: DotPosition, lowest: i32) -> Option<u32> {
        let mut best: Option<(f64, u32)> = None;
        let last_row = self.cell_of([0, lowest])[1];
        for ring in 0..=self.columns.max(self.rows) {
            // Nothing in this ring or beyond it is nearer than the border of the ring before.
            if best.is_some_and(|(least, _)| least < f64::from(ring - 1) * self.cell as f64) {
                break;
            }
            self.ring(self.cell_of(to), ring, last_row, |number| {
                let position = self.positions[number as usize];
                let found = (distance(to, position), number);
                if position[1] <= lowest && best.is_none_or(|best| found < best) {
                    best = Some(found);
                }
            });
        }
        best.map(|(_, number)| number)
    }

    /// For each position the numbers of its neighbours: some nearest, and the nearest of each quadrant.
    pub(super) fn neighbours(&self) -> Vec<Vec<u32>> {
        (0..self.positions.len() as u32).map(|number| self.neighbours_of(number)).collect()
    }

    fn neighbours_of(&self, number: u32) -> Vec<u32> {
        let at = self.positions[number as usize];
        let mut found: Vec<(f64, u32)> = Vec::new();
        let mut seen_in = [0; 4];
        for ring in 0..=MOST_RINGS {
            // One ring more than is needed to fill the list, as a nearer position can lie in it.
            let full = found.len() > NEAREST && seen_in.iter().all(|&count| count >= PER_QUADRANT);
            self.ring(self.cell_of(at), ring, self.rows - 1, |other| {
                if other != number {
                    let position = self.positions[other as usize];
                    seen_in[quadrant(at, position)] += 1;
                    found.push((distance(at, position), other));
                }
            });
            if full {
                break;
            }
        }
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut taken_in = [0; 4];
        let mut rank = 0;
        found.retain(|&(_, other)| {
            let quadrant = quadrant(at, self.positions[other as usize]);
            taken_in[quadrant] += 1;
            rank += 1;
            rank <= NEAREST || taken_in[quadrant] <= PER_QUADRANT
        });
        found.into_iter().map(|(_, other)| other).collect()
    }

    /// Calls `visit` with what is in the cells `ring` away from the one at `middle`, no further down than `last_row`.
    fn ring(&self, [column, row]: [i32; 2], ring: i32, last_row: i32, mut visit: impl FnMut(u32)) {
        for y in (row - ring).max(0)..=(row + ring).min(last_row) {
            let whole = (y - row).abs() == ring;
            let step = if whole || ring == 0 { 1 } else { 2 * ring };
            let (mut x, end) = (column - ring, column + ring);
            while x <= end {
                if (0..self.columns).contains(&x) {
                    self.cells[(y * self.columns + x) as usize].iter().copied().for_each(&mut visit);
                }
                x += step;
            }
        }
    }
}

/// Which quarter of all directions; half-open, so that each direction belongs to one.
fn quadrant([x, y]: DotPosition, [to_x, to_y]: DotPosition) -> usize {
    if to_x > x && to_y <= y {
        0
    } else if to_x >= x && to_y > y {
        1
    } else if to_x < x && to_y >= y {
        2
    } else {
        3
    }
}

#[cfg(test)]
mod tests;
