//! The colour structure tensor (Di Zenzo 1986) from Gaussian derivatives, row by row.
//!
//! Only as many rows as the kernel is high are in memory. Sums run over mirrored pairs of pixels from the centre
//! outwards, so that a flipped picture gives exactly the flipped tensor. Vector instructions process several pixels at
//! once, with the same operations in the same order for each pixel, so that every machine gives the same bits.
//!
//! The kernels are structs that implement `WithSimd`. The body of a closure may be compiled separately, without the
//! wide vectors; that was half as fast.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use crate::raster::plane::gauss;
use crate::units::Size;

/// Number of pixels that are processed together, so that their sums stay in registers.
const BLOCK: usize = 16;

/// One row of the tensor `[[xx, xy], [xy, yy]]`, summed over the colour planes: squared gradients per pixel.
#[derive(Debug, Clone, Default)]
pub(super) struct TensorRow {
    pub(super) xx: Vec<f32>,
    pub(super) xy: Vec<f32>,
    pub(super) yy: Vec<f32>,
    /// Length of the gradient: the square root of the first eigenvalue.
    pub(super) length: Vec<f32>,
}

/// Takes rows of colour planes and returns rows of their tensor, delayed by the radius of the kernel.
pub(super) struct Gradient {
    arch: Arch,
    size: Size,
    smooth: Vec<f32>,
    slope: Vec<f32>,
    /// Ring buffers: the last rows of each colour plane; row `y` has the index `y` modulo their number.
    rings: Vec<Vec<f32>>,
    columns: Filtered,
    /// Number of the next row.
    next: usize,
    /// The rows that are returned.
    wanted: Range<usize>,
    row: TensorRow,
}

/// One row of one plane after filtering down the columns, padded at both ends for the kernel along the row.
struct Filtered {
    smooth: Vec<f32>,
    slope: Vec<f32>,
}

impl Gradient {
    /// For a picture of `size`; only the rows `wanted` of the tensor are returned.
    pub(super) fn new(size: Size, planes: usize, sigma: f32, wanted: Range<usize>) -> Self {
        let smooth = gauss(sigma);
        let slope = derivative(&smooth);
        let stride = stride(size);
        let radius = smooth.len() - 1;
        let padded = || vec![0.0; stride + 2 * radius];
        Self {
            arch: Arch::new(),
            size,
            rings: (0..planes).map(|_| vec![0.0; stride * (2 * radius + 1)]).collect(),
            columns: Filtered { smooth: padded(), slope: padded() },
            smooth,
            slope,
            next: 0,
            wanted,
            row: TensorRow::of(size),
        }
    }

    /// Number of rows needed above and below a row.
    pub(super) fn reach(&self) -> usize {
        self.smooth.len() - 1
    }

    /// Sets the number of the first row that is pushed, if it is not the first row of the picture.
    pub(super) fn start(&mut self, row: usize) {
        self.next = row;
    }

    /// Takes the next row, one slice per plane. `take` receives the row of the tensor that this completes, if any; it
    /// may keep the row and leave another one of the same size.
    pub(super) fn push(&mut self, planes: &[Vec<f32>], take: impl FnMut(&mut TensorRow)) {
        let (width, stride, radius) = (self.size.width as usize, stride(self.size), self.smooth.len() - 1);
        let slot = self.next % (2 * radius + 1) * stride;
        for (ring, plane) in self.rings.iter_mut().zip(planes) {
            ring[slot..][..width].copy_from_slice(&plane[..width]);
        }
        self.next += 1;
        if self.next > radius && self.wanted.contains(&(self.next - 1 - radius)) {
            self.complete(self.next - 1 - radius, take);
        }
    }

    /// Returns the last rows, whose kernels reach below the picture.
    pub(super) fn finish(mut self, mut take: impl FnMut(&mut TensorRow)) {
        let radius = self.smooth.len() - 1;
        for y in self.next.saturating_sub(radius).max(self.wanted.start)..self.next.min(self.wanted.end) {
            self.complete(y, &mut take);
        }
    }

    fn complete(&mut self, y: usize, mut take: impl FnMut(&mut TensorRow)) {
        let Self { arch, size, smooth, slope, rings, columns, row, .. } = self;
        let (width, stride, radius) = (size.width as usize, stride(*size), smooth.len() - 1);
        let slot = |at: usize| at % (2 * radius + 1) * stride;
        // beyond the border the nearest row is repeated
        let pairs: Vec<(usize, usize)> =
            (0..=radius).map(|k| (slot(y.saturating_sub(k)), slot((y + k).min(size.height as usize - 1)))).collect();
        row.clear();
        arch.dispatch(TensorRows { width, rings, pairs: &pairs, smooth, slope, columns, to: row });
        take(row);
    }
}

/// Computes one row of the tensor from the rows around it. `pairs` holds their positions in the ring buffers.
struct TensorRows<'a> {
    width: usize,
    rings: &'a [Vec<f32>],
    pairs: &'a [(usize, usize)],
    smooth: &'a [f32],
    slope: &'a [f32],
    columns: &'a mut Filtered,
    to: &'a mut TensorRow,
}

