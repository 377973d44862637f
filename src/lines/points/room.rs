//! Room for points: a line that ends beside one, as the arc over a number line does, ends a little before it.

use super::drawn::{PASSES, radius};
use super::{FROM_SIDE, Point};
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::{Tip, Vertex};
use crate::units::MmPoint;

/// Shortens the lines that end nearer to points than their signs allow, and lead to none of these, by at most the
/// distance of two lines. An end at another line stays, as that is near to the point as well: the two are led together
/// later.
pub(in crate::lines) fn make_room(points: &[Point], polylines: &mut [Polyline<Vertex>], params: &Params) {
    // discs are moved themselves
    let signs: Vec<(MmPoint, f32)> =
        points.iter().filter(|point| !point.is_disc).map(|point| (point.at, radius(point, params))).collect();
    for number in 0..polylines.len() {
        for which in Tip::BOTH {
            let line = &polylines[number];
            let Some(end) = which.of(line).filter(|_| !line.closed).map(|end| end.at) else { continue };
            let is_beside = |(at, radius): &&(MmPoint, f32)| {
                let beside = params.beside_disc(*radius);
                (*at - end).length() < beside && line.distance(*at) > PASSES * radius
            };
            let near: Vec<&(MmPoint, f32)> = signs.iter().filter(is_beside).collect();
            let leads = |(at, radius): &(MmPoint, f32)| (*at - end).length() <= PASSES * radius;
            let is_on = |(other, of): (usize, &Polyline<Vertex>)| other != number && of.distance(end) <= FROM_SIDE;
            if near.is_empty() || signs.iter().any(leads) || polylines.iter().enumerate().any(is_on) {
                continue;
            }
            let most = (line.length() - params.min_length).clamp(0.0, params.max_spacing());
            let is_clear = |line: &Polyline<Vertex>| {
                near.iter().all(|(at, radius)| line.distance(*at) >= params.beside_disc(*radius) + params.play())
            };
            let shorter = line.shorter_ones(which, most).skip(1).find(is_clear);
            if let Some(shorter) = shorter {
                polylines[number] = shorter;
            }
        }
    }
}
