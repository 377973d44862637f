//! Points on lines as they are drawn: beads, and rings at which lines end.

use std::collections::BTreeMap;

use super::point::ring_radius;
use super::{BEAD, MIDDLE, Point, SOLID, disc_radius};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polygon::circle_points;
use crate::geom::polyline::Polyline;
use crate::geom::walk::arc_between;
use crate::lines::clearance::TOUCH;
use crate::lines::faint::is_faint;
use crate::lines::line::Line;
use crate::lines::marks::whole_series;
use crate::lines::params::{Params, RING_FARTHEST};
use crate::lines::vertex::{FoundIn, SPACING, Vertex, nearby};
use crate::lines::weight::width;
use crate::units::{MmPoint, MmRect, MmVector};

/// A filled point is a piece of its line of this length, mm: with its round ends it is a disc.
const BEAD_LENGTH: f32 = 0.1;
/// A line passes through a point no farther from its middle than this share of its radius: it meets the ring at 30
/// degrees or more. What is farther is beside it.
pub(super) const PASSES: f32 = 0.5;
/// A line that passes through a point is near to it for about this many times as far as its ring keeps from lines.
const RETURNS: f32 = 2.0;

/// The ink of a disc and of a line that it lies on overlap by so much at least, mm: no blank is felt between them.
const SUNK: f32 = 0.2;
/// A disc is moved by at most this, mm, as lines are of a drawing that is crowded: less than a fingertip resolves.
const FARTHEST_DISC: f32 = 0.9;
/// Hollow signs are rings if at least this share of them have room as rings.
const LEAST_RINGS: f32 = 0.75;
/// So much beyond a distance a disc is moved, mm.
const ROUNDING: f32 = 0.01;

/// A part of a line, with which of its vertices are anchored.
#[derive(Debug)]
pub(in crate::lines) struct LinePart {
    pub(in crate::lines) polyline: Polyline<Vertex>,
    pub(in crate::lines) anchored: Vec<bool>,
}

impl LinePart {
    /// A part without vertices.
    fn empty() -> Self {
        Self { polyline: Polyline::open(Vec::new()), anchored: Vec::new() }
    }

    fn push(&mut self, vertex: Vertex, is_anchored: bool) {
        self.polyline.vertices.push(vertex);
        self.anchored.push(is_anchored);
    }
}

/// The marks of those points that have room on the lines that are drawn.
#[derive(Debug, Default)]
pub(in crate::lines) struct DrawnPoints {
    /// Of the line of each filled one its number, and where its bead is.
    pub(super) beads: Vec<(usize, MmPoint)>,
    /// Where lines end at hollow ones, and how far from their middles, mm.
    pub(super) holes: Vec<(MmPoint, f32)>,
    /// All of them, with their radii, mm.
    pub(in crate::lines) discs: Vec<(MmPoint, f32)>,
    /// The least blank of each to lines and to others, mm.
    pub(super) gaps: Vec<f32>,
    /// The lines among which they are.
    pub(super) lines: Option<AmongLines>,
    /// The rings of those.
    pub(in crate::lines) rings: Vec<Polyline<Vertex>>,
    /// How many have no room.
    pub(in crate::lines) lost: usize,
    /// Where those of them are that would be discs.
    pub(in crate::lines) lost_discs: Vec<MmPoint>,
}

/// Draws points on `lines`.
pub(in crate::lines) fn draw(
    points: &[Point],
    lines: &[&Polyline<Vertex>],
    area: MmRect,
    params: &Params,
) -> DrawnPoints {
    if points.is_empty() {
        return DrawnPoints::default();
    }
    let segments = nearby(lines.iter().copied(), area, params);
    let faint: Vec<bool> = lines.iter().map(|line| is_faint(line)).collect();
    let ring_lengths = lines.iter().map(|line| line.view().goes_round().then(|| line.length())).collect();
    let half_widths = lines.iter().map(|line| 0.5 * width(line.mean_strength(), params)).collect();
    let lines = AmongLines { segments, faint, ring_lengths, half_widths };
    let points = &signs_alike(points, &lines, params)[..];
    let (drawn, has_room) = draw_those(points, &vec![true; points.len()], &lines, params);
    let series: Vec<Option<usize>> = points.iter().map(|point| point.series).collect();
    let whole = whole_series(&series, &has_room);
    let drawn = if whole == has_room { drawn } else { draw_those(points, &whole, &lines, params).0 };
    DrawnPoints { lines: Some(lines), ..drawn }
}

