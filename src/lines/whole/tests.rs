//! Tests of `whole`.

use super::*;
use crate::lines::clearance::tests::polyline;
use crate::lines::tests::area;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

/// Two countries side by side, the coast of each open at the border; the border; a river with its mouth at the coast;
/// and a lake.
fn map() -> Vec<Polyline<Vertex>> {
    vec![
        polyline(&[(50.0, 10.0), (10.0, 10.0), (10.0, 90.0), (50.0, 90.0)], false),
        polyline(&[(50.0, 10.0), (90.0, 10.0), (90.0, 90.0), (50.0, 90.0)], false),
        polyline(&[(50.0, 10.0), (50.0, 90.0)], false),
        polyline(&[(30.0, 30.0), (30.0, 90.0)], false),
        polyline(&[(65.0, 40.0), (75.0, 40.0), (75.0, 60.0), (65.0, 60.0)], true),
    ]
}

#[test]
fn coasts_go_before_what_lies_inside() {
    let map = map();
    let ground = Ground::of(map.iter(), area());
    let ranks = |of: Rank| {
        let lines: Vec<_> = map.iter().cloned().map(|line| (line, of)).collect();
        let ranked = ground.outline_first(&lines, &PARAMS);
        ranked.map(|lines| lines.into_iter().map(|(_, rank)| rank).collect::<Vec<_>>())
    };
    let (whole, other) = (Rank::Whole, Rank::Ordinary);
    assert_eq!(ranks(Rank::Ordinary), Some(vec![whole, whole, other, other, other]));
    assert_eq!(ranks(Rank::Faint), None, "they have their rank");
    let coasts: Vec<_> = map[..2].iter().cloned().map(|line| (line, Rank::Ordinary)).collect();
    assert!(ground.outline_first(&coasts, &PARAMS).is_none(), "there is nothing else");
}

#[test]
fn what_lines_enclose_is_open_where_a_part_of_its_coast_is_missing() {
    let map = map();
    let ground = Ground::of(map.iter(), area());
    let opened = |lines: &[Polyline<Vertex>]| ground.opened(&Ground::of(lines.iter(), area()));
    let close = |share: f32, wanted: f32| (share - wanted).abs() < 0.02;
    assert!(close(opened(&map), 0.0));
    assert!(close(opened(&map[..2]), 0.0), "it is whole, though nothing is in it");
    assert!(close(opened(&map[..1]), 1.0), "a coast without the other one encloses nothing");
    assert!(close(opened(&[]), 1.0));
    // 8 mm of the left coast are missing, and the border keeps the right country closed
    let upper = polyline(&[(50.0, 10.0), (10.0, 10.0), (10.0, 40.0)], false);
    let lower = polyline(&[(10.0, 48.0), (10.0, 90.0), (50.0, 90.0)], false);
    let torn: Vec<_> = [upper, lower].into_iter().chain(map[1..].iter().cloned()).collect();
    assert!(close(opened(&torn), 0.5), "{}", opened(&torn));
    // a line that is moved by as much as fingers do not notice opens nothing
    let mut moved = map.clone();
    moved.iter_mut().flat_map(|line| &mut line.vertices).for_each(|vertex| vertex.at.x += 0.8);
    assert!(close(opened(&moved), 0.0));
}
