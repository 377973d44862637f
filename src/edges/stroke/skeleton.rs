//! The middle of structures, a pixel wide: thinning, and the paths between the junctions of what is left.

use crate::units::{PxPoint, Size};

/// A path of pixels between two nodes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SkeletonPath {
    /// Centres of its pixels in order.
    pub(super) points: Vec<PxPoint>,
    /// The junctions at its start and its end; none where it ends freely.
    pub(super) nodes: [Option<usize>; 2],
    /// Whether it is a ring without junctions.
    pub(super) closed: bool,
}

/// Where three or more paths meet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SkeletonNode {
    pub(super) at: PxPoint,
    /// Distance to the border of the mask before it was thinned, px.
    pub(super) depth: f32,
}

/// A path that comes back to the junction it began at has at least so many pixels.
const LOOP: usize = 12;

/// The eight neighbours of a pixel in order round it, beginning above it.
const AROUND: [(isize, isize); 8] = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1)];

/// A mask with a border of one pixel that is never set, so that every pixel has eight neighbours.
#[derive(Debug, Clone)]
pub(super) struct StrokeMask {
    stride: usize,
    cells: Vec<bool>,
    /// The pixels that are set, in order.
    set: Vec<usize>,
    /// Distance of each pixel to the next that is not set, px: the larger of the two along the axes.
    depths: Vec<u16>,
}

