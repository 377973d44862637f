//! Ridge points: local maxima of the gradient across the edge, with sub-pixel position.
//!
//! This is the non-maximum suppression of Canny (1986) with the interpolation of Devernay (1995), through the
//! logarithms of the gradients.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::gradient::TensorRow;
use super::params::Params;
use super::ridge::{EdgeProfile, MAX_BLUR, RidgePoint};
use crate::geom::first_eigenvector;
use crate::units::{PxPoint, PxVector, Size};

/// Takes rows of the structure tensor and collects ridge points, in reading order.
pub(super) struct MaximaFinder {
    arch: Arch,
    size: Size,
    sigma: f32,
    bounds: Bounds,
    min_height: f32,
    /// Distance beyond an edge at which its pedestal is read, px.
    reach: usize,
    /// The last rows: row `y` has the index `y` modulo their number.
    rows: Vec<TensorRow>,
    /// Number of the next row.
    next: usize,
    /// The rows whose points are kept.
    own: Range<usize>,
    /// Buffer: the columns of the current row that have a maximum.
    is_maximum: Vec<bool>,
    points: Vec<RidgePoint>,
}

/// Pixels without a maximum are skipped in blocks of this many.
const BLOCK: usize = 16;

/// Ridge points are kept down to this share of the lower threshold, so that averaging along a chain still sees the weak
/// points.
const SHARE_OF_LOW: f32 = 0.5;
/// The pedestal is read this many scales beyond an edge, where the gradient of a sharp edge itself is down to 2
/// percent.
const PEDESTAL_DISTANCE: f32 = 3.0;

impl MaximaFinder {
    /// For a picture of `size`; only points in the rows `own` are kept.
    pub(super) fn new(size: Size, params: &Params, own: Range<usize>) -> Self {
        let min_height = SHARE_OF_LOW * params.low;
        let reach = (PEDESTAL_DISTANCE * params.sigma).round() as usize;
        Self {
            arch: Arch::new(),
            size,
            sigma: params.sigma,
            bounds: Bounds::new(min_height, params.sigma),
            min_height,
            reach,
            rows: vec![TensorRow::of(size); 2 * reach + 1],
            next: 0,
            own,
            is_maximum: Vec::new(),
            points: Vec::new(),
        }
    }

    /// Number of rows needed above and below a row.
    pub(super) fn reach(&self) -> usize {
        self.reach
    }

    /// Sets the number of the first row that is pushed, if it is not the first row of the picture.
    pub(super) fn start(&mut self, row: usize) {
        self.next = row;
    }

    /// Takes the next row out of `tensor` and leaves an old row there for reuse.
    pub(super) fn push(&mut self, tensor: &mut TensorRow) {
        let slot = self.next % self.rows.len();
        std::mem::swap(&mut self.rows[slot], tensor);
        self.next += 1;
        if self.next > self.reach && self.own.contains(&(self.next - 1 - self.reach)) {
            self.search_row(self.next - 1 - self.reach);
        }
    }

    pub(super) fn finish(mut self) -> Vec<RidgePoint> {
        for row in self.next.saturating_sub(self.reach).max(self.own.start)..self.next.min(self.own.end) {
            self.search_row(row);
        }
        self.points
    }

    /// Finds the ridge points of a row. The outermost pixels of the picture are left out: they lack a neighbour.
    fn search_row(&mut self, row: usize) {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        if row == 0 || row + 1 >= height || width < 3 {
            return;
        }
        let mut is_maximum = std::mem::take(&mut self.is_maximum);
        is_maximum.resize(width.next_multiple_of(BLOCK), false);
        let [above, middle, below] = [row - 1, row, row + 1].map(|y| self.row(y));
        self.arch.dispatch(MarkMaxima {
            lengths: [&above.length, &middle.length, &below.length],
            xx: &middle.xx,
            yy: &middle.yy,
            bounds: &self.bounds,
            to: &mut is_maximum[1..width - 1],
        });
        for (block, found) in is_maximum.as_chunks::<BLOCK>().0.iter().enumerate() {
            if *found == [false; BLOCK] {
                continue;
            }
            for (column, _) in found.iter().enumerate().filter(|(_, found)| **found) {
                let point = self.ridge_point(block * BLOCK + column, row);
                self.points.extend(point);
            }
        }
        self.is_maximum = is_maximum;
    }

    fn row(&self, y: usize) -> &TensorRow {
        &self.rows[y % self.rows.len()]
    }

