//! The lines that are drawn so far, and what comes too near to them.
//!
//! Two lines may be near only on the way to a junction: where one of them ends on the other, or where they cross. The
//! way from there until they are apart must be short, which keeps out lines that run into one another at a flat angle:
//!
//! ```text
//!   ----------o----------   far enough          -----------o------   too flat: the
//!             |                                    ___---´´          lower line ends
//!             |  <- at most 1.7 clearances      --´                  where it comes near
//! ```

use super::near_map::{MARK, NearMap};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::lines::weight;
use crate::units::{MmPoint, MmRect, MmVector};

/// A line ends on another if it comes this near, mm: twice the tolerance of simplification, so that it is drawn so (see
/// [`super::anchor`], which gives the other a vertex there), and far less than a finger notices.
pub(super) const TOUCH: f32 = 0.1;

/// How far beyond its ends a segment is still crossed, as a share of its length.
const VERTEX: f32 = 1e-3;

/// A junction of a polyline with a drawn line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Junction {
    /// How far along the polyline, mm.
    pub(super) arc: f32,
    pub(super) at: MmPoint,
    /// Number of the line.
    pub(super) line: u32,
    /// How far along the line, mm.
    line_arc: f32,
    /// Whether it is an end of the line that lies here.
    tip: bool,
}

impl Junction {
    /// The junction of a polyline that ends at `at` with the line of a segment, if it ends on that.
    fn of_end(at: MmPoint, arc: f32, segment: &Segment) -> Option<Self> {
        let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
        let line_arc = segment.arc + (touched - segment.a).length();
        (distance <= TOUCH).then_some(Self { arc, at, line: segment.line, line_arc, tip: false })
    }
}

/// How near a vertex is to drawn lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// Apart from all.
    Free,
    /// Near to lines with which it has a junction close by.
    Joined,
    /// Near to a line with which it has none.
    TooNear,
}

/// A segment that is near to a vertex.
pub(super) struct Near<'a> {
    pub(super) segment: &'a Segment,
    /// From the nearest point of the segment to the vertex.
    pub(super) away: MmVector,
    /// From centre line to centre line, mm.
    pub(super) distance: f32,
    /// What the distance falls short by, mm.
    pub(super) missing: f32,
    /// Whether the two lines have a junction close by.
    pub(super) joins: bool,
}

/// A polyline among the drawn lines.
pub(super) struct Passage {
    /// Arc length at each vertex, mm.
    pub(super) arcs: Vec<f32>,
    /// Its whole length if it is closed.
    round: Option<f32>,
    /// Its junctions with the lines.
    pub(super) junctions: Vec<Junction>,
}

impl Passage {
    /// Length along the polyline between two arcs, of a ring the shorter way round, mm.
    pub(super) fn between(&self, s: f32, t: f32) -> f32 {
        let apart = (s - t).abs();
        self.round.map_or(apart, |round| apart.min(round - apart))
    }
}

/// The drawn lines.
pub(super) struct DrawnLines<'a> {
    pub(super) params: &'a Params,
    /// All their segments.
    segments: Nearby,
    /// Their ends, as segments without length; `index` is 1 at the end, 0 at the start.
    tips: Nearby,
    /// Vertices of each, with the arc lengths there, mm.
    lines: Vec<Vec<(f32, MmPoint)>>,
    map: NearMap,
}

impl<'a> DrawnLines<'a> {
    pub(super) fn new(area: MmRect, params: &'a Params) -> Self {
        let reach = params.max_spacing();
        Self {
            params,
            segments: Nearby::new(area, reach),
            tips: Nearby::new(area, reach),
            lines: Vec::new(),
            map: NearMap::new(area, params.max_clearance()),
        }
    }

    /// Whether a vertex is too near to a line.
    pub(super) fn is_near(&self, vertex: &Vertex, line: u32) -> bool {
        let of_line = self.segments.nearest(vertex.at, self.params.max_clearance(), |segment| segment.line == line);
        of_line.is_some_and(|(distance, _, segment)| {
            distance < self.params.clearance(0.5 * vertex.width + segment.half_width)
        })
    }

