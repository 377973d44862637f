//! Strength: the height of a colour step, reduced by the evidence for texture.
//!
//! ```text
//! strength = height * (1 - u + u c) * sqrt(H0 / (H0 + H))      c = sqrt(separation * sqrt(length * calm)) / blur
//! ```
//!
//! | term | definition, 0..=1 except `H` | reason |
//! |---|---|---|
//! | `separation` | difference of both sides after the edge-stopping filter / height | 1 |
//! | `1 / blur` | scale of the derivative / blur of the edge | 2 |
//! | `H` | summed height of the edges in the surround | 3 |
//! | `calm` | 1 / (1 + variance on the calmer side / 8^2) | 4 |
//! | `length` | l / (l + 6 cells) for a chain of length l | 5 |
//! | `u` | H / (H + 12) | 6 |
//!
//! 1. A contour separates two areas; a blade of grass lies within one lawn.
//! 2. Edges out of focus and shading matter less.
//! 3. An edge among many others counts less (surround suppression).
//! 4. Texture lies on both sides of its edges, seldom of an outline.
//! 5. Outlines are long, texture breaks into short chains.
//! 6. **An isolated edge is a contour, whatever it looks like.** `u = 1` suits only photographs.
//!
//! | without | val | train |
//! |---|---|---|
//! | nothing | .675 .697 .690 | .706 .731 .732 |
//! | `separation` | .657 .681 .669 | .686 .712 .711 |
//! | `1 / blur` | .670 .692 .682 | .697 .725 .720 |
//! | `H` | .673 .699 .692 | .699 .732 .727 |
//! | `calm` | .672 .698 .688 | .698 .732 .727 |
//! | `length` | .673 .698 .688 | .703 .727 .719 |
//! | `u` (always 1) | .676 .700 .691 | .708 .738 .722 |
//!
//! The figures are ODS, OIS and AP on 50 photographs each of the contour benchmark BSDS500. The cues used before (a
//! window on either side, and coherence of the surround) scored .658 .683 .664 and .678 .709 .696.
//!
//! `H` is the summed height of the edges on a straight line through the surround, less twice the height of the edge
//! itself (a pen stroke has two sides), less noise, and less edges that run in one common direction. In a drawing or
//! on an even ground `u` is near 0 and the strength *is* the height of the step; in a photograph `u` is near 1.
//!
//! The exponents come from a logistic regression on the logarithms, rounded to roots, which are the same on every
//! machine. Tried without gain: suppression of edges beside a stronger one (ODS .002 to .01 lower), longer averages
//! along the chain, windows of several sizes.
//!
//! **Regions.** In a photograph where the tree of [`regions`](crate::regions) is known, the strength `s` of each point
//! becomes a weighted geometric mean with `b`, what keeps the regions on both sides apart: `1.15 (s^3 b^5)^(1/8)`. `b`
//! is the greatest height in the tree of the borders within 2.5 cells, at least `s / 4` (a wire has no region of its
//! own). 1.15 makes pages of as many lines as without, at the same thresholds. Exponents of `b` from .5 to .7 have an
//! ODS within .001 of one another; 5/8 needs square roots only, which are the same on every machine.
//!
//! | | val | train |
//! |---|---|---|
//! | without regions | .676 .698 .689 | .706 .735 .731 |
//! | with those of [`Detail::CONTOURS`](crate::regions::Detail) | .693 .716 .698 | .718 .751 .746 |
//!
//! (The first row is what "nothing" is in the table above, measured at another time, with slightly other code.)
//!
//! The coarser basins of a page ([`Detail::OUTLINES`](crate::regions::Detail)) reach .682 .708 .690 (val). Tried
//! without gain: heights without the early merging of small parts (.691 .713 .696), basins at a scale of .8 cells (.689
//! .712 .695), a mean of `b` along the chain.
//!
//! Strength never exceeds the height of the step, so thresholds on the height hold as bounds.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::chain::{self, Chain};
use super::params::Params;
use super::ridge::RidgePoint;
use super::side_statistics::SideStatistics;
use crate::regions::Heights;

/// Lower bound of `separation`: a wire or the rim of a cup has the same ground on both sides and must not vanish.
const MIN_SEPARATION: f32 = 0.05;

/// Standard deviation on the calmer side at which `calm` is one half, in units of strength.
const HALF_CALM: f32 = 8.0;

/// Length of a chain at which `length` is one half, in cells.
const HALF_LENGTH: f32 = 6.0;

