//! Ticks of a scale, as of an axis, a ruler or a clock, that are shorter than the least line. They are meant all
//! together: where all of a scale have room, but for a few, they are drawn longer; where they are too near to one
//! another every so many-th is; and otherwise none.

pub(super) mod alone;
mod bases;
mod before;
pub(super) mod crossbars;
pub(super) mod found;
pub(super) mod selections;
pub(super) mod spurs;

use std::collections::BTreeSet;

use bases::Half;
use found::{SCALE, Tick, is_straight, ticks};
use selections::{EVEN, MOST_BLOCKED, tick_selections};

use super::lead_on::{extend_to, heading};
use super::lost::LostScale;
use super::marks::TickMark;
use super::params::Params;
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Nearby;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, MmVector};

/// A longer tick is longer by this than [`Params::sure_length`], mm: its end is put on its line, which may be moved.
const MARGIN: f32 = 0.2;
/// A tick is at least this share of the longest one of its scale: the short ticks of rulers and clocks are a third or
/// more of the long ones, and what is shorter is a crumb.
const OF_LONGEST: f32 = 0.25;
/// Ticks stand on one straight side of a line that runs one way there (the cosine: 2.5 degrees; the ticks of a clock
/// differ by more), so near to one straight line, mm.
const ONE_WAY: f32 = 0.999;
const ON_SIDE: f32 = 1.0;
/// A point so near to where a tick crosses its line, mm, is at that place.
const AT_POINT: f32 = 1.0;

/// Ticks of a scale are as long as one another if they differ by no more than this share.
const AS_LONG: f32 = 0.1;

/// What is left out of a scale whose ticks are too near to one another for fingers.
pub(super) struct ThinnedScale {
    /// Its ticks that are not drawn.
    pub(super) left_out: Vec<TickMark>,
    /// What is told of them.
    pub(super) lost: LostScale,
}

