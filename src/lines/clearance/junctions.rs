//! Where a line meets those that are drawn: its crossings, the ends of either that lie on the other, and which of these
//! are junctions. Two that cross without being apart before they cross again only wind round one another.

use std::collections::BTreeMap;

use super::cluster::{AtThird, Cluster, meet};
use super::drawn::{DrawnLine, DrawnLines, Joined};
use super::passage::{Junction, Meeting, Passage, SPIKE, TOUCH, back_and_forth};
use crate::geom::nearby::Segment;
use crate::geom::polygon::{area, roundness};
use crate::geom::polyline::{Polyline, PolylineRef, length};
use crate::geom::walk::arc_between;
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmVector};

/// How far beyond its ends a segment is still crossed, as a share of its length.
const VERTEX: f32 = 1e-3;
/// Segments farther apart than this do not cross, mm, whatever rounding makes of it.
const NOT_CROSSED: f32 = 0.01;

/// A circle and a line touch where the middles of both are no farther apart than this, mm: the width of the least line
/// that profiles of paper have, so that the ink of any two lines meets.
const CONTACT: f32 = 0.75;
/// How round a circle is at least: an ellipse of 3 to 2 has 0.94, a square 0.79.
const CIRCLE: f32 = 0.95;

/// So many vertices before and after the last one are looked at first.
const BESIDE_LAST: usize = 8;

/// Whether a path that comes back to its first place is a circle.
fn is_circle(path: impl Iterator<Item = MmPoint>) -> bool {
    let points: Vec<MmPoint> = path.collect();
    roundness(area(&points), length(&points)) >= CIRCLE
}

