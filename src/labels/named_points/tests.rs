//! Tests of `named_points`.

use super::*;
use crate::geom::polygon::circle_points;
use crate::lines::Height;
use crate::page::Run;

fn ring(x: f32, y: f32, radius: f32) -> Line {
    let points = circle_points(MmPoint::new(x, y), radius, 24).collect();
    Line { strength: 1.0, runs: vec![Run { closed: true, ..Run::stroke(1.0, points) }] }
}

fn text(text: &str, x: f32, y: f32) -> Wanted {
    let anchor = MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 10.0, y + 4.0));
    Wanted { text: text.into(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }
}

#[test]
fn a_text_beside_a_small_ring_names_it_and_others_do_not() {
    let rings = rings(&[ring(50.0, 50.0, 2.5), ring(100.0, 100.0, 20.0), ring(102.0, 60.0, 4.0)]);
    assert_eq!(rings.len(), 2, "the large ring is a shape");
    let texts = [text("far", 10.0, 90.0), text("Quell", 55.0, 49.0), text("River", 57.0, 55.0), text("B", 97.0, 58.0)];
    let anchors = anchors(&texts, &rings, |_, _| true);
    let is_own: Vec<bool> = anchors.iter().zip(&texts).map(|(anchor, text)| *anchor == text.anchor).collect();
    assert_eq!(is_own, [true, false, true, true], "far, beside a ring, beside one that has a name, in a ring");
    assert!(anchors[1].is_empty() && (anchors[1].min - MmPoint::new(50.0, 50.0)).length() < 0.1);
}

/// On dots a ring has no closed stroke; a square, as the patch of a legend, is no point.
#[test]
fn a_ring_of_dots_is_one_and_a_square_is_none() {
    let of = |dots: &[(f32, f32)]| {
        let points = dots.iter().map(|&(x, y)| MmPoint::new(50.0 + 2.5 * x, 50.0 + 2.5 * y)).collect();
        rings(&[Line { strength: 1.0, runs: vec![Run::stroke(1.5, points)] }]).len()
    };
    let round = [(1.0, 0.0), (2.0, 0.0), (3.0, 1.0), (3.0, 2.0), (2.0, 3.0), (1.0, 3.0), (0.0, 2.0), (0.0, 1.0)];
    let square = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0), (0.0, 1.0)];
    assert_eq!([of(&round), of(&square), of(&round[..5])], [1, 0, 0]);
}

#[test]
fn points_beside_all_lines_are_named_on_dots() {
    let dots = |of: &[(f32, f32)]| {
        let points = of.iter().map(|&(x, y)| MmPoint::new(50.0 + 2.5 * x, 50.0 + 2.5 * y)).collect();
        Run::dots(1.5, points, Height::High)
    };
    let ring = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0), (0.0, 1.0)];
    let of = |runs: Vec<Run>| rings(&[Line { strength: 1.0, runs }]);
    let filled = of(vec![dots(&ring), dots(&[(1.0, 1.0)])]);
    assert_eq!(filled, [SmallRing { at: MmPoint::new(52.5, 52.5), reach: 2.5 }]);
    assert_eq!(of(vec![dots(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])]).len(), 1, "a block of four");
    assert!(of(vec![dots(&ring[..5])]).is_empty());
}

/// The years below the points of a time line are nearer to them than the names of what happened, which stand at two
/// heights above.
#[test]
fn points_of_a_time_line_have_a_name_and_a_year() {
    let at = [50.0, 90.0];
    let rings = rings(&at.map(|x| ring(x, 50.0, 2.5)));
    let above = |x: f32, y: f32| text("Name", x - 5.0, y);
    let years = at.map(|x| text("1804", x - 5.0, 55.0));
    let of = |names: [Wanted; 2], is_seen: bool| {
        let texts = [years.to_vec(), names.to_vec()].concat();
        anchors(&texts, &rings, |_, _| is_seen).iter().map(|anchor| anchor.is_empty()).collect::<Vec<_>>()
    };
    let names = [above(50.0, 41.0), above(90.0, 33.0)];
    assert_eq!(of(names.clone(), true), [true; 4]);
    assert_eq!(of(names.clone(), false), [true, true, false, false], "a line lies between");
    assert_eq!(of([names[0].clone(), above(93.0, 33.0)], true), [true, true, false, false], "beside the column of one");
    assert_eq!(of([names[0].clone(), above(90.0, 20.0)], true), [true, true, false, false], "far above one");
}

/// The first point of a curve may lie so near above the axis that the month below it is as near as a name.
#[test]
fn a_month_below_an_axis_names_no_point_of_the_curve_above() {
    let rings = rings(&[ring(50.0, 50.0, 2.5)]);
    let of = |names: [&str; 3], is_seen: bool| {
        let texts: Vec<Wanted> = [45.0, 75.0, 105.0].iter().zip(names).map(|(x, name)| text(name, *x, 55.0)).collect();
        anchors(&texts, &rings, |_, _| is_seen)[0].is_empty()
    };
    let months = ["Jan", "Mar", "May"];
    assert!(!of(months, false), "beyond the axis");
    assert!(of(months, true), "nothing lies between");
    assert!(of(["1", "3", "5"], false), "a number has its place on a line of points");
    let alone = [text("Quell", 45.0, 55.0), text("Brook", 75.0, 60.0)];
    assert!(anchors(&alone, &rings, |_, _| false)[0].is_empty(), "a town beside a road");
}
