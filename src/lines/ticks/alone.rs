//! Straight strokes that stand alone, as the hours of a clock face that do not touch its rim: one that is a little too
//! short for a line is drawn longer where it has room, about its middle, or else beyond one of its ends.

use super::found::is_straight;
use super::{MARGIN, longer};
use crate::geom::polyline::Polyline;
use crate::lines::links;
use crate::lines::params::Params;
use crate::lines::vertex::{Vertex, nearby};
use crate::units::MmRect;

/// By which shares of what a stroke lacks its first and its last end are led on, in the order in which that is tried.
const SHARES: [[f32; 2]; 3] = [[0.5, 0.5], [0.0, 1.0], [1.0, 0.0]];

/// Makes strokes that are shorter than a line, yet not shorter than a link, as long as a line has to be, if no other
/// line is near.
pub(in crate::lines) fn lengthen(polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) {
    let lengths = links::shortest(params)..params.sure_length();
    let is_short = |line: &Polyline<Vertex>| lengths.contains(&line.length()) && is_straight(line);
    let short: Vec<usize> = (0..polylines.len()).filter(|&number| is_short(&polylines[number])).collect();
    if short.is_empty() {
        return;
    }
    let clearance = params.max_clearance();
    let mut all = nearby(polylines.iter(), area, params);
    for number in short {
        let stroke = &polylines[number];
        let more = params.sure_length() + MARGIN - stroke.length();
        let candidate = |shares: [f32; 2]| {
            let mut longer = longer(stroke, shares.map(|share| share * more));
            longer.fill();
            longer
        };
        let is_free = |vertex: &Vertex| {
            let is_other = |line: u32| line as usize != number;
            area.contains(vertex.at) && all.nearest(vertex.at, clearance, |near| is_other(near.line)).is_none()
        };
        let mut candidates = SHARES.into_iter().map(candidate);
        if let Some(longer) = candidates.find(|longer| longer.vertices.iter().all(is_free)) {
            all.insert_line(number as u32, longer.view(), 0.0);
            polylines[number] = longer;
        }
    }
}

#[cfg(test)]
mod tests;
