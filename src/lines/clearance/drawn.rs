//! The lines that are drawn so far, and what comes too near to them.
//!
//! Two lines may be near only close to a junction: where one of them ends on the other, or where they cross; in a
//! drawing also where both meet a third one at nearly one place ([`super::cluster`]). The length from there until they
//! are apart must be short, which keeps out lines that run into one another at a flat angle:
//!
//! ```text
//!   ----------o----------   far enough          -----------o------   too flat: the
//!             |                                    ___---´´          lower line ends
//!             |  <- not too many clearances     --´                  where it comes near
//! ```

use super::cluster::{are_apart, leaves};
use super::near_line::NearLine;
use super::near_map::{MARK, NearMap};
use super::passage::{Cluster, Junction, Meeting, Passage, SPIKE, TOUCH, back_and_forth};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::walk::arc_between;
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::lines::weight;
use crate::units::{MmPoint, MmRect, MmVector};

/// How far beyond its ends a segment is still crossed, as a share of its length.
const VERTEX: f32 = 1e-3;
/// Segments farther apart than this do not cross, mm, whatever rounding makes of it.
const NOT_CROSSED: f32 = 0.01;

/// How near a vertex is to drawn lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LineState {
    /// Apart from all.
    Free,
    /// Near to lines with which it has a junction close by.
    Joined,
    /// Near to a line with which it has none.
    TooNear,
}

/// One of the drawn lines.
#[derive(Default)]
struct DrawnLine {
    /// Its vertices, with the arc lengths there, mm.
    path: Vec<(f32, MmPoint)>,
    closed: bool,
    /// Where it joins others.
    joins: Vec<Joined>,
}

/// Where a drawn line joins another.
#[derive(Clone, Copy)]
struct Joined {
    /// How far along itself, mm.
    arc: f32,
    /// Number of the other.
    other: u32,
    /// How far along the other, mm.
    other_arc: f32,
    /// Whether the other ends there.
    other_ends: bool,
}

impl DrawnLine {
    fn length(&self) -> f32 {
        self.path.last().map_or(0.0, |(arc, _)| *arc)
    }

    /// The whole length of a closed line, mm.
    fn ring_length(&self) -> Option<f32> {
        self.closed.then(|| self.length())
    }
}

/// The drawn lines.
pub(super) struct DrawnLines<'a> {
    pub(super) params: &'a Params,
    /// The part of the sheet that they are on.
    pub(super) area: MmRect,
    /// All their segments.
    segments: Nearby,
    /// Their ends, of drawings also the corners of rings, as segments without length.
    tips: Nearby,
    lines: Vec<DrawnLine>,
    map: NearMap,
}

impl<'a> DrawnLines<'a> {
    pub(super) fn new(area: MmRect, params: &'a Params) -> Self {
        let reach = params.max_spacing();
        Self {
            params,
            area,
            segments: Nearby::new(area, reach),
            tips: Nearby::new(area, reach),
            lines: Vec::new(),
            map: NearMap::new(area, params.max_clearance()),
        }
    }

    /// Whether a vertex is too near to a line.
    pub(super) fn is_near(&self, vertex: &Vertex, line: u32) -> bool {
        let of_line = self.segments.nearest_of_line(vertex.at, self.params.max_clearance(), line);
        of_line.is_some_and(|(distance, _, segment)| {
            distance < self.params.clearance(0.5 * vertex.width + segment.half_width)
        })
    }

    /// Begins to draw a line. Returns its number. Nothing joins its ends until [`DrawnLines::finish`].
    pub(super) fn begin(&mut self, polyline: &Polyline<Vertex>) -> u32 {
        let line = self.lines.len() as u32;
        self.lines.push(DrawnLine::default());
        self.go_on(polyline, 0, line);
        line
    }

