//! Averages planes over areas down to a smaller size, row by row as they come, so that a large picture is never held
//! whole.
//!
//! Exact area coverage: a target pixel is the mean of the source area under it, and a source pixel cut by an edge
//! counts in two targets by the two parts of its area. The edges are worked out in whole numbers, so a picture turned
//! or flipped is cut at the same places turned or flipped.
//!
//! ```text
//!  source   |  0  |  1  |  2  |  3  |  4  |      5 px to 2: a target is 2.5 px wide
//!  target   |      0       |      1       |      pixel 2 goes half to the left and half to the right
//! ```
//!
//! Rows are added up first, over whole vectors; only the sum of a row of targets is then shrunk along x.

use std::fmt::Debug;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Range};
use std::sync::Arc;

use pulp::{Arch, Simd, WithSimd};

use super::plane::Plane;
use super::planes::Raster;
use crate::units::Size;

/// What sums are made in: `f32`, or `f64` where a target may cover tens of thousands of rows, of which `f32` would lose
/// a part in a thousand.
pub trait Accumulator:
    Copy + Default + From<f32> + Add<Output = Self> + Mul<Output = Self> + AddAssign + Sum + Send + Sync + Debug
{
    /// The nearest value.
    fn from_f64(value: f64) -> Self;
    /// The nearest value.
    fn to_f32(self) -> f32;
}

impl Accumulator for f32 {
    fn from_f64(value: f64) -> Self {
        value as Self
    }
    fn to_f32(self) -> f32 {
        self
    }
}

impl Accumulator for f64 {
    fn from_f64(value: f64) -> Self {
        value
    }
    fn to_f32(self) -> f32 {
        self as f32
    }
}

/// How far the picture, or the part of it that is used, reaches along one axis of the rows that come. A JPEG of 4001
/// pixels decoded at 1/8 comes as 501 pixels of which the picture fills only 500 and one eighth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Extent {
    /// Where it begins, in parts of a pixel.
    start: u64,
    /// Its length, in parts of a pixel.
    length: u64,
    /// How many parts make a pixel.
    parts: u64,
}

impl Extent {
    /// `count` whole pixels after `start` others.
    pub(crate) fn pixels(start: u32, count: u32) -> Self {
        Self { start: u64::from(start), length: u64::from(count), parts: 1 }
    }

    /// `count` pixels after `start` others, each scaled by `eighths` / 8.
    pub(crate) fn scaled(start: u32, count: u32, eighths: u32) -> Self {
        let scaled = |pixels: u32| u64::from(pixels) * u64::from(eighths);
        Self { start: scaled(start), length: scaled(count), parts: 8 }
    }

    /// The spans of `target` pixels of equal width that fill the extent.
    fn spans<A: Accumulator>(self, target: u32) -> Vec<Span<A>> {
        // In units of which a source pixel has `unit` and a target pixel `length`.
        let unit = self.parts * u64::from(target);
        let before = self.start * u64::from(target);
        let span = |i: u64| {
            let (from, to) = (before + i * self.length, before + (i + 1) * self.length);
            let covered = |pixel: u64| to.min((pixel + 1) * unit) - from.max(pixel * unit);
            let weight = |pixel: u64| A::from_f64(covered(pixel) as f64 / self.length as f64);
            Span { start: (from / unit) as usize, weights: (from / unit..to.div_ceil(unit)).map(weight).collect() }
        };
        (0..u64::from(target)).map(span).collect()
    }

    /// Whether pixels become `target` pixels just as they are.
    fn is_copied_to(self, target: u32) -> bool {
        self.parts == 1 && self.length == u64::from(target)
    }
}

/// The source pixels under one target pixel, along one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Span<A> {
    /// First source pixel.
    pub start: usize,
    /// The share of every source pixel in the mean; they sum to 1.
    pub weights: Vec<A>,
}

/// The spans of `to` pixels along an axis that has `from`, as [`shrink`] has them.
pub fn spans(from: u32, to: u32) -> Vec<Span<f32>> {
    Extent::pixels(0, from).spans(to)
}

impl<A: Accumulator> Span<A> {
    /// The source pixel after the last.
    pub fn end(&self) -> usize {
        self.start + self.weights.len()
    }

