//! Where a label can lie: what makes a place better than another, and which leader lines there are.

use super::super::forms::FormKind;
use super::super::room::Room;
use super::super::spacing::{LEAST_ABOVE, LEAST_ASIDE};
use super::super::surroundings::LabelsAt;
use super::*;
use crate::page::{Line, Run};

const POINT: MmPoint = MmPoint::new(100.0, 100.0);

fn params() -> Params {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0));
    Params { texture_clearance: 2.0, step: 1.0, ..Params::of_test(area) }
}

/// A room with one line, closed or open; with none without points.
fn room(points: &[(f32, f32)], closed: bool) -> Room {
    let points: Vec<MmPoint> = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    let line = Line { strength: 50.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] };
    let lines: Vec<Line> = std::iter::once(line).filter(|line| !line.runs[0].points.is_empty()).collect();
    Room::new(&lines, &[], &params())
}

fn named(anchor: MmRect) -> Wanted {
    Wanted { text: "word".to_owned(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }
}

fn at(x: f32, y: f32) -> Wanted {
    named(MmRect::new(MmPoint::new(x, y), MmPoint::new(x, y)))
}

/// A box of 20 by 6 mm with this upper left corner.
fn box_at(x: f32, y: f32) -> MmRect {
    MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 20.0, y + 6.0))
}

/// The first label in a place among others.
fn placed(wanted: &[Wanted], place: MmRect, room: &Room, params: &Params) -> Option<Candidate> {
    let form = Form { lines: vec![vec![1; 3]], abbreviation: None, kind: FormKind::OneLine };
    let anchors: Vec<MmRect> = wanted.iter().map(|label| label.anchor).collect();
    candidate(
        &wanted[0],
        0,
        &form,
        place,
        &Surroundings::of(0, LabelsAt { wanted, anchors: &anchors }, 20.0, room, params),
    )
}

/// What a place costs in the room.
fn cost_in(room: &Room, label: &Wanted, place: MmRect) -> f32 {
    placed(std::slice::from_ref(label), place, room, &params()).expect("it can be joined to its anchor").cost
}

#[test]
fn right_of_a_point_is_better_than_left_of_it_or_above() {
    let (room, label) = (room(&[], false), at(100.0, 100.0));
    let cost = |place: MmRect| cost_in(&room, &label, place);
    let left = cost(box_at(77.5, 97.0));
    assert!(cost(box_at(105.0, 97.0)) < left, "though it is 2.5 mm further away");
    assert!(cost(box_at(106.0, 97.0)) > left, "3.5 mm are too many");
    let above = cost(box_at(90.0, 91.5));
    assert!(cost(box_at(106.0, 97.0)) < above, "3.5 mm further away than above");
    assert!(cost(box_at(107.0, 97.0)) > above);
    assert!(cost(box_at(105.0, 96.0)) > cost(box_at(105.0, 97.0)), "level with the point");
    assert!(cost(box_at(92.0, 91.5)) > above, "in the middle above the point");
}

#[test]
fn below_a_bar_is_better_than_beside_it() {
    let bar = room(&[(97.5, 50.0), (102.5, 50.0), (102.5, 100.0), (97.5, 100.0)], true);
    let label = at(100.0, 100.0);
    let cost = |place: MmRect| cost_in(&bar, &label, place);
    assert!(cost(box_at(90.0, 111.5)) < cost(box_at(106.0, 97.0)), "11.5 mm below and 6 mm beside");
    assert!(cost(box_at(90.0, 108.0)) < cost(box_at(96.0, 106.0)), "in the middle, though 2 mm further below");
    let nothing = room(&[], false);
    let beside_point = cost_in(&nothing, &label, box_at(106.0, 97.0));
    assert!(beside_point < cost_in(&nothing, &label, box_at(90.0, 111.5)), "without a bar it is the other way round");
}

#[test]
fn a_label_far_from_its_point_has_a_leader_line() {
    let (room, params) = (room(&[], false), params());
    let label = [at(100.0, 100.0)];
    let placed = |x: f32| placed(&label, box_at(x, 97.0), &room, &params);
    let (near, far) = (placed(111.9).expect("near"), placed(112.1).expect("far"));
    assert_eq!(near.leader(), None);
    assert_eq!(far.leader().map(|[from, to]| (from.x.round(), to)), Some((109.0, POINT)), "3 mm of blank before it");
    assert!((far.cost - near.cost - 10.2).abs() < 0.01, "a leader line costs 10 mm");
    assert_eq!(placed(137.6), None, "beyond the longest leader line");
    assert_eq!(placed(101.9), None, "on the point");
}