/// Which lines are ticks of scales for certain: too short for lines, so many of one length on one line, on which each
/// stands with one end while the other leads to nothing.
pub(super) fn of_scales(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<bool> {
    let mut are_ticks = vec![false; polylines.len()];
    let mut ticks = ticks(polylines, area, params);
    ticks.retain(|tick| tick.foot().is_some() && polylines[tick.number].length() < params.min_length);
    if ticks.len() < SCALE {
        return are_ticks;
    }
    let all = nearby(polylines.iter(), area, params);
    ticks.retain(|tick| {
        let tip = tick.foot().and_then(|(foot, _)| foot.other().of(&polylines[tick.number]));
        let is_other = |line: u32| line as usize != tick.number && line as usize != tick.base;
        tip.is_some_and(|tip| all.nearest(tip.at, FREE, |segment| is_other(segment.line)).is_none())
    });
    for tick in &ticks {
        let is_like = |other: &&Tick| {
            let apart = (other.length - tick.length).abs();
            other.axis == tick.axis && apart <= AS_LONG * other.length.max(tick.length)
        };
        are_ticks[tick.number] = ticks.iter().filter(is_like).take(SCALE).count() == SCALE;
    }
    are_ticks
}

/// Makes the ticks of scales longer where there is room for it: all of a scale by the same length, so that longer ones
/// stay longer, and the shortest is as long as a line has to be. Where they are too near to one another, every so
/// many-th stays, and the others are taken out. `points` are those on lines: they say by themselves where their tick
/// would be.
pub(super) fn lengthen(
    polylines: &mut Vec<Polyline<Vertex>>,
    points: &[MmPoint],
    area: MmRect,
    params: &Params,
) -> Vec<ThinnedScale> {
    let mut ticks = ticks(polylines, area, params);
    let half = |tick: &Tick| tick.foot().map(|(foot, gap)| Half { line: tick.number, foot, gap });
    if bases::join_halves(&ticks.iter().filter_map(half).collect::<Vec<_>>(), polylines, area) {
        polylines.retain(|line| !line.vertices.is_empty());
        ticks = self::ticks(polylines, area, params);
    }
    ticks.sort_by_key(|tick| tick.axis);
    let mut taken = vec![false; polylines.len()];
    let mut thinned = Vec::new();
    for on_axis in ticks.chunk_by(|a, b| a.axis == b.axis) {
        let Some(scale) = scale(on_axis, polylines, params) else { continue };
        let scale = in_order(&scale, polylines);
        let parts = match lengthen_scale(&scale, points, polylines, area, params) {
            Some(drawn) => vec![(scale, drawn)],
            None => sides(&scale)
                .into_iter()
                .filter_map(|side| {
                    let drawn = lengthen_scale(&side, points, polylines, area, params)?;
                    Some((side, drawn))
                })
                .collect(),
        };
        for (scale, (every, drawn)) in parts {
            let left_out = || scale.iter().enumerate().filter(|(member, _)| !drawn.contains(member)).map(|(_, of)| of);
            let Some((_, first)) = left_out().next() else { continue };
            left_out().for_each(|(tick, _)| taken[tick.number] = true);
            let left_out: Vec<TickMark> = left_out().map(|(_, mark)| *mark).collect();
            let lost = LostScale { ticks: scale.len(), lost: left_out.len(), every, first: first.at };
            thinned.push(ThinnedScale { left_out, lost });
        }
    }
    without(polylines, &taken);
    thinned
}

/// The ticks on each straight side of a line, as of the frame of a plot, where they are scales by themselves, in order.
fn sides<'t>(scale: &[(&'t Tick, TickMark)]) -> Vec<Vec<(&'t Tick, TickMark)>> {
    let mut sides: Vec<Vec<(&'t Tick, TickMark)>> = Vec::new();
    for &(tick, mark) in scale {
        let is_on = |side: &Vec<(&Tick, TickMark)>| {
            let TickMark { at, along, .. } = side[0].1;
            along.dot(mark.along).abs() >= ONE_WAY && along.cross(mark.at - at).abs() <= ON_SIDE
        };
        match sides.iter_mut().find(|side| is_on(side)) {
            Some(side) => side.push((tick, mark)),
            None => sides.push(vec![(tick, mark)]),
        }
    }
    sides.retain(|side| (SCALE..scale.len()).contains(&side.len()));
    for side in &mut sides {
        let along = side[0].1.along;
        side.sort_by(|a, b| along.dot(a.1.at.to_vector()).total_cmp(&along.dot(b.1.at.to_vector())));
    }
    sides
}

/// Lines without those that are taken.
fn without(polylines: &mut Vec<Polyline<Vertex>>, taken: &[bool]) {
    let mut taken = taken.iter();
    polylines.retain(|_| taken.next() == Some(&false));
}

/// Makes the ticks of a scale longer, or every so many-th: the first of these selections that has room. Gives the step
/// from one to the next, and which ticks those are.
fn lengthen_scale(
    scale: &[(&Tick, TickMark)],
    points: &[MmPoint],
    polylines: &mut [Polyline<Vertex>],
    area: MmRect,
    params: &Params,
) -> Option<(usize, Vec<usize>)> {
    let marks: Vec<TickMark> = scale.iter().map(|(_, mark)| *mark).collect();
    let own = scale.iter().flat_map(|(tick, _)| [tick.number, tick.base]).collect();
    let others = others(polylines, &own, area, params);
    let is_spared = |mark: &TickMark| points.iter().any(|point| (*point - mark.at).length() <= AT_POINT);
    // beside a straight line they may also grow to one side of it only
    let aside = scale.first().filter(|(tick, _)| is_straight(&polylines[tick.base])).map(|(_, mark)| mark.along);
    let aside = aside.map(|along| MmVector::new(-along.y, along.x));
    let sides: Vec<Option<MmVector>> =
        [None].into_iter().chain(aside.map(Some)).chain(aside.map(|way| Some(-way))).collect();
    let group = |members: &[usize]| TickGroup {
        ticks: members.iter().map(|&member| scale[member].0).collect(),
        spared: members.iter().map(|&member| is_spared(&marks[member])).collect(),
        others: &others,
        sides: &sides,
        may_lack: true,
    };
    let mut selections = tick_selections(&marks);
    let all = group(&(0..scale.len()).collect::<Vec<_>>()).longer(None, polylines, params);
    // fewer have no more room where only other lines are in the way
    if are_apart(&all.iter().collect::<Vec<_>>(), area, params) {
        selections.truncate(1);
    }
    selections.into_iter().find_map(|(every, members)| {
        let drawn = group(&members).lengthen(polylines, area, params)?;
        // of a scale that is drawn as a whole the few without room are told by what they are
        Some((every, if every == 1 { members } else { drawn.into_iter().map(|at| members[at]).collect() }))
    })
}

/// The lines that ticks have to be clear of: all but their `own`, which are all ticks of their scale and what they
/// stand on, and crumbs that are not drawn.
fn others(polylines: &[Polyline<Vertex>], own: &BTreeSet<usize>, area: MmRect, params: &Params) -> Nearby {
    let is_other =
        |(number, line): &(usize, &Polyline<Vertex>)| !own.contains(number) && line.length() >= params.min_length;
    nearby(polylines.iter().enumerate().filter(is_other).map(|(_, line)| line), area, params)
}

/// Ticks that are drawn longer by the same length, or none of them.
struct TickGroup<'t> {
    /// In the order in which they stand on their line.
    ticks: Vec<&'t Tick>,
    /// Which of them may lack room.
    spared: Vec<bool>,
    /// The lines that they have to be clear of ([`others`]).
    others: &'t Nearby,
    /// Where they grow, in the order in which that is tried: to a side of their line, or at all their free ends.
    sides: &'t [Option<MmVector>],
    /// Whether a few others may lack room, too, which stay as they are.
    may_lack: bool,
}

