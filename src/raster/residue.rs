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
mod tests {
    use super::*;
    use crate::raster::plane::Plane;

    const SIZE: Size = Size::new(30, 20);

    fn plane(value: impl Fn(usize, usize) -> f32) -> Plane {
        let width = SIZE.width as usize;
        Plane { size: SIZE, values: (0..SIZE.len()).map(|i| value(i % width, i / width)).collect() }
    }

    #[test]
    fn the_greatest_value_around_each_pixel_is_that_of_its_square() {
        let plane = plane(|x, y| ((x * 7 + y * 13) % 17) as f32);
        let most = square_max(&plane.values, SIZE, 2, false);
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
        assert!(residue(&edge.values, SIZE, 3, Polarity::Below).iter().all(|value| *value == 0.0));
        let stroke = plane(|x, _| if (14..16).contains(&x) { 10.0 } else { ground(x) });
        let below = residue(&stroke.values, SIZE, 3, Polarity::Below);
        assert_eq!(below[5 * 30..][12..18], [0.0, 0.0, 50.0, 50.0, 0.0, 0.0]);
        assert!(residue(&stroke.values, SIZE, 3, Polarity::Above).iter().all(|value| *value == 0.0));
    }

    #[test]
    fn levels_have_the_residue_of_numbers() {
        let levels = plane(|x, y| ((x * 7 + y * 13 + x * y) % 41) as f32);
        for polarity in [Polarity::Below, Polarity::Above] {
            let bytes: Vec<u8> = levels.values.iter().map(|value| *value as u8).collect();
            let found: Vec<f32> = residue(&bytes, SIZE, 2, polarity).into_iter().map(f32::from).collect();
            assert_eq!(found, residue(&levels.values, SIZE, 2, polarity));
            assert!(found.iter().any(|value| *value > 0.0));
        }
    }
}
