//! Tests of `cut_contours`.

use super::*;
use std::f32::consts::TAU;

/// An index of one open line through these points.
fn line(points: &[[f32; 2]]) -> Nearby<Px> {
    let mut near = empty_index(Size::new(200, 200));
    let points: Vec<PxPoint> = points.iter().map(|&[x, y]| PxPoint::new(x, y)).collect();
    near.insert_line(0, PolylineRef { vertices: &points, closed: false }, 0.0);
    near
}

#[test]
fn a_line_that_ends_before_a_ring_or_crosses_it_does_not_open_it() {
    let edgel = |k: u16| {
        let (sin, cos) = (f32::from(k) * TAU / 360.0).sin_cos();
        Edgel { at: PxPoint::new(100.0 + 60.0 * cos, 100.0 + 60.0 * sin), strength: 40.0, contrast: [0.0; 3] }
    };
    let ring: Vec<Edgel> = (0..360).map(edgel).collect();
    let parts = |near: &Nearby<Px>| parts_apart(&ring, true, near, 8.0);
    let whole = vec![(ring.clone(), true)];
    assert_eq!(parts(&line(&[[0.0, 100.0], [36.0, 100.0]])), whole, "it ends 4 px before the ring");
    assert_eq!(parts(&line(&[[0.0, 100.0], [40.0, 100.0]])), whole, "it ends on the ring");
    assert_eq!(parts(&line(&[[0.0, 90.0], [200.0, 110.0]])), whole, "it crosses the ring");
    // a tangent, 2 px off
    let beside = parts(&line(&[[60.0, 38.0], [140.0, 38.0]]));
    assert!(matches!(&beside[..], [(part, false)] if part.len() > 240 && part.len() < 330), "{}", beside.len());
    // one that lies on a quarter of it, as what a person draws in its place
    let quarter: Vec<[f32; 2]> = (0..90).map(|k| edgel(k).at.to_array()).collect();
    let replaced = parts(&line(&quarter));
    assert!(matches!(&replaced[..], [(part, false)] if part.len() < 270), "{}", replaced.len());
}
