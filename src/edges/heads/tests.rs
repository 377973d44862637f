//! Tests of `heads`.

use super::*;
use crate::edges::contour::testing::polyline;
use crate::units::Size;

/// A head that points to the right, at a wall that stands at 50 px.
const HEAD: FilledHead = FilledHead {
    apex: PxPoint::new(50.0, 30.0),
    base: PxPoint::new(38.0, 30.0),
    half_width: 6.0,
    shaft: 2.0,
    ground: [100.0, 0.0, 0.0],
    ink: [-100.0, 0.0, 0.0],
    line: None,
};

/// A shaft, the head, and what it points at, with 16 samples a pixel.
fn picture(with_head: bool, is_pointed_at: &dyn Fn(f32, f32) -> bool) -> Plane {
    let size = Size::new(80, 60);
    let value = |cell: usize| {
        let samples = (0..16).filter(|k| {
            let x = (cell % 80) as f32 + 0.25 * (k % 4) as f32 + 0.125;
            let y = (cell / 80) as f32 + 0.25 * (k / 4) as f32 + 0.125;
            let is_shaft = (10.0..=50.0).contains(&x) && (y - 30.0).abs() <= 1.0;
            let is_head = (38.0..=50.0).contains(&x) && (y - 30.0).abs() <= 0.5 * (50.0 - x);
            is_shaft || with_head && is_head || is_pointed_at(x, y)
        });
        100.0 - samples.count() as f32 / 0.16
    };
    Plane { size, values: (0..size.len()).map(value).collect() }
}

/// Whether a place is dark.
type Shape<'a> = &'a dyn Fn(f32, f32) -> bool;

