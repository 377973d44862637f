//! Tests of `centreline`.

use super::testing::{area, bar, stroke};
use super::*;

#[test]
fn a_thin_bar_becomes_one_line_as_long_as_it_wherever_its_ring_begins() {
    let count = bar(3.0, 0).vertices.len();
    for start in 0..count {
        let merged = merge(vec![bar(3.0, start)], area(), &Params::TEST);
        let [line] = &merged[..] else { panic!("{} lines from vertex {start}", merged.len()) };
        assert!(!line.closed && (line.length() - 40.0).abs() < 0.5, "{} from vertex {start}", line.length());
        let off = line.vertices.iter().map(|vertex| (vertex.at.y - 21.5).abs()).fold(0.0, f32::max);
        assert!(off < 0.1, "{off} from vertex {start}");
        let breadth = line.breadth().expect("it is the middle of the bar");
        assert!((breadth - 3.0).abs() < 0.2 && line.stroke().is_none(), "{breadth} from vertex {start}");
    }
}

#[test]
fn a_wide_bar_keeps_both_sides() {
    let wide = vec![bar(5.0, 0)];
    assert_eq!(merge(wide.clone(), area(), &Params::TEST), wide);
}

#[test]
fn the_shorter_of_two_sides_goes_and_the_longer_one_runs_in_the_middle_beside_it() {
    let merged = merge(stroke(3.0), area(), &Params::TEST);
    let [line] = &merged[..] else { panic!("{} lines", merged.len()) };
    assert!((line.length() - 40.0).abs() < 1.5, "{}", line.length());
    let height_at = |x: f32| {
        let distance = |vertex: &&Vertex| (vertex.at.x - x).abs();
        line.vertices.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|vertex| vertex.at.y)
    };
    let [before, middle, after] = [11.0, 30.0, 49.0].map(|x| height_at(x).expect("it has vertices"));
    assert!((middle - 21.5).abs() < 0.01 && (before - 20.0).abs() < 0.01 && (after - 20.0).abs() < 0.01);
}
