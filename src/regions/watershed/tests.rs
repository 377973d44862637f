//! Tests of `watershed`.

use super::*;
use crate::units::Size;

/// The basins of a landscape of digits, as letters.
fn check(rows: &[&str], expected: &[&str]) {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let values = rows.iter().flat_map(|row| row.bytes()).map(|digit| f32::from(digit - b'0')).collect();
    let (basins, _) = basins(&Plane { size, values });
    let letters: Vec<String> = basins
        .chunks(rows[0].len())
        .map(|row| row.iter().map(|basin| char::from(b'a' + *basin as u8)).collect())
        .collect();
    assert_eq!(letters, expected);
}

#[test]
fn each_cell_goes_to_the_minimum_below_it() {
    check(&["12921", "13921", "12911"], &["aaabb", "aabbb", "aabbb"]);
    check(&["1239431"], &["aaaabbb"]);
}

#[test]
fn a_plain_belongs_to_the_nearest_way_down_and_a_bottom_is_one_basin() {
    check(&["0555555"], &["aaaaaaa"]);
    check(&["05555550"], &["aaaabbbb"]);
    check(&["000", "090", "000"], &["aaa", "aaa", "aaa"]);
    check(&["3333", "3333"], &["aaaa", "aaaa"]);
}
