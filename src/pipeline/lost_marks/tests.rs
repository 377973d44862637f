//! Tests of `lost_marks`.

use super::*;

#[test]
fn marks_are_told_apart() {
    let arc = |degrees: f32| -> Vec<MmPoint> {
        let at = |i: u32| (degrees * i as f32 / 20.0).to_radians().sin_cos();
        (0..=20).map(at).map(|(y, x)| MmPoint::new(4.0 * x, 4.0 * y)).collect()
    };
    let line = |corners: &[(f32, f32)]| -> Vec<MmPoint> {
        let at = |i: usize| MmPoint::from(corners[i]);
        (1..corners.len()).flat_map(|i| (0..=8).map(move |k| at(i - 1).lerp(at(i), k as f32 / 8.0))).collect()
    };
    let is = |points: &[MmPoint], ends: [Option<OnLine>; 2]| {
        kind(points, PolylineRef { vertices: points, closed: false }.length(), (ends, None))
    };
    let (level, upright) = (MmVector::new(1.0, 0.0), MmVector::new(0.0, 1.0));
    let legs = [Some((0.2, level)), Some((0.2, upright))];
    let straight = line(&[(0.0, 0.0), (4.0, 0.0)]);
    assert_eq!(is(&straight, [Some((0.2, upright)), None]), Some(MarkKind::Tick));
    assert_eq!(is(&straight, [None, None]), None, "a dash");
    let crossed = |by: MmVector| kind(&straight, 4.0, ([None, None], Some((0.1, by))));
    assert_eq!((crossed(upright), crossed(level)), (Some(MarkKind::Tick), None), "across an axis, and along one");
    assert_eq!(is(&straight, [Some((0.2, upright)), Some((0.2, upright))]), None, "a piece of a gridline");
    assert_eq!(is(&straight, legs), None, "a piece of a slanting line");
    assert_eq!(is(&line(&[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0)]), legs), Some(MarkKind::Corner));
    let slanting = [legs[0], Some((0.2, MmVector::new(0.8, 0.6)))];
    assert_eq!(is(&line(&[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0)]), slanting), Some(MarkKind::Bend), "its legs are not");
    assert_eq!(is(&arc(145.0), legs), Some(MarkKind::Bend), "a piece of a ring");
    let leg = |degrees: f32| {
        let (y, x) = degrees.to_radians().sin_cos();
        Some((0.2, MmVector::new(x, y)))
    };
    assert_eq!(is(&arc(60.0), [leg(0.0), leg(60.0)]), Some(MarkKind::Arc));
    assert_eq!(is(&arc(120.0), [leg(0.0), leg(120.0)]), Some(MarkKind::Arc));
    assert_eq!(is(&arc(60.0), [leg(10.0), leg(50.0)]), Some(MarkKind::Arc), "not quite exact");
    assert_eq!(is(&arc(120.0), [leg(150.0), leg(30.0)]), None, "a petal on the ring of its flower");
    assert_eq!(is(&arc(60.0), [legs[0], None]), None, "a hook");
    let bent = line(&[(0.0, 0.0), (2.0, 0.0), (2.4, 0.4)]);
    assert_eq!(is(&bent, [Some((2.4, upright)), Some((0.0, upright))]), Some(MarkKind::Tick), "bent at its axis");
    assert_eq!(is(&arc(60.0), [Some((1.0, level)), Some((0.8, level))]), None, "a crumb beside a line");
}

#[test]
fn an_axis_is_not_the_tick_that_crosses_it() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let axis = crate::lines::Line {
        strength: 1.0,
        runs: vec![crate::lines::Run::stroke(1.0, vec![MmPoint::new(10.0, 50.0), MmPoint::new(90.0, 50.0)])],
    };
    let index = index_of_lines(&[axis], area, ENDS_ON);
    let tick = [MmPoint::new(40.0, 49.0), MmPoint::new(40.0, 50.0), MmPoint::new(40.0, 51.0)];
    assert!((0..3).all(|i| !is_along(&index, tick[i], direction_at(&tick, i))));
    let piece = [MmPoint::new(40.0, 50.5), MmPoint::new(41.0, 50.5)];
    assert!((0..2).all(|i| is_along(&index, piece[i], direction_at(&piece, i))));
}

