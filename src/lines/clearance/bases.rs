//! A line of a drawing on which others end goes before them: an axis before the bars that stand on it. They end on it
//! whenever it is drawn, but where they come first, it has no room between two that are near to one another. What is
//! left of a line that had to be cut has its own saliency again.

use super::passage::TOUCH;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::vertex::{FoundIn, Tip, Vertex};
use crate::units::MmRect;

/// How many lines that stand on one another are followed; following a cycle of such lines stops there too.
pub(crate) const HIGHEST_STACK: usize = 8;
/// A straight line on which so many others end is the axis of a chart or a wall: it goes before all lines.
const AXIS: usize = 4;
/// A line is straight if the distance of its ends is at least this share of its length.
const STRAIGHT: f32 = 0.99;
/// A base is more salient than what stands on it by this share.
const MORE: f32 = 1e-4;

/// The saliency of each line, raised for those of a drawing to at least that of the lines that end on it.
pub(super) fn raised(
    saliencies: &[f32],
    lines: &[(Polyline<Vertex>, Rank)],
    area: MmRect,
    params: &Params,
) -> Vec<f32> {
    let mut all = saliencies.to_vec();
    let on_bases = lines_on_bases(lines, area, params);
    let most = saliencies.iter().copied().fold(0.0, f32::max);
    let mut count = vec![0; lines.len()];
    on_bases.iter().for_each(|&(_, base)| count[base] += 1);
    for ((line, _), (own, count)) in lines.iter().zip(all.iter_mut().zip(count)) {
        if params.of_drawing && count >= AXIS && line.chord() >= STRAIGHT * line.length() {
            *own = own.max(most);
        }
    }
    for _ in 0..HIGHEST_STACK {
        let before = all.clone();
        for &(stem, base) in &on_bases {
            if before[base] <= before[stem] {
                all[base] = all[base].max((1.0 + MORE) * before[stem]);
            }
        }
        if all == before {
            break;
        }
    }
    all
}

/// Which lines end on which strokes and paths of drawings, away from their ends.
fn lines_on_bases(lines: &[(Polyline<Vertex>, Rank)], area: MmRect, params: &Params) -> Vec<(usize, usize)> {
    let meant = |line: &Polyline<Vertex>| line.vertices.iter().filter(|at| at.source != FoundIn::Pixels).count();
    let is_base = |line: &Polyline<Vertex>| 2 * meant(line) > line.vertices.len();
    if !lines.iter().any(|(line, _)| is_base(line)) {
        return Vec::new();
    }
    let mut segments = Nearby::new(area, params.max_spacing());
    for (number, (line, _)) in lines.iter().enumerate().filter(|(_, (line, _))| is_base(line)) {
        let arcs = line.arc_lengths();
        let length = arcs.last().copied().unwrap_or(0.0);
        for (i, (a, b)) in line.segments().enumerate() {
            // near its own end it may as well be the other one that stands on it
            if line.closed || (arcs[i] > params.max_stub() && arcs[i + 1] < length - params.max_stub()) {
                let (line, index, arc) = (number as u32, i as u32, arcs[i]);
                segments.insert(Segment { a: a.at, b: b.at, half_width: 0.0, line, index, arc });
            }
        }
    }
    let tips_of = |(stem, (line, _)): (usize, &(Polyline<Vertex>, Rank))| {
        let corners = if params.of_drawing { line.view().corners_of_ring() } else { Vec::new() };
        let corners = corners.into_iter().map(|corner| line.vertices[corner].at);
        let ends = Tip::BOTH.into_iter().filter(|_| !line.closed).filter_map(|which| Some(which.of(line)?.at));
        ends.chain(corners).map(|at| (stem, at)).collect::<Vec<_>>()
    };
    segments.which_end_on(lines.iter().enumerate().flat_map(tips_of), TOUCH, |_, _| true)
}

#[cfg(test)]
mod tests;
