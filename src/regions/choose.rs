//! Which regions tell most about a picture, the most salient ones: those with a clear outline all round, compact,
//! unlike what is beside them, and large, though not as large as the picture.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::arcs::Crack;
use super::disc::CellDisc;
use super::merge::Node;
use super::tree::Tree;
use crate::geom::cells::edge_cells;
use crate::ranked::{Ranked, TotalOrder};
use crate::units::Size;

/// What is asked of the regions that get an outline. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// At most so many.
    pub most: usize,
    /// At most so many of them are drawn, the first ones; all if none.
    pub drawn: Option<usize>,
    /// Each is worth at least this share of the first, 0..=1.
    pub least_gain: f32,
    /// Outlines nearer than this disturb one another.
    pub spacing: f32,
    /// Most of an outline that may be too near to others, as a share of its length, 0..=1.
    pub most_near: f32,
    /// No region, nothing between two, is drawn narrower than this.
    pub narrowest: f32,
    /// Sigma of the Gaussian that smooths an outline along itself.
    pub smoothing: f32,
}

/// Regions that get an outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chosen {
    /// Their numbers, the first first.
    pub regions: Vec<u32>,
    /// How many tell enough for an outline beside these, and are beyond the most that are drawn. No more are looked for
    /// than [`Params::most`] in all.
    pub beyond: usize,
}

/// What a region of the figure counts more than others in an overview. On 50 photographs of BSDS500 (val) an earlier
/// version, of which F was .551 and .250 of the lines closed (.567 and .264 on 28 November), had with 1 .551 and .24,
/// with 2 .550 and .241; with no others than those of the figure .547 and .22.
const PREFERRED: f64 = 1.5;
/// Difference of colour at which contrast is one half.
const HALF_CONTRAST: f64 = 20.0;
/// Exponent of the compactness.
const COMPACT: f64 = 0.75;
/// Exponent of the area.
const AREA: f64 = 0.33;
/// A region of this share of the picture or more is its ground, and counts nothing.
const GROUND: f64 = 0.7;
/// Below that share the ground fades out: a region counts fully from a share on that is less by this.
const GROUND_RANGE: f64 = 0.3;
/// What a region loses that lies along the edge of the picture.
const ALONG_PICTURE_EDGE: f64 = 0.8;
/// Cracks run in steps: an outline is shorter than its cracks by about this factor.
const STEPS: f64 = 0.8;
/// Most of an outline that counts as lying along the edge of the picture: a region whose other border is short would
/// count nothing otherwise, however clear that is.
const MOST_ALONG_PICTURE_EDGE: f64 = 0.9;
/// Least area, mm2, and least area of a region that is not strikingly clear.
const LEAST_AREA: f64 = 8.0;
const COMMON_AREA: f64 = 15.0;
/// Above this contrast, and with more than this clearness, a region is strikingly clear.
const STRIKING_CONTRAST: f64 = 0.6;
const STRIKING_CLEARNESS: f64 = 0.7;
/// An opening by this radius, mm, must keep that share of a region: what is thin is a line, not a region.
const OPENING: f32 = 1.2;
const KEPT: f64 = 0.6;
/// A region whose mean width is so many times the width of what the opening takes away is not looked at.
const WIDE: f64 = 2.5;
/// Outlines within this distance are the same, cells.
const SAME: f32 = 4.0;
/// Most of an outline that may be the same as those before it.
const MOST_SAME: f64 = 0.7;
/// Share of its gain that an outline loses where as much of it as is allowed is near to outlines chosen before; less in
/// proportion.
const NEAR: f64 = 0.7;

/// A region that may be chosen.
#[derive(Clone, Copy)]
struct RankedRegion {
    gain: f64,
    area: f64,
    node: u32,
    /// How many were chosen when its gain was computed.
    round: usize,
}

/// The best first; of equal ones the larger, then the one of the lower number.
type GainOrder = (TotalOrder, TotalOrder, Reverse<u32>);

impl RankedRegion {
    fn ranked(self) -> Ranked<GainOrder, Self> {
        Ranked { rank: (TotalOrder(self.gain), TotalOrder(self.area), Reverse(self.node)), item: self }
    }
}