impl TickGroup<'_> {
    /// The ticks, longer by the same length, so that the shortest is as long as a line has to be: to this side of their
    /// line, or at all their free ends.
    fn longer(&self, side: Option<MmVector>, polylines: &[Polyline<Vertex>], params: &Params) -> Vec<Polyline<Vertex>> {
        let shortest = self.ticks.iter().map(|tick| tick.length).fold(f32::INFINITY, f32::min);
        let more = (params.sure_length() + MARGIN - shortest).max(0.0);
        self.ticks.iter().map(|tick| tick.longer(&polylines[tick.number], more, side)).collect()
    }

    /// Draws the ticks longer if they have room, or else all but a few. Gives the places in the group of those that are
    /// on the page then; none if they stay as they are.
    fn lengthen(&self, polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) -> Option<Vec<usize>> {
        let is_open = self.ticks.iter().all(|tick| !polylines[tick.base].closed);
        let ways = [false, true].into_iter().filter(|lacks| self.may_lack || !lacks);
        for (may_lack, side) in ways.flat_map(|may| self.sides.iter().map(move |side| (may, *side))) {
            let longer = self.longer(side, polylines, params);
            let is_free = |(line, tick): (&Polyline<Vertex>, &&Tick)| {
                is_free(line, tick.base_of(&polylines[tick.number]), self.others, area, params)
            };
            let is_free: Vec<bool> = longer.iter().zip(&self.ticks).map(is_free).collect();
            let free =
                || longer.iter().zip(&self.ticks).zip(&is_free).filter(|(_, is_free)| **is_free).map(|(of, _)| of);
            let lines: Vec<&Polyline<Vertex>> = free().map(|(line, _)| line).collect();
            if self.are_enough(&is_free, is_open, may_lack) && are_apart(&lines, area, params) {
                free().for_each(|(line, tick)| polylines[tick.number] = line.clone());
                let is_there = |at: &usize| is_free[*at] || self.is_there_as_it_is(*at, polylines, params);
                return Some((0..is_free.len()).filter(is_there).collect());
            }
        }
        None
    }

    /// Whether a tick is on the page though it has no room to be longer: as a line, as a point at its place, or as
    /// another line that it lies along, such as an axis.
    fn is_there_as_it_is(&self, at: usize, polylines: &[Polyline<Vertex>], params: &Params) -> bool {
        let line = &polylines[self.ticks[at].number];
        let is_along = |vertex: &Vertex| self.others.nearest(vertex.at, AT_POINT, |_| true).is_some();
        self.spared[at] || line.length() >= params.min_length || line.vertices.iter().all(is_along)
    }

    /// Whether enough of the ticks are free: all but those that are spared, and where some may lack room all but the
    /// first and the last on an open line, where an arrowhead or another axis may be in the way, or but a few.
    fn are_enough(&self, is_free: &[bool], is_open: bool, may_lack: bool) -> bool {
        let count = is_free.len();
        let lacking: Vec<usize> = (0..count).filter(|&i| !is_free[i] && !self.spared[i]).collect();
        let free = is_free.iter().filter(|is_free| **is_free).count();
        let is_end = |i: &usize| is_open && (*i == 0 || *i + 1 == count);
        let are_few = lacking.iter().all(is_end) || lacking.len() as f32 <= MOST_BLOCKED * count as f32;
        lacking.is_empty() || (may_lack && are_few && free >= SCALE)
    }
}

