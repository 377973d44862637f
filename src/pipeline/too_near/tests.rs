//! Tests of `too_near`.

use super::*;
use crate::profile::{Plan, Profile};

fn area() -> MmRect {
    MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 100.0))
}

fn stroke(points: &[(f32, f32)]) -> Line {
    let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    Line { strength: 100.0, runs: vec![Run::stroke(1.5, points)] }
}

/// What is left of lines on swell paper.
fn left(lines: Vec<Line>, whole_rings: bool) -> Lines {
    let plan = Plan::new(&Profile::named("swell-a4").expect("built in")).expect("it makes sense");
    let mut drawn = Lines { lines, ..Lines::default() };
    let print = Medium::Print(crate::page::Print::default());
    cut(&mut drawn, &Rules::among(area(), whole_rings, &print, &plan));
    assert!(near_lines(&drawn.lines, &print, &plan.limits()).0.is_empty(), "{:?}", drawn.lines);
    drawn
}

#[test]
fn lines_that_are_apart_stay_as_they_are() {
    let lines = vec![stroke(&[(0.0, 10.0), (100.0, 10.0)]), stroke(&[(0.0, 20.0), (100.0, 20.0)])];
    let drawn = left(lines.clone(), false);
    assert_eq!((drawn.lines, drawn.lost.lost), (lines, 0.0));
}

#[test]
fn of_two_that_cross_at_a_flat_angle_the_shorter_ends_before_the_other() {
    let long = stroke(&[(0.0, 50.0), (150.0, 50.0)]);
    let drawn = left(vec![long.clone(), stroke(&[(20.0, 42.0), (130.0, 58.0)])], false);
    assert_eq!(drawn.lines[0], long);
    let lengths: Vec<f32> = drawn.lines[1..].iter().map(Line::length).collect();
    assert!(lengths.len() == 2 && lengths.iter().all(|length| (15.0..40.0).contains(length)), "{lengths:?}");
    let lost = drawn.lost.lost;
    assert!((lost + lengths.iter().sum::<f32>() - 110.0_f32.hypot(16.0)).abs() < 0.1, "{lost} mm are told");
    assert!((drawn.lost.by_place.iter().sum::<f32>() - lost).abs() < 0.01);
}

/// As a piece that had no room from the first is; of a gridline nothing is told.
#[test]
fn a_piece_that_is_cut_out_of_an_open_line_is_told() {
    let torn = |strength: f32| {
        let short = Line { strength, ..stroke(&[(20.0, 42.0), (130.0, 58.0)]) };
        let drawn = left(vec![stroke(&[(0.0, 50.0), (150.0, 50.0)]), short], false);
        assert_eq!(drawn.lines.len(), 3);
        drawn.lost.torn
    };
    let told = torn(100.0);
    assert_eq!(told.len(), 1);
    let (at, length) = (told[0].extent.center(), told[0].length);
    assert!((at - MmPoint::new(75.0, 50.0)).length() < 2.0 && (TORN..60.0).contains(&length), "{length} mm at {at:?}");
    assert_eq!(torn(1.0), []);
}

#[test]
fn what_is_too_short_after_a_cut_is_left_out_and_told() {
    let drawn = left(vec![stroke(&[(0.0, 50.0), (150.0, 50.0)]), stroke(&[(40.0, 52.0), (60.0, 53.0)])], false);
    assert_eq!((drawn.lines.len(), drawn.lost.gone.len()), (1, 1));
}

#[test]
fn a_ring_is_cut_once_and_counts_as_lost_in_an_overview() {
    let ring = stroke(&[(20.0, 20.0), (60.0, 20.0), (60.0, 60.0), (20.0, 60.0), (20.0, 20.0)]);
    let lines = vec![stroke(&[(10.0, 62.0), (75.0, 62.0), (75.0, 10.0), (10.0, 10.0), (10.0, 62.0)]), ring];
    let drawn = left(lines.clone(), false);
    assert_eq!(drawn.lines.len(), 2, "the piece that is left goes on over its first point");
    assert!(drawn.lines.iter().all(|line| line.length() > 100.0), "{:?}", drawn.lines);
    assert_eq!((drawn.lost.rings, drawn.lost.gaps.len()), (0, 1));
    let drawn = left(lines, true);
    assert_eq!((drawn.lines.len(), drawn.lost.rings), (2, 1));
}

#[test]
fn a_neighbour_that_is_as_near_as_it_may_be_keeps_its_length() {
    // too near at the left end only, where the first line bends down to it
    let first = stroke(&[(0.0, 42.0), (20.0, 50.0), (150.0, 50.0)]);
    let mut bead = first.clone();
    let points = [(150.0, 50.0), (150.1, 50.0)].map(|(x, y)| MmPoint::new(x, y));
    bead.runs.push(Run::stroke(4.5, points.to_vec()));
    let neighbour = stroke(&[(2.0, 45.0), (8.0, 45.2), (140.0, 45.2)]);
    for first in [first, bead] {
        let drawn = left(vec![first, neighbour.clone()], false);
        let length: f32 = drawn.lines.iter().map(Line::length).sum();
        assert!(length > 260.0, "{length} of 290 mm: {:?}", drawn.lines);
    }
}

#[test]
fn of_a_line_that_comes_back_too_near_to_itself_one_side_is_cut() {
    let drawn = left(vec![stroke(&[(10.0, 10.0), (90.0, 60.0), (92.0, 57.0), (20.0, 12.0)])], false);
    let length: f32 = drawn.lines.iter().map(Line::length).sum();
    assert!(length > 90.0, "{length} mm are left: {:?}", drawn.lines);
}
