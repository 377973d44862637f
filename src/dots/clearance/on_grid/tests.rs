//! Lines of dots that keep apart on a grid.

use super::*;

pub(in super::super) fn row(y: i32, columns: std::ops::Range<i32>) -> Vec<GridDot> {
    columns.map(|x| [x, y]).collect()
}

pub(in super::super) fn taken(lines: &[Vec<GridDot>], gap: i32) -> OccupiedDots {
    let mut taken = OccupiedDots::new(gap);
    for (number, cells) in lines.iter().enumerate() {
        cells.iter().for_each(|&cell| taken.take(cell, number));
    }
    taken
}

fn pieces(taken: &OccupiedDots, cells: &[GridDot], closed: bool) -> Vec<(Vec<GridDot>, bool)> {
    taken.pieces(cells, closed).into_iter().map(|piece| (piece.cells, piece.closed)).collect()
}

#[test]
fn a_line_far_from_others_stays_whole() {
    let taken = taken(&[row(0, 0..20)], 2);
    assert_eq!(pieces(&taken, &row(3, 0..20), false), [(row(3, 0..20), false)]);
    // a step nearer there are too few empty dots between
    assert_eq!(pieces(&taken, &row(2, 0..20), false), []);
}

#[test]
fn a_line_is_cut_where_it_comes_near_another() {
    let taken = taken(&[row(0, 10..12)], 1);
    assert_eq!(pieces(&taken, &row(1, 0..20), false), [(row(1, 0..9), false), (row(1, 13..20), false)]);
}

#[test]
fn a_ring_that_is_cut_is_an_open_line() {
    let side = |from: GridDot, step: GridDot| (0..6).map(move |i| [from[0] + i * step[0], from[1] + i * step[1]]);
    let right_and_down = side([0, 0], [1, 0]).chain(side([6, 0], [0, 1]));
    let ring: Vec<GridDot> = right_and_down.chain(side([6, 6], [-1, 0])).chain(side([0, 6], [0, -1])).collect();
    assert_eq!(pieces(&taken(&[], 1), &ring, true), [(ring.clone(), true)]);
    let cut = pieces(&taken(&[row(-1, 2..6)], 1), &ring, true);
    assert_eq!(cut.len(), 1);
    let (cells, closed) = &cut[0];
    assert!(!closed && cells.len() == ring.len() - 6, "{cells:?}");
    assert_eq!((cells.first(), cells.last()), (Some(&[6, 1]), Some(&[0, 0])));
    // one that only touches another line stays
    let touching = pieces(&taken(&[vec![[3, -1]]], 1), &ring, true);
    assert!(matches!(&touching[..], [(cells, true)] if cells.len() == ring.len()), "{touching:?}");
}

#[test]
fn an_end_that_touches_another_line_stays_joined() {
    let taken = taken(&[row(0, 0..20)], 2);
    let upright = |rows: std::ops::Range<i32>| rows.map(|y| [10, y]).collect::<Vec<GridDot>>();
    // the dot on the other line is removed, the one beside it stays
    assert_eq!(pieces(&taken, &upright(0..9), false), [(upright(1..9), false)]);
    let reversed: Vec<GridDot> = upright(0..9).into_iter().rev().collect();
    assert_eq!(pieces(&taken, &reversed, false), [(upright(1..9).into_iter().rev().collect(), false)]);
    // an end that only comes near is shortened
    assert_eq!(pieces(&taken, &upright(2..9), false), [(upright(3..9), false)]);
}

#[test]
fn a_short_line_from_one_line_to_another_is_a_link() {
    let upright = |x: i32| (0..12).map(move |y| [x, y]).collect::<Vec<GridDot>>();
    let links = |apart: i32, from: i32, to: i32| {
        let pieces = taken(&[upright(0), upright(apart)], 2).pieces(&row(6, from..to), false);
        pieces.into_iter().map(|piece| (piece.cells.len(), piece.is_link)).collect::<Vec<_>>()
    };
    for apart in 4..9 {
        assert_eq!(
            links(apart, 0, apart + 1),
            [(apart as usize - 1, true)],
            "from dot on line to dot on line, {apart}"
        );
        assert_eq!(links(apart, 1, apart), [(apart as usize - 1, true)], "from dot beside line to dot beside line");
    }
    assert_eq!(links(3, 0, 4), [], "two dots are no line");
    assert_eq!(links(7, 0, 5), [(4, false)], "it ends before the other one");
    // beside one of them all along
    let beside = taken(&[upright(0), upright(4)], 2).pieces(&(0..6).map(|y| [1, y]).collect::<Vec<GridDot>>(), false);
    assert!(beside.iter().all(|piece| !piece.is_link));
}

