//! Tests of `lost_signs`.

use super::*;

#[test]
fn arrowheads_and_points_are_told_by_themselves() {
    let line = Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![MmPoint::zero(), MmPoint::new(50.0, 0.0)])] };
    let ring = |x: f32| MmRect::new(MmPoint::new(x, -2.0), MmPoint::new(x + 4.0, 2.0));
    assert!(is_at_end(std::slice::from_ref(&line), ring(49.0)));
    assert!(!is_at_end(&[line], ring(20.0)), "in the middle of the line");
    let sign = |x: f32, kind: SignKind| LostSign { at: MmPoint::new(x, 0.0), kind };
    let figure = Figure {
        place: MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)),
        source: crate::units::Size::new(100, 100),
        textures: Vec::new(),
        lines: Vec::new(),
    };
    let (head, point) = (SignKind::Arrowhead, SignKind::Point);
    let lost = [sign(50.0, head), sign(20.0, SignKind::Ring), sign(80.0, head), sign(60.0, point), sign(62.0, point)];
    let told: Vec<String> =
        told(&lost, &[], &Words::default(), &figure, None).iter().map(ToString::to_string).collect();
    assert_eq!(told.len(), 3);
    assert!(told[0].contains("1 small shape (at 20, 0 mm)"), "{}", told[0]);
    assert!(told[1].contains("2 points (at 60, 0; 62, 0 mm): they are too near to other points"), "{}", told[1]);
    assert!(told[2].contains("2 arrowheads at ends of lines (at 50, 0; 80, 0 mm)"), "{}", told[2]);
}

#[test]
fn a_lost_shape_is_told_by_the_text_whose_leader_line_ends_there() {
    let sign = |x: f32| LostSign { at: MmPoint::new(x, 50.0), kind: SignKind::Ring };
    let place = |x: f32| MmRect::new(MmPoint::new(x, 50.0), MmPoint::new(x + 20.0, 56.0));
    let all = [("anther", place(100.0)), ("petal", place(55.0))];
    let told = |signs: &[LostSign], tips: &[(&str, MmPoint)]| {
        told_of_shapes(signs, (&all, tips), true, None).map(|note| note.to_string()).unwrap_or_default()
    };
    let tip = [("anther", MmPoint::new(53.0, 48.0))];
    // "petal" stands nearer, and the line of "anther" ends there
    let one = told(&[sign(50.0)], &tip);
    assert!(one.contains("1 small shape (that of \"anther\"; at 50, 50 mm)"), "{one}");
    assert!(one.contains("so a label may name what is not felt"), "{one}");
    let beside = told(&[sign(50.0)], &[("anther", MmPoint::new(57.0, 48.0))]);
    assert!(beside.contains("(that beside \"petal\"; at 50, 50 mm)"), "{beside}");
    let both = told(&[sign(50.0), sign(98.0), sign(150.0)], &tip);
    let names = "3 small shapes (those of \"anther\"; those beside \"anther\"; the first at 50, 50 mm)";
    assert!(both.contains(names), "{both}");
    let none = told(&[sign(150.0)], &tip);
    assert!(none.contains("1 small shape (at 150, 50 mm)") && !none.contains("not felt"), "{none}");
}

#[test]
fn the_points_of_a_curve_are_told_as_such() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let line = |points: Vec<MmPoint>| Line { strength: 1.0, runs: vec![Run::stroke(1.0, points)] };
    let figure = Figure {
        place: MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)),
        source: crate::units::Size::new(100, 100),
        textures: Vec::new(),
        lines: vec![line(vec![at(10.0, 10.0), at(50.0, 50.0), at(90.0, 20.0)])],
    };
    let told = |places: &[MmPoint]| -> Vec<String> {
        let lost: Vec<LostSign> = places.iter().map(|&at| LostSign { at, kind: SignKind::Ring }).collect();
        told(&lost, &[], &Words::default(), &figure, None).iter().map(ToString::to_string).collect()
    };
    let curve = [at(10.0, 10.0), at(50.0, 49.0), at(90.0, 20.0)];
    let all = told(&[&curve[..], &[at(80.0, 80.0)]].concat());
    assert_eq!(all.len(), 2, "{all:?}");
    assert!(all[0].contains("1 small shape (at 80, 80 mm)"), "{all:?}");
    assert!(all[1].contains("3 points of lines (the first at 10, 10 mm)"), "{all:?}");
    // of triangles, too
    let sign = |at: MmPoint| LostSign { at, kind: SignKind::Series };
    let (of_lines, others) = points_of_lines(curve.iter().copied().map(sign).collect(), &figure.lines);
    assert_eq!((of_lines.len(), others.len()), (3, 0));
    let towns = told(&curve[..2]);
    assert!(towns.len() == 1 && towns[0].contains("2 small shapes"), "{towns:?}");
}

