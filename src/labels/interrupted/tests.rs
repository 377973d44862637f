//! Tests of `interrupted`.

use super::*;

fn line(strength: f32, points: &[(f32, f32)]) -> Line {
    let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
    Line { strength, runs: vec![Run { width: 1.0, points, closed: false, pen: Pen::Stroke }] }
}

#[test]
fn only_lines_of_a_grid_give_way_to_labels() {
    let lines = [
        line(90.0, &[(0.0, 0.0), (0.0, 90.0)]),
        line(7.0, &[(0.0, 50.0), (100.0, 50.0)]),
        line(7.0, &[(0.0, 70.0), (50.0, 75.0), (100.0, 70.0)]),
        line(40.0, &[(0.0, 80.0), (100.0, 80.0)]),
        line(7.0, &[(0.0, 20.0), (100.0, 20.0)]),
        line(7.0, &[(0.0, 35.0), (100.0, 35.0)]),
    ];
    // an axis, a gridline, a faint curve, a line, two more gridlines
    assert_eq!(giving_way(&lines, 7.0, &[]), [false, true, false, false, true, true]);
    // leader lines side by side are no grid
    let leaders = [MmPoint::new(100.0, 50.0), MmPoint::new(101.0, 20.5)];
    assert_eq!(giving_way(&lines, 7.0, &leaders), [false; 6]);
    let place = MmRect::new(MmPoint::new(40.0, 46.0), MmPoint::new(50.0, 52.0));
    let label = Placed::of_test(place);
    let params = Params::of_test(place);
    let mut left = lines.to_vec();
    assert_eq!(interrupt(&mut left, &[&label], &params), [0, 1, 1, 2, 3, 4, 5]);
    let ends: Vec<f32> = left[1..3].iter().flat_map(|line| line.runs[0].points.iter().map(|at| at.x)).collect();
    assert_eq!(left.len(), 7);
    assert!(ends.iter().zip([0.0, 36.5, 53.5, 100.0]).all(|(x, of)| (x - of).abs() <= STEP), "{ends:?}");
}
