//! Basins are merged into regions, those first between which the least is seen.

use std::collections::BinaryHeap;

use super::arcs::{Arc, Sums};
use crate::ranked::Ranked;

/// Weight of a difference of colour beside the strength of traces.
const COLOUR: f64 = 0.15;
/// A difference of colour counts at most this much.
const MOST_COLOUR: f64 = 30.0;
/// Regions of this share of the picture, and smaller ones, merge early: crumbs are no regions.
const NEGLIGIBLE: f64 = 0.003;
/// Exponent of the size that a region counts with: at 0 crumbs would be merged as late as what is large, and at 1 any
/// large region would outlast a small one that is clearly seen. Chosen with the other numbers (see `regions`).
const POWER: f64 = 0.3;

/// A region: a basin, or two regions merged.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    /// In cells.
    pub(super) area: f64,
    /// Sum of the colours of its cells.
    pub(super) colour: [f64; 3],
    /// Sides of its cells on the edge of the picture.
    pub(super) picture_edge: f64,
    /// Sums over its outline, the edge of the picture excepted: its own side first.
    pub(super) outline: Sums,
    /// The two regions that it was merged of.
    pub(super) children: Option<[u32; 2]>,
    /// The greatest cost of all the merging that made it; 0 of a basin.
    pub(super) height: f64,
}

impl Node {
    /// The share of its outline that lies on the edge of the picture, 0..=1.
    pub(super) fn on_picture_edge(&self) -> f64 {
        self.picture_edge / (self.outline.length + self.picture_edge).max(1.0)
    }
}

/// An edge of the region adjacency graph: the arc between two regions that are yet to be merged.
struct Adjacency {
    ends: [u32; 2],
    sums: Sums,
    /// Changes whenever its cost does.
    version: u32,
    alive: bool,
}

/// In which order regions are merged: by cost, the cheapest first; of equal ones by the length of their arc, the
/// longest first; then by the number of the adjacency. All in one number, as most of the time of a heap is for
/// comparing: the bits of a number that is not negative are ordered as it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct MergeOrder(u128);

impl MergeOrder {
    fn new(cost: f64, length: f64, adjacency: u32) -> Self {
        let by_cost = u128::from(!cost.to_bits()) << 64;
        Self(by_cost | u128::from(length as u32) << 32 | u128::from(!adjacency))
    }

    fn cost(self) -> f64 {
        f64::from_bits(!((self.0 >> 64) as u64))
    }

    fn adjacency(self) -> u32 {
        !(self.0 as u32)
    }
}

/// What merging works on.
struct Merging {
    nodes: Vec<Node>,
    /// By node: what size counts beside a larger one, and beside a smaller one.
    weights: Vec<[f64; 2]>,
    adjacencies: Vec<Adjacency>,
    /// By node: its neighbours, ordered, and the adjacencies with them.
    neighbours: Vec<Vec<(u32, u32)>>,
    /// Each with the version of its adjacency.
    heap: BinaryHeap<Ranked<MergeOrder, u32>>,
    cells: f64,
    /// See [`Detail::part`](super::tree::Detail).
    part: f64,
}

/// All regions, basins first, in the order in which they are merged. `part`: see [`Detail`](super::tree::Detail).
pub(super) fn merge(basins: Vec<Node>, arcs: &[Arc], cells: usize, part: f64) -> Vec<Node> {
    let mut merging = Merging::new(basins, arcs, cells as f64, part);
    while let Some(Ranked { rank, item: version }) = merging.heap.pop() {
        let (cost, adjacency) = (rank.cost(), rank.adjacency());
        let Adjacency { alive, version: current, .. } = merging.adjacencies[adjacency as usize];
        if alive && current == version {
            merging.unite(adjacency, cost);
        }
    }
    merging.nodes
}

impl Merging {
    fn new(mut nodes: Vec<Node>, arcs: &[Arc], cells: f64, part: f64) -> Self {
        let mut counts = vec![0; nodes.len()];
        arcs.iter().flat_map(|arc| arc.ends).for_each(|end| counts[end as usize] += 1);
        let mut neighbours: Vec<Vec<(u32, u32)>> = counts.into_iter().map(Vec::with_capacity).collect();
        let mut adjacencies = Vec::with_capacity(arcs.len());
        for (number, arc) in (0_u32..).zip(arcs) {
            let [a, b] = arc.ends;
            neighbours[a as usize].push((b, number));
            neighbours[b as usize].push((a, number));
            nodes[a as usize].outline.add(&arc.sums, false);
            nodes[b as usize].outline.add(&arc.sums, true);
            let sums = arc.sums;
            adjacencies.push(Adjacency { ends: arc.ends, sums, version: 0, alive: true });
        }
        neighbours.iter_mut().for_each(|list| list.sort_unstable());
        let weights = nodes.iter().map(|node| weights(node.area, cells, part)).collect();
        let mut merging = Self { nodes, weights, adjacencies, neighbours, heap: BinaryHeap::new(), cells, part };
        (0..arcs.len() as u32).for_each(|adjacency| merging.put(adjacency));
        merging
    }

