//! Ticks of a scale, as of an axis, a ruler or a clock, that are shorter than the least line. They are meant all
//! together: where all of a scale have room, but for one at either end, they are drawn longer, and otherwise none is.

pub(super) mod alone;
mod bases;
pub(super) mod crossbars;

use bases::Half;

use super::lead_on::{extend_to, heading};
use super::marks::TickMark;
use super::params::Params;
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Segment;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect};

/// The shortest tick, mm: what is shorter may be a crumb. Half a millimetre is more than two pixels.
const SHORTEST: f32 = 0.5;
/// The end of a tick lies so near to the line that it stands on, mm: it ends at the side of a broad one, or a little
/// inside of the ring of a clock, nearer than two lines may be apart.
const STANDS: f32 = 2.5;
/// A tick goes across a line that is so near to its middle, as a share of its length.
const ACROSS: f32 = 0.15;
/// A tick is straight: its chord is at least this share of it.
const STRAIGHT: f32 = 0.98;
/// A tick is steep: the cosine between it and its line is at most this (60 degrees between them).
const STEEP: f32 = 0.5;
/// A longer tick is longer by this than a line has to be, mm: its end is put on its line, which may be moved.
const MARGIN: f32 = 0.2;
/// So many ticks on a line that are too short are a scale.
const SCALE: usize = 3;
/// Ticks are shorter than so many least lengths of a line; what stands on a line and is longer is a line of its own.
const LONGEST: f32 = 2.0;
/// A tick is at least this share of the longest one of its scale: the short ticks of rulers and clocks are a third or
/// more of the long ones, and what is shorter is a crumb.
const OF_LONGEST: f32 = 0.25;

/// A tick, which may be too short for a line.
struct Tick {
    /// Its line among all.
    number: usize,
    /// The line that it belongs to.
    base: usize,
    /// The first piece of that line, where it is in pieces.
    axis: usize,
    length: f32,
    /// Of its first and its last end: how far it is from its line where it stands on that, mm; none of a free end.
    stands: [Option<f32>; 2],
}

/// Makes the ticks of those scales longer that have room for it: all of a scale by the same length, so that longer ones
/// stay longer, and the shortest is as long as a line has to be.
pub(super) fn lengthen(polylines: &mut Vec<Polyline<Vertex>>, area: MmRect, params: &Params) {
    let mut ticks = ticks(polylines, area, params);
    let half = |tick: &Tick| match tick.stands {
        [Some(gap), None] => Some(Half { line: tick.number, foot: Tip::First, gap }),
        [None, Some(gap)] => Some(Half { line: tick.number, foot: Tip::Last, gap }),
        _ => None,
    };
    if bases::join_halves(&ticks.iter().filter_map(half).collect::<Vec<_>>(), polylines, area) {
        polylines.retain(|line| !line.vertices.is_empty());
        ticks = self::ticks(polylines, area, params);
    }
    ticks.sort_by_key(|tick| tick.axis);
    for on_axis in ticks.chunk_by(|a, b| a.axis == b.axis) {
        let Some(scale) = scale(on_axis, polylines, params) else { continue };
        lengthen_together(&scale, polylines, area, params);
    }
}

/// Makes ticks longer by the same length, so that the shortest is as long as a line has to be, if all have room, or all
/// but the first or the last.
fn lengthen_together(group: &[&Tick], polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) {
    let shortest = group.iter().map(|tick| tick.length).fold(f32::INFINITY, f32::min);
    let more = params.min_length + MARGIN - shortest;
    let longer = |group: &[&Tick]| -> Vec<Polyline<Vertex>> {
        group.iter().map(|tick| tick.longer(&polylines[tick.number], more)).collect()
    };
    let has_room = |group: &[&Tick]| have_room(&longer(group), group, polylines, area, params);
    let all = in_order(group, polylines);
    // at its ends an arrowhead or another axis may be in the way of one
    let ends = |first: usize, last: usize| all.get(first..all.len().saturating_sub(last)).unwrap_or_default();
    let is_round = group.iter().any(|tick| polylines[tick.base].closed);
    let parts = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(first, last)| ends(first, last));
    let mut parts = parts.into_iter().take(if is_round { 1 } else { 4 });
    if let Some(part) = parts.find(|part| (part.len() == all.len() || part.len() >= SCALE) && has_room(part)) {
        let longer = longer(part);
        for (tick, longer) in part.iter().zip(longer) {
            polylines[tick.number] = longer;
        }
    }
}

/// The ticks of an axis in the order in which they stand on it; those of a ring, which have no ends, as they come.
fn in_order<'t>(scale: &[&'t Tick], polylines: &[Polyline<Vertex>]) -> Vec<&'t Tick> {
    let mut scale = scale.to_vec();
    let way = |line: &Polyline<Vertex>| Some(line.vertices.last()?.at - line.vertices.first()?.at);
    let axis = scale.first().and_then(|tick| way(&polylines[tick.base]));
    if let Some(axis) = axis {
        let along = |tick: &Tick| polylines[tick.number].vertices.first().map_or(0.0, |v| v.at.to_vector().dot(axis));
        scale.sort_by(|a, b| along(a).total_cmp(&along(b)));
    }
    scale
}