#[test]
fn each_name_beside_lost_shapes_is_told_once() {
    let mut names = vec!["C", "4", "C", "C", "4"];
    each_once(&mut names);
    assert_eq!(names, ["C", "4"]);
}

#[test]
fn a_ring_of_which_a_line_covers_a_piece_is_a_ring() {
    let arc = |turns: f32| -> Vec<MmPoint> {
        let at = |k: u32| (turns * std::f32::consts::TAU * k as f32 / 40.0).sin_cos();
        (0..=40).map(at).map(|(y, x)| MmPoint::new(20.0 + 2.0 * x, 20.0 + 2.0 * y)).collect()
    };
    assert!(is_nearly_closed(&arc(1.0)), "its ends lie in one place");
    assert!(is_nearly_closed(&arc(0.9)), "a town on a river");
    assert!(!is_nearly_closed(&arc(0.75)), "a letter C");
    let hairpin = [(0.0, 0.0), (9.0, 0.0), (9.0, 0.4), (0.0, 0.4)].map(MmPoint::from);
    assert!(!is_nearly_closed(&hairpin), "a line that turns back");
    assert!(!is_nearly_closed(&[]));
}

#[test]
fn many_lost_shapes_that_are_alike_are_a_series_if_none_is_drawn() {
    // (x, area, is_drawn) of shapes in boxes of 3 mm
    let kinds = |shapes: &[(f32, f32, bool)]| -> Vec<SignKind> {
        let shape = |&(x, area, is_drawn): &(f32, f32, bool)| {
            let ring = MmRect::new(MmPoint::new(x, 0.0), MmPoint::new(x + 3.0, 3.0));
            SmallShape { ring, area, is_drawn }
        };
        let small: Vec<SmallShape> = shapes.iter().map(shape).collect();
        let ring = |shape: &SmallShape| LostSign { at: shape.ring.center(), kind: SignKind::Ring };
        let mut lost: Vec<LostSign> = small.iter().filter(|shape| !shape.is_drawn).map(ring).collect();
        name_series(&mut lost, &small);
        lost.iter().map(|sign| sign.kind).collect()
    };
    let triangles = [10.0, 30.0, 50.0, 70.0].map(|x| (x, 4.5, false));
    assert_eq!(kinds(&triangles), [SignKind::Series; 4]);
    assert_eq!(kinds(&triangles[1..]), [SignKind::Ring; 3]);
    let with = |other: (f32, f32, bool)| kinds(&[&triangles[..], &[other]].concat());
    assert_eq!(with((90.0, 7.07, true)), [SignKind::Series; 4], "a disc is drawn");
    assert_eq!(with((90.0, 4.5, true)), [SignKind::Ring; 4], "one of them is drawn");
    assert_eq!(with((90.0, 9.0, false))[4], SignKind::Ring, "a square by itself");
    assert_eq!(kinds(&triangles.map(|(x, _, is_drawn)| (x, 7.07, is_drawn))), [SignKind::Ring; 4], "discs");
}

#[test]
fn a_series_is_told_as_such() {
    let lost: Vec<LostSign> =
        (1..=5).map(|k| LostSign { at: MmPoint::new(10.0 * k as f32, 50.0), kind: SignKind::Series }).collect();
    let told = told_of_shapes(&lost, (&[], &[]), true, None).map(|note| note.to_string()).unwrap_or_default();
    assert!(told.contains("all small shapes of a series, 5 or more (the first at 10, 50 mm): "), "{told}");
    assert!(told.contains("or draw them as round points"), "{told}");
}
