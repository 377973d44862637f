//! Room for marks on rows of dots.

use super::*;
use crate::devices::Grid;
use crate::dots::grid_dot::GridBox;
use crate::lines::{HeadMark, Height, Line, Run};

const PARAMS: Params = Params::TEST;

/// All of the grid.
const SHEET: MmRect = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(200.0, 200.0));

fn grid() -> Grid {
    let even = |count: usize| (0..count).map(|i| 2.0 * i as f32).collect();
    Grid { columns: even(60), rows: even(40) }
}

/// An axis along row 20, and what is beside it.
fn rows(more: Option<Row>) -> Vec<Row> {
    let dots = (2..58).map(|x| MmPoint::new(2.0 * x as f32, 40.0)).collect();
    std::iter::once(Row { dots, closed: false, is_heavy: false, is_weak: false }).chain(more).collect()
}

fn tick(x: f32, above: f32, below: f32) -> TickMark {
    let end = |length: f32, way: f32| (length > 0.0).then_some(MmPoint::new(x, 40.0 + way * length));
    TickMark { at: MmPoint::new(x, 40.0), along: MmVector::new(1.0, 0.0), ends: [end(above, -1.0), end(below, 1.0)] }
}

fn point(x: f32, radius: f32, is_filled: bool) -> PointMark {
    PointMark { at: MmPoint::new(x, 40.4), radius, is_filled, series: None, is_alone: false, strength: 30.0 }
}

fn placed(points: &[PointMark], scale: &[TickMark], rows: &[Row]) -> Placed {
    let marks = LineMarks { points: points.to_vec(), scales: vec![scale.to_vec()], ..LineMarks::default() };
    let grid = grid();
    place(&marks, rows, Lattice::Grid { grid: &grid, within: GridBox::within(SHEET, &grid) }, &PARAMS)
}

/// How many dots each mark on the first row has.
fn counts(placed: &Placed) -> Vec<usize> {
    placed.runs[0].iter().map(Vec::len).collect()
}

#[test]
fn ticks_have_two_dots_on_each_side_and_longer_ones_more() {
    let scale = [tick(20.0, 2.0, 2.0), tick(40.0, 2.0, 2.0), tick(60.0, 5.0, 5.0)];
    let all = placed(&[], &scale, &rows(None));
    assert_eq!((counts(&all), &all.shown.scales[0].ticks[..]), (vec![2, 2, 2, 2, 4, 4], &[true; 3][..]));
    let first: Vec<[f32; 2]> = all.runs[0][0].iter().map(|at| [at.x, at.y]).collect();
    assert_eq!(first, [[20.0, 38.0], [20.0, 36.0]], "from the axis on");
    // on one side only
    assert_eq!(counts(&placed(&[], &[tick(20.0, 3.0, 0.0); 1], &rows(None))), [2]);
}

#[test]
fn where_a_line_is_beside_the_axis_ticks_are_on_its_other_side() {
    let dots = (2..58).map(|x| MmPoint::new(2.0 * x as f32, 46.0)).collect();
    let all = placed(
        &[],
        &[tick(20.0, 2.0, 2.0), tick(40.0, 2.0, 2.0)],
        &rows(Some(Row { dots, closed: false, is_heavy: false, is_weak: false })),
    );
    assert_eq!(counts(&all), [2, 2]);
    assert!(all.runs[0].iter().flatten().all(|at| at.y < 40.0));
}

#[test]
fn the_side_of_a_bar_that_ends_on_the_axis_above_a_tick_is_not_in_its_way() {
    let side = |last: i32| Row {
        dots: (5..=last).map(|y| MmPoint::new(20.0, 2.0 * y as f32)).collect(),
        closed: false,
        is_heavy: false,
        is_weak: false,
    };
    let scale = [tick(20.0, 0.0, 2.0), tick(40.0, 0.0, 2.0), tick(60.0, 0.0, 2.0)];
    let drawn = |last: i32| placed(&[], &scale, &rows(Some(side(last)))).shown.scales.remove(0).ticks;
    assert_eq!(drawn(19), [true; 3]);
    assert_eq!(drawn(24), [false; 3], "it goes on below the axis");
}