/// Takes the ticks of scales out of the contours of a drawing, to be drawn where its lines become dots: those of each
/// scale in order along its line.
pub(super) fn take(polylines: &mut Vec<Polyline<Vertex>>, area: MmRect, params: &Params) -> Vec<Vec<TickMark>> {
    let mut ticks = ticks(polylines, area, params);
    if ticks.is_empty() {
        return Vec::new();
    }
    let all = nearby(polylines.iter(), area, params);
    // what leads on to another line is a side of something
    ticks.retain(|tick| {
        let is_other = |line: u32| line as usize != tick.number && line as usize != tick.base;
        let line = &polylines[tick.number].vertices;
        let ends = [line.first(), line.last()].into_iter().zip(tick.stands).filter(|(_, stands)| stands.is_none());
        ends.filter_map(|(end, _)| end).all(|end| all.nearest(end.at, FREE, |segment| is_other(segment.line)).is_none())
    });
    ticks.sort_by_key(|tick| tick.base);
    let mut taken = vec![false; polylines.len()];
    let mut scales = Vec::new();
    for on_line in ticks.chunk_by(|a, b| a.base == b.base) {
        let Some(scale) = scale(on_line, polylines, params) else { continue };
        let mut marks: Vec<(f32, TickMark)> = scale.iter().filter_map(|tick| mark(tick, polylines)).collect();
        scale.iter().for_each(|tick| taken[tick.number] = true);
        marks.sort_by(|a, b| a.0.total_cmp(&b.0));
        scales.push(whole(marks));
    }
    let mut number = 0;
    polylines.retain(|_| {
        number += 1;
        !taken[number - 1]
    });
    scales
}

/// The end of a tick is free if no other line is so near, mm.
const FREE: f32 = 1.0;
/// Two ticks so near to one another, mm, on two sides of a line are one.
const ONE: f32 = 1.0;

/// The ticks of a line that are a scale, if they are one.
fn scale<'a>(on_line: &'a [Tick], polylines: &[Polyline<Vertex>], params: &Params) -> Option<Vec<&'a Tick>> {
    let longest = on_line.iter().map(|tick| tick.length).fold(0.0, f32::max);
    let scale: Vec<&Tick> = on_line.iter().filter(|tick| tick.length >= OF_LONGEST * longest).collect();
    let short = scale.iter().filter(|tick| polylines[tick.number].length() < params.min_length).count();
    (short >= SCALE).then_some(scale)
}

/// A tick as it is handed on, and how far along its line it is, mm.
fn mark(tick: &Tick, polylines: &[Polyline<Vertex>]) -> Option<(f32, TickMark)> {
    let (line, base) = (&polylines[tick.number], &polylines[tick.base]);
    let ends = [line.vertices.first()?.at, line.vertices.last()?.at];
    let standing = ends.iter().zip(tick.stands).find(|(_, gap)| gap.is_some()).map(|(end, _)| *end);
    let middle = standing.unwrap_or_else(|| ends[0].lerp(ends[1], 0.5));
    let distance = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(middle, a.at, b.at);
    let nearest = base.segments().map(distance).enumerate().min_by(|a, b| a.1.0.total_cmp(&b.1.0));
    let (number, (_, at)) = nearest?;
    let (from, to) = base.segments().nth(number)?;
    let along = (to.at - from.at).try_normalize()?;
    let mut mark = TickMark { at, along, ends: [None, None] };
    for (end, _) in ends.into_iter().zip(tick.stands).filter(|(_, gap)| gap.is_none()) {
        let side = usize::from(along.cross(end - at) > 0.0);
        mark.ends[side] = Some(end);
    }
    let arc = base.arc_lengths().get(number).copied().unwrap_or(0.0) + (at - from.at).length();
    mark.ends.iter().any(Option::is_some).then_some((arc, mark))
}

/// Ticks in order, those that a point on their line parts as one.
fn whole(marks: Vec<(f32, TickMark)>) -> Vec<TickMark> {
    let mut all: Vec<TickMark> = Vec::with_capacity(marks.len());
    for (_, mark) in marks {
        match all.last_mut().filter(|last| (last.at - mark.at).length() < ONE) {
            Some(last) if (0..2).all(|side| last.ends[side].is_none() || mark.ends[side].is_none()) => {
                (0..2).for_each(|side| last.ends[side] = last.ends[side].or(mark.ends[side]));
            }
            _ => all.push(mark),
        }
    }
    all
}

