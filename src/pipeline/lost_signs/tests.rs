//! Tests of `lost_signs`.

use super::*;
use crate::lines::Run;

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
    let told: Vec<String> = told(&lost, &[], &Words::default(), &figure).iter().map(ToString::to_string).collect();
    assert_eq!(told.len(), 3);
    assert!(told[0].contains("1 small closed shape (at 20, 0 mm)"), "{}", told[0]);
    assert!(told[1].contains("2 points (at 60, 0; 62, 0 mm): they are too near to other points"), "{}", told[1]);
    assert!(told[2].contains("2 arrowheads at ends of lines (at 50, 0; 80, 0 mm)"), "{}", told[2]);
}
