//! What lies near a place: segments in a grid of square cells.

use super::nearest_on_segment;
use crate::units::{MmPoint, MmRect};

/// A segment with the half of its width and whose it is.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// One end.
    pub a: MmPoint,
    /// The other end.
    pub b: MmPoint,
    /// Half its width, mm.
    pub half_width: f32,
    /// Number of the line it belongs to.
    pub line: u32,
    /// Number of the vertex `a` in its line.
    pub index: u32,
    /// Way along its line to `a`, mm.
    pub arc: f32,
}

/// Segments, found again by place. A query looks at the cells within `reach` of it, no further.
#[derive(Debug, Clone)]
pub struct Nearby {
    origin: MmPoint,
    cell: f32,
    per_mm: f32,
    columns: usize,
    rows: usize,
    /// Each cell holds the segments that reach into its box, so that looking round reads memory in order.
    cells: Vec<Vec<Segment>>,
    /// Which cells hold something, so that emptying the grid is cheap.
    used: Vec<usize>,
}

impl Nearby {
    /// An empty grid of `cell` millimetres over `area`. Queries of any reach are answered; those of about a cell look
    /// at the fewest segments.
    pub fn new(area: MmRect, cell: f32) -> Self {
        let cell = cell.max(0.5); // finer cells cost memory and win nothing at the millimetre scale
        let columns = (area.width() / cell).ceil().max(1.0) as usize;
        let rows = (area.height() / cell).ceil().max(1.0) as usize;
        Self {
            origin: area.min,
            cell,
            per_mm: 1.0 / cell,
            columns,
            rows,
            cells: vec![Vec::new(); columns * rows],
            used: Vec::new(),
        }
    }

    /// Adds a segment.
    pub fn insert(&mut self, segment: Segment) {
        let (columns, rows) = self.covered(segment.a.min(segment.b), segment.a.max(segment.b));
        for row in rows {
            for column in columns.clone() {
                let cell = row * self.columns + column;
                if self.cells[cell].is_empty() {
                    self.used.push(cell);
                }
                self.cells[cell].push(segment);
            }
        }
    }

    /// Takes all segments out.
    pub fn clear(&mut self) {
        for cell in self.used.drain(..) {
            self.cells[cell].clear();
        }
    }

    /// Calls `visit` with the segments that may lie within `reach` of the box `low`-`high`; one segment can come
    /// several times, and some farther ones come too.
    pub fn around(&self, low: MmPoint, high: MmPoint, reach: f32, mut visit: impl FnMut(&Segment)) {
        let (columns, rows) =
            self.covered(MmPoint::new(low.x - reach, low.y - reach), MmPoint::new(high.x + reach, high.y + reach));
        for row in rows {
            for column in columns.clone() {
                self.cells[row * self.columns + column].iter().for_each(&mut visit);
            }
        }
    }

    /// Calls `visit` with the segments in the cells that the way from `from` to `to` leads through, nearest cells
    /// first; one segment can come several times. Only what lies in the area is seen.
    pub fn along(&self, from: MmPoint, to: MmPoint, mut visit: impl FnMut(&Segment)) {
        let place = |p: MmPoint| ((p.x - self.origin.x) / self.cell, (p.y - self.origin.y) / self.cell);
        let ((x, y), (end_x, end_y)) = (place(from), place(to));
        let (mut column, mut row) = (x.floor() as i64, y.floor() as i64);
        // Amanatides and Woo 1987: shares of the way at which it enters the next column and the next row
        let axis = |at: f32, end: f32| {
            let way = end - at;
            let step = if way > 0.0 { 1_i64 } else { -1 };
            let border = if way > 0.0 { at.floor() + 1.0 } else { at.floor() };
            if way == 0.0 { (step, f32::INFINITY, 0.0) } else { (step, (border - at) / way, 1.0 / way.abs()) }
        };
        let (step_x, mut next_x, each_x) = axis(x, end_x);
        let (step_y, mut next_y, each_y) = axis(y, end_y);
        loop {
            if (0..self.columns as i64).contains(&column) && (0..self.rows as i64).contains(&row) {
                self.cells[row as usize * self.columns + column as usize].iter().for_each(&mut visit);
            }
            if next_x.min(next_y) > 1.0 {
                break;
            }
            if next_x <= next_y {
                column += step_x;
                next_x += each_x;
            } else {
                row += step_y;
                next_y += each_y;
            }
        }
    }

    /// The segment nearest to `at` within `reach` (centre lines) that `wanted` lets pass: distance, nearest point,
    /// segment.
    pub fn nearest(
        &self,
        at: MmPoint,
        reach: f32,
        wanted: impl Fn(&Segment) -> bool,
    ) -> Option<(f32, MmPoint, Segment)> {
        let mut best: Option<(f32, MmPoint, Segment)> = None;
        self.around(at, at, reach, |segment| {
            // the distance first: it is cheaper than most questions of `wanted`
            let (distance, point) = nearest_on_segment(at, segment.a, segment.b);
            if distance <= reach && best.is_none_or(|(least, ..)| distance < least) && wanted(segment) {
                best = Some((distance, point, *segment));
            }
        });
        best
    }

    fn covered(&self, low: MmPoint, high: MmPoint) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let index = |value: f32, count: usize| (value * self.per_mm).clamp(0.0, (count - 1) as f32) as usize;
        let columns = index(low.x - self.origin.x, self.columns)..index(high.x - self.origin.x, self.columns) + 1;
        let rows = index(low.y - self.origin.y, self.rows)..index(high.y - self.origin.y, self.rows) + 1;
        (columns, rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::segment_distance;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn along_a_way_nothing_that_it_crosses_is_missed(
            raw in prop::collection::vec((0.0_f32..40.0, 0.0_f32..30.0, -3.0_f32..3.0, -3.0_f32..3.0), 1..40),
            way in (0.0_f32..40.0, 0.0_f32..30.0, -9.0_f32..9.0, -9.0_f32..9.0),
        ) {
            let mut nearby = Nearby::new(MmRect::new(MmPoint::zero(), MmPoint::new(40.0, 30.0)), 1.0);
            let inside = |x: f32, y: f32| MmPoint::new(x.clamp(0.0, 39.9), y.clamp(0.0, 29.9));
            let segments: Vec<_> = raw.iter().map(|&(x, y, dx, dy)| (inside(x, y), inside(x + dx, y + dy))).collect();
            for (index, &(a, b)) in segments.iter().enumerate() {
                nearby.insert(Segment { a, b, half_width: 0.0, line: 0, index: index as u32, arc: 0.0 });
            }
            let (from, to) = (inside(way.0, way.1), inside(way.0 + way.2, way.1 + way.3));
            let mut seen = Vec::new();
            nearby.along(from, to, |segment| seen.push(segment.index as usize));
            for (index, &segment) in segments.iter().enumerate() {
                let crosses = segment_distance((from, to), segment) == 0.0;
                prop_assert!(!crosses || seen.contains(&index), "segment {index} is missed");
            }
        }
    }
}
