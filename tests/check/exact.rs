//! Distances are exact: held against a search of all pairs in f64 on random pages.

use proptest::prelude::*;
use tactograph::Page;
use tactograph::internals::legibility::{check, too_near};
use tactograph::internals::page::{Line, Run};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::units::MmPoint;
use tactograph_tools::blanks;

/// Blank between lines that is asked for, mm.
const LEAST: f32 = 3.2;

/// The least blank between two lines, whatever their segments.
fn blank(a: &Line, b: &Line) -> f64 {
    blanks::least(&blanks::strokes(a), &blanks::strokes(b))
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
        let touch = |i: usize| lines[..i].iter().any(|other| blank(&lines[i], other) <= 0.01);
        // lines that touch join, and beside a join, also one of two others, other rules count
        prop_assume!(!(0..lines.len()).any(touch));
        for (i, a) in lines.iter().enumerate() {
            for (j, b) in lines[..i].iter().enumerate() {
                let blank = blank(a, b);
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

/// A page, and the blanks on it, mm.
type KnownPage = Result<(Page, Vec<f64>), tactograph::Error>;

/// All that a rule tells of random pages is off by less than 0.001 mm, and nothing is missed or made up.
fn is_exact(rule: &str, page: fn(u64) -> KnownPage) {
    let limits = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense").limits();
    let mut told = 0;
    for seed in 0..PAGES {
        let (page, known) = page(seed).expect("its marks lie on the sheet");
        let (count, off) = blanks::off(&check(&page, &limits, None), rule, known);
        assert!(off < 1e-3, "{rule}, page {seed}: {off} mm off");
        told += count;
    }
    assert!(told > 5 * PAGES as usize, "{rule}: only {told} were looked at");
}

/// Pages that are looked at: some tenths of a second's work.
const PAGES: u64 = 60;

#[test]
fn the_least_blank_between_textures_and_lines_is_exact() {
    is_exact("texture-gap", blanks::textures_beside_waves);
}

#[test]
fn the_least_blank_around_braille_is_exact() {
    is_exact("braille-gap", blanks::braille_beside_waves);
}

/// Of one line that comes back to itself places are compared every 0.25 mm: the nearest lies up to half of that aside,
/// and as a distance grows by no more than what one goes along, it is told up to 0.125 mm too large, and never too small.
#[test]
fn a_line_near_itself_is_told_less_than_an_eighth_of_a_millimetre_off() {
    let mut told = 0;
    for seed in 0..200 {
        let (line, blank) = blanks::there_and_back(seed);
        // strokes that touch join; and what is just short of the limit may lie between two places
        if blank < 0.01 || blank > f64::from(LEAST) - 0.15 {
            continue;
        }
        let near = too_near(&[line], LEAST).into_iter().map(|near| f64::from(near.gap)).fold(f64::MAX, f64::min);
        assert!((-1e-3..0.125).contains(&(near - blank)), "line {seed}: {near} in place of {blank}");
        told += 1;
    }
    assert!(told > 50, "only {told} were looked at");
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
