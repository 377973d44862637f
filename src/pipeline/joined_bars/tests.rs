//! Three bars made by hand: what is drawn of them otherwise, and what of their contours that replaces.

use super::super::bars::{BaseSpan, Direction};
use super::*;
use crate::units::{MmPoint, Size};

const BARS: [Bar; 3] = [
    Bar { from: 0.0, to: 20.0, top: 100.0 },
    Bar { from: 24.0, to: 44.0, top: 60.0 },
    Bar { from: 48.0, to: 68.0, top: 80.0 },
];
const OWN_SIDES: [RowEnd; 2] = [RowEnd { at: 0.0, is_axis: false }, RowEnd { at: 68.0, is_axis: false }];

/// Three bars that point up, 4 px apart, on a base at 0, and an axis 10 px before the first, as high as this.
fn chart(axis: f32) -> Chart {
    let side = |at: f32, to: f32| BaseSpan { at, from: 0.0, to };
    let sides = BARS.iter().flat_map(|bar| [side(bar.from, bar.top), side(bar.to, bar.top)]);
    let sides = sides.chain([side(-10.0, axis)]).collect();
    let (bars, gridlines) = (BARS.to_vec(), Vec::new());
    Chart { direction: Direction::Up, base: 0.0, bars, sides, gridlines, frame: None, is_divided: false }
}

fn row(ends: [RowEnd; 2]) -> BarRow {
    BarRow { bars: BARS.to_vec(), ends }
}

/// Paths as places across and along bars.
fn places(paths: &[Vec<PxPoint>]) -> Vec<Vec<(f32, f32)>> {
    paths.iter().map(|path| path.iter().map(|&at| Direction::Up.of(at)).collect()).collect()
}

#[test]
fn bars_that_touch_have_an_outline_and_a_line_up_to_the_lower_of_every_two() {
    let outline =
        [(0.0, 0.0), (0.0, 100.0), (22.0, 100.0), (22.0, 60.0), (46.0, 60.0), (46.0, 80.0), (68.0, 80.0), (68.0, 0.0)];
    let between = [vec![(22.0, 0.0), (22.0, 60.0)], vec![(46.0, 0.0), (46.0, 60.0)]];
    let chart = chart(120.0);
    let touching = places(&chart.paths(&[row(OWN_SIDES)], true));
    assert_eq!(touching[..2], between);
    assert_eq!(touching[2..], [outline.to_vec()]);
    assert_eq!(places(&chart.paths(&[row(OWN_SIDES)], false)), [outline.to_vec()], "one common outline");
}

#[test]
fn an_outline_that_begins_at_an_axis_has_no_side_there() {
    let at_axis = [RowEnd { at: -10.0, is_axis: true }, OWN_SIDES[1]];
    let outline = places(&chart(120.0).paths(&[row(at_axis)], false)).remove(0);
    assert_eq!((outline[0], outline.len()), ((-10.0, 100.0), 7));
}

#[test]
fn a_row_ends_at_an_axis_in_reach_that_is_as_high_or_else_at_its_own_side() {
    let end = |axis: f32, bar: usize, reach: f32, is_last: bool| {
        let end = chart(axis).end(&BARS[bar], reach, is_last);
        (end.at, end.is_axis)
    };
    assert_eq!(end(120.0, 0, 12.0, false), (-10.0, true));
    assert_eq!(end(120.0, 0, 8.0, false), (0.0, false), "it is too far away");
    assert_eq!(end(50.0, 0, 12.0, false), (0.0, false), "it is lower than the bar");
    assert_eq!(end(120.0, 2, 12.0, true), (68.0, false), "it is on the other side");
    assert_eq!(end(120.0, 0, 12.0, true), (20.0, false), "the side of the next bar is no axis");
}

#[test]
fn the_base_has_a_line_where_nothing_else_runs_along_it() {
    let gaps = |ground: &[(f32, f32)]| places(&chart(120.0).gaps_of_base(&[row(OWN_SIDES)], ground.to_vec()));
    assert_eq!(gaps(&[]), [[(0.0, 0.0), (68.0, 0.0)]]);
    assert_eq!(gaps(&[(40.0, 70.0), (-5.0, 10.0)]), [[(10.0, 0.0), (40.0, 0.0)]]);
    assert_eq!(gaps(&[(10.0, 30.0)]), [[(0.0, 0.0), (10.0, 0.0)], [(30.0, 0.0), (68.0, 0.0)]]);
    assert_eq!(gaps(&[(90.0, 99.0)]), [[(0.0, 0.0), (68.0, 0.0)]], "what is beyond the row does not count");
    assert!(gaps(&[(-5.0, 34.0), (36.0, 70.0)]).is_empty(), "what is interrupted by a line's width goes on");
}

