//! Tests of `gridlines`.

use super::*;

#[test]
fn treads_between_rails_are_no_grid_and_lines_behind_a_curve_are() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let line = |a: (f32, f32), b: (f32, f32)| vec![at(a.0, a.1), at(b.0, b.1)];
    let treads = || (1..6).map(|step| line((10.0, 8.0 * step as f32), (50.0, 8.0 * step as f32)));
    let rails = [line((9.0, 0.0), (9.0, 60.0)), line((51.0, 0.0), (51.0, 60.0))];
    let gridlines = |lines: &[Vec<MmPoint>], rails: usize| {
        let ends: Vec<_> = lines.iter().map(|of| Some([of[0], of[of.len() - 1]])).collect();
        let ends = [&ends[..5], &vec![None; lines.len() - 5]].concat();
        let mut found = which_are_gridlines(&ends);
        without_treads(&mut found, &ends, &lines[..5 + rails]);
        found[..5].iter().filter(|is| **is).count()
    };
    let all = |on: &[Vec<MmPoint>]| treads().chain(rails.clone()).chain(on.iter().cloned()).collect::<Vec<_>>();
    assert_eq!(gridlines(&all(&[]), 2), 0);
    assert_eq!(gridlines(&all(&[]), 1), 5, "they end on one line only, as on the axis of a chart");
    let arrow = [line((30.0, 2.0), (30.0, 50.0)), line((27.0, 44.0), (30.0, 50.0))];
    assert_eq!(gridlines(&all(&arrow), 4), 0, "stairs with an arrow");
    let curve = [vec![at(12.0, 38.0), at(25.0, 20.0), at(48.0, 12.0)]];
    assert_eq!(gridlines(&all(&curve), 3), 5);
    let squared = [line((20.0, 0.0), (20.0, 60.0)), line((30.0, 0.0), (30.0, 60.0))];
    assert_eq!(gridlines(&all(&squared), 4), 5);
}

#[test]
fn even_lines_that_end_together_are_a_grid_and_walls_are_none() {
    let level = |y: f32, from: f32, to: f32| Some([MmPoint::new(from, y), MmPoint::new(to, y)]);
    let grid = [level(10.0, 0.0, 30.0), level(10.0, 40.0, 90.0), level(20.3, 0.0, 90.0), level(40.0, 12.0, 90.0)];
    assert_eq!(which_are_gridlines(&grid), [true; 4], "in pieces, and one of them is missing");
    let upright = Some([MmPoint::new(5.0, 0.0), MmPoint::new(5.0, 50.0)]);
    assert_eq!(which_are_gridlines(&[grid.as_slice(), &[upright, None]].concat())[4..], [false; 2]);
    assert_eq!(
        which_are_gridlines(&[level(10.0, 0.0, 90.0), level(24.0, 0.0, 90.0), level(29.6, 0.0, 90.0)]),
        [false; 3]
    );
    assert_eq!(
        which_are_gridlines(&[level(10.0, 0.0, 40.0), level(20.0, 50.0, 90.0), level(30.0, 20.0, 70.0)]),
        [false; 3]
    );
    assert_eq!(which_are_gridlines(&grid[2..]), [false; 2]);
    let short = [level(33.0, 2.0, 8.0), level(20.5, 70.0, 76.0), level(50.1, 70.0, 76.0)];
    assert_eq!(which_are_gridlines(&[grid.as_slice(), &short].concat())[4..], [false, true, true]);
}
