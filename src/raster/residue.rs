//! What is thin in a plane: the residue of a morphological closing or opening (top-hat transform, Serra 1982).
//!
//! A closing by a square removes dark structures that the square does not fit into, an opening light ones. What they
//! remove is the structure's contrast with its ground, also where the grounds on its two sides differ; edges of wider
//! areas leave nothing. Windows grow by doubling, a few operations a pixel whatever the size of the square, on whole
//! vectors.

use pulp::{Arch, Simd, WithSimd};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::units::Size;

/// Which structures are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Polarity {
    /// Darker than their ground, or with less of a colour.
    Below,
    /// Lighter than their ground, or with more of a colour.
    Above,
}

/// A value of a pixel: a number, or a level of 256.
pub trait Level: Copy + Default + PartialOrd + Send + Sync {
    /// None is less.
    const LEAST: Self;
    /// Opposites are in the opposite order, and as far apart.
    fn opposite(self) -> Self;
    /// How far it is above another one; 0 if it is below.
    fn above(self, other: Self) -> Self;
}

impl Level for f32 {
    const LEAST: Self = Self::NEG_INFINITY;

    fn opposite(self) -> Self {
        -self
    }

    fn above(self, other: Self) -> Self {
        (self - other).max(0.0)
    }
}

impl Level for u8 {
    const LEAST: Self = 0;

    fn opposite(self) -> Self {
        Self::MAX - self
    }

    fn above(self, other: Self) -> Self {
        self.saturating_sub(other)
    }
}

/// Contrast of structures that are narrower than `2 radius + 1` px, and 0 elsewhere.
pub fn residue<V: Level>(values: &[V], size: Size, radius: usize, polarity: Polarity) -> Vec<V> {
    // thin structures are made low
    let is_opposite = polarity == Polarity::Above;
    let dilated = square_max(values, size, radius, is_opposite);
    let mut residue = square_max(&dilated, size, radius, true);
    for (closed, &value) in residue.iter_mut().zip(values) {
        *closed = closed.opposite().above(if is_opposite { value.opposite() } else { value });
    }
    residue
}

/// The greatest value within a square of `2 radius + 1` pixels around each pixel, of values or of their opposites.
pub fn square_max<V: Level>(values: &[V], size: Size, radius: usize, of_opposites: bool) -> Vec<V> {
    let (width, height) = (size.width as usize, size.height as usize);
    let window = 2 * radius + 1;
    let arch = Arch::new();
    let mut most = vec![V::default(); values.len()];
    // bands of rows, each with the rows around it that it needs
    let bands = most.par_chunks_mut(BAND * width).enumerate();
    bands.for_each_init(<[Vec<V>; 3]>::default, |[padded, spare, along], (band, out)| {
        let first = band * BAND;
        let rows = out.len() / width;
        let last = (first + rows + radius).min(height);
        along.clear();
        along.resize(radius.saturating_sub(first) * width, V::LEAST);
        for row in values[first.saturating_sub(radius) * width..last * width].chunks_exact(width) {
            padded.clear();
            padded.resize(radius, V::LEAST);
            if of_opposites {
                padded.extend(row.iter().map(|value| value.opposite()));
            } else {
                padded.extend_from_slice(row);
            }
            padded.resize(width + 2 * radius, V::LEAST);
            arch.dispatch(RowMax { padded: &mut *padded, spare: &mut *spare, window });
            along.extend_from_slice(&padded[..width]);
        }
        along.resize((rows + 2 * radius) * width, V::LEAST);
        arch.dispatch(ColumnMax { padded: along, out, width, window });
    });
    most
}

/// Rows that are taken at a time.
const BAND: usize = 64;

/// Each value becomes the greatest of those in a window that begins with it: of two windows of half the width, again
/// and again.
struct RowMax<'a, V> {
    padded: &'a mut Vec<V>,
    spare: &'a mut Vec<V>,
    window: usize,
}

impl<V: Level> WithSimd for RowMax<'_, V> {
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

/// [`RowMax`] down the columns, the last step of which is written to `out`.
struct ColumnMax<'a, V> {
    padded: &'a mut [V],
    out: &'a mut [V],
    width: usize,
    window: usize,
}

impl<V: Level> WithSimd for ColumnMax<'_, V> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { padded, out, width, window } = self;
        let mut reached = 1;
        for step in steps(window) {
            reached += step;
            if reached == window {
                let ahead = &padded[step * width..];
                let both = padded.iter().zip(ahead);
                out.iter_mut().zip(both).for_each(|(out, (here, there))| *out = greater(*here, *there));
            } else {
                let rows = padded.len() / width;
                for row in 0..rows.saturating_sub(step) {
                    let (above, below) = padded.split_at_mut((row + step) * width);
                    let here = &mut above[row * width..][..width];
                    here.iter_mut().zip(&*below).for_each(|(here, there)| *here = greater(*here, *there));
                }
            }
        }
    }
}

/// The steps by which windows grow from 1 to `window`, which is at least 2.
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
fn greater<V: Level>(a: V, b: V) -> V {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests;
