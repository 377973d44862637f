//! Tests of `ticks`.

use super::*;
use crate::lines::vertex::{FoundIn, SPACING};

pub(super) const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

pub(super) fn line(from: (f32, f32), to: (f32, f32)) -> Polyline<Vertex> {
    let vertex =
        |(x, y): (f32, f32)| Vertex { at: MmPoint::new(x, y), strength: 60.0, source: FoundIn::Vector, ..Vertex::TEST };
    let mut line = Polyline::open(vec![vertex(from), vertex(to)]);
    line.subdivide(SPACING);
    line
}

/// The lengths of ticks on an axis along y = 50, after they were made longer; `ticks` has their upper and lower
/// ends.
fn lengths(step: f32, ticks: &[(f32, f32)], more: Option<Polyline<Vertex>>) -> Vec<f32> {
    lengths_with(&[], step, ticks, more)
}

/// The same with points there.
fn lengths_with(points: &[MmPoint], step: f32, ticks: &[(f32, f32)], more: Option<Polyline<Vertex>>) -> Vec<f32> {
    let tick = |(k, &(from, to)): (usize, &(f32, f32))| {
        let x = 20.0 + step * k as f32;
        line((x, from), (x, to))
    };
    let mut lines: Vec<_> = ticks.iter().enumerate().map(tick).collect();
    lines.push(line((10.0, 50.0), (90.0, 50.0)));
    lines.extend(more);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    lengthen(&mut lines, points, area, &PARAMS);
    lines[..ticks.len()].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect()
}

#[test]
fn ticks_across_a_line_and_on_it_are_longer_by_the_same() {
    assert_eq!(lengths(10.0, &[(47.0, 53.0), (46.5, 53.5), (47.0, 53.0)], None), [8.2, 9.2, 8.2]);
    assert_eq!(lengths(10.0, &[(47.6, 49.4), (47.0, 49.4), (47.6, 49.4)], None), [8.2, 8.8, 8.2], "both ends are near");
    // those that end at the side of a broad line are led on to its middle
    assert_eq!(lengths(10.0, &[(45.0, 49.0), (43.0, 49.0), (45.0, 49.0)], None), [8.2, 10.2, 8.2]);
}

#[test]
fn all_of_a_scale_or_none() {
    let ticks = [(47.0, 53.0); 3];
    assert_eq!(lengths(4.0, &ticks, None), [6.0; 3], "too near to one another");
    assert_eq!(lengths(10.0, &ticks[..2], None), [6.0; 2], "no scale");
    let beside = line((35.0, 57.0), (60.0, 57.0));
    assert_eq!(lengths(10.0, &ticks, Some(beside.clone())), [6.0; 3], "one is in the way of a line");
    assert_eq!(lengths(10.0, &[(47.0, 53.0); 5], Some(beside)), [6.0; 5], "two are");
    let head = line((62.0, 53.0), (70.0, 57.0));
    assert_eq!(lengths(10.0, &[(47.0, 53.0); 5], Some(head)), [8.2, 8.2, 8.2, 8.2, 6.0], "the last one is");
    assert_eq!(lengths(10.0, &[(60.0, 66.0); 3], None), [6.0; 3], "on no line");
}

/// Five ticks below an axis along y = 50, then the axis, then the sides of bars that stand on it above each of them.
fn histogram() -> Vec<Polyline<Vertex>> {
    let below = |k: usize| (20.0 + 10.0 * k as f32, 50.0);
    let ticks = (0..5).map(|k| line(below(k), (below(k).0, 52.0)));
    let sides = (0..5).map(|k| line((below(k).0, 20.0), below(k)));
    ticks.chain([line((10.0, 50.0), (90.0, 50.0))]).chain(sides).collect()
}

#[test]
fn what_ends_on_the_axis_above_a_tick_is_not_in_its_way() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let lengths = |mut lines: Vec<Polyline<Vertex>>| -> Vec<f32> {
        lengthen(&mut lines, &[], area, &PARAMS);
        lines[..5].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect()
    };
    assert_eq!(lengths(histogram()), [8.2; 5]);
    let mut crossed = histogram();
    crossed.push(line((15.0, 56.0), (55.0, 56.0)));
    assert_eq!(lengths(crossed), [2.0; 5], "what is below the axis is");
}