#[test]
fn ticks_too_near_to_one_another_are_left_out_but_for_every_so_many_th() {
    let near: Vec<TickMark> = (0..9).map(|k| tick(20.0 + 4.0 * k as f32, 2.0, 2.0)).collect();
    let shown = placed(&[], &near, &rows(None)).shown.scales.remove(0);
    assert_eq!((shown.every, shown.ticks.iter().filter(|is_drawn| **is_drawn).count()), (2, 5));
    let uneven = [tick(20.0, 2.0, 2.0), tick(24.0, 2.0, 2.0), tick(40.0, 2.0, 2.0)];
    assert_eq!(placed(&[], &uneven, &rows(None)).shown.scales[0].ticks, [false; 3]);
}

#[test]
fn a_disc_is_a_block_and_a_ring_interrupts_its_line() {
    let disc = placed(&[point(41.0, 1.5, true)], &[], &rows(None));
    assert_eq!((counts(&disc), disc.hidden[0].len(), disc.has_points[0]), (vec![6], 0, true));
    let ring = placed(&[point(40.0, 1.5, false)], &[], &rows(None));
    assert_eq!((counts(&ring), &ring.hidden[0][..]), (vec![6], &[MmPoint::new(40.0, 40.0)][..]));
    // as large as it is: 12 dots around 9, of which two are on the line, and three of the line inside
    let large = placed(&[point(40.0, 4.0, false)], &[], &rows(None));
    assert_eq!((counts(&large), large.hidden[0].len()), (vec![10], 3));
}

#[test]
fn points_keep_apart_from_one_another_and_from_other_lines() {
    let shown = |points: &[PointMark], rows: &[Row]| placed(points, &[], rows).shown.points;
    let both = [point(40.0, 1.5, true), point(44.0, 1.5, false)];
    assert_eq!(shown(&both, &rows(None)), [true, false]);
    let dots = (2..58).map(|x| MmPoint::new(2.0 * x as f32, 46.0)).collect();
    let beside = Row { dots, closed: false, is_heavy: false, is_weak: false };
    assert_eq!(shown(&both[..1], &rows(Some(beside.clone()))), [false]);
    let gridline = Row { is_weak: true, ..beside.clone() };
    assert_eq!(shown(&both[..1], &rows(Some(gridline))), [true], "a gridline gives way");
    assert_eq!(shown(&[point(40.0, 1.5, true)], &[]), [false], "on no line");
    // the ends of two lines at one point
    let slanting = (0..12).map(|k| MmPoint::new(40.0 + 2.0 * k as f32, 38.0 - 2.0 * k as f32)).collect();
    let slanting = Row { dots: slanting, ..beside.clone() };
    assert_eq!(shown(&both[..1], &rows(Some(slanting))), [true]);
}

/// As the contacts of a switch: the wire from the second one was cut back before the lever, which ends near there.
#[test]
fn a_point_whose_line_ends_before_it_takes_no_room_from_those_on_their_lines() {
    let row = |dots: &[(f32, f32)]| Row {
        dots: dots.iter().map(|&(x, y)| MmPoint::new(x, y)).collect(),
        closed: false,
        is_heavy: false,
        is_weak: false,
    };
    let wire: Vec<(f32, f32)> = (2..=20).map(|x| (2.0 * x as f32, 40.0)).collect();
    let lever = [(42.0, 38.0), (44.0, 38.0), (46.0, 36.0), (48.0, 36.0), (50.0, 34.0), (52.0, 34.0)];
    let rows = [row(&wire), row(&lever)];
    let (pivot, contact) = (point(40.0, 1.5, true), point(51.0, 1.5, true));
    assert_eq!(placed(&[contact, pivot], &[], &rows).shown.points, [false, true]);
    assert_eq!(placed(&[pivot, contact], &[], &rows).shown.points, [true, false]);
}

