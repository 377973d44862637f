//! Where basins meet: cracks between two cells, and arcs of all cracks between the same two basins.

use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::grid::RegionGrid;
use super::traces::TraceMap;
use crate::geom::{first_eigenvector, right_of};
use crate::raster::plane::{Plane, SubpixelPosition};
use crate::units::{PxPoint, PxVector};

/// Cracks of an arc within this distance, cells, give a crack's direction.
const TANGENT_REACH: f32 = 4.0;
/// How far from a crack the colours of its two sides are looked at, cells.
const SIDE_DISTANCE: f32 = 5.0;
/// Steps are counted up to this strength: a stronger one closes a region no better.
const CLEAR: f32 = 20.0;
/// Strength from which a crack counts as seen.
const SEEN: f32 = 5.0;

/// The side between two cells of different basins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crack {
    /// The cell on its left or above it; the other is the next one to the right or below.
    pub(super) cell: u32,
    /// Whether the cells lie side by side, so that it runs down.
    pub(super) is_upright: bool,
}

impl Crack {
    /// Both cells.
    pub(super) fn cells(&self, grid: RegionGrid) -> [usize; 2] {
        let cell = self.cell as usize;
        [cell, cell + if self.is_upright { 1 } else { grid.cells.width as usize }]
    }

    /// Its middle, in cells.
    pub(super) fn middle(&self, grid: RegionGrid) -> PxPoint {
        let width = grid.cells.width;
        let (x, y) = ((self.cell % width) as f32, (self.cell / width) as f32);
        if self.is_upright { PxPoint::new(x + 1.0, y + 0.5) } else { PxPoint::new(x + 0.5, y + 1.0) }
    }

    /// Its middle, in halves of a cell.
    fn half_cells(&self, grid: RegionGrid) -> [i32; 2] {
        let width = grid.cells.width;
        let (x, y) = (2 * (self.cell % width) as i32, 2 * (self.cell / width) as i32);
        if self.is_upright { [x + 2, y + 1] } else { [x + 1, y + 2] }
    }

    /// From its middle to an end, in halves of a cell.
    fn half(&self) -> [i32; 2] {
        if self.is_upright { [0, 1] } else { [1, 0] }
    }
}

/// Sums over cracks.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Sums {
    /// How many cracks.
    pub(super) length: f64,
    pub(super) strength: f64,
    /// Strengths up to [`CLEAR`].
    pub(super) clear: f64,
    /// How many are [`SEEN`].
    pub(super) seen: f64,
    /// Colours on both sides (L, 2a, 2b).
    pub(super) colours: [[f64; 3]; 2],
}

impl Sums {
    /// Adds others, with sides exchanged if `turned`.
    pub(super) fn add(&mut self, other: &Self, turned: bool) {
        self.add_times(other, turned, 1.0);
    }

    /// Adds others so many times.
    pub(super) fn add_times(&mut self, other: &Self, turned: bool, times: f64) {
        self.length += times * other.length;
        self.strength += times * other.strength;
        self.clear += times * other.clear;
        self.seen += times * other.seen;
        for side in 0..2 {
            let from = if turned { 1 - side } else { side };
            (0..3).for_each(|k| self.colours[side][k] += times * other.colours[from][k]);
        }
    }

    /// Mean strength.
    pub(super) fn mean(&self) -> f64 {
        self.strength / self.length.max(1.0)
    }

    /// Mean strength up to [`CLEAR`], as a share of it.
    pub(super) fn clearness(&self) -> f64 {
        self.clear / (f64::from(CLEAR) * self.length.max(1.0))
    }
}

/// All cracks between two basins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arc {
    /// The basins, the lower number first; so are the sides of the sums.
    pub(super) ends: [u32; 2],
    pub(super) sums: Sums,
    /// Its cracks among all.
    pub(super) cracks: Range<usize>,
}

/// All cracks, arc by arc, and the arcs in the order of their basins.
pub(super) fn arcs(basin: &[u32], grid: RegionGrid, traces: &TraceMap, colours: &[Plane]) -> (Vec<Crack>, Vec<Arc>) {
    let found = found(basin, grid);
    let cracks: Vec<Crack> = found.iter().map(|(_, crack)| *crack).collect();
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for of_arc in found.chunk_by(|a, b| a.0 == b.0) {
        let start = ranges.last().map_or(0, |range| range.end);
        ranges.push(start..start + of_arc.len());
    }
    let arc = |range: Range<usize>| {
        let ends = found[range.start].0;
        let sums = measure(&cracks[range.clone()], ends, basin, grid, traces, colours);
        Arc { ends, sums, cracks: range }
    };
    let arcs = ranges.into_par_iter().map(arc).collect();
    (cracks, arcs)
}

/// All cracks, each with the two basins beside it (the lower number first), sorted by these; cracks of the same two
/// basins row by row.
fn found(basin: &[u32], grid: RegionGrid) -> Vec<([u32; 2], Crack)> {
    let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
    let mut found: Vec<([u32; 2], Crack)> = Vec::new();
    for (y, row) in basin.chunks_exact(width).enumerate() {
        let mut put = |a: u32, b: u32, x: usize, is_upright: bool| {
            if a != b {
                found.push(([a.min(b), a.max(b)], Crack { cell: (y * width + x) as u32, is_upright }));
            }
        };
        let below = if y + 1 < height { &basin[(y + 1) * width..][..width] } else { row };
        for x in 0..width {
            put(row[x], below[x], x, false);
            put(row[x], row[(x + 1).min(width - 1)], x, true);
        }
    }
    // They were found row by row. Numbers of basins are dense, so that counting orders them in little time, first by
    // the higher number, then by the lower one.
    let count = basin.iter().max().map_or(0, |last| *last as usize + 1);
    let by_higher = counted(&found, count, |(ends, _)| ends[1]);
    counted(&by_higher, count, |(ends, _)| ends[0])
}

