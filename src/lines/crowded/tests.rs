//! Tests of `crowded`.

use super::*;
use crate::lines::tests::area;
use crate::units::MmPoint;

fn line(points: &[(f32, f32)]) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), ..Vertex::TEST };
    let mut line = Polyline::open(points.iter().map(vertex).collect());
    line.subdivide(0.4);
    line
}

#[test]
fn a_wall_is_missing_where_no_line_runs_along_it() {
    let wall = line(&[(10.0, 50.0), (60.0, 50.0)]);
    let missing = |drawn: &[(f32, f32)]| {
        let drawn = line(drawn);
        missing(&[&wall], std::iter::once(&drawn), area(), &Params::TEST)
    };
    assert!(missing(&[(10.0, 51.0), (60.0, 51.0)]) < 0.1, "moved a little");
    let torn = missing(&[(10.0, 50.0), (30.0, 50.0)]);
    assert!((28.0..30.0).contains(&torn), "{torn}");
    for other in [[(10.0, 52.4), (60.0, 52.4)], [(35.0, 20.0), (35.0, 80.0)]] {
        let all = missing(&other);
        assert!((all - 50.0).abs() < 0.1, "a bed beside it, or a line across: {all}");
    }
}

#[test]
fn the_middle_of_two_thin_strokes_is_no_wall() {
    let of = |stroke: f32, bar: f32| {
        let mut line = line(&[(10.0, 50.0), (60.0, 50.0)]);
        line.vertices.iter_mut().for_each(|vertex| (vertex.stroke, vertex.bar) = (stroke, bar));
        is_one_stroke(&line)
    };
    assert!(of(2.4, 0.0), "a stroke");
    assert!(of(0.0, 2.4), "the middle of a thin area");
    assert!(!of(0.6, 1.3), "of two strokes");
}
