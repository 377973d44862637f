//! Tests of `paths`.

use super::*;
use crate::page::Height;

#[test]
fn a_row_is_broken_at_a_hole_and_one_of_every_second_dot_is_whole() {
    let pieces = |columns: &[u8]| {
        let dots = columns.iter().map(|column| MmPoint::new(10.0 + 2.0 * f32::from(*column), 20.0)).collect();
        let line = Line { strength: 20.0, runs: vec![Run::dots(1.6, dots, Height::High)] };
        Paths::broken(&[line], 3.0).paths.len()
    };
    assert_eq!(pieces(&[0, 1, 2, 3, 4]), 1);
    assert_eq!(pieces(&[0, 1, 2, 4, 5, 6]), 2, "a hole");
    assert_eq!(pieces(&[0, 2, 4, 6]), 1);
    assert_eq!(pieces(&[0, 1, 3, 5, 7]), 1, "a leader line from a label on");
    assert_eq!(pieces(&[0, 2, 4, 8]), 4, "a hole in it");
    assert_eq!(pieces(&[0, 2]), 2, "two dots");
    assert_eq!(pieces(&[0, 1, 3]), 2, "a hole in a short line");
    assert_eq!(pieces(&[0, 1, 3, 4, 6, 7]), 3, "dashes");
}