#[test]
fn a_link_goes_with_the_dots_that_it_led_to() {
    let link: Vec<GridDot> = (1..5).map(|y| [0, y]).collect();
    let left = |bases: [Vec<GridDot>; 2]| {
        let mut taken = taken(&bases, 2);
        let piece = RowPiece { is_link: true, ..RowPiece::cut_out(link.clone()) };
        link.iter().for_each(|&cell| taken.take(cell, 2));
        let base = |(line, cells)| DrawnPiece { line, piece: RowPiece::cut_out(cells) };
        let mut drawn: Vec<DrawnPiece> = bases.into_iter().enumerate().map(base).collect();
        drawn.push(DrawnPiece { line: 2, piece });
        let steps: Vec<f32> = (0..40).map(|step| 2.0 * step as f32).collect();
        let grid = Grid { columns: steps.clone(), rows: steps };
        taken.drop_loose(&mut drawn, &[false; 3], &grid, &Params::TEST);
        (drawn[2].piece.cells.len(), link.iter().filter(|cell| taken.piece_of.contains_key(*cell)).count())
    };
    assert_eq!(left([row(0, -9..9), row(5, -9..9)]), (4, 4));
    // a hollow point has hidden some of them
    assert_eq!(left([row(0, -9..9), row(5, 3..9)]), (0, 0));
}

#[test]
fn a_line_that_comes_back_keeps_the_gap_from_itself() {
    let hairpin: Vec<GridDot> = row(0, 0..20).into_iter().chain(row(1, 0..20).into_iter().rev()).collect();
    let left = pieces(&taken(&[], 1), &hairpin, false);
    // both arms are near each other for 8 dots from the turn on
    assert_eq!(left.len(), 1);
    assert_eq!((left[0].0.first(), left[0].0.len()), (Some(&[0, 0]), 20 + 4));
}

#[test]
fn a_piece_that_comes_back_to_itself_is_a_ring_without_a_spike() {
    let ring = [[7, 5], [6, 6], [5, 7], [5, 8], [5, 9], [4, 9], [3, 9], [2, 8], [2, 7], [3, 6], [4, 6], [5, 6], [6, 5]];
    let piece = RowPiece::cut_out(ring.to_vec());
    assert_eq!((piece.closed, &piece.cells[..]), (true, &ring[2..12]));
    assert!(!RowPiece::cut_out(ring[..8].to_vec()).closed);
}

#[test]
fn two_short_lines_that_cross_are_a_cross() {
    // of the second one two dots are clear of the first on one side
    let falling: Vec<GridDot> = (-4..5).map(|k| [k, k]).collect();
    let rising: Vec<GridDot> = (-4..5).map(|k| [k + 1, -k]).collect();
    let pieces = taken(&[falling], 2).pieces(&rising, false);
    let all: Vec<GridDot> = pieces.iter().flat_map(|piece| piece.cells.clone()).collect();
    assert_eq!(all, rising);
    assert!(pieces.iter().all(|piece| piece.through == 9));
}

#[test]
fn the_arms_of_a_line_that_crosses_another_count_together() {
    let taken = taken(&[row(0, -20..20)], 2);
    let through = |line: &[GridDot]| -> Vec<(usize, usize)> {
        taken.pieces(line, false).iter().map(|piece| (piece.cells.len(), piece.through)).collect()
    };
    let upright: Vec<GridDot> = (-7..12).map(|y| [3, y]).collect();
    assert_eq!(through(&upright), [(7, 19), (11, 19)]);
    let slanted: Vec<GridDot> = (-7..12).map(|y| [3 + y, y]).collect();
    assert_eq!(through(&slanted), [(7, 19), (11, 19)]);
    // what comes down, runs along the other and goes on joins it with both sides, and is no cross
    let along: Vec<GridDot> =
        (-7..0).map(|y| [0, y]).chain((0..12).map(|x| [x, 0])).chain((1..9).map(|y| [11, y])).collect();
    assert_eq!(through(&along), [(7, 5), (8, 6)]);
    // nor is what turns where it is cut
    let column: Vec<GridDot> = (0..4).map(|y| [0, y]).collect();
    assert!(goes_on(&column, &(9..13).map(|y| [1, y]).collect::<Vec<GridDot>>()));
    assert!(!goes_on(&column, &row(5, 3..7)));
}