/// The numbers of the most salient regions, the first first, after those of `leading`, which come first whatever they
/// tell; if they are among the most salient ones, the others stay the same. Those of `preferred` come before others
/// that are as salient, so that a finger finds in the figure what it felt in the overview. `mm_per_cell` is the side of
/// a cell on the sheet.
pub(super) fn choose(tree: &Tree, mm_per_cell: f32, params: &Params, leading: &[u32], preferred: &[u32]) -> Vec<u32> {
    if !leading.is_empty() {
        let plain = choose(tree, mm_per_cell, params, &[], preferred);
        if leading.iter().all(|node| plain.contains(node)) {
            let others = plain.into_iter().filter(|node| !leading.contains(node));
            return leading.iter().copied().chain(others).collect();
        }
    }
    let first_gain = |node: u32| {
        let factor = if preferred.contains(&node) { PREFERRED } else { 1.0 };
        factor * saliency(&tree.nodes[node as usize], tree.basin.len(), mm_per_cell)
    };
    let gains = (0_u32..).zip(&tree.nodes).map(|(node, of)| (node, first_gain(node), of.area));
    let mut heap: BinaryHeap<Ranked<GainOrder, RankedRegion>> = gains
        .filter(|(node, gain, _)| *gain > 0.0 && !leading.contains(node))
        .map(|(node, gain, area)| RankedRegion { gain, area, node, round: 0 }.ranked())
        .collect();
    let (mut chosen, mut first) = (leading.to_vec(), None);
    let mut near = Nearness::new(tree, mm_per_cell, params);
    leading.iter().for_each(|&node| near.add(node, tree));
    while let Some(Ranked { item: candidate, .. }) = heap.pop() {
        if chosen.len() >= params.most || candidate.gain < f64::from(params.least_gain) * first.unwrap_or(0.0) {
            break;
        }
        // a gain that was computed before the last choice is computed anew, and a region that is too near to what is
        // chosen is out for good
        if candidate.round < chosen.len() {
            if let Some(gain) = gain(first_gain(candidate.node), near.around(candidate.node, tree), params) {
                heap.push(RankedRegion { gain, round: chosen.len(), ..candidate }.ranked());
            }
            continue;
        }
        if !survives_opening(tree, candidate.node, mm_per_cell) {
            continue;
        }
        first.get_or_insert(candidate.gain);
        chosen.push(candidate.node);
        if chosen.len() == params.most {
            break;
        }
        near.add(candidate.node, tree);
    }
    chosen
}

/// How near a cell of the halved grid is to an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Closeness {
    Far,
    /// Outlines so near disturb one another.
    Disturbs,
    /// Outlines so near are the same.
    Same,
}

/// How near the cells of the halved grid are to the outlines of the chosen regions. Only cells around a new outline
/// are visited, which takes a tenth of the time of a distance transform.
struct Nearness {
    is_outline: Vec<bool>,
    of_cell: Vec<Closeness>,
    too_near: CellDisc,
    same: CellDisc,
    /// How many outlines were added.
    added: u32,
    /// What was counted last at each arc.
    of_arc: Vec<Counted>,
}

/// How many cracks of an outline, or of an arc, are near to others, and how near.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Counted {
    same: u32,
    too_near: u32,
    all: u32,
    /// How many outlines there were when it was counted: most regions that are looked at have arcs in common.
    added: u32,
}

impl Nearness {
    fn new(tree: &Tree, mm_per_cell: f32, params: &Params) -> Self {
        let size = half(tree.grid.cells);
        let (same, near) = ((0.5 * SAME).powi(2), (0.5 * params.spacing / mm_per_cell).powi(2));
        Self {
            is_outline: vec![false; size.len()],
            of_cell: vec![Closeness::Far; size.len()],
            too_near: CellDisc::new(size, |square| (square as f32) < near),
            same: CellDisc::new(size, |square| square as f32 <= same),
            added: 0,
            of_arc: vec![Counted::default(); tree.arcs.len()],
        }
    }

    /// Adds the outline of a chosen region.
    fn add(&mut self, node: u32, tree: &Tree) {
        self.added += 1;
        for cell in tree.outline_of(node).flat_map(|crack| crack.cells(tree.grid)) {
            let cell = halved(cell, tree.grid.cells);
            if std::mem::replace(&mut self.is_outline[cell], true) {
                continue;
            }
            for (disc, near) in [(&self.too_near, Closeness::Disturbs), (&self.same, Closeness::Same)] {
                for row in disc.around(cell) {
                    self.of_cell[row].iter_mut().for_each(|of_cell| *of_cell = near.max(*of_cell));
                }
            }
        }
    }

    /// How near the nearer cell beside a crack is.
    fn of(&self, crack: &Crack, tree: &Tree) -> Closeness {
        let [a, b] = crack.cells(tree.grid).map(|cell| self.of_cell[halved(cell, tree.grid.cells)]);
        a.max(b)
    }

    /// How near some cracks are.
    fn counted<'a>(&self, cracks: impl IntoIterator<Item = &'a Crack>, tree: &Tree) -> Counted {
        let mut counted = Counted { added: self.added, ..Counted::default() };
        for crack in cracks {
            let near = self.of(crack, tree);
            counted.same += u32::from(near == Closeness::Same);
            counted.too_near += u32::from(near == Closeness::Disturbs);
            counted.all += 1;
        }
        counted
    }

    /// How near the outline of a region is to those that were added.
    fn around(&mut self, node: u32, tree: &Tree) -> Counted {
        let mut all = Counted::default();
        for arc in tree.arcs_around(node) {
            if self.of_arc[arc].added != self.added || self.of_arc[arc].all == 0 {
                self.of_arc[arc] = self.counted(&tree.cracks[tree.arcs[arc].cracks.clone()], tree);
            }
            let of_arc = self.of_arc[arc];
            all.same += of_arc.same;
            all.too_near += of_arc.too_near;
            all.all += of_arc.all;
        }
        all
    }
}

