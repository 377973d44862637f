//! Tests of `walk`.

use super::*;
use crate::units::{MmPoint, MmVector};

/// Vertices 1 mm apart: 3 to the right, then 3 down.
fn corner(closed: bool) -> Polyline<MmPoint> {
    let points = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (3, 2), (3, 3)];
    Polyline { vertices: points.map(|(x, y)| MmPoint::new(x as f32, y as f32)).into(), closed }
}

#[test]
fn a_walk_counts_arc_length_to_the_end_and_once_round() {
    let steps = |closed, forwards| corner(closed).walk(2, forwards).collect::<Vec<_>>();
    assert_eq!(steps(false, false), [(2, 0.0), (1, 1.0), (0, 2.0)]);
    assert_eq!(steps(true, false).len(), 7);
    let (vertex, arc) = steps(true, false)[3];
    assert!(vertex == 6 && (arc - 2.0 - 18.0_f32.sqrt()).abs() < 1e-6);
}

#[test]
fn a_heading_leads_away_from_a_vertex_without_what_is_near() {
    let (right, down) = (MmVector::new(1.0, 0.0), MmVector::new(0.0, 1.0));
    assert_eq!(corner(false).heading(0, true, [0.0, 2.0]), Some(right));
    assert_eq!(corner(false).heading(0, true, [3.0, 6.0]), Some(down));
    assert_eq!(corner(false).heading(6, false, [0.0, 3.0]), Some(-down));
    assert_eq!(corner(false).heading(6, false, [3.0, 5.0]), Some(-right));
    assert_eq!(corner(false).heading(4, true, [0.0, 3.0]), None, "it ends 2 mm from there");
    let over_the_seam = corner(true).heading(5, true, [1.0, 4.0]);
    assert!(over_the_seam.is_some_and(|ahead| (ahead - MmVector::new(-1.0, -1.0) * 0.5_f32.sqrt()).length() < 1e-6));
}

#[test]
fn the_runs_of_a_ring_do_not_depend_on_where_it_begins() {
    let of = |signs: &[u8], closed| runs(signs.len(), closed, |a, b| signs[a] == signs[b]);
    assert_eq!(of(b"aabbba", false), [vec![0, 1], vec![2, 3, 4], vec![5]]);
    assert_eq!(of(b"aabbba", true), [vec![2, 3, 4], vec![5, 0, 1]]);
    assert_eq!(of(b"aaa", true), [[0, 1, 2]]);
    assert_eq!(of(b"", true), [[0; 0]; 0]);
    let signs = b"aaabbacccc";
    for turn in 0..signs.len() {
        let mut turned = *signs;
        turned.rotate_left(turn);
        let mut found: Vec<Vec<usize>> =
            of(&turned, true).iter().map(|run| run.iter().map(|i| (i + turn) % signs.len()).collect()).collect();
        found.sort();
        assert_eq!(found, [vec![0, 1, 2], vec![3, 4], vec![5], vec![6, 7, 8, 9]]);
    }
}

#[test]
fn between_two_places_of_a_ring_the_shorter_way_counts() {
    let is = |s: f32, t: f32, ring_length: Option<f32>, way: f32| (arc_between(s, t, ring_length) - way).abs() < 1e-4;
    assert!(is(98.0, 2.0, None, 96.0) && is(98.0, 2.0, Some(100.0), 4.0) && is(30.0, 60.0, Some(100.0), 30.0));
}

#[test]
fn an_end_has_the_heading_of_its_last_stretch_and_a_short_line_that_of_all_of_it() {
    let points = [(9.0, 4.0), (9.0, 3.0), (9.0, 0.0), (0.0, 0.0)].map(MmPoint::from);
    let heading = |count: usize| heading_of_end(points[..count].iter().copied(), 2.0);
    assert_eq!(heading(4), Some(MmVector::new(0.0, 1.0)));
    assert_eq!(heading(2), Some(MmVector::new(0.0, 1.0)), "no point is so far");
    assert_eq!(heading(1), None);
}
