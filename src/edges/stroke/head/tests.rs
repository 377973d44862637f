//! Tests of `head`: shafts lead along u from -25 to 10, where their tip is, turned by some degrees.

use super::*;
use crate::edges::contour::testing::polyline;
use crate::geom::nearest_on_segment;
use crate::units::Size;

const LEAST: f32 = 7.0;

/// Whether there is ink so far along the shaft and to its right, px.
type IsInk<'a> = &'a dyn Fn(f32, f32) -> bool;

fn place(turn: f32, [u, v]: [f32; 2]) -> PxPoint {
    let (sin, cos) = turn.to_radians().sin_cos();
    PxPoint::new(40.0 + cos * u - sin * v, 30.0 + sin * u + cos * v)
}

/// Black ink on white, 16 samples a pixel.
fn picture(turn: f32, is_ink: IsInk<'_>) -> Plane {
    let size = Size::new(80, 60);
    let (sin, cos) = turn.to_radians().sin_cos();
    let value = |cell: usize| {
        let samples = (0..16).filter(|k| {
            let x = (cell % 80) as f32 + 0.25 * (k % 4) as f32 + 0.125 - 40.0;
            let y = (cell / 80) as f32 + 0.25 * (k / 4) as f32 + 0.125 - 30.0;
            is_ink(cos * x + sin * y, cos * y - sin * x)
        });
        100.0 - samples.count() as f32 / 0.16
    };
    Plane { size, values: (0..size.len()).map(value).collect() }
}

/// The heads that a stroke as far as `to` shows.
fn found(turn: f32, to: f32, is_ink: IsInk<'_>) -> Vec<FilledHead> {
    found_in(&[0.0], turn, to, is_ink)
}

/// The same of strokes so far to the right of that, px.
fn found_in(rows: &[f32], turn: f32, to: f32, is_ink: IsInk<'_>) -> Vec<FilledHead> {
    let stroke = |right: &f32| {
        let ends = [[-25.0, *right], [to, *right]].map(|at| place(turn, at)).map(|at| (at.x, at.y));
        let contour = polyline(&ends);
        Stroke { width: 2.0, whole: contour.length(), contour, is_dash: false, tint: None }
    };
    let strokes: Vec<Stroke> = rows.iter().map(stroke).collect();
    filled_heads(&strokes, &[picture(turn, is_ink)], LEAST)
}

fn is_shaft(u: f32, v: f32) -> bool {
    (-25.0..=10.0).contains(&u) && v.abs() <= 1.0
}

fn is_head(u: f32, v: f32) -> bool {
    (-2.0..=10.0).contains(&u) && v.abs() <= 0.5 * (10.0 - u)
}

/// Whether a place is on a line that is 2 px wide.
fn is_on(u: f32, v: f32, [a, b]: [[f32; 2]; 2]) -> bool {
    let [at, a, b] = [[u, v], a, b].map(|[x, y]| PxPoint::new(x, y));
    nearest_on_segment(at, a, b).0 <= 1.0
}

