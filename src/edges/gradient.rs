//! The colour structure tensor (Di Zenzo 1986) from Gaussian derivatives, row by row.
//!
//! Only as many rows as the kernel is high are in memory. Sums run over mirrored pairs from the centre outwards, so that a
//! flipped picture gives exactly the flipped tensor; the widest vectors of the processor at hand do several pixels at once
//! with the same operations in the same order, so that every machine gives the same bits.

use pulp::Arch;

use crate::raster::plane::{gauss, pad};
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
    /// Width rounded up to whole blocks.
    stride: usize,
    smooth: Vec<f32>,
    slope: Vec<f32>,
    /// For each colour plane a ring of rows, already filtered along x.
    rings: Vec<Ring>,
    padded: Vec<f32>,
    filled: usize,
    row: TensorRow,
}

struct Ring {
    smooth: Vec<f32>,
    slope: Vec<f32>,
}

impl Gradient {
    pub(super) fn new(size: Size, planes: usize, sigma: f32) -> Self {
        let smooth = gauss(sigma);
        let slope = derivative(&smooth);
        let stride = (size.width as usize).next_multiple_of(BLOCK);
        let rows = 2 * smooth.len() - 1;
        let ring = || Ring { smooth: vec![0.0; stride * rows], slope: vec![0.0; stride * rows] };
        let row = || vec![0.0; stride];
        Self {
            arch: Arch::new(),
            size,
            stride,
            rings: (0..planes).map(|_| ring()).collect(),
            padded: Vec::with_capacity(stride + 2 * smooth.len()),
            smooth,
            slope,
            filled: 0,
            row: TensorRow { xx: row(), xy: row(), yy: row(), length: row() },
        }
    }

    /// Takes the next row, one slice per plane; `take` gets the row of the tensor that is complete with it, if there is one.
    pub(super) fn push(&mut self, planes: &[Vec<f32>], take: impl FnMut(&TensorRow)) {
        let radius = self.smooth.len() - 1;
        let slot = self.filled % (2 * radius + 1) * self.stride;
        for (ring, plane) in self.rings.iter_mut().zip(planes) {
            pad(&plane[..self.size.width as usize], radius, &mut self.padded);
            self.padded.resize(self.stride + 2 * radius, 0.0);
            let (padded, smooth, slope) = (&self.padded[..], &self.smooth[..], &self.slope[..]);
            let (to_smooth, to_slope) =
                (&mut ring.smooth[slot..][..self.stride], &mut ring.slope[slot..][..self.stride]);
            self.arch.dispatch(
                #[inline(always)]
                || along_x(padded, smooth, slope, to_smooth, to_slope),
            );
        }
        self.filled += 1;
        if self.filled > radius {
            self.complete(self.filled - 1 - radius, take);
        }
    }

    /// Gives the rows that waited for rows below the picture.
    pub(super) fn finish(mut self, mut take: impl FnMut(&TensorRow)) {
        let radius = self.smooth.len() - 1;
        for y in self.filled.saturating_sub(radius)..self.filled {
            self.complete(y, &mut take);
        }
    }

    fn complete(&mut self, y: usize, mut take: impl FnMut(&TensorRow)) {
        let Self { arch, size, stride, smooth, slope, rings, row, .. } = self;
        let radius = smooth.len() - 1;
        let slot = |at: usize| at % (2 * radius + 1) * *stride;
        // beyond the border the nearest row counts
        let pairs: Vec<(usize, usize)> =
            (0..=radius).map(|k| (slot(y.saturating_sub(k)), slot((y + k).min(size.height as usize - 1)))).collect();
        arch.dispatch(
            #[inline(always)]
            || along_y(rings, &pairs, smooth, slope, row),
        );
        take(row);
    }
}

