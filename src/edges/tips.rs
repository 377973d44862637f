//! Ends of strokes that belong together. Near its tip the two sides of a corner are one thick spot, so that a stroke
//! ends before it; and an edge that meets a stroke ends where the sides of the stroke begin. Of strokes of two tints
//! only ends that touch may belong together, as the sides of a triangle in two colours: a gridline may end near the end
//! of a curve. A thin, pale stroke and a bold one make no sharp corner: the gridlines of squared paper end near the
//! corners of what is drawn on it.

use super::contour::{Contour, ContourPoint, crossing};
use super::junction::{PointIndex, index_of};
use super::stroke::{Stroke, Tint, are_two_breadths};
use crate::geom::link::{End, Part, link};
use crate::geom::order::median;
use crate::geom::walk::runs;
use crate::units::{Px, PxPoint, PxVector, Size};

/// A contour, and the width of the stroke along whose middle it runs, px; an edge has none.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FoundContour {
    pub(super) contour: Contour,
    pub(super) stroke: Option<f32>,
    /// Length of what it is a part of, px: a stroke goes on where another one lies over it.
    pub(super) whole: f32,
    /// The tint of a stroke, where it is known.
    pub(super) tint: Option<Tint>,
}

/// Two ends make a corner if they are at most so many widths of the stroke apart, and this much more, px: those of a
/// roof whose sides make 33 degrees, found with the largest square, are 17 px apart.
const APART_WIDTHS: f32 = 2.0;
const APART: f32 = 18.0;
/// The same for ends of which one is that of an edge, in scales of the edge detector.
const APART_SCALES: f32 = 4.0;
/// The direction of an end is taken over so many widths of the stroke, and this much more, px.
const HEADING_WIDTHS: f32 = 2.0;
const HEADING: f32 = 6.0;
/// The direction of an end of an edge is taken over so many scales, but for the last ones, which are bent.
const HEADING_SCALES: f32 = 6.0;
const BENT_SCALES: f32 = 1.5;
/// Cosine between the directions of two ends that make a corner: at most 60 degrees between its sides, and at least 10.
const WIDE: f32 = 0.5;
const NARROW: f32 = 0.985;
/// Least cosine between the directions of two ends that make any other corner (120 degrees).
const WIDEST: f32 = -0.5;
/// Two strokes of different tints make a corner only where they are no farther apart than the wider one is wide, and
/// this much more, px: over that nobody can tell which of the two it is.
const TINT_UNSURE: f32 = 6.0;
/// Two strokes are of different weight if one is so many times as wide as the other, or of so many times its contrast.
/// Pixels show a stroke of half a pixel as two wide, with a quarter of its contrast.
const WIDER: f32 = 1.6;
const BOLDER: f32 = 2.0;
/// Shorter ones, px, may be parts of letters, which differ as they are thin here and thick there.
const WEIGHED: f32 = 32.0;
/// Two strokes of different weight are two lines where they meet in a corner, if the cosine between their directions is
/// at least the first (45 degrees), and where one goes on in the other, if that between the directions there is less
/// than the second (10 degrees): a gridline and the top of a bar are one straight line.
const SHARP: f32 = 0.707;
const ONE_STRAIGHT: f32 = 0.985;
/// The tip lies at most so many times the greatest distance between the ends beyond them or before them.
const BEYOND: f32 = 1.5;
/// An end goes on in another if the cosine between its direction and the direction there is at least this (18 degrees).
const AHEAD_COSINE: f32 = 0.95;
/// A contour that goes straight on, or makes a wide corner, is at least so many times as long as another may be away
/// from its end: the parts of letters and of arrowheads are not.
const LONG: f32 = 3.0;
/// One that makes a sharp corner is at least this long, px: the eaves of small houses are no longer.
const SHORT: f32 = 8.0;
/// On the way to the tip there is at least this share of the contrast that the contour has at its end.
const SEEN: f32 = 0.3;

/// The contrast need not be seen over the last of the way to the tip, px, where the tip is too thin.
const POINTED: f32 = 4.0;

/// An end stands on another contour if it is no farther from its side than this, px, and that leads away from there on
/// both sides, across the end: the cosine between their directions is at most this (45 degrees).
const STANDS: f32 = 2.0;
const ACROSS: f32 = 0.707;
/// Of a gap between two contours on which ends stand, this share beside each is not looked at: it may be blurred.
const BESIDE: f32 = 0.25;

