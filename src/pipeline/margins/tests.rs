//! Tests of `margins`.

use super::*;
use crate::page::Print;

/// A contour is seen where two pixels side by side differ, in pale lines and in one plane of colours too.
#[test]
fn contours_are_where_pixels_differ() {
    let size = Size::new(6, 4);
    let bar = |inside: f32| -> Vec<f32> { (0..24).map(|i| if i % 6 == 3 { inside } else { 1.0 }).collect() };
    let grey = contours(&Raster::grey(size, bar(0.85)));
    assert_eq!(grey.len(), 8, "two sides of a bar, in four rows: {grey:?}");
    assert!(grey.iter().all(|at| ((at.x - 3.5).abs() - 0.5).abs() < 1e-3 && (0.0..4.0).contains(&at.y)));
    assert!(contours(&Raster::grey(size, bar(0.99))).is_empty(), "noise");
    let flat = vec![1.0; 24];
    assert_eq!(contours(&Raster::colour(size, [flat.clone(), bar(0.5), flat])).len(), 8);
}

/// Words beside an axis have room for the shorter of their two forms at least, however near to the limit the longer one
/// comes: before, one that reached up to it was wanted, and then there was no room for any.
#[test]
fn words_up_to_the_limit_have_room() {
    let (source, sheet, most) = (Size::new(600, 400), [210.0, 297.0], [45.0, 30.0]);
    let layout_of = |size: Size| -> Result<Layout, Error> {
        let figure = MmVector::new(180.0, 180.0 * size.height as f32 / size.width as f32);
        let figure = MmRect::from_origin_and_size(MmPoint::new(15.0, 20.0), figure.to_size());
        Ok(Layout::of_figure(sheet, figure, Medium::Print(Print::default())))
    };
    for whole in (30_u8..120).map(f32::from) {
        // they end at an eighth of the drawing
        let left = |layout: &Layout, long: f32| layout.figure.min.x + 0.12 * layout.figure.width() - long;
        let lacks = |layout: &Layout| {
            let is_whole = left(layout, whole) >= layout.figure.min.x - most[0];
            let reach = left(layout, if is_whole { whole } else { 0.5 * whole });
            let least = f32::NEG_INFINITY;
            [layout.room.min.x - reach + moved(layout), least, least, least]
        };
        let own = layout_of(source).expect("a layout");
        let layout = widened(own, source, TextBounds { most, min_side: 12.7 }, lacks, &layout_of);
        let (shorter, room) = (left(&layout, 0.5 * whole), layout.room.min.x);
        assert!(shorter >= room - SLACK, "{whole} mm: from {shorter} in a room from {room} mm");
    }
}

/// Blank of the sheet is beside a drawing that takes all of its height, and not beside one as wide as the sheet.
#[test]
fn blank_is_found_where_the_sheet_is_wider_than_the_drawing() {
    let source = Size::new(600, 400);
    for (sheet, blank) in [([300.0, 100.0], 150.0), ([150.0, 300.0], 0.0)] {
        let layout_of = |size: Size| -> Result<Layout, Error> {
            let [width, height] = [size.width as f32, size.height as f32];
            let mm_per_px = (sheet[0] / width).min(sheet[1] / height);
            let figure = MmRect::new(MmPoint::zero(), MmPoint::new(width * mm_per_px, height * mm_per_px));
            Ok(Layout::of_figure(sheet, figure, Medium::Print(Print::default())))
        };
        let own = layout_of(source).expect("a layout");
        let found = blank_beside(&own, source, &layout_of);
        assert!((found - blank).abs() < 8.0, "{found} mm and not {blank}");
    }
}
