//! Tests of `vertex`.

use super::*;

fn line(points: &[(f32, f32)], closed: bool) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), strength: 30.0, ..Vertex::TEST };
    let mut line = Polyline { vertices: points.iter().map(vertex).collect::<Vec<_>>(), closed };
    line.subdivide(0.25);
    line
}

fn gap(line: &Polyline<Vertex>, (x, y): (f32, f32)) -> f32 {
    line.vertices.iter().map(|v| (v.at - MmPoint::new(x, y)).length()).fold(f32::INFINITY, f32::min)
}

#[test]
fn corners_stay_where_they_are() {
    let corners = [(10.0, 10.0), (30.0, 10.0), (30.0, 25.0), (12.0, 30.0)];
    for closed in [false, true] {
        let smooth = line(&corners, closed).smoothed_between_corners(0.6);
        assert_eq!(smooth.closed, closed);
        assert!(corners.iter().all(|&corner| gap(&smooth, corner) < 1e-4), "{smooth:?}");
        assert!(smooth.segments().all(|(a, b)| (b.at - a.at).length() > 0.2), "no vertex twice");
    }
    assert!(gap(&line(&corners, true).smoothed(0.6), corners[0]) > 0.1);
}

#[test]
fn a_circle_has_no_corners() {
    let on = |k: u32| (k as f32 / 60.0 * std::f32::consts::TAU).sin_cos();
    let circle: Vec<(f32, f32)> = (0..60).map(on).map(|(y, x)| (20.0 + 5.0 * x, 20.0 + 5.0 * y)).collect();
    let circle = line(&circle, true);
    assert!(circle.view().corners().is_empty());
    assert_eq!(circle.clone().smoothed_between_corners(0.6), circle.smoothed(0.6).evened());
}

#[test]
fn an_open_line_is_shortened_at_either_end() {
    let bent = line(&[(10.0, 10.0), (20.0, 10.0), (20.0, 15.0)], false);
    let first = bent.shortened(Tip::First, 4.0);
    assert!((first.length() - 11.0).abs() < 1e-3 && (first.vertices[0].at.x - 14.0).abs() < 1e-3, "{first:?}");
    let last = bent.shortened(Tip::Last, 6.0);
    let tip = Tip::Last.of(&last).expect("it has vertices").at;
    assert!((last.length() - 9.0).abs() < 1e-3 && (tip - MmPoint::new(19.0, 10.0)).length() < 1e-3, "{tip:?}");
    let lengths: Vec<f32> = bent.shorter_ones(Tip::Last, 0.6).map(|line| line.length()).collect();
    assert!(lengths.len() == 3 && (lengths[0] - 15.0).abs() < 1e-3 && (lengths[2] - 14.5).abs() < 1e-3, "{lengths:?}");
}
