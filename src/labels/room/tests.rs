//! Tests of `room`.

use super::*;
use crate::page::{Class, Glyph, Run, Shape, Sign};

fn params() -> Params {
    Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)))
}

fn room(points: &[(f32, f32)], closed: bool) -> Room {
    let points: Vec<MmPoint> = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    let line = Line { strength: 50.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] };
    Room::new(&[line], &[], &params())
}

#[test]
fn a_point_is_shut_in_by_a_ring_and_not_by_an_arc() {
    let ring = |count: u32| {
        let at = |i: u32| {
            let (sin, cos) = (TAU * i as f32 / 24.0).sin_cos();
            (50.0 + 5.0 * cos, 50.0 + 5.0 * sin)
        };
        (0..count).map(at).collect::<Vec<_>>()
    };
    let (whole, arc) = (room(&ring(24), true), room(&ring(18), false));
    let reach = whole.shut_in(MmPoint::new(50.0, 50.0), 12.0).expect("a ring is around it");
    assert!((reach - 4.2).abs() < 0.6, "{reach}");
    assert_eq!(whole.shut_in(MmPoint::new(50.0, 50.0), 3.0), None);
    assert_eq!(arc.shut_in(MmPoint::new(50.0, 50.0), 12.0), None);
}

#[test]
fn a_room_with_a_door_shuts_in_and_a_bay_does_not() {
    let walls = |gap: f32| {
        let from = [(50.0 - 0.5 * gap, 80.0), (20.0, 80.0), (20.0, 20.0), (80.0, 20.0), (80.0, 80.0)];
        room(&[&from[..], &[(50.0 + 0.5 * gap, 80.0)]].concat(), false)
    };
    let (middle, reach) = (MmPoint::new(50.0, 50.0), 90.0);
    assert!(walls(0.0).is_in_room(middle, reach) && walls(14.0).is_in_room(middle, reach));
    assert!(!walls(50.0).is_in_room(middle, reach) && !walls(14.0).is_in_room(MmPoint::new(90.0, 50.0), reach));
    assert!(!walls(0.0).is_in_room(middle, 20.0), "too far away");
}

#[test]
fn the_only_line_on_a_way_is_found() {
    let one = room(&[(50.0, 10.0), (50.0, 90.0)], false);
    let (from, to) = (MmPoint::new(20.0, 50.0), MmPoint::new(70.0, 50.0));
    let begin = one.only_line(from, to, 3.0).expect("it is between them");
    assert!((begin - 29.3).abs() < 0.6, "{begin}");
    assert_eq!(one.only_line(from, MmPoint::new(40.0, 50.0), 3.0), None);
    assert_eq!(room(&[(40.0, 10.0), (40.0, 90.0), (60.0, 90.0), (60.0, 10.0)], false).only_line(from, to, 3.0), None);
    assert_eq!(one.only_line(MmPoint::new(50.0, 20.0), MmPoint::new(50.0, 80.0), 3.0), None, "along it");
}

#[test]
fn a_line_comes_up_to_one_side_of_a_text() {
    let text = MmRect::new(MmPoint::new(40.0, 48.0), MmPoint::new(60.0, 52.0));
    let of = |points: &[(f32, f32)]| room(points, false).comes_up_to(text, 5.0);
    assert_eq!(of(&[(10.0, 50.0), (37.0, 51.0)]), Some(-1.0));
    assert_eq!(of(&[(62.0, 10.0), (62.0, 90.0)]), Some(1.0));
    assert_eq!(of(&[(10.0, 50.0), (30.0, 50.0)]), None, "too far");
    assert_eq!(of(&[(10.0, 55.0), (90.0, 55.0)]), None, "below");
    assert_eq!(of(&[(37.0, 50.0), (37.0, 70.0), (63.0, 70.0), (63.0, 50.0)]), None, "on both sides");
}

