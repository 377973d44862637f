//! Tests of `open_rings`.

use super::*;
use crate::lines::{Height, Run};

/// The dots of a narrow box, 20 mm by 6 mm, one after another.
fn around() -> Vec<MmPoint> {
    let corners = [(10.0, 10.0), (30.0, 10.0), (30.0, 16.0), (10.0, 16.0)].map(MmPoint::from);
    let side = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 4]);
        let steps = ((to - from).length() / 2.0).round() as u32;
        (0..steps).map(move |step| from.lerp(to, step as f32 / steps as f32))
    };
    (0..4).flat_map(side).collect()
}

fn line(runs: Vec<Run>) -> Line {
    Line { strength: 50.0, runs }
}

/// A row without its last dots.
fn row(mut points: Vec<MmPoint>, missing: usize) -> Line {
    points.truncate(points.len() - missing);
    line(vec![Run::dots(1.6, points, Height::High)])
}

#[test]
fn a_narrow_box_whose_row_has_a_gap_is_open() {
    let path = |closed: bool| {
        let mut path = around();
        path.extend(path.first().copied().filter(|_| closed));
        line(vec![Run::stroke(1.0, path)])
    };
    let gap = |of: Line, pressed: &[Line], stand_for: &[Option<usize>]| {
        gaps(&[of], pressed, stand_for, [2.0, 6.5])[0].map(|gap| gap.length.round())
    };
    let with = |missing: usize| gap(path(true), &[row(around(), missing)], &[Some(0)]);
    assert_eq!([with(0), with(1)], [None, None], "nobody feels that a dot is missing");
    assert_eq!(with(2), Some(6.0));
    assert_eq!(gap(path(false), &[row(around(), 2)], &[Some(0)]), None, "it is open in the drawing");
    assert_eq!(gap(path(true), &[], &[]), None, "it is gone");
    // the rest of it is another row, or another line lies there
    let (first, second) = (around()[..12].to_vec(), around()[12..].to_vec());
    assert_eq!(gap(path(true), &[row(first, 0), row(second.clone(), 0)], &[Some(0), Some(0)]), None);
    assert_eq!(gap(path(true), &[row(around(), 2), row(second, 0)], &[Some(0), None]), None);
}
