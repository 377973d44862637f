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
    let colours = together(colours, basin.len());
    let cracks: Vec<Crack> = found.iter().map(|(_, crack)| *crack).collect();
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for of_arc in found.chunk_by(|a, b| a.0 == b.0) {
        let start = ranges.last().map_or(0, |range| range.end);
        ranges.push(start..start + of_arc.len());
    }
    let arc = |moments: &mut ArcMoments, range: Range<usize>| {
        let ends = found[range.start].0;
        moments.find(&cracks[range.clone()], grid);
        let sums = measure(&cracks[range.clone()], moments, ends, basin, (grid, traces, &colours));
        Arc { ends, sums, cracks: range }
    };
    let arcs = ranges.into_par_iter().map_init(ArcMoments::default, arc).collect();
    (cracks, arcs)
}

/// All cracks, each with the two basins beside it (the lower number first), sorted by these; cracks of the same two
/// basins row by row.
fn found(basin: &[u32], grid: RegionGrid) -> Vec<([u32; 2], Crack)> {
    let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
    let mut found: Vec<([u32; 2], Crack)> = Vec::with_capacity(basin.len() / 4);
    for (y, row) in basin.chunks_exact(width).enumerate() {
        let below = if y + 1 < height { &basin[(y + 1) * width..][..width] } else { row };
        let mut put = |a: u32, b: u32, x: usize, is_upright: bool| {
            if a != b {
                found.push(([a.min(b), a.max(b)], Crack { cell: (y * width + x) as u32, is_upright }));
            }
        };
        for (x, (pair, &below)) in row.windows(2).zip(below).enumerate() {
            put(pair[0], below, x, false);
            put(pair[0], pair[1], x, true);
        }
        put(row[width - 1], below[width - 1], width - 1, false);
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

/// The colours of each of `count` cells side by side, up to three of them, as they are looked up together.
fn together(colours: &[Plane], count: usize) -> Vec<[f32; 4]> {
    if let [l, a, b] = colours {
        let cells = l.values.iter().zip(&a.values).zip(&b.values);
        return cells.map(|((&l, &a), &b)| [l, a, b, 0.0]).collect();
    }
    let mut all = vec![[0.0; 4]; count];
    for (k, plane) in colours.iter().enumerate().take(3) {
        all.iter_mut().zip(&plane.values).for_each(|(of_cell, value)| of_cell[k] = *value);
    }
    all
}

/// Sums up what is seen at the cracks of one arc.
fn measure(
    cracks: &[Crack],
    moments: &ArcMoments,
    ends: [u32; 2],
    basin: &[u32],
    (grid, traces, colours): (RegionGrid, &TraceMap, &[[f32; 4]]),
) -> Sums {
    let mut sums = Sums::default();
    for (crack, moments) in cracks.iter().zip(&moments.of_cracks) {
        let tangent = tangent(moments, crack);
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
            let seen = place.look_up_each(colours);
            sums.colours[side].iter_mut().zip(seen).for_each(|(sum, value)| *sum += f64::from(value));
        }
    }
    sums
}

/// Sums over the cracks near one, from its middle, in halves of a cell: whole numbers, so that their order does not
/// matter. Three of them, of up to [`FIELD`] bits with their sign, make one number each.
#[derive(Clone, Copy)]
struct Moments {
    /// Of x and y of the middles, and how many they are.
    first: i64,
    /// Of xx, xy and yy of the ends, half of each.
    second: i64,
}

/// Bits of a sum: there are fewer than 200 cracks in reach, and no square is more than 65.
const FIELD: u32 = 20;
/// A crack more.
const ONE: i64 = 1 << (2 * FIELD);

/// The sums in a number, the lowest first.
fn sums_in(number: i64) -> [i32; 3] {
    let lowest = |number: i64| number << (i64::BITS - FIELD) >> (i64::BITS - FIELD);
    let first = lowest(number);
    let above = (number - first) >> FIELD;
    let second = lowest(above);
    [first as i32, second as i32, ((above - second) >> FIELD) as i32]
}

/// The moments of all cracks of an arc, and what they are found by: there are many arcs.
#[derive(Default)]
struct ArcMoments {
    of_cracks: Vec<Moments>,
    /// The middles of cracks, each with what its ends add to the squares of that.
    middles: Vec<([i32; 2], i64)>,
}

impl ArcMoments {
    /// Finds those of some cracks.
    fn find(&mut self, cracks: &[Crack], grid: RegionGrid) {
        const REACH: i32 = 2 * TANGENT_REACH as i32;
        let middle = |crack: &Crack| {
            let [x, y] = crack.half();
            (crack.half_cells(grid), i64::from(x) + (i64::from(y) << (2 * FIELD)))
        };
        self.middles.clear();
        self.middles.extend(cracks.iter().map(middle));
        self.of_cracks.clear();
        self.of_cracks.resize(cracks.len(), Moments { first: 0, second: 0 });
        let mut rest = (&mut self.of_cracks[..], &self.middles[..]);
        while let ([own, others @ ..], [(middle, ends), later @ ..]) = rest {
            let (mut first, mut second) = (own.first + ONE, own.second + ends);
            for (moments, (other, of_other)) in others.iter_mut().zip(later) {
                let to = [other[0] - middle[0], other[1] - middle[1]];
                // cracks come row by row; in a row those that run down lie half a cell higher
                if to[1] > REACH + 1 {
                    break;
                }
                // x alone first: its square across a wide grid is more than 32 bits hold
                if to[0].abs() <= REACH && to[0] * to[0] + to[1] * to[1] <= REACH * REACH {
                    let (x, y) = (i64::from(to[0]), i64::from(to[1]));
                    let (way, squares) = (x + (y << FIELD), x * x + ((x * y) << FIELD) + ((y * y) << (2 * FIELD)));
                    first += ONE + way;
                    second += squares + of_other;
                    moments.first += ONE - way;
                    moments.second += squares + ends;
                }
            }
            *own = Moments { first, second };
            rest = (others, later);
        }
    }
}

/// The direction of an arc at a crack: the main axis of the cracks near it.
fn tangent(moments: &Moments, crack: &Crack) -> PxVector {
    // each crack has two ends
    let ([x, y, count], [xx, xy, yy]) = (sums_in(moments.first), sums_in(moments.second));
    let count = (2 * count) as f32;
    let (x, y) = ((2 * x) as f32 * 0.5 / count, (2 * y) as f32 * 0.5 / count);
    let (xx, xy, yy) = ((2 * xx) as f32, (2 * xy) as f32, (2 * yy) as f32);
    let [xx, xy, yy] = [0.25 * xx / count, 0.25 * xy / count, 0.25 * yy / count];
    let own = if crack.is_upright { PxVector::new(0.0, 1.0) } else { PxVector::new(1.0, 0.0) };
    first_eigenvector(xx - x * x, xy - x * y, yy - y * y).unwrap_or(own)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "sums of whole numbers are exact")]
mod tests;