impl StrokeMask {
    /// A picture of this size with these pixels set.
    pub(super) fn new(size: Size, set: impl Iterator<Item = usize>) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let stride = width + 2;
        let mut cells = vec![false; stride * (height + 2)];
        for pixel in set {
            cells[(pixel / width + 1) * stride + pixel % width + 1] = true;
        }
        let set: Vec<usize> = (0..cells.len()).filter(|&cell| cells[cell]).collect();
        let depths = depths(&set, cells.len(), stride);
        Self { stride, cells, set, depths }
    }

    fn neighbour(&self, cell: usize, k: usize) -> usize {
        let (dx, dy) = AROUND[k % 8];
        cell.wrapping_add_signed(dy * self.stride as isize + dx)
    }

    fn ring(&self, cell: usize) -> [bool; 8] {
        std::array::from_fn(|k| self.cells[self.neighbour(cell, k)])
    }

    /// Centre of a cell, px of the picture.
    fn centre(&self, cell: usize) -> PxPoint {
        PxPoint::new((cell % self.stride) as f32 - 0.5, (cell / self.stride) as f32 - 0.5)
    }

    /// Thins the mask until it is a pixel wide (Z. Guo and R. W. Hall 1989, algorithm A1). The algorithm of T. Y. Zhang
    /// and C. Y. Suen (1984) takes diagonal lines away altogether that are two pixels wide.
    ///
    /// Which neighbours of a pixel are set is kept beside the mask: most pixels stay for many rounds, and each is asked
    /// in every one.
    pub(super) fn thin(&mut self) {
        let mut rings = vec![0_u8; self.cells.len()];
        for &cell in &self.set {
            (0..8).for_each(|k| rings[self.neighbour(cell, k)] |= 1 << ((k + 4) % 8));
        }
        let mut set = std::mem::take(&mut self.set);
        loop {
            let mut changed = false;
            for removable in &REMOVABLE {
                let removed: Vec<usize> =
                    set.iter().copied().filter(|&cell| removable[usize::from(rings[cell])]).collect();
                changed |= !removed.is_empty();
                for cell in removed {
                    self.cells[cell] = false;
                    (0..8).for_each(|k| rings[self.neighbour(cell, k)] &= !(1 << ((k + 4) % 8)));
                }
                set.retain(|&cell| self.cells[cell]);
            }
            if !changed {
                break;
            }
        }
        // steps of staircases: a pixel whose neighbours are connected without it
        for &cell in &set {
            if self.is_step(cell) {
                self.cells[cell] = false;
            }
        }
        set.retain(|&cell| self.cells[cell]);
        self.set = set;
    }

    /// Whether a pixel only fills the corner between two neighbours that touch one another.
    fn is_step(&self, cell: usize) -> bool {
        let ring = self.ring(cell);
        let [n, ne, e, se, s, sw, w, nw] = ring;
        let diagonal = [ne, se, sw, nw].iter().filter(|set| **set).count();
        let count = ring.iter().filter(|set| **set).count();
        let corner = (n && e && !sw) || (e && s && !nw) || (s && w && !ne) || (w && n && !se);
        count == 2 + diagonal && corner && [n, e, s, w].iter().filter(|set| **set).count() == 2 && diagonal == 0
    }

    /// The paths and junctions of a mask that is thinned.
    pub(super) fn paths(&self) -> (Vec<SkeletonPath>, Vec<SkeletonNode>) {
        let set = &self.set;
        let (node_of, nodes) = self.nodes(set);
        let mut walk = Walk { mask: self, node_of: &node_of, seen: vec![false; self.cells.len()], paths: Vec::new() };
        // from junctions, then from free ends, then round rings
        for &cell in set.iter().filter(|&&cell| node_of[cell].is_some()) {
            for k in 0..8 {
                walk.follow(cell, self.neighbour(cell, k));
            }
        }
        for &cell in set.iter().filter(|&&cell| self.ring(cell).iter().filter(|set| **set).count() == 1) {
            walk.follow_from_end(cell);
        }
        for &cell in set {
            walk.follow_ring(cell);
        }
        (walk.paths, nodes)
    }

    /// The number of the junction that each pixel belongs to, and the junctions.
    fn nodes(&self, set: &[usize]) -> (Vec<Option<usize>>, Vec<SkeletonNode>) {
        let mut node_of = vec![None; self.cells.len()];
        let is_junction = |cell: usize| self.cells[cell] && transitions(self.ring(cell)) >= 3;
        let mut nodes = Vec::new();
        for &cell in set {
            if node_of[cell].is_some() || !is_junction(cell) {
                continue;
            }
            let mut members = vec![cell];
            node_of[cell] = Some(nodes.len());
            let mut next = 0;
            while next < members.len() {
                for k in 0..8 {
                    let other = self.neighbour(members[next], k);
                    if node_of[other].is_none() && is_junction(other) {
                        node_of[other] = Some(nodes.len());
                        members.push(other);
                    }
                }
                next += 1;
            }
            let sum = members.iter().fold(PxPoint::zero(), |sum, &cell| sum + self.centre(cell).to_vector());
            let depth = members.iter().map(|&cell| self.depths[cell]).max().unwrap_or(0);
            nodes.push(SkeletonNode { at: sum / members.len() as f32, depth: f32::from(depth) });
        }
        (node_of, nodes)
    }
}

/// For the first half of a round of thinning and the second: whether a pixel goes whose neighbours are set as the bits
/// of a number say, from the one above it on.
static REMOVABLE: [[bool; 256]; 2] = [removable(false), removable(true)];

const fn removable(second: bool) -> [bool; 256] {
    let mut removable = [false; 256];
    let mut ring = 0;
    while ring < 256 {
        removable[ring] = is_removable(ring, second);
        ring += 1;
    }
    removable
}

const fn is_removable(ring: usize, second: bool) -> bool {
    let mut is_set = [false; 8];
    let mut k = 0;
    while k < 8 {
        is_set[k] = (ring >> k) & 1 == 1;
        k += 1;
    }
    let [n, ne, e, se, s, sw, w, nw] = is_set;
    let connected = count([!n && (ne || e), !e && (se || s), !s && (sw || w), !w && (nw || n)]);
    let (a, b) = (count([nw || n, ne || e, se || s, sw || w]), count([n || ne, e || se, s || sw, w || nw]));
    let neighbours = if a < b { a } else { b };
    let sides = if second { (s || sw || !nw) && w } else { (n || ne || !se) && e };
    connected == 1 && matches!(neighbours, 2..=3) && !sides
}