#[test]
fn ticks_of_a_scale_are_so_many_of_one_length_whose_other_end_leads_to_nothing() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let count = |lines: &[Polyline<Vertex>]| of_scales(lines, area, &PARAMS).iter().filter(|is| **is).count();
    let lines = histogram();
    assert_eq!(of_scales(&lines, area, &PARAMS)[..6], [true, true, true, true, true, false]);
    assert_eq!((count(&lines), count(&lines[3..])), (5, 0), "two are no scale");
    let box_below = line((15.0, 52.0), (65.0, 52.0));
    assert_eq!(count(&[&lines[..], &[box_below]].concat()), 0, "they lead on to something");
}

#[test]
fn a_scale_is_drawn_without_the_few_ticks_that_have_no_room_and_those_at_points() {
    let beside = |from: f32, to: f32, y: f32| Some(line((from, y), (to, y)));
    let ticks = [(47.0, 53.0); 7];
    let one_lacks = lengths(10.0, &ticks, beside(45.0, 55.0, 43.0));
    assert_eq!(one_lacks, [8.2, 8.2, 8.2, 6.0, 8.2, 8.2, 8.2], "one of seven");
    assert_eq!(lengths(10.0, &ticks, beside(35.0, 55.0, 43.0)), [6.0; 7], "two of seven are too many");
    let at_points = [MmPoint::new(40.0, 50.0), MmPoint::new(50.0, 50.5)];
    let spared = lengths_with(&at_points, 10.0, &ticks, beside(35.0, 55.0, 43.0));
    assert_eq!(spared, [8.2, 8.2, 6.0, 6.0, 8.2, 8.2, 8.2], "points say where these are");
}

#[test]
fn ticks_grow_to_one_side_of_their_line_where_the_other_has_no_room() {
    let ticks: Vec<(f32, f32, f32)> = [20.0, 30.0, 40.0].map(|x| (x, 47.0, 53.0)).to_vec();
    let ends = |beside: f32| -> Vec<f32> {
        let mut lines: Vec<_> = ticks.iter().map(|&(x, from, to)| line((x, from), (x, to))).collect();
        lines.extend([line((10.0, 50.0), (90.0, 50.0)), line((10.0, beside), (90.0, beside))]);
        lengthen(&mut lines, &[], MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)), &PARAMS);
        let ends = |line: &Polyline<Vertex>| line.vertices.iter().map(|v| v.at.y).fold(f32::INFINITY, f32::min);
        lines[..3].iter().map(|line| (10.0 * ends(line)).round() / 10.0).collect()
    };
    assert_eq!(ends(70.0), [45.9; 3], "to both");
    assert_eq!(ends(58.2), [44.8; 3], "to the upper one");
    assert_eq!(ends(41.8), [47.0; 3], "to the lower one");
}

/// Where the ticks of an axis along y = 50 are that are drawn, and of those left out every how many-th is drawn and
/// how many they are.
fn drawn(step: f32, ticks: &[(f32, f32)]) -> (Vec<i32>, Option<(usize, usize, usize)>) {
    drawn_beside(step, ticks, None)
}

/// The same with another line there, longer than 20 mm.
fn drawn_beside(
    step: f32,
    ticks: &[(f32, f32)],
    more: Option<Polyline<Vertex>>,
) -> (Vec<i32>, Option<(usize, usize, usize)>) {
    let tick = |(k, &(from, to)): (usize, &(f32, f32))| {
        let x = 20.0 + step * k as f32;
        line((x, from), (x, to))
    };
    let mut lines: Vec<_> = ticks.iter().enumerate().map(tick).collect();
    lines.push(line((10.0, 50.0), (90.0, 50.0)));
    lines.extend(more);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let thinned = lengthen(&mut lines, &[], area, &PARAMS);
    let ticks = lines.iter().filter(|line| line.length() < 20.0);
    let at = ticks.map(|line| line.vertices[0].at.x.round() as i32).collect();
    (at, thinned.first().map(|scale| (scale.lost.every, scale.lost.lost, scale.left_out.len())))
}

#[test]
fn of_ticks_that_are_too_near_to_one_another_every_so_many_th_is_drawn() {
    let alike = [(47.0, 53.0); 9];
    assert_eq!(drawn(10.0, &alike[..6]), (vec![20, 30, 40, 50, 60, 70], None), "all have room");
    assert_eq!(drawn(4.0, &alike), (vec![20, 28, 36, 44, 52], Some((2, 4, 4))));
    let rule: Vec<(f32, f32)> = (0..21).map(|k| if k % 5 == 0 { (46.0, 54.0) } else { (47.0, 53.0) }).collect();
    assert_eq!(drawn(2.4, &rule), (vec![20, 32, 44, 56, 68], Some((5, 16, 16))), "the long ones");
}

