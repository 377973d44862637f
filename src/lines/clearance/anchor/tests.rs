//! Tests of `anchor`.

use super::super::tests::{drawn, polyline};
use super::*;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::units::MmRect;

const DRAWING: Params = Params { of_drawing: true, ..Params::TEST };

fn cleared(points: &[(f32, f32)], closed: bool) -> Cleared {
    let polyline = polyline(points, closed);
    Cleared { saliency: 0.0, rank: Rank::Ordinary, anchored: vec![false; polyline.vertices.len()], polyline }
}

#[test]
fn a_line_has_an_anchor_where_another_ends_on_it() {
    let (bar, stem) = ([(10.0, 50.0), (90.0, 50.0)], [(50.07, 80.0), (50.07, 50.0)]);
    let mut lines = [cleared(&bar, false), cleared(&stem, false)];
    anchor(&mut lines, &drawn(&[&bar, &stem]));
    let anchors = |line: &Cleared| line.anchored.iter().filter(|anchored| **anchored).count();
    assert_eq!((anchors(&lines[0]), anchors(&lines[1])), (1, 0));
    let index = lines[0].anchored.iter().position(|anchored| *anchored).expect("an anchor");
    assert_eq!(Some(lines[0].polyline.vertices[index].at), lines[1].polyline.vertices.last().map(|v| v.at));
}

#[test]
fn a_line_has_an_anchor_where_a_corner_of_a_ring_lies_on_it() {
    let (bar, ring) = ([(10.0, 50.0), (90.0, 50.0)], [(50.0, 50.06), (60.0, 80.0), (40.0, 80.0)]);
    let mut lines = [cleared(&bar, false), cleared(&ring, true)];
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let mut drawn = DrawnLines::new(area, &DRAWING);
    lines.iter().for_each(|line| {
        drawn.begin(&line.polyline);
    });
    anchor(&mut lines, &drawn);
    let is_corner = |vertex: &Vertex| lines[1].polyline.vertices.iter().any(|corner| corner.at == vertex.at);
    assert!(lines[0].polyline.vertices.iter().any(is_corner), "{:?}", lines[0].polyline);
}

#[test]
fn a_line_needs_no_anchor_beside_its_end_where_another_ends_too() {
    let (bar, mut next) = ([(10.0, 50.0), (50.0, 50.0)], polyline(&[(50.0, 50.0), (90.0, 50.0)], false));
    // a vertex nearer to the end than the two lines have to be
    next.vertices.insert(1, Vertex { at: MmPoint::new(50.03, 50.02), ..next.vertices[0] });
    let next =
        Cleared { saliency: 0.0, rank: Rank::Ordinary, anchored: vec![false; next.vertices.len()], polyline: next };
    let mut lines = [cleared(&bar, false), next];
    let before: Vec<MmPoint> = lines[1].polyline.vertices.iter().map(|vertex| vertex.at).collect();
    anchor(&mut lines, &drawn(&[&bar, &[(50.0, 50.0), (50.03, 50.02), (90.0, 50.0)]]));
    let after: Vec<MmPoint> = lines[1].polyline.vertices.iter().map(|vertex| vertex.at).collect();
    assert_eq!(after, before);
}
