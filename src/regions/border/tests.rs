//! Tests of `border`.

use super::*;

/// The borders of a map of digits: label, number of sides, whether closed.
fn check(rows: &[&str], count: usize, expected: &[(u8, usize, bool)]) -> Vec<Border> {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let labels: Vec<u8> = rows.iter().flat_map(|row| row.bytes()).map(|digit| digit - b'0').collect();
    let borders = borders(&labels, count, size);
    let sides = |border: &Border| border.corners.len() - usize::from(!border.closed);
    let found: Vec<_> = borders.iter().map(|border| (border.label, sides(border), border.closed)).collect();
    assert_eq!(found, expected);
    borders
}

#[test]
fn an_area_has_a_ring_and_one_at_the_frame_an_open_border() {
    check(&["0000", "0110", "0000"], 1, &[(1, 6, true)]);
    check(&["0110", "0110", "0000"], 1, &[(1, 6, false)]);
    check(&["1111", "1001", "1111"], 1, &[(1, 6, true)]);
    check(&["1111", "1111"], 1, &[]);
}

#[test]
fn neighbours_share_one_border_which_belongs_to_the_first() {
    let borders = check(&["000000", "011220", "011220", "000000"], 2, &[(1, 8, true), (2, 6, false)]);
    let of_first = |corner| borders[0].corners.contains(corner);
    let ends = [borders[1].corners.first(), borders[1].corners.last()];
    assert!(ends.iter().flatten().all(|corner| of_first(corner)), "the second ends on the first");
    assert_eq!(borders[1].corners.iter().filter(|corner| of_first(corner)).count(), 2);
}

#[test]
fn areas_that_share_a_corner_are_two() {
    check(&["0000", "0100", "0010", "0000"], 1, &[(1, 4, true), (1, 4, true)]);
}