#[test]
fn a_filled_head_is_found_with_its_tip_and_its_base() {
    let is_arrow = |u: f32, v: f32| is_shaft(u, v) || is_head(u, v);
    let upright = [[10.0, -22.0], [10.0, 22.0]];
    let aslant = [[-11.6, -10.4], [20.8, 5.2]];
    let cases: [(&str, IsInk<'_>); 3] = [
        ("nothing before it", &is_arrow),
        ("a wall", &|u, v| is_arrow(u, v) || is_on(u, v, upright)),
        ("a slanted wall", &|u, v| is_arrow(u, v) || is_on(u, v, aslant)),
    ];
    for (name, is_ink) in cases {
        for turn in [0.0, 20.0, 33.0, 90.0, 180.0] {
            let heads = found(turn, 10.0, is_ink);
            let [head] = heads[..] else { panic!("{name}, {turn}: {heads:?}") };
            let off =
                [(head.apex, [10.0, 0.0]), (head.base, [-2.0, 0.0])].map(|(at, of)| (at - place(turn, of)).length());
            assert!(off[0] < 1.4 && off[1] < 0.6, "{name}, {turn}: {off:?}");
            assert!((head.half_width - 6.0).abs() < 0.8 && (head.shaft - 2.0).abs() < 0.5, "{name}, {turn}: {head:?}");
            let is_right = match head.line {
                Some(line) => name == "a slanted wall" && (line + 7.0).abs() < 1.0,
                None => name != "a slanted wall",
            };
            assert!(is_right, "{name}, {turn}: {:?}", head.line);
        }
    }
}

#[test]
fn a_head_with_barbs_is_found_with_these() {
    let is_barbed = |u: f32, v: f32| is_shaft(u, v) || is_head(u, v) && (u >= 2.0 || v.abs() >= 1.5 * (2.0 - u));
    for turn in [0.0, 20.0, 90.0] {
        let heads = found(turn, 10.0, &is_barbed);
        let [head] = heads[..] else { panic!("{turn}: {heads:?}") };
        let off = [(head.apex, [10.0, 0.0]), (head.base, [-2.0, 0.0])].map(|(at, of)| (at - place(turn, of)).length());
        assert!(off[0] < 1.4 && off[1] < 2.0, "{turn}: {off:?}");
        assert!((head.half_width - 6.0).abs() < 1.5, "{turn}: {head:?}");
    }
}

#[test]
fn a_loose_triangle_beside_two_arrows_takes_no_head_from_them() {
    let count = |rows: &[f32]| {
        let is_arrow = |u: f32, v: f32| is_shaft(u, v) || is_head(u, v);
        let is_ink = |u: f32, v: f32| is_head(u, v) || rows.iter().any(|right| is_arrow(u, v - right));
        found_in(rows, 0.0, 10.0, &is_ink).len()
    };
    assert_eq!([count(&[-16.0, 16.0]), count(&[16.0])], [2, 0]);
}

#[test]
fn what_is_no_filled_head_is_none() {
    let upright = [[10.0, -22.0], [10.0, 22.0]];
    let is_wall = |u: f32, v: f32| is_shaft(u, v) || is_on(u, v, upright);
    let is_open = |u: f32, v: f32| [-7.0, 7.0].iter().any(|side| is_on(u, v, [[0.0, *side], [10.0, 0.0]]));
    let is_ray = |u: f32, v: f32| {
        let angles = [-0.6_f32, -0.4, -0.2, 0.2, 0.4, 0.6].into_iter();
        angles.map(f32::sin_cos).any(|(sin, cos)| is_on(u, v, [[10.0 - 30.0 * cos, 30.0 * sin], [10.0, 0.0]]))
    };
    let within = -2.0..=10.0;
    let bent = [[2.0, 0.0], [14.0, -24.0]];
    let cases: [(&str, IsInk<'_>); 11] = [
        ("an open head", &|u, v| is_wall(u, v) || is_open(u, v)),
        ("a disc", &|u, v| is_wall(u, v) || (u - 4.0).hypot(v) <= 6.0),
        ("a diamond", &|u, v| is_wall(u, v) || (u - 3.0).abs() + v.abs() <= 7.0),
        ("rays that meet", &|u, v| is_shaft(u, v) || is_ray(u, v)),
        ("a line across", &|u, v| is_wall(u, v) || is_on(u, v, [[0.0, -20.0], [0.0, 20.0]])),
        ("half a head", &|u, v| is_wall(u, v) || is_head(u, v) && v >= 0.0),
        ("a bar", &|u, v| is_wall(u, v) || within.contains(&u) && v.abs() <= 5.0),
        ("it points back", &|u, v| is_shaft(u, v) || within.contains(&u) && v.abs() <= 0.5 * (u + 2.0)),
        ("a sign where a curve bends", &|u, v| is_shaft(u, v) || is_head(u, v) || is_on(u, v, bent)),
        ("one of two signs", &|u, v| is_shaft(u, v) || is_head(u, v) || is_head(u, v + 20.0)),
        ("a sign within a line", &|u, v| is_head(u, v) || (-25.0..=35.0).contains(&u) && v.abs() <= 1.0),
    ];
    for (name, is_ink) in cases {
        for turn in [0.0, 20.0] {
            let to = if name == "a sign within a line" { 25.0 } else { 10.0 };
            let heads = found(turn, to, is_ink);
            assert!(heads.is_empty(), "{name}, {turn}: {heads:?}");
        }
    }
}
