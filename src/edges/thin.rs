//! From a broad ridge of gradient to single points between the pixels.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::Params;
use super::gradient::TensorRow;
use super::height::{Profile, WIDEST};
use crate::units::{PxPoint, Size};

/// A place where the gradient is greatest across the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ridge {
    pub(super) at: PxPoint,
    /// Unit vector across the edge; its sign has no meaning (a colour step has no up).
    pub(super) normal: [f32; 2],
    pub(super) profile: Profile,
    /// Height of the step, in units of strength.
    pub(super) step: f32,
    /// Blur of the step with the scale of the derivative in it, px.
    pub(super) blur: f32,
    /// The pixel it was found at.
    pub(super) column: u32,
    /// The pixel row.
    pub(super) row: u32,
}

/// Takes tensor rows and keeps the ridge points, in reading order.
pub(super) struct Thinner {
    arch: Arch,
    size: Size,
    sigma: f32,
    least: Least,
    least_step: f32,
    /// How far beyond an edge its pedestal is read, px.
    reach: usize,
    /// The last rows, row `y` in place `y` modulo their number.
    rows: Vec<TensorRow>,
    /// The row that comes next.
    pushed: usize,
    /// The rows whose points are kept.
    own: Range<usize>,
    /// Where the row at hand has its peaks.
    peaks: Vec<bool>,
    points: Vec<Ridge>,
}

/// So many places are passed over at once where there is no peak.
const PEAKS_AT_ONCE: usize = 16;

/// Ridges are kept down to this share of the lower threshold, so that smoothing along a chain still sees the weak points.
const BELOW_LOW: f32 = 0.5;
/// The pedestal is read this many scales beyond an edge, where a sharp edge's own gradient is down to 2 in 100.
const BEYOND: f32 = 3.0;

impl Thinner {
    /// For a picture of `size`, of which the points in the rows `own` are kept.
    pub(super) fn new(size: Size, params: &Params, own: Range<usize>) -> Self {
        let least_step = BELOW_LOW * params.low;
        let reach = (BEYOND * params.sigma).round() as usize;
        Self {
            arch: Arch::new(),
            size,
            sigma: params.sigma,
            least: Least::new(least_step, params.sigma),
            least_step,
            reach,
            rows: vec![TensorRow::of(size); 2 * reach + 1],
            pushed: 0,
            own,
            peaks: Vec::new(),
            points: Vec::new(),
        }
    }

    /// How many rows above and below one are looked at for it.
    pub(super) fn reach(&self) -> usize {
        self.reach
    }

    /// Says which row comes first, if not the first of the picture.
    pub(super) fn start(&mut self, row: usize) {
        self.pushed = row;
    }

    /// Keeps the next row, and leaves an old one in its place.
    pub(super) fn push(&mut self, tensor: &mut TensorRow) {
        let slot = self.pushed % self.rows.len();
        std::mem::swap(&mut self.rows[slot], tensor);
        self.pushed += 1;
        if self.pushed > self.reach && self.own.contains(&(self.pushed - 1 - self.reach)) {
            self.thin(self.pushed - 1 - self.reach);
        }
    }

    pub(super) fn finish(mut self) -> Vec<Ridge> {
        for row in self.pushed.saturating_sub(self.reach).max(self.own.start)..self.pushed.min(self.own.end) {
            self.thin(row);
        }
        self.points
    }

    /// Looks at one row. The outermost pixels of the picture have no neighbours to compare with.
    fn thin(&mut self, row: usize) {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        if row == 0 || row + 1 >= height || width < 3 {
            return;
        }
        let mut peaks = std::mem::take(&mut self.peaks);
        peaks.resize(width.next_multiple_of(PEAKS_AT_ONCE), false);
        let [above, middle, below] = [row - 1, row, row + 1].map(|y| self.row(y));
        self.arch.dispatch(Peaks {
            lengths: [&above.length, &middle.length, &below.length],
            xx: &middle.xx,
            yy: &middle.yy,
            least: &self.least,
            to: &mut peaks[1..width - 1],
        });
        for (block, found) in peaks.as_chunks::<PEAKS_AT_ONCE>().0.iter().enumerate() {
            if *found == [false; PEAKS_AT_ONCE] {
                continue;
            }
            for (column, _) in found.iter().enumerate().filter(|(_, found)| **found) {
                let ridge = self.ridge(block * PEAKS_AT_ONCE + column, row);
                self.points.extend(ridge);
            }
        }
        self.peaks = peaks;
    }

