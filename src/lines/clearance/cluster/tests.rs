//! Tests of `cluster`.

use super::*;

fn path(points: &[(f32, f32)]) -> Vec<(f32, MmPoint)> {
    let mut arc = 0.0;
    let mut last = None;
    let place = |&at: &(f32, f32)| {
        let at = MmPoint::from(at);
        arc += last.map_or(0.0, |last: MmPoint| (at - last).length());
        last = Some(at);
        (arc, at)
    };
    points.iter().map(place).collect()
}

#[test]
fn a_path_leaves_its_ends_one_way_and_other_places_both_ways_however_short_it_is() {
    let bent = path(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]);
    let way = |arc: f32, span: f32| leaves(&bent, false, arc, span).map(|way| way.map(|way| way.round().to_tuple()));
    assert_eq!(way(0.0, 4.0), [Some((1.0, 0.0)), None]);
    assert_eq!(way(10.0, 4.0), [Some((0.0, 1.0)), Some((-1.0, 0.0))]);
    assert_eq!(way(20.0, 40.0)[0], None);
    assert!(leaves(&bent, false, 5.0, 40.0).iter().all(Option::is_some), "to its end");
    let ring = path(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)]);
    let at_start = leaves(&ring, true, 0.0, 4.0).map(|way| way.map(|way| way.round().to_tuple()));
    assert_eq!(at_start, [Some((1.0, 0.0)), Some((0.0, 1.0))]);
}

#[test]
fn lines_beside_one_another_are_told_by_their_directions() {
    let line = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        leaves(&path(&[(0.0, 0.0), (3.0 * cos, 3.0 * sin)]), false, 0.0, 4.0)
    };
    assert!(are_apart(line(0.0), line(40.0)) && are_apart(line(10.0), line(-100.0)));
    assert!(!are_apart(line(0.0), line(30.0)));
}