/// Places nearer than this, px, are one: two ends that were led to one tip.
const SAME: f32 = 1e-3;

/// See [`meet`].
pub(super) type IsSeen<'a> = dyn Fn(PxPoint, PxPoint, f32, f32) -> bool + 'a;

/// Contours whose ends make a sharp corner end at its tip, if one of them is a stroke; two strokes become one, as they
/// do where one goes on in the other, unless each stands on a contour of its own: those are the plates of a battery. A
/// tip beyond the border of the picture is none. `sigma` is the scale of the edge detector, px, and `size` that of the
/// picture.
///
/// `is_seen` tells whether the picture shows something along the segment between two points that has at least a
/// contrast, given with the width of the stroke.
pub(super) fn join_corners(
    mut found: Vec<FoundContour>,
    sigma: f32,
    size: Size,
    is_seen: &IsSeen<'_>,
) -> Vec<FoundContour> {
    let ends: Vec<End<Px>> = (0..found.len())
        .filter(|&number| !found[number].contour.closed && found[number].contour.vertices.len() > 2)
        .flat_map(|number| [true, false].map(|at_start| end(number, at_start, &found[number], sigma)))
        .collect();
    let reach = found.iter().map(|found| found.reach(sigma)).fold(0.0, f32::max);
    let (right, bottom) = (size.width as f32, size.height as f32);
    let is_inside = |at: PxPoint| (0.0..=right).contains(&at.x) && (0.0..=bottom).contains(&at.y);
    let bases = Bases::of(&found, size, sigma);
    let may_meet = |a: &End<Px>, b: &End<Px>| match goes_on(a, b) {
        true => !bases.are_parted(a, b, is_seen),
        false => is_inside(tip_of(a, b)),
    };
    let threads = link(found.len(), &ends, reach, |a, b| cost(a, b, &found, sigma, is_seen).filter(|_| may_meet(a, b)));
    let of = |part: &Part, at_start: bool| {
        let at_start = at_start != part.reversed;
        ends.iter().find(|end| end.polyline == part.polyline && end.at_start == at_start)
    };
    let mut joined = Vec::with_capacity(found.len());
    for thread in threads {
        let pairs = thread.parts.windows(2).map(|pair| (&pair[0], &pair[1]));
        let over_start = thread.closed.then(|| thread.parts.last().zip(thread.parts.first())).flatten();
        for (part, next) in pairs.chain(over_start) {
            let Some((a, b)) = of(part, false).zip(of(next, true)) else { continue };
            if goes_on(a, b) {
                continue;
            }
            let tip = tip_of(a, b);
            for end in [a, b] {
                let [_, trimmed] = found[end.polyline].heading(sigma);
                found[end.polyline].lead_to(tip, end.at_start, trimmed);
            }
        }
        let is_straight =
            |part: &Part, next: &Part| of(part, false).zip(of(next, true)).is_some_and(|(a, b)| goes_on(a, b));
        joined.extend(concatenated(&thread.parts, thread.closed, &found, &is_straight));
    }
    joined
}

/// The contours of a thread. Strokes that follow one another are one, and so are edges: as two lines they might be
/// taken for the two sides of a stroke beside their tip. What goes straight on is one, whatever it is.
fn concatenated(
    parts: &[Part],
    closed: bool,
    found: &[FoundContour],
    is_straight: &dyn Fn(&Part, &Part) -> bool,
) -> Vec<FoundContour> {
    let is_stroke = |part: usize| found[parts[part].polyline].stroke.is_some();
    let is_one = |a: usize, b: usize| is_stroke(a) == is_stroke(b) || is_straight(&parts[a], &parts[b]);
    let runs = runs(parts.len(), closed, is_one);
    // its ends meet in one tip
    let is_ring = closed && runs.len() == 1;
    let of = |part: usize| {
        let Part { polyline, reversed } = parts[part];
        let mut found = found[polyline].clone();
        if reversed {
            found.contour.reverse();
        }
        found
    };
    let one = |run: Vec<usize>| {
        let mut one = of(run[0]);
        run[1..].iter().for_each(|&part| one.go_on_in(of(part)));
        if is_ring {
            one.contour.vertices.pop();
            one.contour.closed = true;
        }
        one
    };
    runs.into_iter().map(one).collect()
}