/// Items in the order of a number below `count`; equal ones stay in order.
fn counted<T: Copy>(items: &[T], count: usize, number: impl Fn(&T) -> u32) -> Vec<T> {
    let mut next = vec![0_usize; count + 1];
    items.iter().for_each(|item| next[number(item) as usize + 1] += 1);
    for i in 1..next.len() {
        next[i] += next[i - 1];
    }
    let Some(&first) = items.first() else { return Vec::new() };
    let mut out = vec![first; items.len()];
    for item in items {
        let place = &mut next[number(item) as usize];
        out[*place] = *item;
        *place += 1;
    }
    out
}

/// Sums up what is seen at the cracks of one arc.
fn measure(
    cracks: &[Crack],
    ends: [u32; 2],
    basin: &[u32],
    grid: RegionGrid,
    traces: &TraceMap,
    colours: &[Plane],
) -> Sums {
    let mut sums = Sums::default();
    for (crack, tangent) in cracks.iter().zip(tangents(cracks, grid)) {
        let middle = crack.middle(grid);
        let strength = traces.strength(middle, tangent);
        // from the first cell to the second
        let across = right_of(tangent);
        let along_axis = if crack.is_upright { across.x } else { across.y };
        let across = if along_axis < 0.0 { -across } else { across };
        let first = usize::from(basin[crack.cell as usize] != ends[0]);
        sums.length += 1.0;
        sums.strength += f64::from(strength);
        sums.clear += f64::from(strength.min(CLEAR));
        sums.seen += f64::from(u8::from(strength >= SEEN));
        for (side, at) in [(first, middle - across * SIDE_DISTANCE), (1 - first, middle + across * SIDE_DISTANCE)] {
            let place = SubpixelPosition::new(grid.cells, at.x, at.y);
            for (sum, plane) in sums.colours[side].iter_mut().zip(colours) {
                *sum += f64::from(place.look_up(&plane.values));
            }
        }
    }
    sums
}

/// Sums over the ends of the cracks near one, from its middle, in halves of a cell: whole numbers, so that their order
/// does not matter.
#[derive(Clone, Copy)]
struct Moments {
    count: i32,
    x: i32,
    y: i32,
    xx: i32,
    xy: i32,
    yy: i32,
}

impl Moments {
    /// Adds both ends of a crack whose middle is there; `half` is from its middle to an end.
    fn add(&mut self, [x, y]: [i32; 2], half: [i32; 2]) {
        self.count += 2;
        self.x += 2 * x;
        self.y += 2 * y;
        self.xx += 2 * (x * x + half[0]);
        self.xy += 2 * x * y;
        self.yy += 2 * (y * y + half[1]);
    }
}

/// The direction of an arc at each of its cracks: the main axis of the cracks near it.
fn tangents(cracks: &[Crack], grid: RegionGrid) -> Vec<PxVector> {
    const REACH: i32 = 2 * TANGENT_REACH as i32;
    let middles: Vec<([i32; 2], [i32; 2])> =
        cracks.iter().map(|crack| (crack.half_cells(grid), crack.half())).collect();
    let none = Moments { count: 0, x: 0, y: 0, xx: 0, xy: 0, yy: 0 };
    let mut moments = vec![none; cracks.len()];
    let mut rest = (&mut moments[..], &middles[..]);
    while let ([own, others @ ..], [(middle, half), later @ ..]) = rest {
        own.add([0, 0], *half);
        for (moments, (other, of_other)) in others.iter_mut().zip(later) {
            let to = [other[0] - middle[0], other[1] - middle[1]];
            // cracks come row by row; in a row those that run down lie half a cell higher
            if to[1] > REACH + 1 {
                break;
            }
            // x alone first: its square across a wide grid is more than 32 bits hold
            if to[0].abs() <= REACH && to[0] * to[0] + to[1] * to[1] <= REACH * REACH {
                own.add(to, *of_other);
                moments.add([-to[0], -to[1]], *half);
            }
        }
        rest = (others, later);
    }
    moments.iter().zip(cracks).map(|(moments, crack)| tangent(moments, crack)).collect()
}

/// The main axis of the cracks near one.
fn tangent(moments: &Moments, crack: &Crack) -> PxVector {
    let &Moments { count, x, y, xx, xy, yy } = moments;
    let count = count as f32;
    let mean = [x, y].map(|sum| 0.5 * sum as f32 / count);
    let [xx, xy, yy] = [xx, xy, yy].map(|sum| 0.25 * sum as f32 / count);
    let own = if crack.is_upright { PxVector::new(0.0, 1.0) } else { PxVector::new(1.0, 0.0) };
    first_eigenvector(xx - mean[0] * mean[0], xy - mean[0] * mean[1], yy - mean[1] * mean[1]).unwrap_or(own)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "sums of whole numbers are exact")]
mod tests;