#[test]
fn of_a_thinned_scale_ticks_without_room_are_left_out_and_counted() {
    let rule: Vec<(f32, f32)> = (0..21).map(|k| if k % 5 == 0 { (46.5, 53.5) } else { (47.5, 52.5) }).collect();
    let above = |to: f32| Some(line((44.0, 10.0), (44.0, to)));
    assert_eq!(drawn_beside(2.4, &rule, above(40.0)), (vec![20, 32, 44, 56, 68], Some((5, 16, 16))));
    assert_eq!(drawn_beside(2.4, &rule, above(44.5)), (vec![20, 32, 56, 68], Some((5, 17, 17))));
}

/// The face of a clock with ticks at its minutes, of which every so many-th is long, so far inside of its rim, mm.
fn clock(every: usize, inside: f32) -> Vec<Polyline<Vertex>> {
    let at = |k: usize, radius: f32| {
        let (sin, cos) = (k as f32 / 60.0 * std::f32::consts::TAU).sin_cos();
        (50.0 + radius * sin, 50.0 - radius * cos)
    };
    let mut rim = line(at(0, 40.0), at(1, 40.0));
    (1..60).for_each(|k| rim.vertices.extend(line(at(k, 40.0), at(k + 1, 40.0)).vertices.into_iter().skip(1)));
    rim.vertices.pop();
    rim.closed = true;
    let inner = |k: usize| if k.is_multiple_of(every) { 33.0 } else { 35.5 };
    let mut lines: Vec<_> = (0..60).map(|k| line(at(k, 40.0 - inside), at(k, inner(k) - inside))).collect();
    lines.push(rim);
    lines
}

const AREA: MmRect = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(100.0, 100.0));

#[test]
fn a_scale_that_goes_round_is_thinned_only_if_some_of_its_ticks_are_long() {
    let left = |every: usize, inside: f32| {
        let mut lines = clock(every, inside);
        let thinned = lengthen(&mut lines, &[], AREA, &PARAMS);
        let told: Vec<(usize, usize)> = thinned.iter().map(|scale| (scale.lost.every, scale.lost.lost)).collect();
        (told, lines.len())
    };
    assert_eq!(left(5, 0.0), (vec![(5, 48)], 13), "the hours");
    assert_eq!(left(1, 0.0), (Vec::new(), 61), "where all are alike nothing says at which one to begin");
    assert_eq!(left(5, 3.0), (vec![(5, 48)], 13), "the hours well inside of the rim");
    assert_eq!(left(5, 6.0), (Vec::new(), 61), "so far inside they are lines by themselves");
}

#[test]
fn ticks_well_inside_of_a_rim_are_led_on_to_it_and_handed_on_as_those_on_it_are() {
    let mut lines = clock(5, 3.0);
    lengthen(&mut lines, &[], AREA, &PARAMS);
    let far = |at: MmPoint| (at - MmPoint::new(50.0, 50.0)).length();
    let outer = |line: &Polyline<Vertex>| line.vertices.iter().map(|vertex| far(vertex.at)).fold(0.0, f32::max);
    assert!(lines[..12].iter().all(|tick| (outer(tick) - 40.0).abs() < 0.05));
    let scales = take(&mut clock(5, 3.0), AREA, &PARAMS);
    assert_eq!(scales.iter().map(Vec::len).collect::<Vec<_>>(), [60]);
    assert!(scales[0].iter().all(|tick| (far(tick.at) - 40.0).abs() < 0.1));
}

#[test]
fn a_pointer_on_the_rim_leaves_the_ticks_inside_of_it_a_scale() {
    let with_pointer = || {
        let mut lines = clock(5, 3.0);
        lines.push(line((90.0, 50.0), (96.0, 50.0)));
        lines
    };
    let mut lines = with_pointer();
    let thinned = lengthen(&mut lines, &[], AREA, &PARAMS);
    assert_eq!(thinned.iter().map(|scale| scale.lost.every).collect::<Vec<_>>(), [5]);
    assert_eq!(lines.len(), 14, "the hours, the rim and the pointer");
    assert_eq!(take(&mut with_pointer(), AREA, &PARAMS).iter().map(Vec::len).collect::<Vec<_>>(), [60]);
}

