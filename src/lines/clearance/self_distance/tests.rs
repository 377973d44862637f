//! Tests of `self_distance`.

use super::super::tests::polyline;
use super::*;
use crate::units::MmRect;

fn first_return(points: &[(f32, f32)], closed: bool) -> Option<Range<usize>> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    self_approach(&polyline(points, closed), &Params::TEST, &mut Nearby::new(area, Params::TEST.max_spacing()))
}

#[test]
fn a_hairpin_comes_back_and_a_wide_bend_does_not() {
    let narrow = [(10.0, 10.0), (50.0, 10.0), (50.0, 13.0), (10.0, 13.0)];
    let back = first_return(&narrow, false).expect("the second arm is too near to the first");
    // it is allowed the arc round the bend
    assert!(back.start as f32 * 0.4 > 43.0, "{back:?}");
    assert_eq!(first_return(&[(10.0, 10.0), (50.0, 10.0), (50.0, 18.0), (10.0, 18.0)], false), None);
}

#[test]
fn a_corner_is_no_return() {
    assert_eq!(first_return(&[(10.0, 10.0), (50.0, 10.0), (50.0, 50.0)], false), None);
    assert_eq!(first_return(&[(10.0, 10.0), (40.0, 10.0), (40.0, 40.0), (10.0, 40.0)], true), None);
}

#[test]
fn a_sharp_corner_is_no_return_and_a_narrow_loop_is_one() {
    // 25 degrees between its sides, which are 30 mm long
    let tip = [(10.0, 50.0), (40.0, 50.0), (12.81, 37.32)];
    assert_eq!(first_return(&tip, false), None);
    let triangle = [(10.0, 50.0), (40.0, 50.0), (12.81, 37.32)];
    for start in 0..3 {
        let turned: Vec<_> = (0..3).map(|k| triangle[(start + k) % 3]).collect();
        assert_eq!(first_return(&turned, true), None, "begun at {start}");
    }
    // 12 degrees are too few
    assert!(first_return(&[(10.0, 50.0), (40.0, 50.0), (10.66, 43.76)], false).is_some());
    // nor is a hairpin a corner that has the same distance after the same arc length
    assert!(first_return(&[(10.0, 10.0), (22.0, 10.0), (22.0, 14.0), (10.0, 14.0)], false).is_some());
}

#[test]
fn an_end_on_the_line_itself_may_be_near_it() {
    let loop_back = [(10.0, 30.0), (50.0, 30.0), (50.0, 60.0), (30.0, 60.0), (30.0, 30.0)];
    assert_eq!(first_return(&loop_back, false), None);
}