    /// Begins to draw a line. Returns its number. Nothing joins its ends until [`DrawnLines::finish`].
    pub(super) fn begin(&mut self, polyline: &Polyline<Vertex>) -> u32 {
        let line = self.lines.len() as u32;
        self.lines.push(Vec::new());
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
        self.lines[line as usize] = arcs.into_iter().zip(polyline.path().map(|vertex| vertex.at)).collect();
    }

    /// A line is complete: others may join its ends.
    pub(super) fn finish(&mut self, polyline: &Polyline<Vertex>, line: u32) {
        let (Some(first), Some(last), false) = (polyline.vertices.first(), polyline.vertices.last(), polyline.closed)
        else {
            return;
        };
        let length = self.lines[line as usize].last().map_or(0.0, |(arc, _)| *arc);
        for (at, index, arc) in [(first.at, 0, 0.0), (last.at, 1, length)] {
            self.tips.insert(Segment { a: at, b: at, half_width: 0.0, line, index, arc });
        }
    }

    /// Whether any line may be too near to this point.
    pub(super) fn may_be_near(&self, at: MmPoint) -> bool {
        self.map.may_be_near(at)
    }

    /// The junctions of a polyline with the lines.
    pub(super) fn passage(&self, polyline: PolylineRef<'_, Vertex>) -> Passage {
        let PolylineRef { vertices, closed } = polyline;
        let arcs = polyline.arc_lengths();
        let length = arcs.last().copied().unwrap_or(0.0);
        let mut junctions = Vec::new();
        for (i, (a, b)) in polyline.segments().enumerate() {
            if self.may_be_near(a.at) {
                self.add_crossings((a.at, b.at), arcs[i], &mut junctions);
                self.add_touching_tips((a.at, b.at), arcs[i], &mut junctions);
            }
        }
        if !closed && let (Some(first), Some(last)) = (vertices.first(), vertices.last()) {
            for (at, arc) in [(first.at, 0.0), (last.at, length)] {
                self.add_ends_on_lines(at, arc, &mut junctions);
            }
        }
        let mut passage = Passage { arcs, round: closed.then_some(length), junctions };
        let winding: Vec<bool> = passage.junctions.iter().map(|at| self.winds(at, vertices, &passage)).collect();
        let mut winding = winding.into_iter();
        passage.junctions.retain(|_| !winding.next().unwrap_or(false));
        passage
    }

    /// The junctions of a path whose last vertex ends on lines: it joins all that pass there.
    pub(super) fn arriving(&self, path: &[Vertex]) -> Passage {
        let arcs = PolylineRef { vertices: path, closed: false }.arc_lengths();
        let mut junctions = Vec::new();
        if let (Some(&arc), Some(tip)) = (arcs.last(), path.last()) {
            self.add_ends_on_lines(tip.at, arc, &mut junctions);
        }
        Passage { arcs, round: None, junctions }
    }

    /// Adds the junctions where the segment `a`-`b` of a polyline, which begins at `arc`, crosses lines.
    fn add_crossings(&self, (a, b): (MmPoint, MmPoint), arc: f32, junctions: &mut Vec<Junction>) {
        self.segments.around(a.min(b), a.max(b), 0.0, |segment| {
            // longer by a rounding: lines that cross at a vertex, as those of drawings do, cross all the same
            let (own, other) = ((b - a) * VERTEX, (segment.b - segment.a) * VERTEX);
            // a line that ends on another may, by a rounding, cross it
            if let Some(at) = crossing((a - own, b + own), (segment.a - other, segment.b + other))
                && self.tips.nearest(at, TOUCH, |tip| tip.line == segment.line).is_none()
            {
                let line_arc = segment.arc + (at - segment.a).length();
                junctions.push(Junction { arc: arc + (at - a).length(), at, line: segment.line, line_arc, tip: false });
            }
        });
    }

    /// Adds the junctions where lines end on the segment `a`-`b` of a polyline, which begins at `arc`.
    fn add_touching_tips(&self, (a, b): (MmPoint, MmPoint), arc: f32, junctions: &mut Vec<Junction>) {
        self.tips.around(a.min(b), a.max(b), TOUCH, |tip| {
            let (distance, at) = nearest_on_segment(tip.a, a, b);
            if distance <= TOUCH {
                let arc = arc + (at - a).length();
                junctions.push(Junction { arc, at: tip.a, line: tip.line, line_arc: tip.arc, tip: true });
            }
        });
    }