/// All ticks, where enough of them are too short for a line.
fn ticks(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Tick> {
    let is_tick =
        |line: &Polyline<Vertex>| (SHORTEST..LONGEST * params.min_length).contains(&line.length()) && is_straight(line);
    let straight: Vec<usize> = (0..polylines.len()).filter(|&i| is_tick(&polylines[i])).collect();
    if straight.iter().filter(|&&i| polylines[i].length() < params.min_length).count() < SCALE {
        return Vec::new();
    }
    let segments = nearby(polylines.iter(), area, params);
    let is_long = |line: u32| polylines[line as usize].length() >= LONGEST * params.min_length;
    let tick = |number: usize| -> Option<Tick> {
        let line = &polylines[number];
        let (first, last) = (line.vertices.first()?.at, line.vertices.last()?.at);
        let along = (last - first).try_normalize()?;
        let length = line.length();
        let base = |at: MmPoint, reach: f32| -> Option<(f32, usize)> {
            // at the corner of two axes it stands on one of them
            let is_steep = |segment: &Segment| {
                (segment.b - segment.a).try_normalize().is_some_and(|base| base.dot(along).abs() <= STEEP)
            };
            let wanted = |segment: &Segment| is_long(segment.line) && is_steep(segment);
            let (distance, _, segment) = segments.nearest(at, reach, wanted)?;
            Some((distance, segment.line as usize))
        };
        if let Some((_, base)) = base(first.lerp(last, 0.5), ACROSS * length) {
            return Some(Tick { number, base, axis: base, length, stands: [None, None] });
        }
        let ends = match (base(first, STANDS), base(last, STANDS)) {
            // of a short one both ends are near: it stands with the nearer one
            (Some(near), Some(far)) if near.1 == far.1 => {
                if near.0 < far.0 {
                    (Some(near), None)
                } else {
                    (None, Some(far))
                }
            }
            ends => ends,
        };
        match ends {
            (Some((gap, base)), None) => {
                Some(Tick { number, base, axis: base, length: length + gap, stands: [Some(gap), None] })
            }
            (None, Some((gap, base))) => {
                Some(Tick { number, base, axis: base, length: length + gap, stands: [None, Some(gap)] })
            }
            _ => None,
        }
    };
    let mut ticks: Vec<Tick> = straight.into_iter().filter_map(tick).collect();
    let straight = ticks.iter().map(|tick| tick.base).filter(|base| is_straight(&polylines[*base]));
    let first = bases::first_pieces(straight, polylines, area);
    ticks.iter_mut().for_each(|tick| tick.axis = first.get(&tick.base).copied().unwrap_or(tick.base));
    ticks
}

fn is_straight(line: &Polyline<Vertex>) -> bool {
    !line.closed && line.chord() >= STRAIGHT * line.length()
}

impl Tick {
    /// Its line, longer by so much, mm, at its free ends, and standing on the line that it belongs to.
    fn longer(&self, line: &Polyline<Vertex>, more: f32) -> Polyline<Vertex> {
        let each = more / self.stands.iter().filter(|gap| gap.is_none()).count().max(1) as f32;
        longer(line, self.stands.map(|gap| gap.unwrap_or(each)))
    }
}

/// A straight line that is longer by so much, mm, at its first and at its last end.
fn longer(line: &Polyline<Vertex>, by: [f32; 2]) -> Polyline<Vertex> {
    let (mut line, length) = (line.clone(), line.length());
    for (which, by) in Tip::BOTH.into_iter().zip(by) {
        let tip = which.of(&line).map(|tip| tip.at);
        let (Some(tip), Some(heading)) = (tip, heading(&line, which, length)) else { continue };
        extend_to(&mut line, which, tip + heading * by);
    }
    line
}

/// Whether longer ticks are apart from one another and from all lines but their own.
fn have_room(
    longer: &[Polyline<Vertex>],
    scale: &[&Tick],
    polylines: &[Polyline<Vertex>],
    area: MmRect,
    params: &Params,
) -> bool {
    let clearance = params.max_clearance();
    let ticks = nearby(longer.iter(), area, params);
    let is_apart = |(number, line): (usize, &Polyline<Vertex>)| {
        line.vertices.iter().all(|vertex| {
            ticks.nearest(vertex.at, clearance, |segment| segment.line as usize != number).is_none()
                && area.contains(vertex.at)
        })
    };
    if !longer.iter().enumerate().all(is_apart) {
        return false;
    }
    let is_own = |line: usize| scale.iter().any(|tick| tick.number == line || tick.base == line);
    // what crosses the scale, as its own axis, and crumbs that are not drawn
    let others =
        polylines.iter().enumerate().filter(|(line, other)| !is_own(*line) && other.length() >= params.min_length);
    let others: Vec<&Polyline<Vertex>> = others.map(|(_, other)| other).collect();
    let others = nearby(others.into_iter(), area, params);
    longer.iter().flat_map(|line| &line.vertices).all(|vertex| {
        let mut free = true;
        others.around_point(vertex.at, clearance, |segment| {
            free &= nearest_on_segment(vertex.at, segment.a, segment.b).0 >= clearance;
        });
        free
    })
}

#[cfg(test)]
mod tests;
