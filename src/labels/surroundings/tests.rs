//! Tests of `surroundings`.

use super::*;
use crate::page::{Line, Run};

/// Two lands of 30 by 30 mm, side by side; the text stands in the left one.
#[test]
fn a_label_above_two_lands_is_before_both() {
    let line = |points: &[(f32, f32)], closed: bool| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 50.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] }
    };
    let outline = line(&[(40.0, 40.0), (100.0, 40.0), (100.0, 70.0), (40.0, 70.0)], true);
    let border = line(&[(70.0, 40.0), (70.0, 70.0)], false);
    let params = Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 110.0)));
    let anchors = [MmRect::new(MmPoint::new(50.0, 52.0), MmPoint::new(60.0, 58.0))];
    let is_before = |lines: &[Line], from: f32, to: f32| {
        let wanted = [Wanted {
            text: "land".to_owned(),
            anchor: anchors[0],
            lost_leader: None,
            kept_leader: None,
            is_nameless: false,
        }];
        let room = Room::new(lines, &[], &params);
        let around = Surroundings::of(0, LabelsAt { wanted: &wanted, anchors: &anchors }, 40.0, &room, &params);
        let place = MmRect::new(MmPoint::new(from, 30.0), MmPoint::new(to, 36.0));
        around.is_before_others(place, MmVector::new(0.0, 16.0))
    };
    let both = [outline.clone(), border];
    assert!(is_before(&both, 42.0, 98.0), "above both");
    assert!(!is_before(&both, 20.0, 68.0), "above its own, and beside that");
    assert!(!is_before(&both, 30.0, 78.0), "a little above the other");
    assert!(!is_before(&[outline], 30.0, 110.0), "above a box by itself");
}

/// A box, 14 mm wide and 32 mm high, with its middle at 100, 100, as the lens of an eye, and an upright line right of
/// it.
fn lens(line_at: f32) -> Room {
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|&at| MmPoint::from(at)).collect();
        Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] }
    };
    let around = [(93.0, 84.0), (107.0, 84.0), (107.0, 116.0), (93.0, 116.0), (93.0, 84.0)];
    let lines = [line(&around), line(&[(line_at, 60.0), (line_at, 140.0)])];
    Room::new(&lines, &[], &Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0))))
}

#[test]
fn a_leader_line_may_lead_into_its_small_shape_and_across_nothing_else() {
    let leads = |line_at: f32, tip: (f32, f32), lost_leader: Option<MmPoint>| {
        let (room, tip) = (lens(line_at), MmPoint::from(tip));
        let params = Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0)));
        let anchor = MmRect::new(tip, tip);
        let label = Wanted { text: "lens".to_owned(), anchor, lost_leader, kept_leader: None, is_nameless: false };
        let wanted = [label];
        let at = LabelsAt { wanted: &wanted, anchors: &[anchor] };
        Surroundings::of(0, at, 20.0, &room, &params).leads_into_shape(&wanted[0], MmPoint::new(125.0, 100.0))
    };
    let lost = Some(MmPoint::new(40.0, 100.0));
    assert!(leads(160.0, (100.0, 100.0), lost));
    assert!(!leads(115.0, (100.0, 100.0), lost), "another line lies between");
    assert!(!leads(115.0, (110.0, 160.0), lost), "in the open");
    assert!(!leads(160.0, (100.0, 100.0), None), "the drawing has no leader line to it");
}
