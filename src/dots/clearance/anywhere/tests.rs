//! Tests of `anywhere`.

use super::*;
use crate::lines::Run;

const PART: MmRect = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(100.0, 100.0));

fn line(strength: f32, points: &[(f32, f32)]) -> Line {
    let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    Line { strength, runs: vec![Run::stroke(1.0, points)] }
}

fn params() -> Params {
    Params { pitch: 2.5, line_gap: 1, min_length: 5.0, ..Params::TEST }
}

/// Lines without marks.
fn anywhere(lines: &[Line], part: MmRect, params: &Params) -> Vec<Line> {
    super::anywhere(lines, &LineMarks::default(), part, params).0
}

fn dots(lines: &[Line]) -> Vec<Vec<usize>> {
    lines.iter().map(|line| line.runs.iter().map(|run| run.points.len()).collect()).collect()
}

#[test]
fn a_crossing_line_leaves_out_what_falls_on_the_dots_of_the_stronger() {
    let across = line(20.0, &[(10.0, 50.0), (60.0, 50.0)]);
    let upright = line(10.0, &[(35.0, 25.0), (35.0, 75.0)]);
    let drawn = anywhere(&[across, upright], PART, &params());
    assert_eq!(dots(&drawn), [[21], [20]]);
    let all: Vec<MmPoint> = drawn.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.clone()).collect();
    for (i, a) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|b| (*a - *b).length() >= LEAST_STEP * 2.5 - 1e-3), "{a:?}");
    }
}

/// A dot 1.7 mm behind a corner is too near to the one before it; without it there would be 3.9 mm without a dot.
#[test]
fn a_corner_does_not_break_a_line() {
    let bent = line(20.0, &[(12.0, 50.0), (53.0, 50.0), (53.0, 91.0)]);
    let drawn = anywhere(&[bent], PART, &params());
    let row = &drawn[0].runs[0].points;
    let steps: Vec<f32> = row.windows(2).map(|pair| (pair[1] - pair[0]).length()).collect();
    let (least, most) = steps.iter().fold((f32::MAX, 0.0_f32), |(a, b), &step| (a.min(step), b.max(step)));
    assert!(least >= LEAST_STEP * 2.5 - 1e-3 && most < 1.5 * 2.5, "{least} to {most} mm: {row:?}");
    let at_corner = row.iter().any(|at| at.y > 50.1 && at.x < 52.9);
    assert!(at_corner, "the case is not the one of the test: {row:?}");
}

#[test]
fn dots_outside_the_part_and_short_lines_are_left_out() {
    let leaving = line(20.0, &[(80.0, 50.0), (130.0, 50.0)]);
    let short = line(10.0, &[(10.0, 10.0), (12.0, 10.0)]);
    assert_eq!(dots(&anywhere(&[leaving, short], PART, &params())), [[9]]);
}

#[test]
fn a_second_row_keeps_the_gap_from_other_lines() {
    let heavy = line(60.0, &[(10.0, 50.0), (60.0, 50.0)]);
    assert_eq!(dots(&anywhere(std::slice::from_ref(&heavy), PART, &params())), [[21, 21]]);
    // 6 mm below it the second row would come within 3.5 mm of the other line, and 5 mm must lie between
    let light = line(10.0, &[(10.0, 56.0), (60.0, 56.0)]);
    assert_eq!(dots(&anywhere(&[heavy.clone(), light], PART, &params())), [vec![21], vec![21]]);
    let high = Params { has_heights: true, ..params() };
    assert_eq!(dots(&anywhere(&[heavy], PART, &high)), [[21]], "a device with heights has single rows");
}

#[test]
fn a_row_that_others_leave_too_short_for_a_line_goes_unless_it_leads_from_line_to_line() {
    let params = Params { min_length: 12.5, ..params() };
    // two sides nearer to one another than dots may be
    let thin = line(20.0, &[(10.0, 50.0), (20.0, 50.8), (10.0, 51.6), (10.0, 50.0)]);
    assert!(anywhere(&[thin], PART, &params).is_empty());
    let bases = [10.0, 20.0].map(|x| line(30.0, &[(x, 20.0), (x, 80.0)]));
    let link = line(20.0, &[(10.0, 50.0), (20.0, 50.0)]);
    let [left, right] = bases;
    assert_eq!(anywhere(&[left.clone(), right, link.clone()], PART, &params).len(), 3);
    assert_eq!(anywhere(&[left, link], PART, &params).len(), 1, "it leads to nothing");
}
