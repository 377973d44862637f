//! Borders beside two traces keep to one of them.

use std::f32::consts::TAU;

use super::super::border::{borders, corner_at};
use super::super::grid::RegionGrid;
use super::super::trace::{TracePoint, TracedContour};
use super::*;
use crate::units::Size;

/// Columns and rows of a picture.
const SIDE: usize = 100;
/// Middle of an oval.
const MIDDLE: (f32, f32) = (48.3, 51.2);

fn grid() -> RegionGrid {
    RegionGrid::new(Size::new(SIDE as u32, SIDE as u32))
}

/// How far a place is from the middle of the oval, along its longer axis.
fn radius(at: PxPoint) -> f32 {
    (at.x - MIDDLE.0).hypot((at.y - MIDDLE.1) / 0.8)
}

/// Two ovals around one another, this far apart, of which now the one is stronger and now the other, and the border of
/// a region between them; all places are `turned`.
fn oval(gap: f32, turned: impl Fn(PxPoint) -> PxPoint) -> (TraceMap, Vec<PxPoint>) {
    let trace = |radius: f32, phase: usize| {
        let count = (6.0 * radius) as usize;
        let point = |i: usize| {
            let (sin, cos) = (i as f32 / count as f32 * TAU).sin_cos();
            let strength = if (24 * i / count + phase).is_multiple_of(2) { 40.0 } else { 25.0 };
            let at = PxPoint::new(MIDDLE.0 + radius * cos, MIDDLE.1 + 0.8 * radius * sin);
            TracePoint { at: turned(at), strength }
        };
        TracedContour { vertices: (0..count).map(point).collect(), closed: true }
    };
    let traces = [trace(24.0 - 0.5 * gap, 0), trace(24.0 + 0.5 * gap, 1)];
    let mut labels = vec![0; SIDE * SIDE];
    for cell in 0..SIDE * SIDE {
        let at = PxPoint::new((cell % SIDE) as f32 + 0.5, (cell / SIDE) as f32 + 0.5);
        let to = turned(at);
        labels[to.y as usize * SIDE + to.x as usize] = u8::from(radius(at) < 24.0);
    }
    let all = borders(&labels, 1, grid().cells);
    let [ring] = &all[..] else { panic!("{} borders", all.len()) };
    let corner = |i: usize| corner_at(ring.corners[i % ring.corners.len()], grid().cells);
    let places = (0..ring.corners.len()).map(|i| corner(i).lerp(corner(i + 1), 0.5)).collect();
    (TraceMap::of(&traces, grid()), places)
}

/// A straight trace to the right, of which now the one, now the other stretch of six pixels is stronger.
fn straight(y: f32, columns: std::ops::Range<usize>, phase: usize) -> TracedContour {
    let point = |x: usize| TracePoint {
        at: PxPoint::new(x as f32 + 0.5, y),
        strength: if (x / 6 + phase).is_multiple_of(2) { 40.0 } else { 25.0 },
    };
    TracedContour { vertices: columns.map(point).collect(), closed: false }
}

/// The places along a straight border between two such traces.
fn straight_places() -> Vec<PxPoint> {
    (10..90).map(|x| PxPoint::new(x as f32 + 0.5, 45.0)).collect()
}

/// What each vertex would be put on by itself.
fn strongest(traces: &TraceMap, places: &[PxPoint], closed: bool) -> Vec<Seen> {
    let at = |(&place, heading): (&PxPoint, PxVector)| {
        let all = traces.all_seen(place, heading);
        all.into_iter().max_by(|a, b| a.strength.total_cmp(&b.strength)).expect("something is seen")
    };
    places.iter().zip(headings(places, closed)).map(at).collect()
}

/// How often neighbours are on different sides.
fn leaps(seen: &[Seen], is_inside: impl Fn(PxPoint) -> bool) -> usize {
    seen.windows(2).filter(|pair| is_inside(pair[0].at) != is_inside(pair[1].at)).count()
}

