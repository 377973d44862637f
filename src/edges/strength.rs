//! Strength: the height of a colour step, less what speaks for texture.
//!
//! ```text
//! strength = step * (1 - u + u c) * sqrt(H0 / (H0 + H))      c = sqrt(parted * sqrt(long * calm)) / blur
//! ```
//!
//! | sign | 0..=1 | why | without it, val | train |
//! |---|---|---|---|---|
//! | all | | | .675 .697 .690 | .706 .731 .732 |
//! | `parted` | difference on both sides after the colours have flowed / step | a contour parts two areas, a blade of grass one lawn | .657 .681 .669 | .686 .712 .711 |
//! | `1 / blur` | scale of the derivative / blur that the edge shows | what is out of focus, and shading, is not meant | .670 .692 .682 | .697 .725 .720 |
//! | `H` | how busy the surroundings are | an edge among many others counts less | .673 .699 .692 | .699 .732 .727 |
//! | `calm` | 1 / (1 + variance around the calmer side / 8^2) | texture lies on both sides of its edges, seldom of an outline | .672 .698 .688 | .698 .732 .727 |
//! | `long` | l / (l + 6 cells) of the chain | outlines are long, and texture breaks into crumbs | .673 .698 .688 | .703 .727 .719 |
//! | `u` | H / (H + 12) | **an edge that stands alone is a contour, whatever it looks like**; 1 is for photographs alone | .676 .700 .691 | .708 .738 .722 |
//!
//! The figures are ODS, OIS and AP on 50 photographs each of the contour benchmark BSDS500. The
//! cues before (a window on either side, and coherence around) read .658 .683 .664 and .678 .709 .696.
//!
//! `H` is the height of the edges on a straight way through the surroundings, less two steps of the edge itself (a pen
//! stroke has two sides), less what noise adds, and less what runs all one way. In a drawing or on an even ground `u` is
//! near 0 and the strength *is* the height of the step; in a photograph `u` is near 1.
//!
//! The exponents are those that logistic regression gave on the logarithms, rounded to roots, which are the same on every
//! machine. Tried in vain: edges with a stronger one beside them count less (ODS less by .002 to .01), longer averages
//! along the chain, windows of several sizes.
//!
//! All this only takes away, never adds, so thresholds on the step hold as bounds.

use super::Params;
use super::chain::{self, Chain};
use super::sides::Sides;
use super::thin::Ridge;

/// Lower bound of `parted`: a wire or the rim of a cup has one ground on both sides and must not vanish.
const LEAST_PARTED: f32 = 0.05;

/// Spread around the calmer side that halves `calm`, in units of strength.
const SPREAD: f32 = 8.0;

/// Length of a chain that halves `long`, in cells.
const SHORT: f32 = 6.0;

/// Height of edges around that makes `u` one half.
const ALONE: f32 = 12.0;

/// Height of edges around that takes a factor sqrt(2) off every edge among them: about the mean of photographs.
const BUSY: f32 = 120.0;

/// Strength of every point of a chain, averaged along the chain.
pub(super) fn along(points: &[Ridge], chain: &Chain, sides: &Sides, params: &Params) -> Vec<f32> {
    let length = chain::length(points, chain);
    let long = length / (length + SHORT * params.side_cell);
    let strength = |&number: &u32| {
        let point = &points[number as usize];
        point.step * (1.0 - params.suppression * (1.0 - share(point, long, sides, params)))
    };
    let raw: Vec<f32> = chain.iter().map(strength).collect();
    // points of a chain are a pixel apart, give or take the slant
    averaged(&raw, chain.first() == chain.last(), params.strength_window.round() as usize)
}

/// How much of a step's height counts as strength, 0..=1.
fn share(point: &Ridge, long: f32, sides: &Sides, params: &Params) -> f32 {
    let step = point.step.max(1e-6);
    let beside = sides.beside(point.at, point.normal);
    let parted = (beside.difference / step).clamp(LEAST_PARTED, 1.0);
    let calm = 1.0 / (1.0 + beside.variance / (SPREAD * SPREAD));
    let blur = (point.blur / params.sigma).max(1.0);
    let contour = (parted * (long * calm).sqrt()).sqrt() / blur;
    let around = (sides.busy(point.at) - 2.0 * step).max(0.0);
    let depth = around / (around + ALONE);
    (1.0 - depth + depth * contour) * (BUSY / (BUSY + around)).sqrt()
}

/// Means over `window` values to both sides, fewer at the ends. A closed chain's last value is its first again.
fn averaged(raw: &[f32], closed: bool, window: usize) -> Vec<f32> {
    let n = if closed { raw.len() - 1 } else { raw.len() };
    let mean = |i: usize| {
        let reach = if closed { window.min((n - 1) / 2) } else { window.min(i).min(n - 1 - i) };
        let sum: f32 = raw[i] + (1..=reach).map(|k| raw[(i + k) % n] + raw[(i + n - k) % n]).sum::<f32>();
        sum / (2 * reach + 1) as f32
    };
    let mut means: Vec<f32> = (0..n).map(mean).collect();
    if closed {
        means.push(means[0]);
    }
    means
}
