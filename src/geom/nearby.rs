//! What lies near a place: the index of things by square cells, and of segments in particular.

use std::ops::Range;

use lyon::geom::euclid::{Box2D, Point2D, Vector2D};

use super::nearest_on_segment;
use super::polyline::{Located, PolylineRef};
use crate::units::Mm;

/// A segment with the half of its width and whose it is. Lengths are in the unit of its points.
#[derive(Debug, Clone, Copy)]
pub struct Segment<U = Mm> {
    /// One end.
    pub a: Point2D<f32, U>,
    /// The other end.
    pub b: Point2D<f32, U>,
    /// Half its width.
    pub half_width: f32,
    /// Number of the line it belongs to.
    pub line: u32,
    /// Number of the vertex `a` in its line.
    pub index: u32,
    /// Way along its line to `a`.
    pub arc: f32,
}

/// Entries found again by place, in pixels or millimetres. A query looks at the cells within `reach` of it, no further.
#[derive(Debug, Clone)]
pub struct Index<T, U> {
    origin: Point2D<f32, U>,
    cell: f32,
    per_unit: f32,
    columns: usize,
    rows: usize,
    /// Each cell holds the entries that reach into its box, so that looking round reads memory in order.
    cells: Vec<Vec<T>>,
    /// Which cells hold something, so that emptying the grid is cheap.
    used: Vec<usize>,
}

impl<T: Copy, U: Copy> Index<T, U> {
    /// An empty grid with cells of this side over `area`. Queries of any reach are answered; those of about a cell look
    /// at the fewest entries. What lies outside of the area is in the nearest cell.
    pub fn new(area: Box2D<f32, U>, cell: f32) -> Self {
        let cell = cell.max(0.5); // finer cells cost memory and win nothing, in millimetres and in pixels
        let columns = (area.width() / cell).ceil().max(1.0) as usize;
        let rows = (area.height() / cell).ceil().max(1.0) as usize;
        Self {
            origin: area.min,
            cell,
            per_unit: 1.0 / cell,
            columns,
            rows,
            cells: vec![Vec::new(); columns * rows],
            used: Vec::new(),
        }
    }

    /// Adds an entry at a point.
    pub fn put_at(&mut self, at: Point2D<f32, U>, entry: T) {
        let [column, row] = self.cell_of(at);
        self.put(row * self.columns + column, entry);
    }

    /// Adds an entry that reaches over the box `low`-`high`.
    pub fn put_over(&mut self, low: Point2D<f32, U>, high: Point2D<f32, U>, entry: T) {
        let (columns, rows) = self.covered(low, high);
        for row in rows {
            for column in columns.clone() {
                self.put(row * self.columns + column, entry);
            }
        }
    }

    fn put(&mut self, cell: usize, entry: T) {
        if self.cells[cell].is_empty() {
            self.used.push(cell);
        }
        self.cells[cell].push(entry);
    }

    /// Takes all entries out.
    pub fn clear(&mut self) {
        for cell in self.used.drain(..) {
            self.cells[cell].clear();
        }
    }

    /// Calls `visit` with the entries that may lie within `reach` of the box `low`-`high`; one entry can come several
    /// times, and some farther ones come too.
    pub fn around<'a>(&'a self, low: Point2D<f32, U>, high: Point2D<f32, U>, reach: f32, mut visit: impl FnMut(&'a T)) {
        self.each_cell(low, high, reach, |cell| cell.iter().for_each(&mut visit));
    }

    /// The entries that reach into the cell of a point, in the order in which they came.
    pub fn in_cell_of(&self, at: Point2D<f32, U>) -> &[T] {
        let [column, row] = self.cell_of(at);
        &self.cells[row * self.columns + column]
    }

    /// Whether `is_last` is true of one of the cells within `reach` of a point: no more are looked at then.
    fn any_cell(&self, at: Point2D<f32, U>, reach: f32, mut is_last: impl FnMut(&[T]) -> bool) -> bool {
        let (columns, mut rows) = self.covered(at - Vector2D::splat(reach), at + Vector2D::splat(reach));
        rows.any(|row| self.cells[row * self.columns..][columns.clone()].iter().any(|cell| is_last(cell)))
    }

    /// Calls `visit` with the cells within `reach` of the box `low`-`high`.
    fn each_cell<'a>(
        &'a self,
        low: Point2D<f32, U>,
        high: Point2D<f32, U>,
        reach: f32,
        mut visit: impl FnMut(&'a [T]),
    ) {
        let (columns, rows) =
            self.covered(Point2D::new(low.x - reach, low.y - reach), Point2D::new(high.x + reach, high.y + reach));
        for row in rows {
            self.cells[row * self.columns..][columns.clone()].iter().for_each(|cell| visit(cell));
        }
    }