#[test]
fn without_its_head_a_shaft_leads_up_to_what_the_arrow_points_at() {
    let upright = |x: f32, y: f32| (x - 50.0).abs() <= 1.0 && (8.0..=52.0).contains(&y);
    // at 25.8 degrees, along one side of the head
    let from = |x: f32| 30.0 + 0.483 * (x - 50.0);
    let aslant = |x: f32, y: f32| (y - from(x)).abs() <= 1.1 && (28.0..=60.0).contains(&x);
    let cases: [(FilledHead, Shape<'_>, usize); 2] =
        [(HEAD, &upright, 2), (FilledHead { line: Some(-7.0), ..HEAD }, &aslant, 12)];
    for (head, pointed_at, most) in cases {
        let (mut planes, without) = ([picture(true, pointed_at)], picture(false, pointed_at));
        let other = |plane: &Plane| {
            let pairs = plane.values.iter().zip(&without.values);
            pairs.filter(|(a, b)| (*a - *b).abs() > 50.0).count()
        };
        let before = other(&planes[0]);
        take_out(&[head], &mut planes);
        let after = other(&planes[0]);
        assert!(before >= 30 && after <= most, "{before} {after}");
    }
}

#[test]
fn edges_around_a_head_are_its_own_and_those_of_what_it_points_at_are_not() {
    let has = |x: f32, y: f32| HEAD.has_edge(PxPoint::new(x, y), 1.5);
    assert!(has(37.0, 34.0) && has(44.0, 33.5) && has(38.5, 24.0));
    assert!(!has(50.0, 30.5) && !has(50.0, 40.0) && !has(30.0, 31.0) && !has(44.0, 40.0));
}

#[test]
fn heads_found_by_place_are_all_that_have_an_edge_there() {
    let head = |number: usize| {
        let apex = PxPoint::new(20.0 + 27.0 * (number % 4) as f32, 20.0 + 31.0 * (number / 4) as f32);
        let (y, x) = (number as f32).sin_cos();
        FilledHead { apex, base: apex - PxVector::new(x, y) * 12.0, ..HEAD }
    };
    let heads: Vec<FilledHead> = (0..12).map(head).collect();
    let edges = EdgesOfHeads::of(&heads, 1.5);
    for (y, x) in (-20..130).flat_map(|y| (-20..130).map(move |x| (y, x))) {
        let at = PxPoint::new(x as f32, y as f32);
        assert_eq!(edges.has(at), heads.iter().any(|head| head.has_edge(at, 1.5)), "{at:?}");
    }
}

#[test]
fn a_contour_that_leads_through_several_heads_is_parted_at_each() {
    let moved = |by: f32| {
        let by = PxVector::new(by, 0.0);
        FilledHead { apex: HEAD.apex + by, base: HEAD.base + by, ..HEAD }
    };
    let heads = [moved(200.0), HEAD, FilledHead { apex: PxPoint::new(50.0, 90.0), ..HEAD }, moved(70.0)];
    let contour = polyline(&[(10.0, 30.0), (150.0, 30.0)]);
    let found = FoundContour { contour: contour.clone(), stroke: Some(2.0), whole: 140.0, tint: None };
    let parts = parted(vec![found], &heads);
    let lengths: Vec<f32> = parts.iter().map(|found| found.contour.length().round()).collect();
    assert_eq!(lengths, [40.0, 70.0, 30.0]);
    let mut contours = [contour.clone(), polyline(&[(10.0, 30.0), (124.0, 30.0)]), contour];
    shorten(&mut contours[1..2], &heads);
    assert_eq!(contours.map(|contour| contour.length().round() as i32), [140, 110, 140]);
}

#[test]
fn a_contour_that_leads_through_a_head_is_parted_at_its_tip() {
    let lengths = |points: &[(f32, f32)]| -> Vec<f32> {
        let found = FoundContour { contour: polyline(points), stroke: Some(2.0), whole: 65.0, tint: None };
        parted(vec![found], &[HEAD]).iter().map(|found| found.contour.length().round()).collect()
    };
    assert_eq!(lengths(&[(10.0, 30.0), (50.0, 30.0), (50.0, 5.0)]), [40.0, 25.0]);
    assert_eq!(lengths(&[(50.0, 5.0), (50.0, 30.0), (10.0, 30.0)]), [25.0, 40.0]);
    assert_eq!(lengths(&[(10.0, 30.0), (50.0, 30.0)]), [40.0], "it ends there");
    assert_eq!(lengths(&[(10.0, 30.0), (50.0, 30.0), (54.0, 30.0)]), [40.0], "over a gap");
    assert_eq!(lengths(&[(50.0, 5.0), (50.0, 55.0)]), [50.0], "what it points at");
}

#[test]
fn a_shaft_that_leads_to_its_own_start_is_opened_at_the_tip() {
    let ring = |points: &[(f32, f32)]| {
        let mut contour = polyline(points);
        contour.vertices.pop();
        contour.closed = true;
        let found = FoundContour { contour, stroke: Some(2.0), whole: 130.0, tint: None };
        parted(vec![found], &[HEAD]).into_iter().map(|found| found.contour).collect::<Vec<_>>()
    };
    let parts = ring(&[(10.0, 5.0), (10.0, 30.0), (50.0, 30.0), (50.0, 5.0), (10.0, 5.0)]);
    let [part] = &parts[..] else { panic!("{parts:?}") };
    assert!(!part.closed && (part.length() - 130.0).abs() < 0.01 && HEAD.has_end(part), "{part:?}");
    assert!([part.vertices[0], part.vertices[130]].iter().all(|end| end.at == HEAD.apex), "{part:?}");
    let parts = ring(&[(38.0, 30.0), (50.0, 30.0), (50.0, 24.0), (38.0, 24.0), (38.0, 30.0)]);
    assert!(matches!(&parts[..], [part] if part.closed), "a sign on a line: {parts:?}");
}

#[test]
fn a_head_is_a_triangle_and_belongs_to_a_contour_that_ends_there() {
    let mut edges = Edges::none(Size::new(80, 60));
    add(&[HEAD], &mut edges);
    assert!(matches!(&edges.chains[..], [chain] if chain.closed && chain.kind.exact && chain.kind.head));
    assert!((edges.chain(&edges.chains[0]).length() - 12.0 - 2.0 * 12.0_f32.hypot(6.0)).abs() < 0.01);
    assert_eq!(edges.edgels[0].at, HEAD.apex);
    assert!(HEAD.has_end(&polyline(&[(10.0, 30.0), (49.0, 30.0)])));
    assert!(!HEAD.has_end(&polyline(&[(50.0, 5.0), (50.0, 55.0)])), "there is no shaft");
}

#[test]
fn a_shaft_that_was_led_on_over_a_gap_ends_at_its_tip() {
    let length = |to: f32| {
        let mut contours = [polyline(&[(10.0, 30.0), (50.0, 30.0), (to, 30.0)])];
        shorten(&mut contours, &[HEAD]);
        contours[0].length().round() as i32
    };
    assert_eq!([54.0, 52.0, 70.0].map(length), [40, 42, 60]);
}
