//! A line that was cut is extended along its old path to what it would soon have joined.

use super::drawn::DrawnLines;
use super::self_distance::is_bend;
use crate::geom::nearby::Segment;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::walk::heading_of_end;
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::params::HEADING;
use crate::lines::vertex::Vertex;
use crate::lines::{lead_on, links};
use crate::units::{MmPoint, MmVector};

/// A line whose path comes this near to another, in join gaps, may be extended to it.
const MEETS: f32 = 0.5;
/// Least cosine between the heading of a line and the direction to the other line to which it is extended: it does not
/// turn aside for it.
const AHEAD_COSINE: f32 = 0.5;
/// The direction to the other line is asked for where the distance to it is longer than this, mm; a shorter one has no
/// direction worth asking for.
const TURN: f32 = 0.75;
/// A line that would join another this near to where a third one does is extended to the same point, mm.
const SNAP: f32 = 1.5;
/// Points nearer than this, mm, are one.
const SAME: f32 = 1e-3;

/// What is extended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Extended {
    /// A piece that is not drawn yet. Where its contour ends, it is extended to what it points at.
    Piece,
    /// The line of this number, which is drawn already: it may join itself as well.
    Line(u32),
}

/// Where an extension ends.
#[derive(Clone, Copy)]
struct ExtensionTarget {
    at: MmPoint,
    /// How many vertices of the path come before it.
    count: usize,
    /// Distance from the last of them, mm.
    distance: f32,
}

/// A line that is being extended.
struct Extension<'a> {
    body: &'a [Vertex],
    start: Vertex,
    /// Length of the body, mm.
    length: f32,
    what: Extended,
    drawn: &'a DrawnLines<'a>,
}

/// The vertices that extend a line along its old `path`, to a line that it joins soon and at no flat angle.
pub(super) fn extension(
    body: &[Vertex],
    path: &[Vertex],
    what: Extended,
    drawn: &DrawnLines<'_>,
) -> Option<Vec<Vertex>> {
    let start = *body.last()?;
    let length = PolylineRef { vertices: body, closed: false }.length();
    let extension = Extension { body, start, length, what, drawn };
    let (mut added, target) = extension.follow(path)?;
    added.truncate(target.count);
    let at = extension.snapped(target.at, &mut added);
    if extension.closes(at) || !extension.reaches(at, &added) {
        return None;
    }
    let tip = *added.last().unwrap_or(&start);
    added.extend(lead_on::straight(&tip, at));
    extension.keeps_clear(&added).then_some(added)
}

/// A line that is drawn as a link or not at all ([`links`](crate::lines::links)), extended to what its ends point at
/// where they do not lie on a line already; none if it cannot be a link, or one of them leads to no line.
pub(super) fn as_link(line: Polyline<Vertex>, drawn: &DrawnLines<'_>) -> Option<Polyline<Vertex>> {
    if !links::can_be(&line, drawn.params) {
        return None;
    }
    let mut vertices = line.vertices;
    for _end in 0..2 {
        let tip = vertices.last()?.at;
        if !drawn.is_on_line(tip) {
            vertices.extend(extension(&vertices, &[], Extended::Piece, drawn)?);
        }
        vertices.reverse();
    }
    Some(Polyline::open(vertices))
}

