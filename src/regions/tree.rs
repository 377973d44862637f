//! The tree of regions, and which basins each is made of.

use super::arcs::{Arc, Crack, Sums, arcs};
use super::grid::RegionGrid;
use super::merge::{Node, merge};
use super::trace::TracedContour;
use super::traces::TraceMap;
use super::watershed::basins;
use crate::raster::plane::Plane;

/// Scale of the colour gradient, cells.
const GRADIENT_SCALE: f32 = 1.5;
/// Scale at which traces become ridges of the landscape, cells.
const TRACE_SCALE: f32 = 1.2;
/// Weights of traces and of the gradient in the landscape: where a trace runs it is the ridge, and the gradient parts
/// what lies between traces, such as where an outline fades. Chosen with the other numbers (see `regions`).
const TRACES: f32 = 3.0;
const GRADIENT: f32 = 0.9375;

/// How fine a tree is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Scale at which the landscape is smoothed, cells: what is narrower has no basin of its own.
    landscape_scale: f32,
    /// Regions of this share of the picture, and smaller ones, merge early with larger ones: parts join one another
    /// before they join the ground.
    pub(super) part: f64,
}

impl Detail {
    /// For the outlines of things on a page, and for the contours beside them.
    pub const OUTLINES: Self = Self { landscape_scale: 2.0, part: 0.02 };
    /// For contours that are traced in all their detail: twice as many basins, in twice the time.
    pub const CONTOURS: Self = Self { landscape_scale: 1.0, part: 0.004 };
}

/// All regions of a picture: basins, and what they are merged to.
#[derive(Debug, Clone, PartialEq)]
pub struct Tree {
    pub(super) grid: RegionGrid,
    pub(super) traces: TraceMap,
    /// The basin of each cell.
    pub(super) basin: Vec<u32>,
    /// How many basins there are.
    pub(super) basins: usize,
    pub(super) cracks: Vec<Crack>,
    pub(super) arcs: Vec<Arc>,
    /// Basins, then merged regions.
    pub(super) nodes: Vec<Node>,
    members: Members,
}

impl Tree {
    /// The regions between traces. `colours` are L, 2a and 2b of the cells, or L alone.
    pub fn new(traces: &[TracedContour], colours: &[Plane], grid: RegionGrid, detail: Detail) -> Self {
        let ((traces, ridges), (squares, soft)) = rayon::join(
            || {
                let traces = TraceMap::of(traces, grid);
                let ridges = traces.strengths().blurred(TRACE_SCALE);
                (traces, ridges)
            },
            || {
                let soft: Vec<Plane> = colours.iter().map(|plane| plane.blurred(TRACE_SCALE)).collect();
                (squared_gradient(colours, grid), soft)
            },
        );
        let (basin, count) = basins(&landscape(ridges, &squares, detail.landscape_scale));
        let ((cracks, arcs), nodes) =
            rayon::join(|| arcs(&basin, grid, &traces, &soft), || basin_nodes(&basin, count, colours, grid));
        let nodes = merge(nodes, &arcs, basin.len(), detail.part);
        let members = Members::of(&nodes, &arcs);
        Self { grid, traces, basin, basins: count, cracks, arcs, nodes, members }
    }

    /// Whether a basin is in a region.
    pub(super) fn has(&self, node: u32, basin: u32) -> bool {
        self.members.range[node as usize].contains(&self.members.place[basin as usize])
    }

    /// The numbers of the arcs around a region.
    pub(super) fn arcs_around(&self, node: u32) -> impl Iterator<Item = usize> {
        let range = &self.members.range[node as usize];
        let places = range.start as usize..range.end as usize;
        let of_basins = &self.members.arcs[self.members.first_arc[places.start]..self.members.first_arc[places.end]];
        of_basins.iter().filter(move |(_, other)| !range.contains(other)).map(|(arc, _)| *arc as usize)
    }

    /// The cracks around a region.
    pub(super) fn outline_of(&self, node: u32) -> impl Iterator<Item = &Crack> {
        self.arcs_around(node).flat_map(move |arc| &self.cracks[self.arcs[arc].cracks.clone()])
    }

    /// The side of a cell on the sheet, mm.
    pub(super) fn mm_of_cell(&self, mm_per_px: f32) -> f32 {
        mm_per_px * self.grid.picture.width as f32 / self.grid.cells.width as f32
    }
}

/// High where traces run and colours change, smooth at a scale, in cells, so that every basin is worth one. `ridges`
/// are the strengths of traces, `squares` the squared gradient.
fn landscape(mut ridges: Plane, squares: &[f32], scale: f32) -> Plane {
    let sum = |(v, square): (&mut f32, &f32)| *v = *v * TRACES + GRADIENT * square.sqrt();
    ridges.values.iter_mut().zip(squares).for_each(sum);
    ridges.blurred(scale)
}

