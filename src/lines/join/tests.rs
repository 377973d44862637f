//! Tests of `join`.

use super::super::params::Params;
use super::super::tests::area;
use super::*;

fn straight(from: (f32, f32), to: (f32, f32), step: f32) -> Polyline<Vertex> {
    let [from, to] = [from, to].map(|(x, y)| MmPoint::new(x, y));
    let vertex = |k: u32| Vertex {
        at: from.lerp(to, k as f32 / 20.0),
        strength: 30.0,
        contrast: [step, 0.0, 0.0],
        ..Vertex::TEST
    };
    Polyline::open((0..=20).map(vertex).collect())
}

#[test]
fn pieces_of_a_straight_line_become_one_whichever_way_they_run() {
    let pieces = vec![straight((0., 0.), (8., 0.), 20.0), straight((18., 0.), (10., 0.), -20.0)];
    let joined = join(pieces, 3.0, &StandingEnds::default(), false);
    assert_eq!(joined.len(), 1);
    assert!((joined[0].length() - 18.0).abs() < 1e-3 && !joined[0].closed);
    assert!(joined[0].vertices.iter().all(|v| v.contrast[0] > 0.0), "the second piece was turned round");
    assert!(joined[0].segments().all(|(a, b)| (b.at - a.at).length() <= 0.51), "the gap is filled");
}

#[test]
fn what_has_other_colours_or_another_direction_stays_apart() {
    let other_colours = vec![straight((0., 0.), (8., 0.), 20.0), straight((10., 0.), (18., 0.), -20.0)];
    assert_eq!(join(other_colours, 3.0, &StandingEnds::default(), false).len(), 2);
    let aside = vec![straight((0., 0.), (8., 0.), 20.0), straight((8., 2.5), (8., 12.), 20.0)];
    assert_eq!(join(aside, 3.0, &StandingEnds::default(), false).len(), 2);
    let far = vec![straight((0., 0.), (8., 0.), 20.0), straight((11.5, 0.), (18., 0.), 20.0)];
    assert_eq!(join(far, 3.0, &StandingEnds::default(), false).len(), 2);
}

#[test]
fn the_top_of_a_bar_is_joined_to_its_sides_though_these_begin_right_below_it() {
    let path = |corners: &[(f32, f32)]| {
        let corner = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: 30.0,
            contrast: [20.0, 0.0, 0.0],
            ..Vertex::TEST
        };
        let sides = corners.windows(2).flat_map(|side| {
            let [from, to] = [corner(&side[0]), corner(&side[1])];
            let steps = ((to.at - from.at).length() / 0.2).ceil();
            (0..steps as u32).map(move |k| Vertex { at: from.at.lerp(to.at, k as f32 / steps), ..from })
        });
        Polyline::open(sides.chain(corners.last().map(corner)).collect())
    };
    let top = path(&[(0.0, 0.7), (0.0, 0.0), (12.0, 0.0), (12.0, 0.7)]);
    let bar = vec![top, path(&[(0.0, 20.0), (0.0, 1.7)]), path(&[(12.0, 1.7), (12.0, 20.0)])];
    let count = |mut lines: Vec<Polyline<Vertex>>, of_drawing: bool| {
        let standing = StandingEnds::of(&mut lines, area(), &Params { of_drawing, ..Params::TEST });
        join(lines, 3.0, &standing, of_drawing).len()
    };
    assert_eq!([true, false].map(|of_drawing| count(bar.clone(), of_drawing)), [1, 3]);
    let mut of_other_colours = bar;
    of_other_colours[0].vertices.iter_mut().for_each(|vertex| vertex.contrast[0] = -20.0);
    assert_eq!(count(of_other_colours, true), 3, "the colours lie the other way round");
}

