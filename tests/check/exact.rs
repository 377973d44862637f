//! Distances are exact: held against a search of all pairs in f64 on random pages.

use proptest::prelude::*;
use tactograph::internals::legibility::too_near;
use tactograph::internals::page::{Line, Run};
use tactograph::internals::units::MmPoint;

/// Blank between lines that is asked for, mm.
const LEAST: f32 = 3.2;

type Point = (f64, f64);

fn to_segment(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (a.0 + share * dx - p.0).hypot(a.1 + share * dy - p.1)
}

fn between((a, b): (Point, Point), (c, d): (Point, Point)) -> f64 {
    let side = |p: Point, q: Point, r: Point| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    [to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)]
        .into_iter()
        .fold(f64::MAX, f64::min)
}

/// The least blank between two lines, whatever their segments.
fn blank(a: &Line, b: &Line) -> f64 {
    let segments = |line: &Line| -> Vec<(Point, Point, f64)> {
        let of = |run: &Run| {
            let path: Vec<MmPoint> = run.path().collect();
            let half = f64::from(run.width) / 2.0;
            path.windows(2).map(|pair| (wide(pair[0]), wide(pair[1]), half)).collect::<Vec<_>>()
        };
        line.runs.iter().flat_map(of).collect()
    };
    let theirs = segments(b);
    let least = |(p, q, half): (Point, Point, f64)| {
        theirs.iter().map(|(r, s, other)| between((p, q), (*r, *s)) - half - other).fold(f64::MAX, f64::min)
    };
    segments(a).into_iter().map(least).fold(f64::MAX, f64::min)
}

fn wide(at: MmPoint) -> Point {
    (f64::from(at.x), f64::from(at.y))
}

/// A wavy line across the page, `runs` pieces of different widths.
fn wave((y, slope, swing, period): (f32, f32, f32, f32), widths: &[f32]) -> Line {
    let at = |k: usize| {
        let x = 10.0 + 3.0 * k as f32;
        MmPoint::new(x, y + slope * x + swing * (x / period).sin())
    };
    let run = |(number, width): (usize, &f32)| Run::stroke(*width, (12 * number..=12 * number + 12).map(at).collect());
    Line { strength: 20.0, runs: widths.iter().enumerate().map(run).collect() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Lines that do not meet: each pair that is too near is found, with the very distance, and no other.
    #[test]
    fn the_least_blank_of_two_lines_is_exact(
        shapes in prop::collection::vec(((10.0_f32..250.0, -0.1_f32..0.1, 0.0_f32..6.0, 4.0_f32..30.0),
            prop::collection::vec(0.75_f32..1.5, 3..4)), 2..14),
    ) {
        let lines: Vec<Line> = shapes.iter().map(|(shape, widths)| wave(*shape, widths)).collect();
        let found = too_near(&lines, LEAST);
        for (i, a) in lines.iter().enumerate() {
            for (j, b) in lines[..i].iter().enumerate() {
                let blank = blank(a, b);
                // lines that touch join, and beside a join other rules count
                prop_assume!(blank > 0.01);
                let near = found.iter().filter(|near| near.lines == (i, j) || near.lines == (j, i));
                let least = near.map(|near| near.gap).fold(f32::MAX, f32::min);
                if blank < f64::from(LEAST) - 0.016 {
                    prop_assert!((f64::from(least) - blank).abs() < 1e-3, "{least} in place of {blank}");
                } else if blank >= f64::from(LEAST) {
                    prop_assert!(least > 1e6, "lines {i} and {j} are {blank} mm apart, not {least}");
                }
            }
        }
    }
}

fn line(width: f32, points: &[(f32, f32)]) -> Line {
    Line { strength: 20.0, runs: vec![Run::stroke(width, points.iter().map(|&at| at.into()).collect())] }
}

#[test]
fn lines_that_end_on_a_small_ring_meet_in_it_as_in_a_point() {
    let ring = |radius: f32| {
        let at = |k: u32| {
            let turn = std::f32::consts::TAU * k as f32 / 40.0;
            MmPoint::new(60.0 + radius * turn.cos(), 50.0 + radius * turn.sin())
        };
        let points: Vec<MmPoint> = (0..=40).map(at).collect();
        Line { strength: 20.0, runs: vec![Run::stroke(1.0, points)] }
    };
    // two roads at 40 degrees
    let road = |radius: f32, degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        line(1.0, &[(60.0 + radius * cos, 50.0 + radius * sin), (60.0 + 45.0 * cos, 50.0 + 45.0 * sin)])
    };
    let found = |radius: f32| too_near(&[ring(radius), road(radius, 0.0), road(radius, 40.0)], LEAST).len();
    assert_eq!(found(3.0), 0);
    // of the same roads without a ring the ends are too near to one another
    assert!(!too_near(&[road(3.0, 0.0), road(3.0, 40.0)], LEAST).is_empty());
    // at a large ring they are two lines, as they run beside one another
    let wide = |degrees: f32| road(9.0, degrees);
    assert!(!too_near(&[ring(9.0), wide(0.0), wide(20.0)], LEAST).is_empty());
}