/// The points, of which the signs are all discs where too few hollow ones would have room as rings: that each is there
/// says more than of which kind it is.
fn signs_alike(points: &[Point], lines: &AmongLines, params: &Params) -> Vec<Point> {
    let (_, has_room) = draw_those(points, &vec![true; points.len()], lines, params);
    let own = || points.iter().zip(&has_room).filter(|(point, _)| is_ring_of_sign(point));
    let drawn = own().filter(|(_, has_room)| **has_room).count() as f32;
    let are_alike = drawn < LEAST_RINGS * own().count() as f32;
    let alike = |point: &Point| Point { is_filled: point.is_filled || point.is_sign && are_alike, ..*point };
    points.iter().map(alike).collect()
}

/// The lines among which points are drawn.
#[derive(Debug)]
pub(super) struct AmongLines {
    segments: Nearby,
    /// Which are faint: they give way.
    faint: Vec<bool>,
    /// The lengths of those that go round, mm.
    ring_lengths: Vec<Option<f32>>,
    /// Half of how wide each will be, mm.
    half_widths: Vec<f32>,
}

/// Draws those of the points that are wanted and have room; says which.
fn draw_those(points: &[Point], wanted: &[bool], lines: &AmongLines, params: &Params) -> (DrawnPoints, Vec<bool>) {
    let mut drawn = DrawnPoints::default();
    let half = 0.5 * params.width_max;
    let mut has_room = vec![false; points.len()];
    for (number, point) in points.iter().enumerate().filter(|(number, _)| wanted[*number]) {
        let (radius, gap) = (radius(point, params), gap(point, params));
        // no line passes through a ring
        let on = if is_ring_of_sign(point) { f32::NEG_INFINITY } else { radius - SUNK };
        let bounds = (on, radius + gap + params.play());
        let near = |at: MmPoint| {
            let near = |((other, its), gap_of): (&(MmPoint, f32), &f32)| {
                (*other - at).length() < radius + its + gap.max(*gap_of)
            };
            drawn.discs.iter().zip(&drawn.gaps).any(near)
        };
        let place = match point.is_disc {
            true => lines.place_of_disc(point.at, bounds, params).map(|at| (at, None)),
            false => lines.place(point).filter(|(at, _)| lines.leave_room(point, *at, radius, params)),
        };
        let from_others = |at: MmPoint| {
            let apart = drawn.apart(at, radius, gap).filter(|to| (*to - point.at).length() <= FARTHEST_DISC);
            apart.filter(|to| lines.place_of_disc(*to, bounds, params) == Some(*to) && !near(*to))
        };
        let place = place.and_then(|(at, line)| match near(at) {
            false => Some((at, line)),
            true => from_others(at).filter(|_| point.is_disc).map(|at| (at, line)),
        });
        let Some((at, line)) = place else {
            drawn.lost_discs.extend(point.is_disc.then_some(point.at));
            continue;
        };
        has_room[number] = true;
        drawn.discs.push((at, radius));
        drawn.gaps.push(gap);
        match line.filter(|_| point.is_filled) {
            None if is_ring_of_sign(point) => drawn.rings.push(ring(point, at, radius - half, params)),
            None if point.is_disc => drawn.rings.push(ring(point, at, 0.5 * SOLID * params.width_max, params)),
            Some(line) => drawn.beads.push((line as usize, at)),
            None => {
                drawn.rings.push(ring(point, at, radius - half, params));
                drawn.holes.push((at, radius - half));
            }
        }
    }
    drawn.lost = has_room.iter().filter(|has_room| !**has_room).count();
    (drawn, has_room)
}

