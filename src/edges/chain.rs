//! Ridge points that follow one another are linked to chains.
//!
//! Every pair of near points that lie along each other's edge is a candidate link. The shortest and straightest links
//! are taken first, and a point has one link on either side. So each point ends up with at most two neighbours, closed
//! contours close by themselves, and the result does not depend on where the search begins.

use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::ridge::RidgePoint;
use crate::geom::polyline::Polyline;
use crate::units::Size;

/// A chain as numbers of ridge points.
pub(super) type Chain = Polyline<u32>;

/// Greatest distance of linked points in pixel columns and rows. Neighbours on a thinned contour are at most sqrt(2)
/// apart, but a pixel is skipped where the axis of comparison changes.
const REACH: u32 = 2;
/// Distances of linked points, px. Nearer points are two readings of one point and show no direction along an edge.
const MIN_DISTANCE: f32 = 0.05;
const MAX_DISTANCE: f32 = 2.5;
/// Least cosine between a link and the edge at both its points, and between the directions of the edge there (60
/// degrees).
const MIN_COSINE: f32 = 0.5;
/// Marks a side of a point without a link.
const NONE: u32 = u32::MAX;

/// Links points (in reading order) to chains of at least `min_length` px: first the open chains, then the closed ones.
pub(super) fn link(points: &[RidgePoint], size: Size, min_length: f32) -> Vec<Chain> {
    let links = candidates(points, size);
    // of links with the same cost, the one found first is taken first
    let mut order: Vec<u64> = (0_u64..).zip(&links).map(|(i, link)| u64::from(link.cost) << 32 | i).collect();
    order.par_sort_unstable(); // no two are equal
    // neighbour[p][s]: the point linked to p on side s of its tangent
    let mut neighbour = vec![[NONE; 2]; points.len()];
    for link in order.iter().map(|cost_and_number| &links[(cost_and_number & 0xffff_ffff) as usize]) {
        let [p, q] = link.ends.map(|end| end as usize);
        let [sp, sq] = link.sides.map(usize::from);
        if neighbour[p][sp] == NONE && neighbour[q][sq] == NONE {
            neighbour[p][sp] = q as u32;
            neighbour[q][sq] = p as u32;
        }
    }
    let mut chains = follow(&neighbour);
    chains.retain(|chain| length(points, chain) >= min_length);
    chains
}

/// Length of a chain, px.
pub(super) fn length(points: &[RidgePoint], chain: &Chain) -> f32 {
    let at = |number: u32| points[number as usize].at;
    let closing = if chain.closed { chain.vertices.last().zip(chain.vertices.first()) } else { None };
    let segments = chain.vertices.windows(2).map(|pair| (&pair[0], &pair[1])).chain(closing);
    segments.map(|(&a, &b)| (at(b) - at(a)).length()).sum()
}

/// The indices before and after index `i` of `n` points; at the ends of an open chain `i` itself.
pub(super) fn neighbours(n: usize, closed: bool, i: usize) -> [usize; 2] {
    if closed { [(i + n - 1) % n, (i + 1) % n] } else { [i.saturating_sub(1), (i + 1).min(n - 1)] }
}

/// A possible link of two points, on one side of each.
struct Link {
    cost: u32,
    ends: [u32; 2],
    sides: [u8; 2],
}

/// Number of rows that are searched as one task.
const ROWS: usize = 64;

/// All candidate links, in reading order of their first points.
fn candidates(points: &[RidgePoint], size: Size) -> Vec<Link> {
    let mut starts = vec![0_usize; size.height as usize + 1];
    for point in points {
        starts[point.row as usize + 1] += 1;
    }
    for row in 0..size.height as usize {
        starts[row + 1] += starts[row];
    }
    let height = size.height as usize;
    let blocks = (0..height.div_ceil(ROWS)).into_par_iter().map(|block| block * ROWS..height.min((block + 1) * ROWS));
    let found: Vec<Vec<Link>> = blocks.map(|rows| candidates_from(rows, points, &starts, height)).collect();
    let mut links = Vec::with_capacity(found.iter().map(Vec::len).sum());
    found.into_iter().for_each(|more| links.extend(more));
    links
}

