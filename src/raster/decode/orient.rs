//! Turns a picture upright as its EXIF orientation asks. Done on the small working picture, where it costs nothing.

use image::metadata::Orientation;

use crate::raster::crop::PixelPart;
use crate::units::Size;

/// Whether width and height change places.
pub(super) fn swaps(orientation: Orientation) -> bool {
    use Orientation::{Rotate90, Rotate90FlipH, Rotate270, Rotate270FlipH};
    matches!(orientation, Rotate90 | Rotate270 | Rotate90FlipH | Rotate270FlipH)
}

/// `size` after the turn, or before it (it is the same rule both ways).
pub(super) fn turned(size: Size, orientation: Orientation) -> Size {
    if swaps(orientation) { size.turned() } else { size }
}

/// A part of the upright picture as it lies in the stored one, which has `stored` pixels.
pub(super) fn part_as_stored(part: PixelPart, stored: Size, orientation: Orientation) -> PixelPart {
    let size = turned(part.size, orientation);
    let upright = turned(stored, orientation);
    // What is left of the part, above it, to its right and below it, in the upright picture.
    let (left, top) = (part.left, part.top);
    let (right, bottom) = (upright.width - left - part.size.width, upright.height - top - part.size.height);
    let (left, top) = match orientation {
        Orientation::NoTransforms => (left, top),
        Orientation::FlipHorizontal => (right, top),
        Orientation::Rotate180 => (right, bottom),
        Orientation::FlipVertical => (left, bottom),
        Orientation::Rotate90FlipH => (top, left),
        Orientation::Rotate90 => (top, right),
        Orientation::Rotate270FlipH => (bottom, right),
        Orientation::Rotate270 => (bottom, left),
    };
    PixelPart { left, top, size }
}

/// A plane of `size` as stored, turned upright.
pub(super) fn upright(plane: Vec<f32>, size: Size, orientation: Orientation) -> Vec<f32> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (right, bottom) = (width.saturating_sub(1), height.saturating_sub(1));
    // For a place in the upright picture, the place in the stored one.
    let stored = |x: usize, y: usize| match orientation {
        Orientation::NoTransforms => (x, y),
        Orientation::FlipHorizontal => (right - x, y),
        Orientation::Rotate180 => (right - x, bottom - y),
        Orientation::FlipVertical => (x, bottom - y),
        Orientation::Rotate90FlipH => (y, x),
        Orientation::Rotate90 => (y, bottom - x),
        Orientation::Rotate270FlipH => (right - y, bottom - x),
        Orientation::Rotate270 => (right - y, x),
    };
    if orientation == Orientation::NoTransforms {
        return plane;
    }
    let upright = turned(size, orientation);
    let mut out = Vec::with_capacity(plane.len());
    for y in 0..upright.height as usize {
        out.extend((0..upright.width as usize).map(|x| {
            let (x, y) = stored(x, y);
            plane[y * width + x]
        }));
    }
    out
}

#[cfg(test)]
mod tests;
