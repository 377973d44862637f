//! Points of drawings: which small rings and discs are points, and how they are drawn.

use super::super::line::{HeavyStrokes, Line};
use super::super::lost::Lost;
use super::super::params::LineMedium;
use super::super::tests::area;
use super::super::vertex::{FoundIn, SPACING};
use super::drawn::LinePart;
use super::*;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

fn line(points: &[(f32, f32)], closed: bool, step: f32, source: FoundIn) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex {
        at: MmPoint::new(x, y),
        strength: 60.0,
        contrast: [step, 0.0, 0.0],
        width: PARAMS.width_max,
        source,
        ..Vertex::TEST
    };
    let mut line = Polyline { vertices: points.iter().map(vertex).collect(), closed };
    line.subdivide(SPACING);
    line
}

/// A part of a circle around a place, from one share of a turn to another.
fn arc(middle: (f32, f32), radius: f32, turns: (f32, f32)) -> Vec<(f32, f32)> {
    let turn = |k: u32| std::f32::consts::TAU * (turns.0 + (turns.1 - turns.0) * k as f32 / 40.0);
    (0..40).map(|k| (middle.0 + radius * turn(k).cos(), middle.1 + radius * turn(k).sin())).collect()
}

fn disc(x: f32, step: f32) -> Polyline<Vertex> {
    line(&arc((x, 50.0), 2.0, (0.0, 1.0)), true, step, FoundIn::Vector)
}

fn axis(from: f32, to: f32) -> Polyline<Vertex> {
    line(&[(from, 50.0), (to, 50.0)], false, 0.0, FoundIn::Vector)
}

#[test]
fn a_disc_between_two_ends_is_a_point_and_the_line_goes_on_to_its_middle() {
    let mut lines = vec![axis(10.0, 48.0), disc(50.0, 60.0), axis(52.0, 54.5), disc(56.5, 60.0), axis(58.5, 90.0)];
    let points = take(&mut lines, &PARAMS);
    assert!(points.len() == 2 && points.iter().all(|point| point.is_filled), "{points:?}");
    let length: f32 = lines.iter().map(Polyline::length).sum();
    assert!(lines.len() == 3 && (length - 80.0).abs() < 0.05, "{length}");
}

