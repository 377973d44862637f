//! Pieces that are linked at their ends.

use super::*;
use crate::units::MmPoint;
use proptest::prelude::*;

/// The ends of straight polylines from the first point of each pair to the second.
fn ends(lines: &[(MmPoint, MmPoint)]) -> Vec<End<crate::units::Mm>> {
    let both = |(polyline, &(from, to)): (usize, &(MmPoint, MmPoint))| {
        let direction = (to - from).try_normalize().unwrap_or_default();
        let end = |at_start, at, direction| End { polyline, at_start, at, direction, contrast: [0.0; 3] };
        [end(true, from, -direction), end(false, to, direction)]
    };
    lines.iter().enumerate().flat_map(both).collect()
}

fn by_distance(lines: &[(MmPoint, MmPoint)], reach: f32) -> Vec<LinkedChain> {
    link(lines.len(), &ends(lines), reach, |a, b| {
        let distance = (b.at - a.at).length();
        (distance <= reach && a.polyline != b.polyline).then_some(distance)
    })
}

fn at(x: f32, y: f32) -> MmPoint {
    MmPoint::new(x, y)
}

fn parts(thread: &LinkedChain) -> Vec<(usize, bool)> {
    thread.parts.iter().map(|part| (part.polyline, part.reversed)).collect()
}

#[test]
fn ends_in_reach_make_one_thread_whichever_way_the_pieces_run() {
    let threads = by_distance(&[(at(0., 0.), at(4., 0.)), (at(9., 0.), at(5., 0.)), (at(20., 0.), at(30., 0.))], 1.5);
    assert_eq!(threads.len(), 2);
    assert_eq!((parts(&threads[0]), threads[0].closed), (vec![(0, false), (1, true)], false));
    assert_eq!(parts(&threads[1]), [(2, false)]);
}

#[test]
fn the_cheapest_link_is_made_and_an_end_has_one() {
    // the end at x = 4 could go on to either of two
    let threads = by_distance(&[(at(0., 0.), at(4., 0.)), (at(5., 0.5), at(9., 0.5)), (at(4.5, 0.), at(9., 0.))], 2.0);
    assert_eq!(parts(&threads[0]), [(0, false), (2, false), (1, true)]);
}

#[test]
fn of_equal_links_that_of_the_earlier_ends_is_made() {
    let threads = by_distance(&[(at(0., 0.), at(4., 0.)), (at(5., 1.), at(9., 9.)), (at(5., -1.), at(9., -9.))], 2.0);
    assert_eq!(parts(&threads[0]), [(0, false), (1, false)]);
}

#[test]
fn pieces_of_a_ring_close_and_come_last() {
    let square = [
        (at(0., 0.), at(4., 0.)),
        (at(4.5, 4.5), at(4.5, 0.5)),
        (at(4., 5.), at(0., 5.)),
        (at(-0.5, 4.5), at(-0.5, 0.5)),
    ];
    let mut lines = square.to_vec();
    lines.push((at(20., 0.), at(30., 0.)));
    let threads = by_distance(&lines, 1.0);
    assert_eq!(parts(&threads[0]), [(4, false)]);
    assert!(threads[1].closed);
    assert_eq!(parts(&threads[1]), [(0, false), (1, true), (2, false), (3, false)]);
}

#[test]
fn the_two_ends_of_one_polyline_may_be_linked() {
    let threads = link(1, &ends(&[(at(0., 0.), at(1., 0.))]), 2.0, |_, _| Some(1.0));
    assert_eq!(threads, [LinkedChain { parts: vec![Part { polyline: 0, reversed: false }], closed: true }]);
}

#[test]
fn linked_polylines_become_one_in_the_direction_of_the_first() {
    let lines = [(at(0., 0.), at(4., 0.)), (at(9., 0.), at(5., 0.)), (at(9., 1.), at(0., 1.))];
    let mut left: Vec<_> = lines.iter().map(|&(from, to)| Some(Polyline::open(vec![from, to]))).collect();
    let threads = by_distance(&lines, 1.5);
    assert_eq!(threads.len(), 1);
    let ring = threads[0].concatenate(&mut left, |before, next| before.extend(next)).expect("it is left");
    let expected = [at(0., 0.), at(4., 0.), at(5., 0.), at(9., 0.), at(9., 1.), at(0., 1.)];
    assert_eq!((ring.vertices, ring.closed), (expected.to_vec(), true));
    assert!(threads[0].concatenate(&mut left, |before, next| before.extend(next)).is_none(), "it was taken");
}

#[test]
fn what_has_no_ends_is_a_thread_by_itself() {
    let threads = link::<crate::units::Mm>(2, &[], 1.0, |_, _| None);
    assert_eq!(threads.iter().map(parts).collect::<Vec<_>>(), [[(0, false)], [(1, false)]]);
}

proptest! {
    #[test]
    fn every_polyline_is_in_one_thread_and_its_links_are_in_reach(
        raw in prop::collection::vec((0.0_f32..20.0, 0.0_f32..20.0, 0.0_f32..20.0, 0.0_f32..20.0), 0..30),
        reach in 0.0_f32..8.0,
    ) {
        let lines: Vec<_> = raw.iter().map(|&(a, b, c, d)| (at(a, b), at(c, d))).collect();
        let threads = by_distance(&lines, reach);
        let parts = threads.iter().flat_map(|thread| &thread.parts);
        let mut seen: Vec<usize> = parts.map(|part| part.polyline).collect();
        seen.sort_unstable();
        prop_assert_eq!(seen, (0..lines.len()).collect::<Vec<_>>());
        let tip = |part: &Part, end: bool| {
            let (from, to) = lines[part.polyline];
            if part.reversed == end { from } else { to }
        };
        for thread in &threads {
            for pair in thread.parts.windows(2) {
                prop_assert!((tip(&pair[0], true) - tip(&pair[1], false)).length() <= reach);
            }
        }
    }
}
