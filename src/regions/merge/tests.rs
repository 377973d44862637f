//! Tests of `merge`.

use super::*;

/// Basins of areas and lightnesses, with their arcs: which two, length and mean strength.
fn merged(basins: &[(f64, f64)], arcs: &[([u32; 2], f64, f64)]) -> Vec<Node> {
    let node = |&(area, lightness): &(f64, f64)| {
        let colour = [area * lightness, 0.0, 0.0];
        Node { area, colour, picture_edge: 1.0, outline: Sums::default(), children: None, height: 0.0 }
    };
    let arc = |&(ends, length, mean): &([u32; 2], f64, f64)| {
        let sums = Sums { length, strength: mean * length, ..Sums::default() };
        Arc { ends, sums, cracks: 0..0 }
    };
    let nodes: Vec<Node> = basins.iter().map(node).collect();
    let cells = nodes.iter().map(|node| node.area).sum::<f64>() as usize;
    merge(nodes, &arcs.iter().map(arc).collect::<Vec<_>>(), cells, 0.02)
}

/// The basins of a region, in their order.
fn basins_of(nodes: &[Node], number: u32) -> Vec<u32> {
    let Some(children) = nodes[number as usize].children else { return vec![number] };
    let mut all: Vec<u32> = children.iter().flat_map(|&child| basins_of(nodes, child)).collect();
    all.sort_unstable();
    all
}

const EVEN: [(f64, f64); 3] = [(100.0, 50.0); 3];

#[test]
fn those_with_least_between_them_merge_first_and_all_become_one() {
    let nodes = merged(&EVEN, &[([0, 1], 10.0, 30.0), ([1, 2], 6.0, 2.0)]);
    assert_eq!(nodes.len(), 5);
    assert_eq!((basins_of(&nodes, 3), basins_of(&nodes, 4)), (vec![1, 2], vec![0, 1, 2]));
    assert_eq!([nodes[3].area, nodes[4].area, nodes[4].picture_edge], [200.0, 300.0, 3.0]);
    assert_eq!(nodes[4].colour, [300.0 * 50.0, 0.0, 0.0]);
    assert!(nodes[..3].iter().all(|basin| basin.height <= 0.0));
    assert!(0.0 < nodes[3].height && nodes[3].height < nodes[4].height);
}

#[test]
fn an_outline_is_what_is_left_around_the_whole() {
    let nodes = merged(&EVEN, &[([0, 1], 10.0, 2.0), ([1, 2], 6.0, 30.0)]);
    let lengths: Vec<f64> = nodes.iter().map(|node| node.outline.length).collect();
    assert_eq!(lengths, [10.0, 16.0, 6.0, 6.0, 0.0]);
    assert_eq!(nodes[3].outline.mean(), 30.0);
}

#[test]
fn colours_part_what_is_parted_by_nothing_else() {
    let arcs = [([0, 1], 8.0, 5.0), ([0, 2], 8.0, 5.0), ([1, 2], 8.0, 5.0)];
    let nodes = merged(&[(100.0, 50.0), (100.0, 90.0), (100.0, 52.0)], &arcs);
    assert_eq!(basins_of(&nodes, 3), [0, 2]);
}

#[test]
fn crumbs_merge_early() {
    let nodes = merged(&[(10_000.0, 50.0), (10_000.0, 50.0), (4.0, 50.0)], &[([0, 1], 90.0, 5.0), ([1, 2], 8.0, 8.0)]);
    assert_eq!(basins_of(&nodes, 3), [1, 2]);
}

#[test]
fn of_equal_costs_the_longer_border_goes_first() {
    let nodes = merged(&EVEN, &[([0, 1], 3.0, 5.0), ([1, 2], 7.0, 5.0)]);
    assert_eq!(basins_of(&nodes, 3), [1, 2]);
}

/// What lies between two regions is judged by all of it: two arcs with a third region become one, weighed by
/// length.
#[test]
fn arcs_with_a_region_that_was_merged_count_as_one() {
    let triangle = |mean| [([0, 1], 5.0, 1.0), ([0, 2], 4.0, mean), ([1, 2], 6.0, 20.0)];
    let nodes = merged(&EVEN, &triangle(10.0));
    assert_eq!(basins_of(&nodes, 3), [0, 1]);
    assert_eq!([nodes[3].outline.length, nodes[3].outline.strength], [10.0, 160.0]);
    // one arc of the same mean over the same length costs the same
    let even = merged(&EVEN, &[([0, 1], 5.0, 1.0), ([0, 2], 4.0, 16.0), ([1, 2], 6.0, 16.0)]);
    assert!((nodes[4].height - even[4].height).abs() < 1e-12);
    assert!(merged(&EVEN, &triangle(12.0))[4].height > nodes[4].height);
}
