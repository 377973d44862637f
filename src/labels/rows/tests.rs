//! Tests of `rows`.

use super::*;

#[test]
fn labels_stand_side_by_side_as_near_as_they_can() {
    let cases = [
        ([0.0, 10.0, 20.0], [0.0, 10.0, 20.0]),
        // the first two share what they lack; the third has room
        ([0.0, 4.0, 30.0], [-2.0, 6.0, 30.0]),
        // a pool that grows back over the one before it
        ([0.0, 8.0, 8.0], [-8.0 / 3.0, 16.0 / 3.0, 40.0 / 3.0]),
    ];
    for (wanted, placed) in cases {
        let starts = side_by_side(&wanted, &[8.0, 8.0, 8.0]);
        assert!(starts.iter().zip(&placed).all(|(start, at)| (start - at).abs() < 1e-4), "{starts:?}");
        assert_eq!(starts.len(), 3);
    }
}
