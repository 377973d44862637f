//! The colour structure tensor (Di Zenzo 1986) from Gaussian derivatives, row by row.
//!
//! Only as many rows as the kernel is high are in memory. Sums run over mirrored pairs from the centre outwards, so that a
//! flipped picture gives exactly the flipped tensor; the widest vectors of the processor at hand do several pixels at once
//! with the same operations in the same order, so that every machine gives the same bits. (Kernels are structs with a
//! `WithSimd`: the body of a closure may be compiled apart, without the wide vectors; that was half as fast.)

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use crate::raster::plane::gauss;
use crate::units::Size;

/// Pixels worked on together: their sums stay in registers.
const BLOCK: usize = 16;

/// One row of the tensor `[[xx, xy], [xy, yy]]`, summed over the colour planes: gradients per pixel, squared.
#[derive(Debug, Clone, Default)]
pub(super) struct TensorRow {
    pub(super) xx: Vec<f32>,
    pub(super) xy: Vec<f32>,
    pub(super) yy: Vec<f32>,
    /// Length of the gradient: root of the first eigenvalue.
    pub(super) length: Vec<f32>,
}

/// Takes rows of colour planes and gives rows of their tensor, as many rows later as the kernel reaches.
pub(super) struct Gradient {
    arch: Arch,
    size: Size,
    smooth: Vec<f32>,
    slope: Vec<f32>,
    /// For each colour plane the last rows, row `y` in place `y` modulo their number.
    rings: Vec<Vec<f32>>,
    across: Across,
    /// The row that comes next.
    filled: usize,
    /// The rows that are given.
    wanted: Range<usize>,
    row: TensorRow,
}

/// One row of one plane, filtered down the columns, with room beyond its ends for the kernel along it.
struct Across {
    smooth: Vec<f32>,
    slope: Vec<f32>,
}

impl Gradient {
    /// For a picture of `size`, of whose tensor the rows `wanted` are given.
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
            across: Across { smooth: padded(), slope: padded() },
            smooth,
            slope,
            filled: 0,
            wanted,
            row: TensorRow::of(size),
        }
    }

    /// How many rows above and below one are needed for it.
    pub(super) fn reach(&self) -> usize {
        self.smooth.len() - 1
    }

    /// Says which row comes first, if not the first of the picture.
    pub(super) fn start(&mut self, row: usize) {
        self.filled = row;
    }

    /// Takes the next row, one slice per plane; `take` gets the row of the tensor that is complete with it, if there is one,
    /// and may keep it and leave another of the same size.
    pub(super) fn push(&mut self, planes: &[Vec<f32>], take: impl FnMut(&mut TensorRow)) {
        let (width, stride, radius) = (self.size.width as usize, stride(self.size), self.smooth.len() - 1);
        let slot = self.filled % (2 * radius + 1) * stride;
        for (ring, plane) in self.rings.iter_mut().zip(planes) {
            ring[slot..][..width].copy_from_slice(&plane[..width]);
        }
        self.filled += 1;
        if self.filled > radius && self.wanted.contains(&(self.filled - 1 - radius)) {
            self.complete(self.filled - 1 - radius, take);
        }
    }

    /// Gives the rows that waited for rows below the picture.
    pub(super) fn finish(mut self, mut take: impl FnMut(&mut TensorRow)) {
        let radius = self.smooth.len() - 1;
        for y in self.filled.saturating_sub(radius).max(self.wanted.start)..self.filled.min(self.wanted.end) {
            self.complete(y, &mut take);
        }
    }

    fn complete(&mut self, y: usize, mut take: impl FnMut(&mut TensorRow)) {
        let Self { arch, size, smooth, slope, rings, across, row, .. } = self;
        let (width, stride, radius) = (size.width as usize, stride(*size), smooth.len() - 1);
        let slot = |at: usize| at % (2 * radius + 1) * stride;
        // beyond the border the nearest row counts
        let pairs: Vec<(usize, usize)> =
            (0..=radius).map(|k| (slot(y.saturating_sub(k)), slot((y + k).min(size.height as usize - 1)))).collect();
        row.clear();
        arch.dispatch(Rows { width, rings, pairs: &pairs, smooth, slope, across, to: row });
        take(row);
    }
}