#[test]
fn an_arc_whose_ends_meet_is_a_ring() {
    let angle = |k: u32| 0.1 + k as f32 * 6.1 / 100.0;
    let vertex = |k: u32| Vertex {
        at: MmPoint::new(10.0 * angle(k).cos(), 10.0 * angle(k).sin()),
        strength: 30.0,
        contrast: [20.0, 0.0, 0.0],
        ..Vertex::TEST
    };
    let joined = join(vec![Polyline::open((0..=100).map(vertex).collect())], 3.0, &StandingEnds::default(), false);
    assert!(joined.len() == 1 && joined[0].closed);
    assert!(joined[0].vertices.first() != joined[0].vertices.last());
}

/// As in a histogram: the tick was a part of the bar's side, and as short as it was.
#[test]
fn a_tick_is_no_part_of_what_ends_on_the_other_side_of_its_line() {
    let lines = || vec![straight((20., 50.), (20., 52.), 0.0), straight((20., 20.), (20., 50.), 0.0)];
    assert_eq!(join(lines(), 3.0, &StandingEnds::default(), true).len(), 1);
    assert_eq!(join_but_ticks(lines(), &[true, false], 3.0, &StandingEnds::default(), true).len(), 2);
}

/// How many lines are left of strokes between these places, and how many of them are rings, in a drawing with a line
/// across at 20 mm from the top.
fn lines_at_a_line(strokes: &[[(f32, f32); 2]]) -> [usize; 2] {
    let across = straight((10., 20.), (90., 20.), 0.0);
    let mut lines: Vec<_> = strokes.iter().map(|[from, to]| straight(*from, *to, 0.0)).chain([across]).collect();
    let standing = StandingEnds::of(&mut lines, area(), &Params { of_drawing: true, ..Params::TEST });
    let joined = join(lines, 3.0, &standing, true);
    [joined.len() - 1, joined.iter().filter(|line| line.closed).count()]
}

#[test]
fn strokes_that_lead_from_one_place_of_a_line_to_several_stay_lines_by_themselves() {
    let fan = [[(50., 20.), (30., 40.)], [(50., 20.), (70., 40.)], [(50., 20.), (50., 40.)]];
    assert_eq!(lines_at_a_line(&fan), [3, 0]);
    assert_eq!(lines_at_a_line(&fan[..2]), [2, 0]);
    let across = [[(50., 20.), (30., 40.)], [(50., 20.), (70., 4.)]];
    assert_eq!(lines_at_a_line(&across), [1, 0], "it crosses the line, and bends there");
    let short = [[(50., 20.), (46., 24.)], [(50., 20.), (54., 24.)]];
    assert_eq!(lines_at_a_line(&short), [1, 0], "a sign");
    let triangle = [[(50., 20.), (30., 40.)], [(30., 40.), (70., 40.)], [(70., 40.), (50., 20.)]];
    assert_eq!(lines_at_a_line(&triangle), [1, 1], "a triangle below the line");
}

/// The squares of the net of a cube as they are found, each without the sides that others have: the sides of three of
/// them close to a ring that comes to one corner twice.
#[test]
fn a_ring_that_touches_itself_is_several_lines() {
    let open = |corners: &[(f32, f32)]| {
        let sides = corners.windows(2).flat_map(|side| straight(side[0], side[1], 0.0).vertices);
        Polyline::open(sides.collect())
    };
    let square = |x: f32, y: f32| Polyline {
        closed: true,
        ..open(&[(x, y), (x + 20., y), (x + 20., y + 20.), (x, y + 20.), (x, y)])
    };
    let mut lines = vec![
        square(40., 20.),
        square(20., 40.),
        open(&[(60., 40.), (60., 60.), (40., 60.)]),
        open(&[(60., 40.), (80., 40.), (80., 60.), (60., 60.)]),
        open(&[(60., 60.), (60., 80.), (40., 80.), (40., 60.)]),
    ];
    let standing = StandingEnds::of(&mut lines, area(), &Params { of_drawing: true, ..Params::TEST });
    let joined = join(lines, 3.0, &standing, true);
    assert_eq!(joined.len(), 5);
    assert_eq!(joined.iter().filter(|line| line.closed).count(), 2);
}