#[test]
fn a_label_nearer_to_another_anchor_has_a_leader_line_of_some_length() {
    let (room, params) = (room(&[], false), params());
    let both = [at(100.0, 100.0), at(100.0, 112.0)];
    let leader = |wanted: &[Wanted], place: MmRect| placed(wanted, place, &room, &params).map(|found| found.leader());
    let place = box_at(106.0, 108.0);
    assert_eq!(leader(&both[..1], place), Some(None), "10 mm from its own");
    let [from, to] = leader(&both, place).flatten().expect("6 mm from the other");
    assert!(to == POINT && (distance_to_box(from, place) - 3.0).abs() < 0.01);
    // 5 mm are too short for a leader line, and from the corners it would run along the label
    assert_eq!(leader(&both, box_at(103.0, 104.0)), None);
    assert_eq!(leader(&both[..1], box_at(103.0, 104.0)), Some(None));
}

#[test]
fn a_label_stands_in_no_shape_of_another_though_its_outline_has_a_gap() {
    // two shapes, one above the other, and a gap between them on the right
    let outline =
        [(92.0, 100.0), (60.0, 100.0), (60.0, 60.0), (140.0, 60.0), (140.0, 140.0), (60.0, 140.0), (60.0, 100.0)];
    let shapes = room(&outline, false);
    let own = at(106.0, 112.0);
    let leads = |wanted: &[Wanted]| {
        placed(wanted, box_at(70.0, 88.0), &shapes, &params()).map(|found| found.leader().is_some())
    };
    assert_eq!(leads(std::slice::from_ref(&own)), Some(true), "nothing else is named");
    assert_eq!(leads(&[own.clone(), at(84.0, 79.0)]), None, "it would be a name of the upper shape");
    assert_eq!(leads(&[own, at(125.0, 125.0)]), Some(true), "the other is in the lower one too");
}

#[test]
fn leader_lines_keep_away_from_what_others_name() {
    let (room, params) = (room(&[], false), params());
    let start = |y: f32| {
        let found = placed(&[at(100.0, 100.0), at(110.0, y)], box_at(120.0, 97.0), &room, &params)?;
        found.leader().map(|[from, _]| from.y)
    };
    assert_eq!(start(104.5), Some(100.0), "4.5 mm beside the straight line from the nearest point");
    assert!(start(103.5).is_some_and(|y| y < 98.0), "from the upper corner");
}

#[test]
fn a_leader_line_crosses_others_only_where_it_may() {
    let wall = room(&[(105.0, 20.0), (105.0, 180.0)], false);
    let label = [at(100.0, 100.0)];
    let found = |label: &[Wanted], may_cross: bool| {
        placed(label, box_at(110.0, 97.0), &wall, &Params { may_cross, ..params() })
    };
    assert_eq!(found(&label, false), None);
    let across = found(&label, true).expect("it may");
    assert!(across.attachment.crosses() && across.cost > 2000.0 && across.leader().is_some_and(|[_, to]| to == POINT));
    let drawn = Wanted { lost_leader: Some(MmPoint::new(112.0, 100.0)), ..at(100.0, 100.0) };
    let drawn = found(&[drawn], true).expect("as the drawing leads to it");
    assert!(
        drawn.attachment.crosses() && (300.0..1000.0).contains(&drawn.cost),
        "less than an abbreviation: {}",
        drawn.cost
    );
    // along a line it would be felt as a part of that
    let cost = |room: &Room| {
        let join = Attachment::LeaderAcross([MmPoint::new(100.0, 117.0), POINT]);
        let (params, place) = (params(), box_at(91.0, 120.0));
        let labels = LabelsAt { wanted: &label, anchors: &[label[0].anchor] };
        cost(0.0, &label[0], place, join, &Surroundings::of(0, labels, 20.0, room, &params))
    };
    let beside = room(&[(101.0, 106.0), (101.0, 180.0)], false);
    let along = cost(&beside) - cost(&room(&[], false));
    // and 60 as it is not felt as a line before it meets that one
    assert!((280.0..340.0).contains(&along), "20 for each of 11 to 14 mm: {along}");
}

