//! Tests of `saliency`.

use super::*;
use crate::units::MmPoint;

fn line(closed: bool, at: impl Fn(f32) -> (f32, f32)) -> Polyline<Vertex> {
    let vertex = |i: u32| {
        let (x, y) = at(i as f32 * 0.4);
        Vertex { at: MmPoint::new(x, y), strength: 30.0, contrast: [30.0, 0.0, 0.0], width: 1.0, ..Vertex::TEST }
    };
    Polyline { vertices: (0..100).map(vertex).collect(), closed }
}

fn params(detail: f32) -> Params {
    Params { detail, ..Params::TEST }
}

#[test]
fn a_ring_is_more_salient_than_a_straight_line_and_that_more_than_a_wavering_one() {
    let radius = 40.0 / std::f32::consts::TAU;
    let ring = line(true, |s| (radius * (s / radius).cos(), radius * (s / radius).sin()));
    let [ring, straight, wavering] = [ring, line(false, |s| (s, 0.0)), line(false, |s| (s, 2.0 * (0.785 * s).sin()))]
        .map(|line| saliency(&line, &params(0.5)) / line.length());
    assert!((straight - 1.0).abs() < 1e-3 && (ring - CLOSED).abs() < 0.05 && wavering < 0.7, "{ring} {wavering}");
}

#[test]
fn more_detail_asks_for_less() {
    let asked: Vec<f32> = (0..=10).map(|i| least(200.0, &params(i as f32 / 10.0))).collect();
    assert!(asked.is_sorted_by(|a, b| a >= b), "{asked:?}");
    assert!((asked[0] - 50.0).abs() < 1e-3 && (asked[5] - 8.0).abs() < 1e-3 && asked[10] < 1e-6, "{asked:?}");
}
