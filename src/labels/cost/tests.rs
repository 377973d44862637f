//! Tests of `cost`.

use super::super::placed::Params;
use super::super::room::Room;
use super::super::surroundings::LabelsAt;
use super::*;
use crate::page::{Line, Run};

/// A word of 40 mm for a print of 15 mm at the end of a leader line, which comes from the left: in the row of that its
/// middle is 14 mm further on, and it begins 4 mm behind the end.
#[test]
fn onwards_a_word_is_as_far_from_its_leader_line_as_it_begins_behind_it() {
    let (end, middle) = (MmPoint::new(100.0, 50.0), 110.0);
    let onwards = |from: f32, leader: Option<MmPoint>| {
        let place = MmRect::new(MmPoint::new(from, 47.0), MmPoint::new(from + 40.0, 53.0));
        onwards(leader, -1.0, place, place.center().x - middle)
    };
    assert!((onwards(104.0, Some(end)) - 4.0).abs() < 1e-3);
    assert!((onwards(114.0, Some(end)) - 14.0).abs() < 1e-3, "further off it is worse");
    assert!((onwards(104.0, None) - 14.0).abs() < 1e-3, "without a leader line from middle to middle");
    assert!((onwards(92.0, Some(end)) - 2.0).abs() < 1e-3, "under the leader line, too");
    let mirrored = MmRect::new(MmPoint::new(56.0, 47.0), MmPoint::new(96.0, 53.0));
    assert!((super::onwards(Some(end), 1.0, mirrored, -14.0) - 4.0).abs() < 1e-3, "one from the right");
}

/// Two rooms of 60 by 60 mm, side by side, with a door between them.
#[test]
fn the_name_of_a_room_is_rather_abbreviated_than_led_through_its_door() {
    let line = |points: &[(f32, f32)], closed: bool| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 50.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] }
    };
    let walls = line(&[(20.0, 20.0), (140.0, 20.0), (140.0, 80.0), (20.0, 80.0)], true);
    let wall = |low: f32, high: f32| line(&[(80.0, low), (80.0, high)], false);
    let lines = [walls, wall(20.0, 44.0), wall(56.0, 80.0)];
    let params = Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(160.0, 100.0)));
    let room = Room::new(&lines, &[], &params);
    let anchor = MmRect::new(MmPoint::new(60.0, 47.0), MmPoint::new(70.0, 53.0));
    let label = Wanted { text: "room".into(), anchor, lost_leader: None, kept_leader: None, is_nameless: false };
    let labels = LabelsAt { wanted: std::slice::from_ref(&label), anchors: &[anchor] };
    let around = Surroundings::of(0, labels, 30.0, &room, &params);
    let cost = |x: f32, leader: Option<[MmPoint; 2]>| {
        let place = MmRect::new(MmPoint::new(x, 47.0), MmPoint::new(x + 30.0, 53.0));
        let attachment = leader.map_or(Attachment::Beside, Attachment::Leader);
        cost(0.0, &label, place, attachment, &around)
    };
    let led = cost(90.0, Some([MmPoint::new(87.0, 50.0), anchor.center()]));
    assert!(led > ABBREVIATED, "{led}");
    assert!(cost(90.0, None) > ABBREVIATED && cost(66.0, None) > ABBREVIATED, "in the next room, and in the door");
    assert!(cost(40.0, None) < ABBREVIATED);
    let in_room = cost(30.0, Some([MmPoint::new(57.0, 60.0), anchor.center()]));
    assert!(in_room < ABBREVIATED, "{in_room}");
}
