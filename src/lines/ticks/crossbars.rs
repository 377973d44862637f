//! Short strokes across the end of a line, as the plates of a battery or the bars of a dimension line. A line that only
//! ends there is felt as torn, so they are drawn longer where there is room, like ticks: those that belong together by
//! the same length, so that a longer plate stays longer.

use super::found::{ACROSS, STEEP, Tick, is_straight, ticks};
use super::{TickGroup, in_order, others};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmRect, MmVector};

/// A stroke shorter than this share of the least length of a line is a crumb.
const SHORTEST: f32 = 0.4;
/// Strokes across ends that are longer than so many least lengths are lines by themselves.
const LONGEST: f32 = 3.0;
/// Strokes across ends belong together if they are parallel (the cosine) and no farther apart than this, in distances
/// of two lines: the plates of a battery.
const PARALLEL: f32 = 0.98;
const TOGETHER: f32 = 3.0;
/// The end of a line lies no farther from the stroke across it than this, mm.
const TOUCHES: f32 = 0.5;

/// Makes the strokes across ends that are too short for a line longer, where there is room for it.
pub(in crate::lines) fn lengthen(polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) {
    let bars = crossbars(polylines, area, params);
    let mut done = vec![false; bars.len()];
    for first in 0..bars.len() {
        if done[first] || bars[first].length >= params.sure_length() {
            continue;
        }
        let place = |bar: &Tick| middle_and_way(&polylines[bar.number]);
        let Some((middle, way)) = place(&bars[first]) else { continue };
        let belongs = |bar: &Tick| {
            place(bar).is_some_and(|(at, along)| {
                along.dot(way).abs() >= PARALLEL && (at - middle).length() <= TOGETHER * params.max_spacing()
            })
        };
        let group: Vec<usize> = (0..bars.len()).filter(|&other| belongs(&bars[other])).collect();
        group.iter().for_each(|&other| done[other] = true);
        let group: Vec<&Tick> = group.into_iter().map(|other| &bars[other]).collect();
        let ticks: Vec<&Tick> = in_order(&group, polylines).into_iter().map(|(bar, _)| bar).collect();
        let own = ticks.iter().flat_map(|bar| [bar.number, bar.base]).collect();
        let others = others(polylines, &own, area, params);
        let spared = vec![false; ticks.len()];
        // all or none: a longer one that stays as it is may become the shorter one
        let group = TickGroup { spared, ticks, others: &others, sides: &[None], may_lack: false };
        group.lengthen(polylines, area, params);
    }
}

/// All strokes across ends of lines, the ticks of scales apart.
fn crossbars(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Tick> {
    let lengths = SHORTEST * params.min_length..LONGEST * params.min_length;
    let is_bar = |line: &Polyline<Vertex>| is_straight(line) && lengths.contains(&line.length());
    let numbers: Vec<usize> = (0..polylines.len()).filter(|&number| is_bar(&polylines[number])).collect();
    if numbers.iter().all(|&number| polylines[number].length() >= params.sure_length()) {
        return Vec::new();
    }
    let of_scales = ticks(polylines, area, params);
    let stem = |number: usize| {
        let (middle, way) = middle_and_way(&polylines[number])?;
        let length = polylines[number].length();
        let reach = (ACROSS * length).max(TOUCHES);
        let ends_at = |line: &Polyline<Vertex>| {
            let vertices = &line.vertices;
            let (Some(first), Some(last)) = (vertices.first(), vertices.last()) else { return false };
            let inner = |end: &Vertex| vertices.iter().find(|at| (at.at - end.at).length() >= TOUCHES);
            let inner_of_last = || vertices.iter().rev().find(|at| (at.at - last.at).length() >= TOUCHES);
            let leads = |end: &Vertex, inner: Option<&Vertex>| {
                let steep = inner.and_then(|inner| (end.at - inner.at).try_normalize());
                (end.at - middle).length() <= reach && steep.is_some_and(|heading| heading.dot(way).abs() <= STEEP)
            };
            leads(first, inner(first)) || leads(last, inner_of_last())
        };
        let passes = |line: &Polyline<Vertex>| {
            let nearest = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(middle, a.at, b.at).0;
            line.segments().any(|segment| nearest(segment) <= reach)
        };
        let others = || polylines.iter().enumerate().filter(|(other, _)| *other != number);
        let mut near = others().filter(|(_, line)| passes(line));
        let (base, line) = near.next()?;
        let is_only = near.next().is_none() && !line.closed && ends_at(line) && line.length() >= params.min_length;
        let is_tick = of_scales.iter().filter(|tick| tick.base == base).count() > 1;
        (is_only && !is_tick).then_some(Tick { number, base, axis: base, length, stands: [None, None] })
    };
    numbers.into_iter().filter_map(stem).collect()
}

/// The middle of a straight line, and which way it runs.
fn middle_and_way(line: &Polyline<Vertex>) -> Option<(MmPoint, MmVector)> {
    let (first, last) = (line.vertices.first()?.at, line.vertices.last()?.at);
    Some((first.lerp(last, 0.5), (last - first).try_normalize()?))
}

#[cfg(test)]
mod tests;
