//! Which regions are chosen: the same as by a plain search of all in each round.

use super::super::main_thing::tests::{Disc, PARAMS, tree};
use super::*;
use crate::geom::distance::squared_distances;

/// The side of a cell on the sheet, mm.
const MM: f32 = 0.5;

/// The regions that a plain search chooses: in each round that of the greatest gain, computed of all.
fn plainly_chosen(tree: &Tree, params: &Params) -> Vec<u32> {
    let mut near = Nearness::new(tree, MM, params);
    let of = |node: u32| saliency(&tree.nodes[node as usize], tree.basin.len(), MM);
    let may_be = |node: &u32| of(*node) > 0.0 && survives_opening(tree, *node, MM);
    let all: Vec<u32> = (0..tree.nodes.len() as u32).filter(may_be).collect();
    let (mut chosen, mut first) = (Vec::new(), 0.0);
    while chosen.len() < params.most {
        let left = all.iter().copied().filter(|node| !chosen.contains(node));
        let plain = |node: u32| near.counted(tree.outline_of(node), tree);
        let gains = left.filter_map(|node| Some((gain(of(node), plain(node), params)?, node)));
        let rank = |(gain, node): &(f64, u32)| {
            (TotalOrder(*gain), TotalOrder(tree.nodes[*node as usize].area), Reverse(*node))
        };
        let Some((best, node)) = gains.max_by_key(rank) else { break };
        if best < f64::from(params.least_gain) * first {
            break;
        }
        first = if chosen.is_empty() { best } else { first };
        near.add(node, tree);
        chosen.push(node);
    }
    chosen
}

/// Discs at places and of sizes that look random, the same for the same seed.
fn discs(seed: u64) -> Vec<Disc> {
    let mut state = seed;
    let mut next = |from: f32, to: f32| {
        // Knuth's MMIX generator; its high bits are the better ones
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 40) as f32 / (1_u64 << 24) as f32
    };
    (0..9).map(|_| (next(0.0, 180.0), next(0.0, 120.0), next(6.0, 24.0), next(35.0, 95.0))).collect()
}

#[test]
fn the_same_regions_are_chosen_as_by_a_plain_search() {
    let mut counts = Vec::new();
    for seed in 1..=6 {
        let tree = tree(&discs(seed));
        let chosen = choose(&tree, MM, &PARAMS, &[], &[]);
        assert_eq!(chosen, plainly_chosen(&tree, &PARAMS), "seed {seed}");
        counts.push(chosen.len());
    }
    assert!(counts.iter().all(|count| *count >= 3), "{counts:?}: each has something to choose from");
}

#[test]
fn an_opening_is_that_of_two_distance_transforms() {
    let (mut survive, mut all) = (0, 0);
    for seed in 1..=3 {
        let tree = tree(&discs(seed));
        for node in 0..tree.nodes.len() as u32 {
            let is_outside: Vec<bool> = tree.basin.iter().map(|&basin| !tree.has(node, basin)).collect();
            let square = (OPENING / MM).powi(2);
            let to_outside = squared_distances(&is_outside, tree.grid.cells);
            let is_core: Vec<bool> = to_outside.iter().map(|to| *to as f32 > square).collect();
            let to_core = squared_distances(&is_core, tree.grid.cells);
            let kept = to_core.iter().filter(|to| **to as f32 <= square).count();
            let of = &tree.nodes[node as usize];
            let mean_width = 2.0 * of.area / (STEPS * of.outline.length + of.picture_edge);
            let is_wide = mean_width >= WIDE * f64::from(2.0 * OPENING / MM);
            let survives = survives_opening(&tree, node, MM);
            assert_eq!(survives, is_wide || kept as f64 >= KEPT * of.area, "region {node} of seed {seed}");
            (survive, all) = (survive + usize::from(survives), all + 1);
        }
    }
    assert!(survive > 10 && all - survive > 10, "{survive} of {all}");
}

#[test]
fn what_leads_comes_first_and_changes_nothing_if_it_is_chosen_anyway() {
    let tree = tree(&discs(3));
    let plain = choose(&tree, MM, &PARAMS, &[], &[]);
    let last = plain[plain.len() - 1];
    let led = choose(&tree, MM, &PARAMS, &[last], &[]);
    assert_eq!(led[0], last);
    assert_eq!(led[1..], plain[..plain.len() - 1]);
}
