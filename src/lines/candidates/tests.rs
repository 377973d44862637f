//! Tests of `candidates`.

use super::*;

/// A level line.
fn level(y: f32, [from, to]: [f32; 2]) -> Polyline<Vertex> {
    let vertex = |x: f32| Vertex { at: MmPoint::new(x, y), width: 1.0, ..Vertex::TEST };
    let mut line = Polyline::open(vec![vertex(from), vertex(to)]);
    line.fill();
    line
}

fn cleared(line: Polyline<Vertex>, saliency: f32) -> Cleared {
    Cleared { anchored: vec![false; line.vertices.len()], polyline: line, saliency, rank: Rank::Ordinary }
}

#[test]
fn pieces_of_a_photograph_that_only_detail_leaves_out_are_not_told_as_without_room() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let [long, torn] = [level(20.0, [10.0, 80.0]), level(60.0, [10.0, 60.0])];
    let candidates = LineCandidates {
        lines: vec![(long.clone(), Rank::Ordinary), (torn, Rank::Ordinary)],
        saliencies: vec![70.0, 50.0],
        contours: 2,
        gridlines: 0,
        short: LossTally::new(area),
        points: Vec::new(),
        scales: Vec::new(),
        left_out: Vec::new(),
        lost_scales: Vec::new(),
        heads: Vec::new(),
    };
    // of the other one 20 mm have no room, and what is left are two pieces of 15 mm, less than there is to be
    let [one, other] = [level(60.0, [10.0, 25.0]), level(60.0, [45.0, 60.0])];
    let had_room = [cleared(long, 70.0), cleared(one, 15.0), cleared(other, 15.0)];
    let (drawn, all): (Vec<&Cleared>, Vec<&Cleared>) = (had_room[..1].iter().collect(), had_room.iter().collect());
    let lost = |drawn: &[&Cleared], of_drawing: bool| {
        let params = Params { of_drawing, ..Params::TEST };
        candidates.lost(drawn, &had_room, 22.0, area, &params).lost.round() as u32
    };
    // a line stands for what is near its ends, too
    let without_room = (20.0 - 2.0 * Params::TEST.max_offset()).round() as u32;
    assert!(lost(&drawn, false).abs_diff(without_room) <= 1, "{} of {without_room} mm", lost(&drawn, false));
    assert_eq!(lost(&drawn, false), lost(&all, false), "with more detail it is no other");
    assert_eq!(lost(&drawn, true), 50, "in a drawing every line is meant");
}
