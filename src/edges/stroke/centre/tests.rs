//! Tests of `centre`.

use super::*;

#[test]
fn changes_of_contrast_on_a_ring_do_not_depend_on_where_it_begins() {
    // 80 px round; without contrast over 20 of them, and over 5 others, which are too few
    let side = |k: usize| match (k / 20, (k % 20) as f32) {
        (0, along) => PxPoint::new(along, 0.0),
        (1, along) => PxPoint::new(20.0, along),
        (2, along) => PxPoint::new(20.0 - along, 20.0),
        (_, along) => PxPoint::new(0.0, 20.0 - along),
    };
    let is_stroke = |k: usize| !(30..50).contains(&k) && !(65..70).contains(&k);
    let none = StrokeContrast { height: 50.0, is_stroke: true, is_apart: false, ground: [0.0; 3], excess: [0.0; 3] };
    let of = |k: usize| StrokeContrast { is_stroke: is_stroke(k), ..none };
    for turn in 0..80 {
        let vertices = (0..80).map(|k| side((k + turn) % 80)).collect();
        let contrasts: Vec<StrokeContrast> = (0..80).map(|k| of((k + turn) % 80)).collect();
        let line = Polyline { vertices, closed: true };
        let found = changes(&line, &contrasts, 10.0, 5.0).into_iter().map(|i| (i + turn) % 80);
        let mut found: Vec<usize> = found.collect();
        found.sort_unstable();
        assert_eq!(found, [30, 50], "from vertex {turn}");
    }
}

#[test]
fn values_across_a_line_are_those_of_the_plane_in_whatever_order_they_are_asked_for() {
    let size = Size::new(12, 9);
    let plane = Plane { size, values: (0..size.len()).map(|i| (i * i % 11) as f32).collect() };
    let (at, across) = (PxPoint::new(6.3, 4.1), PxVector::new(0.6, -0.8));
    let mut steps = StepsAcross::new(&plane, at, across);
    for step in [-4, 0, 4, 7, 8, 9, 20, 8, -1, -8, -9, -17, -30, -9] {
        let place = at + across * (step as f32 * STEP);
        assert_eq!(steps.value(step).to_bits(), plane.at(place.x, place.y).to_bits(), "step {step}");
    }
}

#[test]
fn a_line_goes_straight_through_a_junction_unless_it_turns_before_or_behind_it() {
    // drawn aside by 2 px where another joins it, and led aslant from 5 px before or behind it on
    let line = |turns_before: bool, turns_behind: bool| {
        let at = |k: i16| {
            let far = (f32::from(k.abs()) - 5.0).max(0.0);
            let turns = if k < 0 { turns_before } else { turns_behind };
            let aside = if k.abs() <= 2 { 2.0 } else { 0.0 };
            let (along, turned) = (f32::from(k.abs().min(5)), std::f32::consts::FRAC_1_SQRT_2 * far);
            let (x, y) = if turns { (along + turned, turned) } else { (along + far, 0.0) };
            PxPoint::new(50.0 + f32::from(k.signum()) * x, 50.0 + y + aside)
        };
        Polyline::open((-20..=20).map(at).collect())
    };
    let through = |line: &Polyline<PxPoint>| through_junctions(line, &[PxPoint::new(50.0, 50.0)], 4.0);
    let straight = through(&line(false, false));
    let (middle, level) = (straight.vertices[20], straight.vertices.iter().all(|at| (at.y - 50.0).abs() < 1e-3));
    assert!(level && (middle.x - 50.0).abs() < 1e-3, "{straight:?}");
    assert!(straight.vertices.is_sorted_by(|a, b| a.x < b.x));
    for turning in [line(true, false), line(false, true), line(true, true)] {
        assert_eq!(through(&turning).vertices, turning.vertices);
    }
    // one that ends in the junction goes through nothing
    let ends = Polyline::open(line(false, false).vertices[..23].to_vec());
    assert_eq!(through(&ends).vertices, ends.vertices);
}

#[test]
fn the_tip_of_an_area_is_not_even_where_its_widths_were_cut_off() {
    // from 3.75 px to 21 px wide
    let (size, width) = (Size::new(70, 60), |x: f32| 3.75 + 17.25 * (x - 5.0) / 59.0);
    let value = |cell: usize| {
        let (x, y) = ((cell % 70) as f32 + 0.5, (cell / 70) as f32 + 0.5);
        100.0 * (0.5 * width(x) - (y - 30.0).abs() + 0.5).clamp(0.0, 1.0)
    };
    let plane = Plane { size, values: (0..size.len()).map(value).collect() };
    let line = Polyline::open((5..65).map(|x| PxPoint::new(x as f32, 30.0)).collect());
    let read = |reach: f32| -> Vec<CrossSection> {
        (0..line.vertices.len()).map(|i| profile(&line, i, &plane, reach)).collect()
    };
    let (whole, cut) = (read(13.0), read(7.7));
    assert!(whole.iter().all(|cross| !cross.is_cut) && cut.iter().any(|cross| cross.is_cut));
    assert!(is_even(&line, &cut, &plane, 7.7), "as far as they were read they seem even");
    assert!(!is_even(&line, &cut, &plane, 13.0) && !is_even(&line, &whole, &plane, 13.0));
}