    /// Calls `visit` with the cells that the segment from `from` to `to` leads through, the nearest first, and with the
    /// share of the segment at which each begins, as long as it wants more. One entry can come several times. Only what
    /// lies in the area is seen.
    pub fn along(&self, from: Point2D<f32, U>, to: Point2D<f32, U>, mut visit: impl FnMut(&[T], f32) -> bool) {
        let place = |p: Point2D<f32, U>| ((p.x - self.origin.x) / self.cell, (p.y - self.origin.y) / self.cell);
        let ((x, y), (end_x, end_y)) = (place(from), place(to));
        let (mut column, mut row) = (x.floor() as i64, y.floor() as i64);
        // Amanatides and Woo 1987: shares of the segment at which it enters the next column and the next row
        let axis = |at: f32, end: f32| {
            let delta = end - at;
            let step = if delta > 0.0 { 1_i64 } else { -1 };
            let border = if delta > 0.0 { at.floor() + 1.0 } else { at.floor() };
            if delta == 0.0 { (step, f32::INFINITY, 0.0) } else { (step, (border - at) / delta, 1.0 / delta.abs()) }
        };
        let (step_x, mut next_x, each_x) = axis(x, end_x);
        let (step_y, mut next_y, each_y) = axis(y, end_y);
        let mut begins = 0.0;
        loop {
            let is_inside = (0..self.columns as i64).contains(&column) && (0..self.rows as i64).contains(&row);
            if is_inside && !visit(&self.cells[row as usize * self.columns + column as usize], begins) {
                break;
            }
            begins = next_x.min(next_y);
            if begins > 1.0 {
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

    fn covered(&self, low: Point2D<f32, U>, high: Point2D<f32, U>) -> (Range<usize>, Range<usize>) {
        let ([left, top], [right, bottom]) = (self.cell_of(low), self.cell_of(high));
        (left..right + 1, top..bottom + 1)
    }

    /// Column and row of the cell that a point lies in; the nearest one if it lies outside.
    fn cell_of(&self, at: Point2D<f32, U>) -> [usize; 2] {
        let index = |value: f32, count: usize| (value * self.per_unit).clamp(0.0, (count - 1) as f32) as usize;
        [index(at.x - self.origin.x, self.columns), index(at.y - self.origin.y, self.rows)]
    }
}

/// What rounding may make of a distance, in millimetres or pixels.
const ROUNDING: f32 = 0.01;

/// Segments, found again by place.
#[derive(Debug, Clone)]
pub struct Nearby<U = Mm> {
    index: Index<Segment<U>, U>,
    /// The length of the longest segment.
    longest: f32,
}

impl<U: Copy> Nearby<U> {
    /// An empty index: see [`Index::new`].
    pub fn new(area: Box2D<f32, U>, cell: f32) -> Self {
        Self { index: Index::new(area, cell), longest: 0.0 }
    }

    /// Adds a segment.
    pub fn insert(&mut self, segment: Segment<U>) {
        self.longest = self.longest.max((segment.b - segment.a).length());
        self.index.put_over(segment.a.min(segment.b), segment.a.max(segment.b), segment);
    }

    /// Takes all segments out.
    pub fn clear(&mut self) {
        self.index.clear();
        self.longest = 0.0;
    }

    /// [`Index::around`] for segments.
    pub fn around<'a>(
        &'a self,
        low: Point2D<f32, U>,
        high: Point2D<f32, U>,
        reach: f32,
        visit: impl FnMut(&'a Segment<U>),
    ) {
        self.index.around(low, high, reach, visit);
    }

    /// [`Index::along`] for segments.
    pub fn along(&self, from: Point2D<f32, U>, to: Point2D<f32, U>, visit: impl FnMut(&[Segment<U>], f32) -> bool) {
        self.index.along(from, to, visit);
    }

    /// Adds the segments of a polyline, which is the line of this number and twice `half_width` wide.
    pub fn insert_line<V: Located<Unit = U>>(&mut self, line: u32, polyline: PolylineRef<'_, V>, half_width: f32) {
        let mut arc = 0.0;
        for (index, (a, b)) in (0..).zip(polyline.segments()) {
            let (a, b) = (a.at(), b.at());
            self.insert(Segment { a, b, half_width, line, index, arc });
            arc += (b - a).length();
        }
    }

    /// The length of the longest segment.
    pub fn longest(&self) -> f32 {
        self.longest
    }

    /// The farthest that a segment within `reach` can begin.
    fn farthest(&self, reach: f32) -> f32 {
        reach + self.longest + ROUNDING
    }

    /// [`Index::around`] for the segments that may lie within `reach` of a point; few farther ones come too: segments
    /// are short, so where each begins tells most of them.
    pub fn around_point(&self, at: Point2D<f32, U>, reach: f32, mut visit: impl FnMut(&Segment<U>)) {
        let square = self.farthest(reach).powi(2);
        self.around(at, at, reach, |segment| {
            if (segment.a - at).square_length() <= square {
                visit(segment);
            }
        });
    }

    /// [`Nearby::around_point`] until `is_last` is true of a segment; whether it was.
    pub fn any_around_point(
        &self,
        at: Point2D<f32, U>,
        reach: f32,
        mut is_last: impl FnMut(&Segment<U>) -> bool,
    ) -> bool {
        let square = self.farthest(reach).powi(2);
        self.index.any_cell(at, reach, |cell| {
            cell.iter().any(|segment| (segment.a - at).square_length() <= square && is_last(segment))
        })
    }

    /// Calls `visit` with the number of the line of each segment within `reach` of a point.
    pub fn each_line_at(&self, at: Point2D<f32, U>, reach: f32, mut visit: impl FnMut(usize)) {
        self.around(at, at, reach, |segment| {
            if nearest_on_segment(at, segment.a, segment.b).0 <= reach {
                visit(segment.line as usize);
            }
        });
    }

    /// Which lines end on which others, by their numbers, in order: each of `tips`, given with the number of its line,
    /// on the lines of segments within `reach`. `is_base` is asked of a segment and of the way along its line to the
    /// place there.
    pub fn which_end_on(
        &self,
        tips: impl Iterator<Item = (usize, Point2D<f32, U>)>,
        reach: f32,
        is_base: impl Fn(&Segment<U>, f32) -> bool,
    ) -> Vec<(usize, usize)> {
        let mut found = Vec::new();
        for (line, at) in tips {
            self.around(at, at, reach, |segment| {
                let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
                let arc = segment.arc + (touched - segment.a).length();
                if segment.line as usize != line && distance <= reach && is_base(segment, arc) {
                    found.push((line, segment.line as usize));
                }
            });
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The segment nearest to `at` within `reach` (centre lines) that `wanted` lets pass: distance, nearest point,
    /// segment.
    pub fn nearest(
        &self,
        at: Point2D<f32, U>,
        reach: f32,
        wanted: impl Fn(&Segment<U>) -> bool,
    ) -> Option<(f32, Point2D<f32, U>, Segment<U>)> {
        let mut best = Best::new(self, at, reach);
        self.around(at, at, reach, |segment| best.look(segment, &wanted));
        best.found()
    }

    /// [`Nearby::nearest`] among the segments of one line, in an index into which lines came one after another: in each
    /// cell those of one follow one another.
    pub fn nearest_of_line(
        &self,
        at: Point2D<f32, U>,
        reach: f32,
        line: u32,
    ) -> Option<(f32, Point2D<f32, U>, Segment<U>)> {
        let mut best = Best::new(self, at, reach);
        self.index.each_cell(at, at, reach, |cell| {
            of_line(cell, line).for_each(|segment| best.look(segment, |_| true));
        });
        best.found()
    }

    /// Whether [`Nearby::nearest_of_line`] would find a segment. The cell of the point is looked at first, and no more
    /// than is needed.
    pub fn is_near_line(&self, at: Point2D<f32, U>, reach: f32, line: u32) -> bool {
        let square = self.farthest(reach).powi(2);
        let is_near = |cell: &[Segment<U>]| {
            of_line(cell, line).any(|segment| {
                (segment.a - at).square_length() <= square && nearest_on_segment(at, segment.a, segment.b).0 <= reach
            })
        };
        is_near(self.index.in_cell_of(at)) || self.index.any_cell(at, reach, is_near)
    }
}

/// The segments of a line in a cell into which lines came one after another.
fn of_line<U>(cell: &[Segment<U>], line: u32) -> impl Iterator<Item = &Segment<U>> {
    debug_assert!(cell.is_sorted_by_key(|segment| segment.line), "lines came one after another");
    let start = cell.partition_point(|segment| segment.line < line);
    cell[start..].iter().take_while(move |segment| segment.line == line)
}

/// The nearest segment to a point among those looked at.
struct Best<'a, U> {
    at: Point2D<f32, U>,
    reach: f32,
    /// The length of the longest segment.
    longest: f32,
    /// The square of the farthest that a segment can begin that is within reach and nearer than the one found.
    square: f32,
    found: Option<(f32, Point2D<f32, U>, &'a Segment<U>)>,
}

impl<'a, U: Copy> Best<'a, U> {
    fn new(nearby: &Nearby<U>, at: Point2D<f32, U>, reach: f32) -> Self {
        Self { at, reach, longest: nearby.longest, square: nearby.farthest(reach).powi(2), found: None }
    }

    fn look(&mut self, segment: &'a Segment<U>, wanted: impl Fn(&Segment<U>) -> bool) {
        if (segment.a - self.at).square_length() > self.square {
            return;
        }
        let (distance, point) = nearest_on_segment(self.at, segment.a, segment.b);
        // `wanted` last: most of its questions cost more than the distance
        if distance <= self.reach && self.found.is_none_or(|(least, ..)| distance < least) && wanted(segment) {
            self.found = Some((distance, point, segment));
            self.square = (distance + self.longest + ROUNDING).powi(2);
        }
    }

    fn found(self) -> Option<(f32, Point2D<f32, U>, Segment<U>)> {
        self.found.map(|(distance, point, segment)| (distance, point, *segment))
    }
}

#[cfg(test)]
mod tests;