impl FoundContour {
    /// An edge.
    pub(super) fn edge(contour: Contour) -> Self {
        Self { whole: contour.length(), contour, stroke: None, tint: None }
    }

    /// A stroke, along its middle.
    pub(super) fn stroke(Stroke { contour, width, whole, tint, .. }: Stroke) -> Self {
        Self { contour, stroke: Some(width), whole, tint }
    }

    /// Whether the two are strokes whose tints are known and differ: pieces of two lines, which may cross.
    pub(super) fn differs_in_tint(&self, other: &Self) -> bool {
        Tint::are_two(self.tint, other.tint)
    }

    /// The contrast of most of it.
    pub(super) fn height(&self) -> f32 {
        median(self.contour.vertices.iter().map(|vertex| vertex.strength))
    }

    /// Whether the two are strokes of different breadth: a wall, and the leaf of the door at its end.
    pub(super) fn differs_in_breadth(&self, other: &Self) -> bool {
        self.stroke.zip(other.stroke).is_some_and(|(width, other)| are_two_breadths(width, other))
    }

    /// Whether the two are long strokes of which one is far wider or bolder than the other.
    fn differs_in_weight(&self, other: &Self) -> bool {
        if self.whole.min(other.whole) < WEIGHED {
            return false;
        }
        let is_more = |one: f32, other: f32, times: f32| one.max(other) >= times * one.min(other);
        self.stroke.zip(other.stroke).is_some_and(|(width, other_width)| {
            is_more(width, other_width, WIDER) || is_more(self.height(), other.height(), BOLDER)
        })
    }

    /// Goes on in another one, as a stroke if most of it is one.
    fn go_on_in(&mut self, next: Self) {
        let (before, after) = (self.contour.length(), next.contour.length());
        self.stroke = match (self.stroke, next.stroke) {
            (Some(width), Some(next_width)) => Some((width * before + next_width * after) / (before + after)),
            (width, next_width) => {
                if before >= after {
                    width
                } else {
                    next_width
                }
            }
        };
        if after > before {
            self.tint = next.tint;
        }
        self.whole = self.whole.max(next.whole).max(before + after);
        let last = self.contour.vertices.last().map(|vertex| vertex.at);
        let is_there = |first: &ContourPoint| last.is_some_and(|last| (first.at - last).length() < SAME);
        let tips = next.contour.vertices.first().map_or(0, |first| usize::from(is_there(first)));
        self.contour.vertices.extend(next.contour.vertices.into_iter().skip(tips));
    }

    /// The least contrast that is seen where it goes on beyond one of its ends.
    pub(super) fn least_seen(&self, at_start: bool) -> f32 {
        let last = if at_start { self.contour.vertices.first() } else { self.contour.vertices.last() };
        last.map_or(0.0, |last| SEEN * last.strength)
    }

    /// How far from one of its ends another may be that makes a corner with it, px.
    fn reach(&self, sigma: f32) -> f32 {
        self.stroke.map_or(APART_SCALES * sigma, |width| APART_WIDTHS * width + APART)
    }

    /// From where to where the direction of an end is taken, px from the end.
    fn heading(&self, sigma: f32) -> [f32; 2] {
        self.stroke.map_or([BENT_SCALES, HEADING_SCALES].map(|scales| scales * sigma), |width| {
            [0.0, HEADING_WIDTHS * width + HEADING]
        })
    }

    /// Leads an end straight to a tip, from where it is this far from it, px. Beside the tip contrast cannot be
    /// measured: it is that before.
    pub(super) fn lead_to(&mut self, tip: PxPoint, at_start: bool, trimmed: f32) {
        if at_start {
            self.contour.reverse();
        }
        let vertices = &mut self.contour.vertices;
        while vertices.len() > 2 && vertices.last().is_some_and(|last| (last.at - tip).length() < trimmed) {
            vertices.pop();
        }
        self.contour.lead_to(tip);
        if at_start {
            self.contour.reverse();
        }
    }
}