#[test]
fn a_line_that_crosses_another_steeply_keeps_its_dots() {
    let taken = taken(&[row(0, -20..20)], 2);
    let upright: Vec<GridDot> = (-9..10).map(|y| [3, y]).collect();
    let halves = pieces(&taken, &upright, false);
    assert_eq!(halves, [(upright[..9].to_vec(), false), (upright[10..].to_vec(), false)]);
    // at 30 degrees, as an end that joins
    let slanting: Vec<GridDot> = (-19..20).map(|x: i32| [x, (0.58 * x as f32).round() as i32]).collect();
    let halves = pieces(&taken, &slanting, false);
    assert_eq!(halves, [(slanting[..19].to_vec(), false), (slanting[20..].to_vec(), false)]);
    let flat: Vec<GridDot> = (-19..20).map(|x| [x, x / 3]).collect();
    let left = pieces(&taken, &flat, false);
    assert!(!left.is_empty() && left.iter().all(|(cells, _)| cells.iter().all(|cell| cell[1].abs() > 2)));
    // between dots of the other
    let slanted: Vec<GridDot> = (-9..10).map(|y| [y, y]).collect();
    let other = self::taken(&[(-9..10).map(|y| [y, 1 - y]).collect()], 2);
    assert_eq!(pieces(&other, &slanted, false).iter().map(|(cells, _)| cells.len()).sum::<usize>(), slanted.len());
}

#[test]
fn a_ring_that_touches_a_line_stays_a_ring() {
    let stem = (-20..20).map(|y| [0, y]).collect::<Vec<GridDot>>();
    let leaf: Vec<GridDot> = [
        (0..8).map(|i| [i, -i]).collect::<Vec<GridDot>>(),
        (1..8).map(|i| [7 + i, -7 + i]).collect(),
        (1..8).map(|i| [14 - i, i]).collect(),
        (1..7).map(|i| [7 - i, 7 - i]).collect(),
    ]
    .concat();
    let left = pieces(&taken(&[stem], 2), &leaf, true);
    assert_eq!(left.len(), 1);
    assert!(left[0].1 && left[0].0.len() == leaf.len() - 1, "{left:?}");
    // corner on corner, without a dot in common: it begins where it touches
    let bend: Vec<GridDot> = row(0, 1..20).into_iter().rev().chain((0..9).map(|y| [0, y])).collect();
    let sides = [row(-4, -20..0), (-3..0).map(|y| [0, y]).collect(), row(0, -20..0).into_iter().rev().collect()];
    let bar: Vec<GridDot> = sides.into_iter().chain([(-3..0).map(|y| [-21, -4 - y]).collect()]).flatten().collect();
    let left = pieces(&self::taken(&[bend], 2), &bar, true);
    let [(ring, true)] = &left[..] else { panic!("{left:?}") };
    assert!(ring.len() == bar.len() && distance(ring[0], [0, 0]) <= 1, "{ring:?}");
}

#[test]
fn a_corner_on_the_end_of_a_line_keeps_its_dots() {
    let mut taken = taken(&[row(0, -20..1)], 2);
    let corner: Vec<GridDot> = (-8..0).map(|y| [-y, y]).chain(row(0, 0..9)).collect();
    let dots = |taken: &OccupiedDots| pieces(taken, &corner, false).iter().map(|(cells, _)| cells.len()).sum::<usize>();
    assert_eq!(dots(&taken), corner.len() - 1);
    taken.tips.insert([0, 0]);
    assert_eq!(dots(&taken), corner.len() - 1);
    // a line that ends beside it does not interrupt it
    let beside = self::taken(&[row(0, -20..3)], 2);
    let upright: Vec<GridDot> = (-9..10).map(|y| [3, y]).collect();
    assert_eq!(pieces(&beside, &upright, false).iter().map(|(cells, _)| cells.len()).sum::<usize>(), upright.len() - 5);
    let mut ending = beside;
    ending.tips.insert([2, 0]);
    assert_eq!(pieces(&ending, &upright, false), [(upright, false)]);
}

#[test]
fn a_sharp_corner_on_another_line_keeps_its_sides() {
    // 53 degrees between the sides, and its tip at (0, tip)
    let corner = |tip: i32| -> Vec<GridDot> { (-8..=8_i32).map(|k| [(k + k.signum()) / 2, tip - k.abs()]).collect() };
    let pieces = |tip: i32| pieces(&taken(&[row(0, -20..20)], 2), &corner(tip), false);
    let on = pieces(0);
    assert_eq!(on, [(corner(0)[..8].to_vec(), false), (corner(0)[9..].to_vec(), false)], "without the dot of both");
    let beside: Vec<GridDot> = pieces(-1).into_iter().flat_map(|(cells, _)| cells).collect();
    assert_eq!(beside, corner(-1));
    // one that only comes near is cut
    let near = pieces(-2);
    assert_eq!(near, [(corner(-2)[..8].to_vec(), false), (corner(-2)[9..].to_vec(), false)]);
}