impl WithSimd for TensorRows<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { width, rings, pairs, smooth, slope, columns, to } = self;
        let radius = smooth.len() - 1;
        for ring in rings {
            down(ring, pairs, smooth, slope, columns);
            pad(&mut columns.smooth, radius, width);
            pad(&mut columns.slope, radius, width);
            along(columns, smooth, slope, to);
        }
        lengths(to);
    }
}

impl TensorRow {
    /// A row of zeroes for a picture of this size.
    pub(super) fn of(size: Size) -> Self {
        let row = || vec![0.0; stride(size)];
        Self { xx: row(), xy: row(), yy: row(), length: row() }
    }

    fn clear(&mut self) {
        for values in [&mut self.xx, &mut self.xy, &mut self.yy] {
            values.fill(0.0);
        }
    }
}

/// The width, rounded up to whole blocks.
fn stride(size: Size) -> usize {
    (size.width as usize).next_multiple_of(BLOCK)
}

/// Repeats the first and the last value of a row of `width` values that begins at index `radius`.
fn pad(row: &mut [f32], radius: usize, width: usize) {
    let (first, last) = (row[radius], row[radius + width - 1]);
    row[..radius].fill(first);
    row[radius + width..].fill(last);
}

/// Derivative of a Gaussian: half of an odd kernel, from half of the Gaussian, scaled so that a slope of 1 per pixel
/// gives 1.
pub(super) fn derivative(smooth: &[f32]) -> Vec<f32> {
    let moment: f32 = smooth.iter().enumerate().map(|(i, k)| 2.0 * (i * i) as f32 * k).sum();
    smooth.iter().enumerate().map(|(i, k)| i as f32 * k / moment).collect()
}

#[inline(always)]
fn block(values: &[f32], at: usize) -> &[f32; BLOCK] {
    values[at..].first_chunk().unwrap_or(&[0.0; BLOCK])
}

/// Smooths and differentiates down the columns, over the rows at the positions `pairs`.
#[inline(always)]
fn down(ring: &[f32], pairs: &[(usize, usize)], smooth: &[f32], slope: &[f32], to: &mut Filtered) {
    let radius = smooth.len() - 1;
    let to_smooth = to.smooth[radius..].as_chunks_mut::<BLOCK>().0.iter_mut();
    let to_slope = to.slope[radius..].as_chunks_mut::<BLOCK>().0;
    let blocks = (ring.len() / (2 * radius + 1)) / BLOCK;
    for (number, (to_smooth, to_slope)) in to_smooth.zip(to_slope).enumerate().take(blocks) {
        let at = number * BLOCK;
        let mut even = *block(ring, pairs[0].0 + at);
        even.iter_mut().for_each(|v| *v *= smooth[0]);
        let mut odd = [0.0; BLOCK];
        for (k, &(up, down)) in pairs.iter().enumerate().skip(1) {
            let (above, below) = (block(ring, up + at), block(ring, down + at));
            for i in 0..BLOCK {
                even[i] += smooth[k] * (above[i] + below[i]);
                odd[i] += slope[k] * (below[i] - above[i]);
            }
        }
        *to_smooth = even;
        *to_slope = odd;
    }
}

/// Completes the gradient of one plane along the row and adds its products to the tensor.
#[inline(always)]
fn along(columns: &Filtered, smooth: &[f32], slope: &[f32], row: &mut TensorRow) {
    let radius = smooth.len() - 1;
    let rows = row.xx.as_chunks_mut::<BLOCK>().0.iter_mut().zip(row.xy.as_chunks_mut::<BLOCK>().0);
    for (number, ((xx, xy), yy)) in rows.zip(row.yy.as_chunks_mut::<BLOCK>().0).enumerate() {
        let at = number * BLOCK + radius;
        let mut gy = *block(&columns.slope, at);
        gy.iter_mut().for_each(|v| *v *= smooth[0]);
        let mut gx = [0.0; BLOCK];
        for k in 1..=radius {
            let (left, right) = (block(&columns.smooth, at - k), block(&columns.smooth, at + k));
            for i in 0..BLOCK {
                gx[i] += slope[k] * (right[i] - left[i]);
            }
            let (left, right) = (block(&columns.slope, at - k), block(&columns.slope, at + k));
            for i in 0..BLOCK {
                gy[i] += smooth[k] * (left[i] + right[i]);
            }
        }
        for i in 0..BLOCK {
            xx[i] += gx[i] * gx[i];
            xy[i] += gx[i] * gy[i];
            yy[i] += gy[i] * gy[i];
        }
    }
}

/// Computes the square root of the first eigenvalue of each pixel.
#[inline(always)]
fn lengths(row: &mut TensorRow) {
    let TensorRow { xx, xy, yy, length } = row;
    for (((xx, xy), yy), length) in xx.iter().zip(xy).zip(yy).zip(length) {
        let (half, difference) = (0.5 * (*xx + *yy), 0.5 * (*xx - *yy));
        *length = (half + (difference * difference + *xy * *xy).sqrt()).sqrt();
    }
}

#[cfg(test)]
mod tests;
