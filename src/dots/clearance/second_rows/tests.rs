//! Second rows keep the gap, and are whole where they are to be.

use super::super::on_grid::tests::{row, taken};
use super::*;
use crate::devices::Grid;

#[test]
fn a_second_row_keeps_the_gap_from_other_lines() {
    let first = row(0, 0..12);
    let piece = RowPiece::cut_out(first.clone());
    let alone = taken(std::slice::from_ref(&first), 1);
    assert_eq!(alone.second_row((0, &piece), LEAST_DOTS, |_| true), row(1, 0..12));
    assert_eq!(alone.second_row((0, &piece), LEAST_DOTS, |cell| cell[1] < 1), row(1, 0..0));
    let beside = taken(&[first, vec![[6, 2]]], 1);
    assert_eq!(beside.second_row((0, &piece), LEAST_DOTS, |_| true), [row(1, 0..5), row(1, 8..12)].concat());
    assert_eq!(beside.second_row((0, &piece), 5, |_| true), row(1, 0..5), "four dots are too few");
}

#[test]
fn a_second_row_that_is_to_be_whole_is_on_the_side_that_has_room_or_nowhere() {
    let params =
        Params { diameter: 1.5, line_gap: 1, heavy_from: 9.0, whole_rows: true, min_length: 5.0, ..Params::TEST };
    let wall = || RowPiece::cut_out(row(0, 0..20));
    // lines that end beside it above and below
    let rows = |ends: &[GridDot], whole_rows: bool| {
        let mut taken = taken(&[row(0, 0..20)], 1);
        ends.iter().for_each(|&end| taken.take(end, 1));
        let params = Params { whole_rows, ..params };
        let mut second = taken.wider_side((0, &wall()), 3, &params, |_| true);
        second.sort_unstable();
        second
    };
    assert_eq!(rows(&[], true), row(1, 0..20));
    assert_eq!(rows(&[[10, 2]], true), row(-1, 0..20), "below there is a line");
    assert!(rows(&[[10, 2], [5, -2]], true).is_empty());
    assert!(!rows(&[[10, 2], [5, -2]], false).is_empty());
}

#[test]
fn walls_that_are_one_line_with_the_arc_of_a_door_have_a_whole_second_row_or_none() {
    let params =
        Params { diameter: 1.5, line_gap: 1, heavy_from: 9.0, whole_rows: true, min_length: 5.0, ..Params::TEST };
    let length = |aslant: i32| {
        let arc = (1..=aslant).map(|k| [29 + k, k]);
        let wall = row(0, 0..30).into_iter().chain(arc).chain((1..8).map(|k| [29 + aslant, aslant + k]));
        let cells: Vec<GridDot> = wall.collect();
        let mut taken = taken(std::slice::from_ref(&cells), 1);
        // lines that end beside it above and below
        [[12, 2], [7, -2]].into_iter().for_each(|end| taken.take(end, 1));
        taken.wider_side((0, &RowPiece::cut_out(cells)), 3, &params, |_| true).len()
    };
    assert_eq!(length(6), 0, "6 of 43 dots");
    // it is no wall, and has its second row in parts
    assert!(length(20) > 20);
}

#[test]
fn a_straight_line_a_little_aslant_is_no_wall() {
    let params =
        Params { diameter: 1.5, line_gap: 1, heavy_from: 9.0, whole_rows: true, min_length: 5.0, ..Params::TEST };
    let length = |run: i32| {
        let cells: Vec<GridDot> = (0..60).map(|x| [x, x / run]).collect();
        let mut taken = taken(std::slice::from_ref(&cells), 1);
        // lines that end beside it above and below
        [[20, 20 / run + 2], [10, 10 / run - 2]].into_iter().for_each(|end| taken.take(end, 1));
        taken.wider_side((0, &RowPiece::cut_out(cells)), 3, &params, |_| true).len()
    };
    assert!(length(7) > 30, "8 of 59 steps go aslant, a curve has its second row in parts");
    assert_eq!(length(20), 0, "level but for two steps");
}

