//! Tests of `distance`.

use super::*;

#[test]
fn distances_are_those_of_a_search_over_all() {
    let size = Size::new(17, 13);
    for seed in 1..20_usize {
        let is_set: Vec<bool> = (0..size.len()).map(|cell| (cell * 7919 + seed * 104_729) % 61 < 2).collect();
        let place = |cell: usize| (cell % 17, cell / 17);
        let square = |a: usize, b: usize| {
            let ((ax, ay), (bx, by)) = (place(a), place(b));
            (ax.abs_diff(bx).pow(2) + ay.abs_diff(by).pow(2)) as u32
        };
        for (cell, &distance) in squared_distances(&is_set, size).iter().enumerate() {
            let least = (0..size.len()).filter(|&other| is_set[other]).map(|other| square(cell, other)).min();
            assert_eq!(Some(distance), least);
        }
    }
    let none = vec![false; size.len()];
    assert!(squared_distances(&none, size).iter().all(|&distance| distance == FAR));
    assert!(distances(&none, size).iter().all(|distance| distance.is_infinite()));
}
