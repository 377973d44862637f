//! Tests of `majority`: against shares that are shrunk and blurred of whole planes.

use super::*;
use crate::raster::shrink::shrink;

#[test]
fn the_labels_are_those_of_shares_of_the_whole_map() {
    let mut seen = std::collections::BTreeSet::new();
    for (width, height, across, down) in [(61, 47, 24, 19), (40, 33, 40, 33), (37, 20, 30, 16), (50, 9, 3, 1)] {
        let [fine, coarse] = [Size::new(width, height), Size::new(across, down)];
        for seed in 1..5_usize {
            // blocks of labels, of which 3 is nowhere, and single cells
            let label = |cell: usize| {
                let (x, y) = (cell % width as usize, cell / width as usize);
                let block = (x / (5 + seed) * 7 + y / (12 - seed) * 5 + seed) % 4;
                let block = if (cell * 7919 + seed * 104_729) % 89 < 4 { 3 - block } else { block };
                [0_u8, 1, 2, 4][block]
            };
            let labels: Vec<u8> = (0..fine.len()).map(label).collect();
            for sigma in [0.4, 0.9, 2.0] {
                let (mut best, mut expected) = (vec![0.0_f32; coarse.len()], vec![0; coarse.len()]);
                for label in 0..=4 {
                    let is_own = |other: &u8| f32::from(u8::from(*other == label));
                    let all: Vec<f32> = labels.iter().map(is_own).collect();
                    let shares = shrink(&all, fine, coarse).blurred(sigma).values;
                    for (cell, share) in shares.into_iter().enumerate() {
                        if share > best[cell] {
                            (best[cell], expected[cell]) = (share, label);
                        }
                    }
                }
                seen.extend(expected.iter().copied());
                assert_eq!(majority(&labels, 4, [fine, coarse], sigma), expected, "{coarse:?}, seed {seed}, {sigma}");
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<u8>>(), [0, 1, 2, 4], "each label wins somewhere");
}

#[test]
fn the_share_of_a_label_is_that_of_a_shrunk_plane_to_the_bit() {
    let (fine, coarse) = (Size::new(53, 29), Size::new(20, 11));
    let labels: Vec<u8> = (0..fine.len()).map(|cell| ((cell / 7 + cell % 53 / 9) % 3) as u8).collect();
    let map = Map::new(&labels, fine, coarse);
    for label in 0..3 {
        let all: Vec<f32> = labels.iter().map(|other| f32::from(u8::from(*other == label))).collect();
        let place = CellBox { left: 0, top: 0, right: 20, bottom: 11 };
        assert_eq!(map.shares(label, place), shrink(&all, fine, coarse), "label {label}");
    }
}