#[test]
fn a_triangle_in_a_ring_is_whole_at_all_its_corners() {
    // the ring is level and upright around (0, 0), and the corners lie on it
    let line = |from: GridDot, to: GridDot| {
        let n = (to[0] - from[0]).abs().max((to[1] - from[1]).abs());
        (0..n).map(move |k| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * k / n)).collect::<Vec<GridDot>>()
    };
    let closed = |corners: &[GridDot]| -> Vec<GridDot> {
        (0..corners.len()).flat_map(|i| line(corners[i], corners[(i + 1) % corners.len()])).collect()
    };
    let ring = closed(&[[-20, -20], [20, -20], [20, 20], [-20, 20]]);
    let corners = [[-20, 10], [20, 10], [0, -20]];
    let triangle = closed(&corners);
    let pieces = pieces(&taken(std::slice::from_ref(&ring), 2), &triangle, true);
    let left: Vec<GridDot> = pieces.into_iter().flat_map(|(cells, _)| cells).collect();
    let missing: Vec<GridDot> = triangle.into_iter().filter(|cell| !left.contains(cell)).collect();
    assert!(missing.iter().all(|cell| ring.contains(cell)), "only what both share: {missing:?}");
}

#[test]
fn a_line_that_crosses_two_others_in_a_row_keeps_its_dots() {
    let upright = |rows: std::ops::Range<i32>| rows.map(|y| [3, y]).collect::<Vec<GridDot>>();
    let across = |apart: i32| {
        let pieces = pieces(&taken(&[row(0, -20..20), row(apart, -20..20)], 2), &upright(-9..20), false);
        pieces.into_iter().map(|(cells, _)| cells).collect::<Vec<_>>()
    };
    // no dot between them is more than two steps from both
    assert_eq!(across(5), [upright(-9..0), upright(1..5), upright(6..20)]);
    // the dot in the middle is near to both
    assert_eq!(across(4), [upright(-9..-2), upright(7..20)]);
}

#[test]
fn short_arms_of_one_line_on_both_sides_of_a_crossing_hold_one_another() {
    let centres: Vec<f32> = (0..60_u8).map(|i| 2.0 * f32::from(i)).collect();
    let grid = Grid { columns: centres.clone(), rows: centres };
    let left = |steps: i32, lines: [usize; 2], has_points: bool| {
        let cells = [row(5, 0..4), row(5, 3 + steps..7 + steps)];
        let mut taken = taken(&cells, 1);
        let piece = |(line, cells)| DrawnPiece { line, piece: RowPiece::cut_out(cells) };
        let mut drawn: Vec<DrawnPiece> = lines.into_iter().zip(cells).map(piece).collect();
        taken.drop_loose(&mut drawn, &[has_points; 2], &grid, &Params::TEST);
        let left = drawn.iter().filter(|of| !of.piece.cells.is_empty()).count();
        assert_eq!(taken.piece_of.len(), 4 * left, "dots of what is dropped are free again");
        left
    };
    let reach = longest_cut(1) as i32 + 1;
    assert_eq!(left(reach, [0, 0], false), 2);
    assert_eq!(left(reach + 1, [0, 0], false), 0, "no cut is that long");
    assert_eq!(left(reach, [0, 1], false), 0, "they are of two lines");
    assert_eq!(left(reach + 1, [0, 0], true), 2, "points are on them");
}

#[test]
fn what_leads_from_a_crossing_soon_to_another_line_is_a_link() {
    let links = |apart: i32, reversed: bool| {
        let mut line: Vec<GridDot> = (-10..=apart).map(|y| [10, y]).collect();
        if reversed {
            line.reverse();
        }
        let pieces = taken(&[row(0, 0..20), row(apart, 5..15)], 2).pieces(&line, false);
        pieces.into_iter().map(|piece| (piece.cells.len(), piece.is_link)).collect::<Vec<_>>()
    };
    for reversed in [false, true] {
        assert_eq!(links(4, reversed), [(10, false), (3, true)], "as from the bar of a family tree to a box");
        assert_eq!(links(3, reversed), [(10, false)], "two dots are no line");
    }
}
