//! A line of a drawing on which others end goes before them: an axis before the bars that stand on it. They end on it
//! whenever it is drawn, but where they come first, it has no room between two that are near to one another. What is
//! left of a line that had to be cut has its own saliency again.

use std::collections::BTreeSet;

use super::passage::TOUCH;
use super::walls::walls;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::vertex::{FoundIn, Tip, Vertex};
use crate::units::{MmPoint, MmRect};

/// How many lines that stand on one another are followed; following a cycle of such lines stops there too.
pub(crate) const HIGHEST_STACK: usize = 8;
/// A straight line on which so many others end is the axis of a chart or a wall: it goes before all others but what
/// a person drew or named.
const AXIS: usize = 4;
/// An axis is at least this share of the drawing's width or height, and no farther off level or upright, and off the
/// end of the other one, mm. Chosen by us.
const ALONG: f32 = 0.5;
const OFF: f32 = 1.0;
/// A line is straight if the distance of its ends is at least this share of its length.
const STRAIGHT: f32 = 0.99;
/// A base is more salient than what stands on it by this share.
const MORE: f32 = 1e-4;

/// The saliency of each line, raised for those of a drawing to at least that of the lines that end on it; axes and
/// walls get their rank.
pub(super) fn raised(
    saliencies: &[f32],
    lines: &mut [(Polyline<Vertex>, Rank)],
    area: MmRect,
    params: &Params,
) -> Vec<f32> {
    let mut all = saliencies.to_vec();
    let on_bases = lines_on_bases(lines, area, params);
    if params.of_drawing {
        for number in axes(lines, &on_bases).into_iter().chain(walls(lines, params)) {
            lines[number].1 = lines[number].1.max(Rank::Axis);
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

/// The straight lines that are axes of a chart or walls: those on which many others end, and two that make a corner, a
/// level and an upright one along much of the drawing. Their ticks may be too short for lines.
fn axes(lines: &[(Polyline<Vertex>, Rank)], on_bases: &[(usize, usize)]) -> BTreeSet<usize> {
    let mut count = vec![0; lines.len()];
    on_bases.iter().for_each(|&(_, base)| count[base] += 1);
    let extent = MmRect::from_points(lines.iter().flat_map(|(line, _)| line.path().map(|vertex| vertex.at)));
    let ends_of = |number: usize| {
        let (line, rank) = &lines[number];
        let is_straight = !line.closed && line.chord() >= STRAIGHT * line.length() && *rank != Rank::Faint;
        let ends = line.vertices.first().zip(line.vertices.last()).filter(|_| is_straight);
        ends.map(|(first, last)| [first.at, last.at])
    };
    let straight: Vec<(usize, [MmPoint; 2])> =
        (0..lines.len()).filter_map(|number| Some((number, ends_of(number)?))).collect();
    let along = |ends: &[MmPoint; 2]| (ends[1] - ends[0]).abs();
    let is_level = |ends: &[MmPoint; 2]| along(ends).x >= ALONG * extent.width() && along(ends).y <= OFF;
    let is_upright = |ends: &[MmPoint; 2]| along(ends).y >= ALONG * extent.height() && along(ends).x <= OFF;
    let meet = |a: &[MmPoint; 2], b: &[MmPoint; 2]| a.iter().any(|a| b.iter().any(|b| (*a - *b).length() <= OFF));
    let mut axes: BTreeSet<usize> =
        straight.iter().map(|(number, _)| *number).filter(|number| count[*number] >= AXIS).collect();
    for (level, of_level) in straight.iter().filter(|(_, ends)| is_level(ends)) {
        for (upright, _) in straight.iter().filter(|(_, ends)| is_upright(ends) && meet(ends, of_level)) {
            axes.extend([*level, *upright]);
        }
    }
    axes
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
