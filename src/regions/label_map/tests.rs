//! Tests of `label_map`.

use super::*;

/// A map of digits, opened.
fn check(rows: &[&str], radius: f32, expected: &[&str]) {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let labels: Vec<u8> = rows.iter().flat_map(|row| row.bytes()).map(|digit| digit - b'0').collect();
    let opened = opened(&labels, size, radius);
    let found: Vec<String> = opened
        .chunks(rows[0].len())
        .map(|row| row.iter().map(|cell| char::from(b'0' + cell.label)).collect())
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn what_is_thin_goes_and_what_is_between_two_is_shared_by_them() {
    let bar = ["000000000", "000111000", "000111000", "000111000", "000010000", "000010000", "000000000"];
    let stout = ["000000000", "000111000", "000111000", "000111000", "000010000", "000000000", "000000000"];
    check(&bar, 1.0, &stout);
    let gap = ["111110222", "111110222", "111110222", "111110222"];
    let shared = ["111111222", "111111222", "111111222", "111111222"];
    check(&gap, 1.0, &shared);
}

#[test]
fn the_frame_narrows_nothing() {
    let strip = ["0111", "0111", "0111", "0111"];
    check(&strip, 2.0, &strip);
}

#[test]
fn cores_and_the_nearest_of_them_are_those_of_a_distance_transform_for_each_label() {
    let size = Size::new(31, 23);
    for seed in 1..6_usize {
        // blocks of labels, and single cells
        let label = |cell: usize| {
            let (x, y) = (cell % 31, cell / 31);
            let block = (x / (3 + seed) * 7 + y / (9 - seed) * 5 + seed) % 3;
            if (cell * 7919 + seed * 104_729) % 97 < 2 { 2 } else { block as u8 }
        };
        let labels: Vec<u8> = (0..size.len()).map(label).collect();
        for radius in [0.5_f32, 1.0, 2.3, 4.0] {
            let (wide, padded, margin) = padded(&labels, size, radius.ceil() as usize + 1);
            let square = radius * radius;
            let mut nearest: Vec<(u8, u32, bool)> = wide.iter().map(|&label| (label, FAR, false)).collect();
            for label in 0..3 {
                let is_other: Vec<bool> = wide.iter().map(|&other| other != label).collect();
                let to_other = squared_distances(&is_other, padded);
                let is_core: Vec<bool> = to_other.iter().map(|to| *to as f32 > square).collect();
                for (cell, distance) in squared_distances(&is_core, padded).into_iter().enumerate() {
                    if distance < nearest[cell].1 || (distance == nearest[cell].1 && label == wide[cell]) {
                        nearest[cell] = (label, distance, distance as f32 <= square);
                    }
                }
            }
            let (width, across) = (size.width as usize, padded.width as usize);
            let of_cell = |cell: usize| nearest[(cell / width + margin) * across + cell % width + margin];
            let opened_cell = |(label, _, is_in_reach)| OpenedCell { label, is_in_reach };
            let expected: Vec<OpenedCell> = (0..size.len()).map(of_cell).map(opened_cell).collect();
            assert_eq!(opened(&labels, size, radius), expected, "radius {radius}, seed {seed}");
        }
    }
}
