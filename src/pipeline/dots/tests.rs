//! Tests of `dots`.

use super::*;
use crate::lines::{Height, LineMarks, Lost, PointMark};

#[test]
fn a_squared_grid_that_is_torn_or_hides_others_is_left_out() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let line = |from: (f32, f32), to: (f32, f32), strength: f32| Line {
        strength,
        runs: vec![Run::stroke(1.0, vec![from.into(), to.into()])],
    };
    let level = |y: f32, to: f32| line((10.0, y), (to, y), 7.0);
    let upright = |x: f32| line((x, 10.0), (x, 90.0), 7.0);
    let places = || (0..5).map(|i| 10.0 + 20.0 * i as f32);
    let axis = line((5.0, 50.0), (95.0, 50.0), 90.0);
    let all = |to: f32| -> Vec<Line> {
        std::iter::once(axis.clone()).chain(places().map(|y| level(y, to))).chain(places().map(upright)).collect()
    };
    // how many lines are drawn without it, if it is left out
    let left = |drawn: &[Line], pressed: &[Line]| {
        let drawn = Lines { lines: drawn.to_vec(), ..Lines::default() };
        let press = |_: &Lines| (vec![axis.clone()], ());
        without_squared_grid(&drawn, pressed, press, area, 7.0).map(|(others, _)| others.lines.len())
    };
    assert_eq!(left(&all(90.0), &all(90.0)), None, "it is whole");
    assert_eq!(left(&all(90.0), &all(30.0)), Some(1), "it is torn");
    // five points between the ends of its level lines do not stand for these
    let mut with_points = all(70.0);
    let block = |y: f32| {
        let corners = [(79.0, 1.0), (81.0, 1.0), (81.0, 3.0), (79.0, 3.0)].map(|(x, down)| MmPoint::new(x, y + down));
        Line { strength: 90.0, runs: vec![Run::dots(1.6, corners.to_vec(), Height::High)] }
    };
    with_points.extend(places().map(block));
    assert_eq!(left(&all(90.0), &with_points), Some(1), "it is torn at points");
    // rows of dots, of which one that is interrupted is one row all the same
    let dotted = |hole: std::ops::Range<f32>| -> Vec<Line> {
        let row = |y: f32| {
            let places = (0..=40).map(|i| 10.0 + 2.0 * i as f32).filter(|x| !hole.contains(x));
            let dots = places.map(|x| MmPoint::new(x, y)).collect();
            Line { strength: 7.0, runs: vec![Run::dots(1.6, dots, Height::High)] }
        };
        std::iter::once(axis.clone()).chain(places().map(row)).chain(places().map(upright)).collect()
    };
    assert_eq!(left(&all(90.0), &dotted(40.0..41.0)), None, "one dot is missing");
    assert_eq!(left(&all(90.0), &dotted(40.0..59.0)), Some(1), "it is torn by holes");
    let lacking = Lost { of_gridlines: [0.0, 120.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], ..Lost::default() };
    let drawn = Lines { lines: all(90.0), lost: lacking, ..Lines::default() };
    let others = without_squared_grid(&drawn, &all(90.0), |_| (vec![axis.clone()], ()), area, 7.0);
    assert!(others.is_some(), "pieces were left out before it became dots");
    let mut cut = all(90.0);
    cut[0] = line((5.0, 50.0), (80.0, 50.0), 90.0);
    assert_eq!(left(&all(90.0), &cut), Some(1), "it hides a part of the axis");
    // a piece of an upright one, parted from the rest, that is led to a line beside it; and a slanted line
    let mut parted = all(90.0);
    let piece = [(70.0, 30.0), (70.0, 12.0), (68.5, 10.0)].map(MmPoint::from).to_vec();
    parted.push(Line { strength: 7.0, runs: vec![Run::stroke(1.0, piece)] });
    assert_eq!(left(&parted, &all(30.0)), Some(1), "the piece goes with the grid");
    parted.push(line((40.0, 20.0), (60.0, 22.0), 7.0));
    assert_eq!(left(&parted, &all(30.0)), Some(2), "a slanted line is no part of it");
    let only_level: Vec<Line> = places().map(|y| level(y, 90.0)).collect();
    assert_eq!(left(&only_level, &[]), None, "gridlines of a chart are each told");
}

