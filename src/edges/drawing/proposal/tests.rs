//! Tests of `proposal`.

use super::*;

fn found(wanted: &[bool], closed: bool) -> Vec<(usize, usize, bool)> {
    stretches(wanted, closed).iter().map(|stretch| (stretch.first, stretch.count, stretch.whole_ring)).collect()
}

#[test]
fn a_stretch_goes_over_the_first_segment_of_a_ring_and_not_of_a_line() {
    let wanted = [true, true, false, false, true];
    assert_eq!(found(&wanted, false), [(0, 2, false), (4, 1, false)]);
    assert_eq!(found(&wanted, true), [(4, 3, false)]);
    assert_eq!(found(&[true; 3], true), [(0, 3, true)]);
    assert_eq!(found(&[false; 3], true), []);
}
