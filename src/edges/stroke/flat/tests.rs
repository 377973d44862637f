//! Tests of `flat`.

use super::*;

/// A picture in which one of `every` columns differs from those beside it, from a row on.
fn picture(every: usize, from: usize) -> Raster {
    let size = Size::new(64, 64);
    let level = |i: usize| if i / 64 >= from && (i % 64).is_multiple_of(every) { 0.1 } else { 0.8 };
    Raster::grey(size, (0..64 * 64).map(level).collect())
}

#[test]
fn a_drawing_is_mostly_of_flat_areas() {
    let flatness = Flatness { chroma: 1.0, share: FLAT_SHARE, line: f32::INFINITY };
    let is_flat = |picture: &Raster| super::is_flat(picture, 1.0, flatness);
    assert!(is_flat(&picture(1000, 0)), "nothing differs");
    assert!(is_flat(&picture(16, 0)), "two of 16 steps");
    assert!(!is_flat(&picture(3, 0)), "two of three steps");
    // 0.4 of the rows are full of steps, first or last
    assert!(!is_flat(&picture(2, 38)));
    assert!(is_flat(&picture(2, 52)));
}

#[test]
fn strokes_are_no_evidence_where_lines_do_not_count() {
    let flatness = Flatness { chroma: 1.0, share: FLAT_SHARE, line: LINE };
    // two of five steps, all of them strong: what is left is flat
    assert!(super::is_flat(&picture(5, 0), 1.0, flatness));
    assert!(!super::is_flat(&picture(2, 0), 1.0, flatness), "nothing is flat");
    let weak = Raster::grey(Size::new(64, 64), (0..64 * 64).map(|i| if i % 3 == 0 { 0.77 } else { 0.8 }).collect());
    assert!(!super::is_flat(&weak, 0.5, flatness));
}
