//! Tests of `lead_on`.

use super::*;
use crate::lines::clearance::tests::polyline;
use crate::lines::tests::area;
use crate::lines::vertex::FoundIn;

#[test]
fn a_ring_without_its_corner_is_closed_once() {
    let vertex = |at: MmPoint| Vertex { at, strength: 60.0, contrast: [60.0, 0.0, 0.0], width: 1.5, ..Vertex::TEST };
    let corners = [(10.0, 12.0), (10.0, 40.0), (40.0, 40.0), (40.0, 10.0), (12.0, 10.0)];
    let mut ring = Polyline::open(corners.map(|(x, y)| vertex(MmPoint::new(x, y))).to_vec());
    ring.subdivide(SPACING);
    let mut lines = [ring];
    extend(&mut lines, MmRect::new(MmPoint::zero(), MmPoint::new(50.0, 50.0)), 3.0);
    // both ends point at one another, and the segment between them is drawn once
    assert!(lines[0].closed);
    assert!((lines[0].length() - (4.0 * 30.0 - 2.0 * 2.0 + 8.0_f32.sqrt())).abs() < 0.1, "{}", lines[0].length());
}

#[test]
fn corners_of_rings_are_put_on_a_line_that_they_nearly_reach() {
    let level = polyline(&[(10.0, 50.0), (90.0, 50.0)], false);
    let put = |ring: Polyline<Vertex>| {
        let mut lines = [ring, level.clone()];
        put_corners(&mut lines, area(), &Params::TEST);
        assert_eq!(lines[1], level, "only corners are put elsewhere");
        let [ring, _] = lines;
        ring
    };
    let lowest = |ring: &Polyline<Vertex>| ring.vertices.iter().map(|vertex| vertex.at.y).fold(0.0, f32::max);
    // triangles that point at it and end so far before it, or beyond it
    let triangle = |before: f32| polyline(&[(40.0, 20.0), (60.0, 20.0), (50.1, 50.0 - before)], true);
    for before in [-0.4, -0.15, 0.15, 0.4] {
        let ring = put(triangle(before));
        assert!((lowest(&ring) - 50.0).abs() < 1e-3, "{before}: {}", lowest(&ring));
        assert!(ring.closed && (ring.length() - triangle(before).length()).abs() < 1.0);
    }
    assert_eq!([-0.8, 0.8].map(|before| put(triangle(before)) == triangle(before)), [true, true], "too far");
    let exact = |before: f32| {
        let mut ring = triangle(before);
        ring.vertices.iter_mut().for_each(|vertex| vertex.source = FoundIn::Vector);
        ring
    };
    assert_eq!(put(exact(0.15)), exact(0.15), "what a path has before a line is meant");
    assert!((lowest(&put(exact(-0.15))) - 50.0).abs() < 1e-3, "nobody feels a tip of 0.15 mm beyond it");
    let along = polyline(&[(40.0, 20.0), (60.0, 20.0), (60.0, 49.8), (40.0, 49.8)], true);
    assert_eq!(put(along.clone()), along, "it has a side along the line");
    // a tip with two corners, 1.1 mm from one another
    let ring = put(polyline(&[(40.0, 20.0), (60.0, 20.0), (50.55, 50.2), (49.45, 50.2)], true));
    let on_line: Vec<f32> = ring.vertices.iter().filter(|of| (of.at.y - 50.0).abs() < 1e-3).map(|of| of.at.x).collect();
    assert!([49.45_f32, 50.55].iter().all(|x| on_line.iter().any(|of| (of - x).abs() < 0.1)), "both: {on_line:?}");
}

/// The part of a bar below ends at the corner of the part above, whose side goes on in line with it but for rounding:
/// a ray along the one crosses the other farther up, and misses the corner.
#[test]
fn an_end_in_line_with_a_side_beyond_a_corner_is_led_on_to_the_corner() {
    let line = |places: &[(f32, f32)]| {
        let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), ..Vertex::TEST };
        Polyline::open(places.iter().map(vertex).collect())
    };
    for aside in [1e-5, 0.0, -1e-5] {
        let part = line(&[(30.0, 30.0), (10.0 + aside, 30.0), (10.0 - aside, 28.0), (10.0 - aside, 10.0)]);
        let mut lines = [part, line(&[(10.0, 36.0), (10.0, 33.0), (10.0, 30.25)])];
        extend(&mut lines, MmRect::new(MmPoint::zero(), MmPoint::new(50.0, 50.0)), 3.0);
        let end = lines[1].vertices[lines[1].vertices.len() - 1].at;
        assert!((end - MmPoint::new(10.0, 30.0)).length() < 1e-3, "{aside}: {end:?}");
    }
}