#[test]
fn labels_of_texts_stand_above_or_below_rather_than_beside() {
    let text = named(MmRect::new(MmPoint::new(95.0, 98.0), MmPoint::new(105.0, 102.0)));
    let nothing = room(&[], false);
    let cost = |room: &Room, middle: [f32; 2]| cost_in(room, &text, box_at(middle[0] - 10.0, middle[1] - 3.0));
    assert!(cost(&nothing, [100.0, 108.0]) < cost(&nothing, [103.0, 100.0]), "8 mm below or 3 mm beside");
    // a line comes up to it on the left: rather away from it in its row
    let line = room(&[(20.0, 100.0), (93.0, 100.0)], false);
    assert!(cost(&line, [107.0, 100.0]) < cost(&line, [100.0, 104.0]), "7 mm on or 4 mm below");
    assert!(cost(&line, [108.0, 100.0]) > cost(&line, [100.0, 104.0]));
}

fn at_leader(place: MmRect, leader: [(f32, f32); 2]) -> Candidate {
    Candidate::of_row(0, place, Attachment::Leader(leader.map(MmPoint::from)), 0.0, PlacedAs::Alone)
}

const LEAST: Spacing = Spacing { aside: LEAST_ASIDE, above: LEAST_ABOVE, in_line: 15.0 };

#[test]
fn leader_lines_that_are_too_near_conflict() {
    let (blank, one) = (room(&[], false), at_leader(box_at(0.0, 0.0), [(23.0, 3.0), (80.0, 3.0)]));
    let conflicts =
        |y: f32| one.conflicts(&at_leader(box_at(120.0, y), [(117.0, y), (70.0, y)]), LEAST, 0.0, Some(&blank));
    assert!(conflicts(5.9) && !conflicts(6.1), "3 mm of blank");
    // and what lies in the way of a leader line
    let label = |y: f32| Candidate { attachment: Attachment::Beside, ..at_leader(box_at(50.0, y), [(0.0, 0.0); 2]) };
    assert!(
        one.conflicts(&label(6.4), LEAST, 0.0, Some(&blank)) && !one.conflicts(&label(6.6), LEAST, 0.0, Some(&blank)),
        "3.5 mm"
    );
    assert!(one.conflicts(&label(6.6), LEAST, 0.5, Some(&blank)), "its dots lie off by half a millimetre");
    let fixed = |of: Candidate| Candidate { stands: PlacedAs::InRow, ..of };
    assert!(!fixed(one.clone()).conflicts(&fixed(label(6.4)), LEAST, 0.0, Some(&blank)), "rows keep their own blank");
}

#[test]
fn labels_at_one_height_are_not_read_as_one_text() {
    let label = |x: f32, y: f32| Candidate::of_row(0, box_at(x, y), Attachment::Beside, 0.0, PlacedAs::Alone);
    // the first ends at 60
    let conflicts = |x: f32, y: f32, room: &Room| {
        let (one, other) = (label(40.0, 50.0), label(x, y));
        let of_both = [one.conflicts(&other, LEAST, 0.0, Some(room)), other.conflicts(&one, LEAST, 0.0, Some(room))];
        assert_eq!(of_both[0], of_both[1]);
        of_both[0]
    };
    let blank = room(&[], false);
    assert!(conflicts(67.0, 50.0, &blank), "a blank cell or two, as between two words");
    assert!(conflicts(67.0, 55.5, &blank), "half a line lower");
    assert!(!conflicts(75.1, 50.0, &blank));
    assert!(!conflicts(67.0, 60.0, &blank), "in another line");
    let line = room(&[(63.5, 20.0), (63.5, 80.0)], false);
    assert!(!conflicts(67.0, 50.0, &line), "a line between them");
    assert!(conflicts(65.0, 50.0, &line), "nearer than labels ever are");
    assert!(!label(40.0, 50.0).conflicts(&label(67.0, 50.0), LEAST, 0.0, None), "two numbers");
}

#[test]
fn the_best_places_are_kept_some_distance_apart() {
    let places = |count: usize, step: f32| -> Vec<Candidate> {
        let at = |k: usize| {
            Candidate::of_row(k, box_at(k as f32 * step, 0.0), Attachment::Beside, k as f32, PlacedAs::Alone)
        };
        apart((0..count).rev().map(at).collect())
    };
    let near: Vec<usize> = places(20, 1.0).iter().map(|place| place.form).collect();
    assert_eq!(near, [0, 4, 8, 12, 16], "4 mm apart, the cheapest first");
    let many = places(100, 5.0);
    assert_eq!((many.len(), many[0].form, many[47].form), (48, 0, 47));
}

