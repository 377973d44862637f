//! Tests of `outlines`.

use super::*;
use crate::units::MmPoint;

/// A line through these places, mm, a vertex every half millimetre, with this difference of colour.
fn line(places: &[(f32, f32)], closed: bool, contrast: f32) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex {
        at: MmPoint::new(x, y),
        strength: 50.0,
        contrast: [contrast, 0.0, 0.0],
        width: 1.0,
        ..Vertex::TEST
    };
    Polyline { vertices: places.iter().map(vertex).collect(), closed }.resampled(0.5)
}

#[test]
fn only_a_long_straight_open_stroke_goes_before_outlines() {
    let long = [(0.0, 0.0), (LONG + 1.0, 0.0)];
    assert_eq!(Rank::of(&line(&long, false, 0.0)), Rank::Stroke);
    assert_eq!(Rank::of(&line(&long, false, 30.0)), Rank::Ordinary, "an edge, with a colour on each side");
    assert_eq!(Rank::of(&line(&[(0.0, 0.0), (LONG - 1.0, 0.0)], false, 0.0)), Rank::Ordinary, "short");
    assert_eq!(Rank::of(&line(&[(0.0, 0.0), (15.0, 10.0), (30.0, 0.0)], false, 0.0)), Rank::Ordinary, "bent");
    assert_eq!(Rank::of(&line(&[(0.0, 0.0), (30.0, 0.0), (30.0, 9.0)], true, 0.0)), Rank::Ordinary, "closed");
    assert_eq!(Rank::of(&line(&[], false, 0.0)), Rank::Ordinary);
}

#[test]
fn a_line_that_is_partly_an_edge_is_a_stroke_if_most_of_it_is() {
    let mixed = |stroke: f32| {
        let mut all = line(&[(0.0, 0.0), (30.0 * stroke, 0.0)], false, 0.0);
        all.vertices.extend(line(&[(30.0 * stroke + 0.5, 0.0), (30.0, 0.0)], false, 30.0).vertices);
        Rank::of(&all)
    };
    assert_eq!([mixed(0.8), mixed(0.6)], [Rank::Stroke, Rank::Ordinary]);
}

#[test]
fn what_comes_first_is_greater() {
    let order = [Rank::Faint, Rank::Ordinary, Rank::Outline, Rank::Stroke, Rank::Subject, Rank::Person];
    assert!(order.is_sorted());
    assert_eq!(order.map(Rank::is_outline), [false, false, true, false, true, false]);
}
