//! Tests of `leaders`.

use super::*;
use crate::edges::Edgel;
use crate::lines::{Height, Run};
use crate::units::{PxPoint, Size};

/// Whether a leader line from 0 to 40 mm is whole of which these pieces are drawn.
fn whole(pieces: &[(f32, f32)], y: f32) -> bool {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let line = |&(from, to): &(f32, f32)| Line {
        strength: 1.0,
        runs: vec![Run::stroke(1.0, vec![at(from, y), at(0.5 * (from + to), y), at(to, y)])],
    };
    // what it crosses is no piece of it
    let crossed = Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![at(20.0, 0.0), at(20.0, 90.0)])] };
    let lines: Vec<Line> = pieces.iter().map(line).chain([crossed]).collect();
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    is_whole(&[at(0.0, 50.0), at(40.0, 50.0)], &index_of_pieces(&lines, area), GAP)
}

#[test]
fn a_leader_line_that_lacks_its_tip_or_its_middle_is_torn() {
    assert!(whole(&[(0.0, 40.0)], 50.0));
    assert!(whole(&[(0.0, 19.0), (21.0, 39.0)], 50.5), "moved, and with a gap at what it crosses");
    assert!(!whole(&[(0.0, 18.0)], 50.0), "only outside of what it crosses");
    assert!(!whole(&[(22.0, 40.0)], 50.0), "only inside");
    assert!(!whole(&[(0.0, 15.0), (25.0, 40.0)], 50.0), "a gap of 10 mm");
    assert!(!whole(&[], 50.0));
}

#[test]
fn those_left_out_are_told_by_their_texts() {
    let text = |string: &str, lost_leader: bool| Text {
        lost_leader: lost_leader.then(|| (MmPoint::zero(), MmPoint::new(9.0, 0.0))),
        ..Text::of_test(string, MmRect::zero())
    };
    let note = told_lost(&[text("nucleus", true), text("vacuole", false)]).expect("a note").to_string();
    assert!(note.contains("the leader line of \"nucleus\": it has no room as a whole"), "{note}");
    assert_eq!(told_lost(&[text("vacuole", false)]), None);
}

#[test]
fn a_row_is_one_of_the_nearest_leader_line_and_of_none_beside_it() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let leaders = [52.0, 50.0].map(|y| [at(0.0, y), at(40.0, y)]);
    let tip = |from: MmPoint, to: MmPoint| {
        let dots = (0..=8).map(|k| from.lerp(to, k as f32 / 8.0)).collect();
        let line = Line { strength: 1.0, runs: vec![Run::dots(1.6, dots, Height::High)] };
        along(&line, &leaders, 2.0).map(|[_, tip]| tip.y)
    };
    assert_eq!(tip(at(10.0, 50.5), at(26.0, 50.5)), Some(50.0), "the second is nearer");
    assert_eq!(tip(at(10.0, 51.5), at(26.0, 51.5)), Some(52.0));
    assert_eq!(tip(at(10.0, 47.5), at(26.0, 47.5)), None, "an outline beside it");
    assert_eq!(tip(at(10.0, 50.0), at(10.0, 34.0)), None, "it leads elsewhere");
}

#[test]
fn a_leader_line_that_ends_at_another_thing_leads_there() {
    let line = |points: &[(f32, f32)]| Line {
        strength: 1.0,
        runs: vec![Run::stroke(1.0, points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect())],
    };
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let tip = MmPoint::new(40.0, 50.0);
    let leads = |end: f32| {
        let own = line(&[(0.0, 50.0), (20.0, 50.0), (end, 50.0)]);
        let lines = [own, line(&[(41.0, 40.0), (41.0, 60.0)]), line(&[(20.0, 46.0), (32.0, 46.0)])];
        leads_to_other(&[MmPoint::new(0.0, 50.0), tip], &index_of_pieces(&lines, area))
    };
    assert!(leads(33.0), "it ends 4 mm from one and 8 mm from the other");
    assert!(!leads(38.0), "short of its tip by the blank before a line");
}