/// Half of the odd kernel that belongs to half of a Gaussian, scaled so that a ramp of 1 per pixel gives 1.
fn derivative(smooth: &[f32]) -> Vec<f32> {
    let moment: f32 = smooth.iter().enumerate().map(|(i, k)| 2.0 * (i * i) as f32 * k).sum();
    smooth.iter().enumerate().map(|(i, k)| i as f32 * k / moment).collect()
}

#[inline(always)]
fn block(values: &[f32], at: usize) -> &[f32; BLOCK] {
    values[at..].first_chunk().unwrap_or(&[0.0; BLOCK])
}

/// Smooths and differentiates a padded row.
#[inline(always)]
fn along_x(padded: &[f32], smooth: &[f32], slope: &[f32], to_smooth: &mut [f32], to_slope: &mut [f32]) {
    let radius = smooth.len() - 1;
    let (to_smooth, to_slope) = (to_smooth.as_chunks_mut::<BLOCK>().0, to_slope.as_chunks_mut::<BLOCK>().0);
    for (number, (to_smooth, to_slope)) in to_smooth.iter_mut().zip(to_slope).enumerate() {
        let at = number * BLOCK + radius;
        let mut even = *block(padded, at);
        even.iter_mut().for_each(|v| *v *= smooth[0]);
        let mut odd = [0.0; BLOCK];
        for k in 1..=radius {
            let (left, right) = (block(padded, at - k), block(padded, at + k));
            for i in 0..BLOCK {
                even[i] += smooth[k] * (left[i] + right[i]);
                odd[i] += slope[k] * (right[i] - left[i]);
            }
        }
        *to_smooth = even;
        *to_slope = odd;
    }
}

/// Finishes the gradients of all planes down the rows whose places `pairs` holds, and sums their products.
#[inline(always)]
fn along_y(rings: &[Ring], pairs: &[(usize, usize)], smooth: &[f32], slope: &[f32], row: &mut TensorRow) {
    let TensorRow { xx, xy, yy, length } = row;
    let rows = xx.as_chunks_mut::<BLOCK>().0.iter_mut().zip(xy.as_chunks_mut::<BLOCK>().0);
    let rows = rows.zip(yy.as_chunks_mut::<BLOCK>().0).zip(length.as_chunks_mut::<BLOCK>().0);
    for (number, (((xx, xy), yy), length)) in rows.enumerate() {
        let at = number * BLOCK;
        (*xx, *xy, *yy) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        for ring in rings {
            let mut gx = *block(&ring.slope, pairs[0].0 + at);
            gx.iter_mut().for_each(|v| *v *= smooth[0]);
            let mut gy = [0.0; BLOCK];
            for (k, &(up, down)) in pairs.iter().enumerate().skip(1) {
                let (above, below) = (block(&ring.slope, up + at), block(&ring.slope, down + at));
                for i in 0..BLOCK {
                    gx[i] += smooth[k] * (above[i] + below[i]);
                }
                let (above, below) = (block(&ring.smooth, up + at), block(&ring.smooth, down + at));
                for i in 0..BLOCK {
                    gy[i] += slope[k] * (below[i] - above[i]);
                }
            }
            for i in 0..BLOCK {
                xx[i] += gx[i] * gx[i];
                xy[i] += gx[i] * gy[i];
                yy[i] += gy[i] * gy[i];
            }
        }
        for i in 0..BLOCK {
            let (half, difference) = (0.5 * (xx[i] + yy[i]), 0.5 * (xx[i] - yy[i]));
            length[i] = (half + (difference * difference + xy[i] * xy[i]).sqrt()).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_has_its_own_slope_everywhere_inside() {
        let size = Size::new(40, 30);
        let mut rows = 0;
        let mut look = |tensor: &TensorRow| {
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
        let mut gradient = Gradient::new(size, 1, 1.5);
        for y in 0..30 {
            let row = (0..40).map(|x| 3.0 * x as f32 - 2.0 * y as f32).collect();
            gradient.push(&[row], &mut look);
        }
        gradient.finish(&mut look);
        assert_eq!(rows, 30);
    }
}
