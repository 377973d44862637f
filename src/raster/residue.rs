//! What is thin in a plane: the residue of a morphological closing or opening (top-hat transform, Serra 1982).
//!
//! A closing by a square removes dark structures that the square does not fit into, an opening light ones. What they
//! remove is the structure's contrast with its ground, also where the grounds on its two sides differ; edges of wider
//! areas leave nothing. Windows grow by doubling, a few operations a pixel whatever the size of the square, on whole
//! vectors.

use pulp::{Arch, Simd, WithSimd};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use super::plane::Plane;
use crate::units::Size;

/// Which structures are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Polarity {
    /// Darker than their ground, or with less of a colour.
    Below,
    /// Lighter than their ground, or with more of a colour.
    Above,
}

/// Contrast of structures that are narrower than `2 radius + 1` px, and 0 elsewhere.
pub fn residue(plane: &Plane, radius: usize, polarity: Polarity) -> Plane {
    let values = match polarity {
        Polarity::Below => plane.values.clone(),
        Polarity::Above => plane.values.iter().map(|value| -value).collect(),
    };
    let size = plane.size;
    let dilated = square_max(&values, size, radius);
    let negated: Vec<f32> = dilated.iter().map(|value| -value).collect();
    let closed = square_max(&negated, size, radius);
    let residue = closed.iter().zip(&values).map(|(closed, value)| (-closed - value).max(0.0)).collect();
    Plane { size, values: residue }
}

/// The greatest value within a square of `2 radius + 1` pixels around each pixel.
pub fn square_max(values: &[f32], size: Size, radius: usize) -> Vec<f32> {
    let (width, height) = (size.width as usize, size.height as usize);
    let arch = Arch::new();
    let window = 2 * radius + 1;
    let mut along = vec![0.0; values.len()];
    along.par_chunks_mut(width).zip(values.par_chunks(width)).for_each(|(out, row)| {
        let mut padded = vec![f32::NEG_INFINITY; width + 2 * radius];
        padded[radius..radius + width].copy_from_slice(row);
        let mut spare = Vec::with_capacity(padded.len());
        arch.dispatch(RowMax { padded: &mut padded, spare: &mut spare, window });
        out.copy_from_slice(&padded[..width]);
    });
    let mut both = vec![0.0; values.len()];
    // bands of rows, each with the rows around it that it needs
    both.par_chunks_mut(BAND * width).enumerate().for_each(|(band, out)| {
        let rows = out.len() / width;
        let first = band * BAND;
        let mut padded = vec![f32::NEG_INFINITY; (rows + 2 * radius) * width];
        let from = first.saturating_sub(radius);
        let to = (first + rows + radius).min(height);
        let start = (from + radius - first) * width;
        padded[start..start + (to - from) * width].copy_from_slice(&along[from * width..to * width]);
        arch.dispatch(ColumnMax { padded: &mut padded, width, window });
        out.copy_from_slice(&padded[..rows * width]);
    });
    both
}

/// Rows that are taken at a time.
const BAND: usize = 64;

/// Each value becomes the greatest of those in a window that begins with it: of two windows of half the width, again
/// and again.
struct RowMax<'a> {
    padded: &'a mut Vec<f32>,
    spare: &'a mut Vec<f32>,
    window: usize,
}

impl WithSimd for RowMax<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for step in steps(self.window) {
            let from = &self.padded[..];
            let ahead = &from[step..];
            self.spare.clear();
            self.spare.extend(from.iter().zip(ahead).map(|(here, there)| greater(*here, *there)));
            self.spare.extend_from_slice(&from[ahead.len()..]);
            std::mem::swap(self.padded, self.spare);
        }
    }
}

/// [`RowMax`] down the columns.
struct ColumnMax<'a> {
    padded: &'a mut [f32],
    width: usize,
    window: usize,
}

impl WithSimd for ColumnMax<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for step in steps(self.window) {
            let rows = self.padded.len() / self.width;
            for row in 0..rows.saturating_sub(step) {
                let (above, below) = self.padded.split_at_mut((row + step) * self.width);
                let here = &mut above[row * self.width..][..self.width];
                here.iter_mut().zip(&*below).for_each(|(here, there)| *here = greater(*here, *there));
            }
        }
    }
}

/// The steps by which windows grow from 1 to `window`.
#[inline(always)]
fn steps(window: usize) -> impl Iterator<Item = usize> {
    let mut reached = 1;
    std::iter::from_fn(move || {
        let step = reached.min(window - reached);
        reached += step;
        (step > 0).then_some(step)
    })
}

/// One instruction, which `f32::max` is not.
#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size::new(30, 20);

    fn plane(value: impl Fn(usize, usize) -> f32) -> Plane {
        let width = SIZE.width as usize;
        Plane { size: SIZE, values: (0..SIZE.len()).map(|i| value(i % width, i / width)).collect() }
    }

    #[test]
    fn the_greatest_value_around_each_pixel_is_that_of_its_square() {
        let plane = plane(|x, y| ((x * 7 + y * 13) % 17) as f32);
        let most = square_max(&plane.values, SIZE, 2);
        for (y, x) in (0..20_usize).flat_map(|y| (0..30_usize).map(move |x| (y, x))) {
            let rows = y.saturating_sub(2)..(y + 3).min(20);
            let around = rows.flat_map(|y| (x.saturating_sub(2)..(x + 3).min(30)).map(move |x| (y, x)));
            let expected = around.map(|(y, x)| plane.values[y * 30 + x]).fold(f32::MIN, f32::max);
            assert!((most[y * 30 + x] - expected).abs() < f32::EPSILON, "{x}, {y}");
        }
    }

    #[test]
    fn a_thin_stroke_between_two_grounds_is_left_and_their_edge_is_not() {
        let ground = |x: usize| if x < 15 { 80.0 } else { 60.0 };
        let edge = plane(|x, _| ground(x));
        assert!(residue(&edge, 3, Polarity::Below).values.iter().all(|value| *value == 0.0));
        let stroke = plane(|x, _| if (14..16).contains(&x) { 10.0 } else { ground(x) });
        let below = residue(&stroke, 3, Polarity::Below);
        assert_eq!(below.values[5 * 30..][12..18], [0.0, 0.0, 50.0, 50.0, 0.0, 0.0]);
        assert!(residue(&stroke, 3, Polarity::Above).values.iter().all(|value| *value == 0.0));
    }
}
