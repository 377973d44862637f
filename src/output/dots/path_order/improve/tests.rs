//! Orders of dots that are made shorter.

use super::super::neighbours::PositionGrid;
use super::*;
use proptest::prelude::*;

/// The path through `dots`, the first and the last of which are its ends, in the order given.
struct Case {
    positions: Vec<DotPosition>,
    neighbours: Vec<Vec<u32>>,
    order: Vec<u32>,
}

fn case(start: DotPosition, dots: &[DotPosition], end: DotPosition) -> Case {
    let count = dots.len() as u32;
    let order = [count].into_iter().chain(0..count).chain([count + 1]).collect();
    let positions = dots.iter().copied().chain([start, end]).collect();
    Case { positions, neighbours: PositionGrid::new(dots).neighbours(), order }
}

impl Case {
    fn shortened(&self, most_back: i32) -> Vec<u32> {
        shorten(&self.positions, &self.neighbours, self.order.clone(), most_back)
    }

    fn length(&self, order: &[u32]) -> f64 {
        order.windows(2).map(|pair| distance(self.at(pair[0]), self.at(pair[1]))).sum()
    }

    fn at(&self, number: u32) -> DotPosition {
        self.positions[number as usize]
    }

    /// The positions of a path without its ends.
    fn dots(&self, order: &[u32]) -> Vec<DotPosition> {
        order[1..order.len() - 1].iter().map(|&number| self.at(number)).collect()
    }
}

/// A path before any change, for one step at a time.
fn path(case: &Case) -> DotPath<'_> {
    let mut at = vec![0; case.positions.len()];
    case.order.iter().enumerate().for_each(|(index, &number)| at[number as usize] = index as u32);
    DotPath {
        positions: &case.positions,
        neighbours: &case.neighbours,
        most_back: i32::MAX,
        order: case.order.clone(),
        at,
        queue: VecDeque::new(),
        is_queued: vec![false; case.positions.len()],
        reversals: Vec::new(),
        steps: 0,
    }
}

#[test]
fn two_opt_removes_a_crossing() {
    // 0 -> 2 and 1 -> 3 are the diagonals of a square.
    let case = case([-100, 0], &[[0, 0], [100, 100], [0, 100], [100, 0]], [200, 0]);
    let mut path = path(&case);
    let (gain, _) = path.two_opt(0).expect("the diagonals are longer than the sides");
    assert_eq!(case.dots(&path.order), [[0, 0], [0, 100], [100, 100], [100, 0]]);
    assert!((case.length(&case.order) - case.length(&path.order) - gain).abs() < 1e-9);
}

#[test]
fn or_opt_moves_a_dot_to_where_it_belongs() {
    // The last dot lies between the first two; moving it saves the way there and back.
    let case = case([0, 0], &[[100, 0], [300, 0], [400, 0], [200, 10]], [500, 0]);
    let mut path = path(&case);
    let (gain, _) = path.or_opt(3).expect("it lies between the first two");
    assert_eq!(case.dots(&path.order), [[100, 0], [200, 10], [300, 0], [400, 0]]);
    assert!((case.length(&case.order) - case.length(&path.order) - gain).abs() < 1e-9);
}

#[test]
fn a_double_bridge_is_undone_exactly() {
    let dots: Vec<DotPosition> = (0..60).map(|i| [i * 37 % 61 * 10, i * 53 % 59 * 10]).collect();
    let case = case([0, 0], &dots, [600, 600]);
    let mut path = path(&case);
    let changed = (0..200).filter(|&number| {
        path.reversals.clear();
        let before = path.order.clone();
        let Some(lost) = path.double_bridge(number) else { return false };
        assert!((case.length(&path.order) - case.length(&before) - lost).abs() < 1e-9);
        assert_ne!(path.order, before);
        path.undo();
        assert_eq!(path.order, before);
        assert!(path.order.iter().enumerate().all(|(index, &number)| path.index(number) == index));
        true
    });
    assert!(changed.count() > 50);
}

proptest! {
    #[test]
    fn paths_get_no_longer_keep_their_dots_and_ends_and_pull_back_no_farther(
        dots in prop::collection::btree_set((0..900, 0..900), 2..60),
        most_back in prop::sample::select(vec![0, 100, 400, i32::MAX]),
    ) {
        // From top to bottom, so that nothing is pulled back at the beginning.
        let mut dots: Vec<DotPosition> = dots.into_iter().map(|(x, y)| [x, y]).collect();
        dots.sort_unstable_by_key(|dot| dot[1]);
        let case = case([0, 0], &dots, [0, 1_000]);
        let order = case.shortened(most_back);
        prop_assert!(case.length(&order) <= case.length(&case.order) + 1e-6);
        prop_assert_eq!((order.first(), order.last()), (case.order.first(), case.order.last()));
        let mut visited = order.clone();
        visited.sort_unstable();
        prop_assert_eq!(visited, (0..order.len() as u32).collect::<Vec<_>>());
        let mut lowest = i32::MIN;
        for dot in case.dots(&order) {
            lowest = lowest.max(dot[1]);
            prop_assert!(lowest - dot[1] <= most_back);
        }
    }
}