#[test]
fn what_lies_beside_a_line_or_is_pointed_at_or_is_no_disc_stays() {
    let triangle = line(&[(48.0, 48.0), (52.0, 50.0), (48.0, 52.0)], true, 60.0, FoundIn::Vector);
    let beside = line(&arc((50.0, 48.0), 2.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
    for ring in [triangle, beside, line(&arc((50.0, 50.0), 4.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector)] {
        let mut lines = vec![axis(10.0, 90.0), ring];
        assert!(take(&mut lines, &PARAMS).is_empty() && lines.len() == 2);
    }
    assert!(take(&mut vec![axis(10.0, 48.0), disc(50.0, 60.0)], &PARAMS).is_empty(), "pointed at");
}

#[test]
fn a_ring_at_which_one_line_ends_is_a_point_if_it_is_like_others_on_lines() {
    let node = |x: f32, radius: f32| line(&arc((x, 50.0), radius, (0.0, 1.0)), true, 0.0, FoundIn::Vector);
    let points = |leaf: f32| {
        let mut lines = vec![axis(10.0, 28.0), node(30.0, 2.0), axis(32.0, 70.0 - leaf), node(70.0, leaf)];
        let points = take(&mut lines, &PARAMS);
        let drawn = draw(&points, &lines.iter().filter(|line| !line.closed).collect::<Vec<_>>(), area(), &PARAMS);
        (points.len(), drawn.lost)
    };
    assert_eq!(points(2.0), (2, 0));
    assert_eq!(points(3.5), (1, 0), "a shape that the line points at");
}

#[test]
fn discs_on_lines_are_rings_where_others_beside_lines_are() {
    let away = |step: f32| line(&arc((60.0, 30.0), 2.0, (0.0, 1.0)), true, step, FoundIn::Vector);
    let taken = |others: &[Polyline<Vertex>]| {
        let mut lines = [&[axis(10.0, 90.0), disc(50.0, 60.0)], others].concat();
        let points = take(&mut lines, &PARAMS);
        points.iter().filter(|point| !point.is_alone).map(|point| point.is_filled).collect::<Vec<_>>()
    };
    assert_eq!(taken(&[]), [true]);
    assert_eq!(taken(&[away(60.0)]), [false], "towns of a map, of which one lies on a river");
    assert_eq!(taken(&[away(60.0), disc(70.0, 0.0)]), [true, false], "hollow points mean something else");
    assert_eq!(taken(&[line(&arc((60.0, 30.0), 2.7, (0.0, 1.0)), true, 60.0, FoundIn::Vector)]), [true]);
}

#[test]
fn a_filled_point_is_a_bead_and_a_hollow_one_a_ring_at_which_the_line_ends() {
    let mut lines = vec![axis(10.0, 90.0), disc(30.0, 60.0), disc(60.0, 0.0)];
    let points = take(&mut lines, &PARAMS);
    let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
    assert!(drawn.rings.len() == 1 && drawn.lost == 0);
    let count = lines[0].vertices.len();
    let parts = drawn.parts(0, &lines[0], &vec![false; count], &PARAMS);
    let [LinePart { polyline: before, anchored }, LinePart { polyline: after, .. }] = &parts[..] else {
        panic!("{} parts", parts.len())
    };
    let radius = 0.5 * PARAMS.max_spacing();
    assert!((before.length() - (50.0 - radius)).abs() < 0.02 && (after.length() - (30.0 - radius)).abs() < 0.02);
    let bead: Vec<f32> = before.vertices.iter().filter(|at| at.width > 4.0).map(|at| at.at.x).collect();
    assert!(matches!(bead[..], [a, b] if (a + b - 60.0).abs() < 0.15), "{bead:?}");
    assert_eq!(anchored.len(), before.vertices.len());
}

#[test]
fn of_a_tick_under_a_hollow_point_nothing_sticks_out() {
    let drawn = |length: f32| {
        let tick = line(&[(60.0, 50.0 - 0.5 * length), (60.0, 50.0 + 0.5 * length)], false, 0.0, FoundIn::Vector);
        let drawn = DrawnPoints { holes: vec![(MmPoint::new(60.0, 50.0), 2.5)], ..DrawnPoints::default() };
        drawn.parts(0, &tick, &vec![false; tick.vertices.len()], &PARAMS).len()
    };
    assert_eq!((drawn(8.0), drawn(40.0)), (0, 2));
}

/// Where a gridline from 10 to 90 mm is drawn beside a disc, in tenths of a mm.
fn pieces_beside(at: (f32, f32), radius: f32) -> Vec<[i32; 2]> {
    let gridline = line(&[(10.0, 50.0), (90.0, 50.0)], false, 0.0, FoundIn::FaintStroke);
    let discs = vec![(MmPoint::from(at), radius)];
    let drawn = DrawnPoints { discs, gaps: vec![PARAMS.min_gap], ..DrawnPoints::default() };
    let parts = drawn.parts(0, &gridline, &vec![false; gridline.vertices.len()], &PARAMS);
    let ends = |part: &LinePart| [0, part.polyline.vertices.len() - 1].map(|end| part.polyline.vertices[end].at.x);
    parts.iter().map(|part| ends(part).map(|x| (10.0 * x).round() as i32)).collect()
}

#[test]
fn a_faint_line_is_interrupted_beside_a_point_and_its_short_pieces_are_left_out() {
    let radius = 2.0;
    let off = radius + PARAMS.min_gap + 0.5 * PARAMS.width_min + PARAMS.play();
    let tenths = |x: f32| (10.0 * x).round() as i32;
    assert_eq!(pieces_beside((50.0, 50.0), radius), [[100, tenths(50.0 - off)], [tenths(50.0 + off), 900]]);
    assert_eq!(pieces_beside((50.0, 50.0 + off + 0.1), radius), [[100, 900]], "it is clear of the point");
    // its ends are as far apart as any where it would only touch
    let [[_, before], [behind, _]] = pieces_beside((50.0, 50.0 + off - 0.05), radius)[..] else { panic!("two pieces") };
    let apart = 0.1 * (behind - before) as f32;
    // to a vertex
    assert!((apart - PARAMS.clearance(PARAMS.width_min)).abs() < 2.0 * SPACING, "{apart}");
    let least = PARAMS.min_length;
    assert_eq!(pieces_beside((10.0 + off + 0.9 * least, 50.0), radius).len(), 1, "what is before it is too short");
    assert_eq!(pieces_beside((10.0 + off + 1.1 * least, 50.0), radius).len(), 2);
}

/// As in the sign of a lamp, whose cross is not drawn either.
#[test]
fn two_strokes_that_cross_in_a_hollow_point_are_told_and_others_are_ticks_behind_it() {
    let (at, radius) = (MmPoint::new(50.0, 50.0), 5.0);
    let drawn = DrawnPoints { holes: vec![(at, radius)], ..DrawnPoints::default() };
    let stroke = |from: (f32, f32), to: (f32, f32)| line(&[from, to], false, 0.0, FoundIn::Vector);
    let cross = [stroke((46.5, 46.5), (53.5, 53.5)), stroke((46.5, 53.5), (53.5, 46.5))];
    let wire = axis(10.0, 90.0);
    let lost_of = |lines: &[&Polyline<Vertex>]| {
        let mut lost = Lost::default();
        lost.add_crosses(&drawn.hidden(lines, &PARAMS), area(), &PARAMS);
        (lost.gone.len(), lost.lost.round())
    };
    assert_eq!(lost_of(&[&wire, &cross[0], &cross[1]]), (2, 20.0));
    assert_eq!(lost_of(&[&wire, &cross[0]]), (0, 0.0), "a tick behind a point");
    let beside = stroke((47.5, 46.5), (54.5, 53.5));
    assert_eq!(lost_of(&[&wire, &cross[0], &beside]), (0, 0.0), "two ticks side by side");
}

#[test]
fn a_line_that_sticks_out_of_a_hollow_point_is_as_long_as_a_line_or_leads_to_another() {
    let parts = |length: f32, beside: f32| {
        let mut lines = vec![axis(10.0, 50.0 + length), disc(50.0, 0.0)];
        let points = take(&mut lines, &PARAMS);
        let other = line(&[(beside, 20.0), (beside, 80.0)], false, 0.0, FoundIn::Vector);
        let drawn = draw(&points, &[&lines[0], &other], area(), &PARAMS);
        assert!(drawn.rings.len() == 1, "{drawn:?}");
        let parts = drawn.parts(0, &lines[0], &vec![false; lines[0].vertices.len()], &PARAMS);
        (parts.len(), drawn.stubs(&[&lines[0], &other], &PARAMS).len())
    };
    let least = 0.5 * PARAMS.max_spacing() + PARAMS.min_length;
    assert_eq!(parts(least + 1.0, 90.0), (2, 0));
    assert_eq!(parts(least - 1.0, 90.0), (1, 1));
    assert_eq!(parts(least - 1.0, 50.0 + least - 1.0), (2, 0), "from the point to another line");
}

#[test]
fn a_line_may_pass_through_a_point_twice_and_not_come_back_beside_it() {
    let lost = |end: (f32, f32)| {
        let back = line(
            &[(10.0, 50.0), (60.0, 50.0), (90.0, 50.0), (90.0, 90.0), (60.0, 90.0), end],
            false,
            0.0,
            FoundIn::Vector,
        );
        let mut lines = vec![back, disc(60.0, 0.0)];
        let points = take(&mut lines, &PARAMS);
        assert_eq!(points.len(), 1);
        draw(&points, &[&lines[0]], area(), &PARAMS).lost
    };
    assert_eq!(lost((60.0, 50.0)), 0, "both ways lead to its middle");
    assert_eq!(lost((60.0, 56.0)), 1, "the end is beside it");
}

#[test]
fn points_without_room_are_counted() {
    let mut lines = vec![axis(10.0, 90.0), disc(30.0, 60.0), disc(36.0, 60.0), disc(70.0, 60.0)];
    let points = take(&mut lines, &PARAMS);
    let beside = line(&[(60.0, 55.0), (80.0, 55.0)], false, 0.0, FoundIn::Vector);
    let drawn = draw(&points, &[&lines[0], &beside], area(), &PARAMS);
    // of two that are too near to one another the first is drawn
    assert!(points.len() == 3 && drawn.lost == 2 && drawn.beads.len() == 1, "{drawn:?}");
}

#[test]
fn points_beside_lines_are_drawn_like_those_on_them() {
    let beside = |y: f32| line(&arc((50.0, y), 2.0, (0.0, 1.0)), true, 0.0, FoundIn::Vector);
    let mut lines = vec![axis(10.0, 90.0), disc(30.0, 0.0), beside(70.0), beside(55.0)];
    let points = take(&mut lines, &PARAMS);
    assert!(points.len() == 3 && lines.len() == 1, "{points:?}");
    let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
    let lengths: Vec<f32> = drawn.rings.iter().map(Polyline::length).collect();
    let [on_line, beside] = lengths[..] else { panic!("one is too near to the axis: {lengths:?}") };
    assert!((on_line - beside).abs() < 0.01 && drawn.lost == 1);
    let on_dots = Params { medium: LineMedium::Dots(HeavyStrokes { from: 40.0, width: 2.5 }), ..PARAMS };
    let alone = line(&arc((50.0, 70.0), 1.8, (0.0, 1.0)), true, 0.0, FoundIn::Vector);
    let mut lines = vec![axis(10.0, 90.0), disc(30.0, 0.0), alone];
    assert_eq!((take(&mut lines, &on_dots).len(), lines.len()), (2, 1), "there it is a sign by itself");
}

#[test]
fn a_small_disc_by_itself_is_a_sign_and_dots_side_by_side_are_none() {
    let disc = |x: f32| line(&arc((x, 30.0), 0.8, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
    let points = take(&mut vec![axis(10.0, 90.0), disc(20.0), disc(60.0)], &PARAMS);
    assert!(points.len() == 2 && points.iter().all(|point| point.is_disc && point.is_alone), "{points:?}");
    assert!(take(&mut vec![axis(10.0, 90.0), disc(20.0), disc(24.0)], &PARAMS).is_empty());
}

#[test]
fn points_of_a_series_are_drawn_all_or_none() {
    let drawn = |xs: &[f32]| {
        let mut lines = vec![axis(5.0, 95.0)];
        lines.extend(xs.iter().map(|&x| disc(x, 60.0)));
        let points = take(&mut lines, &PARAMS);
        let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
        (drawn.beads.len(), drawn.lost)
    };
    assert_eq!(drawn(&[10.0, 25.0, 40.0, 55.0, 70.0]), (5, 0));
    assert_eq!(drawn(&[10.0, 15.0, 20.0, 25.0, 30.0]), (0, 5), "every second one would be a special one");
    assert_eq!(drawn(&[10.0, 15.0, 40.0]), (2, 1), "three are no series");
}

#[test]
fn a_point_has_room_where_a_line_that_goes_round_begins_and_ends() {
    let mut round = arc((50.0, 50.0), 25.0, (0.0, 1.0));
    round.push(round[0]);
    let round = line(&round, false, 0.0, FoundIn::Vector);
    let mut lines = vec![round, line(&arc((75.0, 50.0), 2.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector)];
    let points = take(&mut lines, &PARAMS);
    let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
    assert!(drawn.beads.len() == 1 && drawn.lost == 0, "{drawn:?}");
}

/// Discs of a cloud with these middles, and a line from left to right.
fn cloud(middles: &[(f32, f32)]) -> (Vec<Point>, DrawnPoints) {
    let mut lines = vec![axis(5.0, 95.0)];
    lines.extend(middles.iter().map(|&at| line(&arc(at, 1.3, (0.0, 1.0)), true, 60.0, FoundIn::Vector)));
    let points = take(&mut lines, &PARAMS);
    let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
    (points, drawn)
}

#[test]
fn many_discs_beside_lines_are_discs_at_their_own_places_and_so_are_those_on_a_line() {
    let middles = [(20.0, 20.0), (30.0, 30.0), (40.0, 25.0), (60.0, 70.0), (50.0, 50.0)];
    let (points, drawn) = cloud(&middles);
    assert!(points.len() == 5 && points.iter().all(|point| point.is_disc), "{points:?}");
    assert!(drawn.lost == 0 && drawn.beads.is_empty() && drawn.holes.is_empty(), "{drawn:?}");
    let lines: Vec<Line> = drawn
        .rings
        .iter()
        .filter_map(|ring| crate::lines::weight::finish(ring, &vec![false; ring.vertices.len()], &PARAMS))
        .collect();
    assert!(lines.len() == 5 && lines.iter().all(Line::is_disc), "their stroke fills them");
    assert!(cloud(&middles[..3]).0.is_empty(), "three are shapes by themselves");
    let on_dots = Params { medium: LineMedium::Dots(HeavyStrokes { from: 40.0, width: 2.5 }), ..PARAMS };
    let ring = |&at: &(f32, f32)| line(&arc(at, 1.3, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
    let on_dots = take(&mut middles[..4].iter().map(ring).collect(), &on_dots);
    assert!(on_dots.len() == 4 && on_dots.iter().all(|point| point.is_alone && point.is_filled), "{on_dots:?}");
    let dots = |&at: &(f32, f32)| line(&arc(at, 0.4, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
    assert!(take(&mut middles[..4].iter().map(dots).collect(), &PARAMS).is_empty(), "those of a dotted line");
}

#[test]
fn discs_in_pixels_are_a_cloud_if_they_are_circles_of_some_size_and_no_rings_with_two_edges() {
    let middles = [(20.0, 20.0), (30.0, 30.0), (40.0, 25.0), (60.0, 70.0)];
    type Outlines = Vec<Vec<(f32, f32)>>;
    let taken = |outlines: &dyn Fn((f32, f32)) -> Outlines| {
        let outlines = middles.iter().flat_map(|&at| outlines(at));
        let mut lines: Vec<_> = outlines.map(|points| line(&points, true, 60.0, FoundIn::Pixels)).collect();
        lines.push(axis(5.0, 95.0));
        let points = take(&mut lines, &PARAMS);
        assert!(points.iter().all(|point| point.is_disc), "{points:?}");
        points.len()
    };
    let round = |at: (f32, f32), radius: f32| arc(at, radius, (0.0, 1.0));
    assert_eq!(taken(&|at| vec![round(at, 1.3)]), 4);
    assert_eq!(taken(&|at| vec![round(at, 0.7)]), 0, "noise has such");
    assert_eq!(taken(&|at| vec![round(at, 1.9), round(at, 1.4)]), 0, "the two edges of a broad ring");
    let oval = |(x, y): (f32, f32)| round((0.0, 0.0), 1.0).into_iter().map(move |(a, b)| (x + 1.5 * a, y + 1.1 * b));
    assert_eq!(taken(&|at| vec![oval(at).collect()]), 0, "ovals");
}

#[test]
fn of_many_discs_in_pixels_those_with_another_outline_in_them_are_none() {
    let at = |k: usize| (8.0 + 12.0 * (k % 15) as f32, 8.0 + 12.0 * (k / 15) as f32);
    let ring = |at: (f32, f32), radius: f32| line(&arc(at, radius, (0.0, 1.0)), true, 60.0, FoundIn::Pixels);
    let mut lines: Vec<_> = (0..45).map(|k| ring(at(k), 1.3)).collect();
    lines.extend((0..45).step_by(7).map(|k| ring((at(k).0 + 0.6, at(k).1 - 0.6), 0.9)));
    lines.push(axis(5.0, 95.0));
    let points = take(&mut lines, &PARAMS);
    assert!(points.iter().all(|point| point.is_disc));
    assert_eq!((points.len(), lines.len()), (38, 15), "7 of 45 have another");
}

#[test]
fn a_disc_in_pixels_beside_a_line_is_none_and_where_many_are_there_is_no_cloud() {
    let taken = |middles: &[(f32, f32)]| {
        let rings = middles.iter().map(|&at| line(&arc(at, 1.3, (0.0, 1.0)), true, 60.0, FoundIn::Pixels));
        let mut lines: Vec<_> = rings.chain([axis(5.0, 95.0)]).collect();
        take(&mut lines, &PARAMS).len()
    };
    let apart = [(20.0, 20.0), (30.0, 30.0), (40.0, 25.0), (60.0, 70.0)];
    assert_eq!(taken(&[&apart[..], &[(80.0, 53.0)]].concat()), 4, "the axis is 1.7 mm beside the last");
    assert_eq!(taken(&[&apart[..], &[(80.0, 53.0), (70.0, 47.0)]].concat()), 0, "two of six");
}

#[test]
fn a_disc_is_moved_a_little_onto_a_line_or_off_it_and_one_too_near_to_another_is_told_with_its_place() {
    let far = [(20.0, 20.0), (30.0, 30.0), (40.0, 25.0)];
    let with = |other: &[(f32, f32)]| {
        let (_, drawn) = cloud(&[&far[..], other].concat());
        let beside: Vec<f32> = drawn.discs[3..].iter().map(|(at, _)| at.y - 50.0).collect();
        (beside, drawn.lost_discs)
    };
    let on = 0.5 * (2.0 + SOLID) * PARAMS.width_max;
    let (beside, lost) = with(&[(60.0, 50.0 + on + 0.4)]);
    assert!(lost.is_empty() && beside[0] < on && beside[0] > on - 0.4, "{beside:?}");
    let (beside, lost) = with(&[(60.0, 50.0 + on + 1.2)]);
    assert!(lost.is_empty() && (beside[0] - on - 0.5 * PARAMS.min_gap).abs() < 0.4, "{beside:?}");
    let (beside, lost) = with(&[(60.0, 70.0), (63.0, 70.0)]);
    assert!(beside.len() == 1 && matches!(lost[..], [at] if (at.x - 63.0).abs() < 0.01), "{lost:?}");
}

#[test]
fn a_line_that_ends_beside_a_point_makes_room_for_it() {
    let with = |y: f32| {
        let hop = line(&[(50.0, y), (58.0, 30.0), (80.0, 30.0)], false, 0.0, FoundIn::Vector);
        let mut lines = vec![axis(10.0, 90.0), disc(50.0, 60.0), hop];
        let points = take(&mut lines, &PARAMS);
        make_room(&points, &mut lines, &PARAMS);
        let drawn = draw(&points, &lines.iter().collect::<Vec<_>>(), area(), &PARAMS);
        (drawn.lost, lines.iter().map(|line| line.vertices[0].at.y).fold(f32::INFINITY, f32::min))
    };
    let (lost, end) = with(46.5);
    assert!(lost == 0 && (42.0..46.0).contains(&end), "{lost} lost, the line ends at {end}");
    assert_eq!(with(40.0), (0, 40.0), "far enough");
}

#[test]
fn a_disc_that_another_hides_in_part_is_one_of_a_cloud() {
    let whole = [(20.0, 20.0), (30.0, 30.0), (40.0, 25.0), (50.0, 20.0)];
    let taken = |turns: f32, count: usize| {
        let mut lines: Vec<Polyline<Vertex>> =
            whole[..count].iter().map(|&at| line(&arc(at, 1.3, (0.0, 1.0)), true, 60.0, FoundIn::Vector)).collect();
        lines.push(line(&arc((60.0, 60.0), 1.3, (0.0, turns)), false, 60.0, FoundIn::Vector));
        take(&mut lines, &PARAMS).iter().map(|point| point.at).collect::<Vec<_>>()
    };
    let found = taken(0.7, 4);
    assert!(matches!(found[..], [.., at] if found.len() == 5 && (at - MmPoint::new(60.0, 60.0)).length() < 0.05));
    assert_eq!(taken(0.3, 4).len(), 4, "an arc");
    assert!(taken(0.7, 3).is_empty());
}

/// A river that begins under the disc of a town: as large as it is the disc is a ring on fine dots, and the hidden
/// stretch was in its way; on pins it has no hollow, and is a point.
#[test]
fn on_dots_a_line_that_begins_under_a_large_disc_leaves_it_on_the_page() {
    for (pitch, points, length) in [(1.27, 0, 36.0), (2.5, 1, 40.0)] {
        let medium = LineMedium::Dots(HeavyStrokes { from: 40.0, width: pitch });
        for from in [10.0, 90.0] {
            let town = line(&arc((50.0, 50.0), 4.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
            let mut lines = vec![axis(from, 50.0), town];
            let taken = take(&mut lines, &Params { medium, ..PARAMS });
            assert_eq!((taken.len(), lines.len()), (points, 2 - points), "{pitch} mm");
            let end = lines[0].vertices.last().expect("a line").at;
            let off = (lines[0].length() - length).abs().max((end.y - 50.0).abs());
            assert!(off < 0.1 && (lines[0].vertices[0].at.x - from).abs() < 0.01, "{pitch} mm: {off}");
        }
    }
}