/// The ticks of an axis in the order in which they stand on it, each as it is handed on.
fn in_order<'t>(scale: &[&'t Tick], polylines: &[Polyline<Vertex>]) -> Vec<(&'t Tick, TickMark)> {
    let way = |line: &Polyline<Vertex>| Some(line.vertices.last()?.at - line.vertices.first()?.at);
    // an axis in pieces is straight
    let axis = scale.first().map(|tick| &polylines[tick.base]).filter(|base| is_straight(base)).and_then(way);
    let place = |tick: &'t Tick| {
        let (arc, mark) = mark(tick, polylines)?;
        Some((axis.map_or(arc, |axis| mark.at.to_vector().dot(axis)), tick, mark))
    };
    let mut places: Vec<(f32, &'t Tick, TickMark)> = scale.iter().copied().filter_map(place).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    // on a ring, as the tube of a thermometer, they begin after the widest gap; if they go round there is none
    if scale.first().is_some_and(|tick| polylines[tick.base].closed) {
        let count = places.len();
        let gap = |i: usize| (places[i].2.at - places[(i + count - 1) % count].2.at).length();
        let least = (0..count).map(gap).fold(f32::INFINITY, f32::min);
        let first = (0..count).max_by(|&a, &b| gap(a).total_cmp(&gap(b))).filter(|&at| gap(at) > EVEN * least);
        places.rotate_left(first.unwrap_or(0));
    }
    places.into_iter().map(|(_, tick, mark)| (tick, mark)).collect()
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
    without(polylines, &taken);
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

impl Tick {
    /// Where it stands on the line that it belongs to, and which way it leads away from that; none of one that goes
    /// across. `line` is its own.
    fn base_of(&self, line: &Polyline<Vertex>) -> Option<(MmPoint, MmVector)> {
        let (which, gap) = self.foot()?;
        let (foot, end) = (which.of(line)?.at, which.other().of(line)?.at);
        let way = (end - foot).try_normalize()?;
        Some((foot - way * gap, way))
    }

    /// Its line, longer by so much, mm, and standing on the line that it belongs to: at its free ends, or where both
    /// are free at that on one side of its line, if one is given.
    fn longer(&self, line: &Polyline<Vertex>, more: f32, side: Option<MmVector>) -> Polyline<Vertex> {
        let (Some(first), Some(last)) = (line.vertices.first(), line.vertices.last()) else { return line.clone() };
        let way = last.at - first.at;
        let by = match (self.stands, side) {
            ([None, None], Some(side)) if way.dot(side) > 0.0 => [0.0, more],
            ([None, None], Some(_)) => [more, 0.0],
            ([None, None], None) => [0.5 * more; 2],
            (stands, _) => stands.map(|gap| gap.unwrap_or(more)),
        };
        longer(line, by)
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

/// Whether a tick is apart from all these others. Where it stands on its line, and which way it leads away from
/// that, is given, if it does: what is on the other side of its line, as the side of a bar that ends there, is not in
/// its way.
fn is_free(
    tick: &Polyline<Vertex>,
    base: Option<(MmPoint, MmVector)>,
    others: &Nearby,
    area: MmRect,
    params: &Params,
) -> bool {
    let (clearance, half) = (params.max_clearance(), 0.5 * params.width_max);
    // what ends within the line does so from there
    let is_behind = |at: MmPoint| base.is_some_and(|(foot, way)| (at - foot).dot(way) <= half);
    tick.vertices.iter().all(|vertex| {
        let mut free = area.contains(vertex.at);
        others.around_point(vertex.at, clearance, |segment| {
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            free &= distance >= clearance || is_behind(at);
        });
        free
    })
}

/// Whether lines are apart from one another.
fn are_apart(lines: &[&Polyline<Vertex>], area: MmRect, params: &Params) -> bool {
    let (clearance, all) = (params.max_clearance(), nearby(lines.iter().copied(), area, params));
    let is_apart = |(number, line): (usize, &&Polyline<Vertex>)| {
        let is_near =
            |vertex: &Vertex| all.nearest(vertex.at, clearance, |other| other.line as usize != number).is_some();
        !line.vertices.iter().any(is_near)
    };
    lines.iter().enumerate().all(is_apart)
}

#[cfg(test)]
mod tests;