/// The squared length of the colour gradient of each cell.
fn squared_gradient(colours: &[Plane], grid: RegionGrid) -> Vec<f32> {
    let mut squares = vec![0.0_f32; grid.cells.len()];
    let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
    for plane in colours {
        let soft = plane.blurred(GRADIENT_SCALE);
        let row = |y: usize| &soft.values[y * width..][..width];
        for (y, squares) in squares.chunks_exact_mut(width).enumerate() {
            let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
            for (square, (above, below)) in squares.iter_mut().zip(above.iter().zip(below)) {
                *square += 0.25 * (below - above) * (below - above);
            }
            let ends = [(0, 0, 1.min(width - 1)), (width - 1, width.saturating_sub(2), width - 1)];
            for (x, left, right) in ends.into_iter().take(width.min(2)) {
                squares[x] += 0.25 * (here[right] - here[left]).powi(2);
            }
            for (square, step) in squares.iter_mut().skip(1).zip(here.windows(3)) {
                *square += 0.25 * (step[2] - step[0]) * (step[2] - step[0]);
            }
        }
    }
    squares
}

/// Basins with their areas and colours.
fn basin_nodes(basin: &[u32], count: usize, colours: &[Plane], grid: RegionGrid) -> Vec<Node> {
    let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
    // colours and area; sums of their own lie closer together than in nodes
    let mut sums = vec![[0.0_f64; 4]; count];
    if let [l, a, b] = colours {
        let colours = l.values.iter().zip(&a.values).zip(&b.values);
        for (&basin, ((&l, &a), &b)) in basin.iter().zip(colours) {
            let [of_l, of_a, of_b, area] = &mut sums[basin as usize];
            *of_l += f64::from(l);
            *of_a += f64::from(a);
            *of_b += f64::from(b);
            *area += 1.0;
        }
    } else {
        basin.iter().for_each(|&basin| sums[basin as usize][3] += 1.0);
        for (k, plane) in colours.iter().enumerate().take(3) {
            basin.iter().zip(&plane.values).for_each(|(&basin, &value)| sums[basin as usize][k] += f64::from(value));
        }
    }
    let node = |[l, a, b, area]: [f64; 4]| {
        let outline = Sums::default();
        Node { area, colour: [l, a, b], picture_edge: 0.0, outline, children: None, height: 0.0 }
    };
    let mut nodes: Vec<Node> = sums.into_iter().map(node).collect();
    let (first, last) = (0, width * height - width);
    let sides = (0..width).flat_map(|x| [first + x, last + x]);
    for cell in sides.chain((0..height).flat_map(|y| [y * width, y * width + width - 1])) {
        nodes[basin[cell] as usize].picture_edge += 1.0;
    }
    nodes
}

/// Which basins each region is made of.
#[derive(Debug, Clone, PartialEq)]
struct Members {
    /// The place of each basin in an order in which those of every region follow one another.
    place: Vec<u32>,
    /// The places of each region.
    range: Vec<std::ops::Range<u32>>,
    /// The arcs around each basin, in the order of the places of these: the number of each, and the place of the basin
    /// beyond it.
    arcs: Vec<(u32, u32)>,
    /// By place, and behind the last: the first of its arcs among these.
    first_arc: Vec<usize>,
}

impl Members {
    fn of(nodes: &[Node], arcs: &[Arc]) -> Self {
        let count = nodes.len();
        let mut is_child = vec![false; count];
        for [a, b] in nodes.iter().filter_map(|node| node.children) {
            (is_child[a as usize], is_child[b as usize]) = (true, true);
        }
        let mut place = vec![0; count];
        let mut range = vec![0..0; count];
        let mut next = 0;
        let mut todo: Vec<(u32, bool)> =
            (0..count as u32).filter(|&node| !is_child[node as usize]).map(|node| (node, false)).collect();
        while let Some((node, is_done)) = todo.pop() {
            let at = node as usize;
            match nodes[at].children {
                None => {
                    place[at] = next;
                    range[at] = next..next + 1;
                    next += 1;
                }
                Some([a, b]) if is_done => range[at] = range[b as usize].start..range[a as usize].end,
                Some([a, b]) => todo.extend([(node, true), (a, false), (b, false)]),
            }
        }
        let ends: Vec<[u32; 2]> = arcs.iter().map(|arc| arc.ends.map(|basin| place[basin as usize])).collect();
        let (arcs, first_arc) = by_place(&ends, next as usize);
        Self { place, range, arcs, first_arc }
    }
}

/// The arcs of each of `count` places with the place beyond each, where `ends` are the places of both ends of all
/// arcs; and the first arc of each place among these.
fn by_place(ends: &[[u32; 2]], count: usize) -> (Vec<(u32, u32)>, Vec<usize>) {
    let mut first = vec![0; count + 1];
    ends.iter().flatten().for_each(|&place| first[place as usize + 1] += 1);
    for i in 1..first.len() {
        first[i] += first[i - 1];
    }
    let mut next = first.clone();
    let mut arcs = vec![(0, 0); 2 * ends.len()];
    for (number, &[a, b]) in (0_u32..).zip(ends) {
        for (place, beyond) in [(a, b), (b, a)] {
            arcs[next[place as usize]] = (number, beyond);
            next[place as usize] += 1;
        }
    }
    (arcs, first)
}

#[cfg(test)]
mod tests;
