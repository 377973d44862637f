//! Ridge points that follow one another become chains.
//!
//! Every pair of near points that lie along each other's edge is a possible link; the shortest and straightest are taken
//! first, and a point has one link on either side. So each point ends with two neighbours at most, closed contours close
//! by themselves, and the result does not hang on where the search began.

use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::thin::Ridge;
use crate::units::Size;

/// A chain as numbers of ridge points; closed iff the last is the first again.
pub(super) type Chain = Vec<u32>;

/// Linked points are at most this far apart, px: thinned contours touch at sqrt(2), and skip a pixel where the axis of
/// comparison changes.
const REACH: u32 = 2;
/// ... and by place at least this far (two readings of one place are no way along an edge) and at most that, px.
const LEAST: f32 = 0.05;
const MOST: f32 = 2.5;
/// Least cosine between a link and the edge at both its points, and between the edge's directions there (60 degrees).
const STRAIGHT: f32 = 0.5;
const NONE: u32 = u32::MAX;

/// Links points (in reading order) to chains of at least `least` px, those with free ends first, then the closed ones.
pub(super) fn link(points: &[Ridge], size: Size, least: f32) -> Vec<Chain> {
    let links = candidates(points, size);
    // of links that cost the same the first found is taken first
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
    let mut chains = walk(&neighbour);
    chains.retain(|chain| length(points, chain) >= least);
    chains
}

/// Length of a chain, px.
pub(super) fn length(points: &[Ridge], chain: &[u32]) -> f32 {
    chain.windows(2).map(|pair| (points[pair[1] as usize].at - points[pair[0] as usize].at).length()).sum()
}

struct Link {
    cost: u32,
    ends: [u32; 2],
    sides: [u8; 2],
}

/// So many rows are searched at once.
const ROWS: usize = 64;

/// All possible links, in reading order of their first points.
fn candidates(points: &[Ridge], size: Size) -> Vec<Link> {
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

/// Possible links from the points in some rows to points behind them. `starts` says where the points of each row begin.
fn candidates_from(rows: Range<usize>, points: &[Ridge], starts: &[usize], height: usize) -> Vec<Link> {
    let mut links = Vec::with_capacity(2 * (starts[rows.end] - starts[rows.start]));
    for row in rows {
        // where the points of this row and of those below begin that are not too far to the left
        let mut firsts: [usize; 1 + REACH as usize] =
            std::array::from_fn(|on| starts[(row + on).min(starts.len() - 1)]);
        for (i, p) in (starts[row]..).zip(&points[starts[row]..starts[row + 1]]) {
            for (on, first) in firsts.iter_mut().enumerate().filter(|(on, _)| row + on < height) {
                let end = starts[row + on + 1];
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

fn candidate((i, p): (usize, &Ridge), (j, q): (usize, &Ridge)) -> Option<Link> {
    let (dx, dy) = (q.at.x - p.at.x, q.at.y - p.at.y);
    let square = dx * dx + dy * dy;
    if !(LEAST * LEAST..=MOST * MOST).contains(&square) {
        return None;
    }
    let distance = square.sqrt();
    // along each point's tangent, which is its normal turned by a quarter
    let along = |r: &Ridge| (-r.normal[1] * dx + r.normal[0] * dy) / distance;
    let (ap, aq) = (along(p), along(q));
    let parallel = (p.normal[0] * q.normal[0] + p.normal[1] * q.normal[1]).abs();
    if ap.abs() < STRAIGHT || aq.abs() < STRAIGHT || parallel < STRAIGHT {
        return None;
    }
    let cost = distance + (2.0 - ap.abs() - aq.abs()) + (1.0 - parallel);
    Some(Link {
        cost: (cost * 1_048_576.0) as u32,
        ends: [i as u32, j as u32],
        sides: [u8::from(ap > 0.0), u8::from(aq < 0.0)],
    })
}

/// Follows the links: first from free ends, then round the rings.
fn walk(neighbour: &[[u32; 2]]) -> Vec<Chain> {
    let mut seen = vec![false; neighbour.len()];
    let mut chains = Vec::new();
    for rings in [false, true] {
        for start in 0..neighbour.len() {
            let [a, b] = neighbour[start];
            if seen[start] || (a == NONE && b == NONE) || (!rings && a != NONE && b != NONE) {
                continue;
            }
            let mut chain = vec![start as u32];
            seen[start] = true;
            let (mut before, mut here) = (start as u32, if a == NONE { b } else { a });
            while here != NONE && !seen[here as usize] {
                seen[here as usize] = true;
                chain.push(here);
                let [a, b] = neighbour[here as usize];
                (before, here) = (here, if a == before { b } else { a });
            }
            if rings {
                chain.push(start as u32);
            }
            chains.push(chain);
        }
    }
    chains
}
