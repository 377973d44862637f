//! Tests of `skeleton`.

use super::*;
use proptest::prelude::*;

fn skeleton(rows: &[&str]) -> (Vec<SkeletonPath>, Vec<SkeletonNode>) {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let cells = rows.concat().into_bytes();
    let mut mask = StrokeMask::new(size, (0..cells.len()).filter(|&cell| cells[cell] == b'#'));
    mask.thin();
    mask.paths()
}

#[test]
fn a_bar_is_one_path_along_its_middle() {
    let (paths, nodes) = skeleton(&["..........", ".########.", ".########.", ".########.", ".........."]);
    assert!(nodes.is_empty() && paths.len() == 1 && !paths[0].closed);
    assert!(paths[0].points.iter().all(|at| (at.y - 2.5).abs() < 1e-6), "{paths:?}");
}

#[test]
fn a_diagonal_two_pixels_wide_stays() {
    let rows: Vec<String> = (0..16)
        .map(|y: i32| (0..18).map(|x: i32| if (0..=1).contains(&(x - y)) && y > 0 { '#' } else { '.' }).collect())
        .collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let (paths, nodes) = skeleton(&rows);
    assert!(nodes.is_empty(), "{nodes:?}");
    assert!(matches!(&paths[..], [line] if line.points.len() >= 12), "{paths:?}");
}

#[test]
fn a_ring_is_closed() {
    let (paths, nodes) = skeleton(&[".........", ".#######.", ".#.....#.", ".#.....#.", ".#######.", "........."]);
    assert!(nodes.is_empty(), "{nodes:?}");
    assert!(matches!(&paths[..], [ring] if ring.closed && ring.points.len() >= 14), "{paths:?}");
}

#[test]
fn a_loop_comes_back_to_its_junction_and_leaves_what_hangs_on_it() {
    let rows = [
        "....#....",
        "....#....",
        "....#....",
        "...#.#...",
        "..#...#..",
        ".#.....#.",
        ".#.....#.",
        ".#######.",
        ".........",
    ];
    let (paths, nodes) = skeleton(&rows);
    assert_eq!(nodes.len(), 1, "{nodes:?}");
    let mut at_node: Vec<usize> = paths.iter().map(|path| path.nodes.iter().flatten().count()).collect();
    at_node.sort_unstable();
    assert_eq!(at_node, [1, 2], "a loop and what hangs on it: {paths:?}");
}

#[test]
fn a_cross_has_four_arms_from_one_junction() {
    let rows = ["....#....", "....#....", "....#....", "....#....", "#########", "....#....", "....#....", "....#...."];
    let (paths, nodes) = skeleton(&rows);
    assert_eq!((paths.len(), nodes.len()), (4, 1));
    assert!(paths.iter().all(|path| path.nodes.iter().flatten().count() == 1));
    assert!((nodes[0].at - PxPoint::new(4.5, 4.5)).length() < 0.8, "{nodes:?}");
}

#[test]
fn junctions_side_by_side_are_one() {
    let rows = ["...#......", "...#......", "...#......", "##########", "....#.....", "....#.....", "....#....."];
    let (paths, nodes) = skeleton(&rows);
    assert_eq!((paths.len(), nodes.len()), (4, 1), "{paths:?}\n{nodes:?}");
    assert!((nodes[0].at - PxPoint::new(4.0, 3.5)).length() < 0.1, "{nodes:?}");
}

#[test]
fn a_path_that_ends_beside_its_own_junction_comes_back_to_it_only_after_a_way_round() {
    // the first pixel is the junction
    let path = |pixels: &[(usize, usize)]| {
        let mask = StrokeMask::new(Size::new(6, 6), pixels.iter().map(|(x, y)| 6 * y + x));
        let cell = |(x, y): (usize, usize)| (y + 1) * mask.stride + x + 1;
        let mut node_of = vec![None; mask.cells.len()];
        node_of[cell(pixels[0])] = Some(0);
        let mut walk = Walk { mask: &mask, node_of: &node_of, seen: vec![false; mask.cells.len()], paths: Vec::new() };
        walk.follow(cell(pixels[0]), cell(pixels[1]));
        let [path] = &walk.paths[..] else { panic!("{:?}", walk.paths) };
        (path.points.len(), path.nodes)
    };
    assert_eq!(path(&[(2, 2), (3, 2)]), (1, [Some(0), None]));
    assert_eq!(path(&[(2, 2), (3, 2), (3, 3)]), (2, [Some(0), None]));
    assert_eq!(path(&[(2, 2), (3, 2), (3, 3), (2, 3)]), (3, [Some(0), Some(0)]));
    assert_eq!(path(&[(1, 1), (2, 1), (3, 1), (4, 1), (5, 1)]), (4, [Some(0), None]), "it leads away");
}

/// Thins a mask without keeping which neighbours of pixels are set.
fn thin_plainly(mask: &mut StrokeMask) {
    let ring = |mask: &StrokeMask, cell: usize| {
        let is_set = |k: &usize| mask.cells[mask.neighbour(cell, *k)];
        (0..8).filter(is_set).map(|k| 1_usize << k).sum::<usize>()
    };
    loop {
        let before = mask.cells.clone();
        for second in [false, true] {
            let goes = |cell: &usize| mask.cells[*cell] && is_removable(ring(mask, *cell), second);
            let gone: Vec<usize> = (0..before.len()).filter(goes).collect();
            gone.iter().for_each(|&cell| mask.cells[cell] = false);
        }
        if mask.cells == before {
            break;
        }
    }
    for cell in 0..mask.cells.len() {
        if mask.cells[cell] && mask.is_step(cell) {
            mask.cells[cell] = false;
        }
    }
}

proptest! {
    #[test]
    fn neighbours_that_are_kept_beside_the_mask_are_those_in_it(
        is_set in prop::collection::vec(prop::bool::weighted(0.8), 14 * 9),
    ) {
        let mut mask = StrokeMask::new(Size::new(14, 9), (0..is_set.len()).filter(|&cell| is_set[cell]));
        let mut plain = mask.clone();
        mask.thin();
        thin_plainly(&mut plain);
        prop_assert_eq!(&mask.cells, &plain.cells);
        let left: Vec<usize> = (0..mask.cells.len()).filter(|&cell| mask.cells[cell]).collect();
        prop_assert_eq!(mask.set, left);
    }
}
