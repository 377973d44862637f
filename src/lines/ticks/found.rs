//! Which strokes are ticks: short straight ones that stand on a long line or go across it, and those of a round scale
//! that end before it.

use std::collections::BTreeSet;

use super::bases;
use super::before::{StrokeBefore, are_ticks};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::{Tip, Vertex, nearby};
use crate::units::{MmPoint, MmRect};

/// The shortest tick, mm: what is shorter may be a crumb. Half a millimetre is more than two pixels.
pub(crate) const SHORTEST_TICK: f32 = 0.5;
/// Ticks are shorter than so many least lengths of a line; what stands on a line and is longer is a line of its own.
pub(crate) const LONGEST_TICK: f32 = 2.0;
/// The end of a tick lies so near to the line that it stands on, mm: it ends at the side of a broad one, or a little
/// inside of the ring of a clock. Of those that end farther off see [`before`](super::before).
const STANDS: f32 = 2.5;
/// A tick goes across a line that is so near to its middle, as a share of its length.
pub(super) const ACROSS: f32 = 0.15;
/// A tick is straight: its chord is at least this share of it.
const STRAIGHT: f32 = 0.98;
/// A tick is steep: the cosine between it and its line is at most this (60 degrees between them).
pub(super) const STEEP: f32 = 0.5;
/// So many ticks on a line that are too short are a scale.
pub(super) const SCALE: usize = 3;

/// A tick, which may be too short for a line.
pub(super) struct Tick {
    /// Its line among all.
    pub(super) number: usize,
    /// The line that it belongs to.
    pub(super) base: usize,
    /// The first piece of that line, where it is in pieces.
    pub(super) axis: usize,
    pub(super) length: f32,
    /// Of its first and its last end: how far it is from its line where it stands on that, mm; none of a free end.
    pub(super) stands: [Option<f32>; 2],
}

impl Tick {
    /// The end with which it stands on its line, and how far that is from the line, mm; none of one that goes across.
    pub(super) fn foot(&self) -> Option<(Tip, f32)> {
        match self.stands {
            [Some(gap), None] => Some((Tip::First, gap)),
            [None, Some(gap)] => Some((Tip::Last, gap)),
            _ => None,
        }
    }
}

/// All ticks, where enough of them are too short for a line.
pub(super) fn ticks(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Tick> {
    let is_tick = |line: &Polyline<Vertex>| {
        (SHORTEST_TICK..LONGEST_TICK * params.min_length).contains(&line.length()) && is_straight(line)
    };
    let straight: Vec<usize> = (0..polylines.len()).filter(|&i| is_tick(&polylines[i])).collect();
    if straight.iter().filter(|&&i| polylines[i].length() < params.min_length).count() < SCALE {
        return Vec::new();
    }
    let is_long = |line: &Polyline<Vertex>| line.length() >= LONGEST_TICK * params.min_length;
    let are_long = polylines.iter().map(is_long).collect();
    let lines = Bases { polylines, segments: nearby(polylines.iter(), area, params), are_long };
    let on_line = |&number: &usize| lines.crossed_by(number).or_else(|| Some(lines.below(number, STANDS)?.0));
    let mut ticks: Vec<Tick> = straight.iter().filter_map(on_line).collect();
    let before = lines.before(&straight, &ticks, params);
    // what stands alone on the line of such a scale is no tick of it, as a pointer on the rim of a dial
    let of_scale: BTreeSet<usize> = before.iter().flat_map(|tick| [tick.base, tick.number]).collect();
    ticks.retain(|tick| !of_scale.contains(&tick.base) && !of_scale.contains(&tick.number));
    ticks.extend(before);
    let straight = ticks.iter().map(|tick| tick.base).filter(|base| is_straight(&polylines[*base]));
    let first = bases::first_pieces(straight, polylines, area);
    ticks.iter_mut().for_each(|tick| tick.axis = first.get(&tick.base).copied().unwrap_or(tick.base));
    ticks
}

/// The lines that ticks may stand on, among all.
struct Bases<'a> {
    polylines: &'a [Polyline<Vertex>],
    segments: Nearby,
    /// Which of them are long enough.
    are_long: Vec<bool>,
}