#[test]
fn lines_that_end_on_another_at_nearly_one_place_meet_there() {
    // two petals on the middle of their flower, 2 mm apart, and two rungs as far apart
    let base = line(1.0, &[(10.0, 50.0), (110.0, 50.0)]);
    let petals = [line(1.0, &[(60.0, 50.0), (40.0, 30.0)]), line(1.0, &[(62.0, 50.0), (82.0, 30.0)])];
    let rungs = [60.0, 62.0].map(|x| line(1.0, &[(x, 50.0), (x, 43.5)]));
    let found = |[one, other]: &[Line; 2]| too_near(&[base.clone(), one.clone(), other.clone()], LEAST).len();
    assert_eq!(found(&petals), 0);
    assert!(found(&rungs) > 0);
    // 8 mm apart, where each is a junction of its own, they may not come near again
    let back = [line(1.0, &[(60.0, 50.0), (63.0, 40.0), (90.0, 20.0)]), line(1.0, &[(68.0, 50.0), (65.5, 41.0)])];
    assert!(found(&back) > 0);
}

#[test]
fn a_stretch_has_its_length_and_its_place() {
    // 2 mm of blank along 40 mm, and then away at 45 degrees
    let lines = [line(1.0, &[(10.0, 50.0), (110.0, 50.0)]), line(1.0, &[(30.0, 53.0), (70.0, 53.0), (100.0, 83.0)])];
    let found = too_near(&lines, LEAST);
    assert_eq!(found.len(), 1, "{found:?}");
    let near = found[0];
    assert!((near.gap - 2.0).abs() < 1e-4, "{near:?}");
    // 1.2 mm further down at 45 degrees
    assert!((near.length - (40.0 + 1.185 * std::f32::consts::SQRT_2)).abs() < 0.05, "{near:?}");
}

#[test]
fn lines_that_join_may_be_near_beside_the_join_and_lines_that_run_along_may_not() {
    let across = line(1.0, &[(10.0, 50.0), (110.0, 50.0)]);
    for (other, are_near) in [
        (line(1.0, &[(60.0, 50.0), (60.0, 90.0)]), false),
        (line(1.0, &[(60.0, 20.0), (60.0, 90.0)]), false),
        (line(1.0, &[(60.0, 52.0), (60.0, 90.0)]), true),
        (line(1.0, &[(20.0, 50.0), (100.0, 58.0)]), true),
    ] {
        let found = too_near(&[across.clone(), other.clone()], LEAST);
        assert_eq!(!found.is_empty(), are_near, "{other:?}: {found:?}");
    }
}

#[test]
fn a_line_that_comes_back_is_too_near_to_itself_and_a_corner_is_not() {
    let hairpin = line(1.0, &[(10.0, 10.0), (60.0, 10.0), (60.0, 13.0), (10.0, 13.0)]);
    let found = too_near(&[hairpin], LEAST);
    assert!(found.len() == 1 && (found[0].gap - 2.0).abs() < 1e-3 && found[0].length > 35.0, "{found:?}");
    let corner = line(1.0, &[(10.0, 10.0), (60.0, 10.0), (20.0, 40.0)]);
    assert!(too_near(&[corner], LEAST).is_empty());
}