/// As the arc of a jump along a number line, which ends above a point of it.
#[test]
fn a_line_that_ends_in_the_blank_beside_a_point_ends_before_it() {
    let slanting = |x: f32, y: f32, way: f32, count: i32| {
        let dots = (0..count).map(|k| MmPoint::new(x + 2.0 * way * k as f32, y - 2.0 * k as f32)).collect();
        Row { dots, closed: false, is_heavy: false, is_weak: false }
    };
    let with = |more: &[Row]| {
        let all: Vec<Row> = rows(None).into_iter().chain(more.iter().cloned()).collect();
        placed(&[point(40.0, 1.5, true)], &[], &all)
    };
    let arc = slanting(44.0, 34.0, 1.0, 16);
    let drawn = with(std::slice::from_ref(&arc));
    assert_eq!((drawn.shown.points, &drawn.hidden[1][..]), (vec![true], &arc.dots[..1]));
    assert!(drawn.hidden[0].is_empty(), "the axis stays");
    assert_eq!(with(&[arc, slanting(42.0, 32.0, -1.0, 16)]).shown.points, [false], "it ends at another line");
    assert_eq!(with(&[slanting(44.0, 34.0, 1.0, 12)]).shown.points, [false], "too little would be left of it");
}

#[test]
fn a_tick_behind_a_point_goes_on_from_it() {
    let scale = [tick(20.0, 2.0, 2.0), tick(40.0, 2.0, 2.0), tick(60.0, 2.0, 2.0)];
    let all = placed(&[point(40.0, 1.5, false)], &scale, &rows(None));
    assert_eq!(counts(&all), [6, 2, 2, 1, 1, 2, 2]);
    assert_eq!(all.shown.scales[0].ticks, [true; 3]);
}

#[test]
fn anywhere_a_point_is_six_dots_around_one() {
    let part = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 80.0));
    let marks = |is_filled: bool| LineMarks {
        points: vec![point(41.0, 1.5, is_filled)],
        scales: vec![vec![tick(60.3, 2.0, 2.0), tick(80.3, 2.0, 0.0)]],
        ..LineMarks::default()
    };
    let place =
        |is_filled: bool| super::place(&marks(is_filled), &rows(None), Lattice::Free { part, pitch: 2.0 }, &PARAMS);
    assert_eq!((counts(&place(true)), counts(&place(false))), (vec![7, 2, 2, 2], vec![6, 2, 2, 2]));
    let hidden = &place(true).hidden[0];
    assert_eq!(hidden.len(), 3, "those of the line make way: {hidden:?}");
}

#[test]
fn the_head_of_an_arrow_is_two_rows_at_the_end_of_its_row() {
    let head = |x: f32, way: f32| HeadMark {
        at: MmPoint::new(x, 40.3),
        toward: MmVector::new(way, 0.0),
        extent: MmRect::zero(),
        strength: 100.0,
        shortened: 0.0,
        has_shaft: true,
        is_drawn: false,
    };
    let grid = grid();
    let place = |rows: &[Row], heads: &[HeadMark]| {
        let marks = LineMarks { heads: heads.to_vec(), ..LineMarks::default() };
        super::place(&marks, rows, Lattice::Grid { grid: &grid, within: GridBox::within(SHEET, &grid) }, &PARAMS)
    };
    let all = place(&rows(None), &[head(113.0, 1.0), head(4.0, -1.0), head(60.0, 1.0), head(113.0, -1.0)]);
    assert_eq!(all.shown.heads, [true, true, false, false], "at both ends, not in the middle nor against its way");
    let dots: Vec<[f32; 2]> = all.runs[0][0].iter().map(|at| [at.x, at.y]).collect();
    assert_eq!(dots, [[110.0, 36.0], [112.0, 38.0], [112.0, 42.0], [110.0, 44.0]]);
    assert!(all.has_points[0], "its line has one row");
    let beside = |y: f32| {
        let dots = (50..58).map(|x| MmPoint::new(2.0 * x as f32, y)).collect();
        rows(Some(Row { dots, closed: false, is_heavy: false, is_weak: false }))
    };
    assert_eq!(place(&beside(48.0), &[head(113.0, 1.0)]).shown.heads, [false], "no room");
    assert_eq!(place(&beside(52.0), &[head(113.0, 1.0)]).shown.heads, [true]);
}