/// A piece of a gridline that ends on a curve is led to it, farther aside than most lines are moved.
#[test]
fn a_piece_in_line_with_a_gridline_is_of_the_grid() {
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|at| MmPoint::from(*at)).collect();
        Line { strength: 7.0, runs: vec![Run::stroke(1.0, points)] }
    };
    let places = || (0..5).map(|i| 10.0 + 20.0 * i as f32);
    let level = places().map(|y| line(&[(10.0, y), (90.0, y)]));
    let mut lines: Vec<Line> = level.chain(places().map(|x| line(&[(x, 50.0), (x, 90.0)]))).collect();
    let led_far = |x: f32| line(&[(x, 48.0), (x, 26.0), (x + 2.0, 24.0), (x + 6.0, 20.0)]);
    lines.extend([led_far(30.0), led_far(40.0)]);
    assert_eq!(squared_grid(&lines, 7.0), (0..11).collect::<Vec<usize>>(), "not what lies between two gridlines");
}

/// Of a bar on a grid the dots begin a step above the axis that it stands on, and its corners are cut.
#[test]
fn a_line_that_ends_at_the_dots_of_another_is_whole() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let line = |points: &[(f32, f32)]| Line {
        strength: 50.0,
        runs: vec![Run::stroke(1.0, points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect())],
    };
    let axis = [(10.0, 90.0), (90.0, 90.0)];
    let bar = line(&[(40.0, 90.0), (40.0, 60.0), (47.5, 60.0), (47.5, 90.0)]);
    let kept = |pressed: &[Line]| {
        let lines = [line(&axis), bar.clone()];
        let (_, shares) = kept_lines::matched(&lines, area, pressed, area);
        kept_of((&lines, &shares), pressed, area, 2.5)
    };
    let pressed = line(&[(40.0, 87.5), (40.0, 62.5), (42.5, 60.0), (45.0, 60.0), (47.5, 62.5), (47.5, 87.5)]);
    assert!((kept(&[line(&axis), pressed]) - 1.0).abs() < 1e-3);
    let half = line(&[(40.0, 87.5), (40.0, 62.5)]);
    assert!((0.7..0.8).contains(&kept(&[line(&axis), half])));
}

#[test]
fn the_cross_of_a_lamp_that_is_a_hollow_point_is_gone() {
    let at = MmPoint::new(50.0, 50.0);
    let stroke = |from: (f32, f32), to: (f32, f32)| Line {
        strength: 50.0,
        runs: vec![Run::stroke(1.0, vec![from.into(), to.into()])],
    };
    let point = PointMark { at, radius: 6.0, is_filled: false, series: None, is_alone: false, strength: 50.0 };
    let lines = vec![stroke((45.5, 45.5), (54.5, 54.5)), stroke((50.0, 50.0), (90.0, 50.0))];
    let marks = LineMarks { points: vec![point], ..LineMarks::default() };
    let drawn = Lines { lines, marks, ..Lines::default() };
    let ring = [(56.0, 50.0), (50.0, 56.0), (44.0, 50.0), (50.0, 44.0)].map(MmPoint::from);
    let are_kept = |is_drawn: bool, more: Option<MmPoint>| {
        let dots = ring.into_iter().chain(more).collect();
        let pressed = Line { strength: 50.0, runs: vec![Run::dots(1.6, dots, Height::High)] };
        let mut shares = [1.0, 1.0];
        without_insides(&mut shares, &drawn, &[is_drawn], &[pressed]);
        shares.map(|share| share > 0.5)
    };
    assert_eq!(are_kept(true, None), [false, true], "the cross lies in it, and the wire leads on");
    assert_eq!(are_kept(false, None), [true, true], "the point is not drawn");
    assert_eq!(are_kept(true, Some(at)), [true, true], "there are dots in it");
}
