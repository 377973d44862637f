//! Which places of a figure are free of lines, and how many glyphs of textures a place would cost.

use crate::geom::nearest_on_segment;
use crate::page::{Line, Pen, Texture};
use crate::units::{MmPoint, MmRect, MmVector};

/// Side of the squares that the figure is looked at in, mm. Chosen by us: a sixth of the distance that labels keep.
const SQUARE: f32 = 0.5;
/// From the middle of a square to its corner, mm.
const CORNER: f32 = 0.354;
/// Blank between a leader line and other lines, mm.
const LEADER_CLEARANCE: f32 = 1.5;

/// The figure in squares.
#[derive(Debug, Clone, Copy)]
struct Squares {
    area: MmRect,
    columns: usize,
    rows: usize,
}

/// What is in the squares: as sums over all of them above and to the left, so that a box is looked at in one step.
#[derive(Debug)]
pub(super) struct Room {
    squares: Squares,
    /// Squares nearer to a line than a label may lie.
    taken: Vec<u32>,
    /// Squares nearer to a line than a leader line may lie; no sums.
    for_leader: Vec<u32>,
    /// Squares that lines lie in; no sums.
    ink: Vec<u32>,
    /// Glyphs.
    glyphs: Vec<u32>,
}

impl Room {
    pub(super) fn new(area: MmRect, lines: &[Line], textures: &[Texture], clearance: f32) -> Self {
        let count = |mm: f32| (mm / SQUARE).ceil().max(1.0) as usize;
        let squares = Squares { area, columns: count(area.width()), rows: count(area.height()) };
        let none = || vec![0; squares.columns * squares.rows];
        let (mut taken, mut for_leader, mut ink, mut glyphs) = (none(), none(), none(), none());
        for run in lines.iter().flat_map(|line| &line.runs) {
            let half = 0.5 * run.width + CORNER;
            let mut mark = |a: MmPoint, b: MmPoint| {
                squares.around(a, b, half + clearance, |index| taken[index] = 1);
                squares.around(a, b, half + LEADER_CLEARANCE, |index| for_leader[index] = 1);
                squares.around(a, b, half, |index| ink[index] = 1);
            };
            match run.pen {
                Pen::Dots(_) => run.points.iter().for_each(|&at| mark(at, at)),
                Pen::Stroke => {
                    let path: Vec<MmPoint> = run.polyline().path().copied().collect();
                    path.windows(2).for_each(|pair| mark(pair[0], pair[1]));
                }
            }
        }
        for glyph in textures.iter().flat_map(|texture| &texture.glyphs) {
            if let Some(index) = squares.index(glyph.at) {
                glyphs[index] += 1;
            }
        }
        Self { squares, taken: squares.sums(&taken), for_leader, ink, glyphs: squares.sums(&glyphs) }
    }

    /// Whether a box lies in the area and as far from lines as labels must.
    pub(super) fn is_free(&self, place: MmRect) -> bool {
        self.squares.area.contains_box(&place) && self.squares.sum(&self.taken, place) == 0
    }

    /// How many glyphs lie in a box.
    pub(super) fn glyphs(&self, place: MmRect) -> u32 {
        self.squares.sum(&self.glyphs, place)
    }

    /// Whether a straight leader line would keep clear of other lines; `end` mm before its end it need not, as there is
    /// what it leads to.
    pub(super) fn is_free_way(&self, from: MmPoint, to: MmPoint, end: f32) -> bool {
        !self.meets(&self.for_leader, from, to, end)
    }

    /// Whether a line lies between two places; `end` mm before the second it does not count.
    pub(super) fn is_parted(&self, from: MmPoint, to: MmPoint, end: f32) -> bool {
        self.meets(&self.ink, from, to, end)
    }

    /// How much of a straight leader line lies near to other lines, mm, without the last `end` mm.
    pub(super) fn along(&self, from: MmPoint, to: MmPoint, end: f32) -> f32 {
        let length = (to - from).length();
        let steps = (length / SQUARE).ceil().max(1.0);
        let is_near = |step: u32| {
            let along = step as f32 / steps;
            let square = self.squares.index(from.lerp(to, along));
            (1.0 - along) * length > end && square.is_some_and(|index| self.for_leader[index] > 0)
        };
        (0..=steps as u32).filter(|step| is_near(*step)).count() as f32 * length / (steps + 1.0)
    }

    fn meets(&self, squares: &[u32], from: MmPoint, to: MmPoint, end: f32) -> bool {
        let length = (to - from).length();
        let steps = (length / SQUARE).ceil().max(1.0);
        (0..=steps as u32).any(|step| {
            let along = step as f32 / steps;
            let is_there = || self.squares.index(from.lerp(to, along)).is_some_and(|index| squares[index] > 0);
            (1.0 - along) * length > end && is_there()
        })
    }
}

impl Squares {
    /// Calls `visit` with the squares whose middle is nearer than `reach` to a segment.
    fn around(&self, a: MmPoint, b: MmPoint, reach: f32, mut visit: impl FnMut(usize)) {
        let (low, high) = (a.min(b) - MmVector::new(reach, reach), a.max(b) + MmVector::new(reach, reach));
        let range = |low: f32, high: f32, count: usize| {
            let at = |mm: f32| (mm / SQUARE).floor().clamp(0.0, count as f32) as usize;
            at(low)..(at(high) + 1).min(count)
        };
        for row in range(low.y - self.area.min.y, high.y - self.area.min.y, self.rows) {
            for column in range(low.x - self.area.min.x, high.x - self.area.min.x, self.columns) {
                let middle = self.area.min + MmVector::new(column as f32 + 0.5, row as f32 + 0.5) * SQUARE;
                if nearest_on_segment(middle, a, b).0 < reach {
                    visit(row * self.columns + column);
                }
            }
        }
    }

    fn index(&self, at: MmPoint) -> Option<usize> {
        let from = (at - self.area.min) / SQUARE;
        let inside = from.x >= 0.0 && from.y >= 0.0 && from.x < self.columns as f32 && from.y < self.rows as f32;
        inside.then(|| from.y as usize * self.columns + from.x as usize)
    }

    /// For each corner of squares what lies above and to the left of it.
    fn sums(&self, squares: &[u32]) -> Vec<u32> {
        let wide = self.columns + 1;
        let mut sums = vec![0; wide * (self.rows + 1)];
        for row in 0..self.rows {
            let mut of_row = 0;
            for column in 0..self.columns {
                of_row += squares[row * self.columns + column];
                sums[(row + 1) * wide + column + 1] = sums[row * wide + column + 1] + of_row;
            }
        }
        sums
    }

    /// The sum over all squares that a box touches.
    fn sum(&self, sums: &[u32], place: MmRect) -> u32 {
        let at = |mm: f32, count: usize| mm.clamp(0.0, count as f32) as usize;
        let low = (place.min - self.area.min) / SQUARE;
        let high = (place.max - self.area.min) / SQUARE;
        let (left, top) = (at(low.x.floor(), self.columns), at(low.y.floor(), self.rows));
        let (right, bottom) = (at(high.x.ceil(), self.columns), at(high.y.ceil(), self.rows));
        if right <= left || bottom <= top {
            return 0;
        }
        let sum = |row: usize, column: usize| sums[row * (self.columns + 1) + column];
        sum(bottom, right) + sum(top, left) - sum(top, right) - sum(bottom, left)
    }
}
