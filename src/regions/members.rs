//! Which basins each region is made of.

use super::arcs::Crack;
use super::tree::Tree;

/// Which basins each region is made of.
pub(super) struct Members {
    /// The place of each basin in an order in which those of every region follow one another.
    place: Vec<u32>,
    /// The places of each region.
    range: Vec<std::ops::Range<u32>>,
    /// The places of both ends of each arc, close together: an outline looks at all of them.
    ends: Vec<[u32; 2]>,
}

impl Members {
    pub(super) fn of(tree: &Tree) -> Self {
        let count = tree.nodes.len();
        let mut is_child = vec![false; count];
        for [a, b] in tree.nodes.iter().filter_map(|node| node.children) {
            (is_child[a as usize], is_child[b as usize]) = (true, true);
        }
        let mut place = vec![0; count];
        let mut range = vec![0..0; count];
        let mut next = 0;
        let mut todo: Vec<(u32, bool)> =
            (0..count as u32).filter(|&node| !is_child[node as usize]).map(|node| (node, false)).collect();
        while let Some((node, is_done)) = todo.pop() {
            let at = node as usize;
            match tree.nodes[at].children {
                None => {
                    place[at] = next;
                    range[at] = next..next + 1;
                    next += 1;
                }
                Some([a, b]) if is_done => range[at] = range[b as usize].start..range[a as usize].end,
                Some([a, b]) => todo.extend([(node, true), (a, false), (b, false)]),
            }
        }
        let ends = tree.arcs.iter().map(|arc| arc.ends.map(|basin| place[basin as usize])).collect();
        Self { place, range, ends }
    }

    /// Whether a basin is in a region.
    pub(super) fn has(&self, node: u32, basin: u32) -> bool {
        self.range[node as usize].contains(&self.place[basin as usize])
    }

    /// The cracks around a region.
    pub(super) fn outline(&self, tree: &Tree, node: u32) -> Vec<Crack> {
        let range = &self.range[node as usize];
        let mut outline = Vec::new();
        for (arc, ends) in tree.arcs.iter().zip(&self.ends) {
            if range.contains(&ends[0]) != range.contains(&ends[1]) {
                outline.extend_from_slice(&tree.cracks[arc.cracks.clone()]);
            }
        }
        outline
    }
}
