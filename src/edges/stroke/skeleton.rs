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
        let depths = depths(&cells, stride);
        Self { stride, cells, depths }
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
    pub(super) fn thin(&mut self) {
        let mut set: Vec<usize> = (0..self.cells.len()).filter(|&cell| self.cells[cell]).collect();
        loop {
            let mut changed = false;
            for second in [false, true] {
                let removed: Vec<usize> = set.iter().copied().filter(|&cell| self.is_removable(cell, second)).collect();
                changed |= !removed.is_empty();
                removed.iter().for_each(|&cell| self.cells[cell] = false);
                set.retain(|&cell| self.cells[cell]);
            }
            if !changed {
                break;
            }
        }
        // steps of staircases: a pixel whose neighbours are connected without it
        for cell in set {
            if self.is_step(cell) {
                self.cells[cell] = false;
            }
        }
    }

    fn is_removable(&self, cell: usize, second: bool) -> bool {
        let ring = self.ring(cell);
        let [n, ne, e, se, s, sw, w, nw] = ring;
        let count = |set: [bool; 4]| set.into_iter().filter(|set| *set).count();
        let connected = count([!n && (ne || e), !e && (se || s), !s && (sw || w), !w && (nw || n)]);
        let neighbours = count([nw || n, ne || e, se || s, sw || w]).min(count([n || ne, e || se, s || sw, w || nw]));
        let sides = if second { (s || sw || !nw) && w } else { (n || ne || !se) && e };
        connected == 1 && (2..=3).contains(&neighbours) && !sides
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
        let set: Vec<usize> = (0..self.cells.len()).filter(|&cell| self.cells[cell]).collect();
        let (node_of, nodes) = self.nodes(&set);
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
        for &cell in &set {
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

/// The chessboard distance of each cell to the next that is not set (A. Rosenfeld and J. Pfaltz 1966). The cells have a
/// border that is not set.
fn depths(cells: &[bool], stride: usize) -> Vec<u16> {
    let mut depths: Vec<u16> = cells.iter().map(|set| if *set { u16::MAX - 1 } else { 0 }).collect();
    for cell in 0..cells.len() {
        if cells[cell] {
            let before = [cell - stride - 1, cell - stride, cell - stride + 1, cell - 1].map(|other| depths[other]);
            depths[cell] = depths[cell].min(before.into_iter().fold(u16::MAX, u16::min).saturating_add(1));
        }
    }
    for cell in (0..cells.len()).rev() {
        if cells[cell] {
            let after = [cell + stride + 1, cell + stride, cell + stride - 1, cell + 1].map(|other| depths[other]);
            depths[cell] = depths[cell].min(after.into_iter().fold(u16::MAX, u16::min).saturating_add(1));
        }
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
