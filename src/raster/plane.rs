//! One plane of numbers: shrink, blur, look up between the pixels.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use crate::units::Size;

/// Numbers on a pixel grid, rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// Width and height.
    pub size: Size,
    /// `width * height` values.
    pub values: Vec<f32>,
}

impl Plane {
    /// A plane full of `value`.
    pub fn filled(size: Size, value: f32) -> Self {
        Self { size, values: vec![value; size.len()] }
    }

    /// The value at a place in pixels (centres at +0.5), bilinear; beyond the border the nearest pixel counts.
    pub fn at(&self, x: f32, y: f32) -> f32 {
        Self::look_up(&self.values, self.size, x, y)
    }

    /// [`Plane::at`] for values that are not in a `Plane`.
    pub fn look_up(values: &[f32], size: Size, x: f32, y: f32) -> f32 {
        let (width, height) = (size.width as usize, size.height as usize);
        let fx = (x - 0.5).clamp(0.0, (width - 1) as f32);
        let fy = (y - 0.5).clamp(0.0, (height - 1) as f32);
        let (left, top) = (fx as usize, fy as usize);
        let (right, bottom) = ((left + 1).min(width - 1), (top + 1).min(height - 1));
        let (tx, ty) = (fx - left as f32, fy - top as f32);
        let row = |y: usize| {
            let row = &values[y * width..(y + 1) * width];
            row[left] * (1.0 - tx) + row[right] * tx
        };
        row(top) * (1.0 - ty) + row(bottom) * ty
    }

    /// Averages over areas down to `size`, which is not larger than the plane's own. Each new pixel is the mean over
    /// exactly the area that it covers, so a picture turned or flipped shrinks to the turned or flipped result.
    pub fn shrunk(&self, size: Size) -> Self {
        shrink(&self.values, self.size, size)
    }

    /// Blurs with a Gaussian of `sigma` pixels; beyond the border the nearest pixel counts.
    pub fn blurred(self, sigma: f32) -> Self {
        if sigma <= 0.0 {
            return self;
        }
        Arch::new().dispatch(Filter { plane: self, kernel: &gauss(sigma) })
    }

    /// Filters with an even kernel (half of it given) along x, then along y.
    #[inline(always)]
    fn filtered(self, kernel: &[f32]) -> Self {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let mut across = vec![0.0; self.values.len()];
        let mut padded = Vec::new();
        for (from, to) in self.values.chunks_exact(width).zip(across.chunks_exact_mut(width)) {
            pad(from, kernel.len() - 1, &mut padded);
            filter_row(&padded, kernel, to);
        }
        let mut values = self.values;
        for (y, to) in values.chunks_exact_mut(width).enumerate() {
            let row = |at: isize| {
                let at = at.clamp(0, height as isize - 1) as usize;
                &across[at * width..(at + 1) * width]
            };
            to.iter_mut().zip(row(y as isize)).for_each(|(to, v)| *to = kernel[0] * v);
            for (step, k) in kernel.iter().enumerate().skip(1) {
                let (above, below) = (row(y as isize - step as isize), row(y as isize + step as isize));
                for i in 0..width {
                    to[i] += k * (above[i] + below[i]);
                }
            }
        }
        Self { size: self.size, values }
    }
}

struct Filter<'a> {
    plane: Plane,
    kernel: &'a [f32],
}

impl WithSimd for Filter<'_> {
    type Output = Plane;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Plane {
        self.plane.filtered(self.kernel)
    }
}

/// [`Plane::shrunk`] for values that are not in a `Plane`.
pub fn shrink(values: &[f32], from: Size, to: Size) -> Plane {
    let mut shrinker = Shrinker::new(from, to);
    values.chunks_exact(from.width as usize).for_each(|row| shrinker.push(row));
    shrinker.finish()
}

/// Shrinks a plane whose rows come one after another, so that the large plane need not exist.
///
/// Rows are added up first, over whole vectors; only the sum of a row of cells is then shrunk along x.
#[derive(Debug)]
pub struct Shrinker {
    arch: Arch,
    columns: Vec<(usize, Vec<f32>)>,
    rows: Vec<(usize, Vec<f32>)>,
    /// Weighted sum of the rows of the cell that is being filled.
    sum: Vec<f32>,
    next_row: usize,
    /// Rows of cells, as they are counted in the whole plane: the first that is filled, and the one in work.
    first_cell: usize,
    cell: usize,
    out: Plane,
}

impl Shrinker {
    /// For a plane of `from` pixels that becomes one of `to`, which is not larger.
    pub fn new(from: Size, to: Size) -> Self {
        Self::part(from, to, 0..from.height as usize)
    }

    /// Makes only those rows of the small plane whose cells begin in these rows of the large one.
    pub fn part(from: Size, to: Size, begin: Range<usize>) -> Self {
        let mut rows = shares(from.height, to.height);
        let before = |row: usize| rows.iter().take_while(|(first, _)| *first < row).count();
        let (first_cell, end) = (before(begin.start), before(begin.end));
        rows.truncate(end);
        Self {
            arch: Arch::new(),
            columns: shares(from.width, to.width),
            rows,
            sum: vec![0.0; from.width as usize],
            next_row: 0,
            first_cell,
            cell: first_cell,
            out: Plane::filled(Size::new(to.width, end.saturating_sub(first_cell) as u32), 0.0),
        }
    }

    /// The rows of the large plane in which cells begin.
    pub fn starts(&self) -> Vec<usize> {
        self.rows[self.first_cell.min(self.rows.len())..].iter().map(|(first, _)| *first).collect()
    }