/// As in a flow chart: a row that runs across and then down by so many dots.
#[test]
fn the_head_of_a_bent_row_points_as_its_last_piece_leads_and_keeps_clear_of_the_bend() {
    let place = |below: i32| {
        let across = (2..=20).map(|x| MmPoint::new(2.0 * x as f32, 20.0));
        let down = (1..=below).map(|y| MmPoint::new(40.0, 20.0 + 2.0 * y as f32));
        let row = Row { dots: across.chain(down).collect(), closed: false, is_heavy: false, is_weak: false };
        let head = HeadMark {
            at: MmPoint::new(40.0, 20.0 + 2.0 * below as f32),
            toward: MmVector::new(0.0, 1.0),
            extent: MmRect::zero(),
            strength: 100.0,
            shortened: 0.0,
            has_shaft: true,
            is_drawn: false,
        };
        let (grid, marks) = (grid(), LineMarks { heads: vec![head], ..LineMarks::default() });
        super::place(&marks, &[row], Lattice::Grid { grid: &grid, within: GridBox::within(SHEET, &grid) }, &PARAMS)
    };
    assert_eq!(place(3).shown.heads, [false], "it would lie at the piece before the bend");
    assert_eq!(place(2).shown.heads, [false]);
    let drawn = place(4);
    assert_eq!(drawn.shown.heads, [true]);
    let mut dots: Vec<[f32; 2]> = drawn.runs[0][0].iter().map(|at| [at.x, at.y]).collect();
    dots.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert_eq!(dots, [[36.0, 24.0], [38.0, 26.0], [42.0, 26.0], [44.0, 24.0]]);
}

#[test]
fn a_head_of_dots_is_read_again_and_is_neither_a_tick_nor_a_point() {
    let at = |x: f32, y: f32| MmPoint::new(2.0 * x, 2.0 * y);
    let run = |dots: &[(f32, f32)]| Run::dots(1.6, dots.iter().map(|&(x, y)| at(x, y)).collect(), Height::High);
    let row: Vec<(f32, f32)> = (0..20).map(|x| (x as f32, 10.0)).collect();
    let second: Vec<(f32, f32)> = (0..20).map(|x| (x as f32, 11.0)).collect();
    let line = |more: &[(f32, f32)]| Line { strength: 90.0, runs: vec![run(&row), run(more)] };
    let level = line(&[(17.0, 12.0), (18.0, 11.0), (18.0, 9.0), (17.0, 8.0)]);
    let heads: Vec<_> = level.row_heads().collect();
    assert_eq!(heads, [(at(19.0, 10.0), MmVector::new(1.0, 0.0), [at(17.0, 12.0), at(17.0, 8.0)])]);
    assert_eq!((level.row_ticks().count(), level.row_points().count()), (0, 0));
    assert_eq!(line(&second).row_heads().count(), 0, "a second row");
    let slant: Vec<(f32, f32)> = (0..20).map(|k| (k as f32, k as f32)).collect();
    let slant =
        Line { strength: 9.0, runs: vec![run(&slant), run(&[(17.0, 19.0), (18.0, 19.0), (19.0, 18.0), (19.0, 17.0)])] };
    assert_eq!((slant.row_heads().count(), slant.row_ticks().count(), slant.row_points().count()), (1, 0, 0));
}

