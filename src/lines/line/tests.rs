//! Tests of `line`.

use super::*;

#[test]
fn a_broad_stroke_counts_as_heavy_and_a_narrow_one_does_not() {
    let heavy = HeavyStrokes { from: 60.0, width: 1.5 };
    let strengths = |width: f32| vec![heavy.strength(width, 20.0), heavy.strength(width, 80.0)];
    assert_eq!(strengths(2.0), [60.0, 80.0]);
    assert_eq!(strengths(1.0), [20.0, LIGHT * 60.0]);
    // where black beside white is not heavy, no stroke is made so
    assert!(HeavyStrokes { from: 120.0, ..heavy }.strength(2.0, 20.0) < 20.1);
}

#[test]
fn the_path_of_a_line_runs_through_its_runs_and_not_through_its_second_row() {
    let points = |all: &[f32], y: f32| all.iter().map(|&x| MmPoint::new(x, y)).collect::<Vec<_>>();
    let strokes = vec![Run::stroke(1.0, points(&[0.0, 5.0], 0.0)), Run::stroke(2.0, points(&[5.0, 9.0], 0.0))];
    assert_eq!(Line { strength: 60.0, runs: strokes }.own_path(), points(&[0.0, 5.0, 5.0, 9.0], 0.0));
    let rows = [0.0, 2.0].map(|y| Run::dots(1.6, points(&[0.0, 2.0, 4.0], y), Height::High)).to_vec();
    assert_eq!(Line { strength: 60.0, runs: rows }.own_path(), points(&[0.0, 2.0, 4.0], 0.0));
}

#[test]
fn a_filled_point_is_broader_than_long_and_than_its_line() {
    let run =
        |width: f32, length: f32| Run::stroke(width, vec![MmPoint::new(10.0, 10.0), MmPoint::new(10.0 + length, 10.0)]);
    let beads = |runs: Vec<Run>| {
        let line = Line { strength: 60.0, runs };
        line.beads().map(|run| run.width).collect::<Vec<_>>()
    };
    assert_eq!(beads(vec![run(1.0, 20.0), run(4.0, 0.1), run(1.0, 20.0)]), [4.0]);
    assert_eq!(beads(vec![run(1.0, 20.0), run(1.5, 0.1)]), [0.0; 0], "hardly broader than its line");
    assert_eq!(beads(vec![run(1.0, 20.0), run(4.0, 10.0)]), [0.0; 0], "a broad piece of a line");
    assert_eq!(beads(vec![run(4.0, 0.1)]), [0.0; 0], "on no line");
}

#[test]
fn lines_are_found_by_their_places_with_their_widths() {
    let run = |width: f32, y: f32| Run::stroke(width, vec![MmPoint::new(0.0, y), MmPoint::new(20.0, y)]);
    let lines = [vec![run(1.0, 5.0), run(2.0, 10.0)], vec![run(3.0, 15.0)]].map(|runs| Line { strength: 60.0, runs });
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(20.0, 20.0));
    let index = index_of_lines(&lines, area, 2.0);
    let found = |y: f32| {
        let (_, _, segment) = index.nearest(MmPoint::new(10.0, y), 2.0, |_| true)?;
        Some((segment.line, segment.half_width))
    };
    assert_eq!([5.0, 10.5, 15.0].map(found), [Some((0, 0.5)), Some((1, 1.0)), Some((2, 1.5))]);
    assert_eq!(found(19.0), None);
}
