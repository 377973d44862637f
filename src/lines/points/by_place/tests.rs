//! Tests of `by_place`: what it finds is what a search of all finds.

use super::*;
use crate::geom::nearest_on_segment;
use crate::lines::vertex::Tip;
use crate::units::MmVector;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

/// Numbers from 0 to 1 that look random, the same for the same seed.
fn random(seed: u64) -> impl FnMut() -> f32 {
    let mut state = seed;
    move || {
        // Knuth's MMIX generator; its high bits are the better ones
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1_u64 << 24) as f32
    }
}

fn place(next: &mut impl FnMut() -> f32) -> MmPoint {
    MmPoint::new(120.0 * next(), 80.0 * next())
}

/// A place at most 4 mm from another, across and down.
fn beside(at: MmPoint, next: &mut impl FnMut() -> f32) -> MmPoint {
    at + MmVector::new(8.0 * next() - 4.0, 8.0 * next() - 4.0)
}

fn point(at: MmPoint, radius: f32, is_exact: bool) -> Point {
    Point {
        at,
        radius,
        is_filled: true,
        strength: 60.0,
        series: None,
        is_alone: false,
        is_disc: false,
        is_exact,
        is_sure: true,
        is_circle: true,
        is_sign: false,
    }
}

/// The numbers of those lines that have a segment within `reach` of a place.
fn plainly_around(lines: &[Polyline<Vertex>], at: MmPoint, reach: f32) -> Vec<usize> {
    let is_near = |line: &Polyline<Vertex>| line.segments().any(|(a, b)| nearest_on_segment(at, a.at, b.at).0 <= reach);
    (0..lines.len()).filter(|&line| is_near(&lines[line])).collect()
}

#[test]
fn all_lines_that_come_near_to_a_place_are_found_in_order_also_where_they_were_led_on() {
    let mut next = random(1);
    let mut lines: Vec<Polyline<Vertex>> = (0..60)
        .map(|number| {
            let middle = place(&mut next);
            let vertices = (0..3).map(|_| Vertex { at: beside(middle, &mut next), ..Vertex::TEST }).collect();
            Polyline { vertices, closed: number % 3 == 0 }
        })
        .collect();
    let mut index = LineIndex::of(&lines, &PARAMS);
    let (mut near, mut all) = (0, 0);
    for step in 0..200 {
        let (at, reach) = (place(&mut next), 0.5 + 5.0 * next());
        let found = index.around(at, reach);
        let wanted = plainly_around(&lines, at, reach);
        assert!(found.is_sorted() && wanted.iter().all(|line| found.contains(line)), "{wanted:?} in {found:?}");
        (near, all) = (near + wanted.len(), all + found.len());
        let number = step % lines.len();
        if !lines[number].closed {
            let tip = Tip::Last.of(&lines[number]).expect("it has vertices").at;
            let to = beside(tip, &mut next);
            lines[number].vertices.push(Vertex { at: to, ..Vertex::TEST });
            index.lead_on(number, tip, to);
            assert!(index.around(to, 0.1).contains(&number));
        }
    }
    assert!(near > 0 && all < 200 * lines.len() / 2, "{near} lines are near, of {all} that are looked at");
}

#[test]
fn a_point_is_taken_already_if_it_is_the_same_as_any_of_those() {
    let mut next = random(2);
    let found: Vec<(usize, Point)> =
        (0..400).map(|number| (number, point(place(&mut next), 0.3 + 3.0 * next(), next() < 0.5))).collect();
    let mut taken = TakenPoints::none_of(&found, &PARAMS);
    for (number, point) in &found {
        assert_eq!(taken.has(point), is_drawn_twice(point, &taken.all), "{number}");
        if !taken.has(point) {
            taken.push(*number, *point);
        }
    }
    assert!((100..390).contains(&taken.all.len()), "{}", taken.all.len());
    let (number, first) = found[0];
    assert!(taken.has(&first) && !taken.by_place.is_any_same(number, &first), "it is itself, and no other is there");
}