impl Extension<'_> {
    /// Follows the path until it crosses a line or has come nearest to one, no farther than an approach may be long.
    /// Gives the vertices passed, and the target.
    fn follow(&self, path: &[Vertex]) -> Option<(Vec<Vertex>, ExtensionTarget)> {
        let (longest, join_gap) = (self.drawn.params.min_approach(), self.drawn.params.join_gap);
        let mut passed: Vec<Vertex> = Vec::new();
        let mut arc = 0.0;
        let mut target: Option<ExtensionTarget> = None;
        for vertex in path {
            let last = passed.last().unwrap_or(&self.start).at;
            if let Some(at) = self.first_crossing(last, vertex.at, arc) {
                target = Some(ExtensionTarget { at, count: passed.len(), distance: 0.0 });
                break;
            }
            arc += (vertex.at - last).length();
            if arc > longest {
                break;
            }
            passed.push(*vertex);
            let reach = target.map_or(MEETS * join_gap, |target| target.distance);
            if let Some((distance, at)) = self.nearest(vertex.at, arc, reach) {
                target = Some(ExtensionTarget { at, count: passed.len(), distance });
                if distance < SAME {
                    break;
                }
            }
        }
        if target.is_none() && self.what == Extended::Piece && arc <= longest {
            target = self.pointed_at(&passed);
        }
        Some((passed, target?))
    }

    /// Where the step from `from` to `to`, which begins at `arc` beyond the body, first crosses a line.
    fn first_crossing(&self, from: MmPoint, to: MmPoint, arc: f32) -> Option<MmPoint> {
        let mut hit: Option<(f32, MmPoint)> = None;
        self.drawn.segments.around(from.min(to), from.max(to), 0.0, |segment| {
            if let Some(at) = crossing((from, to), (segment.a, segment.b)) {
                let distance = (at - from).length();
                if hit.is_none_or(|(least, _)| distance < least)
                    && !self.closes_small_loop(segment, arc + distance, 0.0)
                {
                    hit = Some((distance, at));
                }
            }
        });
        hit.map(|(_, at)| at)
    }

    /// The point of a line that is nearest to a vertex, within `reach`.
    fn nearest(&self, vertex: MmPoint, arc: f32, reach: f32) -> Option<(f32, MmPoint)> {
        let near = self.drawn.segments.nearest(vertex, reach, |segment| {
            !self.closes_small_loop(segment, arc, nearest_on_segment(vertex, segment.a, segment.b).0)
        });
        near.map(|(distance, at, _)| (distance, at))
    }

    /// What the contour points at where it ends.
    fn pointed_at(&self, passed: &[Vertex]) -> Option<ExtensionTarget> {
        let tip = passed.last().unwrap_or(&self.start).at;
        let heading = self.heading(passed)?;
        let at = lead_on::ahead(tip, heading, &self.drawn.segments, self.drawn.params.join_gap, |_| true)?;
        Some(ExtensionTarget { at, count: passed.len(), distance: (at - tip).length() })
    }

    /// The target, or the end of a line that lies close by; vertices that are as close to that are taken away.
    fn snapped(&self, at: MmPoint, added: &mut Vec<Vertex>) -> MmPoint {
        let Some(tip) = self.drawn.nearest_tip(at, SNAP) else { return at };
        while added.last().is_some_and(|vertex| (vertex.at - tip).length() < SNAP) {
            added.pop();
        }
        tip
    }

    /// Whether the extension would close the ring that was cut open because its sides are too near.
    fn closes(&self, at: MmPoint) -> bool {
        self.what != Extended::Piece && self.body.first().is_some_and(|first| (first.at - at).length() < SNAP)
    }

    /// Whether the last step over to the target is short enough and does not turn aside.
    fn reaches(&self, at: MmPoint, added: &[Vertex]) -> bool {
        let over = at - added.last().unwrap_or(&self.start).at;
        let turns = || self.heading(added).is_some_and(|heading| over.dot(heading) < AHEAD_COSINE * over.length());
        over.length() <= self.drawn.params.join_gap && (over.length() <= TURN || !turns())
    }

    /// Whether the extension is near to no line but those that it joins, and not too long.
    fn keeps_clear(&self, added: &[Vertex]) -> bool {
        let mut whole = vec![self.start];
        whole.extend(added);
        let passage = self.drawn.arriving(&whole);
        let joins = whole.iter().zip(&passage.arcs).skip(1).all(|(vertex, &arc)| {
            let mut fits = true;
            self.drawn.each_near(vertex, arc, &passage, |near| {
                fits = near.joins() || self.is_own_bend(near.segment, arc, near.distance);
                fits
            });
            fits
        });
        joins && passage.arcs.last().is_some_and(|&arc| arc <= self.drawn.params.min_approach())
    }

    /// Whether a segment of the line itself is near only because the line bends there.
    fn is_own_bend(&self, segment: &Segment, arc: f32, distance: f32) -> bool {
        self.what == Extended::Line(segment.line) && is_bend(self.length + arc - segment.arc, distance)
    }

    /// Whether the line, extended to a segment of its own, would have no loop that a finger finds.
    fn closes_small_loop(&self, segment: &Segment, arc: f32, distance: f32) -> bool {
        let loop_length = self.length + arc - segment.arc;
        self.what == Extended::Line(segment.line) && is_bend(loop_length - self.drawn.params.max_stub(), distance)
    }

    /// The direction of the line that goes on with `added`.
    fn heading(&self, added: &[Vertex]) -> Option<MmVector> {
        heading_of_end(added.iter().rev().chain(self.body.iter().rev()).map(|vertex| vertex.at), HEADING)
    }
}

#[cfg(test)]
mod tests;
