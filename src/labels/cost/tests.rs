//! Tests of `cost`.

use super::*;

/// A word of 40 mm for a print of 15 mm at the end of a leader line, which comes from the left: in the row of that its
/// middle is 14 mm further on, and it begins 4 mm behind the end.
#[test]
fn onwards_a_word_is_as_far_from_its_leader_line_as_it_begins_behind_it() {
    let (end, middle) = (MmPoint::new(100.0, 50.0), 110.0);
    let onwards = |from: f32, leader: Option<MmPoint>| {
        let place = MmRect::new(MmPoint::new(from, 47.0), MmPoint::new(from + 40.0, 53.0));
        onwards(leader, -1.0, place, place.center().x - middle)
    };
    assert!((onwards(104.0, Some(end)) - 4.0).abs() < 1e-3);
    assert!((onwards(114.0, Some(end)) - 14.0).abs() < 1e-3, "further off it is worse");
    assert!((onwards(104.0, None) - 14.0).abs() < 1e-3, "without a leader line from middle to middle");
    assert!((onwards(92.0, Some(end)) - 2.0).abs() < 1e-3, "under the leader line, too");
    let mirrored = MmRect::new(MmPoint::new(56.0, 47.0), MmPoint::new(96.0, 53.0));
    assert!((super::onwards(Some(end), 1.0, mirrored, -14.0) - 4.0).abs() < 1e-3, "one from the right");
}