/// Contours by place, to find those on which ends of others stand.
struct Bases<'a> {
    found: &'a [FoundContour],
    index: PointIndex,
    /// The scale of the edge detector, px.
    sigma: f32,
    /// The greatest [`Bases::beside`] of all.
    farthest: f32,
}

impl<'a> Bases<'a> {
    fn of(found: &'a [FoundContour], size: Size, sigma: f32) -> Self {
        let index = index_of(found.iter().map(|found| &found.contour), size);
        let farthest = found.iter().map(|found| Self::beside(found, sigma)).fold(0.0, f32::max);
        Self { found, index, sigma, farthest }
    }

    /// How far from a contour what stands on it may end, px: an edge ends before the sides of a stroke, and a stroke
    /// before an edge.
    fn beside(found: &FoundContour, sigma: f32) -> f32 {
        found.stroke.map_or(APART_SCALES * sigma, |width| 0.5 * width)
    }

    /// Whether two ends stand on contours of their own, with nothing between these: the gap of a battery or of a
    /// capacitor says what it is. Both on one contour are those of a line across it.
    fn are_parted(&self, a: &End<Px>, b: &End<Px>, is_seen: &IsSeen<'_>) -> bool {
        let (Some(base), Some(other)) = (self.base(a), self.base(b)) else { return false };
        let [from, to] = [BESIDE, 1.0 - BESIDE].map(|share| a.at.lerp(b.at, share));
        let found = &self.found[a.polyline];
        base != other && !is_seen(from, to, found.stroke.unwrap_or(0.0), found.least_seen(a.at_start))
    }

    /// The number of the nearest contour on which an end stands.
    fn base(&self, end: &End<Px>) -> Option<usize> {
        let own = 0.5 * self.found[end.polyline].stroke.unwrap_or(0.0) + STANDS;
        let reach = |found: &FoundContour| own + Self::beside(found, self.sigma);
        let mut nearest: Option<(f32, usize, usize)> = None;
        self.index.around(end.at, end.at, own + self.farthest, |&(number, k)| {
            let (number, k) = (number as usize, k as usize);
            let found = &self.found[number];
            let distance = (found.contour.vertices[k].at - end.at).length();
            let is_other = number != end.polyline && distance <= reach(found);
            let is_nearer = nearest.is_none_or(|nearest| (distance, number, k) < nearest);
            if is_other && is_nearer && leads_across(found, k, end.direction) {
                nearest = Some((distance, number, k));
            }
        });
        nearest.map(|(_, number, _)| number)
    }
}

/// Whether a contour leads away from one of its vertices on both sides, across a direction.
fn leads_across(found: &FoundContour, vertex: usize, direction: PxVector) -> bool {
    let along = |forwards: bool| found.contour.heading(vertex, forwards, [0.0, HEADING]);
    [true, false].into_iter().all(|forwards| along(forwards).is_some_and(|along| along.dot(direction).abs() <= ACROSS))
}

fn end(number: usize, at_start: bool, found: &FoundContour, sigma: f32) -> End<Px> {
    let contour = &found.contour;
    let tip = if at_start { 0 } else { contour.vertices.len() - 1 };
    let inwards = contour.heading(tip, at_start, found.heading(sigma)).unwrap_or_default();
    let at = contour.vertices[tip].at;
    End { polyline: number, at_start, at, direction: -inwards, contrast: [0.0; 3] }
}

/// The tip of the corner that two ends make.
fn tip_of(a: &End<Px>, b: &End<Px>) -> PxPoint {
    let ahead = crossing((a.at, a.direction), (b.at, b.direction)).map_or(0.0, |(ahead, _)| ahead);
    a.at + a.direction * ahead
}