/// A place of a line that is near to a point.
struct NearPlace {
    line: u32,
    /// How far along the line, mm.
    arc: f32,
    /// How far from the middle of the point, mm.
    distance: f32,
}

impl AmongLines {
    /// Where a point is drawn, and on which line: that which goes through it, wherever that was moved; none if there is
    /// no such line any more. One beside lines stays where it is.
    fn place(&self, point: &Point) -> Option<(MmPoint, Option<u32>)> {
        if point.is_alone {
            return Some((point.at, None));
        }
        let reach = RING_FARTHEST + MIDDLE * point.radius;
        let nearest =
            |of_faint: bool| self.segments.nearest(point.at, reach, |segment| self.is_faint(segment) == of_faint);
        nearest(false).or_else(|| nearest(true)).map(|(_, at, segment)| (at, Some(segment.line)))
    }

    /// Where a disc is drawn for a point there: the side of each line is no farther from its middle than `on`, mm, and
    /// under it, or as far as `clear`. For that it is moved a little, to the one or the other; faint lines give way.
    /// None if there is no such place.
    fn place_of_disc(&self, own: MmPoint, (on, clear): (f32, f32), params: &Params) -> Option<MmPoint> {
        let most = 0.5 * params.width_max;
        let Some((distance, foot)) = self.nearest_between(own, (on, clear), most) else { return Some(own) };
        let away = (own - foot).try_normalize()?;
        let mut steps = [on - distance - ROUNDING, clear - distance + ROUNDING];
        steps.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let places = steps.into_iter().filter(|step| step.abs() <= FARTHEST_DISC).map(|step| own + away * step);
        places.into_iter().find(|at| self.nearest_between(*at, (on, clear), most).is_none())
    }

    /// The nearest line that is not faint and whose side is farther from a place than the one distance, mm, and not as
    /// far as the other: how far that is, and where its middle. Lines are at most twice `half_width` wide.
    fn nearest_between(&self, at: MmPoint, (from, to): (f32, f32), half_width: f32) -> Option<(f32, MmPoint)> {
        let mut nearest: BTreeMap<u32, (f32, MmPoint)> = BTreeMap::new();
        self.segments.around_point(at, to + half_width, |segment| {
            let (to_middle, foot) = nearest_on_segment(at, segment.a, segment.b);
            let distance = to_middle - self.half_widths[segment.line as usize];
            if !self.is_faint(segment) && distance < to {
                let least = nearest.entry(segment.line).or_insert((distance, foot));
                *least = if distance < least.0 { (distance, foot) } else { *least };
            }
        });
        let between = nearest.into_values().filter(|(distance, _)| *distance > from);
        between.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Whether a disc with this radius, mm, can be drawn for a point: no line is too near to it but those that pass
    /// through its middle. These may be near it there, and not where they come back beside it; faint ones give way.
    fn leave_room(&self, point: &Point, at: MmPoint, radius: f32, params: &Params) -> bool {
        let beside = params.beside_disc(radius);
        let mut near: Vec<NearPlace> = Vec::new();
        self.segments.around_point(at, beside, |segment| {
            let (distance, nearest) = nearest_on_segment(at, segment.a, segment.b);
            if !self.is_faint(segment) && distance < beside {
                let arc = segment.arc + (nearest - segment.a).length();
                near.push(NearPlace { line: segment.line, arc, distance });
            }
        });
        let passes = |place: &NearPlace| {
            let along = |arc: f32| arc_between(place.arc, arc, self.ring_lengths[place.line as usize]);
            let is_through = |other: &NearPlace| {
                other.line == place.line && other.distance <= PASSES * radius && along(other.arc) <= RETURNS * beside
            };
            !point.is_alone && near.iter().any(is_through)
        };
        near.iter().all(passes)
    }

    fn is_faint(&self, segment: &Segment) -> bool {
        self.faint[segment.line as usize]
    }
}

/// Radius of what is drawn for a point, mm, with its ink.
pub(super) fn radius(point: &Point, params: &Params) -> f32 {
    let half = 0.5 * params.width_max;
    if is_ring_of_sign(point) {
        return ring_radius(params);
    }
    if point.is_disc {
        return disc_radius(params);
    }
    if point.is_filled { BEAD * half } else { point.radius.max(0.5 * params.max_spacing()) + half }
}

/// Whether a ring is drawn for a sign, as others are discs.
fn is_ring_of_sign(point: &Point) -> bool {
    point.is_sign && !point.is_filled
}

/// Least blank around what is drawn for a point, mm.
fn gap(point: &Point, params: &Params) -> f32 {
    if point.is_disc && !is_ring_of_sign(point) { Line::DISC_GAP * params.min_gap } else { params.min_gap }
}

fn ring(point: &Point, at: MmPoint, radius: f32, params: &Params) -> Polyline<Vertex> {
    let count = ((std::f32::consts::TAU * radius / SPACING).ceil() as usize).max(12);
    let vertex = |at: MmPoint| Vertex {
        at,
        strength: point.strength.max(params.full_strength),
        contrast: [0.0; 3],
        width: params.width_max,
        stroke: 0.0,
        bar: 0.0,
        source: FoundIn::Vector,
        displaced: MmVector::zero(),
    };
    Polyline { vertices: circle_points(at, radius, count).map(vertex).collect(), closed: true }
}

impl DrawnPoints {
    /// The place next to this one at which what is drawn with a radius is as far as it must be from that one of these
    /// to which it is nearest.
    fn apart(&self, at: MmPoint, radius: f32, gap: f32) -> Option<MmPoint> {
        let lacks = |((other, its), of): (&(MmPoint, f32), &f32)| {
            let distance = (at - *other).length();
            (radius + its + gap.max(*of) - distance, *other)
        };
        let (lack, other) = self.discs.iter().zip(&self.gaps).map(lacks).max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(at + (at - other).try_normalize()? * (lack + ROUNDING))
    }

