//! Tests of `shapes`.

use super::*;
use crate::page::Run;
use std::f32::consts::PI;

fn line(points: Vec<MmPoint>) -> Line {
    Line { strength: 20.0, runs: vec![Run::stroke(1.0, points)] }
}

fn circle(x: f32, y: f32, radius: f32) -> Line {
    let at = |k: usize| {
        let (sin, cos) = (k as f32 * PI / 20.0).sin_cos();
        MmPoint::new(x + radius * cos, y + radius * sin)
    };
    let first = at(0);
    line((0..40).map(at).chain([first]).collect())
}

#[test]
fn lines_have_their_form_place_and_size() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let level = line(vec![MmPoint::new(10.0, 130.0), MmPoint::new(140.0, 131.0)]);
    let bent = line(vec![MmPoint::new(10.0, 10.0), MmPoint::new(20.0, 10.0), MmPoint::new(20.0, 30.0)]);
    let told = told(&[bent, circle(75.0, 25.0, 6.0), level, circle(75.0, 30.0, 30.0)], figure, 9, Wording::english());
    assert_eq!(
        told,
        [
            "A closed round outline in the upper middle, 60 mm across; it contains a smaller one.",
            "A straight level line in the lower middle, 130 mm long, across most of the figure.",
            "A closed round outline in the upper middle, 12 mm across.",
            "A bent line in the upper left, 30 mm long.",
        ]
    );
}

#[test]
fn an_arrow_is_told_with_its_way_and_its_head_is_no_line() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let at = MmPoint::new;
    let shaft = line(vec![at(60.0, 60.0), at(60.0, 10.0)]);
    let head = |y: f32, back: f32| line(vec![at(56.0, y + back), at(60.0, y), at(64.0, y + back)]);
    let told = |lines: &[Line]| (told(lines, figure, 9, Wording::english()).concat(), count(lines));
    let one = told(&[head(10.0, 5.7), shaft.clone()]);
    assert_eq!(one, ("An arrow in the upper middle, 50 mm long, whose head points up.".to_owned(), 1));
    let both = told(&[shaft.clone(), head(10.0, 5.7), head(60.0, -5.7)]);
    assert_eq!(both, ("A line in the upper middle, 50 mm long, with an arrowhead at each end.".to_owned(), 1));
    assert_eq!(told(&[shaft.clone(), head(10.0, -5.7)]).1, 2, "it points back");
    assert_eq!(told(&[shaft, head(7.0, 5.7)]).1, 2, "it is not at the end of the line");
}

#[test]
fn a_bar_on_an_axis_is_an_open_rectangle_and_a_second_row_of_dots_no_length() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let at = MmPoint::new;
    let bar = line(vec![at(20.0, 140.0), at(20.0, 100.0), at(40.0, 100.4), at(40.0, 140.0)]);
    let told_of = |line: Line| told(&[line], figure, 9, Wording::english()).concat();
    let axis = line(vec![at(10.0, 140.0), at(140.0, 140.0)]);
    let with_axis = told(&[bar.clone(), axis], figure, 9, Wording::english()).concat();
    assert!(with_axis.contains("in the lower left that a line closes at the bottom, 20 mm wide"), "{with_axis}");
    assert_eq!(told_of(bar), "A rectangle in the lower left, open at the bottom, 20 mm wide and 40 mm high.");
    let zigzag = line(vec![at(20.0, 140.0), at(20.0, 100.0), at(30.0, 120.0), at(40.0, 100.0), at(40.0, 140.0)]);
    assert!(told_of(zigzag).starts_with("A bent line"));
    let row = |y: f32| Run::dots(1.5, (0..41).map(|k| at(20.0 + 2.5 * k as f32, y)).collect(), Default::default());
    let heavy = Line { strength: 90.0, runs: vec![row(70.0), row(72.5)] };
    assert!(told_of(heavy).contains("100 mm long"));
}

