//! Tests of `ticks`.

use super::*;
use crate::labels::Params;
use crate::page::{Line, Run};

/// Every how many-th number is tried from 0 to 10 at steps of 10 mm under an axis with ticks at some of them.
fn counts(ticks: &[usize]) -> Vec<i64> {
    counts_of(ticks, (16.0, 24.0))
}

/// The same with ticks from one height to another.
fn counts_of(ticks: &[usize], (from, to): (f32, f32)) -> Vec<i64> {
    let line = |from: (f32, f32), to: (f32, f32)| Line {
        strength: 50.0,
        runs: vec![Run::stroke(1.0, vec![MmPoint::from(from), MmPoint::from(to)])],
    };
    let at = |i: usize| 10.0 + 10.0 * i as f32;
    let of_ticks = ticks.iter().map(|&i| line((at(i), from), (at(i), to)));
    let lines: Vec<Line> = std::iter::once(line((5.0, 20.0), (118.0, 20.0))).chain(of_ticks).collect();
    let room =
        Room::new(&lines, &[], &Params::of_test(MmRect::new(MmPoint::new(0.0, -30.0), MmPoint::new(130.0, 60.0))));
    let wanted: Vec<Wanted> = (0..=10)
        .map(|i| Wanted {
            text: i.to_string(),
            anchor: MmRect::new(MmPoint::new(at(i) - 2.0, 27.0), MmPoint::new(at(i) + 2.0, 31.0)),
            lost_leader: None,
            kept_leader: None,
            is_nameless: false,
        })
        .collect();
    let groups = super::super::groups::of(&wanted, |_| true, |_| false, |_| false);
    assert_eq!(groups.len(), 1);
    selections(&groups[0], &wanted, &room).iter().map(|numbers| numbers.count).collect()
}

#[test]
fn numbers_that_have_a_tick_are_tried_first() {
    let all: Vec<usize> = (0..=10).collect();
    assert_eq!(counts(&all), [1, 2, 5, 10]);
    assert_eq!(counts(&[]), [1, 2, 5, 10]);
    assert_eq!(counts(&[0, 5, 10]), [1, 5, 10, 2]);
    assert_eq!(counts(&[0, 3, 6, 9]), [1, 3, 2, 5, 10]);
    assert_eq!(counts(&[0, 10]), [1, 10, 2, 5]);
}

#[test]
fn lines_of_a_grid_are_no_ticks() {
    assert_eq!(counts_of(&[0, 5, 10], (-20.0, 20.0)), [1, 2, 5, 10]);
}

/// How far towards four texts, 20 mm apart, the ticks of an axis will reach that are to be 8 mm long: the least
/// x of them, where the axis is upright, at 40 mm, from `first` mm down to 80; the first number stands at 10 mm. Of a
/// level axis the same with x and y swapped. The print ends `blank` mm before the ticks; it is these texts.
fn nearest_beside(texts: [&str; 4], tick: f32, blank: f32, first: f32, is_level: bool) -> f32 {
    let at = |i: usize| 10.0 + 20.0 * i as f32;
    let point = |x: f32, y: f32| if is_level { MmPoint::new(y, 90.0 - x) } else { MmPoint::new(x, y) };
    let line = |from: MmPoint, to: MmPoint| Line { strength: 50.0, runs: vec![Run::stroke(1.0, vec![from, to])] };
    let ticks = (0..4).map(|i| line(point(40.0 - tick, at(i)), point(40.0, at(i))));
    let axis = line(point(40.0, first), point(40.0, 80.0));
    let lines: Vec<Line> = std::iter::once(axis).chain(ticks).collect();
    let room = Room::new(&lines, &[], &Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(90.0, 90.0))));
    let right = 40.0 - tick - blank;
    let number = |i: usize| Wanted {
        text: texts[i].to_string(),
        anchor: MmRect::from_points([point(right - 6.0, at(i) - 2.0), point(right, at(i) + 2.0)]),
        lost_leader: None,
        kept_leader: None,
        is_nameless: false,
    };
    let wanted: Vec<Wanted> = (0..4).map(number).collect();
    let groups = super::super::groups::of(&wanted, |_| true, |_| false, |_| false);
    let longer = longer(&groups, &wanted, &room, 8.0);
    let off = |at: &MmPoint| if is_level { 90.0 - at.y } else { at.x };
    longer.iter().map(off).fold(f32::INFINITY, f32::min)
}

/// The same beside the numbers 0 to 3.
fn nearest_of_longer(tick: f32, blank: f32, first: f32, is_level: bool) -> f32 {
    nearest_beside(["0 \u{20ac}", "1 \u{20ac}", "2 \u{20ac}", "3 \u{20ac}"], tick, blank, first, is_level)
}

#[test]
fn ticks_of_a_millimetre_are_laid_out_as_long_as_they_will_be_drawn() {
    for is_level in [false, true] {
        for tick in [2.5, 1.5] {
            let nearest = nearest_of_longer(tick, 6.0 - tick, 5.0, is_level);
            assert!(nearest < 33.5, "{nearest}");
        }
        let nearest = nearest_of_longer(0.0, 6.0, 5.0, is_level);
        assert!(nearest.is_infinite(), "an axis is no tick");
        let nearest = nearest_of_longer(0.0, 0.8, 10.0, is_level);
        assert!(nearest.is_infinite(), "nor is its end");
    }
}

#[test]
fn ticks_are_found_that_end_close_to_their_numbers() {
    for is_level in [false, true] {
        // as in a chart of 8 inches on half a sheet: ticks of 3.5 points, 3.5 points before their numbers
        for (tick, blank) in [(0.8, 0.8), (1.5, 0.8), (1.5, 0.3), (2.5, 0.8)] {
            let nearest = nearest_of_longer(tick, blank, 5.0, is_level);
            assert!((31.0..33.5).contains(&nearest), "{tick} {blank}: {nearest}");
        }
    }
}

#[test]
fn ticks_at_words_below_bars_are_laid_out_as_long_as_they_will_be_drawn() {
    let days = ["Mon", "Tue", "Wed", "Thu"];
    let nearest = nearest_beside(days, 1.5, 0.8, 5.0, true);
    assert!((31.0..33.5).contains(&nearest), "{nearest}");
    let nearest = nearest_beside(days, 0.0, 6.0, 5.0, true);
    assert!(nearest.is_infinite(), "an axis is no tick");
}
