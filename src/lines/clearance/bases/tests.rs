//! Tests of `bases`.

use super::super::tests::{clear_all, polyline};
use super::*;
use crate::lines::saliency::saliency;
use crate::lines::tests::area;

fn stroke(points: &[(f32, f32)], strength: f32) -> (Polyline<Vertex>, Rank) {
    let mut line = polyline(points, false);
    for vertex in &mut line.vertices {
        (vertex.source, vertex.contrast, vertex.strength) = (FoundIn::Stroke, [0.0; 3], strength);
    }
    (line, Rank::Ordinary)
}

fn own(lines: &[(Polyline<Vertex>, Rank)]) -> Vec<f32> {
    lines.iter().map(|(line, _)| saliency(line, &Params::TEST)).collect()
}

/// An axis and bars on it, 7 mm wide and 7 mm apart, that are stronger.
fn chart() -> Vec<(Polyline<Vertex>, Rank)> {
    let bar = |x: f32| stroke(&[(x, 70.0), (x, 20.0), (x + 7.0, 20.0), (x + 7.0, 70.0)], 90.0);
    let axis = stroke(&[(10.0, 10.0), (10.0, 70.02), (90.0, 70.02)], 30.0);
    [20.0, 34.0, 48.0, 62.0].map(bar).into_iter().chain([axis]).collect()
}

#[test]
fn an_axis_goes_before_stronger_bars_and_is_whole() {
    let own = own(&chart());
    let saliencies = raised(&own, &mut chart(), area(), &Params::TEST);
    assert!(saliencies[..4].iter().all(|bar| *bar < saliencies[4]), "{saliencies:?}");
    let cleared = clear_all(chart(), area(), &Params::TEST);
    let length: f32 = cleared.iter().map(|line| line.polyline.length()).sum();
    let all: f32 = chart().iter().map(|(line, _)| line.length()).sum();
    assert!((length - all).abs() < 1.0, "{length} of {all}");
}

#[test]
fn a_line_on_which_nothing_ends_keeps_its_saliency_and_a_circle_of_lines_comes_to_an_end() {
    let mut alone = [stroke(&[(10.0, 10.0), (90.0, 10.0)], 30.0), stroke(&[(10.0, 50.0), (90.0, 50.0)], 90.0)];
    let own_of_alone = own(&alone);
    assert_eq!(raised(&own_of_alone, &mut alone, area(), &Params::TEST), own_of_alone);
    // each ends in the middle of the next
    let mut circle = [
        stroke(&[(10.0, 30.0), (70.0, 30.0)], 30.0),
        stroke(&[(70.0, 10.0), (70.0, 70.0)], 40.0),
        stroke(&[(90.0, 70.0), (30.0, 70.0)], 50.0),
        stroke(&[(30.0, 90.0), (30.0, 30.0)], 60.0),
    ];
    let own = own(&circle);
    let most = own.iter().copied().fold(0.0, f32::max) * (1.0 + MORE).powi(HIGHEST_STACK as i32 + 1);
    let raised = raised(&own, &mut circle, area(), &Params::TEST);
    assert!(raised.iter().zip(&own).all(|(raised, own)| (*own..most).contains(raised)), "{own:?} {raised:?}");
    assert!(raised[0] > own[0], "something stands on it");
}

#[test]
fn an_axis_is_whole_where_a_curve_begins_close_beside_it() {
    let mut lines = vec![stroke(&[(20.0, 10.0), (20.0, 90.0)], 30.0)];
    lines.extend([20.0, 40.0, 60.0, 80.0].map(|y| stroke(&[(20.0, y), (32.0, y)], 30.0)));
    lines.push(stroke(&[(22.0, 52.0), (60.0, 30.0), (95.0, 70.0)], 90.0));
    let params = Params { of_drawing: true, ..Params::TEST };
    let is_axis = |line: &Polyline<Vertex>| line.vertices.iter().all(|vertex| (vertex.at.x - 20.0).abs() < 0.1);
    let cleared = clear_all(lines, area(), &params);
    let axis: f32 = cleared.iter().map(|line| &line.polyline).filter(|line| is_axis(line)).map(Polyline::length).sum();
    assert!((axis - 80.0).abs() < 0.5, "{axis}");
    assert!(cleared.iter().any(|line| line.polyline.length() > 60.0), "and most of the curve");
}

#[test]
fn two_axes_that_make_a_corner_are_whole_also_without_ticks() {
    let upright = stroke(&[(20.0, 10.0), (20.0, 70.0)], 30.0);
    let level = stroke(&[(20.0, 70.0), (90.0, 70.0)], 30.0);
    let trend = stroke(&[(22.0, 62.0), (90.0, 12.0)], 90.0);
    let params = Params { of_drawing: true, ..Params::TEST };
    let whole = |lines: Vec<(Polyline<Vertex>, Rank)>| {
        let is_axis = |line: &Polyline<Vertex>| line.vertices.iter().all(|vertex| (vertex.at.x - 20.0).abs() < 0.1);
        let cleared = clear_all(lines, area(), &params);
        cleared.iter().map(|line| &line.polyline).filter(|line| is_axis(line)).map(Polyline::length).sum::<f32>()
    };
    let axis = whole(vec![upright.clone(), level, trend.clone()]);
    assert!((axis - 60.0).abs() < 0.5, "{axis}");
    // by itself it may be any line
    assert!(whole(vec![upright, trend]) < 59.0);
}