    /// The rows of the large plane that are looked at.
    pub fn rows(&self) -> Range<usize> {
        match self.rows.get(self.first_cell..) {
            Some([(first, _), ..]) => *first..self.rows.last().map_or(*first, |(last, weights)| last + weights.len()),
            _ => 0..0,
        }
    }

    /// Says which row of the large plane comes first, if not its first. Rows that are not looked at may come as well.
    pub fn start(&mut self, row: usize) {
        self.next_row = row;
    }

    /// Adds the rows below those made here.
    pub fn append(&mut self, below: Self) {
        self.out.size.height += below.out.size.height;
        self.out.values.extend(below.out.values);
    }

    /// Takes the next row, from the top.
    pub fn push(&mut self, row: &[f32]) {
        let width = self.out.size.width as usize;
        // a row lies in one cell, or on the border of two
        while let Some((first, weights)) = self.rows.get(self.cell)
            && *first <= self.next_row
        {
            let place = self.next_row - first;
            if let Some(&weight) = weights.get(place) {
                self.arch.dispatch(AddRow { sum: &mut self.sum, row, weight });
            }
            if place + 1 < weights.len() {
                break;
            }
            let to = &mut self.out.values[(self.cell - self.first_cell) * width..][..width];
            for (to, (first, weights)) in to.iter_mut().zip(&self.columns) {
                *to = weights.iter().zip(&self.sum[*first..]).map(|(weight, value)| weight * value).sum();
            }
            self.sum.fill(0.0);
            self.cell += 1;
        }
        self.next_row += 1;
    }

    /// The small plane.
    pub fn finish(self) -> Plane {
        self.out
    }
}

struct AddRow<'a> {
    sum: &'a mut [f32],
    row: &'a [f32],
    weight: f32,
}

impl WithSimd for AddRow<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.sum.iter_mut().zip(self.row).for_each(|(sum, value)| *sum += self.weight * value);
    }
}

/// For each of `to` cells along a side of `from` pixels: the first pixel and the share of every pixel in the mean.
fn shares(from: u32, to: u32) -> Vec<(usize, Vec<f32>)> {
    let step = f64::from(from) / f64::from(to);
    (0..to)
        .map(|cell| {
            let (start, end) = (f64::from(cell) * step, f64::from(cell + 1) * step);
            let first = start.floor() as u32;
            let last = (end.ceil() as u32).clamp(first + 1, from);
            let covered = |pixel: u32| (end.min(f64::from(pixel + 1)) - start.max(f64::from(pixel))).max(0.0);
            (first as usize, (first..last).map(|pixel| (covered(pixel) / step) as f32).collect())
        })
        .collect()
}

/// Half of a Gaussian kernel, from its centre outwards to 3 sigma (which keeps 99.7 % of it); the whole sums to 1.
pub fn gauss(sigma: f32) -> Vec<f32> {
    let sigma = f64::from(sigma);
    let radius = (3.0 * sigma).ceil() as usize;
    let weights: Vec<f64> = (0..=radius).map(|i| (-0.5 * (i as f64 / sigma).powi(2)).exp()).collect();
    let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
    weights.iter().map(|w| (w / sum) as f32).collect()
}

/// Copies a row with `radius` repeats of its first and last value at its ends.
fn pad(row: &[f32], radius: usize, padded: &mut Vec<f32>) {
    padded.clear();
    let (Some(&first), Some(&last)) = (row.first(), row.last()) else { return };
    padded.extend(std::iter::repeat_n(first, radius));
    padded.extend_from_slice(row);
    padded.extend(std::iter::repeat_n(last, radius));
}

/// An even kernel (half of it given) over a padded row. Sums run from the centre outwards over pairs, so a mirrored row
/// gives exactly the mirrored result.
#[inline(always)]
fn filter_row(padded: &[f32], kernel: &[f32], to: &mut [f32]) {
    let radius = kernel.len() - 1;
    let n = to.len();
    to.iter_mut().zip(&padded[radius..]).for_each(|(to, v)| *to = kernel[0] * v);
    for (step, k) in kernel.iter().enumerate().skip(1) {
        let (left, right) = (&padded[radius - step..][..n], &padded[radius + step..][..n]);
        for i in 0..n {
            to[i] += k * (left[i] + right[i]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_keeps_the_mean_and_flips_with_the_picture() {
        let size = Size::new(7, 5);
        let values: Vec<f32> = (0..35).map(|i| ((i * 37) % 11) as f32).collect();
        let flipped: Vec<f32> = values.chunks(7).flat_map(|row| row.iter().rev().copied()).collect();
        let small = shrink(&values, size, Size::new(3, 2));
        let small_flipped = shrink(&flipped, size, Size::new(3, 2));
        let mean = |v: &[f32]| v.iter().sum::<f32>() / v.len() as f32;
        assert!((mean(&values) - mean(&small.values)).abs() < 1e-5);
        for (row, mirrored) in small.values.chunks(3).zip(small_flipped.values.chunks(3)) {
            row.iter().zip(mirrored.iter().rev()).for_each(|(a, b)| assert!((a - b).abs() < 1e-5));
        }
    }

    #[test]
    fn a_blurred_constant_stays_and_a_blurred_point_keeps_its_sum() {
        let size = Size::new(31, 31);
        let flat = Plane::filled(size, 3.0).blurred(2.0);
        assert!(flat.values.iter().all(|v| (v - 3.0).abs() < 1e-5));
        let mut point = Plane::filled(size, 0.0);
        point.values[15 * 31 + 15] = 1.0;
        let sum: f32 = point.blurred(2.0).values.iter().sum();
        assert!((sum - 1.0).abs() < 1e-4);
    }
}