    /// A line, of this number among those that are drawn, with its beads, and in parts where it ends at hollow points;
    /// with what of it is anchored.
    pub(in crate::lines) fn parts(
        &self,
        number: usize,
        line: &Polyline<Vertex>,
        anchored: &[bool],
        params: &Params,
    ) -> Vec<LinePart> {
        let is_own = |(of, _): &&(usize, MmPoint)| *of == number;
        if is_faint(line) && !self.beads.iter().any(|bead| is_own(&bead)) {
            return self.interrupted(line, anchored, params);
        }
        let mut whole = LinePart { polyline: line.clone(), anchored: anchored.to_vec() };
        for (_, at) in self.beads.iter().filter(is_own) {
            add_bead(&mut whole, *at, BEAD * params.width_max);
        }
        if self.holes.is_empty() {
            return vec![whole];
        }
        // what sticks out of a ring for less than a gap, as the ends of a tick, is felt as a fault in the ring
        let mut parts = outside(&whole.polyline, &whole.anchored, &self.holes, params.min_gap);
        parts.retain(|part| !self.is_stub(&part.polyline, number, &whole.polyline, params));
        parts
    }

    /// What of these lines is not drawn, as it would stick out of a hollow point and be too short for a line.
    pub(in crate::lines) fn stubs(&self, lines: &[&Polyline<Vertex>], params: &Params) -> Vec<Polyline<Vertex>> {
        let stubs = |(number, line): (usize, &&Polyline<Vertex>)| -> Vec<Polyline<Vertex>> {
            let parts = outside(line, &vec![false; line.vertices.len()], &self.holes, params.min_gap).into_iter();
            parts.map(|part| part.polyline).filter(|part| self.is_stub(part, number, line, params)).collect()
        };
        let all = if self.holes.is_empty() { &[] } else { lines };
        all.iter().enumerate().flat_map(stubs).collect()
    }

