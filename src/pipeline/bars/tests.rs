//! Tests of `bars`.

use super::*;

fn bars(of: &[(f32, f32, f32)]) -> Vec<Bar> {
    of.iter().map(|&(from, to, top)| Bar { from, to, top }).collect()
}

#[test]
fn cells_between_gridlines_are_no_bars() {
    // under the frame of a plot, the last one under a legend
    let cells = [(103.0, 193.0, -59.0), (193.0, 284.0, -59.0), (284.0, 372.0, -60.0), (373.0, 464.0, -59.0)];
    let legend = (479.0, 570.0, -332.0);
    let frame = BaseSpan { at: -59.0, from: 103.0, to: 570.0 };
    assert!(are_cells(&bars(&[cells[0], cells[1], cells[2], cells[3], legend]), &[frame]));
    let cut = [BaseSpan { to: 300.0, ..frame }, BaseSpan { from: 306.0, ..frame }];
    assert!(are_cells(&bars(&[cells[0], cells[1], cells[2], cells[3], legend]), &cut), "a curve cuts the frame");
    // bars of one height with gaps
    let apart: Vec<(f32, f32, f32)> = cells.iter().map(|&(from, to, top)| (from + 10.0, to - 10.0, top)).collect();
    assert!(!are_cells(&bars(&apart), &[frame]));
    assert!(!are_cells(&[], &[frame]));
}

#[test]
fn bars_of_a_histogram_are_no_cells() {
    let are_cells = |heights: &[f32], level: BaseSpan| {
        let all = heights.iter().enumerate().map(|(k, top)| (50.0 * k as f32, 50.0 * (k + 1) as f32, *top));
        are_cells(&bars(&all.collect::<Vec<_>>()), &[level])
    };
    let over = |from: f32, to: f32| BaseSpan { at: 200.0, from, to };
    // few are as high as the highest, also below a line over all
    assert!(!are_cells(&[100.0, 150.0, 200.0, 200.0, 150.0, 150.0], over(0.0, 300.0)));
    // most are, and their tops are one level, over which the others do not reach
    assert!(!are_cells(&[200.0, 200.0, 200.0, 120.0], over(0.0, 150.0)));
    assert!(!are_cells(&[120.0, 200.0, 200.0, 200.0], over(50.0, 200.0)));
    assert!(are_cells(&[200.0, 200.0, 200.0, 120.0], over(0.0, 200.0)), "under a frame");
}

#[test]
fn bars_of_one_height_are_a_chart_if_they_are_stacks_divided_at_several_heights() {
    let are_stacks = |gap: f32, parts: [&[f32]; 4]| {
        let all = (0..4).map(|k| 50.0 * k as f32).map(|from| (from, from + 50.0 - gap, 100.0)).collect::<Vec<_>>();
        let bars = bars(&all);
        let divided = bars.iter().zip(parts);
        let levels: Vec<BaseSpan> = divided
            .flat_map(|(bar, parts)| parts.iter().map(move |&at| BaseSpan { at, from: bar.from, to: bar.to }))
            .collect();
        let (sides, gridlines) = (Vec::new(), Vec::new());
        let chart =
            Chart { direction: Direction::Up, base: 0.0, bars, sides, gridlines, frame: None, is_divided: true };
        chart.are_stacks(&levels)
    };
    assert!(are_stacks(20.0, [&[40.0, 75.0], &[20.0, 70.0], &[60.0, 70.0], &[15.0, 40.0]]));
    assert!(are_stacks(20.0, [&[40.0], &[20.0], &[60.0], &[]]), "one has a part only");
    assert!(!are_stacks(0.0, [&[40.0, 75.0], &[20.0, 70.0], &[60.0, 70.0], &[15.0, 40.0]]), "cells of a table");
    assert!(!are_stacks(20.0, [&[50.0], &[50.0], &[51.0], &[80.0]]), "windows, one of them open");
    assert!(!are_stacks(20.0, [&[40.0], &[20.0], &[], &[]]), "half of them are not divided");
}

#[test]
fn the_side_of_a_frame_lies_beyond_all_bars_between_two_lines_as_high() {
    let frame = |at: f32, right: f32| {
        let side = |at: f32, to: f32| BaseSpan { at, from: 0.0, to };
        let bars = bars(&[(0.0, 50.0, 100.0), (50.0, 100.0, 150.0)]);
        let sides =
            vec![side(-20.0, 180.0), side(0.0, 100.0), side(50.0, 150.0), side(100.0, 150.0), side(120.0, right)];
        let chart = Chart {
            direction: Direction::Up,
            base: 0.0,
            bars,
            sides,
            gridlines: Vec::new(),
            frame: None,
            is_divided: false,
        };
        let tops = [(100.0, 0.0, 50.0), (150.0, 50.0, 100.0), (at, -20.0, 120.0)];
        chart.frame_beyond(&tops.map(|(at, from, to)| BaseSpan { at, from, to }))
    };
    assert_eq!(frame(180.0, 180.0), Some(180.0));
    assert_eq!(frame(180.0, 100.0), None, "a line over the bars, without a side on the right");
    assert_eq!(frame(150.0, 150.0), None, "the highest bar reaches it");
}
