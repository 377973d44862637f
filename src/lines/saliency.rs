//! Saliency: how much a line tells about the picture. It decides between rivals, and how much detail a page has.
//!
//! A person who draws from a picture begins with the long, strong, closed and smooth contours.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::params::Params;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmVector;

/// A closed line is as salient as an open one of this many times its length: it is a thing, not a part of one.
const CLOSED: f32 = 1.5;
/// Bends to and fro, radians per mm, that halve the saliency. A line that bends only to one side, such as a ring, has
/// none; fur and foliage have more than one bend of a quarter turn every 4 mm.
const WAVERING: f32 = 0.4;
/// Directions for the bends are taken over this many vertices (2 mm), so that noise does not count.
const SPAN: usize = 5;
/// Lengths of full strength that a line must be worth at the detail 0, in least lengths: 120 mm on a sheet with 8 mm.
const OUTLINES: f32 = 15.0;
/// What a line must be worth is at most this share of the saliency of the page's first line, as pages and overviews
/// differ in size.
const OF_FIRST: f32 = 0.25;

/// The saliency of each of some lines.
pub(super) fn saliencies(lines: &[Polyline<Vertex>], params: &Params) -> Vec<f32> {
    lines.par_iter().map(|line| saliency(line, params)).collect()
}

/// Length, mm, of a straight line of full strength that is as salient.
pub(super) fn saliency(polyline: &Polyline<Vertex>, params: &Params) -> f32 {
    let strength = |vertex: &Vertex| vertex.counted_strength(params.full_strength);
    let sum: f32 = polyline.segments().map(|(a, b)| (b.at - a.at).length() * strength(a).min(strength(b))).sum();
    let closed = if polyline.closed { CLOSED } else { 1.0 };
    sum / params.full_strength * closed / (1.0 + wavering(polyline) / WAVERING)
}

/// How much a line bends to and fro: the turns that others take back, radians per mm.
fn wavering(polyline: &Polyline<Vertex>) -> f32 {
    let headings: Vec<MmVector> = polyline
        .path()
        .step_by(SPAN)
        .zip(polyline.path().skip(SPAN).step_by(SPAN))
        .filter_map(|(a, b)| (b.at - a.at).try_normalize())
        .collect();
    let (mut sum, mut total) = (0.0_f32, 0.0_f32);
    for pair in headings.windows(2) {
        let turn = pair[0].cross(pair[1]).atan2(pair[0].dot(pair[1]));
        sum += turn;
        total += turn.abs();
    }
    (total - sum.abs()) / polyline.length().max(1.0)
}

/// The least saliency of a line that is drawn at `params.detail`; it falls as the detail rises.
///
/// At 1/2 it is the least length; from there it falls to nothing at 1 and grows to that of long outlines at 0, though
/// not beyond a share of `first`, the saliency of the first line.
pub(super) fn least(first: f32, params: &Params) -> f32 {
    let Params { detail, min_length, .. } = *params;
    if detail >= 0.5 {
        2.0 * (1.0 - detail) * min_length
    } else {
        (OUTLINES.powf(1.0 - 2.0 * detail) * min_length).min((OF_FIRST * first).max(min_length))
    }
}

#[cfg(test)]
mod tests;
