//! Tests of `walls`.

use super::super::tests::{clear_all, polyline};
use super::*;
use crate::lines::line::HeavyStrokes;
use crate::lines::params::LineMedium;
use crate::lines::tests::area;
use crate::lines::vertex::FoundIn;

const DOTS: LineMedium = LineMedium::Dots(HeavyStrokes { from: 100.0, width: 2.5 });
const PARAMS: Params = Params { of_drawing: true, medium: DOTS, ..Params::TEST };

/// A stroke of this breadth, mm.
fn stroke(points: &[(f32, f32)], closed: bool, breadth: f32) -> (Polyline<Vertex>, Rank) {
    let mut line = polyline(points, closed);
    for vertex in &mut line.vertices {
        (vertex.contrast, vertex.stroke) = ([0.0; 3], breadth);
        vertex.source = FoundIn::Vector;
    }
    (line, Rank::Ordinary)
}

/// A house of one wall inside, 35 mm long, with a bed below that and 2 mm from it; the bed is drawn with thin lines.
fn plan(of_walls: f32) -> Vec<(Polyline<Vertex>, Rank)> {
    let around = stroke(&[(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)], true, of_walls);
    let inside = stroke(&[(10.0, 50.0), (45.0, 50.0)], false, of_walls);
    let bed = stroke(&[(18.0, 52.0), (44.0, 52.0), (44.0, 80.0), (18.0, 80.0)], true, 0.4);
    vec![around, inside, bed]
}

#[test]
fn a_bed_takes_no_piece_of_a_wall() {
    let inside = |of_walls: f32| -> f32 {
        let is_level = |line: &Polyline<Vertex>| line.vertices.iter().all(|vertex| (vertex.at.y - 50.0).abs() < 0.1);
        let cleared = clear_all(plan(of_walls), area(), &PARAMS);
        cleared.iter().map(|line| &line.polyline).filter(|line| is_level(line)).map(Polyline::length).sum()
    };
    let whole = inside(2.0);
    assert!((whole - 35.0).abs() < 0.5, "{whole}");
    // one that is as thin as the bed is a line as that
    assert!(inside(0.4) < 30.0);
}

#[test]
fn a_wall_that_is_a_thin_area_is_a_wall_too() {
    let mut plan = plan(0.0);
    for (line, _) in &mut plan[..2] {
        line.vertices.iter_mut().for_each(|vertex| vertex.bar = 2.4);
    }
    assert_eq!(walls(&plan, &PARAMS), [0, 1]);
}

#[test]
fn walls_are_much_broader_than_what_is_slanted_and_lie_both_ways() {
    assert_eq!(walls(&plan(2.0), &PARAMS), [0, 1]);
    let mut with_ramp = plan(2.0);
    with_ramp.push(stroke(&[(55.0, 20.0), (80.0, 45.0)], false, 1.2));
    assert!(walls(&with_ramp, &PARAMS).is_empty(), "a drawing of broad strokes");
    assert!(walls(&plan(2.0)[..2], &PARAMS).is_empty(), "nothing is thinner");
    assert!(walls(&plan(8.0), &PARAMS).is_empty(), "the outline of bars that touch");
    // bars of a chart, drawn as their middles
    let bars: Vec<_> = [20.0, 40.0, 60.0].map(|x| stroke(&[(x, 20.0), (x, 90.0)], false, 2.0)).to_vec();
    let axis = stroke(&[(10.0, 90.0), (90.0, 90.0)], false, 0.5);
    assert!(walls(&bars.into_iter().chain([axis]).collect::<Vec<_>>(), &PARAMS).is_empty());
    assert!(walls(&plan(2.0), &Params { medium: LineMedium::Print, ..PARAMS }).is_empty(), "on paper");
    let found_in = |source: FoundIn| {
        let mut lines = plan(2.0);
        lines.iter_mut().flat_map(|(line, _)| &mut line.vertices).for_each(|vertex| vertex.source = source);
        walls(&lines, &PARAMS)
    };
    assert_eq!(found_in(FoundIn::Stroke), walls(&plan(2.0), &PARAMS), "strokes of a bitmap");
    assert!(found_in(FoundIn::Pixels).is_empty(), "edges in a bitmap");
    // one of 11 mm beside a door
    let with_stub = |source: FoundIn| {
        let mut lines = plan(2.0);
        lines.push(stroke(&[(70.0, 20.0), (70.0, 31.0)], false, 2.0));
        lines.iter_mut().flat_map(|(line, _)| &mut line.vertices).for_each(|vertex| vertex.source = source);
        walls(&lines, &PARAMS)
    };
    assert_eq!([with_stub(FoundIn::Vector).len(), with_stub(FoundIn::Stroke).len()], [3, 2]);
    // faint lines are none of them
    let faint = plan(2.0).into_iter().map(|(line, _)| (line, Rank::Faint)).collect::<Vec<_>>();
    assert!(walls(&faint, &PARAMS).is_empty());
}
