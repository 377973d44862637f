//! Tests of `clip`.

use super::*;

fn parts(points: &[(f32, f32)], closed: bool) -> Vec<Vec<(f32, f32)>> {
    let points: Vec<MmPoint> = points.iter().map(|&at| at.into()).collect();
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 50.0));
    inside(&points, closed, area).iter().map(|part| part.iter().map(|at| (at.x, at.y)).collect()).collect()
}

#[test]
fn a_line_is_cut_where_it_leaves_the_sheet_and_goes_on_where_it_comes_back() {
    let whole = [(10.0, 10.0), (90.0, 40.0)];
    assert_eq!(parts(&whole, false), [whole.to_vec()]);
    let twice = [(-10.0, 20.0), (50.0, 20.0), (50.0, 60.0), (70.0, 60.0), (70.0, 10.0)];
    let left = [vec![(0.0, 20.0), (50.0, 20.0), (50.0, 50.0)], vec![(70.0, 50.0), (70.0, 10.0)]];
    assert_eq!(parts(&twice, false), left);
    assert!(parts(&[(-10.0, -10.0), (110.0, -10.0)], false).is_empty());
}

#[test]
fn a_ring_that_leaves_the_sheet_is_one_line() {
    let ring = [(20.0, 20.0), (20.0, 60.0), (80.0, 60.0), (80.0, 20.0)];
    assert_eq!(parts(&ring, true), [[(80.0, 50.0), (80.0, 20.0), (20.0, 20.0), (20.0, 50.0)].to_vec()]);
}
