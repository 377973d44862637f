//! What is thin in a plane: the residue of a morphological closing or opening (top-hat transform, Serra 1982).
//!
//! A closing by a square removes dark structures that the square does not fit into, an opening light ones. What they
//! remove is the structure's contrast with its ground, also where the grounds on its two sides differ; edges of wider
//! areas leave nothing. Both take a few operations a pixel, whatever the size of the square (van Herk 1992, Gil and
//! Werman 1993).

use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::raster::plane::Plane;
use crate::units::Size;

/// Which structures are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Polarity {
    /// Darker than their ground, or with less of a colour.
    Below,
    /// Lighter than their ground, or with more of a colour.
    Above,
}

/// Contrast of structures that are narrower than `2 radius + 1` px, and 0 elsewhere.
pub(super) fn residue(plane: &Plane, radius: usize, polarity: Polarity) -> Plane {
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
pub(super) fn square_max(values: &[f32], size: Size, radius: usize) -> Vec<f32> {
    let (width, height) = (size.width as usize, size.height as usize);
    let along = rows_max(values, width, radius);
    let turned = transposed(&along, width, height);
    let both = rows_max(&turned, height, radius);
    transposed(&both, height, width)
}

fn transposed(values: &[f32], width: usize, height: usize) -> Vec<f32> {
    let mut turned = vec![0.0; values.len()];
    turned.par_chunks_mut(height).enumerate().for_each(|(x, column)| {
        column.iter_mut().enumerate().for_each(|(y, value)| *value = values[y * width + x]);
    });
    turned
}

/// The greatest value within `radius` of each value of a row, row by row.
fn rows_max(values: &[f32], width: usize, radius: usize) -> Vec<f32> {
    let mut out = vec![0.0; values.len()];
    let window = 2 * radius + 1;
    out.par_chunks_mut(width).zip(values.par_chunks(width)).for_each(|(out, row)| {
        // the row with `radius` values below all others at both ends, in whole windows
        let padded_len = (width + 2 * radius).div_ceil(window) * window;
        let mut padded = vec![f32::NEG_INFINITY; padded_len];
        padded[radius..radius + width].copy_from_slice(row);
        // greatest value from the start of each window, and to its end
        let (mut from_start, mut to_end) = (padded.clone(), padded);
        for block in from_start.chunks_mut(window) {
            (1..block.len()).for_each(|i| block[i] = block[i].max(block[i - 1]));
        }
        for block in to_end.chunks_mut(window) {
            (0..block.len() - 1).rev().for_each(|i| block[i] = block[i].max(block[i + 1]));
        }
        out.iter_mut().enumerate().for_each(|(x, value)| *value = to_end[x].max(from_start[x + window - 1]));
    });
    out
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