#[test]
fn sides_tops_corners_and_what_is_between_two_bars_of_a_row_are_replaced() {
    let (upwards, level, slanting) = (PxVector::new(0.0, -1.0), PxVector::new(1.0, 0.0), PxVector::new(0.7, -0.7));
    let (chart, rows) = (chart(120.0), [row(OWN_SIDES)]);
    let is_replaced =
        |place: (f32, f32), direction: PxVector| chart.is_replaced(Direction::Up.point(place), direction, &rows, &[]);
    assert!(is_replaced((0.0, 50.0), upwards), "a side");
    assert!(is_replaced((10.0, 100.0), level), "a top");
    assert!(is_replaced((0.0, 100.0), slanting), "a corner, whatever the direction there");
    assert!(is_replaced((22.0, 30.0), level), "a gridline between two bars");
    assert!(!is_replaced((0.0, 50.0), level), "what crosses a side");
    assert!(!is_replaced((0.0, 110.0), upwards), "what is above a bar");
    assert!(!is_replaced((34.0, 30.0), level), "what is in a bar");
    assert!(!is_replaced((47.0, 90.0), level), "what is above the nearer of two bars");
    assert!(!is_replaced((10.0, 2.0), level), "the base");
}

#[test]
fn of_a_bar_that_is_too_low_its_own_outline_is_replaced_only() {
    let (upwards, level) = (PxVector::new(0.0, -1.0), PxVector::new(1.0, 0.0));
    let is_replaced = |place: (f32, f32), direction: PxVector| {
        chart(120.0).is_replaced(Direction::Up.point(place), direction, &[], &BARS[1..2])
    };
    assert!(is_replaced((24.0, 30.0), upwards) && is_replaced((30.0, 60.0), level));
    assert!(!is_replaced((0.0, 50.0), upwards), "the side of another bar");
    assert!(!is_replaced((22.0, 30.0), level), "what is between it and the next");
}

#[test]
fn a_side_that_a_bar_shares_with_one_that_is_too_low_stays() {
    let (upwards, level) = (PxVector::new(0.0, -1.0), PxVector::new(1.0, 0.0));
    let bars = vec![BARS[0], Bar { from: 20.0, to: 40.0, top: 8.0 }];
    let chart = Chart { bars, ..chart(120.0) };
    let is_replaced = |place: (f32, f32), direction: PxVector| {
        chart.is_replaced(Direction::Up.point(place), direction, &[], &chart.bars[1..])
    };
    assert!(is_replaced((40.0, 6.0), upwards) && is_replaced((30.0, 8.0), level));
    assert!(!is_replaced((20.0, 6.0), upwards));
}

/// The lengths of the runs, px, that are kept of 100 px of a straight line of which some is taken out.
fn kept(is_out: impl Fn(usize) -> bool, is_of_base: bool) -> Vec<usize> {
    let edgel = |x: u16| Edgel { at: PxPoint::new(f32::from(x), 0.0), strength: 30.0, contrast: [0.0; 3] };
    let mut edges = Edges::none(Size::new(100, 10));
    edges.push((0..=100).map(edgel), false);
    let runs = kept_runs(&edges, &edges.chains[0], is_out, |_| is_of_base);
    runs.iter().map(|run| run.len() - 1).collect()
}

#[test]
fn a_contour_goes_on_where_it_crosses_the_side_of_a_bar() {
    assert_eq!(kept(|_| false, false), [100]);
    assert_eq!(kept(|i| (40..=48).contains(&i), false), [100], "8 px are less than CROSSES");
    assert_eq!(kept(|i| (40..=60).contains(&i), false), [39, 39], "20 px are a side");
    assert_eq!(kept(|i| i < 8, false), [92], "at an end nothing is crossed");
}

#[test]
fn a_remainder_of_a_bar_goes_unless_it_is_of_the_base() {
    let is_out = |i: usize| !(40..=48).contains(&i);
    assert!(kept(is_out, false).is_empty());
    assert_eq!(kept(is_out, true), [8]);
}

#[test]
fn the_frame_close_above_a_bar_does_not_stand_for_its_top() {
    let tolerances = BarTolerances { gap: 3.0, low: 3.0, reach: 2.0, torn: 3.0, moved: 0.0 };
    let at = PageTransform::new(Size::new(100, 100), MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)));
    // how far above and below the top, at 100 mm, a line stands for it
    let span = |frame: Option<f32>| {
        let WantedPath { path, reach, .. } = Chart { frame, ..chart(120.0) }.middle_of_top(&BARS[0], tolerances, &at);
        let (_, along) = Direction::Up.of(path[0]);
        [along + reach - 100.0, 100.0 - along + reach]
    };
    let is_even = |[up, down]: [f32; 2]| (up - 2.0).abs() < 1e-3 && (down - 2.0).abs() < 1e-3;
    assert!(is_even(span(None)) && is_even(span(Some(110.0))));
    let [up, down] = span(Some(102.0));
    assert!(up < 1.5 && (down - 2.0).abs() < 1e-3, "{up} {down}");
}
