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
mod tests {
    use super::*;

    /// The letter F as the eight EXIF orientations store it, after the EXIF standard's own drawing (row 0 and column 0
    /// of the stored picture are which sides of the scene).
    #[test]
    fn all_eight_orientations_stand_up() {
        let upright_f = "##\n#.\n##\n#.\n#.";
        for (exif, stored) in [
            (1, "##\n#.\n##\n#.\n#."),
            (2, "##\n.#\n##\n.#\n.#"),
            (3, ".#\n.#\n##\n.#\n##"),
            (4, "#.\n#.\n##\n#.\n##"),
            (5, "#####\n#.#.."),
            (6, "#.#..\n#####"),
            (7, "..#.#\n#####"),
            (8, "#####\n..#.#"),
        ] {
            let rows: Vec<&str> = stored.lines().collect();
            let size = Size::new(rows[0].len() as u32, rows.len() as u32);
            let plane = rows.concat().chars().map(|c| if c == '#' { 0.0 } else { 1.0 }).collect();
            let orientation = Orientation::from_exif(exif).unwrap();
            let out = upright(plane, size, orientation);
            let text: Vec<String> = out
                .chunks(turned(size, orientation).width as usize)
                .map(|row| row.iter().map(|&v| if v < 0.5 { '#' } else { '.' }).collect())
                .collect();
            assert_eq!(text.join("\n"), upright_f, "orientation {exif}");
        }
    }

    /// Cutting a part out of the stored picture and turning it is the same as turning the picture and cutting.
    #[test]
    fn parts_are_found_in_all_eight_orientations() {
        for exif in 1..=8 {
            let orientation = Orientation::from_exif(exif).unwrap();
            let stored = Size::new(7, 5);
            let plane: Vec<f32> = (0..35).map(|i| i as f32).collect();
            let cut = |plane: &[f32], width: u32, part: PixelPart| -> Vec<f32> {
                let rows = plane.chunks(width as usize).skip(part.top as usize).take(part.size.height as usize);
                rows.flat_map(|row| row[part.left as usize..][..part.size.width as usize].to_vec()).collect()
            };
            let part = PixelPart { left: 1, top: 2, size: Size::new(3, 2) };
            let turned_first =
                cut(&upright(plane.clone(), stored, orientation), turned(stored, orientation).width, part);
            let as_stored = part_as_stored(part, stored, orientation);
            let cut_first = upright(cut(&plane, 7, as_stored), as_stored.size, orientation);
            assert_eq!(turned_first, cut_first, "orientation {exif}");
        }
    }
}
