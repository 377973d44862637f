//! The rim of a scanned photograph: a dark or white strip along a side, which is no part of what it shows.

use super::lab::pixel;
use super::{Planes, Raster};

/// A rim is darker, or lighter, than this, 0..=100.
const DARK: f32 = 30.0;
const WHITE: f32 = 97.0;
/// Most that the lightness of a rim differs from its median, and least that what lies behind it does.
const EVEN: f32 = 8.0;
const STEP: f32 = 12.0;
/// It is no wider than this share of the picture's shorter side. Of 300 photographs of BSDS500 (train and val) 54 have
/// a rim by these numbers, up to .037 wide, and by the lightness of its lines it is one in each.
const WIDEST: f32 = 0.05;
/// Share of a side behind which there is a step: of the first side with a rim, and of others then. Elsewhere the
/// picture may be as dark.
const LONG: f32 = 0.6;
const LONG_OF_OTHERS: f32 = 0.4;
/// Where a slanted rim is narrower than a pixel, the outermost one is a mixture with what lies behind: it counts if it
/// differs by less than this share of what that does. Of those 300 photographs one more has a rim by it, a true one;
/// with 0.6 it is the same, with 0.7 two have.
const MIXED: f32 = 0.5;
/// A step may be a little shorter than that, where its inner border is looked through.
const STEP_LONG: f32 = 0.9;
/// Its inner border is straight: over four fifths of it the width changes by no more than this share of the shorter
/// side, or by [`LEAST_UNEVEN`] pixels.
const UNEVEN: f32 = 0.01;
const LEAST_UNEVEN: usize = 3;
/// Its inner border is soft over so many pixels.
const SOFT: usize = 3;

/// How wide the rim of a picture is, px: left, top, right, bottom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rim(pub [usize; 4]);

impl Rim {
    /// The rim of a picture, if it has one on any side.
    pub fn of(raster: &Raster) -> Option<Self> {
        let (width, height) = (raster.size().width as usize, raster.size().height as usize);
        let at = |x: usize, y: usize| pixel(raster, y * width + x)[0];
        let widths = |share: f32| {
            [
                width_of(width, height, share, &|depth, along| at(depth, along)),
                width_of(height, width, share, &|depth, along| at(along, depth)),
                width_of(width, height, share, &|depth, along| at(width - 1 - depth, along)),
                width_of(height, width, share, &|depth, along| at(along, height - 1 - depth)),
            ]
        };
        widths(LONG).iter().any(|of_side| *of_side > 0).then(|| Self(widths(LONG_OF_OTHERS)))
    }

    /// The picture with what lies behind the rim in its place.
    pub fn filled(&self, raster: &Raster) -> Raster {
        let size = raster.size();
        let (width, height) = (size.width as usize, size.height as usize);
        let [left, top, right, bottom] = self.0;
        let inside = |plane: &Vec<f32>| -> Vec<f32> {
            let row = |y: usize| &plane[y.clamp(top, height - 1 - bottom) * width..][..width];
            let pixel = |row: &[f32], x: usize| row[x.clamp(left, width - 1 - right)];
            (0..height).flat_map(|y| (0..width).map(move |x| pixel(row(y), x))).collect()
        };
        let planes: Planes<Vec<f32>> = raster.planes().as_ref().map(inside);
        Raster::new(size, planes)
    }
}

/// How wide the rim along a side is that has so many pixels along it, in a picture so many pixels deep from there; 0 if
/// there is none along such a `share` of it. `at` gives the lightness at a depth and a place along the side.
fn width_of(deep: usize, long: usize, share: f32, at: &dyn Fn(usize, usize) -> f32) -> usize {
    let shorter = deep.min(long) as f32;
    let most = ((WIDEST * shorter).ceil() as usize).max(LEAST_UNEVEN);
    if most + SOFT >= deep / 2 {
        return 0;
    }
    let mut outermost: Vec<f32> = (0..long).map(|along| at(0, along)).collect();
    outermost.sort_by(f32::total_cmp);
    let colour = outermost[long / 2];
    if colour > DARK && colour < WHITE {
        return 0;
    }
    let is_rim = |depth: usize, along: usize| (at(depth, along) - colour).abs() <= EVEN;
    let depth = |along: usize| (0..=most).find(|&depth| !is_rim(depth, along));
    let mut depths: Vec<usize> = (0..long).filter_map(depth).filter(|depth| *depth > 0).collect();
    let is_mixed = |along: &usize| {
        let [own, behind] = [0, SOFT].map(|depth| (at(depth, *along) - colour).abs());
        own > EVEN && behind > STEP && own < MIXED * behind
    };
    let mixed = (0..long).filter(is_mixed).count();
    let is_long = |count: usize, share: f32| count as f32 >= share * long as f32;
    if !is_long(depths.len(), LONG_OF_OTHERS) || !is_long(depths.len() + mixed, share) {
        return 0;
    }
    depths.sort_unstable();
    let tenth = depths.len() / 10;
    let (narrow, wide) = (depths[tenth], depths[depths.len() - 1 - tenth]);
    let is_straight = wide - narrow <= LEAST_UNEVEN.max((UNEVEN * shorter) as usize);
    let behind = wide + SOFT;
    let steps = (0..long).filter(|&along| (at(behind, along) - colour).abs() > STEP).count();
    if is_straight && steps as f32 >= STEP_LONG * share * long as f32 { behind } else { 0 }
}

#[cfg(test)]
mod tests;
