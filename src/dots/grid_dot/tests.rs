//! Tests of `grid_dot`.

use super::*;

#[test]
fn a_part_of_the_sheet_holds_the_dots_within_it() {
    let centres: Vec<f32> = (0..20).map(|i| 5.0 + 2.5 * i as f32).collect();
    let grid = Grid { columns: centres.clone(), rows: centres };
    let part = GridBox::within(MmRect::new(MmPoint::new(10.0, 12.0), MmPoint::new(30.0, 21.0)), &grid);
    assert_eq!([part.first, part.last], [[2, 3], [10, 6]]);
    assert!(part.holds([2, 3]) && part.holds([10, 6]) && part.holds([5, 4]));
    assert!(![[1, 4], [11, 4], [5, 2], [5, 7]].into_iter().any(|cell| part.holds(cell)));
    assert_eq!(part.nearest([0, 9]), [2, 6]);
    let between = MmRect::new(MmPoint::new(10.5, 12.0), MmPoint::new(12.0, 21.0));
    assert!(!part.is_empty() && GridBox::within(between, &grid).is_empty());
}