    /// Those of these lines that lie in a hollow point as a whole, so that nothing of them is drawn, each with the
    /// middle of that.
    pub(in crate::lines) fn hidden<'l>(
        &self,
        lines: &[&'l Polyline<Vertex>],
        params: &Params,
    ) -> Vec<(MmPoint, &'l Polyline<Vertex>)> {
        let hole_of = |line: &Polyline<Vertex>| {
            // what sticks out for less than a gap is not drawn either
            let is_in = |(at, radius): &&(MmPoint, f32)| {
                line.vertices.iter().all(|vertex| (vertex.at - *at).length() < radius + params.min_gap)
                    && line.distance(*at) <= PASSES * radius
            };
            self.holes.iter().find(is_in).map(|(at, _)| *at)
        };
        let open = lines.iter().filter(|line| !line.closed && !is_faint(line));
        open.filter_map(|line| hole_of(line).map(|at| (at, *line))).collect()
    }

    /// Whether a part of a line, cut at a hollow point, is too short for a line and leads to nothing else.
    fn is_stub(&self, part: &Polyline<Vertex>, number: usize, line: &Polyline<Vertex>, params: &Params) -> bool {
        let Some(lines) = self.lines.as_ref() else { return false };
        let ends =
            |line: &Polyline<Vertex>| [line.vertices.first(), line.vertices.last()].map(|end| end.map(|end| end.at));
        let ends_loose = |(own, of_line): (Option<MmPoint>, Option<MmPoint>)| {
            let is_other = |other: u32| other as usize != number;
            own.filter(|_| own == of_line)
                .is_some_and(|at| lines.segments.nearest(at, TOUCH, |segment| is_other(segment.line)).is_none())
        };
        !part.closed && part.length() < params.min_length && ends(part).into_iter().zip(ends(line)).any(ends_loose)
    }