#[test]
fn a_text_on_a_grid_belongs_to_the_curve_beside_it() {
    let line = |y: f32, strength: f32| {
        let points = vec![MmPoint::new(10.0, y), MmPoint::new(90.0, y)];
        Line { strength, runs: vec![Run::stroke(1.0, points)] }
    };
    let text = MmRect::new(MmPoint::new(40.0, 38.0), MmPoint::new(60.0, 42.0));
    let beside = |lines: &[Line]| {
        let room = Room::new(lines, &[], &params());
        room.line_beside(text, 6.0, 12.0).map(|at| (at.y / 5.0).round() * 5.0)
    };
    let (grid, curve) = (line(45.0, 3.0), line(50.0, 100.0));
    assert_eq!(beside(&[grid.clone(), curve]), Some(50.0));
    assert_eq!(beside(&[grid.clone(), line(50.0, 80.0), line(45.0, 100.0)]), Some(45.0));
    assert_eq!(beside(&[grid.clone(), line(70.0, 100.0)]), Some(45.0), "no curve is near");
    assert_eq!(beside(&[line(50.0, 3.0)]), None, "too far for a text that stands on no grid");
}

#[test]
fn the_lower_side_of_a_shape_has_nothing_below_it() {
    let bar = room(&[(40.0, 20.0), (60.0, 20.0), (60.0, 70.0), (40.0, 70.0)], true);
    let is_low = |x: f32, y: f32| bar.is_at_lower_side(MmPoint::new(x, y), 6.0, 12.0);
    assert!(is_low(50.0, 70.0) && is_low(50.0, 73.0) && is_low(45.0, 71.0));
    assert!(!is_low(50.0, 20.0), "its inside is below it");
    assert!(!is_low(50.0, 64.0), "inside, with the lower side below");
    assert!(!is_low(50.0, 80.0), "too far below");
    assert!(!is_low(60.0, 40.0) && !is_low(30.0, 70.0), "at a side");
}

#[test]
fn dots_of_a_texture_cost_a_label_less_than_printed_signs() {
    let sign = |x: f32| Glyph { at: MmPoint::new(x, 50.0), shape: Shape::Dot { diameter: 1.5 } };
    let glyphs: Vec<Glyph> = (0..8).map(|number| sign(30.0 + 2.5 * number as f32)).collect();
    let texture = Texture { class: Class::Grey, sign: Sign::Dot, colour: [120; 3], area: 90.0, glyphs };
    let cost = |params: Params| {
        let room = Room::new(&[], std::slice::from_ref(&texture), &params);
        room.glyphs(MmRect::new(MmPoint::new(25.0, 45.0), MmPoint::new(55.0, 55.0)))
    };
    assert!((cost(params()) - 8.0).abs() < 0.01, "{}", cost(params()));
    // a row of dots stands for 4 mm, and a printed sign for 11.2 mm2
    let on_dots = |dot_pitch: f32| cost(Params { dot_pitch, ..params() });
    assert!((on_dots(1.4) - 4.0).abs() < 0.01, "{}", on_dots(1.4));
    assert!((on_dots(2.5) - 7.1).abs() < 0.1, "{}", on_dots(2.5));
}

#[test]
fn a_box_at_the_end_of_a_gridline_is_known() {
    let line = |[from, to]: [(f32, f32); 2], strength: f32| Line {
        strength,
        runs: vec![Run::stroke(1.0, vec![from.into(), to.into()])],
    };
    let level = |y: f32| line([(10.0, y), (90.0, y)], 3.0);
    let lines = [level(30.0), level(50.0), level(70.0), line([(10.0, 20.0), (10.0, 80.0)], 100.0)];
    let room = Room::new(&lines, &[], &params());
    let ends = |x: f32, y: f32| {
        let place = MmRect::new(MmPoint::new(x, y - 3.0), MmPoint::new(x + 14.0, y + 3.0));
        room.ends_gridline(place, 3.0, 12.0)
    };
    assert!(ends(16.0, 50.0), "too little of the line is left before the axis");
    assert!(!ends(40.0, 50.0), "it goes on on both sides");
    assert!(ends(70.0, 50.0), "at its other end");
    assert!(ends(16.0, 45.0) && !ends(70.0, 45.0), "above the left end, where its number stands");
    assert!(!ends(16.0, 40.0), "between two lines");
    assert!(room.is_gridline(MmPoint::new(50.0, 50.0)) && !room.is_gridline(MmPoint::new(10.0, 40.0)));
}