#[test]
fn more_labels_than_have_room_are_looked_for_in_coarser_steps() {
    let is = |labels: usize, mm: f32| (step(labels, &params()) - mm).abs() < 1e-6;
    assert!(is(1, 1.0) && is(150, 1.0), "as many as may have room");
    assert!(is(151, 2.0) && is(300, 2.0), "more");
}

#[test]
fn the_name_of_an_angle_stays_between_its_legs() {
    let legs = room(&[(140.0, 120.0), (90.0, 120.0), (125.0, 60.0)], false);
    let anchor = MmRect::new(MmPoint::new(97.0, 112.0), MmPoint::new(101.0, 116.0));
    let join_at = |text: &str, place: MmRect, anchor: MmRect| {
        let label = [Wanted { text: text.into(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }];
        placed(&label, place, &legs, &params()).map(|found| (found.leader().is_some(), found.attachment.crosses()))
    };
    let join_of = |text: &str, place: MmRect| join_at(text, place, anchor);
    let place = |x: f32, y: f32| MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 10.0, y + 6.0));
    assert_eq!(join_of("α", place(107.0, 108.0)), Some((false, false)), "in the angle");
    assert_eq!(join_of("α", place(95.0, 126.0)), Some((true, true)), "below its leg, which the leader line crosses");
    let beside = |x: f32| anchor.translate(MmVector::new(x, 0.0));
    assert_eq!(join_at("path", place(105.0, 126.0), beside(10.0)), Some((false, false)), "a word names the leg");
    assert_eq!(join_of("path", place(95.0, 126.0)), Some((true, true)), "the other leg, which is nearer to it");
}

#[test]
fn a_line_where_a_next_cell_would_be_is_worse_than_one_further_off() {
    let label = at(100.0, 100.0);
    let cost = |room: &Room, more_aside: f32| {
        let found = placed(std::slice::from_ref(&label), box_at(102.5, 97.0), room, &Params { more_aside, ..params() });
        found.expect("it stands beside its anchor").cost
    };
    // the label ends at 122.5; upright lines of 1 mm are 4 and 6 mm from it
    let (near, far) = (room(&[(127.0, 80.0), (127.0, 120.0)], false), room(&[(129.0, 80.0), (129.0, 120.0)], false));
    assert!(cost(&near, 1.65) > cost(&far, 1.65));
    assert!((cost(&near, 0.0) - cost(&far, 0.0)).abs() < 1e-3, "where cells stand anywhere, both are alike");
    // a line below it is no letter
    let below = room(&[(80.0, 107.0), (120.0, 107.0)], false);
    assert!((cost(&below, 1.65) - cost(&far, 1.65)).abs() < 1e-3);
}

#[test]
fn a_leader_line_across_others_begins_so_far_before_them_that_it_is_felt() {
    let wall = room(&[(90.0, 50.0), (90.0, 150.0)], false);
    let label = Wanted { lost_leader: Some(MmPoint::new(78.0, 100.0)), ..at(100.0, 100.0) };
    let found = |x: f32| {
        let found = placed(std::slice::from_ref(&label), box_at(x, 97.0), &wall, &params());
        found.expect("it can be led across")
    };
    // its leader line begins 3 mm beside it, and meets the wall at 89.5: after 1.5 and after 6.5 mm
    let (near, far) = (found(65.0), found(60.0));
    assert!(near.attachment.crosses() && far.attachment.crosses());
    assert!(far.cost < near.cost, "{} {}", far.cost, near.cost);
}

#[test]
fn the_name_of_a_point_stands_over_no_other_point() {
    let (room, params) = (room(&[], false), params());
    let cost = |others: &[Wanted]| {
        let wanted = [&[at(100.0, 100.0)], others].concat();
        placed(&wanted, box_at(90.0, 88.0), &room, &params).expect("it stands above its point").cost
    };
    let alone = cost(&[]);
    assert!((cost(&[at(109.0, 100.0)]) - alone - 30.0).abs() < 0.01, "rather elsewhere with a leader line");
    assert!((cost(&[at(112.0, 100.0)]) - alone).abs() < 0.01, "beside the other");
    assert!((cost(&[at(109.0, 110.0)]) - alone).abs() < 0.01, "the other is farther below");
}

