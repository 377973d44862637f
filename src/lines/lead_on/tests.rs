//! Tests of `lead_on`.

use super::*;

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
