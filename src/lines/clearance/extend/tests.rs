//! Tests of `extend`.

use super::super::tests::{drawn, polyline};
use super::*;

/// The extension of a line from `from` to `cut` along its path on to `end`, past one line at y = 50.
fn extended(from: (f32, f32), cut: (f32, f32), end: (f32, f32)) -> Option<MmPoint> {
    let lines = drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]);
    let (body, path) = (polyline(&[from, cut], false).vertices, polyline(&[cut, end], false).vertices);
    let added = extension(&body, &path[1..], Extended::Piece, &lines)?;
    added.last().map(|vertex| vertex.at)
}

#[test]
fn a_line_cut_before_another_ends_on_it() {
    let end = extended((50.0, 80.0), (50.0, 54.0), (50.0, 20.0)).expect("it crosses");
    assert!((end - MmPoint::new(50.0, 50.0)).length() < 1e-3, "{end:?}");
}

#[test]
fn a_line_that_stops_short_is_extended_to_what_it_points_at() {
    let end = extended((50.0, 80.0), (50.0, 54.0), (50.0, 52.0)).expect("it points at the line");
    assert!((end - MmPoint::new(50.0, 50.0)).length() < 1e-3, "{end:?}");
    assert_eq!(extended((50.0, 80.0), (50.0, 60.0), (50.0, 57.0)), None, "too far");
}

#[test]
fn a_flat_approach_is_not_extended() {
    assert_eq!(extended((10.0, 64.0), (40.0, 54.0), (70.0, 44.0)), None);
}