    fn row(&self, y: usize) -> &TensorRow {
        &self.rows[y % self.rows.len()]
    }

    /// The point of a ridge at a pixel where the gradient has its peak.
    fn ridge(&self, column: usize, row: usize) -> Option<Ridge> {
        let TensorRow { xx, xy, yy, length } = self.row(row);
        let (xx, xy, yy, here) = (xx[column], xy[column], yy[column], length[column]);
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let upright = xx >= yy;
        // the gradient so many pixels on across the edge, if that is in the picture
        let across = |on: isize| {
            if upright {
                column.checked_add_signed(on).filter(|x| *x < width).map(|x| length[x])
            } else {
                row.checked_add_signed(on).filter(|y| *y < height).map(|y| self.row(y).length[column])
            }
        };
        let (offset, top, sharpness) = peak(across(-1)?, here, across(1)?)?;
        let reach = self.reach as isize;
        let beyond = match [across(-reach), across(reach)] {
            [Some(a), Some(b)] => [a, b],
            // at the border of the picture there is but one side
            [a, b] => [a.or(b).unwrap_or(0.0); 2],
        };
        let normal = direction(xx, xy, yy);
        let along_axis = if upright { normal[0].abs() } else { normal[1].abs() };
        let profile = Profile {
            top,
            sharpness: sharpness / (along_axis * along_axis),
            beyond: beyond.map(|gradient| gradient / here),
            distance: self.reach as f32 * along_axis,
        };
        let step = profile.step(self.sigma);
        let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
        let at = if upright { PxPoint::new(x + offset, y) } else { PxPoint::new(x, y + offset) };
        let blur = profile.blur(self.sigma);
        let ridge = Ridge { at, normal, profile, step, blur, column: column as u32, row: row as u32 };
        (step >= self.least_step).then_some(ridge)
    }
}

/// What a peak must have at least, so that its step can be worth keeping.
///
/// With the logarithm's bound `-ln x >= 1 - x` its sharpness is at least `(2 here - before - after) / here`, and its blur at
/// most the root of the reciprocal, or what the derivative has itself.
struct Least {
    /// Gradient of an edge as wide as is measured.
    gradient: f32,
    /// Gradient of an edge as sharp as there can be.
    sharp: f32,
    /// Square of the gradient of an edge blurred by one pixel.
    square: f32,
}

impl Least {
    fn new(step: f32, sigma: f32) -> Self {
        // a peak between two pixels is higher than the pixels, seldom by more than this
        const RISE: f32 = 1.2;
        let at_one_pixel = step / std::f32::consts::TAU.sqrt();
        Self {
            gradient: at_one_pixel / (sigma * WIDEST),
            sharp: at_one_pixel / (sigma * RISE),
            square: (at_one_pixel / RISE).powi(2),
        }
    }
}

/// Marks the places of a row whose gradient is greater than that of both neighbours across the edge and not too low, from the
/// second to the last but one. Of two that are equal the second counts.
struct Peaks<'a> {
    /// Of the row above, the row itself and the row below.
    lengths: [&'a [f32]; 3],
    xx: &'a [f32],
    yy: &'a [f32],
    least: &'a Least,
    to: &'a mut [bool],
}

impl WithSimd for Peaks<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { lengths: [above, here, below], xx, yy, least, to: peaks } = self;
        let Least { gradient, sharp, square } = *least;
        let n = peaks.len();
        let (above, below, left, here, right) =
            (&above[1..][..n], &below[1..][..n], &here[..n], &here[1..][..n], &here[2..][..n]);
        let (xx, yy) = (&xx[1..][..n], &yy[1..][..n]);
        for i in 0..n {
            // the edge runs up and down: compare left and right
            let upright = xx[i] >= yy[i];
            let before = if upright { left[i] } else { above[i] };
            let after = if upright { right[i] } else { below[i] };
            let here = here[i];
            let high = (here >= sharp) | (here * here * here >= square * (2.0 * here - before - after));
            peaks[i] = (here >= gradient) & (here > before) & (here >= after) & high;
        }
    }
}