#[test]
fn a_leader_line_along_a_line_is_none() {
    let label = [at(100.0, 100.0)];
    let found = |points: &[(f32, f32)]| placed(&label, box_at(75.0, 122.0), &room(points, false), &params());
    // from the label at 95, 122 to the point
    assert!(found(&[(80.0, 112.0), (120.0, 112.0)]).is_some_and(|found| found.attachment.crosses()));
    assert_eq!(found(&[(98.0, 90.0), (96.0, 120.0)]), None, "beside which it runs");
}

#[test]
fn a_label_beside_the_outline_of_its_shape_stands_on_blank_ground() {
    let shape = room(&[(90.0, 90.0), (110.0, 90.0), (110.0, 110.0), (90.0, 110.0)], true);
    let label = [named(MmRect::new(MmPoint::new(97.0, 98.0), MmPoint::new(103.0, 102.0)))];
    let found = |has_coloured_ground: bool| {
        let params = Params { may_cross: false, has_coloured_ground, ..params() };
        let found = |x: f32| placed(&label, box_at(x, 97.0), &shape, &params).map(|found| found.attachment);
        [found(114.0), found(122.0)]
    };
    let [near, far] = found(false);
    assert_eq!(near, Some(Attachment::Beside));
    assert!(matches!(far, Some(Attachment::Leader([_, to])) if (109.0..112.0).contains(&to.x)), "{far:?}");
    assert_eq!(found(true), [None, None], "in the sea it would be a name of that");
}

#[test]
fn places_with_leader_lines_are_left_where_many_are_near_by() {
    let near = (0..60)
        .map(|k| Candidate::of_row(k, box_at(5.0 * k as f32, 0.0), Attachment::Beside, k as f32, PlacedAs::Alone));
    let far = (0..40).map(|k| Candidate {
        cost: 100.0 + k as f32,
        ..at_leader(box_at(5.0 * k as f32, 20.0), [(0.0, 9.0), (0.0, 0.0)])
    });
    let kept = apart(near.chain(far).collect());
    let led = kept.iter().filter(|candidate| candidate.leader().is_some()).count();
    assert_eq!((kept.len(), led), (68, 20), "8 mm apart");
}

/// In an eye without its retina, whose leader line had no room, "Retina" is no name of what is inside.
#[test]
fn a_label_that_lost_its_leader_line_stands_in_no_shape_without_another() {
    let shape = room(&[(60.0, 60.0), (140.0, 60.0), (140.0, 140.0), (60.0, 140.0)], true);
    let is_led = |tip: f32, x: f32| {
        let label = Wanted { lost_leader: Some(MmPoint::new(170.0, 60.0)), ..at(tip, 100.0) };
        placed(&[label], box_at(x, 97.0), &shape, &params()).map(|found| found.leader().is_some())
    };
    assert_eq!(is_led(138.0, 110.0), Some(true), "8 mm from its tip, which is at the outline");
    assert_eq!(is_led(138.0, 113.0), None, "too near for a leader line");
    assert_eq!(is_led(138.0, 143.0), Some(false), "as near outside of the shape");
    assert_eq!(is_led(100.0, 110.0), Some(false), "its tip names what is inside");
}

/// From a corner it may lead back along the label, to which its ink is nearer than its middle by half of its width.
#[test]
fn a_leader_line_from_a_corner_keeps_its_ink_off_its_label() {
    // bars the straight way from the nearest point of the label, and that from the corner on the right
    let bar = room(&[(98.0, 112.0), (104.0, 112.0)], false);
    let label = [at(100.0, 100.0)];
    let begins = |least_before_leader: f32| {
        let params = Params { may_cross: false, least_before_leader, ..params() };
        let found = placed(&label, box_at(82.0, 120.0), &bar, &params);
        found.and_then(|found| found.leader()).map(|[from, _]| (from.y * 10.0).round())
    };
    // 18 mm to the right and 20 up from the corner on the left
    assert_eq!(begins(2.0), Some(1178.0), "2.2 mm above the label");
    assert_eq!(begins(2.375), None, "a line of 0.75 mm is less than 2 mm from it");
}

