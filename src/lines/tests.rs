//! What simplification may not do, on lines that wander at random: leave the tolerance, or let lines cross that did
//! not.

use super::outlines::Rank;
use super::vertex::{SPACING, Vertex};
use super::*;
use crate::geom::polyline::Polyline;
use crate::geom::{crossing, nearest_on_segment};
use crate::units::{MmPoint, MmVector};

const PARAMS: Params = Params::TEST;

/// Numbers in 0..1 that look random and are the same every time.
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as f32 / (1 << 24) as f32
    }
}

/// A square of 100 mm, in which lines are drawn.
pub(super) fn area() -> MmRect {
    MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0))
}

/// Lines of 10 to 70 mm from anywhere in a square of 100 mm, with bends down to a radius of about a millimetre.
fn wandering(seed: u32) -> Vec<Polyline<Vertex>> {
    let mut numbers = Numbers(seed);
    let mut polyline = || {
        let mut at = MmPoint::new(100.0 * numbers.next(), 100.0 * numbers.next());
        let (mut heading, mut bend) = (std::f32::consts::TAU * numbers.next(), 0.0);
        let (strength, fade) = (10.0 + 60.0 * numbers.next(), numbers.next() - 0.5);
        let vertices = (0..25 + (150.0 * numbers.next()) as usize).map(|i| {
            bend = 0.9 * bend + 0.25 * (numbers.next() - 0.5);
            heading += bend;
            at += MmVector::new(heading.cos(), heading.sin()) * SPACING;
            let strength = (strength + fade * i as f32).max(PARAMS.least_strength);
            Vertex { at, strength, contrast: [strength, 0.0, 0.0], ..Vertex::TEST }
        });
        Polyline::open(vertices.collect())
    };
    (0..40).map(|_| polyline()).collect()
}

fn cleared(seed: u32) -> Vec<clearance::Cleared> {
    let area = area();
    let mut polylines = wandering(seed);
    lead_on::extend(&mut polylines, area, PARAMS.join_gap);
    polylines.iter_mut().for_each(|polyline| weight::assign(polyline, &PARAMS));
    clear(polylines, area)
}

type Path = Vec<MmPoint>;

fn path(polyline: &Polyline<Vertex>) -> Path {
    polyline.path().map(|vertex| vertex.at).collect()
}

fn finished(lines: &[clearance::Cleared]) -> Vec<Path> {
    let line =
        |line: &clearance::Cleared| weight::finish(&line.polyline, &line.anchored, &PARAMS).expect("there is a line");
    lines
        .iter()
        .map(|l| line(l).runs.into_iter().flat_map(|run| run.polyline().path().copied().collect::<Path>()).collect())
        .collect()
}

/// How often two lines cross, not counting where one ends on the other.
fn crossings(a: &Path, b: &Path) -> usize {
    let tips = [a[0], a[a.len() - 1], b[0], b[b.len() - 1]];
    let pairs = a.windows(2).flat_map(|s| b.windows(2).map(move |t| (s, t)));
    let places = pairs.filter_map(|(s, t)| crossing((s[0], s[1]), (t[0], t[1])));
    places.filter(|at| tips.iter().all(|tip| (*tip - *at).length() > 2.0 * PARAMS.tolerance)).count()
}

fn own_crossings(line: &Path) -> usize {
    let segments: Vec<_> = line.windows(2).map(|s| (s[0], s[1])).collect();
    let later =
        |(i, s): (usize, &(MmPoint, MmPoint))| segments[i + 1..].iter().filter(|t| crossing(*s, **t).is_some()).count();
    segments.iter().enumerate().map(later).sum()
}

/// Clears lines of which none is an outline.
fn clear(polylines: Vec<Polyline<Vertex>>, area: MmRect) -> Vec<clearance::Cleared> {
    let ordinary = polylines.into_iter().map(|polyline| (polyline, Rank::Ordinary));
    clearance::tests::clear_all(ordinary.collect(), area, &PARAMS)
}

#[test]
fn simplified_lines_cross_no_more_than_before() {
    for seed in 0..60 {
        let lines = cleared(seed);
        let before: Vec<Path> = lines.iter().map(|line| path(&line.polyline)).collect();
        let after = finished(&lines);
        for i in 0..lines.len() {
            assert!(own_crossings(&after[i]) <= own_crossings(&before[i]), "seed {seed}: line {i} crosses itself");
            for j in 0..i {
                let (was, is) = (crossings(&before[i], &before[j]), crossings(&after[i], &after[j]));
                assert!(is <= was, "seed {seed}: lines {i} and {j} cross {is} times instead of {was}");
            }
        }
    }
}

#[test]
fn simplified_lines_lie_within_the_tolerance_both_ways_and_have_fewer_points() {
    let off = |from: &Path, to: &Path| {
        let between = from.windows(2).flat_map(|s| (0..=8).map(|k| s[0].lerp(s[1], k as f32 / 8.0)));
        let nearest = |at| to.windows(2).map(|s| nearest_on_segment(at, s[0], s[1]).0).fold(f32::MAX, f32::min);
        between.map(nearest).fold(0.0, f32::max)
    };
    let (mut points, mut left) = (0, 0);
    for seed in 100..110 {
        let lines = cleared(seed);
        for (line, after) in lines.iter().zip(finished(&lines)) {
            let before = path(&line.polyline);
            assert!(off(&before, &after) <= PARAMS.tolerance + 1e-3 && off(&after, &before) <= PARAMS.tolerance + 1e-3);
            points += before.len();
            left += after.len();
        }
    }
    assert!(left * 2 < points, "{left} of {points} points are left");
}

#[test]
fn two_lines_that_cross_steeply_both_stay_whole() {
    let straight = |from: MmPoint, to: MmPoint| {
        let tip = Vertex { at: from, strength: 50.0, contrast: [50.0, 0.0, 0.0], ..Vertex::TEST };
        let mut vertices = vec![tip];
        vertices.extend(lead_on::straight(&tip, to));
        Polyline::open(vertices)
    };
    let at = MmPoint::new;
    let mut polylines = vec![straight(at(10.0, 50.0), at(90.0, 50.0)), straight(at(40.0, 20.0), at(60.0, 75.0))];
    polylines.iter_mut().for_each(|polyline| weight::assign(polyline, &PARAMS));
    let area = area();
    let lines = clear(polylines.clone(), area);
    assert_eq!(lines.len(), 2);
    assert!(
        lines.iter().zip(&polylines).all(|(line, polyline)| (line.polyline.length() - polyline.length()).abs() < 0.1)
    );
    // the same two at 20 degrees: nearer than a finger can tell apart for 25 mm
    let mut flat = vec![straight(at(10.0, 50.0), at(90.0, 50.0)), straight(at(20.0, 40.0), at(75.0, 60.0))];
    flat.iter_mut().for_each(|polyline| weight::assign(polyline, &PARAMS));
    let lines = clear(flat, area);
    assert!((lines[0].polyline.length() - 80.0).abs() < 0.1 && lines.len() == 3, "{} lines", lines.len());
    assert!(lines[1..].iter().all(|line| line.polyline.length() < 25.0));
}
