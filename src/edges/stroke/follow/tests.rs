//! Tests of `follow`.

use super::*;
use crate::geom::polyline::Polyline;
use crate::units::Size;

const SIZE: Size = Size { width: 120, height: 60 };
const PARAMS: Params = Params {
    sigma: 1.8,
    low: 3.0,
    high: 7.0,
    min_length: 8.0,
    min_length_of_drawing: 8.0,
    strength_window: 4.0,
    suppression: 0.0,
    side_cell: 4.0,
    side_offset: 6.0,
    widest_stroke: 19.0,
    dark_lines: None,
};

/// A picture that is white above row 30 and of some lightness below it.
fn border(below: f32) -> Vec<Plane> {
    let values = (0..SIZE.len()).map(|cell| if cell / SIZE.width as usize >= 30 { below } else { 100.0 });
    vec![Plane { size: SIZE, values: values.collect() }]
}

fn stroke(from: f32, to: f32) -> Stroke {
    let point = |x: f32| ContourPoint {
        at: PxPoint::new(x, 30.0),
        strength: 50.0,
        contrast: [0.0; 3],
        blur: 2.0,
        position_sigma: 0.2,
    };
    let vertices = (0..=(to - from) as usize).map(|k| point(from + k as f32)).collect();
    Stroke { contour: Polyline::open(vertices), width: 2.0, whole: to - from, is_dash: false, tint: None }
}

#[test]
fn strokes_go_on_along_the_border_of_an_area_and_over_nothing_they_do_not() {
    let both = || vec![stroke(10.0, 45.0), stroke(70.0, 110.0)];
    let one = follow(both(), &border(40.0), &PARAMS);
    assert!(matches!(&one[..], [one] if (one.contour.length() - 100.0).abs() < 1.0), "{one:?}");
    assert_eq!(follow(both(), &border(100.0), &PARAMS).len(), 2);
    // a border far fainter than the strokes
    assert_eq!(follow(both(), &border(90.0), &PARAMS).len(), 2);
}

#[test]
fn an_end_that_leads_to_no_other_stroke_stays_as_it_is() {
    let one = follow(vec![stroke(10.0, 45.0)], &border(40.0), &PARAMS);
    assert!(matches!(&one[..], [one] if (one.contour.length() - 35.0).abs() < 0.01), "{one:?}");
}

#[test]
fn pieces_of_one_stroke_that_touch_are_one() {
    let one = follow(vec![stroke(10.0, 45.0), stroke(46.0, 110.0)], &border(100.0), &PARAMS);
    assert!(matches!(&one[..], [one] if (one.contour.length() - 100.0).abs() < 0.01), "{one:?}");
}

/// As the stem of a letter P that its bow comes back to.
#[test]
fn a_stroke_that_is_followed_to_its_own_line_ends_on_it() {
    let corners = [(90.0, 10.0), (90.0, 50.0), (10.0, 50.0), (10.0, 30.0), (45.0, 30.0)];
    let points = corners.windows(2).flat_map(|pair| {
        let [a, b] = [pair[0], pair[1]].map(|(x, y)| PxPoint::new(x, y));
        let steps = (b - a).length() as u16;
        (0..steps).map(move |step| a.lerp(b, f32::from(step) / f32::from(steps)))
    });
    let mut bow = stroke(0.0, 1.0);
    let point = bow.contour.vertices[0];
    bow.contour.vertices = points.map(|at| ContourPoint { at, ..point }).collect();
    bow.whole = bow.contour.length();
    let before = bow.contour.length();
    let one = follow(vec![bow.clone()], &border(40.0), &PARAMS);
    let [one] = &one[..] else { panic!("{one:?}") };
    let end = one.contour.vertices.last().expect("it has vertices").at;
    assert!((end - PxPoint::new(90.0, 30.0)).length() < 3.5, "{end:?}");
    assert!((one.contour.length() - before - 46.0).abs() < 2.0 && !one.contour.closed, "{}", one.contour.length());
    // over white there is nothing to follow
    let same = follow(vec![bow], &border(100.0), &PARAMS);
    assert!(matches!(&same[..], [same] if (same.contour.length() - before).abs() < 0.01), "{same:?}");
}
