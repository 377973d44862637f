//! Tests of `stroke`.

use super::*;
use crate::edges::contour::testing::polyline;

const SIGMA: f32 = 1.8;

fn find(planes: &[Plane], noise: PixelNoise, params: &Params) -> Vec<Stroke> {
    super::find(planes, noise, params).strokes
}

fn stroke(points: &[(f32, f32)], closed: bool) -> Stroke {
    let mut contour = polyline(points);
    contour.closed = closed;
    Stroke { width: 2.0, whole: contour.length(), contour, is_dash: false, tint: None }
}

#[test]
fn a_bar_on_an_axis_leaves_its_base_to_the_axis_and_a_crossing_line_stays_whole() {
    let mut taken = StrokeCover::new(Size::new(200, 100));
    taken.add(&stroke(&[(5.0, 80.0), (195.0, 80.0)], false), SIGMA);
    let bar = stroke(&[(60.0, 80.0), (60.0, 20.0), (100.0, 20.0), (100.0, 80.0), (61.0, 80.0)], true);
    let parts = taken.beside(bar, false);
    let [open] = &parts[..] else { panic!("{} parts", parts.len()) };
    assert!(!open.contour.closed && (open.contour.length() - 160.0).abs() < 6.0, "{}", open.contour.length());
    let crossing = stroke(&[(150.0, 10.0), (150.0, 98.0)], false);
    assert!(matches!(&taken.beside(crossing, false)[..], [one] if (one.contour.length() - 88.0).abs() < 0.1));
}

#[test]
fn what_is_left_of_a_ring_does_not_depend_on_where_it_begins() {
    let mut taken = StrokeCover::new(Size::new(200, 100));
    // its base, over 40 px, is another's; a line crosses both its sides, over 7 px each
    taken.add(&stroke(&[(5.0, 80.0), (195.0, 80.0)], false), SIGMA);
    taken.add(&stroke(&[(5.0, 50.0), (195.0, 50.0)], false), SIGMA);
    let bar = stroke(&[(60.0, 80.0), (60.0, 20.0), (100.0, 20.0), (100.0, 80.0), (61.0, 80.0)], true);
    let lengths = |mut parts: Vec<Stroke>| {
        parts.sort_by(|a, b| a.contour.length().total_cmp(&b.contour.length()));
        parts.iter().map(|part| part.contour.length().round()).collect::<Vec<f32>>()
    };
    let (beside, rest) = (lengths(taken.beside(bar.clone(), false)), lengths(taken.rest_of(&bar, SIGMA)));
    assert!(beside == [156.0] && rest == [21.0, 21.0, 90.0], "{beside:?} {rest:?}");
    for turn in 0..bar.contour.vertices.len() {
        let mut turned = bar.clone();
        turned.contour.vertices.rotate_left(turn);
        assert_eq!(
            (lengths(taken.beside(turned.clone(), false)), lengths(taken.rest_of(&turned, SIGMA))),
            (beside.clone(), rest.clone()),
            "from vertex {turn}"
        );
    }
}
#[test]
fn a_short_stroke_counts_where_the_ground_is_the_same_on_both_sides() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 19.0, ..Params::default() };
    // 18 px long and 2 px wide
    let of = |below: f32| {
        let size = Size::new(80, 40);
        let value = |cell: usize| match (cell % 80, cell / 80) {
            (30..48, 20..22) => 40.0,
            (_, y) if y <= 20 => 100.0,
            _ => below,
        };
        let planes = [Plane { size, values: (0..size.len()).map(value).collect() }];
        let found = find(&planes, PixelNoise::default(), &params);
        found.iter().map(|stroke| stroke.contour.length().round()).collect::<Vec<f32>>()
    };
    assert!(matches!(of(100.0)[..], [one] if (one - 18.0).abs() <= 2.0), "{:?}", of(100.0));
    assert_eq!(of(70.0), [0.0; 0], "it is part of an edge");
}

#[test]
fn short_pieces_that_join_nothing_may_be_dashes() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 7.0, widest_stroke: 16.0, ..Params::default() };
    let size = Size::new(120, 40);
    // six of them, 7 px long and 2 px wide, and a dot
    let is_ink =
        |x: usize, y: usize| (20..22).contains(&y) && ((10..70).contains(&x) && x % 10 < 7 || (90..92).contains(&x));
    let value = |cell: usize| if is_ink(cell % 120, cell / 120) { 40.0 } else { 100.0 };
    let planes = [Plane { size, values: (0..size.len()).map(value).collect() }];
    let found = find(&planes, PixelNoise::default(), &params);
    assert!(found.len() == 6 && found.iter().all(|stroke| stroke.is_dash), "{} strokes", found.len());
    let lengths: Vec<f32> = found.iter().map(|stroke| stroke.contour.length()).collect();
    assert!(lengths.iter().all(|length| (length - 7.0).abs() <= 2.0), "{lengths:?}");
}