    /// The mean of the source pixels under the target pixel.
    fn mean(&self, row: &[A]) -> A {
        let values = &row[self.start..self.end()];
        self.weights.iter().zip(values).map(|(weight, value)| *weight * *value).sum()
    }
}

/// A span of one to three source pixels, of which those that are not there weigh nothing. Most pictures are little
/// larger than they are worked on, so that no target pixel covers more.
#[derive(Debug, Clone, Copy)]
struct Narrow<A> {
    start: usize,
    weights: [A; NARROW],
}

/// Most pixels of a narrow span.
const NARROW: usize = 3;

impl<A: Accumulator> Narrow<A> {
    /// A span, if it is narrow.
    fn of(span: &Span<A>) -> Option<Self> {
        let count = span.weights.len();
        let weight = |i: usize| span.weights.get(i).copied().unwrap_or_default();
        (1..=NARROW).contains(&count).then(|| Self { start: span.start, weights: [0, 1, 2].map(weight) })
    }

    /// The mean of the source pixels under the target pixel, of a row with some more behind its end.
    fn mean(&self, row: &[A]) -> A {
        let [a, b, c] = self.weights;
        match &row[self.start..self.start + NARROW] {
            [first, second, third] => a * *first + b * *second + c * *third,
            _ => A::default(),
        }
    }
}

/// Shrinks a plane whose rows come one after another, the first one first: whoever has others calls
/// [`Shrinker::skip_to`].
#[derive(Debug, Clone)]
pub struct Shrinker<A = f32> {
    arch: Arch,
    across: Arc<[Span<A>]>,
    /// The same, if all are narrow.
    narrow: Option<Arc<[Narrow<A>]>>,
    /// Of the rows that are made here.
    down: Arc<[Span<A>]>,
    /// Whether nothing is to be averaged.
    is_copy: bool,
    /// Weighted sum of the rows of the target row in work, with a few zeros behind it.
    sum: Vec<A>,
    /// Whether that has a row yet; what is in it else is of the target row before.
    is_begun: bool,
    /// The source row that comes next.
    next_row: usize,
    /// The target row in work, of those made here.
    target: usize,
    /// The rows that are done.
    out: Vec<f32>,
    /// Of the plane that the rows fill.
    size: Size,
}

impl Shrinker<f32> {
    /// For a plane of `from` pixels that becomes one of `to`, which is not larger.
    pub fn new(from: Size, to: Size) -> Self {
        Self::part(from, to, 0..from.height as usize)
    }

    /// Makes only those rows of the small plane whose cells begin in these rows of the large one.
    pub fn part(from: Size, to: Size, begin: Range<usize>) -> Self {
        let (across, down) = (Extent::pixels(0, from.width), Extent::pixels(0, from.height));
        // Of target row i the first source row is floor(i * from / to), so those before row r are ceil(r * to / from).
        let before = |row: usize| {
            let rows = (row as u64 * u64::from(to.height)).div_ceil(from.height.into());
            rows.min(to.height.into()) as usize
        };
        let rows = before(begin.start)..before(begin.end).max(before(begin.start));
        Self::of_rows(from.width, across, down, to, rows)
    }
}

impl<A: Accumulator> Shrinker<A> {
    /// For rows of `width` pixels, of which the extents `across` and `down` become a plane of `to` pixels, which is not
    /// larger; makes only the rows `rows` of it.
    pub(crate) fn of_rows(width: u32, across: Extent, down: Extent, to: Size, rows: Range<usize>) -> Self {
        let is_copy = across.is_copied_to(to.width) && down.is_copied_to(to.height);
        let size = Size::new(to.width, rows.len() as u32);
        let down: Arc<[Span<A>]> = down.spans(to.height).drain(rows).collect();
        let across: Arc<[Span<A>]> = across.spans(to.width).into();
        Self {
            arch: Arch::new(),
            narrow: across.iter().map(Narrow::of).collect(),
            across,
            is_copy,
            sum: if is_copy { Vec::new() } else { vec![A::default(); width as usize + NARROW] },
            is_begun: false,
            next_row: 0,
            down,
            target: 0,
            out: Vec::new(),
            size,
        }
    }

    /// The rows of the large plane in which the rows made here begin.
    pub fn starts(&self) -> Vec<usize> {
        self.down.iter().map(|span| span.start).collect()
    }

