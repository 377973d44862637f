//! Tests of `finished`.

use super::*;

#[test]
fn a_head_is_printed_as_two_short_strokes_that_are_alike() {
    let tip = MmPoint::new(50.0, 50.0);
    let head = |above: f32, below: f32| {
        let path = vec![tip + MmVector::new(-above, -above), tip, tip + MmVector::new(-below, below)];
        printed_head(&Line { strength: 60.0, runs: vec![Run::stroke(1.0, path)] }).map(|(tip, _)| tip)
    };
    assert_eq!(head(4.0, 4.0), Some(tip));
    assert_eq!(head(4.0, 6.5), None, "one is much longer");
    assert_eq!(head(20.0, 20.0), None, "no head is so long");
    assert_eq!(head(1.0, 1.0), None, "nor so short");
}