#[test]
fn a_river_is_not_straight_and_how_it_bends_is_told() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let told_of = |line: Line| told(&[line], figure, 9, Wording::english()).concat();
    // along 100 mm from (25, 75) on: `off` mm above the straight, by the share of the way
    let along = |off: &dyn Fn(f32) -> f32| {
        let at = |k: u8| MmPoint::new(25.0 + f32::from(k), 75.0 - off(f32::from(k) / 100.0));
        line((0..=100).map(at).collect())
    };
    let bow = |height: f32| along(&move |share: f32| height * (PI * share).sin());
    assert!(told_of(bow(1.5)).starts_with("A straight level line in the middle, 100 mm long"), "{}", told_of(bow(1.5)));
    let above = "A bent line in the middle, 102 mm long, up to 8 mm above the straight between its ends.";
    assert_eq!(told_of(bow(8.0)), above, "its ends are 0.98 of its length apart");
    assert!(told_of(bow(-8.0)).contains("up to 8 mm below the straight"), "{}", told_of(bow(-8.0)));
    let river = along(&|share: f32| 5.0 * (2.0 * PI * share).sin());
    let winds = "A winding line in the middle, 102 mm long, up to 5 mm off the straight between its ends.";
    assert_eq!(told_of(river), winds);
    // turned by a quarter, what lay above lies on the right
    let upright = |height: f32| {
        let at = |k: u8| MmPoint::new(75.0 + height * (PI * f32::from(k) / 100.0).sin(), 25.0 + f32::from(k));
        line((0..=100).map(at).collect())
    };
    assert!(told_of(upright(8.0)).contains("up to 8 mm right of the straight"), "{}", told_of(upright(8.0)));
    assert!(told_of(upright(-8.0)).contains("up to 8 mm left of the straight"), "{}", told_of(upright(-8.0)));
    assert!(told_of(bow(60.0)).ends_with(" mm long."), "of a hook it is not told: {}", told_of(bow(60.0)));
}

/// A ring of dots ends one step before its first dot: of what lies level with that gap a row met one side only.
#[test]
fn a_ring_of_dots_holds_what_lies_level_with_its_gap() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    // 60 mm across; the gap is on its right, from 4.7 mm above its middle down to that
    let at = |k: usize| {
        let (sin, cos) = (k as f32 * PI / 20.0).sin_cos();
        MmPoint::new(75.0 + 30.0 * cos, 75.0 + 30.0 * sin)
    };
    let ring = Line { strength: 90.0, runs: vec![Run::dots(1.6, (0..40).map(at).collect(), Default::default())] };
    assert!(ring.is_ring_of_dots());
    for y in [66.0, 73.0, 77.0] {
        let told = told(&[ring.clone(), circle(70.0, y, 5.0)], figure, 9, Wording::english());
        assert!(told[0].ends_with("60 mm across; it contains a smaller one."), "{y}: {told:?}");
    }
}

#[test]
fn lines_that_are_not_told_may_be_as_long_as_those_that_are() {
    let level = |y: f32, length: f32| line(vec![MmPoint::new(10.0, y), MmPoint::new(10.0 + length, y)]);
    let equal: Vec<Line> = (0..3).map(|k| level(10.0 * k as f32, 50.0)).collect();
    assert!(!others_are_shorter(&equal, 2));
    assert!(others_are_shorter(&equal, 3), "there is no other");
    let shorter = [level(10.0, 50.0), level(20.0, 40.0), level(30.0, 50.0)];
    assert!(others_are_shorter(&shorter, 2));
}

/// Towns of a map, on paper and as dots: no outlines, and no lines.
#[test]
fn discs_and_small_filled_rings_of_dots_are_points() {
    let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let disc = |x: f32| {
        let mut disc = circle(x, 75.0, 0.7);
        disc.runs[0].width = 1.6;
        disc
    };
    let dots = |at: Vec<MmPoint>| Run::dots(1.6, at, Default::default());
    let around = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
    let ring: Vec<MmPoint> =
        around.iter().map(|(x, y)| MmPoint::new(20.0 + 2.0 * *x as f32, 20.0 + 2.0 * *y as f32)).collect();
    let hollow = Line { strength: 90.0, runs: vec![dots(ring.clone())] };
    let filled = Line { strength: 90.0, runs: vec![dots(ring), dots(vec![MmPoint::new(22.0, 22.0)])] };
    let told_of = |lines: &[Line]| points(lines, figure, Wording::english());
    assert_eq!(told_of(&[disc(75.0)]), ["A point in the middle, 3 mm across."]);
    assert_eq!(told_of(std::slice::from_ref(&filled)), ["A point in the upper left, 6 mm across."]);
    assert!(told_of(&[hollow.clone(), circle(75.0, 75.0, 6.0)]).is_empty(), "what is hollow is an outline");
    assert_eq!(count(&[filled, hollow, circle(75.0, 75.0, 30.0), disc(75.0)]), 2);
    assert_eq!(told_of(&[disc(20.0), disc(60.0), disc(90.0), disc(120.0)]), ["4 points, up to 3 mm across."]);
    let land = [circle(75.0, 75.0, 30.0), disc(75.0)];
    let lines = told(&land, figure, 9, Wording::english());
    assert_eq!(lines, ["A closed round outline in the middle, 60 mm across."], "it holds no smaller one");
}