    /// Draws what was added to a line after vertex `from`.
    pub(super) fn go_on(&mut self, polyline: &Polyline<Vertex>, from: usize, line: u32) {
        let arcs = polyline.arc_lengths();
        if let Some(first) = polyline.vertices.get(from) {
            self.map.mark(first.at);
        }
        for (i, (a, b)) in polyline.segments().enumerate().skip(from) {
            self.segments.insert(segment(a, b, i, line, arcs[i]));
            if i + 1 == polyline.segment_count() || (arcs[i] / MARK) as usize != (arcs[i + 1] / MARK) as usize {
                self.map.mark(b.at);
            }
        }
        let path = arcs.into_iter().zip(polyline.path().map(|vertex| vertex.at)).collect();
        self.lines[line as usize] = DrawnLine { path, closed: polyline.closed, joins: Vec::new() };
    }

    /// The junctions of a line that was begun, with the other lines.
    pub(super) fn junctions_with_others(&self, polyline: &Polyline<Vertex>, line: u32) -> Vec<Junction> {
        self.passage_among(polyline.view(), |other| other != line).junctions
    }

    /// A line is complete, and has these junctions with the other lines: others may join its ends, or its corners if
    /// it is a ring of a drawing.
    pub(super) fn finish(&mut self, polyline: &Polyline<Vertex>, line: u32, junctions: &[Junction]) {
        if self.params.of_drawing {
            for &Junction { arc, line: other, line_arc, meeting, .. } in junctions {
                let other_ends = meeting == Meeting::LineEnds;
                self.lines[line as usize].joins.push(Joined { arc, other, other_arc: line_arc, other_ends });
                let other_ends = meeting == Meeting::PolylineEnds;
                let joined = Joined { arc: line_arc, other: line, other_arc: arc, other_ends };
                self.lines[other as usize].joins.push(joined);
            }
        }
        let path = &self.lines[line as usize].path;
        let places: Vec<usize> = match polyline.view().goes_round() {
            true if self.params.of_drawing => polyline.view().corners_of_ring(),
            true => Vec::new(),
            false => [0, path.len().saturating_sub(1)].to_vec(),
        };
        for &(arc, at) in places.iter().filter_map(|&i| path.get(i)) {
            self.tips.insert(Segment { a: at, b: at, half_width: 0.0, line, index: 0, arc });
        }
    }

    /// Whether any line may be too near to this point.
    pub(super) fn may_be_near(&self, at: MmPoint) -> bool {
        self.map.may_be_near(at)
    }

