//! Tests of `second_row`.

use super::*;
use std::collections::BTreeSet;

fn drawn(cells: &[GridDot], closed: bool) -> String {
    let first: BTreeSet<GridDot> = cells.iter().copied().collect();
    let second: BTreeSet<GridDot> = on_grid(cells, closed).into_iter().map(|(_, cell)| cell).collect();
    let all: Vec<GridDot> = first.union(&second).copied().collect();
    let range = |axis: usize| {
        let values = all.iter().map(|cell| cell[axis]);
        values.clone().min().unwrap_or(0)..=values.max().unwrap_or(0)
    };
    let sign = |cell: GridDot| match (first.contains(&cell), second.contains(&cell)) {
        (true, _) => '#',
        (_, true) => 'o',
        _ => '.',
    };
    range(1).map(|y| range(0).map(|x| sign([x, y])).collect::<String>() + "\n").collect()
}

#[test]
fn a_line_is_two_dots_wide_around_corners() {
    let right_and_down: Vec<GridDot> = (0..5).map(|x| [x, 0]).chain((1..5).map(|y| [4, y])).collect();
    assert_eq!(drawn(&right_and_down, false), "#####\noooo#\n...o#\n...o#\n...o#\n");
    let back: Vec<GridDot> = right_and_down.into_iter().rev().collect();
    assert_eq!(drawn(&back, false), "ooooo.\n#####o\n....#o\n....#o\n....#o\n....#o\n");
}

#[test]
fn both_corners_of_a_bar_are_alike() {
    let (up, down) = ((1..4).rev().map(|y| [0, y]), (1..4).map(|y| [4, y]));
    let bar: Vec<GridDot> = up.chain((0..5).map(|x| [x, 0])).chain(down).collect();
    let back: Vec<GridDot> = bar.iter().rev().copied().collect();
    assert_eq!(drawn(&bar, false), "#####\n#ooo#\n#o.o#\n#o.o#\n");
    assert_eq!(drawn(&back, false), ".ooooo.\no#####o\no#...#o\no#...#o\no#...#o\n");
}

#[test]
fn a_ring_has_its_second_row_inside_whichever_way_it_runs() {
    let side = |from: GridDot, step: GridDot| (0..5).map(move |i| [from[0] + i * step[0], from[1] + i * step[1]]);
    let ring: Vec<GridDot> = side([0, 0], [1, 0])
        .chain(side([5, 0], [0, 1]))
        .chain(side([5, 5], [-1, 0]))
        .chain(side([0, 5], [0, -1]))
        .collect();
    let want = "######\n#oooo#\n#o..o#\n#o..o#\n#oooo#\n######\n";
    assert_eq!(drawn(&ring, true), want);
    let back: Vec<GridDot> = ring.into_iter().rev().collect();
    assert_eq!(drawn(&back, true), want);
}

#[test]
fn slanting_lines_have_no_holes() {
    let slanting: Vec<GridDot> = (0..6).map(|i| [i, i / 2]).collect();
    assert_eq!(drawn(&slanting, false), "##....\noo##..\n..oo##\n....oo\n");
    let steep: Vec<GridDot> = (0..4).map(|i| [i, i]).collect();
    assert_eq!(drawn(&steep, false), "#...\no#..\n.o#.\n..o#\n...o\n");
}

#[test]
fn anywhere_the_second_row_lies_a_pitch_to_the_right() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let row = anywhere(&[at(0.0, 5.0), at(2.5, 5.0), at(5.0, 5.0)], false, 2.5);
    // y points down, so the right of a line that runs to the right lies below it
    assert_eq!(row, [(0, at(0.0, 7.5)), (1, at(2.5, 7.5)), (2, at(5.0, 7.5))]);
    let ring = anywhere(&[at(0.0, 0.0), at(10.0, 0.0), at(10.0, 10.0), at(0.0, 10.0)], true, 2.0);
    let is_inside = |(_, dot): &(usize, MmPoint)| (*dot - at(5.0, 5.0)).length() < 5.1;
    assert!(ring.len() == 4 && ring.iter().all(is_inside), "{ring:?}");
    assert_eq!(anywhere(&[at(1.0, 1.0)], false, 2.5).len(), 1);
}

#[test]
fn short_pieces_of_a_second_row_are_left_out() {
    let row = [[0, 0], [1, 0], [5, 0], [6, 1], [7, 1], [12, 0]];
    let row: Vec<(usize, GridDot)> = row.into_iter().enumerate().collect();
    assert_eq!(without_short_pieces(row.clone(), 3), [[5, 0], [6, 1], [7, 1]]);
    assert_eq!(without_short_pieces(row.clone(), 1).len(), row.len());
    assert_eq!(without_short_pieces(Vec::new(), 3), [[0; 2]; 0]);
}