impl Bases<'_> {
    /// The nearest segment of a long line that is steep to a stroke, within reach of a place: how far it is, and where
    /// on it.
    fn near(&self, stroke: &Polyline<Vertex>, at: MmPoint, reach: f32) -> Option<(f32, MmPoint, Segment)> {
        let along = (stroke.vertices.last()?.at - stroke.vertices.first()?.at).try_normalize()?;
        // at the corner of two axes it stands on one of them
        let is_steep =
            |segment: &Segment| (segment.b - segment.a).try_normalize().is_some_and(|b| b.dot(along).abs() <= STEEP);
        self.segments.nearest(at, reach, |segment| self.are_long[segment.line as usize] && is_steep(segment))
    }

    /// A stroke as a tick that goes across a line.
    fn crossed_by(&self, number: usize) -> Option<Tick> {
        let line = &self.polylines[number];
        let (middle, length) = (line.vertices.first()?.at.lerp(line.vertices.last()?.at, 0.5), line.length());
        let base = self.near(line, middle, ACROSS * length)?.2.line as usize;
        Some(Tick { number, base, axis: base, length, stands: [None, None] })
    }

    /// A stroke as a tick that stands on a line with one of its ends, which is within reach of it, and not between two
    /// lines; and where.
    fn below(&self, number: usize, reach: f32) -> Option<(Tick, StrokeBefore)> {
        let line = &self.polylines[number];
        let near = |which: Tip| self.near(line, which.of(line)?.at, reach);
        let (which, (gap, foot, segment)) = match (near(Tip::First), near(Tip::Last)) {
            // of a short one both ends are near: it stands with the nearer one
            (Some(first), Some(last)) if first.2.line == last.2.line && first.0 < last.0 => (Tip::First, first),
            (Some(first), Some(last)) if first.2.line == last.2.line => (Tip::Last, last),
            (Some(first), None) => (Tip::First, first),
            (None, Some(last)) => (Tip::Last, last),
            _ => return None,
        };
        let base = segment.line as usize;
        let stands = Tip::BOTH.map(|end| (end == which).then_some(gap));
        let arc = segment.arc + (foot - segment.a).length();
        let way = (which.other().of(line)?.at - which.of(line)?.at).try_normalize()?;
        let tick = Tick { number, base, axis: base, length: line.length() + gap, stands };
        Some((tick, StrokeBefore { base, gap, foot, arc, way }))
    }

    /// Those of these strokes that are ticks which end before a line, where the `others` on it are no scale by
    /// themselves (these may be among them): so near to it that there is no room for the stroke and the line as two.
    fn before(&self, strokes: &[usize], others: &[Tick], params: &Params) -> Vec<Tick> {
        let mut ticks_on = vec![0; self.polylines.len()];
        others.iter().for_each(|tick| ticks_on[tick.base] += 1);
        let of_scales = others.iter().filter(|tick| ticks_on[tick.base] >= SCALE);
        let of_scales: BTreeSet<usize> = of_scales.map(|tick| tick.number).collect();
        let rest = strokes.iter().filter(|number| !of_scales.contains(*number));
        let before = rest.filter_map(|&number| self.below(number, params.max_clearance()));
        let before: Vec<(Tick, StrokeBefore)> = before.filter(|(tick, _)| ticks_on[tick.base] < SCALE).collect();
        let places: Vec<StrokeBefore> = before.iter().map(|(_, place)| *place).collect();
        before.into_iter().zip(are_ticks(&places)).filter(|(_, is_tick)| *is_tick).map(|((tick, _), _)| tick).collect()
    }
}

/// Whether a line is straight enough for a tick, or an axis.
pub(in crate::lines) fn is_straight(line: &Polyline<Vertex>) -> bool {
    !line.closed && line.chord() >= STRAIGHT * line.length()
}