    /// The junctions of a polyline with the lines.
    pub(super) fn passage(&self, polyline: PolylineRef<'_, Vertex>) -> Passage {
        self.passage_among(polyline, |_| true)
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
            let (ends, line_ends) = (junction.is_own_end(), joined.other_ends);
            let other = &self.lines[joined.other as usize];
            let ways = leaves(&own, polyline.closed, junction.arc, spacing);
            let are_apart = || are_apart(ways, leaves(&other.path, other.closed, joined.other_arc, spacing));
            let (arc, line, line_arc) = (junction.arc, joined.other, joined.other_arc);
            (apart <= spacing && (ends || line_ends) && are_apart()).then_some(Cluster {
                arc,
                ends,
                line,
                line_arc,
                line_ends,
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
            self.segments.nearest_of_line(vertex.at, reach, a.line).is_some()
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
        let ends = a.is_own_end() || b.is_own_end();
        to - from > SPIKE
            && line().all(|at| vertices.iter().any(|vertex| is_near(at, vertex)))
            && (!ends || line().any(near_again))
    }

    /// Whether a polyline that joins a line comes so near to it again, before it has been apart from it, that the two
    /// may cross once they are simplified.
    fn grazes(&self, junction: &Junction, vertices: &[Vertex], passage: &Passage) -> bool {
        let grazing = |(vertex, arc): (&Vertex, &f32)| {
            let reach = self.params.clearance(0.5 * vertex.width);
            let (distance, ..) = self.segments.nearest_of_line(vertex.at, reach, junction.line)?;
            Some((arc - junction.arc).abs() > SPIKE && distance <= self.params.play())
        };
        let at = passage.arcs.partition_point(|&arc| arc < junction.arc).min(vertices.len());
        let along = || vertices.iter().zip(&passage.arcs);
        let after = along().skip(at).map_while(grazing).any(|grazes| grazes);
        after || along().take(at).rev().map_while(grazing).any(|grazes| grazes)
    }

    /// The state of every vertex of a polyline.
    pub(super) fn states(&self, polyline: &Polyline<Vertex>) -> Vec<LineState> {
        self.states_on(polyline, &self.passage(polyline.view()))
    }

    /// [`DrawnLines::states`] of one with this passage.
    pub(super) fn states_on(&self, polyline: &Polyline<Vertex>, passage: &Passage) -> Vec<LineState> {
        let state = |(i, vertex): (usize, &Vertex)| self.state(vertex, passage.arcs[i], passage);
        polyline.vertices.iter().enumerate().map(state).collect()
    }

    /// The state of a vertex of a polyline.
    fn state(&self, vertex: &Vertex, arc: f32, passage: &Passage) -> LineState {
        let mut state = LineState::Free;
        self.each_near(vertex, arc, passage, |near| {
            state = if near.joins() && state != LineState::TooNear { LineState::Joined } else { LineState::TooNear };
            state != LineState::TooNear
        });
        state
    }

    /// Calls `visit` with every segment that is nearer to a vertex of a polyline than two lines may be, as long as
    /// `visit` returns true.
    pub(super) fn each_near(
        &self,
        vertex: &Vertex,
        arc: f32,
        passage: &Passage,
        visit: impl FnMut(&NearLine<'_>) -> bool,
    ) {
        self.each_near_among(vertex, arc, passage, |_| true, visit);
    }

    /// [`DrawnLines::each_near`] among the lines of which `is_other` is true.
    pub(super) fn each_near_among(
        &self,
        vertex: &Vertex,
        arc: f32,
        passage: &Passage,
        is_other: impl Fn(u32) -> bool,
        mut visit: impl FnMut(&NearLine<'_>) -> bool,
    ) {
        if !self.may_be_near(vertex.at) {
            return;
        }
        let half = 0.5 * vertex.width;
        let mut on = true;
        self.segments.around_point(vertex.at, self.params.max_clearance(), |segment| {
            if !on || !is_other(segment.line) {
                return;
            }
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let clearance = self.params.clearance(half + segment.half_width);
            if distance >= clearance {
                return;
            }
            let approach = self.params.approach(half, segment.half_width);
            let cluster_approach = self.params.cluster_approach(half, segment.half_width);
            let line_arc = segment.arc + (at - segment.a).length();
            let of_drawing = self.params.of_drawing;
            let line_ring_length = self.lines[segment.line as usize].ring_length();
            let (away, missing) = (vertex.at - at, clearance - distance);
            let near = NearLine {
                segment,
                at,
                away,
                distance,
                clearance,
                missing,
                line_arc,
                approach,
                cluster_approach,
                arc,
                passage,
                line_ring_length,
                of_drawing,
            };
            on = visit(&near);
        });
    }

    /// Puts the ends of a polyline that touch lines exactly on them.
    pub(super) fn snap(&self, polyline: &mut Polyline<Vertex>) {
        if let ([first, .., last], false) = (&mut polyline.vertices[..], polyline.closed) {
            for end in [first, last] {
                let on_line = || self.segments.nearest(end.at, TOUCH, |_| true).map(|(_, at, _)| at);
                end.at = self.nearest_tip(end.at, TOUCH).or_else(on_line).unwrap_or(end.at);
            }
        }
    }

    /// Whether a place lies on a line.
    pub(super) fn is_on_line(&self, at: MmPoint) -> bool {
        self.segments.nearest(at, TOUCH, |_| true).is_some()
    }

    /// The nearest end of a line within `reach`.
    pub(super) fn nearest_tip(&self, at: MmPoint, reach: f32) -> Option<MmPoint> {
        self.tips.nearest(at, reach, |_| true).map(|(_, at, _)| at)
    }

    /// All segments of lines.
    pub(super) fn segments(&self) -> &Nearby {
        &self.segments
    }
}

/// The segment of a line between two vertices.
pub(super) fn segment(a: &Vertex, b: &Vertex, i: usize, line: u32, arc: f32) -> Segment {
    let half_width = 0.5 * weight::between(a, b);
    Segment { a: a.at, b: b.at, half_width, line, index: i as u32, arc }
}

#[cfg(test)]
mod tests;