/// Height of the edges in the surround at which `u` is one half.
const HALF_DEPTH: f32 = 12.0;

/// Height of the edges in the surround at which every edge is reduced by a factor sqrt(2): about the mean of
/// photographs.
const HALF_SURROUND: f32 = 120.0;

/// What speaks for and against a contour beside its own points.
#[derive(Clone, Copy)]
pub(super) struct Evidence<'a> {
    pub(super) sides: &'a SideStatistics,
    /// Where the regions between all chains are known, their heights, and the strengths [`along`] each chain.
    pub(super) regions: Option<(&'a Heights, &'a [Vec<f32>])>,
}

/// The least height of a border, as a share of the strength of a point beside it.
const LEAST_HEIGHT: f32 = 0.25;
/// Strengths with regions, relative to those without.
const WITH_REGIONS: f32 = 1.15;

/// Strength of every point of the chain of this number, weighted by the regions beside it where they are known.
pub(super) fn weighted(
    points: &[RidgePoint],
    (number, chain): (usize, &Chain),
    evidence: &Evidence<'_>,
    params: &Params,
) -> Vec<f32> {
    let Some((heights, strengths)) = evidence.regions else { return along(points, chain, evidence.sides, params) };
    let by_regions = |(&strength, &number): (&f32, &u32)| {
        let point = &points[number as usize];
        by_regions(strength, heights.near(point.at)).min(point.height)
    };
    strengths[number].iter().zip(&chain.vertices).map(by_regions).collect()
}

/// Strength of every point of each chain.
pub(super) fn of_all(
    points: &[RidgePoint],
    chains: &[Chain],
    sides: &SideStatistics,
    params: &Params,
) -> Vec<Vec<f32>> {
    chains.par_iter().map(|chain| along(points, chain, sides, params)).collect()
}

/// A strength beside a border of regions, whose height in their tree is no step height.
fn by_regions(strength: f32, border_height: f32) -> f32 {
    let border_height = border_height.max(LEAST_HEIGHT * strength);
    let [s, b] = [strength, border_height].map(|v| v * v); // eight factors, each below 300
    WITH_REGIONS * (s * strength * b * b * border_height).sqrt().sqrt().sqrt()
}

/// Strength of every point of a chain, averaged along the chain.
fn along(points: &[RidgePoint], chain: &Chain, sides: &SideStatistics, params: &Params) -> Vec<f32> {
    let length = chain::length(points, chain);
    let length = length / (length + HALF_LENGTH * params.side_cell);
    let strength = |&number: &u32| {
        let point = &points[number as usize];
        point.height * (1.0 - params.suppression * (1.0 - share(point, length, sides, params)))
    };
    let raw: Vec<f32> = chain.vertices.iter().map(strength).collect();
    // the points of a chain are about a pixel apart
    averaged(&raw, chain.closed, params.strength_window.round() as usize)
}

/// The share of the height of a step that counts as strength, 0..=1. `length` is the term of the same name.
fn share(point: &RidgePoint, length: f32, statistics: &SideStatistics, params: &Params) -> f32 {
    let height = point.height.max(1e-6);
    let sides = statistics.sides(point.at, point.normal);
    let separation = (sides.difference / height).clamp(MIN_SEPARATION, 1.0);
    let calm = 1.0 / (1.0 + sides.variance / (HALF_CALM * HALF_CALM));
    let blur = (point.blur / params.sigma).max(1.0);
    let contour = (separation * (length * calm).sqrt()).sqrt() / blur;
    let surround = (statistics.surround(point.at) - 2.0 * height).max(0.0);
    let depth = surround / (surround + HALF_DEPTH);
    (1.0 - depth + depth * contour) * (HALF_SURROUND / (HALF_SURROUND + surround)).sqrt()
}

/// Means over `window` values on both sides; fewer near the ends of an open chain.
fn averaged(raw: &[f32], closed: bool, window: usize) -> Vec<f32> {
    let n = raw.len();
    let mean = |i: usize| {
        let reach = if closed { window.min((n - 1) / 2) } else { window.min(i).min(n - 1 - i) };
        let sum: f32 = raw[i] + (1..=reach).map(|k| raw[(i + k) % n] + raw[(i + n - k) % n]).sum::<f32>();
        sum / (2 * reach + 1) as f32
    };
    (0..n).map(mean).collect()
}

#[cfg(test)]
mod tests;
