//! Tests of `spaced_row`.

use super::*;

/// Where the dots of a level row stand, in mm, that are left of one with these.
fn left(row: &[i32], pitch: f32) -> Vec<i32> {
    let row: Vec<MmPoint> = row.iter().map(|&x| MmPoint::new(x as f32, 20.0)).collect();
    every_second(&row, pitch).iter().map(|dot| dot.x as i32).collect()
}

#[test]
fn every_second_dot_is_left_and_those_at_both_ends() {
    assert_eq!(left(&[10, 12, 14, 16, 18], 2.0), [10, 14, 18]);
    assert_eq!(left(&[10, 12, 14, 16, 18, 20], 2.0), [10, 12, 16, 20], "10 mm");
    assert_eq!(left(&[20, 18, 16, 14, 12, 10], 2.0), [20, 18, 14, 10], "its tip is its last dot");
}

#[test]
fn a_short_one_stays_as_it_is() {
    assert_eq!(left(&[10, 12, 14, 16], 2.0), [10, 12, 14, 16]);
    assert!(left(&[], 2.0).is_empty());
}

#[test]
fn there_are_dots_on_both_sides_of_a_hole() {
    assert_eq!(left(&[10, 12, 14, 18, 20, 22], 2.0), [10, 14, 18, 22]);
    assert_eq!(left(&[10, 12, 14, 18, 20, 22, 24], 2.0), [10, 14, 18, 20, 24], "and so with one dot more behind it");
    assert_eq!(left(&[10, 12, 14, 16, 20, 22, 24], 2.0), [10, 12, 16, 20, 24], "or before it");
}

#[test]
fn what_is_left_of_a_row_is_told_from_a_line() {
    let is_of_leader = |row: &[i32]| {
        let row: Vec<MmPoint> = row.iter().map(|&x| MmPoint::new(x as f32, 20.0)).collect();
        has_every_second(&row, 3.0)
    };
    assert!(is_of_leader(&[10, 14, 18]) && is_of_leader(&[10, 12, 16, 20]));
    assert!(is_of_leader(&[10, 14, 18, 20, 24]), "behind a hole");
    assert!(!is_of_leader(&[10, 12, 14, 16]), "a line");
    assert!(!is_of_leader(&[10, 14, 22]), "a hole");
    assert!(!is_of_leader(&[]) && !is_of_leader(&[10]) && !is_of_leader(&[10, 14]), "no row");
    assert!(!is_of_leader(&[10, 12, 16]), "a line with a hole");
    assert!(!is_of_leader(&[10, 12, 16, 18, 22, 24]), "dashes");
}