impl DrawnLines<'_> {
    /// The junctions of a polyline with the lines.
    pub(super) fn passage(&self, polyline: PolylineRef<'_, Vertex>) -> Passage {
        self.passage_among(polyline, |_| true)
    }

    /// The junctions of a line that was begun, with the other lines.
    pub(super) fn junctions_with_others(&self, polyline: &Polyline<Vertex>, line: u32) -> Vec<Junction> {
        self.passage_among(polyline.view(), |other| other != line).junctions
    }

    /// The junctions of a polyline with those of the lines of which `is_other` is true.
    pub(super) fn passage_among(&self, polyline: PolylineRef<'_, Vertex>, is_other: impl Fn(u32) -> bool) -> Passage {
        let PolylineRef { vertices, closed } = polyline;
        let arcs = polyline.arc_lengths();
        let length = arcs.last().copied().unwrap_or(0.0);
        let (mut crossings, mut ends) = (Vec::new(), Vec::new());
        for (i, (a, b)) in polyline.segments().enumerate() {
            if self.may_be_near(a.at) {
                self.add_crossings((a.at, b.at), arcs[i], &is_other, &mut crossings);
                self.add_touching_tips((a.at, b.at), arcs[i], &is_other, &mut ends);
            }
        }
        let mut own_ends = Vec::new();
        if let (Some(first), Some(last), false) = (vertices.first(), vertices.last(), closed) {
            for (at, arc) in [(first.at, 0.0), (last.at, length)] {
                self.add_ends_on_lines(at, arc, &is_other, &mut own_ends);
            }
        }
        if self.params.of_drawing {
            // of one that will be drawn as a ring the first vertex is at its end as well
            let again = |i: usize| (i == 0 && !closed).then_some(length);
            let corners = polyline.corners_of_ring().into_iter().filter(|i| self.may_be_near(vertices[*i].at));
            for (at, arc) in corners.flat_map(|i| [Some(arcs[i]), again(i)].map(|arc| (vertices[i].at, arc))) {
                arc.into_iter().for_each(|arc| self.add_ends_on_lines(at, arc, &is_other, &mut ends));
            }
        }
        // where one ends on the other beside a crossing they will not be drawn as crossing
        crossings.retain(|crossing| !ends.iter().chain(&own_ends).any(|end| end.is_beside(crossing)));
        let contacts = match self.params.of_drawing {
            true => self.contacts(polyline, &arcs, &is_other),
            false => Vec::new(),
        };
        // ends in one place join nothing: the line will be drawn as a ring
        if !polyline.goes_round() {
            ends.append(&mut own_ends);
        }
        let ring_length = closed.then_some(length);
        let back_and_forth = back_and_forth(&crossings, ring_length);
        crossings.append(&mut ends);
        let mut passage = Passage { arcs, ring_length, junctions: crossings, clusters: Vec::new() };
        let joins =
            |(i, at): (usize, &Junction)| !back_and_forth.contains(&i) && !self.stays_beside(at, vertices, &passage);
        passage.junctions = passage.junctions.iter().enumerate().filter(|at| joins(*at)).map(|(_, at)| *at).collect();
        let known = passage.junctions.len();
        for contact in contacts {
            if passage.junctions[..known].iter().all(|junction| junction.line != contact.line) {
                passage.junctions.push(contact);
            }
        }
        passage.clusters = self.clusters(&passage.junctions, polyline, &passage.arcs);
        passage
    }

    /// The junctions of a path whose last vertex ends on lines: it joins all that pass there.
    pub(super) fn arriving(&self, path: &[Vertex]) -> Passage {
        let arcs = PolylineRef { vertices: path, closed: false }.arc_lengths();
        let mut junctions = Vec::new();
        if let (Some(&arc), Some(tip)) = (arcs.last(), path.last()) {
            self.add_ends_on_lines(tip.at, arc, |_| true, &mut junctions);
        }
        let clusters = self.clusters(&junctions, PolylineRef { vertices: path, closed: false }, &arcs);
        Passage { arcs, ring_length: None, junctions, clusters }
    }

    /// The lines that others join near to where a polyline does, beside which it does not run.
    fn clusters(&self, junctions: &[Junction], polyline: PolylineRef<'_, Vertex>, arcs: &[f32]) -> Vec<Cluster> {
        let joins = |junction: &Junction| {
            let third = &self.lines[junction.line as usize];
            third.joins.iter().map(move |joined| (third, joined))
        };
        if junctions.iter().all(|junction| joins(junction).next().is_none()) {
            return Vec::new();
        }
        let spacing = self.params.cluster_spacing();
        let own: Vec<(f32, MmPoint)> = arcs.iter().copied().zip(polyline.path().map(|vertex| vertex.at)).collect();
        let cluster = |junction: &Junction, third: &DrawnLine, joined: &Joined| {
            let apart = arc_between(joined.arc, junction.line_arc, third.ring_length());
            let line = &self.lines[joined.other as usize];
            let one = AtThird { path: &own, closed: polyline.closed, arc: junction.arc, ends: junction.is_own_end() };
            let other =
                AtThird { path: &line.path, closed: line.closed, arc: joined.other_arc, ends: joined.other_ends };
            meet(one, other, apart, spacing).then_some(Cluster {
                arc: one.arc,
                ends: one.ends,
                line: joined.other,
                line_arc: other.arc,
                line_ends: other.ends,
                apart,
            })
        };
        let of = |junction| joins(junction).filter_map(move |(third, joined)| cluster(junction, third, joined));
        junctions.iter().flat_map(of).collect()
    }

    /// Adds the junctions where the segment `a`-`b` of a polyline, which begins at `arc`, crosses lines.
    fn add_crossings(
        &self,
        (a, b): (MmPoint, MmPoint),
        arc: f32,
        is_other: impl Fn(u32) -> bool,
        junctions: &mut Vec<Junction>,
    ) {
        let reach = (1.0 + 2.0 * VERTEX) * ((b - a).length() + self.segments.longest()) + NOT_CROSSED;
        self.segments.around(a.min(b), a.max(b), 0.0, |segment| {
            // most are too far away to cross it
            if (segment.a - a).square_length() > reach * reach || !is_other(segment.line) {
                return;
            }
            // longer by a rounding: lines that cross at a vertex, as those of drawings do, cross all the same
            let (own, other) = ((b - a) * VERTEX, (segment.b - segment.a) * VERTEX);
            // a line that ends on another may, by a rounding, cross it; one that ends hardly beyond it may, once both
            // are simplified, end before it
            if let Some(at) = crossing((a - own, b + own), (segment.a - other, segment.b + other))
                && self.tips.nearest(at, 2.0 * TOUCH, |tip| tip.line == segment.line).is_none()
            {
                let arc = arc + (at - a).length();
                let line_arc = segment.arc + (at - segment.a).length();
                let side = if (b - a).cross(segment.b - segment.a) > 0.0 { 1 } else { -1 };
                let along = (segment.b - segment.a).try_normalize().unwrap_or_default();
                junctions.push(Junction {
                    arc,
                    at,
                    line: segment.line,
                    line_arc,
                    along,
                    meeting: Meeting::Cross(side),
                });
            }
        });
    }

    /// Adds the junctions where lines end on the segment `a`-`b` of a polyline, which begins at `arc`.
    fn add_touching_tips(
        &self,
        (a, b): (MmPoint, MmPoint),
        arc: f32,
        is_other: impl Fn(u32) -> bool,
        junctions: &mut Vec<Junction>,
    ) {
        self.tips.around(a.min(b), a.max(b), TOUCH, |tip| {
            let (distance, at) = nearest_on_segment(tip.a, a, b);
            if distance <= TOUCH && is_other(tip.line) {
                let arc = arc + (at - a).length();
                junctions.push(Junction {
                    arc,
                    at: tip.a,
                    line: tip.line,
                    line_arc: tip.arc,
                    along: MmVector::zero(),
                    meeting: Meeting::LineEnds,
                });
            }
        });
    }

    /// Adds the junctions of an end of a polyline with the lines that it lies on.
    fn add_ends_on_lines(&self, at: MmPoint, arc: f32, is_other: impl Fn(u32) -> bool, junctions: &mut Vec<Junction>) {
        self.segments.around_point(at, TOUCH, |segment| {
            junctions.extend(Junction::of_end(at, arc, segment).filter(|end| is_other(end.line)));
        });
    }

    /// Where a circle touches lines, or a line a circle, with the sides of both, without crossing, as a wheel stands on
    /// the road: on both sides of that place the polyline soon is apart.
    fn contacts(
        &self,
        polyline: PolylineRef<'_, Vertex>,
        arcs: &[f32],
        is_other: impl Fn(u32) -> bool,
    ) -> Vec<Junction> {
        let PolylineRef { vertices, closed } = polyline;
        // in pixels, where noise has circles beside lines anywhere, none is meant
        if !vertices.iter().all(|vertex| vertex.source.is_exact()) {
            return Vec::new();
        }
        let is_round = closed && is_circle(polyline.path().map(|vertex| vertex.at));
        let mut nearest: BTreeMap<u32, (f32, usize, Segment)> = BTreeMap::new();
        for (i, vertex) in vertices.iter().enumerate().filter(|(_, vertex)| self.may_be_near(vertex.at)) {
            self.segments.around_point(vertex.at, CONTACT, |segment| {
                let distance = nearest_on_segment(vertex.at, segment.a, segment.b).0;
                let may_touch = is_round || self.lines[segment.line as usize].closed;
                let is_nearer = || nearest.get(&segment.line).is_none_or(|(least, ..)| distance < *least);
                if distance <= CONTACT && may_touch && is_other(segment.line) && is_nearer() {
                    nearest.insert(segment.line, (distance, i, *segment));
                }
            });
        }
        let (count, length) = (vertices.len(), arcs.last().copied().unwrap_or(0.0));
        let leaves = |from: usize, line: u32, step: isize| {
            let index = |k: usize| (from as isize + step * k as isize).rem_euclid(count as isize) as usize;
            let steps = match (closed, step > 0) {
                (true, _) => count,
                (false, true) => count - from,
                (false, false) => from + 1,
            };
            let ring_length = closed.then_some(length);
            let approach = |vertex: &Vertex| self.params.approach(0.5 * vertex.width, 0.5 * self.params.width_max);
            let mut near = (0..steps).map(index);
            let first_apart = near.find(|&i| !self.is_near(&vertices[i], line));
            first_apart.is_some_and(|i| arc_between(arcs[from], arcs[i], ring_length) <= approach(&vertices[i]))
        };
        // what lies before an end is no side
        let is_inner =
            |arc: f32, length: f32| (self.params.max_clearance()..=length - self.params.max_clearance()).contains(&arc);
        let contact = |(line, (_, i, segment)): (u32, (f32, usize, Segment))| {
            let touched = nearest_on_segment(vertices[i].at, segment.a, segment.b).1;
            let along = (segment.b - segment.a).try_normalize().unwrap_or_default();
            let (line_arc, of) = (segment.arc + (touched - segment.a).length(), &self.lines[line as usize]);
            let are_inner = (closed || is_inner(arcs[i], length)) && (of.closed || is_inner(line_arc, of.length()));
            let meeting = Meeting::PolylineEnds;
            let are_round = is_round || is_circle(of.path.iter().map(|(_, at)| *at));
            let junction = Junction { arc: arcs[i], at: vertices[i].at, line, line_arc, along, meeting };
            (are_inner && are_round && leaves(i, line, 1) && leaves(i, line, -1)).then_some(junction)
        };
        nearest.into_iter().filter_map(contact).collect()
    }

    /// Whether a polyline that joins a line does so again before it has been apart from it, or the line from the
    /// polyline: the two wind round one another.
    fn stays_beside(&self, junction: &Junction, vertices: &[Vertex], passage: &Passage) -> bool {
        let again = |other: &&Junction| other.line == junction.line && (other.arc - junction.arc).abs() > SPIKE;
        let mut others = passage.junctions.iter().filter(again);
        self.grazes(junction, vertices, passage)
            || others.any(|other| {
                self.follows([junction, other], vertices, passage)
                    || self.is_followed([junction, other], vertices, passage)
            })
    }

    /// Whether a polyline is near to a line everywhere between two of its junctions with it.
    fn follows(&self, [a, b]: [&Junction; 2], vertices: &[Vertex], passage: &Passage) -> bool {
        let index = |arc: f32| passage.arcs.partition_point(|&other| other < arc).min(vertices.len());
        let between = &vertices[index(a.arc.min(b.arc))..index(a.arc.max(b.arc))];
        between.iter().all(|vertex| {
            let reach = self.params.clearance(0.5 * vertex.width);
            self.segments.is_near_line(vertex.at, reach, a.line)
        })
    }

    /// Whether a line is near to a polyline everywhere between two of their junctions. All of the polyline is looked
    /// at, as it may be near the line beyond the two. Where it ends at one of them and has just come from there, as the
    /// legs of a bar on its axis, it does not count.
    fn is_followed(&self, [a, b]: [&Junction; 2], vertices: &[Vertex], passage: &Passage) -> bool {
        let (from, to) = (a.line_arc.min(b.line_arc), a.line_arc.max(b.line_arc));
        let path = &self.lines[a.line as usize].path;
        let line = || path.iter().filter(|(arc, _)| (from..to).contains(arc)).map(|(_, at)| *at);
        let is_near =
            |at: MmPoint, vertex: &Vertex| (vertex.at - at).length() < self.params.clearance(0.5 * vertex.width);
        let is_apart = |vertex: &Vertex, arc: f32| {
            let approach = self.params.approach(0.5 * vertex.width, 0.5 * self.params.width_max);
            passage.between(arc, a.arc) > approach && passage.between(arc, b.arc) > approach
        };
        let near_again =
            |at| vertices.iter().zip(&passage.arcs).any(|(vertex, &arc)| is_near(at, vertex) && is_apart(vertex, arc));
        // the line goes on beside the vertex that the last place of it was near to
        let mut last = 0_usize;
        let is_near_any = |at: MmPoint| {
            let mut around = last.saturating_sub(BESIDE_LAST)..(last + BESIDE_LAST).min(vertices.len());
            let nearby = around.find(|&i| is_near(at, &vertices[i]));
            let found = nearby.or_else(|| vertices.iter().position(|vertex| is_near(at, vertex)));
            last = found.unwrap_or(last);
            found.is_some()
        };
        let ends = a.is_own_end() || b.is_own_end();
        to - from > SPIKE && line().all(is_near_any) && (!ends || line().any(near_again))
    }

    /// Whether a polyline that joins a line comes so near to it again, before it has been apart from it, that the two
    /// may cross once they are simplified.
    fn grazes(&self, junction: &Junction, vertices: &[Vertex], passage: &Passage) -> bool {
        let grazing = |(vertex, arc): (&Vertex, &f32)| {
            let is_within = |reach: f32| self.segments.is_near_line(vertex.at, reach, junction.line);
            let grazes = (arc - junction.arc).abs() > SPIKE && is_within(self.params.play());
            (grazes || is_within(self.params.clearance(0.5 * vertex.width))).then_some(grazes)
        };
        let at = passage.arcs.partition_point(|&arc| arc < junction.arc).min(vertices.len());
        let along = || vertices.iter().zip(&passage.arcs);
        let after = along().skip(at).map_while(grazing).any(|grazes| grazes);
        after || along().take(at).rev().map_while(grazing).any(|grazes| grazes)
    }
}

#[cfg(test)]
mod tests;