    /// Adds the junctions of an end of a polyline with the lines that it lies on.
    fn add_ends_on_lines(&self, at: MmPoint, arc: f32, junctions: &mut Vec<Junction>) {
        self.segments.around(at, at, TOUCH, |segment| junctions.extend(Junction::of_end(at, arc, segment)));
    }

    /// Whether a polyline that joins a line does so again before it has been apart from it, or the line from the
    /// polyline: the two wind round one another.
    fn winds(&self, junction: &Junction, vertices: &[Vertex], passage: &Passage) -> bool {
        let stretch = |from: f32, to: f32| {
            let (from, to) = (from.min(to), from.max(to));
            let index = |arc: f32| passage.arcs.partition_point(|&other| other < arc).min(vertices.len());
            index(from)..index(to)
        };
        let line = &self.lines[junction.line as usize];
        passage.junctions.iter().any(|other| {
            if other.line != junction.line || (other.arc - junction.arc).abs() <= 1.0 {
                return false;
            }
            let hugs = |vertex: &Vertex| {
                let reach = self.params.clearance(0.5 * vertex.width);
                self.segments.nearest(vertex.at, reach, |segment| segment.line == junction.line).is_some()
            };
            let (from, to) = (junction.line_arc.min(other.line_arc), junction.line_arc.max(other.line_arc));
            let along = || line.iter().filter(|(arc, _)| (from..to).contains(arc));
            // All of the polyline is looked at, as it may be near the line beyond the two. Where it has just come from
            // one of them, as the legs of a bar on its axis, it is no winding.
            let hugging = |at: MmPoint| {
                let near = vertices.iter().zip(&passage.arcs);
                let near = near.filter(move |(v, _)| (v.at - at).length() < self.params.clearance(0.5 * v.width));
                near.map(|(v, &arc)| {
                    let approach = self.params.approach(0.5 * v.width, 0.5 * self.params.width_max);
                    passage.between(arc, junction.arc) > approach && passage.between(arc, other.arc) > approach
                })
            };
            vertices[stretch(junction.arc, other.arc)].iter().all(hugs)
                || (to - from > 1.0
                    && along().all(|(_, at)| hugging(*at).next().is_some())
                    && along().any(|(_, at)| hugging(*at).any(|winds| winds)))
        })
    }

    /// The state of every vertex of a polyline.
    pub(super) fn states(&self, polyline: &Polyline<Vertex>) -> Vec<State> {
        if !polyline.vertices.iter().any(|vertex| self.may_be_near(vertex.at)) {
            return vec![State::Free; polyline.vertices.len()];
        }
        let passage = self.passage(polyline.view());
        let state = |(i, vertex): (usize, &Vertex)| self.state(vertex, passage.arcs[i], &passage);
        polyline.vertices.iter().enumerate().map(state).collect()
    }

    /// The state of a vertex of a polyline.
    fn state(&self, vertex: &Vertex, arc: f32, passage: &Passage) -> State {
        let mut state = State::Free;
        self.each_near(vertex, arc, passage, |near| {
            state = if near.joins && state != State::TooNear { State::Joined } else { State::TooNear };
            state != State::TooNear
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
        mut visit: impl FnMut(&Near<'_>) -> bool,
    ) {
        if !self.may_be_near(vertex.at) {
            return;
        }
        let half = 0.5 * vertex.width;
        let mut on = true;
        self.segments.around(vertex.at, vertex.at, self.params.max_clearance(), |segment| {
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let clearance = self.params.clearance(half + segment.half_width);
            if !on || distance >= clearance {
                return;
            }
            let limit = self.params.approach(half, segment.half_width);
            let line_arc = segment.arc + (at - segment.a).length();
            // it is the line that ends there, or either of two that cross, that must have come from far enough
            let joins = passage.junctions.iter().any(|j| {
                let way = if j.tip { (j.line_arc - line_arc).abs() } else { passage.between(j.arc, arc) };
                j.line == segment.line && way <= limit
            });
            on = visit(&Near { segment, away: vertex.at - at, distance, missing: clearance - distance, joins });
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