#[test]
fn a_ring_is_hollow_however_close_dots_lie() {
    for pitch in [2.0, 1.27] {
        let params = Params { pitch, ..PARAMS };
        let even = |count: usize| (0..count).map(|i| pitch * i as f32).collect();
        let grid = Grid { columns: even(60), rows: even(40) };
        let dots = (2..58).map(|x| MmPoint::new(pitch * x as f32, pitch * 20.0)).collect();
        let rows = [Row { dots, closed: false, is_heavy: false, is_weak: false }];
        let at = MmPoint::new(pitch * 20.0, pitch * 20.0);
        let marks = LineMarks {
            points: vec![PointMark {
                at,
                radius: 0.5,
                is_filled: false,
                series: None,
                is_alone: false,
                strength: 30.0,
            }],
            ..LineMarks::default()
        };
        let placed =
            place(&marks, &rows, Lattice::Grid { grid: &grid, within: GridBox::within(SHEET, &grid) }, &params);
        let nearest = placed.runs[0][0].iter().map(|dot| (*dot - at).length()).fold(f32::INFINITY, f32::min);
        assert!(2.0 * nearest >= HOLLOW + params.diameter - 0.01, "{nearest} mm from the middle at {pitch} mm");
    }
}

fn alone(y: f32, is_filled: bool) -> PointMark {
    PointMark { at: MmPoint::new(50.3, y), is_alone: true, ..point(0.0, 1.0, is_filled) }
}

/// How many dots each run of each point beside all rows has.
fn counts_alone(placed: &Placed) -> Vec<Vec<usize>> {
    placed.alone.iter().map(|point| point.runs.iter().map(Vec::len).collect()).collect()
}

#[test]
fn a_point_beside_all_rows_is_the_smallest_ring_where_it_has_room() {
    let all = placed(&[alone(60.0, true), alone(74.0, false), alone(41.0, false)], &[], &rows(None));
    assert_eq!(all.shown.points, [true, true, false], "one is too near to the axis");
    assert_eq!(counts_alone(&all), [vec![8, 1], vec![8]]);
    let line = PointAlone { runs: all.alone[0].runs.clone(), strength: 30.0 }.line(&PARAMS);
    assert!(line.is_ring_of_dots() && line.runs[1].points == [MmPoint::new(50.0, 60.0)], "{line:?}");
    // where dots can be anywhere it lies at its own place
    let marks = LineMarks { points: vec![alone(60.0, true)], ..LineMarks::default() };
    let free = place(&marks, &rows(None), Lattice::Free { part: SHEET, pitch: 2.0 }, &PARAMS);
    let line = PointAlone { runs: free.alone[0].runs.clone(), strength: 30.0 }.line(&PARAMS);
    let mut steps = line.runs[0].points.windows(2).map(|pair| (pair[1] - pair[0]).length());
    assert!(line.is_ring_of_dots() && steps.all(|step| (step - 2.0).abs() < 0.01), "{line:?}");
}

