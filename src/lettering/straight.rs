//! A line of text as a picture of its own: level, black on white, as programs that read text like it best.

use super::limits::WIDEST_CAPITAL;
use crate::geom::order;
use crate::raster::contrast::distance;
use crate::raster::plane::Plane;
use crate::raster::{Raster, lab};
use crate::units::{PxPoint, PxVector, Size};

/// Height of letters, px: capitals of 30 to 40 px are read best (Tesseract's own advice).
const HEIGHT: f32 = 34.0;
/// Letters are enlarged by no more than this.
const MOST: f32 = 6.0;
/// What is around the line in its picture, in heights of its letters; and white around that, px.
const AROUND: f32 = 0.15;
const WHITE: usize = 14;
/// Share of the pixels that are less far from the ground than black letters: what is further is black as well.
const BLACK: f32 = 0.97;

/// A line of text.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundLine {
    /// Corners of the box around its letters: top left as it is read, then clockwise.
    pub corners: [PxPoint; 4],
    /// Direction in which it is read, degrees counter-clockwise from left to right; upside down it is not told from
    /// upright.
    pub angle: f32,
    /// Height of its letters, px: that of small letters or of capitals, whichever are more.
    pub height: f32,
}

impl FoundLine {
    /// Whether it is no wider than a single letter.
    pub fn may_be_one_letter(&self) -> bool {
        let [corner, right, ..] = self.corners;
        (right - corner).length() <= WIDEST_CAPITAL * self.height
    }
}

/// A picture of one line of text, a grey a byte, row by row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinePicture {
    /// Width and height, px.
    pub size: Size,
    /// 0 is black.
    pub pixels: Vec<u8>,
}

impl LinePicture {
    /// Of a line that was found in a picture. The colour of most pixels around it is the ground, whatever it is; the
    /// further another colour is from it, the darker is the grey.
    pub(super) fn of(line: &FoundLine, raster: &Raster) -> Self {
        let scale = (HEIGHT / line.height).min(MOST);
        let around = AROUND * line.height;
        let [corner, right, _, below] = line.corners;
        let unit = |to: PxVector| to.try_normalize().unwrap_or_default();
        let (along, across) = (unit(right - corner), unit(below - corner));
        let side = |length: f32| ((length + 2.0 * around) * scale).ceil().max(1.0) as usize;
        let (columns, rows) = (side((right - corner).length()), side((below - corner).length()));
        // of letters that are made smaller, means
        let steps = (1.0 / scale).ceil().max(1.0) as usize;
        let mut colours: Vec<[f32; 3]> = Vec::with_capacity(columns * rows);
        for y in 0..rows {
            for x in 0..columns {
                let mut sum = [0.0; 3];
                for (i, j) in (0..steps * steps).map(|k| (k % steps, k / steps)) {
                    let step =
                        |at: usize, part: usize| (at as f32 + (part as f32 + 0.5) / steps as f32) / scale - around;
                    let at = corner + along * step(x, i) + across * step(y, j);
                    let planes = raster.planes().as_ref();
                    let planes = planes.map(|plane| Plane::look_up(plane, raster.size(), at.x, at.y)).as_colour();
                    sum.iter_mut().zip(planes).for_each(|(sum, value)| *sum += value / (steps * steps) as f32);
                }
                colours.push(lab::colour(sum));
            }
        }
        // bold letters cover more of their box than the ground does, but not of what is around it
        let frame = ((around * scale) as usize).max(1);
        let is_frame = |at: usize, count: usize| at < frame || at + frame >= count;
        let is_around = |cell: usize| is_frame(cell % columns, columns) || is_frame(cell / columns, rows);
        let around: Vec<&[f32; 3]> = (0..).zip(&colours).filter(|(at, _)| is_around(*at)).map(|(_, of)| of).collect();
        let middle = |axis: usize| order::middle(around.iter().map(|colour| colour[axis]).collect());
        let ground = [middle(0), middle(1), middle(2)];
        let far: Vec<f32> = colours.iter().map(|colour| distance(*colour, ground)).collect();
        let mut sorted = far.clone();
        sorted.sort_by(f32::total_cmp);
        let black = sorted[((BLACK * sorted.len() as f32) as usize).min(sorted.len() - 1)].max(1.0);
        let size = Size::new((columns + 2 * WHITE) as u32, (rows + 2 * WHITE) as u32);
        let mut pixels = vec![255; size.len()];
        for (row, far) in pixels.chunks_exact_mut(size.width as usize).skip(WHITE).zip(far.chunks_exact(columns)) {
            let grey = |far: &f32| (255.0 * (1.0 - (far / black).min(1.0))).round() as u8;
            row[WHITE..].iter_mut().zip(far).for_each(|(pixel, far)| *pixel = grey(far));
        }
        Self { size, pixels }
    }
}

#[cfg(test)]
mod tests;