/// One that lost its end at a line is told, as the check tells it; in the area that it names it may end in the blank.
#[test]
fn a_leader_line_leads_to_something_from_where_it_ends_on_the_page() {
    let line = |points: &[(f32, f32)], closed: bool| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 1.0, runs: vec![Run { closed, ..Run::stroke(1.0, points) }] }
    };
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let leads = |end: f32, ends_at_line: bool| {
        let own = line(&[(0.0, 50.0), (20.0, 50.0), (end, 50.0)], false);
        let lines = [own, line(&[(39.0, 30.0), (95.0, 30.0), (95.0, 70.0), (39.0, 70.0)], true)];
        let tip = if ends_at_line { 38.0 } else { 65.0 };
        let path = vec![MmPoint::new(0.0, 50.0), MmPoint::new(tip, 50.0)];
        let leader = Leader { chain: 0, text: 0, path, ends_at_line };
        leads_on_page(&leader, &lines, &index_of_pieces(&lines, area), area)
    };
    assert!(leads(35.0, true), "4 mm before the outline at its tip");
    assert!(!leads(32.0, true), "7 mm before it");
    assert!(leads(65.0, false), "in the middle of what it names");
    assert!(!leads(32.0, false), "outside of it");
}

/// The lever of a switch ends free beside the word "switch", and goes on from the wire at its other end.
#[test]
fn what_goes_on_from_a_line_is_no_leader_line() {
    let is_lever = |others: &[(&[(f32, f32)], bool)]| {
        let lever: &[(f32, f32)] = &[(60.0, 40.0), (45.0, 50.0)];
        let mut edges = Edges::none(Size::new(100, 100));
        let mut chains: Vec<Vec<MmPoint>> = Vec::new();
        for (points, closed) in [(lever, false)].iter().chain(others) {
            let edgel = |&(x, y): &(f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 50.0, contrast: [0.0; 3] };
            edges.push(points.iter().map(edgel), *closed);
            chains.push(points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect());
        }
        is_hinged(&chains[0], 0, &chains, &edges)
    };
    let wire: (&[(f32, f32)], bool) = (&[(5.0, 50.0), (20.0, 50.0), (44.0, 50.0)], false);
    let point: (&[(f32, f32)], bool) = (&[(44.0, 49.0), (46.0, 49.0), (46.0, 51.0), (44.0, 51.0)], true);
    assert!(is_lever(&[wire]) && is_lever(&[wire, point]));
    assert!(!is_lever(&[point]), "it leads to a thing");
    assert!(!is_lever(&[wire, (&[(46.0, 50.0), (90.0, 50.0)], false)]), "it parts an outline");
    assert!(!is_lever(&[(&[(45.0, 20.0), (45.0, 49.0)], false)]), "it leads to the end of a line");
    assert!(!is_lever(&[(&[(5.0, 50.0), (35.0, 50.0)], false)]), "a line farther off");
}

#[test]
fn lines_from_words_that_lead_to_one_another_only_are_branches() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let count = |leaders: usize, others: &[[(f32, f32); 2]]| {
        let mut index = Nearby::new(area, 5.0);
        let branches = [[(60.0, 20.0), (20.0, 50.0)], [(60.0, 80.0), (20.0, 50.0)]];
        let chains: Vec<Vec<MmPoint>> =
            branches.iter().chain(others).map(|ends| ends.map(MmPoint::from).to_vec()).collect();
        for (line, path) in (0..).zip(&chains) {
            index.insert_line(line, PolylineRef { vertices: path, closed: false }, 0.0);
        }
        let leader = |chain: usize| Leader { chain, text: chain, path: chains[chain].clone(), ends_at_line: true };
        let found = (0..leaders).map(leader).collect();
        without_branches(found, &chains, |end| end.x > 55.0, &index).len()
    };
    assert_eq!(count(2, &[]), 0, "the root of a tree");
    assert_eq!(count(1, &[]), 0, "the word of one branch stands a little farther off");
    assert_eq!(count(2, &[[(18.0, 40.0), (18.0, 60.0)]]), 2, "two words for one thing");
}