#[test]
fn lines_that_are_about_as_strong_have_second_rows_or_none_has() {
    let strength = |number: usize| [90.0, 80.0, 75.0, 50.0, 45.0][number];
    let rows = |with: &[usize]| {
        let mut rows: Vec<Option<Vec<GridDot>>> =
            (0..5).map(|number| Some(if with.contains(&number) { row(0, 0..9) } else { Vec::new() })).collect();
        alike(&[0, 1, 2, 3, 4], &mut rows, strength);
        (0..5).filter(|&number| rows[number].as_ref().is_some_and(|row| !row.is_empty())).collect::<Vec<_>>()
    };
    assert_eq!(rows(&[0, 1, 2, 3, 4]), [0, 1, 2, 3, 4]);
    assert_eq!(rows(&[0, 1, 3, 4]), [3, 4], "one of three has no room");
    assert_eq!(rows(&[0, 1, 2, 3]), [0, 1, 2]);
    // bars of two colours, by their heights
    let mut mixed: Vec<Option<Vec<GridDot>>> = vec![Some(row(0, 0..9)); 5];
    mixed[1] = Some(Vec::new());
    alike(&[0, 3, 1, 4, 2], &mut mixed, strength);
    assert_eq!(mixed.iter().map(Option::is_some).collect::<Vec<_>>(), [false, false, false, true, true]);
}

#[test]
fn bars_have_their_second_rows_all_inside_or_all_outside() {
    let bar = |x: i32| -> Vec<GridDot> {
        let (up, down) = ((1..9).rev().map(move |y| [x, y]), (1..9).map(move |y| [x + 6, y]));
        up.chain((0..7).map(move |k| [x + k, 0])).chain(down).collect()
    };
    let row_of = |cells: Vec<GridDot>| -> Vec<GridDot> {
        second_row::on_grid(&cells, false).into_iter().map(|(_, cell)| cell).collect()
    };
    let inside = |x: i32| row_of(bar(x));
    let outside = |x: i32| row_of(bar(x).into_iter().rev().collect());
    let drawn = [0, 20].map(|x| DrawnPiece { line: 0, piece: RowPiece::cut_out(bar(x)) });
    let left = |rows: [Vec<GridDot>; 2]| {
        let mut rows: Vec<Option<Vec<GridDot>>> = rows.into_iter().map(Some).collect();
        on_one_side(&[0, 1], &mut rows, &drawn, |_| 90.0);
        rows.iter().flatten().count()
    };
    assert_eq!(left([inside(0), inside(20)]), 2);
    assert_eq!(left([outside(0), outside(20)]), 2);
    assert_eq!(left([inside(0), outside(20)]), 0);
    // walls have no inside
    let walls = [0, 20].map(|x| DrawnPiece { line: 0, piece: RowPiece::cut_out(row(0, x..x + 12)) });
    assert_eq!(walls.map(|wall| wall.piece.has_outside(&row(1, 0..12))), [None; 2]);
}

#[test]
fn walls_with_doors_have_second_rows_where_other_walls_have() {
    let left = |rows: [Option<Vec<GridDot>>; 3]| {
        let mut rows = rows.to_vec();
        as_others(&[vec![0, 1], vec![2]], &mut rows, |number| number == 0);
        rows.into_iter().flatten().filter(|row| !row.is_empty()).count()
    };
    let some = || Some(row(0, 0..9));
    assert_eq!(left([some(), some(), some()]), 3);
    assert_eq!(left([None, some(), some()]), 1, "the third is about as strong as no other");
    assert_eq!(left([Some(Vec::new()), some(), None]), 0);
}

#[test]
fn a_piece_of_a_second_row_is_as_long_as_a_line_or_half_of_its_own() {
    let grid = Grid { columns: (0..60_u8).map(|i| 2.0 * f32::from(i)).collect(), rows: vec![0.0, 2.0, 4.0, 6.0] };
    let within = GridBox::within(grid.bounds(), &grid);
    let params = Params { line_gap: 1, ..Params::TEST };
    let line = Line { strength: params.heavy_from, runs: Vec::new() };
    // of a line of so many dots beside lines that end two steps below it, each of which takes three dots
    let dots = |cells: i32, ends: &[i32]| {
        let cells = row(0, 0..cells);
        let mut taken = taken(std::slice::from_ref(&cells), 1);
        ends.iter().for_each(|&x| taken.take([x, 2], 1));
        let drawn = [DrawnPiece { line: 0, piece: RowPiece::cut_out(cells) }];
        let rows = taken.second_rows(&[0], &drawn, |_| &line, within, &params);
        rows[0].as_ref().map_or(0, Vec::len)
    };
    assert_eq!(dots(40, &[]), 40);
    // 12.5 mm are eight dots; those before and behind are more
    assert_eq!(dots(40, &[10, 21]), 34, "8 between them");
    assert_eq!(dots(40, &[10, 20]), 34 - 7, "7 are felt as texture");
    assert_eq!(dots(12, &[7]), 6, "half of a short line");
    assert_eq!(dots(12, &[6]), 0, "5 and 4");
}
