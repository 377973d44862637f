//! One plane of numbers: blur it, look up between its pixels.

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

    /// The value at a position in pixels (centres at +0.5), bilinear; beyond the edge the nearest pixel counts.
    pub fn at(&self, x: f32, y: f32) -> f32 {
        Self::look_up(&self.values, self.size, x, y)
    }

    /// [`Plane::at`] for values that are not in a `Plane`.
    pub fn look_up(values: &[f32], size: Size, x: f32, y: f32) -> f32 {
        SubpixelPosition::new(size, x, y).look_up(values)
    }

    /// [`Plane::at`] of several positions, the very same values: processors work the positions out side by side.
    pub fn at_each<const N: usize>(&self, x: [f32; N], y: [f32; N]) -> [f32; N] {
        let width = self.size.width as usize;
        let ((left, right, tx), (top, bottom, ty)) = (between(x, self.size.width), between(y, self.size.height));
        // left and right above, then below
        let mut corners = [[0.0; N]; 4];
        for i in 0..N {
            let [left, right] = [left[i], right[i]].map(|column| column as usize);
            let [above, below] = [top[i], bottom[i]].map(|row| row as usize * width);
            corners[0][i] = self.values[above + left];
            corners[1][i] = self.values[above + right];
            corners[2][i] = self.values[below + left];
            corners[3][i] = self.values[below + right];
        }
        let mut values = [0.0; N];
        for i in 0..N {
            let above = corners[0][i] * (1.0 - tx[i]) + corners[1][i] * tx[i];
            let below = corners[2][i] * (1.0 - tx[i]) + corners[3][i] * tx[i];
            values[i] = above * (1.0 - ty[i]) + below * ty[i];
        }
        values
    }

    /// Blurs with a Gaussian of `sigma` pixels; beyond the edge the nearest pixel counts.
    #[must_use]
    pub fn blurred(&self, sigma: f32) -> Self {
        if sigma <= 0.0 {
            return self.clone();
        }
        Arch::new().dispatch(Filter { plane: self, kernel: &gauss(sigma) })
    }

    /// Filters with an even kernel (half of it given) along x, then along y.
    #[inline(always)]
    fn filtered(&self, kernel: &[f32]) -> Self {
        let (width, height, radius) = (self.size.width as usize, self.size.height as usize, kernel.len() - 1);
        // rows that are filtered along x, each as long as it counts for a row that is to come: they take turns
        let turns = 2 * radius + 1;
        let mut across = vec![0.0; turns * width];
        let (mut padded, mut next) = (Vec::new(), 0);
        let mut values = Vec::with_capacity(self.values.len());
        for y in 0..height {
            while next < (y + radius + 1).min(height) {
                pad(&self.values[next * width..(next + 1) * width], radius, &mut padded);
                let turn = next % turns;
                filter_row(&padded, kernel, &mut across[turn * width..(turn + 1) * width]);
                next += 1;
            }
            let row = |at: usize| {
                let turn = at.min(height - 1) % turns;
                &across[turn * width..(turn + 1) * width]
            };
            values.extend(row(y).iter().map(|v| kernel[0] * v));
            let to = &mut values[y * width..(y + 1) * width];
            for (step, k) in kernel.iter().enumerate().skip(1) {
                let (above, below) = (row(y.saturating_sub(step)), row(y + step));
                for i in 0..width {
                    to[i] += k * (above[i] + below[i]);
                }
            }
        }
        Self { size: self.size, values }
    }
}

/// The pixels before and behind positions along an axis of `count` pixels, and the ways from the first towards the
/// second, 0..1. Pixels are numbered by `i32`, into which processors turn several numbers at once.
fn between<const N: usize>(at: [f32; N], count: u32) -> ([i32; N], [i32; N], [f32; N]) {
    let last = (count - 1) as i32;
    let (mut before, mut behind, mut way) = ([0; N], [0; N], [0.0; N]);
    for i in 0..N {
        let at = (at[i] - 0.5).clamp(0.0, last as f32);
        before[i] = at as i32;
        behind[i] = (before[i] + 1).min(last);
        way[i] = at - before[i] as f32;
    }
    (before, behind, way)
}

/// A position between four pixels, to look up in several planes of one size.
#[derive(Debug, Clone, Copy)]
pub struct SubpixelPosition {
    width: usize,
    left: usize,
    right: usize,
    top: usize,
    bottom: usize,
    /// The position between the pixels, 0..1.
    tx: f32,
    ty: f32,
}

impl SubpixelPosition {
    /// A position in pixels (centres at +0.5) in planes of this size.
    pub fn new(size: Size, x: f32, y: f32) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let fx = (x - 0.5).clamp(0.0, (width - 1) as f32);
        let fy = (y - 0.5).clamp(0.0, (height - 1) as f32);
        let (left, top) = (fx as u32 as usize, fy as u32 as usize);
        let (right, bottom) = ((left + 1).min(width - 1), (top + 1).min(height - 1));
        Self { width, left, right, top, bottom, tx: fx - left as f32, ty: fy - top as f32 }
    }

    /// The value there, bilinear; beyond the edge the nearest pixel counts.
    pub fn look_up(&self, values: &[f32]) -> f32 {
        let Self { width, left, right, top, bottom, tx, ty } = *self;
        let row = |y: usize| {
            let row = &values[y * width..(y + 1) * width];
            row[left] * (1.0 - tx) + row[right] * tx
        };
        row(top) * (1.0 - ty) + row(bottom) * ty
    }

    /// [`SubpixelPosition::look_up`] of several values for each pixel, which lie side by side.
    pub fn look_up_each<const N: usize>(&self, values: &[[f32; N]]) -> [f32; N] {
        let Self { width, left, right, top, bottom, tx, ty } = *self;
        let [above, below] = [&values[top * width..(top + 1) * width], &values[bottom * width..(bottom + 1) * width]];
        let (corners, mut all) = ([&above[left], &above[right], &below[left], &below[right]], [0.0; N]);
        for (k, value) in all.iter_mut().enumerate() {
            let above = corners[0][k] * (1.0 - tx) + corners[1][k] * tx;
            let below = corners[2][k] * (1.0 - tx) + corners[3][k] * tx;
            *value = above * (1.0 - ty) + below * ty;
        }
        all
    }
}

struct Filter<'a> {
    plane: &'a Plane,
    kernel: &'a [f32],
}

impl WithSimd for Filter<'_> {
    type Output = Plane;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Plane {
        self.plane.filtered(self.kernel)
    }
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
mod tests;
