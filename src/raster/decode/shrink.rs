//! Averages rows of linear light down to the working size as they come, so that a large picture is never held whole.
//!
//! Exact area coverage: a target pixel is the mean of the source area under it, and a source pixel cut by an edge counts
//! in two targets by the two parts of its area. The edges are worked out in whole numbers, so a picture turned round is
//! cut at the same places turned round.
//!
//! ```text
//!  source   |  0  |  1  |  2  |  3  |  4  |      5 px to 2: a target is 2.5 px wide
//!  target   |      0       |      1       |      pixel 2 goes half to the left and half to the right
//! ```

use std::ops::Range;

use crate::units::Size;

/// The source pixels under one target pixel, along one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    /// First source pixel.
    start: usize,
    /// One past the last source pixel.
    end: usize,
    /// How much of the first pixel is covered, 0..=1.
    first: f64,
    /// How much of the last pixel is covered, 0..=1; not used when there is but one pixel.
    last: f64,
}

impl Span {
    /// How much of source pixel `at` is covered; it has to be one of the span's.
    fn weight(&self, at: usize) -> f64 {
        if at == self.start {
            self.first
        } else if at + 1 == self.end {
            self.last
        } else {
            1.0
        }
    }
}

/// How far the picture, or the part of it that is used, reaches along one axis of the rows that come. A JPEG of 4001 pixels
/// decoded at 1/8 comes as 501 pixels of which the picture fills only 500 and one eighth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Extent {
    /// Where it begins, in parts of a pixel.
    start: u64,
    /// Its length, in parts of a pixel.
    length: u64,
    /// How many parts make a pixel.
    parts: u64,
}

impl Extent {
    /// `count` whole pixels after `start` others.
    pub(super) fn pixels(start: u32, count: u32) -> Self {
        Self { start: u64::from(start), length: u64::from(count), parts: 1 }
    }

    /// `count` pixels after `start` others, each scaled by `eighths` / 8.
    pub(super) fn scaled(start: u32, count: u32, eighths: u32) -> Self {
        let scaled = |pixels: u32| u64::from(pixels) * u64::from(eighths);
        Self { start: scaled(start), length: scaled(count), parts: 8 }
    }

    /// The spans of `target` pixels of equal width that fill the extent.
    fn spans(self, target: u32) -> Vec<Span> {
        let unit = self.parts * u64::from(target);
        let part = |units: u64| units as f64 / unit as f64;
        let before = self.start * u64::from(target);
        (0..u64::from(target))
            .map(|i| {
                let (from, to) = (before + i * self.length, before + (i + 1) * self.length);
                let (start, end) = (from / unit, to.div_ceil(unit));
                let first = part(to.min((start + 1) * unit) - from);
                let last = part(to - (end - 1) * unit);
                Span { start: start as usize, end: end as usize, first, last }
            })
            .collect()
    }

    /// Where the pixels begin that become `target` pixels just as they are.
    fn is_copied_to(self, target: u32) -> Option<usize> {
        (self.parts == 1 && self.length == u64::from(target)).then_some(self.start as usize)
    }

    /// Source pixels for one target pixel.
    fn ratio(self, target: u32) -> f64 {
        self.length as f64 / (self.parts * u64::from(target)) as f64
    }
}

/// Takes rows from the top and gives a smaller picture.
pub(super) struct Shrink {
    across: Vec<Span>,
    down: Vec<Span>,
    /// One over the source area of a target pixel.
    share: f64,
    /// Where the part begins across and down that is copied as it is, if nothing is to be averaged.
    same: Option<(usize, usize)>,
    /// The source row that comes next.
    row: usize,
    /// Sums for the target row in work, plane after plane. In f64: a narrow strip may have 65 thousand rows to a target
    /// pixel, and f32 would lose a part in a thousand there.
    sums: Vec<f64>,
    /// The row that came last, shrunk across.
    narrow: Vec<f64>,
    planes: Vec<Vec<f32>>,
}

impl Shrink {
    /// From a source of `width` by `height` to `target`, which is not larger, in `planes` planes.
    pub(super) fn new(width: Extent, height: Extent, target: Size, planes: usize) -> Self {
        let row = planes * target.width as usize;
        Self {
            across: width.spans(target.width),
            down: height.spans(target.height),
            share: 1.0 / (width.ratio(target.width) * height.ratio(target.height)),
            same: width.is_copied_to(target.width).zip(height.is_copied_to(target.height)),
            row: 0,
            sums: vec![0.0; row],
            narrow: vec![0.0; row],
            planes: (0..planes).map(|_| Vec::with_capacity(target.len())).collect(),
        }
    }

    /// The same for some rows of the target only, which are given by [`Shrink::finish`]; the first row to come is then that
    /// of [`Shrink::first_row`].
    pub(super) fn part(width: Extent, height: Extent, target: Size, planes: usize, rows: Range<usize>) -> Self {
        let mut part = Self::new(width, height, target, planes);
        part.down = part.down[rows].to_vec();
        part.row = part.first_row();
        if let Some((_, top)) = &mut part.same {
            *top = part.row;
        }
        part
    }

    /// The first source row that is looked at.
    pub(super) fn first_row(&self) -> usize {
        self.down.first().map_or(0, |span| span.start)
    }

    /// The source rows that are looked at.
    pub(super) fn rows(&self) -> Range<usize> {
        self.first_row()..self.down.last().map_or(0, |span| span.end)
    }

