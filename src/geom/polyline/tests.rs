//! Tests of `polyline`.

use super::*;
use crate::units::MmPoint;

fn ring(count: usize, radius: f32) -> Polyline<MmPoint> {
    let angles = (0..count).map(|i| i as f32 * std::f32::consts::TAU / count as f32);
    let vertices = angles.map(|a| MmPoint::new(radius * a.cos(), radius * a.sin())).collect();
    Polyline { vertices, closed: true }
}

fn square() -> Polyline<MmPoint> {
    let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)];
    Polyline { vertices: corners.map(|(x, y)| MmPoint::new(x, y)).into(), closed: true }
}

#[test]
fn a_straight_line_stays_straight_and_keeps_its_ends() {
    let line = Polyline::open((0..20).map(|i| MmPoint::new(i as f32, 2.0 * i as f32)).collect());
    let smoothed = smooth(&line.arc_lengths(), false, 2.0, |i| [line.vertices[i].x, line.vertices[i].y]);
    for (p, s) in line.vertices.iter().zip(&smoothed) {
        assert!((p.x - s[0]).abs() < 1e-4 && (p.y - s[1]).abs() < 1e-4, "{p:?} moved to {s:?}");
    }
}

#[test]
fn a_smoothed_ring_has_no_seam() {
    let ring = ring(40, 10.0);
    let smoothed = smooth(&ring.arc_lengths(), true, 1.0, |i| [ring.vertices[i].x, ring.vertices[i].y]);
    let radii: Vec<f32> = smoothed.iter().map(|[x, y]| x.hypot(*y)).collect();
    let (least, most) = radii.iter().fold((f32::MAX, 0.0_f32), |(a, b), &r| (a.min(r), b.max(r)));
    assert_eq!(radii.len(), 40);
    assert!(most - least < 1e-3, "radii from {least} to {most}");
}

#[test]
fn a_ring_has_its_closing_segment_in_all_measures() {
    let square = square();
    assert_eq!(square.segment_count(), 4);
    assert!((square.distance(MmPoint::new(-2.0, 1.5)) - 2.0).abs() < 1e-6, "from the side that closes it");
    assert_eq!(square.arc_lengths(), [0.0, 3.0, 6.0, 9.0, 12.0]);
    assert!((square.length() - 12.0).abs() < 1e-6);
    let open = Polyline::open(square.vertices.clone());
    assert_eq!((open.segment_count(), open.arc_lengths().len()), (3, 4));
    let across = square.tangent(0);
    assert!((across.x - 0.5_f32.sqrt()).abs() < 1e-6 && (across.y + 0.5_f32.sqrt()).abs() < 1e-6);
    assert_eq!(open.tangent(0), Vector2D::new(1.0, 0.0));
    assert_eq!((square.view().next(3, 1), open.view().next(3, 1), open.view().next(0, -1)), (Some(0), None, None));
}

#[test]
fn a_path_back_to_its_start_is_a_ring() {
    let square = square();
    let path: Vec<MmPoint> = square.path().copied().collect();
    assert_eq!(path.len(), 5);
    assert_eq!(Polyline::from_path(path), square);
    let open = Polyline::from_path(square.vertices.clone());
    assert!(!open.closed && open.vertices.len() == 4);
    assert_eq!(Polyline::from_path(Vec::<MmPoint>::new()), Polyline::default());
}

#[test]
fn turned_round_a_ring_begins_where_it_did() {
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| square().vertices[i]);
    assert_eq!(square().reversed().vertices, [a, d, c, b]);
    assert_eq!(Polyline::open(vec![a, b, c, d]).reversed().vertices, [d, c, b, a]);
}

#[test]
fn a_ring_is_resampled_evenly_over_its_seam() {
    let even = ring(12, 10.0).resampled(1.0);
    assert!(even.closed && even.vertices.len() == 62, "{}", even.vertices.len());
    assert!(even.segments().all(|(a, b)| ((*b - *a).length() - 1.0).abs() < 0.1));
    let tiny = ring(7, 0.2).resampled(1.0);
    assert!(!tiny.closed && tiny.vertices.first() == tiny.vertices.last());
}

#[test]
fn long_segments_are_divided_that_of_the_seam_too() {
    let mut square = square();
    square.subdivide(1.0);
    assert_eq!((square.vertices.len(), square.closed), (12, true));
    let mut open = Polyline::open(vec![MmPoint::new(0.0, 0.0), MmPoint::new(2.5, 0.0)]);
    open.subdivide(1.0);
    assert_eq!(open.vertices.len(), 4);
    assert_eq!(open.vertices[3], MmPoint::new(2.5, 0.0));
}

#[test]
fn a_ring_is_opened_at_any_vertex() {
    let open = square().opened_at(2);
    assert_eq!(open.vertices.len(), 5);
    assert!(!open.closed && open.vertices[0] == square().vertices[2] && open.vertices[4] == open.vertices[0]);
}