#[test]
fn a_ring_keeps_to_one_of_two_traces_and_never_turns_back() {
    let is_inside = |at: PxPoint| radius(at) < 24.0;
    for gap in [3.0, 4.0] {
        let (traces, places) = oval(gap, |at| at);
        let alone = leaps(&strongest(&traces, &places, true), is_inside);
        assert!(alone >= 20, "each by itself leaps {alone} times only");
        let seen = followed(&traces, &places, true);
        assert_eq!((seen.len(), leaps(&seen, is_inside)), (places.len(), 0), "{gap} apart");
        for (pair, heading) in seen.windows(2).zip(headings(&places, true)) {
            let along = (pair[1].at - pair[0].at).dot(heading);
            assert!(along > -0.3, "it turns back at {:?}, {gap} apart", pair[0].at);
        }
    }
}

#[test]
fn a_straight_border_keeps_to_one_of_two_traces() {
    let is_inside = |at: PxPoint| at.y > 45.0;
    for (above, below) in [(43.5, 46.5), (43.6, 46.4), (44.1, 46.2)] {
        let traces = TraceMap::of(&[straight(above, 0..SIDE, 0), straight(below, 0..SIDE, 1)], grid());
        let places = straight_places();
        assert!(leaps(&strongest(&traces, &places, false), is_inside) >= 10, "each by itself leaps");
        assert_eq!(leaps(&followed(&traces, &places, false), is_inside), 0, "{above} and {below}");
    }
}

#[test]
fn where_a_trace_ends_it_goes_on_along_the_other() {
    let traces = TraceMap::of(&[straight(43.5, 0..56, 0), straight(46.5, 44..SIDE, 1)], grid());
    let seen = followed(&traces, &straight_places(), false);
    assert_eq!(leaps(&seen, |at| at.y > 45.0), 1);
    let leap = seen.windows(2).find(|pair| pair[1].at.y - pair[0].at.y > 2.0).expect("it leaps down");
    assert!((43.0..57.0).contains(&leap[0].at.x), "at {:?}", leap[0].at);
}

#[test]
fn of_traces_that_are_alike_it_follows_that_inside() {
    let even = |y: f32| {
        let point = |x: usize| TracePoint { at: PxPoint::new(x as f32 + 0.5, y), strength: 40.0 };
        TracedContour { vertices: (0..SIDE).map(point).collect(), closed: false }
    };
    let traces = TraceMap::of(&[even(43.5), even(46.5)], grid());
    let mut places = straight_places();
    assert!(followed(&traces, &places, false).iter().all(|seen| seen.at.y > 45.0), "the right is below");
    places.reverse();
    assert!(followed(&traces, &places, false).iter().all(|seen| seen.at.y < 45.0), "the right is above");
}

#[test]
fn a_flipped_or_turned_picture_has_the_same_outline() {
    let side = SIDE as f32;
    let turns: [fn(PxPoint, f32) -> PxPoint; 4] = [
        |at, side| PxPoint::new(side - at.x, at.y),
        |at, side| PxPoint::new(at.x, side - at.y),
        |at, side| PxPoint::new(side - at.y, at.x),
        |at, _| PxPoint::new(at.y, at.x),
    ];
    // so far apart that it leaps here and there
    for gap in [2.0, 3.0, 4.6] {
        let (traces, places) = oval(gap, |at| at);
        let upright = followed(&traces, &places, true);
        for (number, turn) in turns.iter().enumerate() {
            let (traces, places) = oval(gap, |at| turn(at, side));
            let turned = followed(&traces, &places, true);
            assert_eq!(turned.len(), upright.len());
            let is_there = |seen: &Seen| turned.iter().any(|other| (turn(seen.at, side) - other.at).length() < 1e-3);
            assert!(upright.iter().all(is_there), "turn {number}, {gap} apart");
        }
    }
}

#[test]
fn without_traces_it_stays() {
    let places = straight_places();
    let seen = followed(&TraceMap::of(&[], grid()), &places, false);
    assert!(seen.iter().zip(&places).all(|(seen, place)| seen.at == *place && seen.strength <= 0.0));
    assert_eq!(followed(&TraceMap::of(&[], grid()), &[], true), []);
}