const fn count([a, b, c, d]: [bool; 4]) -> u8 {
    a as u8 + b as u8 + c as u8 + d as u8
}

/// The chessboard distance of each of so many cells to the next that is not set (A. Rosenfeld and J. Pfaltz 1966).
/// Those that are set come in order, and none is at the border.
fn depths(set: &[usize], cells: usize, stride: usize) -> Vec<u16> {
    let mut depths = vec![0_u16; cells];
    for &cell in set {
        depths[cell] = u16::MAX - 1;
    }
    for &cell in set {
        let before = [cell - stride - 1, cell - stride, cell - stride + 1, cell - 1].map(|other| depths[other]);
        depths[cell] = depths[cell].min(before.into_iter().fold(u16::MAX, u16::min).saturating_add(1));
    }
    for &cell in set.iter().rev() {
        let after = [cell + stride + 1, cell + stride, cell + stride - 1, cell + 1].map(|other| depths[other]);
        depths[cell] = depths[cell].min(after.into_iter().fold(u16::MAX, u16::min).saturating_add(1));
    }
    depths
}

/// How often the ring of neighbours goes from unset to set.
fn transitions(ring: [bool; 8]) -> usize {
    (0..8).filter(|&k| !ring[k] && ring[(k + 1) % 8]).count()
}

struct Walk<'a> {
    mask: &'a StrokeMask,
    node_of: &'a [Option<usize>],
    seen: Vec<bool>,
    paths: Vec<SkeletonPath>,
}

impl Walk<'_> {
    /// Follows a path from a junction's pixel over its first pixel.
    fn follow(&mut self, from: usize, first: usize) {
        if !self.mask.cells[first] || self.seen[first] || self.node_of[first].is_some() {
            return;
        }
        let start = self.node_of[from];
        let (cells, end) = self.along(first, start);
        self.add(&cells, [start, end], false);
    }

    fn follow_from_end(&mut self, cell: usize) {
        if !self.seen[cell] && self.node_of[cell].is_none() {
            let (cells, end) = self.along(cell, None);
            self.add(&cells, [None, end], false);
        }
    }

    fn follow_ring(&mut self, cell: usize) {
        if !self.seen[cell] && self.node_of[cell].is_none() {
            let (cells, end) = self.along(cell, None);
            let last = cells[cells.len() - 1];
            let closed = end.is_none() && cells.len() > 2 && (0..8).any(|k| self.mask.neighbour(last, k) == cell);
            self.add(&cells, [None, end], closed);
        }
    }

    /// The pixels from `first` on, and the junction that they end at. `start` is the junction they come from, which
    /// they may come back to, but not with their first step.
    fn along(&mut self, first: usize, start: Option<usize>) -> (Vec<usize>, Option<usize>) {
        let mut cells = vec![first];
        self.seen[first] = true;
        loop {
            let here = cells[cells.len() - 1];
            // neighbours that share a side come first
            let order = [0, 2, 4, 6, 1, 3, 5, 7].map(|k| self.mask.neighbour(here, k));
            let nodes = || order.iter().filter_map(|&cell| self.node_of[cell]);
            let node = nodes().find(|&node| Some(node) != start).or_else(|| nodes().next());
            // beside the junction that it comes from it goes on
            if node.is_some() && (node != start || cells.len() >= LOOP) {
                return (cells, node);
            }
            let next = order
                .into_iter()
                .find(|&cell| self.mask.cells[cell] && !self.seen[cell] && self.node_of[cell].is_none());
            let Some(next) = next else {
                let node = node.filter(|_| cells.len() > 2);
                return (cells, node);
            };
            self.seen[next] = true;
            cells.push(next);
        }
    }

    fn add(&mut self, cells: &[usize], nodes: [Option<usize>; 2], closed: bool) {
        let points = cells.iter().map(|&cell| self.mask.centre(cell)).collect();
        self.paths.push(SkeletonPath { points, nodes, closed });
    }
}

#[cfg(test)]
mod tests;