    /// Adds an adjacency with its cost to the heap.
    fn put(&mut self, number: u32) {
        let adjacency = &self.adjacencies[number as usize];
        let (cost, length) = (self.cost(adjacency), adjacency.sums.length);
        self.heap.push(Ranked { rank: MergeOrder::new(cost, length, number), item: adjacency.version });
    }

    /// How much is seen between two regions.
    fn cost(&self, adjacency: &Adjacency) -> f64 {
        let [a, b] = adjacency.ends.map(|end| end as usize);
        let difference = colour_difference(&self.nodes[a], &self.nodes[b]);
        let colour = difference / (1.0 + difference / MOST_COLOUR);
        let (small, large) = if self.nodes[a].area <= self.nodes[b].area { (a, b) } else { (b, a) };
        (adjacency.sums.mean() + COLOUR * colour) * self.weights[small][0] * self.weights[large][1]
    }

    /// Makes one region of the two beside an adjacency, at its cost.
    fn unite(&mut self, adjacency: u32, cost: f64) {
        let [a, b] = self.adjacencies[adjacency as usize].ends;
        self.adjacencies[adjacency as usize].alive = false;
        let node = united(&self.nodes[a as usize], &self.nodes[b as usize], &self.adjacencies[adjacency as usize].sums);
        let number = self.nodes.len() as u32;
        self.weights.push(weights(node.area, self.cells, self.part));
        self.nodes.push(Node { children: Some([a, b]), height: node.height.max(cost), ..node });
        let [of_a, of_b] = [a, b].map(|end| std::mem::take(&mut self.neighbours[end as usize]));
        let mut merged = Vec::with_capacity(of_a.len() + of_b.len());
        for (old, list) in [(a, of_a), (b, of_b)] {
            for (other, of_other) in list {
                if other == a || other == b {
                    continue;
                }
                let adjacency = &mut self.adjacencies[of_other as usize];
                adjacency.ends = adjacency.ends.map(|end| if end == old { number } else { end });
                merged.push((other, of_other));
            }
        }
        merged.sort_unstable();
        let mut kept: Vec<(u32, u32)> = Vec::with_capacity(merged.len());
        for (other, of_other) in merged {
            let list = &mut self.neighbours[other as usize];
            list.retain(|(end, _)| *end != a && *end != b);
            match kept.last() {
                Some(&(before, into)) if before == other => self.join(into, of_other),
                _ => kept.push((other, of_other)),
            }
        }
        for &(other, adjacency) in &kept {
            // the new number is the highest of all
            self.neighbours[other as usize].push((number, adjacency));
            self.adjacencies[adjacency as usize].version += 1;
            self.put(adjacency);
        }
        self.neighbours.push(kept);
    }

    /// Makes one of two adjacencies between the same regions.
    fn join(&mut self, into: u32, from: u32) {
        let turned = self.adjacencies[into as usize].ends != self.adjacencies[from as usize].ends;
        let sums = self.adjacencies[from as usize].sums;
        self.adjacencies[from as usize].alive = false;
        self.adjacencies[into as usize].sums.add(&sums, turned);
    }
}

/// What a region of an area counts beside a larger one, and beside a smaller one.
fn weights(area: f64, cells: f64, part: f64) -> [f64; 2] {
    [NEGLIGIBLE, part].map(|share| (area / (area + share * cells)).powf(POWER))
}

/// Distance of the mean colours of two regions.
fn colour_difference(a: &Node, b: &Node) -> f64 {
    (0..3).map(|k| a.colour[k] / a.area - b.colour[k] / b.area).map(|d| d * d).sum::<f64>().sqrt()
}

/// Two regions as one, without the border between them.
fn united(a: &Node, b: &Node, between: &Sums) -> Node {
    let mut outline = a.outline;
    outline.add(&b.outline, false);
    outline.add_times(between, false, -1.0);
    outline.add_times(between, true, -1.0);
    Node {
        area: a.area + b.area,
        colour: std::array::from_fn(|k| a.colour[k] + b.colour[k]),
        picture_edge: a.picture_edge + b.picture_edge,
        outline,
        children: None,
        height: a.height.max(b.height),
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "sums of whole numbers are exact")]
mod tests;
