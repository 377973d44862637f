//! Tests of `twins`.

use super::*;
use crate::page::Height;

fn line(y: f32) -> Line {
    let points = vec![MmPoint::new(10.0, y), MmPoint::new(50.0, y), MmPoint::new(90.0, y)];
    Line { strength: 1.0, runs: vec![Run::stroke(1.0, points)] }
}

#[test]
fn of_equal_lines_the_first_stays_and_is_told_once() {
    let mut lines = vec![line(10.0), line(20.0), line(10.0), line(30.0), line(10.0), line(20.0)];
    let mut names: Vec<String> = (1..=6).map(|number| format!("line {number}")).collect();
    let mut found = Vec::new();
    assert!(has_twins(&lines));
    one_of_each(&mut lines, &mut names, &mut found);
    assert_eq!(lines, [line(10.0), line(20.0), line(30.0)]);
    assert_eq!(names, ["line 1", "line 2", "line 4"]);
    let told: Vec<&str> = found.iter().map(|found| found.what.as_str()).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[0].contains("line 1: 2 other lines lie on it") && told[1].contains("line 2: another line"));
    assert!(!has_twins(&lines));
}

#[test]
fn lines_that_differ_in_a_number_stay() {
    let mut wider = line(10.0);
    wider.runs[0].width = 1.2;
    let dots = |height| {
        let points = line(10.0).runs[0].points.clone();
        Line { strength: 1.0, runs: vec![Run::dots(1.0, points, height)] }
    };
    let [low, high] = [Height::Low, Height::High].map(dots);
    assert!(!has_twins(&[line(10.0), wider, line(10.01), low, high]));
}

#[test]
fn a_line_drawn_from_its_other_end_is_the_same() {
    let mut backwards = line(10.0);
    backwards.runs[0].points.reverse();
    assert!(has_twins(&[line(10.0), backwards]));
}