    /// Takes the next row: one slice for each plane, as wide as the source. Rows after the last are not looked at.
    pub(super) fn push(&mut self, planes: &[Vec<f32>]) {
        let row = self.row;
        self.row += 1;
        let height = self.down.len();
        let width = self.across.len();
        let mut target = self.planes.first().map_or(height, |plane| plane.len() / width);
        if target >= height {
            return;
        }
        if let Some((left, top)) = self.same {
            for (plane, row) in self.planes.iter_mut().zip(planes).filter(|_| row >= top) {
                plane.extend_from_slice(&row[left..left + width]);
            }
            return;
        }
        if self.down[target].start > row {
            return; // above the part that is used
        }
        for (narrow, row) in self.narrow.chunks_exact_mut(width).zip(planes) {
            shrink_across(&self.across, row, narrow);
        }
        while let Some(span) = self.down.get(target).filter(|span| span.start <= row) {
            let weight = span.weight(row);
            for (sum, value) in self.sums.iter_mut().zip(&self.narrow) {
                *sum += weight * value;
            }
            if row + 1 < span.end {
                return;
            }
            for (plane, sums) in self.planes.iter_mut().zip(self.sums.chunks_exact(width)) {
                plane.extend(sums.iter().map(|sum| (sum * self.share) as f32));
            }
            self.sums.fill(0.0);
            target += 1;
        }
    }

    /// The planes, when as many rows came as the source has; `None` when some are missing.
    pub(super) fn finish(self) -> Option<Vec<Vec<f32>>> {
        let length = self.across.len() * self.down.len();
        self.planes.iter().all(|plane| plane.len() == length).then_some(self.planes)
    }
}

fn shrink_across(spans: &[Span], row: &[f32], narrow: &mut [f64]) {
    for (sum, span) in narrow.iter_mut().zip(spans) {
        let covered = &row[span.start..span.end];
        *sum = match covered {
            [only] => span.first * f64::from(*only),
            [first, whole @ .., last] => {
                let whole: f64 = whole.iter().map(|&value| f64::from(value)).sum();
                span.first * f64::from(*first) + whole + span.last * f64::from(*last)
            }
            [] => 0.0,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shrunk(source: Size, target: Size, plane: &[f32]) -> Vec<f32> {
        let (width, height) = (Extent::pixels(0, source.width), Extent::pixels(0, source.height));
        let mut shrink = Shrink::new(width, height, target, 1);
        for row in plane.chunks_exact(source.width as usize) {
            shrink.push(&[row.to_vec()]);
        }
        shrink.finish().unwrap().remove(0)
    }

    fn mean(plane: &[f32]) -> f64 {
        plane.iter().map(|&value| f64::from(value)).sum::<f64>() / plane.len() as f64
    }

    /// A picture and a target that is not larger.
    fn pictures() -> impl Strategy<Value = (Size, Size, Vec<f32>)> {
        (1..40u32, 1..40u32)
            .prop_flat_map(|(width, height)| {
                let plane = prop::collection::vec(0.0..=1.0f32, (width * height) as usize);
                (Just(Size::new(width, height)), 1..=width, 1..=height, plane)
            })
            .prop_map(|(source, width, height, plane)| (source, Size::new(width, height), plane))
    }

    proptest! {
        #[test]
        fn the_mean_is_kept((source, target, plane) in pictures()) {
            let small = shrunk(source, target, &plane);
            prop_assert!((mean(&small) - mean(&plane)).abs() < 1e-6);
        }

        #[test]
        fn the_same_size_is_the_same_picture((source, _, plane) in pictures()) {
            prop_assert_eq!(shrunk(source, source, &plane), plane);
        }

        #[test]
        fn a_picture_turned_half_round_gives_the_page_turned_half_round((source, target, plane) in pictures()) {
            let turned: Vec<f32> = plane.iter().rev().copied().collect();
            let small = shrunk(source, target, &plane);
            let small_turned = shrunk(source, target, &turned);
            for (a, b) in small.iter().zip(small_turned.iter().rev()) {
                prop_assert!((a - b).abs() <= f32::EPSILON, "{a} {b}");
            }
        }

        #[test]
        fn one_colour_stays_exactly_that_colour((source, target, _) in pictures(), value in 0.0..=1.0f32) {
            let small = shrunk(source, target, &vec![value; source.len()]);
            prop_assert!(small.iter().all(|&v| (v - value).abs() <= f32::EPSILON), "{value} {small:?}");
        }
    }

    #[test]
    fn a_pixel_cut_by_an_edge_counts_on_both_sides() {
        let small = shrunk(Size::new(5, 1), Size::new(2, 1), &[1.0, 1.0, 0.0, 1.0, 0.0]);
        assert_eq!(small, [2.0 / 2.5, 1.0 / 2.5]);
    }

    #[test]
    fn a_part_of_a_pixel_beyond_the_picture_counts_as_little_as_there_is_of_it() {
        // 9 px at 1/8: one pixel and an eighth, of which the second is seen by its eighth only.
        let mut shrink = Shrink::new(Extent::scaled(0, 9, 1), Extent::pixels(0, 1), Size::new(1, 1), 1);
        shrink.push(&[vec![0.0, 1.0]]);
        assert_eq!(shrink.finish().unwrap(), [[(0.125 / 1.125) as f32]]);
    }

    #[test]
    fn a_strip_of_a_hundred_thousand_rows_keeps_its_mean() {
        let value = 0.1f32;
        let small = shrunk(Size::new(1, 100_000), Size::new(1, 1), &vec![value; 100_000]);
        assert_eq!(small, [value]);
    }

    #[test]
    fn missing_rows_are_seen() {
        let mut shrink = Shrink::new(Extent::pixels(0, 2), Extent::pixels(0, 2), Size::new(1, 1), 1);
        shrink.push(&[vec![0.0, 1.0]]);
        assert!(shrink.finish().is_none());
    }
}