#[test]
fn two_strokes_of_different_tints_are_two_where_one_begins_at_the_end_of_the_other() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 19.0, ..Params::default() };
    let size = Size::new(220, 90);
    // a grey line that ends where a steeper one begins, both 2 px wide, on white
    let lengths = |second: [f32; 3]| {
        let lines = [([(20.0, 30.5), (110.0, 30.5)], [-30.0, 0.0, 0.0]), ([(110.0, 30.5), (180.0, 65.5)], second)];
        let value = |cell: usize, plane: usize| {
            let at = PxPoint::new((cell % 220) as f32 + 0.5, (cell / 220) as f32 + 0.5);
            let ground = if plane == 0 { 100.0 } else { 0.0 };
            lines.iter().fold(ground, |below, ([from, to], colour)| {
                let (from, to) = (PxPoint::new(from.0, from.1), PxPoint::new(to.0, to.1));
                let along = ((at - from).dot(to - from) / (to - from).square_length()).clamp(0.0, 1.0);
                let cover = (1.5 - (at - from.lerp(to, along)).length()).clamp(0.0, 1.0);
                let own = if plane == 0 { 100.0 + colour[0] } else { colour[plane] };
                below + cover * (own - below)
            })
        };
        let planes = [0, 1, 2].map(|plane| Plane { size, values: (0..size.len()).map(|i| value(i, plane)).collect() });
        let found = find(&planes, PixelNoise::default(), &params);
        let mut lengths: Vec<f32> = found.iter().map(|stroke| stroke.contour.length().round()).collect();
        lengths.sort_by(f32::total_cmp);
        lengths
    };
    let one = lengths([-50.0, 0.0, 0.0]);
    assert!(matches!(one[..], [all] if (all - 168.0).abs() < 8.0), "grey and black are one tint: {one:?}");
    let two = lengths([-50.0, -8.0, -80.0]);
    assert!(matches!(two[..], [blue, grey] if (blue - 78.0).abs() < 9.0 && (grey - 90.0).abs() < 9.0), "{two:?}");
}

#[test]
fn a_stroke_is_not_led_over_blank_ground_to_one_of_another_tint() {
    let size = Size::new(80, 40);
    // a blue line that ends at 40, or leads on to a grey one at 50
    let planes = |leads_on: bool| {
        let plane = |[blue, grey, ground]: [f32; 3]| {
            let value = |cell: usize| match (cell % 80, cell / 80) {
                (50, _) => grey,
                (x, 20) if x < 40 || leads_on && x < 50 => blue,
                _ => ground,
            };
            Plane { size, values: (0..size.len()).map(value).collect() }
        };
        [plane([50.0, 70.0, 100.0]), plane([-80.0, 0.0, 0.0])]
    };
    let [blue, grey] = [[-50.0, -80.0, 0.0], [-30.0, 0.0, 0.0]].map(|colour| Tint::of(colour).unwrap());
    let way = [PxPoint::new(40.0, 20.5), PxPoint::new(50.5, 20.5)];
    let leads = |own: Tint, leads_on: bool| may_lead([(1.0, own), (1.0, grey)], way, 1.5, &planes(leads_on));
    assert_eq!([leads(blue, false), leads(blue, true), leads(grey, false)], [false, true, true]);
}

#[test]
fn a_gridline_does_not_vanish_with_a_code_value_of_noise() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 19.0, ..Params::default() };
    // one of #eee on white, 2 px wide
    let size = Size::new(120, 40);
    let value = |cell: usize| if (20..22).contains(&(cell / 120)) { 94.1 } else { 100.0 };
    let planes = [Plane { size, values: (0..size.len()).map(value).collect() }];
    let count = |deviation: f32, is_lossy: bool| find(&planes, PixelNoise { deviation, is_lossy }, &params).len();
    // 1/255 of noise in every channel is 0.25
    assert_eq!([0.0, 0.12, 0.14, 0.25, 0.4].map(|deviation| count(deviation, false)), [1; 5]);
    assert_eq!(count(1.0, false), 0, "it may be noise");
    assert_eq!(count(0.3, true), 0, "it may be what rings beside a contour");
}

#[test]
fn short_broad_marks_on_a_line_are_strokes_where_several_are_alike() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 20.0, ..Params::default() };
    // 20 px long and 6 px wide, on a line that is 5 px wide
    let lengths = |marks: usize| {
        let size = Size::new(240, 60);
        let is_mark = |x: usize, y: usize| x / 40 < marks && (17..23).contains(&(x % 40)) && (22..42).contains(&y);
        let is_ink = |x: usize, y: usize| (17..22).contains(&y) && (4..236).contains(&x) || is_mark(x, y);
        let value = |cell: usize| if is_ink(cell % 240, cell / 240) { 0.0 } else { 100.0 };
        let planes = [Plane { size, values: (0..size.len()).map(value).collect() }];
        let found = find(&planes, PixelNoise::default(), &params);
        found.iter().map(|stroke| stroke.contour.length().round()).collect::<Vec<f32>>()
    };
    let five = lengths(5);
    let marks = five.iter().filter(|length| (18.0..=25.0).contains(*length)).count();
    assert!(five.len() == 6 && marks == 5, "{five:?}");
    assert!(lengths(2).len() == 1, "{:?}", lengths(2));
}

#[test]
fn many_marks_that_are_too_short_are_told() {
    let params =
        Params { sigma: SIGMA, low: 3.0, high: 7.0, min_length: 10.0, widest_stroke: 20.0, ..Params::default() };
    // 10 px long and 2 px wide, on a line that is 5 px wide
    let found = |marks: usize| {
        let size = Size::new(320, 60);
        let is_mark = |x: usize, y: usize| x / 20 < marks && (9..11).contains(&(x % 20)) && (22..32).contains(&y);
        let is_ink = |x: usize, y: usize| (17..22).contains(&y) && (4..316).contains(&x) || is_mark(x, y);
        let value = |cell: usize| if is_ink(cell % 320, cell / 320) { 0.0 } else { 100.0 };
        let planes = [Plane { size, values: (0..size.len()).map(value).collect() }];
        let found = super::find(&planes, PixelNoise::default(), &params);
        (found.strokes.len(), found.short_marks.is_some())
    };
    assert_eq!([found(15), found(3)], [(1, true), (1, false)]);
}
