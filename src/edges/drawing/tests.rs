//! Tests of `drawing`: what pixels show beside paths.

use resvg::tiny_skia::{PathBuilder, Rect};

use super::*;
use crate::raster::vector::{PaintedPath, PixelArea};
use crate::units::{PxPoint, Size};

const SIZE: Size = Size::new(120, 80);

/// The contours of a picture of a black area of 60 by 40 px, of which what lies in a box may be on no path, each with
/// its length and whether it is closed and exact.
fn found(min: (f32, f32), max: (f32, f32), paths: Vec<PaintedPath>) -> Vec<(f32, bool, bool)> {
    let is_white = |pixel: usize| {
        let (x, y) = (pixel % SIZE.width as usize, pixel / SIZE.width as usize);
        !((30..90).contains(&x) && (20..60).contains(&y))
    };
    let raster = Raster::grey(SIZE, (0..SIZE.len()).map(|pixel| f32::from(is_white(pixel))).collect());
    let area = PixelArea { min: PxPoint::from(min), max: PxPoint::from(max) };
    let drawing = VectorDrawing { paths, pixel_areas: vec![area] };
    let params = Params { sigma: 1.8, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 19.0, ..Params::default() };
    let edges = find_in_vector(&raster, &drawing, &params);
    edges.chains().zip(&edges.chains).map(|(chain, range)| (chain.length(), range.closed, range.kind.exact)).collect()
}

#[test]
fn what_pixels_show_beside_paths_is_a_contour_if_it_is_as_long_as_one() {
    let all = found((0.0, 0.0), (120.0, 80.0), Vec::new());
    assert!(matches!(all[..], [(length, true, false)] if (length - 200.0).abs() < 8.0), "{all:?}");
    // but for the lower side; the ring may begin anywhere
    let three_sides = found((20.0, 0.0), (100.0, 55.0), Vec::new());
    let length: f32 = three_sides.iter().map(|(length, ..)| length).sum();
    assert!((length - 130.0).abs() < 8.0 && three_sides.iter().all(|(_, closed, _)| !closed), "{three_sides:?}");
    // a corner with sides of 4 and 3 px
    assert_eq!(found((86.0, 0.0), (100.0, 23.0), Vec::new()), []);
}

#[test]
fn what_pixels_show_along_a_path_is_that_path() {
    let path = PathBuilder::from_rect(Rect::from_ltrb(30.0, 20.0, 90.0, 60.0).expect("a rectangle"));
    let both = found((0.0, 0.0), (120.0, 80.0), vec![PaintedPath::filled(path)]);
    assert!(matches!(both[..], [(length, true, true)] if (length - 200.0).abs() < 2.0), "{both:?}");
}
