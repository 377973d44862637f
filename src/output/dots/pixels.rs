//! Dots as a PNG picture in which a pixel is a dot: for embossers and displays whose own programs take pictures.
//!
//! White is no dot; the darker, the higher. The picture says how far apart its pixels are, in whole pixels a metre as
//! PNG has it: 20 to the inch come out as 787, which is as near as the format goes.

use png::{BitDepth, Filter};

use super::DocumentWords;
use super::dot_matrix::DotMatrix;
use crate::output::layer::GREYS;
use crate::output::png_file::PngFile;

/// Of zlib, 1..=9. The pictures are small.
const LEVEL: u8 = 9;

/// One page as PNG, whose dots are `pitch` mm apart. A device with one height (no `has_heights`) gets black for every
/// dot.
///
/// A matrix without columns or rows comes out as one white pixel, since there are no smaller pictures.
pub fn write(matrix: &DotMatrix, pitch: f32, has_heights: bool, words: &DocumentWords<'_>) -> Vec<u8> {
    let [width, height] = [matrix.columns(), matrix.rows()].map(|dots| dots.max(1));
    let file = PngFile {
        size: [width, height].map(|dots| u32::try_from(dots).unwrap_or(u32::MAX)),
        depth: BitDepth::Eight,
        filter: Filter::NoFilter,
        level: LEVEL,
        per_metre: (1000.0 / f64::from(pitch)).round() as u32,
        words: [(words.title, words.language), (words.description, words.description_language)],
        origin: None,
    };
    let grey = |x, y| match matrix.height(x, y) {
        0 => GREYS[0],
        _ if !has_heights => GREYS[3],
        height => GREYS[usize::from(height.min(DotMatrix::HIGHEST))],
    };
    let written = file
        .write(|out| (0..height).try_for_each(|y| out.write_all(&(0..width).map(|x| grey(x, y)).collect::<Vec<u8>>())));
    written.unwrap_or_default() // writing to memory cannot fail
}

#[cfg(test)]
mod tests;