/// First eigenvector of the tensor: the direction across the edge.
fn direction(xx: f32, xy: f32, yy: f32) -> [f32; 2] {
    let difference = 0.5 * (xx - yy);
    let root = (difference * difference + xy * xy).sqrt();
    // Of the two ways to write the eigenvector, the one without cancellation.
    let (x, y) = if difference >= 0.0 { (difference + root, xy) } else { (xy, root - difference) };
    let length = (x * x + y * y).sqrt();
    if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
}

/// Where between the neighbours the gradient is greatest (pixels from the middle, -0.5..=0.5), how great it is there, and
/// how sharp the ridge is along the axis, px^-2.
///
/// Devernay (1995) lays a parabola through the three gradients. The gradient across a blurred step is a Gaussian, whose
/// logarithm *is* a parabola: so through the logarithms the place is free of bias, and the parabola's curvature is
/// `1 / t^2` for the total blur `t`.
fn peak(before: f32, here: f32, after: f32) -> Option<(f32, f32, f32)> {
    const TINY: f32 = 1e-6;
    let (left, right) = (ln((before / here).max(TINY)), ln((after / here).max(TINY)));
    let curvature = left + right;
    if curvature > -TINY {
        return None;
    }
    let slope = 0.5 * (right - left);
    let offset = (-slope / curvature).clamp(-0.5, 0.5);
    // the exponential, as a series: the rise is some hundredths
    let rise = 0.5 * slope * offset;
    Some((offset, here * (1.0 + rise * (1.0 + rise * (0.5 + rise / 6.0))), -curvature))
}

/// Natural logarithm of a positive number to 1e-6: exponent, and four terms of the series in `(m - 1) / (m + 1)` for what
/// is left. Only + - * /, so that it is the same on every machine.
#[inline(always)]
fn ln(x: f32) -> f32 {
    // x = 2^e m with m from the root of 1/2 to the root of 2
    let bits = x.to_bits();
    let e = (bits.wrapping_sub(0x3f35_04f3) as i32) >> 23;
    let m = f32::from_bits(bits.wrapping_sub((e as u32) << 23));
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    e as f32 * std::f32::consts::LN_2 + 2.0 * s * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gaussian_profile_gives_its_own_place_and_height() {
        for shift in [-0.5_f32, -0.3, 0.0, 0.2, 0.49] {
            for blur in [1.5_f32, 2.0, 3.0] {
                let g =
                    |x: f32| 40.0 / (std::f32::consts::TAU.sqrt() * blur) * (-0.5 * ((x - shift) / blur).powi(2)).exp();
                let (offset, top, sharpness) = peak(g(-1.0), g(0.0), g(1.0)).unwrap();
                let beyond = [g(shift + 4.5) / top; 2];
                let step = Profile { top, sharpness, beyond, distance: 4.5 }.step(1.5);
                assert!((offset - shift).abs() < 1e-3, "{offset} is not {shift}");
                assert!((step - 40.0).abs() < 0.1, "{step} at blur {blur}");
            }
        }
    }

    #[test]
    fn the_logarithm_is_as_right_as_said() {
        for i in 1..=100_000 {
            let x = i as f32 / 50_000.0;
            assert!((f64::from(ln(x)) - f64::from(x).ln()).abs() < 1e-6, "{x}: {}", ln(x));
        }
    }

    #[test]
    fn the_direction_is_across_the_edge() {
        for degrees in 0..180 {
            let (y, x) = (degrees as f32).to_radians().sin_cos();
            let [nx, ny] = direction(9.0 * x * x, 9.0 * x * y, 9.0 * y * y);
            assert!((nx * x + ny * y).abs() > 0.9999, "{degrees} degrees: {nx} {ny}");
        }
    }
}