    /// The ridge point at a pixel where the gradient has a maximum, if its step is high enough.
    fn ridge_point(&self, column: usize, row: usize) -> Option<RidgePoint> {
        let TensorRow { xx, xy, yy, length } = self.row(row);
        let (xx, xy, yy, here) = (xx[column], xy[column], yy[column], length[column]);
        let upright = xx >= yy;
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        // the gradient at a distance of some pixels across the edge; none outside the picture
        let across = |distance: isize| {
            if upright {
                column.checked_add_signed(distance).filter(|x| *x < width).map(|x| length[x])
            } else {
                row.checked_add_signed(distance).filter(|y| *y < height).map(|y| self.row(y).length[column])
            }
        };
        let (offset, maximum, curvature) = interpolate(across(-1)?, here, across(1)?)?;
        let reach = self.reach as isize;
        let beyond = match [across(-reach), across(reach)] {
            [Some(a), Some(b)] => [a, b],
            // at the border of the picture only one side exists
            [a, b] => [a.or(b).unwrap_or(0.0); 2],
        };
        let normal: PxVector = first_eigenvector(xx, xy, yy).unwrap_or(PxVector::new(1.0, 0.0));
        let along_axis = if upright { normal.x.abs() } else { normal.y.abs() };
        let profile = EdgeProfile {
            maximum,
            curvature: curvature / (along_axis * along_axis),
            pedestal: beyond.map(|gradient| gradient / here),
            distance: self.reach as f32 * along_axis,
        };
        let height = profile.height(self.sigma);
        let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
        let at = if upright { PxPoint::new(x + offset, y) } else { PxPoint::new(x, y + offset) };
        let blur = profile.blur(self.sigma);
        let point = RidgePoint { at, normal, profile, height, blur, column: column as u32, row: row as u32 };
        (height >= self.min_height).then_some(point)
    }
}

/// Lower bounds that the gradient at a pixel must reach, so that the step there can be high enough.
///
/// By the bound `-ln x >= 1 - x`, the curvature is at least `(2 here - before - after) / here`. The blur is at most the
/// root of its reciprocal, or the blur of the derivative itself.
struct Bounds {
    /// The gradient of an edge as wide as is measured.
    gradient: f32,
    /// The gradient of an edge as sharp as can be.
    sharp: f32,
    /// Square of the gradient of an edge blurred by one pixel.
    square: f32,
}

impl Bounds {
    fn new(height: f32, sigma: f32) -> Self {
        // a maximum between two pixels is higher than both pixels, seldom by more than this factor
        const RISE: f32 = 1.2;
        let at_one_pixel = height / std::f32::consts::TAU.sqrt();
        Self {
            gradient: at_one_pixel / (sigma * MAX_BLUR),
            sharp: at_one_pixel / (sigma * RISE),
            square: (at_one_pixel / RISE).powi(2),
        }
    }
}

/// Marks the pixels of a row whose gradient is greater than that of both neighbours across the edge and within the
/// bounds, from the second pixel to the last but one. Of two equal neighbours the second counts.
struct MarkMaxima<'a> {
    /// Lengths of the gradients in the row above, the row itself and the row below.
    lengths: [&'a [f32]; 3],
    xx: &'a [f32],
    yy: &'a [f32],
    bounds: &'a Bounds,
    to: &'a mut [bool],
}

impl WithSimd for MarkMaxima<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { lengths: [above, here, below], xx, yy, bounds, to: is_maximum } = self;
        let Bounds { gradient, sharp, square } = *bounds;
        let n = is_maximum.len();
        let (above, below, left, here, right) =
            (&above[1..][..n], &below[1..][..n], &here[..n], &here[1..][..n], &here[2..][..n]);
        let (xx, yy) = (&xx[1..][..n], &yy[1..][..n]);
        for i in 0..n {
            // an upright edge: compare left and right
            let upright = xx[i] >= yy[i];
            let before = if upright { left[i] } else { above[i] };
            let after = if upright { right[i] } else { below[i] };
            let here = here[i];
            let high = (here >= sharp) | (here * here * here >= square * (2.0 * here - before - after));
            is_maximum[i] = (here >= gradient) & (here > before) & (here >= after) & high;
        }
    }
}

/// Position of the maximum between the neighbours (pixels from the middle, -0.5..=0.5), its value, and the curvature
/// of the ridge along the axis, px^-2; none where there is no maximum.
///
/// Devernay (1995) interpolates the three gradients with a parabola. The gradient across a blurred step is a Gaussian,
/// and the logarithm of a Gaussian *is* a parabola. So interpolating the logarithms gives a position without bias, and
/// the curvature of the parabola is `1 / t^2` for the total blur `t`.
fn interpolate(before: f32, here: f32, after: f32) -> Option<(f32, f32, f32)> {
    const TINY: f32 = 1e-6;
    let (left, right) = (ln((before / here).max(TINY)), ln((after / here).max(TINY)));
    let curvature = left + right;
    if curvature > -TINY {
        return None;
    }
    let slope = 0.5 * (right - left);
    let offset = (-slope / curvature).clamp(-0.5, 0.5);
    // the exponential as a series; the rise is a few hundredths
    let rise = 0.5 * slope * offset;
    Some((offset, here * (1.0 + rise * (1.0 + rise * (0.5 + rise / 6.0))), -curvature))
}

/// Natural logarithm of a positive number, with an error below 1e-6: the exponent, and four terms of the series in
/// `(m - 1) / (m + 1)` for the mantissa `m`. It uses only + - * /, so that the result is the same on every machine.
#[inline(always)]
fn ln(x: f32) -> f32 {
    // x = 2^e m, with m between sqrt(1/2) and sqrt(2)
    let bits = x.to_bits();
    let e = (bits.wrapping_sub(0x3f35_04f3) as i32) >> 23;
    let m = f32::from_bits(bits.wrapping_sub((e as u32) << 23));
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    e as f32 * std::f32::consts::LN_2 + 2.0 * s * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0))))
}

#[cfg(test)]
mod tests;