    /// The parts of a faint line beside points, whose other lines they keep clear of too.
    fn interrupted(&self, line: &Polyline<Vertex>, anchored: &[bool], params: &Params) -> Vec<LinePart> {
        // the two ends at a point are as far apart as any, even where the line would only touch the hole
        let half = 0.5 * params.clearance(params.width_min);
        let hole = |(&(at, radius), &gap): (&(MmPoint, f32), &f32)| {
            let clearance = gap + 0.5 * params.width_min + params.play();
            let distance = line.distance(at);
            (distance < radius + clearance).then(|| (at, (radius + clearance).max(distance.hypot(half))))
        };
        let holes: Vec<(MmPoint, f32)> = self.discs.iter().zip(&self.gaps).filter_map(hole).collect();
        let is_cut = |vertex: &Vertex| {
            holes.iter().any(|(at, radius)| ((vertex.at - *at).length() - radius).abs() <= params.tolerance)
        };
        let is_near = |vertex: &Vertex| {
            let reach = params.clearance(0.5 * (vertex.width + params.width_max));
            let lines = self.lines.as_ref();
            lines.is_some_and(|AmongLines { segments, faint, .. }| {
                segments.nearest(vertex.at, reach, |segment| !faint[segment.line as usize]).is_some()
            })
        };
        let clear = |LinePart { polyline, mut anchored }: LinePart| {
            let mut vertices = polyline.vertices;
            if vertices.last().is_some_and(is_cut) {
                while vertices.pop_if(|vertex| is_near(vertex)).is_some() {}
                anchored.truncate(vertices.len());
            }
            if vertices.first().is_some_and(is_cut) {
                let near = vertices.iter().take_while(|vertex| is_near(vertex)).count();
                vertices.drain(..near);
                anchored.drain(..near);
            }
            let polyline = Polyline::open(vertices);
            (polyline.length() >= params.min_length).then_some(LinePart { polyline, anchored })
        };
        let parts = outside(line, anchored, &holes, 0.0).into_iter();
        parts.filter_map(|part| if part.polyline.closed { Some(part) } else { clear(part) }).collect()
    }
}

/// So many vertices from a bead a ring may begin.
const ASIDE: usize = 2;

/// Makes a line as broad as `width`, mm, over [`BEAD_LENGTH`] where it is nearest to a place.
fn add_bead(LinePart { polyline: line, anchored }: &mut LinePart, at: MmPoint, width: f32) {
    let distance = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(at, a.at, b.at).0;
    let nearest = |line: &Polyline<Vertex>| {
        let distances: Vec<f32> = line.segments().map(distance).collect();
        (0..distances.len()).min_by(|&a, &b| distances[a].total_cmp(&distances[b]))
    };
    // a ring begins elsewhere: its first run would begin within the bead
    if line.closed && line.vertices.len() > ASIDE && nearest(line) == Some(0) {
        line.vertices.rotate_left(ASIDE);
        anchored.rotate_left(ASIDE);
    }
    let Some(nearest) = nearest(line) else { return };
    let (a, b) = (line.vertices[nearest], line.vertices[(nearest + 1) % line.vertices.len()]);
    let (chord, half) = (b.at - a.at, 0.5 * BEAD_LENGTH);
    let Some(along) = chord.try_normalize() else { return };
    // within the segment, so that the line does not go back
    let middle = (at - a.at).dot(along).clamp(half, (chord.length() - half).max(half));
    let bead = |ahead: f32| Vertex { at: a.at + along * (middle + ahead), width, ..a };
    line.vertices.splice(nearest + 1..nearest + 1, [bead(-half), bead(half)]);
    anchored.splice(nearest + 1..nearest + 1, [true, true]);
}

/// The parts of a line, with what is anchored of it, that lie in none of the holes. An end of the line shorter than
/// `least`, mm, is none of them.
fn outside(line: &Polyline<Vertex>, anchored: &[bool], holes: &[(MmPoint, f32)], least: f32) -> Vec<LinePart> {
    let hole_at = |vertex: &Vertex| holes.iter().find(|(at, radius)| (vertex.at - *at).length() < *radius);
    let Some(inside) = line.vertices.iter().position(|vertex| hole_at(vertex).is_some()) else {
        return vec![LinePart { polyline: line.clone(), anchored: anchored.to_vec() }];
    };
    let count = line.vertices.len();
    // a ring is gone round from a hole to the same hole
    let (start, steps) = if line.closed { (inside, count + 1) } else { (0, count) };
    // where the step from a vertex in a hole to the one outside leaves the hole
    let side = |inner: &Vertex, outer: &Vertex| -> Option<Vertex> {
        let (at, radius) = hole_at(inner)?;
        let away = (outer.at - *at).try_normalize()?;
        Some(Vertex { at: *at + away * *radius, ..*outer })
    };
    let mut parts = vec![LinePart::empty()];
    let mut before: Option<&Vertex> = None;
    for i in (start..start + steps).map(|i| i % count) {
        let vertex = &line.vertices[i];
        let in_hole = |vertex: &Vertex| hole_at(vertex).is_some();
        let Some(part) = parts.last_mut() else { break };
        match (before.filter(|before| in_hole(before)), in_hole(vertex)) {
            (Some(inner), false) => {
                side(inner, vertex).into_iter().for_each(|side| part.push(side, true));
                part.push(*vertex, anchored[i]);
            }
            (None, true) => {
                let side = before.and_then(|before| side(vertex, before));
                side.into_iter().for_each(|side| part.push(side, true));
                parts.push(LinePart::empty());
            }
            (None, false) => part.push(*vertex, anchored[i]),
            // within a hole nothing is drawn
            (Some(_), true) => {}
        }
        before = Some(vertex);
    }
    let last = parts.len() - 1;
    let is_end = |number: usize| !line.closed && (number == 0 || number == last);
    let stays = |(number, part): &(usize, LinePart)| {
        part.anchored.len() > 1 && (!is_end(*number) || part.polyline.length() >= least)
    };
    parts.into_iter().enumerate().filter(stays).map(|(_, part)| part).collect()
}