/// Candidate links from the points in some rows to later points. `starts` has the number of the first point of each
/// row.
fn candidates_from(rows: Range<usize>, points: &[RidgePoint], starts: &[usize], height: usize) -> Vec<Link> {
    let mut links = Vec::with_capacity(2 * (starts[rows.end] - starts[rows.start]));
    for row in rows {
        // in this row and in those below, the first point that is not too far to the left
        let mut firsts: [usize; 1 + REACH as usize] =
            std::array::from_fn(|down| starts[(row + down).min(starts.len() - 1)]);
        for (i, p) in (starts[row]..).zip(&points[starts[row]..starts[row + 1]]) {
            for (down, first) in firsts.iter_mut().enumerate().filter(|(down, _)| row + down < height) {
                let end = starts[row + down + 1];
                while *first < end && points[*first].column + REACH < p.column {
                    *first += 1;
                }
                let near = (*first..).zip(&points[*first..end]).take_while(|(_, q)| q.column <= p.column + REACH);
                links.extend(near.filter(|(j, _)| *j > i).filter_map(|(j, q)| candidate((i, p), (j, q))));
            }
        }
    }
    links
}

/// The link between two points, if they may be linked.
fn candidate((i, p): (usize, &RidgePoint), (j, q): (usize, &RidgePoint)) -> Option<Link> {
    let (dx, dy) = (q.at.x - p.at.x, q.at.y - p.at.y);
    let square = dx * dx + dy * dy;
    if !(MIN_DISTANCE * MIN_DISTANCE..=MAX_DISTANCE * MAX_DISTANCE).contains(&square) {
        return None;
    }
    let distance = square.sqrt();
    // cosine to the tangent of a point, which is its normal turned by 90 degrees
    let along = |r: &RidgePoint| (-r.normal.y * dx + r.normal.x * dy) / distance;
    let (ap, aq) = (along(p), along(q));
    let parallel = p.normal.dot(q.normal).abs();
    if ap.abs() < MIN_COSINE || aq.abs() < MIN_COSINE || parallel < MIN_COSINE {
        return None;
    }
    let cost = distance + (2.0 - ap.abs() - aq.abs()) + (1.0 - parallel);
    Some(Link {
        cost: (cost * 1_048_576.0) as u32,
        ends: [i as u32, j as u32],
        sides: [u8::from(ap > 0.0), u8::from(aq < 0.0)],
    })
}

/// Follows the links: first from the ends of open chains, then around the closed ones.
fn follow(neighbour: &[[u32; 2]]) -> Vec<Chain> {
    let mut seen = vec![false; neighbour.len()];
    let mut chains = Vec::new();
    for closed in [false, true] {
        for start in 0..neighbour.len() {
            let [a, b] = neighbour[start];
            let begins = if closed { a != NONE && b != NONE } else { (a == NONE) != (b == NONE) };
            if begins && !seen[start] {
                chains.push(Chain { vertices: follow_from(start as u32, neighbour, &mut seen), closed });
            }
        }
    }
    chains
}

/// The points from `start` on, as far as they are linked and not yet seen.
fn follow_from(start: u32, neighbour: &[[u32; 2]], seen: &mut [bool]) -> Vec<u32> {
    let mut points = Vec::new();
    let [a, b] = neighbour[start as usize];
    let (mut before, mut here) = (start, if a == NONE { b } else { a });
    seen[start as usize] = true;
    points.push(start);
    while here != NONE && !seen[here as usize] {
        seen[here as usize] = true;
        points.push(here);
        let [a, b] = neighbour[here as usize];
        (before, here) = (here, if a == before { b } else { a });
    }
    points
}

#[cfg(test)]
mod tests;
