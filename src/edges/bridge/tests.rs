//! Tests of `bridge`.

use super::super::contour::testing::polyline;
use super::*;

const SIGMA: f32 = 1.5;

/// The joined contours: number of points, and whether they are closed.
fn joined(contours: &[Contour]) -> Vec<(usize, bool)> {
    join(contours.to_vec(), SIGMA, false).iter().map(|contour| (contour.vertices.len(), contour.closed)).collect()
}

#[test]
fn aligned_ends_are_joined_over_a_gap_with_points_of_large_position_error() {
    let (left, right) = (polyline(&[(0.0, 0.0), (20.0, 0.0)]), polyline(&[(26.0, 0.0), (46.0, 0.0)]));
    // whatever the directions in which the contours run
    for contours in [[left.clone(), right.clone()], [right.clone().reversed(), left.clone()]] {
        let whole = join(contours.to_vec(), SIGMA, false);
        assert_eq!(whole.len(), 1);
        assert_eq!((whole[0].vertices.len(), whole[0].closed), (47, false));
        assert!((whole[0].length() - 46.0).abs() < 1e-3, "{}", whole[0].length());
        let bridged = whole[0].vertices.iter().filter(|point| point.position_sigma >= GAP_SIGMA);
        assert!(bridged.map(|point| point.at.x).all(|x| x > 20.5 && x < 25.5), "only the gap is uncertain");
    }
    let far = polyline(&[(30.0, 0.0), (46.0, 0.0)]);
    assert_eq!(joined(&[left.clone(), far]).len(), 2, "the gap is too wide");
    let aside = polyline(&[(24.0, 4.0), (44.0, 4.0)]);
    assert_eq!(joined(&[left, aside]).len(), 2, "the ends do not point at one another");
}

#[test]
fn ends_at_a_corner_are_joined_only_with_the_same_colours_on_the_same_sides() {
    let (along, down) = (polyline(&[(0.0, 0.0), (20.0, 0.0)]), polyline(&[(21.5, 1.5), (21.5, 20.0)]));
    assert_eq!(joined(&[along.clone(), down.clone()]).len(), 1);
    let mut opposite = down;
    opposite.vertices.iter_mut().for_each(|point| *point = point.reversed());
    assert_eq!(joined(&[along, opposite]).len(), 2);
}

#[test]
fn a_contour_whose_ends_meet_is_closed_and_a_short_one_is_not() {
    let square = polyline(&[(3.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0), (0.0, 0.0), (1.0, 0.0)]);
    assert_eq!(joined(std::slice::from_ref(&square)), [(square.vertices.len() + 1, true)]);
    let hook = polyline(&[(3.0, 0.0), (3.0, 2.0), (0.0, 2.0), (0.0, 0.0)]);
    assert_eq!(joined(std::slice::from_ref(&hook)), [(hook.vertices.len(), false)]);
}

#[test]
fn halves_of_a_ring_become_one_closed_contour() {
    let upper = polyline(&[(0.0, 9.0), (0.0, 0.0), (30.0, 0.0), (30.0, 9.0)]);
    let lower = polyline(&[(30.0, 12.0), (30.0, 20.0), (0.0, 20.0), (0.0, 12.0)]);
    let whole = join(vec![upper, lower.reversed()], SIGMA, false);
    assert_eq!(whole.len(), 1);
    assert!(whole[0].closed && (whole[0].length() - 100.0).abs() < 1e-3, "{}", whole[0].length());
}

/// It has no ends, though a piece of it has no points.
#[test]
fn a_ring_stays_as_it_is_beside_an_end_that_points_at_where_it_begins() {
    let mut ring = polyline(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0), (0.0, 4.0)]);
    ring.closed = true;
    let beside = polyline(&[(-24.0, 0.0), (-4.0, 0.0)]);
    let counts = [ring.vertices.len(), beside.vertices.len()];
    let mut all = joined(&[ring, beside]);
    all.sort_unstable();
    assert_eq!(all, [(counts[1], false), (counts[0], true)]);
}

#[test]
fn a_wedge_of_a_drawing_is_closed_where_one_side_ends_farther_from_its_tip() {
    // 28 degrees, with its tip at 0, 0
    let wedge = polyline(&[(2.0, -0.5), (40.0, -10.0), (40.0, 10.0), (5.0, 1.25)]);
    let is_closed = |of_drawing: bool| join(vec![wedge.clone()], SIGMA, of_drawing)[0].closed;
    assert!(is_closed(true));
    assert!(!is_closed(false), "the contours of photographs stay as they are");
}
