//! Centre lines whose ends are trimmed.

use super::super::merge;
use super::super::testing::{area, bar, side};
use super::*;
use crate::geom::nearest_on_segment;
use crate::lines::params::Params;

/// What is left of a line without its vertices in a range of x.
fn without(polyline: &Polyline<Vertex>, range: std::ops::Range<f32>) -> Vec<Polyline<Vertex>> {
    let removed = polyline.vertices.iter().map(|vertex| range.contains(&vertex.at.x)).collect();
    let assignment = Assignment { offsets: vec![None; polyline.vertices.len()], removed };
    let mut out = Vec::new();
    trim(polyline, &assignment, 4.7, &mut out);
    out
}

#[test]
fn an_open_line_is_left_on_both_sides_of_a_cut_and_a_ring_is_opened_by_it() {
    let line = side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0);
    let lengths: Vec<f32> = without(&line, 19.9..30.1).iter().map(Polyline::length).collect();
    assert!(matches!(lengths[..], [a, b] if (a - 9.6).abs() < 0.1 && (b - 19.6).abs() < 0.1), "{lengths:?}");
    let ring = bar(20.0, 0);
    for start in 0..ring.vertices.len() {
        let left = without(&bar(20.0, start), 0.0..10.1);
        assert!(matches!(&left[..], [one] if !one.closed && (one.length() - 99.2).abs() < 0.1), "from {start}");
    }
    assert_eq!(without(&ring, 60.0..70.0), [ring]);
}

#[test]
fn the_centreline_of_a_frame_has_the_corners_of_its_middle_wherever_the_ring_begins() {
    let (outer, width) = ([10.0, 10.0, 60.0, 40.0], 3.0);
    let frame = |inset: f32, step: f32| {
        let [left, top, right, bottom] = [outer[0] + inset, outer[1] + inset, outer[2] - inset, outer[3] - inset];
        side(&[(left, top), (right, top), (right, bottom), (left, bottom)], true, step)
    };
    let count = frame(0.0, 60.0).vertices.len();
    for start in (0..count).step_by(7) {
        let mut sides = vec![frame(0.0, 60.0), frame(width, -60.0)];
        sides[0].vertices.rotate_left(start);
        let merged = merge(sides, area(), &Params::TEST);
        let [ring] = &merged[..] else { panic!("{} lines", merged.len()) };
        assert!(ring.closed);
        let middle = frame(0.5 * width, 60.0);
        for corner in [(11.5, 11.5), (58.5, 11.5), (58.5, 38.5), (11.5, 38.5)] {
            let corner = MmPoint::new(corner.0, corner.1);
            let away = ring.vertices.iter().map(|vertex| (vertex.at - corner).length()).fold(f32::MAX, f32::min);
            assert!(away < 0.3, "{away} mm from {corner:?}, from vertex {start}");
        }
        let off =
            |at: MmPoint| middle.segments().map(|(a, b)| nearest_on_segment(at, a.at, b.at).0).fold(f32::MAX, f32::min);
        let most = ring.vertices.iter().map(|vertex| off(vertex.at)).fold(0.0, f32::max);
        assert!(most < 0.1, "{most} mm off, from vertex {start}");
        assert!((ring.length() - middle.length()).abs() < 0.5, "no loop: {}", ring.length());
    }
}

#[test]
fn a_centreline_goes_over_to_the_middle_and_on_to_the_blunt_end() {
    let ring = bar(3.0, 0);
    let is_inner = |vertex: &Vertex| (12.0..=48.0).contains(&vertex.at.x);
    let upper = |vertex: &Vertex| vertex.at.y < 20.1;
    let offset = |vertex: &Vertex| (is_inner(vertex) && upper(vertex)).then_some(MmVector::new(0.0, 1.5));
    let assignment = Assignment {
        offsets: ring.vertices.iter().map(offset).collect(),
        removed: ring.vertices.iter().map(|vertex| is_inner(vertex) && !upper(vertex)).collect(),
    };
    let mut out = Vec::new();
    trim(&ring, &assignment, 4.7, &mut out);
    let [line] = &out[..] else { panic!("{} lines", out.len()) };
    let ends = [line.vertices.first(), line.vertices.last()].map(|end| end.expect("it has vertices").at);
    assert!((ends[0] - MmPoint::new(10.0, 21.5)).length() < 0.1, "{ends:?}");
    assert!((ends[1] - MmPoint::new(50.0, 21.5)).length() < 0.1, "{ends:?}");
    assert!(line.vertices.iter().all(|vertex| (vertex.at.y - 21.5).abs() < 0.01), "no hook at its ends");
}
#[test]
fn a_corner_without_length_is_none() {
    let normals = [(0.0, 1.0), (0.7, 0.7), (1.0, 0.0)].map(MmVector::from);
    for arcs in [[0.0; 3], [0.0, 1e-38, 2e-38]] {
        let mut distances = [Some(1.0), None, Some(1.0)];
        let gaps = fill_corners(&mut distances, &normals, &arcs, false);
        assert!(gaps.iter().all(|gap| gap.beside <= 3), "{arcs:?}");
        assert!(distances.iter().flatten().all(|distance| distance.is_finite()), "{distances:?}");
    }
}
