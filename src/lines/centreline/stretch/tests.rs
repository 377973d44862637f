//! Tests of `stretch`.

use super::super::opposite::opposites;
use super::super::testing::{area, bar, side, stroke};
use super::*;
use crate::lines::params::Params;

fn of(lines: &[Polyline<Vertex>]) -> Vec<StrokeSide> {
    stretches(lines, &opposites(lines, area(), &Params::TEST))
}

#[test]
fn a_stretch_is_as_long_as_the_other_side_and_as_salient_as_it_is_long_and_strong() {
    let found = of(&stroke(3.0));
    let [long, short] = &found[..] else { panic!("{} stretches", found.len()) };
    assert_eq!([(long.polyline, long.other), (short.polyline, short.other)], [(0, 1), (1, 0)]);
    assert!((long.count as f32 * 0.4 - 20.0).abs() < 1.0 && (long.from as f32 * 0.4 - 10.0).abs() < 0.5);
    assert!((short.saliency - 20.0 * 60.0).abs() < 60.0, "{}", short.saliency);
}

#[test]
fn the_stretches_of_a_ring_are_the_same_wherever_it_begins() {
    let count = bar(3.0, 0).vertices.len();
    let places = |start: usize| {
        let mut places: Vec<(usize, usize)> =
            of(&[bar(3.0, start)]).iter().map(|found| ((found.from + start) % count, found.count)).collect();
        places.sort_unstable();
        places
    };
    let first = places(0);
    assert_eq!(first.len(), 2, "both sides: {first:?}");
    for start in 1..count {
        // which of the vertices at the ends of the bar still have an opposite is a matter of rounding
        let is_alike = |(a, b): (&(usize, usize), &(usize, usize))| a.0.abs_diff(b.0) <= 1 && a.1.abs_diff(b.1) <= 2;
        let now = places(start);
        assert!(now.len() == 2 && now.iter().zip(&first).all(is_alike), "{now:?} from vertex {start}, not {first:?}");
    }
}

#[test]
fn a_side_shorter_than_one_and_a_half_widths_is_no_stroke() {
    let beside = |length: f32| {
        let short = side(&[(20.0, 23.0), (20.0 + length, 23.0)], false, -60.0);
        of(&[side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0), short]).len()
    };
    assert_eq!([beside(4.0), beside(5.2)], [0, 2]);
}