#[test]
fn what_is_lost_is_counted() {
    let plan = Plan::new(&crate::profile::Profile::named("swell-a4").expect("it is built in")).expect("a plan");
    let marks = LostMarks { corners: 1, first: Some(MmPoint::new(20.0, 30.2)), ticks: 60, ..LostMarks::default() };
    let told = told_of_marks(&marks, None, &plan).expect("a note").to_string();
    let wanted = "left out: 60 short ticks and 1 mark of a right angle (the first at 20, 30 mm): marks \
                      shorter than 8 mm";
    assert!(told.starts_with(wanted), "{told}");
    assert_eq!(super::told(&Lost::default(), None, &plan), []);
    let of_overview = |marks: &LostMarks| told_not_in_overview(marks, &LostMarks::default());
    let in_overview = of_overview(&marks).expect("a note").to_string();
    let wanted = "1 mark of a right angle is in the figure only, as it is too short for fingers in the overview";
    assert_eq!(in_overview, wanted);
    assert_eq!(of_overview(&LostMarks { ticks: 60, ..LostMarks::default() }), None, "ticks are not told");
    let pieces = LostMarks { pieces: 2, ..marks };
    let all = listed(&pieces).expect("there are some");
    assert_eq!(all, "60 short ticks, 1 mark of a right angle and 2 pieces of small rings");
    assert_eq!(of_overview(&LostMarks { pieces: 2, ..LostMarks::default() }), None, "nor are pieces of rings");
    let scale = |lost: usize, every: usize| LostScale { ticks: 60, lost, every, first: MmPoint::new(20.0, 30.2) };
    let told = |lost: usize, every: usize| told_of_scale(&scale(lost, every), None).to_string();
    assert!(
        told(48, 5).contains("48 of the 60 ticks of a scale (the first at 20, 30 mm)")
            && told(48, 5).contains("every 5th")
    );
    let of_two = Lost { scales: vec![scale(60, 1), scale(60, 1), scale(2, 1)], ..Lost::default() };
    let of_two: Vec<String> = super::told(&of_two, None, &plan).iter().map(Note::to_string).collect();
    assert!(
        of_two.len() == 2 && of_two[0].contains("all 120 short lines on 2 lines") && of_two[1].contains("2 of the 60"),
        "{of_two:?}"
    );
    let all = "all 60 short lines on one line, such as the ticks of a scale (the first at 20, 30 mm)";
    assert!(told(60, 1).contains(all) && told(2, 1).contains("beside other lines"));
    assert!(told(1, 1).contains("such as the ticks of a scale (at 20, 30 mm)"), "{}", told(1, 1));
    let one = LostMarks { corners: 1, ticks: 0, ..marks };
    let one = told_of_marks(&one, None, &plan).expect("a note").to_string();
    assert!(one.starts_with("left out: 1 mark of a right angle (at 20, 30 mm): "), "{one}");
}

#[test]
fn a_tick_that_is_told_as_such_is_no_line_that_is_gone() {
    let of = |from: (f32, f32), to: (f32, f32)| MmRect::new(MmPoint::from(from), MmPoint::from(to));
    let ticks = [of((108.5, 40.0), (112.8, 40.0)), of((108.5, 43.0), (112.8, 43.0))];
    let gone = |extent: MmRect| LostLine { extent, length: 4.8, closed: false, is_faint: false, form: None };
    assert!(is_one_of(&gone(of((108.0, 43.0), (112.8, 43.0))), &ticks), "led on to the axis");
    assert!(!is_one_of(&gone(of((108.0, 46.0), (112.8, 46.0))), &ticks), "one beside them");
    assert!(!is_one_of(&gone(of((110.6, 37.6), (110.6, 42.4))), &ticks), "one across them");
    assert!(!is_one_of(&gone(of((108.0, 43.0), (122.8, 43.0))), &ticks), "a longer one");
}

#[test]
fn what_the_figure_lacks_too_is_not_said_to_be_in_the_figure_only() {
    let lost = |arcs: usize, corners: usize| LostMarks { arcs, corners, ..LostMarks::default() };
    assert_eq!(told_not_in_overview(&lost(2, 1), &lost(2, 1)), None);
    let told = told_not_in_overview(&lost(2, 1), &lost(1, 1)).expect("a note").to_string();
    assert!(told.starts_with("1 arc of an angle is in the figure only, as it is too short"), "{told}");
}

#[test]
fn short_strokes_beside_all_lines_are_marks_too() {
    let stroke = ChainKind { of_drawing: true, exact: true, stroke: Some(3.0), ..ChainKind::default() };
    let ray = [MmPoint::zero(), MmPoint::new(2.0, 0.0), MmPoint::new(4.0, 0.0)];
    let level = MmVector::new(1.0, 0.0);
    let free = ([None, None], None);
    assert!(is_other(&ray, stroke, free), "a ray of the sun");
    assert!(!is_other(&ray, ChainKind { exact: false, ..stroke }, free), "a crumb in a bitmap");
    assert!(!is_other(&ray, ChainKind { stroke: None, ..stroke }, free), "a piece of the outline of an area");
    let on_lines = [Some((0.2, level)), Some((0.2, level))];
    assert!(!is_other(&ray, stroke, (on_lines, None)), "a piece of a longer line");
    let chevron = [MmPoint::zero(), MmPoint::new(3.0, 2.0), MmPoint::new(0.0, 4.0)];
    let beside = [Some((2.0, level)), Some((2.0, level))];
    assert!(is_other(&chevron, stroke, (beside, Some((0.0, level)))), "a mark of parallel lines");
    let all = listed(&LostMarks { ticks: 3, strokes: 5, ..LostMarks::default() });
    assert_eq!(all.as_deref(), Some("3 short ticks and 5 other short lines"));
}

