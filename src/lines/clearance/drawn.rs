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

use super::near_line::NearLine;
use super::near_map::{MARK, NearMap};
use super::passage::{Junction, Meeting, Passage, TOUCH};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::lines::weight;
use crate::units::{MmPoint, MmRect};

/// How near a vertex is to drawn lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LineState {
    /// Apart from all.
    Free,
    /// Near to lines with which it has a junction close by.
    Meets,
    /// Near to a line with which it has none.
    TooNear,
}

/// One of the drawn lines.
#[derive(Default)]
pub(super) struct DrawnLine {
    /// Its vertices, with the arc lengths there, mm.
    pub(super) path: Vec<(f32, MmPoint)>,
    pub(super) closed: bool,
    /// Where it joins others.
    pub(super) joins: Vec<Joined>,
}

/// Where a drawn line joins another.
#[derive(Clone, Copy)]
pub(super) struct Joined {
    /// How far along itself, mm.
    pub(super) arc: f32,
    /// Number of the other.
    pub(super) other: u32,
    /// How far along the other, mm.
    pub(super) other_arc: f32,
    /// Whether the other ends there.
    pub(super) other_ends: bool,
}

impl DrawnLine {
    pub(super) fn length(&self) -> f32 {
        self.path.last().map_or(0.0, |(arc, _)| *arc)
    }

    /// The whole length of a closed line, mm.
    pub(super) fn ring_length(&self) -> Option<f32> {
        self.closed.then(|| self.length())
    }
}

/// The drawn lines.
pub(super) struct DrawnLines<'a> {
    pub(super) params: &'a Params,
    /// The part of the sheet that they are on.
    pub(super) area: MmRect,
    /// All their segments.
    pub(super) segments: Nearby,
    /// Their ends, of drawings also the corners of rings, as segments without length.
    pub(super) tips: Nearby,
    pub(super) lines: Vec<DrawnLine>,
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
            state = if near.joins() && state != LineState::TooNear { LineState::Meets } else { LineState::TooNear };
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
        self.segments.any_around_point(vertex.at, self.params.max_clearance(), |segment| {
            if !is_other(segment.line) {
                return false;
            }
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let clearance = self.params.clearance(half + segment.half_width);
            if distance >= clearance {
                return false;
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
            !visit(&near)
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
}

/// The segment of a line between two vertices.
pub(super) fn segment(a: &Vertex, b: &Vertex, i: usize, line: u32, arc: f32) -> Segment {
    let half_width = 0.5 * weight::between(a, b);
    Segment { a: a.at, b: b.at, half_width, line, index: i as u32, arc }
}