fn cost(a: &End<Px>, b: &End<Px>, found: &[FoundContour], sigma: f32, is_seen: &IsSeen<'_>) -> Option<f32> {
    let [first, second] = [a, b].map(|end| &found[end.polyline]);
    if first.differs_in_breadth(second) {
        return None;
    }
    let is_one = !first.differs_in_tint(second);
    // what has its own tint comes first
    let more = if is_one { 0.0 } else { first.reach(sigma).max(second.reach(sigma)) };
    if let Some(cost) = straight_on(a, b, found, sigma) {
        return Some(cost + more);
    }
    let width = first.stroke.unwrap_or(0.0).max(second.stroke.unwrap_or(0.0));
    if !is_one && (b.at - a.at).length() > width + TINT_UNSURE {
        return None;
    }
    let leads_to = |end: &End<Px>, ahead: f32| {
        let found = &found[end.polyline];
        let tip = end.at + end.direction * (ahead - POINTED);
        ahead <= POINTED || is_seen(end.at, tip, found.stroke.unwrap_or(0.0), found.least_seen(end.at_start))
    };
    let (from_a, from_b) = crossing((a.at, a.direction), (b.at, b.direction))?;
    let cost = sharp_corner(a, b, found, sigma).or_else(|| wide_corner(a, b, found, sigma))?;
    if a.direction.dot(b.direction) >= SHARP && first.differs_in_weight(second) {
        return None;
    }
    (leads_to(a, from_a) && leads_to(b, from_b)).then_some(cost + more)
}

/// The cost of going straight on over a gap.
fn straight_on(a: &End<Px>, b: &End<Px>, found: &[FoundContour], sigma: f32) -> Option<f32> {
    let [first, second] = [a, b].map(|end| &found[end.polyline]);
    let distance = (b.at - a.at).length();
    let reach = first.reach(sigma).max(second.reach(sigma));
    let is_short = [first, second].into_iter().any(|found| found.whole < LONG * found.reach(sigma));
    let are_strokes = first.stroke.is_some() && second.stroke.is_some();
    let are_edges = first.stroke.is_none() && second.stroke.is_none();
    let is_near = distance <= if are_strokes { reach } else { APART_SCALES * sigma };
    let may_be_one = || -a.direction.dot(b.direction) >= ONE_STRAIGHT || !first.differs_in_weight(second);
    (is_near && !is_short && !are_edges && goes_on(a, b) && may_be_one()).then_some(distance)
}

fn sharp_corner(a: &End<Px>, b: &End<Px>, found: &[FoundContour], sigma: f32) -> Option<f32> {
    let (distance, cosine) = ((b.at - a.at).length(), a.direction.dot(b.direction));
    let [first, second] = [a, b].map(|end| &found[end.polyline]);
    let reach = first.reach(sigma).max(second.reach(sigma));
    let is_short = [first, second].into_iter().any(|found| found.whole < SHORT);
    if distance > reach || is_short || goes_on(a, b) {
        return None;
    }
    if !(WIDE..=NARROW).contains(&cosine) {
        return None;
    }
    let near = |ahead: f32| ahead.abs() <= BEYOND * reach;
    let (from_a, from_b) = crossing((a.at, a.direction), (b.at, b.direction))?;
    (near(from_a) && near(from_b)).then_some(distance)
}

/// The cost of a corner that is not sharp: its ends are near one another, or both near the tip.
fn wide_corner(a: &End<Px>, b: &End<Px>, found: &[FoundContour], sigma: f32) -> Option<f32> {
    let (distance, cosine) = ((b.at - a.at).length(), a.direction.dot(b.direction));
    let [first, second] = [a, b].map(|end| &found[end.polyline]);
    let width = first.stroke.unwrap_or(0.0).max(second.stroke.unwrap_or(0.0));
    let reach = APART_SCALES * sigma + 0.5 * width;
    let is_short = [first, second].into_iter().any(|found| found.whole < LONG * reach);
    let are_edges = first.stroke.is_none() && second.stroke.is_none();
    if distance > reach || is_short || are_edges || !(WIDEST..WIDE).contains(&cosine) {
        return None;
    }
    let near = |ahead: f32| ahead.abs() <= reach;
    let (from_a, from_b) = crossing((a.at, a.direction), (b.at, b.direction))?;
    // ends that go on in one another and sharp corners come first
    (near(from_a) && near(from_b)).then_some(distance + 2.0 * (APART_WIDTHS * width + APART))
}

/// Whether one end points at the other, and the other at it.
fn goes_on(a: &End<Px>, b: &End<Px>) -> bool {
    let ahead = (b.at - a.at).try_normalize().unwrap_or_default();
    a.direction.dot(ahead) >= AHEAD_COSINE && -b.direction.dot(ahead) >= AHEAD_COSINE
}

#[cfg(test)]
mod tests;
