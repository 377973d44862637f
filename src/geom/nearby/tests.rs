//! Tests of `nearby`.

use super::*;
use crate::geom::segment_distance;
use crate::units::{MmPoint, MmRect, Px, PxPoint};
use proptest::prelude::*;

proptest! {
    #[test]
    fn points_within_reach_are_seen_once_wherever_they_lie(
        raw in prop::collection::vec((-20.0_f32..60.0, -20.0_f32..60.0), 1..60),
        at in (-20.0_f32..60.0, -20.0_f32..60.0),
        reach in 0.0_f32..30.0,
        cell in 0.1_f32..50.0,
    ) {
        let points: Vec<PxPoint> = raw.iter().map(|&at| at.into()).collect();
        let mut index = Index::<usize, Px>::new(Box2D::new(PxPoint::zero(), PxPoint::new(40.0, 30.0)), cell);
        for (number, &point) in points.iter().enumerate() {
            index.put_at(point, number);
        }
        let at = PxPoint::from(at);
        let mut seen = Vec::new();
        index.around(at, at, reach, |&number| seen.push(number));
        seen.sort_unstable();
        prop_assert!(seen.is_sorted_by(|a, b| a < b), "a point is in one cell");
        for (number, &point) in points.iter().enumerate() {
            prop_assert!((point - at).length() > reach || seen.contains(&number), "{point:?} is missed");
        }
    }

    #[test]
    fn along_a_way_nothing_that_it_crosses_is_missed(
        raw in prop::collection::vec((0.0_f32..40.0, 0.0_f32..30.0, -3.0_f32..3.0, -3.0_f32..3.0), 1..40),
        ray in (0.0_f32..40.0, 0.0_f32..30.0, -9.0_f32..9.0, -9.0_f32..9.0),
    ) {
        let mut nearby = Nearby::new(MmRect::new(MmPoint::zero(), MmPoint::new(40.0, 30.0)), 1.0);
        let inside = |x: f32, y: f32| MmPoint::new(x.clamp(0.0, 39.9), y.clamp(0.0, 29.9));
        let segments: Vec<_> = raw.iter().map(|&(x, y, dx, dy)| (inside(x, y), inside(x + dx, y + dy))).collect();
        for (index, &(a, b)) in segments.iter().enumerate() {
            nearby.insert(Segment { a, b, half_width: 0.0, line: 0, index: index as u32, arc: 0.0 });
        }
        let (from, to) = (inside(ray.0, ray.1), inside(ray.0 + ray.2, ray.1 + ray.3));
        let mut seen = Vec::new();
        let mut last = 0.0;
        nearby.along(from, to, |segments, begins| {
            seen.extend(segments.iter().map(|segment| segment.index as usize));
            let is_farther = begins >= last;
            last = begins;
            is_farther
        });
        for (index, &segment) in segments.iter().enumerate() {
            let crosses = segment_distance((from, to), segment) == 0.0;
            prop_assert!(!crosses || seen.contains(&index), "segment {index} is missed");
        }
    }

    #[test]
    fn a_line_is_near_where_it_has_a_nearest_segment(
        raw in prop::collection::vec((0_u32..4, 0.0_f32..40.0, 0.0_f32..30.0, -3.0_f32..3.0, -3.0_f32..3.0), 1..60),
        at in (-5.0_f32..45.0, -5.0_f32..35.0),
        reach in 0.0_f32..6.0,
        line in 0_u32..5,
    ) {
        let mut nearby = Nearby::new(MmRect::new(MmPoint::zero(), MmPoint::new(40.0, 30.0)), 4.0);
        let mut raw = raw;
        raw.sort_by_key(|segment| segment.0);
        for (line, x, y, dx, dy) in raw {
            let (a, b) = (MmPoint::new(x, y), MmPoint::new(x + dx, y + dy));
            nearby.insert(Segment { a, b, half_width: 0.0, line, index: 0, arc: 0.0 });
        }
        let nearest = nearby.nearest_of_line(at.into(), reach, line);
        prop_assert_eq!(nearby.is_near_line(at.into(), reach, line), nearest.is_some());
        // the first that is asked for ends the search, and all before it come in the same order
        let (mut all, mut seen) = (Vec::new(), Vec::new());
        nearby.around_point(at.into(), reach, |segment| all.push(segment.line));
        let has_one = nearby.any_around_point(at.into(), reach, |segment| {
            seen.push(segment.line);
            segment.line == line
        });
        let until = all.iter().position(|of| *of == line).map_or(all.len(), |first| first + 1);
        prop_assert_eq!((&seen[..], has_one), (&all[..until], all.contains(&line)));
    }
}

#[test]
fn along_a_way_no_more_cells_are_looked_at_than_are_asked_for() {
    let mut index = Index::<usize, Px>::new(Box2D::new(PxPoint::zero(), PxPoint::new(40.0, 30.0)), 1.0);
    (0..40).for_each(|column| index.put_at(PxPoint::new(column as f32 + 0.5, 5.5), column));
    let seen = |most: f32| {
        let mut seen = Vec::new();
        index.along(PxPoint::new(10.5, 5.5), PxPoint::new(20.5, 5.5), |cell, begins| {
            let goes_on = begins <= most;
            seen.extend(cell.iter().copied().filter(|_| goes_on));
            goes_on
        });
        seen
    };
    assert_eq!(seen(1.0), (10..=20).collect::<Vec<_>>());
    // the fourth cell begins 2.5 of 10 along the way, and the fifth 3.5
    assert_eq!(seen(0.3), [10, 11, 12, 13]);
    let mut looked = 0;
    index.along(PxPoint::new(10.5, 5.5), PxPoint::new(20.5, 5.5), |_, _| {
        looked += 1;
        looked < 3
    });
    assert_eq!(looked, 3);
}

#[test]
fn lines_end_on_others_where_these_may_be_bases() {
    let mut nearby = Nearby::new(MmRect::new(MmPoint::zero(), MmPoint::new(40.0, 30.0)), 4.0);
    let segment = |line: u32, a: (f32, f32), b: (f32, f32)| Segment {
        a: a.into(),
        b: b.into(),
        half_width: 0.0,
        line,
        index: 0,
        arc: 0.0,
    };
    nearby.insert(segment(0, (5.0, 20.0), (35.0, 20.0)));
    nearby.insert(segment(1, (20.0, 5.0), (20.0, 19.95)));
    let tips = || [(0, (5.0, 20.0)), (1, (20.0, 19.95)), (2, (5.0, 20.0))].map(|(line, at)| (line, at.into()));
    assert_eq!(nearby.which_end_on(tips().into_iter(), 0.1, |_, _| true), [(1, 0), (2, 0)]);
    let away_from_its_ends = |_: &Segment, arc: f32| (1.0..29.0).contains(&arc);
    assert_eq!(nearby.which_end_on(tips().into_iter(), 0.1, away_from_its_ends), [(1, 0)]);
}
