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
    assert!(are_cells(&bars(&[cells[0], cells[1], cells[2], cells[3], legend])));
    // bars of one height with gaps, and a histogram of which few are as high as the highest
    let apart: Vec<(f32, f32, f32)> = cells.iter().map(|&(from, to, top)| (from + 10.0, to - 10.0, top)).collect();
    assert!(!are_cells(&bars(&apart)));
    let heights = [100.0, 150.0, 200.0, 200.0, 150.0, 150.0].into_iter().enumerate();
    let histogram: Vec<(f32, f32, f32)> =
        heights.map(|(k, top)| (50.0 * k as f32, 50.0 * (k + 1) as f32, top)).collect();
    assert!(!are_cells(&bars(&histogram)));
    assert!(!are_cells(&[]));
}
