//! Tests of `margins`.

use super::*;

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