/// As beside a wire of a circuit, of which fingers take it for a part.
#[test]
fn a_leader_line_beside_a_line_is_worse_than_one_by_itself() {
    let label = at(100.0, 100.0);
    let cost = |points: &[(f32, f32)]| {
        // from the label at 125, 100 to the point
        let found = placed(std::slice::from_ref(&label), box_at(125.0, 97.0), &room(points, false), &params());
        let found = found.expect("it is led to its point");
        assert!(matches!(found.attachment, Attachment::Leader(_)), "{:?}", found.attachment);
        found.cost
    };
    let alone = cost(&[]);
    let beside = cost(&[(80.0, 103.0), (140.0, 103.0)]) - alone;
    assert!((400.0..600.0).contains(&beside), "50 for each mm of 22, but for the last 4 and 8: {beside}");
    assert!((cost(&[(80.0, 105.0), (140.0, 105.0)]) - alone).abs() < 0.01, "as far off as a label");
    assert!((cost(&[(112.0, 103.0), (112.0, 150.0)]) - alone).abs() < 0.01, "past the end of a line");
}

/// "6 cm" inside of a triangle, beside a leg, would say with a leader line to another side how long that is.
#[test]
fn a_length_is_led_to_the_side_that_it_stands_at() {
    let shape = room(&[(60.0, 150.0), (60.0, 80.0), (90.0, 65.0), (90.0, 150.0)], true);
    let anchor = MmRect::new(MmPoint::new(63.0, 108.0), MmPoint::new(72.0, 113.0));
    let ends = |text: &str, x: f32| {
        let label = Wanted { text: text.to_owned(), ..named(anchor) };
        let params = Params { may_cross: false, ..params() };
        placed(&[label], box_at(x, 107.5), &shape, &params).map(|found| found.leader().map(|[_, to]| to.x.round()))
    };
    assert_eq!(ends("word", 101.0), Some(Some(91.0)), "it names the shape");
    assert_eq!(ends("6 cm", 101.0), None, "of the other side it is no length");
    assert!(ends("6 cm", 29.0).flatten().is_some_and(|x| (58.0..62.0).contains(&x)), "from beyond its own");
}

/// Two dots between a label and an outline are felt as dots by themselves.
#[test]
fn a_leader_line_of_two_dots_is_worse_than_a_longer_one() {
    let (room, both) = (room(&[], false), [at(100.0, 100.0), at(100.0, 112.0)]);
    let params = |dot_pitch: f32| Params { dot_pitch, leader_off: 2.2, ..params() };
    // what it costs more on dots than in print, from a label so far on the right of its point, and 8 mm below it
    let more = |x: f32| {
        let found = |pitch: f32| placed(&both, box_at(100.0 + x, 108.0), &room, &params(pitch));
        let cost = |pitch: f32| found(pitch).filter(|found| found.leader().is_some()).expect("it is led").cost;
        cost(2.0) - cost(0.0)
    };
    assert!((more(6.0) - 12.0).abs() < 0.1, "4.8 mm of 6: {}", more(6.0));
    assert!(more(10.0).abs() < 0.01, "7.6 mm");
}

/// As the instructions of a worksheet, which stand beside a drawing by chance.
#[test]
fn a_sentence_has_no_leader_line() {
    let outline = room(&[(125.0, 60.0), (180.0, 60.0), (180.0, 140.0), (125.0, 140.0)], true);
    let place_of_text = MmRect::new(MmPoint::new(80.0, 97.0), MmPoint::new(120.0, 103.0));
    let is_led = |text: &str, place: MmRect| {
        let label = Wanted { text: text.to_owned(), ..named(place_of_text) };
        placed(&[label], place, &outline, &params()).map(|found| found.leader().is_some())
    };
    let sentence = "Colour the cells green.";
    assert_eq!(is_led("cells", box_at(90.0, 75.0)), Some(true), "19 mm away, to the line beside the text");
    assert_eq!(is_led(sentence, box_at(90.0, 75.0)), Some(false));
    assert_eq!(is_led(sentence, box_at(90.0, 97.0)), Some(false), "in its place");
    assert_ne!(is_led(sentence, box_at(130.0, 97.0)), Some(false), "it is no name of the shape");
}