#[test]
fn gridlines_are_interrupted_at_points_beside_them() {
    let gridline = |y: f32| {
        let dots = (2..58).map(|x| MmPoint::new(2.0 * x as f32, y)).collect();
        Row { dots, closed: false, is_heavy: false, is_weak: true }
    };
    let far = PointMark { at: MmPoint::new(66.0, 60.0), ..alone(60.0, true) };
    let all = placed(&[alone(60.0, true), far], &[], &rows(Some(gridline(56.0))));
    assert_eq!(all.shown.points, [true, true]);
    let mut hidden: Vec<i32> = all.hidden[1].iter().map(|dot| (dot.x / 2.0).round() as i32).collect();
    // two dots to both sides of each ring, whose middles are at columns 25 and 33, and one dot between them
    hidden.sort_unstable();
    assert_eq!(hidden, (22..=36).collect::<Vec<i32>>());
    assert!(all.hidden[0].is_empty(), "the axis stays");
    // one across the axis leaves the whole of a point where they meet
    let column = (10..30).map(|y| MmPoint::new(40.0, 2.0 * y as f32)).collect();
    let across = Row { dots: column, closed: false, is_heavy: false, is_weak: true };
    let on_axis = |more: Option<Row>| counts(&placed(&[point(40.0, 1.5, true)], &[], &rows(more)));
    assert_eq!(on_axis(Some(across)), on_axis(None));
    // one that ends there stays, unless it is level, and one that goes on on both sides is interrupted
    let slanting = |from: f32, steps: std::ops::Range<i32>| {
        let dots = steps.map(|k| MmPoint::new(from + 2.0 * k as f32, 60.0 - 2.0 * k as f32)).collect();
        Row { dots, ..gridline(0.0) }
    };
    let beside = |row: Row| placed(&[alone(60.0, false)], &[], &rows(Some(row))).shown.points;
    assert_eq!(beside(slanting(54.0, 0..9)), [false]);
    assert_eq!(beside(slanting(56.0, -9..9)), [true]);
    let level = (27..40).map(|x| MmPoint::new(2.0 * x as f32, 60.0)).collect();
    assert_eq!(beside(Row { dots: level, ..gridline(0.0) }), [true]);
    // one with marks of its own stays, as these would be torn
    let own = PointMark { at: MmPoint::new(50.0, 56.0), is_alone: false, ..alone(56.0, true) };
    let beside = PointMark { at: MmPoint::new(80.0, 60.0), ..alone(60.0, false) };
    assert_eq!(placed(&[own, beside], &[], &rows(Some(gridline(56.0)))).shown.points, [true, false]);
}

/// As the thin grey lines of a timeline, from the points to the names of what happened then.
#[test]
fn a_weak_row_that_ends_at_a_point_stays_and_a_gridline_beyond_it_does_not() {
    let upright = |at: std::ops::RangeInclusive<i32>| {
        let dots = at.map(|y| MmPoint::new(40.0, 2.0 * y as f32)).collect();
        Row { dots, closed: false, is_heavy: false, is_weak: true }
    };
    let hidden = |more: &[Row]| -> Vec<usize> {
        let all: Vec<Row> = rows(None).into_iter().chain(more.iter().cloned()).collect();
        let drawn = placed(&[point(40.0, 1.5, true)], &[], &all);
        assert_eq!(drawn.shown.points, [true]);
        drawn.hidden[1..].iter().map(Vec::len).collect()
    };
    assert_eq!(hidden(&[upright(10..=19)]), [0]);
    assert_eq!(hidden(&[upright(21..=30)]), [0], "below the axis");
    assert_eq!(hidden(&[upright(10..=19), upright(21..=30)]), [3, 3], "both sides of a gridline");
    assert_eq!(hidden(&[upright(10..=17)]), [1], "it ends beside the point, and not at it");
}

#[test]
fn points_of_one_size_are_blocks_where_not_all_have_room_for_rings() {
    let hollow = PointMark { at: MmPoint::new(80.0, 66.0), ..alone(66.0, false) };
    let blocks = placed(&[alone(60.0, true), alone(66.0, true), hollow], &[], &rows(None));
    assert_eq!(counts_alone(&blocks), [vec![4], vec![4], vec![8]], "hollow ones are others");
    let line = PointAlone { runs: blocks.alone[0].runs.clone(), strength: 30.0 }.line(&PARAMS);
    assert!(line.is_block_of_dots() && !line.is_ring_of_dots(), "{line:?}");
    // larger ones keep their size, but for a step
    let large = |y: f32| PointMark { radius: 4.0, ..alone(y, false) };
    assert_eq!(counts_alone(&placed(&[large(60.0), large(66.0)], &[], &rows(None))), [[12]]);
}
