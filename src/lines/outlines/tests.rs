//! Tests of `outlines`.

use super::*;
use crate::units::{MmPoint, MmRect};

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
    assert_eq!(Rank::of(&line(&long, false, 0.0)), Rank::Untorn);
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
    assert_eq!([mixed(0.8), mixed(0.6)], [Rank::Untorn, Rank::Ordinary]);
}

#[test]
fn what_comes_first_is_greater() {
    let of_drawing = [Rank::Faint, Rank::Ordinary, Rank::Whole, Rank::Axis, Rank::Person];
    assert!(of_drawing.is_sorted());
    let order = [Rank::Faint, Rank::Ordinary, Rank::Outline, Rank::Untorn, Rank::Subject, Rank::Person];
    assert!(order.is_sorted());
    assert_eq!(order.map(Rank::is_outline), [false, false, true, false, true, false]);
}

#[test]
fn a_long_round_clear_ring_goes_before_outlines_unless_one_stands_for_it() {
    let circle = |radius: f32, high: f32| -> Polyline<Vertex> {
        let places: Vec<(f32, f32)> = (0..120).map(|k| (k as f32 / 120.0 * std::f32::consts::TAU).sin_cos()).collect();
        let places: Vec<(f32, f32)> =
            places.into_iter().map(|(y, x)| (60.0 + radius * x, 60.0 + high * radius * y)).collect();
        line(&places, true, 30.0)
    };
    let may_be = |ring: &Polyline<Vertex>| Rank::may_be_ring(ring, &Params::TEST);
    assert!(may_be(&circle(30.0, 1.0)) && may_be(&circle(30.0, 0.6)));
    assert!(!may_be(&circle(5.0, 1.0)), "short");
    assert!(!may_be(&circle(30.0, 0.2)), "narrow");
    let weak = |mut ring: Polyline<Vertex>| {
        ring.vertices.iter_mut().for_each(|vertex| vertex.strength = 20.0);
        ring
    };
    assert!(!may_be(&weak(circle(30.0, 1.0))));
    let few = Params { most_shapes: Some(3), ..Params::TEST };
    assert!(!Rank::may_be_ring(&circle(30.0, 1.0), &few), "few shapes are those of the outlines");
    let sheet = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 120.0));
    let along = |outline: &Polyline<Vertex>| {
        let near = super::super::vertex::nearby(std::iter::once(outline), sheet, &Params::TEST);
        Rank::is_along(&circle(30.0, 1.0), &near, &Params::TEST)
    };
    assert!(along(&circle(32.0, 1.0)) && !along(&circle(20.0, 1.0)));
    let open = |mut ring: Polyline<Vertex>, count: usize| {
        (ring.closed, ring.vertices) = (false, ring.vertices[..count].to_vec());
        ring
    };
    let half = open(circle(31.0, 1.0), 60);
    assert!(!along(&half), "half of it stands for half");
}

#[test]
fn a_very_long_smooth_clear_curve_goes_before_outlines() {
    let wave = |length: u16, high: f32, strength: f32| {
        let place = |x: u16| (f32::from(x), high * (f32::from(x) / 2.5).sin());
        let mut wave = line(&(0..=length).map(place).collect::<Vec<_>>(), false, 30.0);
        wave.vertices.iter_mut().for_each(|vertex| vertex.strength = strength);
        wave
    };
    let may_be = |curve: &Polyline<Vertex>| Rank::may_be_curve(curve, &Params::TEST);
    assert!(may_be(&wave(160, 0.3, 50.0)));
    // whichever end comes first, at a height at which it is nearly too ragged
    for high in (0..40_u16).map(|k| 0.1 * f32::from(k)) {
        let there = wave(160, high, 50.0);
        let mut back = there.clone();
        back.vertices.reverse();
        assert_eq!(may_be(&there), may_be(&back), "{high}");
    }
    assert!(!may_be(&wave(140, 0.3, 50.0)), "short");
    assert!(!may_be(&wave(160, 0.3, 20.0)), "weak");
    assert!(!may_be(&wave(160, 4.0, 50.0)), "ragged");
    let overview = Params { part: PagePart::Overview, ..Params::TEST };
    assert!(!Rank::may_be_curve(&wave(160, 0.3, 50.0), &overview), "an overview is made of shapes");
}