/// Above the wall of a house its name would be that of a garden.
#[test]
fn outside_of_a_room_a_label_is_worse_than_an_abbreviation() {
    let walls = [(115.0, 140.0), (140.0, 140.0), (140.0, 60.0), (60.0, 60.0), (60.0, 140.0), (115.0, 140.0)];
    // a short wall inside hides a part of the room from the text
    let (plain, with_wall) = (room(&walls, false), room(&[&[(115.0, 120.0)][..], &walls[..]].concat(), false));
    let label = named(MmRect::new(MmPoint::new(95.0, 67.0), MmPoint::new(105.0, 73.0)));
    let (outside, inside) = (box_at(90.0, 50.5), box_at(90.0, 70.0));
    let cost = |room: &Room, place| placed(std::slice::from_ref(&label), place, room, &params()).map(|of| of.cost);
    let all =
        [[&plain, &with_wall].map(|room| cost(room, inside)), [&plain, &with_wall].map(|room| cost(room, outside))];
    let [[Some(as_before), Some(within)], [_, beyond]] = all else { panic!("inside it can stand: {all:?}") };
    assert!((as_before - within).abs() < 0.01, "{all:?}");
    assert!(beyond.is_none_or(|beyond| beyond > within + 1000.0), "{all:?}");
}

#[test]
fn candidates_that_blank_a_texture_come_last_where_it_is_to_be_spared() {
    let candidate = |cost: f32, blanks: bool| {
        let of = Candidate::of_row(0, box_at(90.0, 90.0), Attachment::Beside, cost, PlacedAs::Alone);
        Candidate { blanks, ..of }
    };
    let costs = |all: &[Candidate]| all.iter().map(|of| of.cost.round() as i32).collect::<Vec<_>>();
    assert_eq!(sparing(&[vec![candidate(1.0, false)], Vec::new()]), None);
    let all =
        [vec![candidate(1.0, true), candidate(60.0, false), candidate(1001.0, true)], vec![candidate(2.0, false)]];
    let sparing = sparing(&all).expect("some blank a texture");
    assert_eq!(costs(&sparing[0]), [60, 201, 1201]);
    assert_eq!(costs(&sparing[1]), [2]);
}

#[test]
fn the_name_of_a_room_is_led_to_no_table_that_has_a_name() {
    let line = |(low, high): ((f32, f32), (f32, f32))| {
        let points = [low, (high.0, low.1), high, (low.0, high.1)].map(|(x, y)| MmPoint::new(x, y));
        Line { strength: 50.0, runs: vec![Run { closed: true, ..Run::stroke(1.0, points.to_vec()) }] }
    };
    let lines = [line(((50.0, 20.0), (150.0, 100.0))), line(((80.0, 52.0), (120.0, 72.0)))];
    let (params, room) = (params(), Room::new(&lines, &[], &params()));
    let text = |x: f32, y: f32| named(MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 10.0, y + 6.0)));
    let tip = |wanted: &[Wanted]| {
        let anchors: Vec<MmRect> = wanted.iter().map(|label| label.anchor).collect();
        Surroundings::of(0, LabelsAt { wanted, anchors: &anchors }, 20.0, &room, &params).tip
    };
    // 4 mm above the table
    let (own, table) = (text(95.0, 41.0), text(95.0, 59.0));
    assert!(tip(std::slice::from_ref(&own)).y > 50.0, "a table without a name");
    assert_eq!(tip(&[own.clone(), table]), own.anchor.center());
    assert!(tip(&[own.clone(), text(60.0, 80.0)]).y > 50.0, "another text of the room");
}

#[test]
fn the_name_of_a_room_stands_in_it_without_a_leader_line() {
    let walls = [(115.0, 140.0), (140.0, 140.0), (140.0, 60.0), (60.0, 60.0), (60.0, 140.0), (115.0, 140.0)];
    let room_of = |furniture: &[(f32, f32)]| room(&[furniture, &walls[..]].concat(), false);
    let label = named(MmRect::new(MmPoint::new(95.0, 67.0), MmPoint::new(105.0, 73.0)));
    let attached = |room: &Room, place: MmRect| {
        placed(std::slice::from_ref(&label), place, room, &params()).map(|of| of.attachment)
    };
    // a wall that juts out hides a part of the room from the text
    let place = box_at(90.0, 88.0);
    assert_eq!(attached(&room_of(&[(115.0, 120.0)]), place), Some(Attachment::Beside));
    assert_ne!(
        attached(&room_of(&[]), place),
        Some(Attachment::Beside),
        "in a box the label of which it is has to be told"
    );
}
