//! How much a line says: what decides between rivals, and how much detail a page has.
//!
//! A person who draws from a picture begins with the long, strong, closed and smooth contours.

use super::Params;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmVector;

/// A closed line says as much as an open one of this many times its length: it is a thing, not a part of one.
const CLOSED: f32 = 1.5;
/// Bends to and fro, radians per mm, that halve what a line says. A line that bends only one way, such as a ring, has none;
/// fur and foliage have more than one bend of a quarter turn every 4 mm.
const WAVERING: f32 = 0.4;
/// Directions for the bends are taken over this many vertices (2 mm), so that noise does not count.
const SPAN: usize = 5;
/// Lengths of full strength that a line must be worth at the detail 0, in least lengths: 120 mm on a sheet with 8 mm.
const OUTLINES: f32 = 15.0;
/// ... but not more than this share of what the first line of the page says, as pages and overviews differ in size.
const OF_FIRST: f32 = 0.25;

/// Length, mm, of a straight line of full strength that says as much.
pub(super) fn saliency(polyline: &Polyline<Vertex>, params: &Params) -> f32 {
    let sum: f32 = polyline.segments().map(|(a, b)| (b.at - a.at).length() * a.strength.min(b.strength)).sum();
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

/// What a line must say to be drawn at `params.detail`; it falls as the detail rises.
///
/// At 1/2 it is the least length; from there it falls to nothing at 1 and grows to that of long outlines at 0, though not
/// beyond a share of `first`, what the first line says.
pub(super) fn least(first: f32, params: &Params) -> f32 {
    let Params { detail, min_length, .. } = *params;
    if detail >= 0.5 {
        2.0 * (1.0 - detail) * min_length
    } else {
        (OUTLINES.powf(1.0 - 2.0 * detail) * min_length).min((OF_FIRST * first).max(min_length))
    }
}