/// How much a region tells, by itself: its saliency.
pub(super) fn saliency(node: &Node, cells: usize, mm_per_cell: f32) -> f64 {
    let length = STEPS * node.outline.length;
    let (share, square_mm) = (node.area / cells as f64, node.area * f64::from(mm_per_cell * mm_per_cell));
    if node.outline.length < 1.0 || square_mm < LEAST_AREA {
        return 0.0;
    }
    let clear = node.outline.clearness();
    let seen = node.outline.seen / node.outline.length;
    let compact = (2.0 * (std::f64::consts::PI * node.area).sqrt() / (length + node.picture_edge)).min(1.0);
    let [inside, outside] = node.outline.colours.map(|sum| sum.map(|v| v / node.outline.length));
    let difference = (0..3).map(|k| inside[k] - outside[k]).map(|d| d * d).sum::<f64>().sqrt();
    let contrast = difference / (difference + HALF_CONTRAST);
    if square_mm < COMMON_AREA && !(contrast > STRIKING_CONTRAST && clear > STRIKING_CLEARNESS) {
        return 0.0;
    }
    let not_ground = ((GROUND - share) / GROUND_RANGE).clamp(0.0, 1.0);
    let along_picture_edge = (node.picture_edge / (length + node.picture_edge)).min(MOST_ALONG_PICTURE_EDGE);
    clear
        * seen
        * seen
        * compact.powf(COMPACT)
        * contrast.sqrt()
        * share.powf(AREA)
        * not_ground
        * (1.0 - ALONG_PICTURE_EDGE * along_picture_edge)
}

/// A grid of half as many columns and rows, in which distances of outlines are looked at.
fn half(cells: Size) -> Size {
    Size::new(cells.width.div_ceil(2), cells.height.div_ceil(2))
}

/// The cell of the halved grid in which a cell lies.
fn halved(cell: usize, cells: Size) -> usize {
    let width = cells.width as usize;
    cell / width / 2 * half(cells).width as usize + cell % width / 2
}

/// What a region adds to those that are chosen, of its `first` gain, when none was; none if its outline is one of
/// theirs or too near to them. It falls as more are chosen, but where an outline that was near to one of them is the
/// same as the next: that waits behind its older gain.
fn gain(first: f64, outline: Counted, params: &Params) -> Option<f64> {
    let [same, too_near, count] = [outline.same, outline.too_near, outline.all.max(1)].map(f64::from);
    let (same, too_near) = (same / count, too_near / count);
    let too_near = too_near / f64::from(params.most_near);
    (same <= MOST_SAME && too_near <= 1.0).then_some(first * (1.0 - same) * (1.0 - NEAR * too_near))
}

/// Whether a region is more than a stroke. The edge of the picture narrows nothing.
pub(super) fn survives_opening(tree: &Tree, node: u32, mm_per_cell: f32) -> bool {
    let of = &tree.nodes[node as usize];
    let mean_width = 2.0 * of.area / (STEPS * of.outline.length + of.picture_edge);
    if mean_width >= WIDE * f64::from(2.0 * OPENING / mm_per_cell) {
        return true;
    }
    let (is_outside, size) = outside(tree, node);
    let square = (OPENING / mm_per_cell).powi(2);
    let disc = CellDisc::new(size, |of_cell| of_cell as f32 <= square);
    let is_core: Vec<bool> = disc.spread(&is_outside).iter().map(|near_outside| !near_outside).collect();
    let kept = disc.spread(&is_core).iter().filter(|is_kept| **is_kept).count();
    kept as f64 >= KEPT * of.area
}

/// Whether each cell is outside a region, in a box around it with a margin of one cell where there is one, and the
/// size of that.
fn outside(tree: &Tree, node: u32) -> (Vec<bool>, Size) {
    let width = tree.grid.cells.width as usize;
    let (mut columns, mut rows) = ((usize::MAX, 0), (usize::MAX, 0));
    let mut put = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        columns = (columns.0.min(x), columns.1.max(x + 1));
        rows = (rows.0.min(y), rows.1.max(y + 1));
    };
    // of a crack one cell is inside and the other, which is the margin, outside
    tree.outline_of(node).flat_map(|crack| crack.cells(tree.grid)).for_each(&mut put);
    let is_in: Vec<bool> = (0..tree.basins as u32).map(|basin| tree.has(node, basin)).collect();
    edge_cells(tree.grid.cells).filter(|&cell| is_in[tree.basin[cell] as usize]).for_each(&mut put);
    let cells =
        tree.basin[rows.0 * width..rows.1 * width].chunks_exact(width).flat_map(|row| &row[columns.0..columns.1]);
    let is_outside = cells.map(|&basin| !is_in[basin as usize]).collect();
    (is_outside, Size::new((columns.1 - columns.0) as u32, (rows.1 - rows.0) as u32))
}

#[cfg(test)]
mod tests;