#[test]
fn a_room_hides_a_part_behind_its_furniture_and_a_box_or_a_sector_does_not() {
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 50.0, runs: vec![Run { closed: true, ..Run::stroke(1.0, points) }] }
    };
    let walls = line(&[(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)]);
    let table = line(&[(40.0, 60.0), (60.0, 60.0), (60.0, 75.0), (40.0, 75.0)]);
    let hides =
        |lines: &[Line], x: f32, y: f32| Room::new(lines, &[], &params()).hides_a_part(MmPoint::new(x, y), 90.0);
    assert!(hides(&[walls.clone(), table.clone()], 50.0, 40.0));
    assert!(!hides(&[walls.clone(), table], 50.0, 68.0), "the table is a box");
    assert!(!hides(std::slice::from_ref(&walls), 20.0, 80.0));
    let with_a_gap = [walls, line(&[(50.0, 10.0), (50.0, 45.0)]), line(&[(50.0, 55.0), (50.0, 90.0)])];
    assert!(!hides(&with_a_gap, 25.0, 50.0), "the other half is seen through a gap");
    assert!(!hides(&[line(&[(10.0, 46.0), (90.0, 46.0), (90.0, 54.0), (10.0, 54.0)])], 25.0, 50.0), "a long box");
    let arc = (0..=20_u32)
        .map(|k| (-0.5 + 0.05 * k as f32).sin_cos())
        .map(|(sin, cos)| (50.0 + 60.0 * sin, 90.0 - 60.0 * cos));
    let sector: Vec<(f32, f32)> = std::iter::once((50.0, 90.0)).chain(arc).collect();
    assert!(!hides(&[line(&sector)], 50.0, 40.0), "a sector");
}

#[test]
fn lines_that_a_leader_line_crosses_are_counted() {
    let bars = room(&[(20.0, 20.0), (20.0, 80.0), (40.0, 80.0), (40.0, 20.0), (60.0, 20.0), (60.0, 80.0)], false);
    let crossed = |to: f32, end: f32| bars.crossed(MmPoint::new(10.0, 50.0), MmPoint::new(to, 50.0), end);
    assert_eq!([crossed(15.0, 0.0), crossed(30.0, 0.0), crossed(50.0, 0.0), crossed(70.0, 0.0)], [0, 1, 2, 3]);
    assert_eq!(crossed(61.0, 4.0), 2, "where it ends it may");
}

#[test]
fn a_way_through_a_door_is_known() {
    let line = |points: &[(f32, f32)], closed: bool| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 50.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] }
    };
    let walls = line(&[(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)], true);
    // a door in the middle of a wall, one in the corner of a room, and a shelf
    let middle = [line(&[(50.0, 10.0), (50.0, 30.0)], false), line(&[(50.0, 42.0), (50.0, 90.0)], false)];
    let corner = line(&[(50.0, 60.0), (76.0, 60.0)], false);
    let shelf = line(&[(20.0, 82.0), (20.0, 76.0)], false);
    let curve = line(&[(80.0, 34.0), (70.0, 22.0)], false);
    let [first, second] = middle;
    let room = Room::new(&[walls, first, second, corner, shelf, curve], &[], &params());
    let leads = |from: (f32, f32), to: (f32, f32)| room.leads_through_door(from.into(), to.into());
    assert!(leads((30.0, 30.0), (70.0, 40.0)) && leads((70.0, 40.0), (30.0, 30.0)));
    assert!(leads((82.0, 50.0), (82.0, 70.0)), "between a wall and another one");
    assert!(!leads((30.0, 30.0), (48.0, 36.0)), "in front of the door");
    assert!(!leads((15.0, 79.0), (25.0, 90.0)), "behind a shelf, which is too short for a wall");
    assert!(!leads((60.0, 18.0), (70.0, 14.0)), "behind a curve");
    let is_in = |x: f32, y: f32| {
        let low = MmPoint::new(x, y);
        room.is_in_door(MmRect::new(low, low + MmVector::new(20.0, 6.0)))
    };
    assert!(is_in(40.0, 33.0) && !is_in(20.0, 33.0));
}

#[test]
fn where_a_wall_ends_at_another_is_no_door() {
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] }
    };
    let [level, upright] = [line(&[(10.0, 50.0), (90.0, 50.0)]), line(&[(50.0, 90.0), (50.0, 50.0)])];
    let beyond = line(&[(10.0, 38.0), (90.0, 38.0)]);
    let room = Room::new(&[level, upright, beyond], &[], &params());
    assert!(!room.leads_through_door(MmPoint::new(30.0, 44.0), MmPoint::new(70.0, 44.0)));
}