#[test]
fn ticks_beside_a_tube_are_in_order_wherever_its_outline_begins() {
    let mut tube = line((50.0, 50.0), (50.0, 90.0));
    for to in [(40.0, 90.0), (40.0, 10.0), (50.0, 10.0), (50.0, 50.0)] {
        let from = tube.vertices[tube.vertices.len() - 1].at;
        tube.vertices.extend(line((from.x, from.y), to).vertices.into_iter().skip(1));
    }
    tube.vertices.pop();
    tube.closed = true;
    let mut lines: Vec<_> = (0..15).map(|k| 20.0 + 4.0 * k as f32).map(|y| line((50.0, y), (54.0, y))).collect();
    lines.push(tube);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let thinned = lengthen(&mut lines, &[], area, &PARAMS);
    let left: Vec<(usize, usize)> = thinned.iter().map(|scale| (scale.lost.every, scale.lost.lost)).collect();
    assert_eq!((left, lines.len()), (vec![(2, 7)], 9));
    assert!(lines[..8].iter().all(|tick| (tick.length() - 8.2).abs() < 0.01));
}

#[test]
fn ticks_of_a_scale_are_taken_in_order_and_those_parted_by_a_point_are_one() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let mut lines = vec![
        line((60.0, 47.0), (60.0, 53.0)),
        line((20.0, 47.0), (20.0, 53.0)),
        // two halves of one, on both sides of the axis
        line((40.0, 47.0), (40.0, 50.0)),
        line((40.0, 53.0), (40.0, 50.0)),
        line((10.0, 50.0), (90.0, 50.0)),
    ];
    // the side of a box ends on another line
    lines.extend([line((70.0, 44.0), (70.0, 50.0)), line((65.0, 44.0), (78.0, 44.0))]);
    let scales = take(&mut lines, area, &PARAMS);
    let [scale] = &scales[..] else { panic!("{scales:?}") };
    let ticks: Vec<(f32, f32)> = scale.iter().map(|tick| (tick.at.x, tick.length())).collect();
    assert_eq!(ticks, [(20.0, 6.0), (40.0, 6.0), (60.0, 6.0)]);
    assert!(scale.iter().all(|tick| tick.ends[0].is_some_and(|end| end.y < 50.0)), "the same side is the left one");
    assert_eq!(lines.len(), 3, "the axis and the box");
}

#[test]
fn of_a_logarithmic_scale_all_ticks_are_tried_then_the_long_ones() {
    // three decades of 20 mm
    let scale = |is_long: fn(usize) -> bool| -> Vec<TickMark> {
        let at = |k: usize| 10.0 + 20.0 * ((k / 9) as f32 + ((k % 9 + 1) as f32).log10());
        let tick = |k: usize| TickMark {
            at: MmPoint::new(at(k), 50.0),
            along: MmVector::new(1.0, 0.0),
            ends: [None, Some(MmPoint::new(at(k), if is_long(k) { 51.0 } else { 50.6 }))],
        };
        (0..28).map(tick).collect()
    };
    let all = (1, (0..28).collect::<Vec<usize>>());
    assert_eq!(tick_selections(&scale(|k| k % 9 == 0)), [all.clone(), (9, vec![0, 9, 18, 27])]);
    assert_eq!(tick_selections(&scale(|_| false)), std::slice::from_ref(&all), "none is long");
    assert_eq!(tick_selections(&scale(|k| k % 9 == 0 && k != 9)), [all], "the long ones are uneven, too");
}

#[test]
fn ticks_of_each_side_of_a_frame_are_a_scale_where_all_have_no_room() {
    let ring = |corners: &[(f32, f32)]| {
        let mut ring = line(corners[0], corners[1]);
        for pair in corners[1..].windows(2) {
            ring.vertices.extend(line(pair[0], pair[1]).vertices.into_iter().skip(1));
        }
        ring.closed = true;
        ring
    };
    // below the frame ticks with room, on its left such that are too near to one another
    let below = [30.0, 45.0, 60.0, 75.0].map(|x| line((x, 80.0), (x, 82.0)));
    let left = [30.0, 32.5, 36.0, 38.5, 70.0].map(|y| line((18.0, y), (20.0, y)));
    let mut lines: Vec<_> = below.into_iter().chain(left).collect();
    lines.push(ring(&[(20.0, 20.0), (90.0, 20.0), (90.0, 80.0), (20.0, 80.0), (20.0, 22.0)]));
    lengthen(&mut lines, &[], MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)), &PARAMS);
    let lengths: Vec<f32> = lines[..9].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect();
    assert_eq!(lengths, [8.2, 8.2, 8.2, 8.2, 2.0, 2.0, 2.0, 2.0, 2.0]);
}
