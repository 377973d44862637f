//! Tests of `branch`.

use super::super::tests::{clear_all, polyline};
use super::*;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::tests::area;

/// The lengths of two hands of a clock with so many degrees between them that are drawn, the longer one first, and
/// how far the end of the shorter one is from where it should be.
fn hands(degrees: f32, of_drawing: bool) -> (Vec<f32>, f32) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let end = (50.0 + 33.0 * cos, 50.0 + 33.0 * sin);
    let long = polyline(&[(50.0, 50.0), (99.0, 50.0)], false);
    let short = polyline(&[(50.0, 50.0), end], false);
    let params = Params { of_drawing, ..Params::TEST };
    let drawn = clear_all([long, short].map(|line| (line, Rank::Ordinary)).to_vec(), area(), &params);
    let ends = drawn.iter().flat_map(|line| [line.polyline.vertices.first(), line.polyline.vertices.last()]);
    let off = ends.flatten().map(|vertex| (vertex.at - MmPoint::from(end)).length()).fold(f32::INFINITY, f32::min);
    (drawn.iter().map(|line| line.polyline.length()).collect(), off)
}

#[test]
fn the_hour_hand_beside_the_minute_hand_branches_off_it_and_is_drawn_to_its_end() {
    let (lengths, off) = hands(10.0, true);
    assert!(matches!(lengths[..], [long, short] if (long - 49.0).abs() < 0.1 && short > 17.0), "{lengths:?}");
    assert!(off < 0.1, "{off}");
    assert_eq!(hands(10.0, false).0.len(), 1, "in a photograph it is no line");
    let (lengths, off) = hands(40.0, true);
    assert!(lengths[1] > 32.5 && off < 0.1, "with room it is whole: {lengths:?}");
}