#[test]
fn one_stroke_on_a_line_is_no_tick() {
    let stroke = |x: f32, y: f32| [MmPoint::new(x, y - 1.5), MmPoint::new(x, y + 1.5)];
    let scale = [10.0, 20.0, 30.0, 40.0, 50.0].map(|x| stroke(x, 40.0));
    let told = |lost: &[[MmPoint; 2]], all: &[[MmPoint; 2]]| {
        listed(&with_ticks(LostMarks::default(), lost, || all.to_vec())).expect("there are some")
    };
    let alone = [1, 2, 3].map(|count| told(&scale[..count], &scale[..count]));
    assert_eq!(alone, ["1 short line", "2 short lines", "3 short ticks"]);
    assert_eq!(told(&scale[..2], &scale), "2 short ticks", "others of the scale are drawn");
    assert_eq!(told(&scale[..2], &scale[..4]), "2 short lines", "two batteries have four plates");
    let beside = [scale[0], stroke(20.0, 44.0)];
    assert_eq!(told(&beside, &scale), "1 short tick and 1 other short line", "it is not in the row");
    let along = [MmPoint::new(18.0, 40.0), MmPoint::new(22.0, 40.0)];
    assert_eq!(told(&[along], &scale), "1 short line");
    // of a dial, the hours longer
    let dial = |k: usize| {
        let (sin, cos) = (15.0 * k as f32).to_radians().sin_cos();
        let inner = if k.is_multiple_of(3) { 34.0 } else { 36.5 };
        [40.0, inner].map(|far| MmPoint::new(50.0 - far * cos, 50.0 - far * sin))
    };
    let dial: Vec<[MmPoint; 2]> = (0..13).map(dial).collect();
    assert_eq!(told(&dial[6..8], &dial), "2 short ticks", "of a sundial");
    assert_eq!(told(&dial[6..8], &dial[5..9]), "2 short lines", "four rays");
    let crossing = [MmPoint::new(50.0, 10.0), MmPoint::new(54.0, 13.0)];
    assert_eq!(told(&[crossing], &dial), "1 short line", "it points elsewhere");
}

#[test]
fn a_point_hides_the_tick_behind_it_and_not_the_one_beside_it() {
    let bead = MmRect::new(MmPoint::new(47.75, 37.75), MmPoint::new(52.25, 42.25));
    let cover = PointCover { rings: Vec::new(), beads: vec![bead] };
    let exact = ChainKind { of_drawing: true, exact: true, stroke: Some(3.0), ..ChainKind::default() };
    let tick = |x: f32| [38.5, 40.0, 41.5].map(|y| MmPoint::new(x, y));
    assert!(cover.hides(&tick(50.0), exact) && cover.hides(&tick(50.8), exact), "behind it");
    assert!(!cover.hides(&tick(52.7), exact), "beside it");
    assert!(cover.hides(&tick(52.7), ChainKind { exact: false, ..exact }), "a crumb in a bitmap");
    assert!(!cover.hides(&tick(54.0), exact), "apart from it");
    let arc = [MmPoint::new(52.0, 38.0), MmPoint::new(53.2, 40.0), MmPoint::new(52.0, 42.0)];
    assert!(cover.hides(&arc, exact), "no stroke but a piece of an outline");
}

/// As of a number line with a hollow point, of whose tick two short ends are seen.
#[test]
fn a_hollow_point_is_on_the_ends_of_its_tick_and_on_no_other() {
    let ring = MmRect::new(MmPoint::new(47.5, 37.5), MmPoint::new(52.5, 42.5));
    let cover = PointCover { rings: vec![ring], beads: Vec::new() };
    let is_on = |x: f32, from: f32, to: f32| cover.has_ring_on([MmPoint::new(x, from), MmPoint::new(x, to)]);
    assert!(is_on(50.0, 36.0, 37.3) && is_on(50.5, 44.0, 42.7), "above and below it");
    assert!(!is_on(52.5, 36.0, 37.3), "beside its middle");
    assert!(!is_on(50.0, 31.0, 34.0), "apart from it");
}

/// As in the sign of a lamp.
#[test]
fn two_short_strokes_in_a_small_ring_are_a_cross_and_one_is_a_tick_behind_a_point() {
    let circle = |k: u16| {
        let (y, x) = (30.0 * f32::from(k)).to_radians().sin_cos();
        MmPoint::new(40.0 + 3.0 * x, 50.0 + 3.0 * y)
    };
    let ring = Line { strength: 40.0, runs: vec![crate::lines::Run::stroke(1.5, (0..=12).map(circle).collect())] };
    let stroke = |from: (f32, f32), to: (f32, f32)| [MmPoint::from(from), MmPoint::from(to)];
    let cross = [stroke((38.0, 48.0), (42.0, 52.0)), stroke((38.0, 52.0), (42.0, 48.0))];
    let elsewhere = stroke((70.0, 48.0), (74.0, 52.0));
    let found = |strokes: &[[MmPoint; 2]]| strokes_of_crosses(strokes.to_vec(), std::slice::from_ref(&ring));
    assert_eq!(found(&[cross[0], elsewhere, cross[1]]), cross);
    assert!(found(&[cross[0], elsewhere]).is_empty(), "one stroke is no cross");
}
