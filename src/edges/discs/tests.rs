//! Tests of `discs`.

use super::super::contour::testing::polyline;
use super::*;
use crate::edges::ridge::EdgeProfile;
use crate::units::PxVector;

const SIZE: Size = Size::new(200, 100);

fn params() -> Params {
    Params { sigma: 1.8, low: 3.0, high: 7.0, min_length: 8.0, widest_stroke: 19.0, ..Params::default() }
}

/// Ridge points on a circle but where a level line through it hides them, this far above and below its middle.
fn circle(middle: (f32, f32), radius: f32, hidden: f32) -> Vec<RidgePoint> {
    let profile = EdgeProfile { maximum: 1.0, curvature: 0.3, pedestal: [0.0; 2], distance: 4.0 };
    let count = (6.0 * radius) as u32;
    let turn = |k: u32| k as f32 / count as f32 * std::f32::consts::TAU;
    let normal = (0..count).map(turn).map(|turn| PxVector::new(turn.cos(), turn.sin()));
    let point = |normal: PxVector| {
        let at = PxPoint::new(middle.0, middle.1) + normal * radius;
        RidgePoint { at, normal, profile, height: 60.0, blur: 1.8, column: at.x as u32, row: at.y as u32 }
    };
    normal.map(point).filter(|point| (point.at.y - middle.1).abs() >= hidden).collect()
}

fn discs(points: &[RidgePoint]) -> Vec<Disc> {
    find(points, SIZE, &params())
}

fn stroke(points: &[(f32, f32)]) -> FoundContour {
    FoundContour { stroke: Some(3.0), ..FoundContour::edge(polyline(points)) }
}

fn split(found: Vec<FoundContour>, discs: &[Disc]) -> Vec<FoundContour> {
    split_at_discs(found, discs, &params(), &|_, _, _, _| true)
}

#[test]
fn a_disc_on_a_line_is_a_ring_between_two_straight_ends() {
    // the line was found round the upper half of the disc
    let line = stroke(&[(10.0, 50.0), (90.0, 50.0), (100.0, 44.0), (110.0, 50.0), (190.0, 50.0)]);
    let parts = split(vec![line], &discs(&circle((100.0, 50.3), 8.4, 3.0)));
    let [before, after, ring] = &parts[..] else { panic!("{} contours", parts.len()) };
    assert!(!before.contour.closed && !after.contour.closed && ring.contour.closed && ring.stroke.is_none());
    let length = ring.contour.length();
    assert!((length - std::f32::consts::TAU * 8.4).abs() < 2.0, "{length}");
    assert!(before.contour.vertices.iter().all(|vertex| (vertex.at.y - 50.0).abs() < 0.1));
}

#[test]
fn a_ring_on_a_line_has_its_outline_for_a_stroke() {
    let line = stroke(&[(10.0, 50.0), (190.0, 50.0)]);
    let mut points = circle((100.0, 50.0), 9.0, 3.0);
    points.extend(circle((100.0, 50.0), 5.5, 0.0));
    let parts = split(vec![line], &discs(&points));
    let ring = parts.iter().find(|part| part.contour.closed).expect("a ring");
    assert!(ring.stroke.is_some_and(|width| (width - 3.5).abs() < 1.0), "{:?}", ring.stroke);
}

#[test]
fn a_side_that_ends_in_a_line_before_the_disc_is_led_to_it() {
    // 11 degrees from the line, and bent where both are one spot
    let discs = discs(&circle((100.0, 50.0), 8.0, 3.0));
    let all = vec![stroke(&[(10.0, 50.0), (190.0, 50.0)]), stroke(&[(10.0, 68.0), (75.0, 55.0), (83.0, 51.0)])];
    let end = |parts: &[FoundContour]| {
        let side = parts.iter().find(|part| part.contour.vertices[0].at.y > 60.0).expect("the side");
        side.contour.vertices[side.contour.vertices.len() - 1].at
    };
    let led = end(&split(all.clone(), &discs)) - PxPoint::new(100.0, 50.0);
    assert!((led.length() - 8.0).abs() < 0.3 && (led.y + 0.2 * led.x).abs() < 0.3, "{led:?}");
    let not_seen = split_at_discs(all, &discs, &params(), &|_, _, _, _| false);
    assert_eq!(end(&not_seen), PxPoint::new(83.0, 51.0), "nothing is there");
}

#[test]
fn the_round_end_of_a_stroke_is_no_disc() {
    let mut cap = circle((100.0, 50.0), 5.0, 0.0);
    cap.retain(|point| point.at.x >= 98.0);
    assert_eq!(discs(&cap), []);
}

#[test]
fn what_no_line_leads_to_or_is_no_circle_stays() {
    let beside = vec![stroke(&[(10.0, 57.0), (190.0, 57.0)])];
    assert_eq!(split(beside.clone(), &discs(&circle((100.0, 50.0), 8.0, 0.0))), beside);
    // more than half of the circle is hidden
    assert_eq!(discs(&circle((100.0, 50.0), 8.0, 6.0)), []);
}
