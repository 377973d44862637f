//! Tests of `neighbours`.

use super::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn the_nearest_is_found_while_positions_are_removed(
        positions in prop::collection::btree_set((0..400, 0..900), 1..60),
        to in (-100..500, -100..1_000),
        lowest in 0..900,
    ) {
        let positions: Vec<DotPosition> = positions.into_iter().map(|(x, y)| [x, y]).collect();
        let to = [to.0, to.1];
        let mut grid = PositionGrid::new(&positions);
        let mut left: Vec<u32> = (0..positions.len() as u32).collect();
        loop {
            let far = |number: &u32| (distance(to, positions[*number as usize]), *number);
            let allowed = left.iter().filter(|number| positions[**number as usize][1] <= lowest);
            let expected = allowed.min_by(|a, b| far(a).partial_cmp(&far(b)).expect("finite distances")).copied();
            prop_assert_eq!(grid.nearest(to, lowest), expected);
            let Some(number) = expected else { break };
            grid.remove(number);
            left.retain(|&other| other != number);
        }
    }

    #[test]
    fn neighbours_come_nearest_first_and_the_nearest_is_among_them(
        positions in prop::collection::btree_set((0..400, 0..900), 2..60),
    ) {
        let positions: Vec<DotPosition> = positions.into_iter().map(|(x, y)| [x, y]).collect();
        for (number, found) in PositionGrid::new(&positions).neighbours().iter().enumerate() {
            let far = |other: u32| distance(positions[number], positions[other as usize]);
            prop_assert!(found.is_sorted_by(|&a, &b| far(a) <= far(b)));
            let others = (0..positions.len() as u32).filter(|&other| other as usize != number);
            let least = others.map(far).fold(f64::INFINITY, f64::min);
            prop_assert!(found.first().is_some_and(|&first| far(first) <= least));
            prop_assert!(found.len() <= NEAREST + 4 * PER_QUADRANT);
        }
    }
}

#[test]
fn a_line_sees_the_line_beside_it() {
    // Two rows of dots 20 apart, a dot each 1: the six nearest of each dot are all in its own row.
    let positions: Vec<DotPosition> = (0..100).flat_map(|x| [[x, 0], [x, 20]]).collect();
    let neighbours = PositionGrid::new(&positions).neighbours();
    assert!(neighbours[100].iter().any(|&other| positions[other as usize][1] == 20));
}
