//! Connected parts of grids, and sets that are joined.

use super::*;
use crate::units::{MmPoint, MmVector};
use proptest::prelude::*;

/// The components of the labels of a grid as it is drawn, and the labels.
fn drawn(rows: &[&str], connectivity: Connectivity) -> (Vec<char>, Vec<Vec<usize>>) {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let labels: Vec<char> = rows.concat().chars().collect();
    let components = listed(&of_labels(&labels, size, connectivity));
    (labels, components)
}

fn listed(components: &Components) -> Vec<Vec<usize>> {
    components.iter().map(<[usize]>::to_vec).collect()
}

#[test]
fn equal_labels_are_connected_by_their_sides_and_not_by_corners() {
    let (_, components) = drawn(&["aab", "baa", "bbb"], Connectivity::Four);
    assert_eq!(components, [vec![0, 1, 4, 5], vec![2], vec![3, 6, 7, 8]]);
}

#[test]
fn corners_connect_where_asked_for() {
    let (labels, mut patches) = drawn(&["#..#", ".#.#", "....", "#..#"], Connectivity::Eight);
    patches.retain(|patch| labels[patch[0]] == '#');
    assert_eq!(patches, [vec![0, 5], vec![3, 7], vec![12], vec![15]]);
}

#[test]
fn rows_do_not_go_on_in_the_next_row() {
    for connectivity in [Connectivity::Four, Connectivity::Eight] {
        let (_, components) = drawn(&["..#", "...", "#..", "..#"], connectivity);
        assert_eq!(components, [vec![0, 1, 3, 4, 5, 7, 8, 9, 10], vec![2], vec![6], vec![11]]);
    }
    assert!(of_labels(&[(); 0], Size::new(0, 0), Connectivity::Four).is_empty());
}

#[test]
fn neighbours_end_at_the_edges_of_the_grid() {
    let size = Size::new(3, 2);
    assert_eq!(four_neighbours(0, size).collect::<Vec<_>>(), [1, 3]);
    assert_eq!(four_neighbours(4, size).collect::<Vec<_>>(), [3, 5, 1]);
    assert_eq!(four_neighbours(0, Size::new(1, 1)).count(), 0);
}

#[test]
fn a_spiral_is_one_component_of_any_length() {
    let rows = ["#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"];
    let (labels, components) = drawn(&rows, Connectivity::Four);
    let ink = labels.iter().filter(|&&label| label == '#').count();
    assert_eq!(components.iter().map(Vec::len).collect::<Vec<_>>(), [ink, labels.len() - ink]);
}

proptest! {
    #[test]
    fn cells_are_in_one_component_if_a_path_of_their_label_leads_from_one_to_the_other(
        width in 1_u32..9,
        labels in prop::collection::vec(0..3, 1..80),
        eight in any::<bool>(),
    ) {
        let size = Size::new(width, (labels.len() as u32).div_ceil(width));
        let labels: Vec<i32> = labels.iter().copied().cycle().take(size.len()).collect();
        let connectivity = if eight { Connectivity::Eight } else { Connectivity::Four };
        let found = of_labels(&labels, size, connectivity);
        // the lowest cell that each is connected to, step by step
        let beside = |a: usize, b: usize| {
            let [(ax, ay), (bx, by)] = [a, b].map(|cell| (cell as u32 % width, cell as u32 / width));
            let (dx, dy) = (ax.abs_diff(bx), ay.abs_diff(by));
            labels[a] == labels[b] && if eight { dx.max(dy) == 1 } else { dx + dy == 1 }
        };
        let mut lowest: Vec<usize> = (0..labels.len()).collect();
        let pairs: Vec<(usize, usize)> = (0..labels.len())
            .flat_map(|a| (0..labels.len()).map(move |b| (a, b)))
            .filter(|&(a, b)| beside(a, b))
            .collect();
        while pairs.iter().any(|&(a, b)| lowest[a] != lowest[b]) {
            pairs.iter().for_each(|&(a, b)| lowest[b] = lowest[b].min(lowest[a]));
        }
        let set: Vec<bool> = labels.iter().map(|label| *label == 1).collect();
        let ones: Vec<&[usize]> = found.iter().filter(|cells| set[cells[0]]).collect();
        prop_assert_eq!(of_set(&set, size, connectivity), ones);
        for cell in 0..labels.len() {
            let own = &found[found.of(cell)];
            prop_assert_eq!(own[0], lowest[cell]);
            prop_assert!(own.is_sorted() && own.contains(&cell));
        }
        prop_assert_eq!(found.iter().map(<[usize]>::len).sum::<usize>(), labels.len());
    }
}

#[test]
fn points_are_connected_over_others_and_as_the_caller_says() {
    let points: Vec<MmPoint> =
        [(0.0, 0.0), (9.0, 0.0), (0.9, 0.0), (1.8, 0.1), (1.8, -0.9)].map(|(x, y)| MmPoint::new(x, y)).into();
    assert_eq!(listed(&of_points(&points, 1.01, |v| v.length() <= 1.01)), [vec![0, 2, 3, 4], vec![1]]);
    let level = |v: MmVector| v.y.abs() < 0.5 && v.x.abs() <= 1.0;
    assert_eq!(listed(&of_points(&points, 1.01, level)), [vec![0, 2, 3], vec![1], vec![4]]);
}

#[test]
fn what_stays_keeps_its_order() {
    let mut items = vec!['a', 'b', 'c', 'd'];
    let points = [0.0, 5.0, 10.0, 0.5].map(|x| MmPoint::new(x, 0.0));
    let components = of_points(&points, 1.0, |v| v.length() <= 1.0);
    retain(&mut items, &components, |_, component| component.len() == 2);
    assert_eq!(items, ['a', 'd']);
}