/// The rows around one, at the places that `pairs` holds, which become one of the tensor.
struct Rows<'a> {
    width: usize,
    rings: &'a [Vec<f32>],
    pairs: &'a [(usize, usize)],
    smooth: &'a [f32],
    slope: &'a [f32],
    across: &'a mut Across,
    to: &'a mut TensorRow,
}

impl WithSimd for Rows<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { width, rings, pairs, smooth, slope, across, to } = self;
        let radius = smooth.len() - 1;
        for ring in rings {
            down(ring, pairs, smooth, slope, across);
            extend(&mut across.smooth, radius, width);
            extend(&mut across.slope, radius, width);
            along(across, smooth, slope, to);
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

/// Width rounded up to whole blocks.
fn stride(size: Size) -> usize {
    (size.width as usize).next_multiple_of(BLOCK)
}

/// Repeats the first and the last value of a row of `width` that begins at `radius`.
fn extend(row: &mut [f32], radius: usize, width: usize) {
    let (first, last) = (row[radius], row[radius + width - 1]);
    row[..radius].fill(first);
    row[radius + width..].fill(last);
}

/// Half of the odd kernel that belongs to half of a Gaussian, scaled so that a ramp of 1 per pixel gives 1.
pub(super) fn derivative(smooth: &[f32]) -> Vec<f32> {
    let moment: f32 = smooth.iter().enumerate().map(|(i, k)| 2.0 * (i * i) as f32 * k).sum();
    smooth.iter().enumerate().map(|(i, k)| i as f32 * k / moment).collect()
}

#[inline(always)]
fn block(values: &[f32], at: usize) -> &[f32; BLOCK] {
    values[at..].first_chunk().unwrap_or(&[0.0; BLOCK])
}

/// Smooths and differentiates down the columns, over the rows whose places `pairs` holds.
#[inline(always)]
fn down(ring: &[f32], pairs: &[(usize, usize)], smooth: &[f32], slope: &[f32], to: &mut Across) {
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

/// Finishes the gradient of one plane along the row and adds its products.
#[inline(always)]
fn along(across: &Across, smooth: &[f32], slope: &[f32], row: &mut TensorRow) {
    let radius = smooth.len() - 1;
    let rows = row.xx.as_chunks_mut::<BLOCK>().0.iter_mut().zip(row.xy.as_chunks_mut::<BLOCK>().0);
    for (number, ((xx, xy), yy)) in rows.zip(row.yy.as_chunks_mut::<BLOCK>().0).enumerate() {
        let at = number * BLOCK + radius;
        let mut gy = *block(&across.slope, at);
        gy.iter_mut().for_each(|v| *v *= smooth[0]);
        let mut gx = [0.0; BLOCK];
        for k in 1..=radius {
            let (left, right) = (block(&across.smooth, at - k), block(&across.smooth, at + k));
            for i in 0..BLOCK {
                gx[i] += slope[k] * (right[i] - left[i]);
            }
            let (left, right) = (block(&across.slope, at - k), block(&across.slope, at + k));
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

/// The root of the first eigenvalue.
#[inline(always)]
fn lengths(row: &mut TensorRow) {
    let TensorRow { xx, xy, yy, length } = row;
    for (((xx, xy), yy), length) in xx.iter().zip(xy).zip(yy).zip(length) {
        let (half, difference) = (0.5 * (*xx + *yy), 0.5 * (*xx - *yy));
        *length = (half + (difference * difference + *xy * *xy).sqrt()).sqrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_has_its_own_slope_everywhere_inside() {
        let size = Size::new(40, 30);
        let mut rows = 0;
        let mut look = |tensor: &mut TensorRow| {
            if (6..24).contains(&rows) {
                for x in 6..34 {
                    assert!((tensor.xx[x] - 9.0).abs() < 1e-2);
                    assert!((tensor.xy[x] + 6.0).abs() < 1e-2);
                    assert!((tensor.yy[x] - 4.0).abs() < 1e-2);
                    assert!((tensor.length[x] - 13_f32.sqrt()).abs() < 1e-2);
                }
            }
            rows += 1;
        };
        let mut gradient = Gradient::new(size, 1, 1.5, 0..30);
        for y in 0..30 {
            let row = (0..40).map(|x| 3.0 * x as f32 - 2.0 * y as f32).collect();
            gradient.push(&[row], &mut look);
        }
        gradient.finish(&mut look);
        assert_eq!(rows, 30);
    }
}