    /// The rows of the large plane that are looked at.
    pub fn rows(&self) -> Range<usize> {
        match &self.down[..] {
            [] => 0..0,
            [first, ..] => first.start..self.down.last().map_or(0, Span::end),
        }
    }

    /// The next row to come is this one of the large plane. Those before it that have not come count as 0.
    pub fn skip_to(&mut self, row: usize) {
        debug_assert!(row >= self.next_row, "row {} is the next", self.next_row);
        self.next_row = row;
        if self.is_copy {
            // they are no part of a sum
            let skipped = self.down[self.target..].iter().take_while(|span| span.start < row).count();
            self.target += skipped;
            self.out.resize(self.out.len() + skipped * self.across.len(), 0.0);
        }
    }

    /// Adds the rows below those made here.
    pub fn append(&mut self, below: Self) {
        let (mut own, below) = (self.filled(), below.finish());
        own.extend(below.values);
        self.out = own;
        self.size.height += below.size.height;
    }

    /// Takes the next row, from the top. Rows that are not looked at may come as well.
    pub fn push(&mut self, row: &[f32]) {
        let width = self.across.len();
        // A row lies under one target row, or on the boundary of two.
        while let Some(span) = self.down.get(self.target)
            && span.start <= self.next_row
        {
            // all at once, and only where rows come: clones are made before
            if self.out.capacity() == 0 {
                self.out.reserve_exact(self.size.len());
            }
            if self.is_copy {
                let left = self.across.first().map_or(0, |span| span.start);
                self.out.extend_from_slice(&row[left..left + width]);
                self.target += 1;
                break;
            }
            let place = self.next_row - span.start;
            if let Some(&weight) = span.weights.get(place) {
                let is_first = !std::mem::replace(&mut self.is_begun, true);
                self.arch.dispatch(AddRow { sum: &mut self.sum, row, weight, is_first });
            }
            if place + 1 < span.weights.len() {
                break;
            }
            if !std::mem::replace(&mut self.is_begun, false) {
                self.sum.fill(A::default());
            }
            match &self.narrow {
                Some(narrow) => self.out.extend(narrow.iter().map(|of| of.mean(&self.sum).to_f32())),
                None => self.out.extend(self.across.iter().map(|of| of.mean(&self.sum).to_f32())),
            }
            self.target += 1;
        }
        self.next_row += 1;
    }

    /// The small plane; what rows that have not come would have filled is 0.
    pub fn finish(mut self) -> Plane {
        Plane { values: self.filled(), size: self.size }
    }

    /// Takes all rows, with 0 for those that have not come.
    fn filled(&mut self) -> Vec<f32> {
        let mut rows = std::mem::take(&mut self.out);
        rows.resize(self.size.len(), 0.0);
        rows
    }

    /// The small plane; `None` when rows are missing.
    pub(crate) fn finish_whole(self) -> Option<Plane> {
        (self.target == self.down.len()).then(|| self.finish())
    }
}

struct AddRow<'a, A> {
    sum: &'a mut [A],
    row: &'a [f32],
    weight: A,
    /// Whether it is the first one of the sum.
    is_first: bool,
}

impl<A: Accumulator> WithSimd for AddRow<'_, A> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let of_row = self.sum.iter_mut().zip(self.row);
        if self.is_first {
            // added to 0, as -0 would stay
            of_row.for_each(|(sum, value)| *sum = A::default() + self.weight * A::from(*value));
        } else {
            of_row.for_each(|(sum, value)| *sum += self.weight * A::from(*value));
        }
    }
}

/// Averages a plane of `from` pixels over areas down to `to`, which is not larger. Each new pixel is the mean over
/// exactly the area that it covers, so a picture turned or flipped shrinks to the turned or flipped result.
pub fn shrink(values: &[f32], from: Size, to: Size) -> Plane {
    let mut shrinker = Shrinker::new(from, to);
    values.chunks_exact(from.width as usize).for_each(|row| shrinker.push(row));
    shrinker.finish()
}

impl Plane {
    /// [`shrink`] for a plane that knows its size.
    pub fn shrunk(&self, size: Size) -> Self {
        shrink(&self.values, self.size, size)
    }
}

impl Raster {
    /// [`shrink`] of all planes.
    pub fn shrunk(&self, size: Size) -> Self {
        Self::new(size, self.planes().as_ref().map(|plane| shrink(plane, self.size(), size).values))
    }
}

#[cfg(test)]
mod tests;
