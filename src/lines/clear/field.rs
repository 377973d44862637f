//! The lines that are drawn so far, and what comes too near to them.
//!
//! Two lines may be near only on the way to a place where they meet: where one of them ends on the other, or where they
//! cross. The way from there until they are apart must be short, which keeps out lines that run into one another flat:
//!
//! ```text
//!   ----------o----------   far enough          -----------o------   too flat: the
//!             |                                    ___---´´          lower line ends
//!             |  <- at most 1.7 clearances      --´                  where it comes near
//! ```

use super::{Params, weight};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmRect, MmVector};

/// A line ends on another if it comes this near, mm: twice the tolerance of simplification, so that it is drawn so (see
/// [`super::pin`], which gives the other a vertex there), and far less than a finger notices.
pub(super) const TOUCH: f32 = 0.1;
/// The longest way from a meeting until two lines are apart, in clearances: at 36 degrees a straight line needs as much.
pub(super) const APPROACH: f32 = 1.7;
/// ... less this, mm: a line may be drawn by a step of width thinner than its vertices say.
pub(super) const LESS: f32 = 0.2;
/// What rounding and the vertices where lines meet may take from a distance, mm.
const ROUNDING: f32 = 0.08;

/// Cells of the map of what is near to a line at all, mm.
const CELL: f32 = 1.0;
/// ... which is marked along a line in steps of this, mm.
const MARK: f32 = 1.5;

/// A polyline meets a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    /// How far along the polyline.
    pub(super) arc: f32,
    pub(super) at: MmPoint,
    pub(super) line: u32,
    /// How far along the line.
    there: f32,
    /// Whether it is an end of the line that lies here.
    tip: bool,
}

impl Meeting {
    /// The meeting of a polyline that ends at a place with the line of a segment, if it ends on that.
    fn of_end(at: MmPoint, arc: f32, segment: &Segment) -> Option<Self> {
        let (distance, touched) = nearest_on_segment(at, segment.a, segment.b);
        let there = segment.arc + (touched - segment.a).length();
        (distance <= TOUCH).then_some(Self { arc, at, line: segment.line, there, tip: false })
    }
}

/// How near a vertex is to lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// Apart from all.
    Free,
    /// Near to lines that it meets close by.
    Joined,
    /// Near to a line that it does not meet.
    TooNear,
}

/// A segment that is near to a vertex.
pub(super) struct Near<'a> {
    pub(super) segment: &'a Segment,
    /// From centre line to centre line, mm.
    pub(super) distance: f32,
    /// What the distance falls short by, mm.
    pub(super) missing: f32,
}

/// Lines that are drawn.
pub(super) struct Field<'a> {
    pub(super) params: &'a Params,
    area: MmRect,
    /// All their segments.
    segments: Nearby,
    /// Their ends, as segments without length; `index` is 1 at the end, 0 at the start.
    tips: Nearby,
    /// Vertices of each, with the way to them, mm.
    lines: Vec<Vec<(f32, MmPoint)>>,
    /// For each cell whether a line may be nearer to a place in it than two lines may be.
    map: Vec<bool>,
    columns: usize,
    rows: usize,
}

/// A polyline among the lines that are drawn.
pub(super) struct Places {
    /// Way to each vertex, mm.
    pub(super) arcs: Vec<f32>,
    /// Its whole length if it is closed.
    pub(super) round: Option<f32>,
    /// Where it meets lines.
    pub(super) meetings: Vec<Meeting>,
}

impl Places {
    /// Way along the polyline between two places, mm.
    pub(super) fn way(&self, s: f32, t: f32) -> f32 {
        let apart = (s - t).abs();
        self.round.map_or(apart, |round| apart.min(round - apart))
    }
}

impl<'a> Field<'a> {
    pub(super) fn new(area: MmRect, params: &'a Params) -> Self {
        let reach = params.min_gap + params.width_max;
        let cells = |mm: f32| (mm / CELL).ceil().max(1.0) as usize;
        let (columns, rows) = (cells(area.width()), cells(area.height()));
        Self {
            params,
            area,
            segments: Nearby::new(area, reach),
            tips: Nearby::new(area, reach),
            lines: Vec::new(),
            map: vec![false; columns * rows],
            columns,
            rows,
        }
    }

    /// How far apart the centre lines of two lines must be, mm. Simplification may move both.
    pub(super) fn clearance(&self, half_widths: f32) -> f32 {
        self.params.min_gap + half_widths + 2.0 * self.params.tolerance + ROUNDING
    }

    /// The longest way from a meeting until two lines of the least width are apart, mm.
    pub(super) fn longest_approach(&self) -> f32 {
        APPROACH * (self.params.min_gap + self.params.width_min) - 2.0 * LESS
    }

    /// The longest way beyond a crossing that does not count as a line of its own, mm.
    pub(super) fn longest_stub(&self) -> f32 {
        APPROACH * (self.params.min_gap + self.params.width_max)
    }

    /// Whether a vertex is too near to one of the lines.
    pub(super) fn is_near(&self, vertex: &Vertex, line: u32) -> bool {
        self.segments
            .nearest(vertex.at, self.farthest(), |segment| segment.line == line)
            .is_some_and(|(distance, _, segment)| distance < self.clearance(0.5 * vertex.width + segment.half_width))
    }

    pub(super) fn farthest(&self) -> f32 {
        self.clearance(self.params.width_max)
    }

    /// Begins to draw a line. Returns its number. Nothing meets its ends until [`Field::finish`].
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
            self.mark(first.at);
        }
        for (i, (a, b)) in polyline.segments().enumerate().skip(from) {
            self.segments.insert(segment(a, b, i, line, arcs[i]));
            if i + 1 == polyline.segment_count() || (arcs[i] / MARK) as usize != (arcs[i + 1] / MARK) as usize {
                self.mark(b.at);
            }
        }
        self.lines[line as usize] = arcs.into_iter().zip(polyline.path().map(|vertex| vertex.at)).collect();
    }

    /// A line is complete: others may meet its ends.
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

    fn mark(&mut self, at: MmPoint) {
        let reach = self.farthest() + CELL + 0.5 * MARK; // half the diagonal of a cell, and half the way to the next mark
        let (x, y) = ((at.x - self.area.min.x) / CELL, (at.y - self.area.min.y) / CELL);
        let range = |middle: f32, count: usize| {
            ((middle - reach / CELL).max(0.0) as usize)..(((middle + reach / CELL).max(0.0) as usize + 1).min(count))
        };
        for row in range(y, self.rows) {
            for column in range(x, self.columns) {
                let (dx, dy) = (column as f32 + 0.5 - x, row as f32 + 0.5 - y);
                if (dx * dx + dy * dy) * CELL * CELL <= reach * reach {
                    self.map[row * self.columns + column] = true;
                }
            }
        }
    }

    /// Whether any line may be too near to this place.
    pub(super) fn may_be_near(&self, at: MmPoint) -> bool {
        let index = |value: f32, count: usize| ((value / CELL).max(0.0) as usize).min(count - 1);
        let (column, row) = (index(at.x - self.area.min.x, self.columns), index(at.y - self.area.min.y, self.rows));
        self.map[row * self.columns + column]
    }

    /// Where a polyline meets the lines.
    pub(super) fn places(&self, polyline: PolylineRef<'_, Vertex>) -> Places {
        let PolylineRef { vertices, closed } = polyline;
        let arcs = polyline.arc_lengths();
        let arc = arcs.last().copied().unwrap_or(0.0);
        let mut meetings = Vec::new();
        for (i, (a, b)) in polyline.segments().enumerate() {
            if !self.may_be_near(a.at) {
                continue;
            }
            let (a, b) = (a.at, b.at);
            let (low, high) = (a.min(b), a.max(b));
            self.segments.around(low, high, 0.0, |segment| {
                // a line that ends on another may, by a rounding, cross it
                if let Some(at) = crossing((a, b), (segment.a, segment.b))
                    && self.tips.nearest(at, TOUCH, |tip| tip.line == segment.line).is_none()
                {
                    let there = segment.arc + (at - segment.a).length();
                    meetings.push(Meeting {
                        arc: arcs[i] + (at - a).length(),
                        at,
                        line: segment.line,
                        there,
                        tip: false,
                    });
                }
            });
            self.tips.around(low, high, TOUCH, |tip| {
                let (distance, at) = nearest_on_segment(tip.a, a, b);
                if distance <= TOUCH {
                    let arc = arcs[i] + (at - a).length();
                    meetings.push(Meeting { arc, at: tip.a, line: tip.line, there: tip.arc, tip: true });
                }
            });
        }
        if !closed && let (Some(first), Some(last)) = (vertices.first(), vertices.last()) {
            for (at, arc) in [(first.at, 0.0), (last.at, arc)] {
                self.segments.around(at, at, TOUCH, |segment| {
                    meetings.extend(Meeting::of_end(at, arc, segment));
                });
            }
        }
        let mut places = Places { arcs, round: closed.then_some(arc), meetings };
        let winding: Vec<bool> = places.meetings.iter().map(|meeting| self.winds(meeting, vertices, &places)).collect();
        let mut winding = winding.into_iter();
        places.meetings.retain(|_| !winding.next().unwrap_or(false));
        places
    }

    /// Whether a polyline that meets a line does so again before it has been apart from it, or the line from the polyline: the two
    /// wind round one another.
    fn winds(&self, meeting: &Meeting, vertices: &[Vertex], places: &Places) -> bool {
        let stretch = |from: f32, to: f32| {
            let (from, to) = (from.min(to), from.max(to));
            let index = |arc: f32| places.arcs.partition_point(|&other| other < arc).min(vertices.len());
            index(from)..index(to)
        };
        let line = &self.lines[meeting.line as usize];
        places.meetings.iter().any(|other| {
            if other.line != meeting.line || (other.arc - meeting.arc).abs() <= 1.0 {
                return false;
            }
            let polyline = &vertices[stretch(meeting.arc, other.arc)];
            let hugs = |vertex: &Vertex| {
                let reach = self.clearance(0.5 * vertex.width);
                self.segments.nearest(vertex.at, reach, |segment| segment.line == meeting.line).is_some()
            };
            let (from, to) = (meeting.there.min(other.there), meeting.there.max(other.there));
            let along = || line.iter().filter(|(arc, _)| (from..to).contains(arc));
            // all the polyline is looked at, as it may be near the line beyond the two
            let is_hugged = |at: MmPoint| vertices.iter().any(|v| (v.at - at).length() < self.clearance(0.5 * v.width));
            polyline.iter().all(hugs) || (to - from > 1.0 && along().all(|(_, at)| is_hugged(*at)))
        })
    }

    /// The state of a vertex of a polyline.
    pub(super) fn state(&self, vertex: &Vertex, arc: f32, places: &Places) -> State {
        let mut state = State::Free;
        self.each_near(vertex, arc, places, |_, _, joins| {
            state = if joins && state != State::TooNear { State::Joined } else { State::TooNear };
            state != State::TooNear
        });
        state
    }

    /// Calls `visit` with the nearest place of every segment that is too near to a vertex of a polyline unless the two lines meet
    /// close by, as the way from there and the length missing, and whether they do. It goes on as long as `visit` says so.
    pub(super) fn each_near(
        &self,
        vertex: &Vertex,
        arc: f32,
        places: &Places,
        mut visit: impl FnMut(&Near<'_>, MmVector, bool) -> bool,
    ) {
        if !self.may_be_near(vertex.at) {
            return;
        }
        let half = 0.5 * vertex.width;
        let mut on = true;
        self.segments.around(vertex.at, vertex.at, self.farthest(), |segment| {
            let (distance, at) = nearest_on_segment(vertex.at, segment.a, segment.b);
            let clearance = self.clearance(half + segment.half_width);
            if !on || distance >= clearance {
                return;
            }
            let limit = APPROACH * (self.params.min_gap + half + segment.half_width) - LESS;
            let there = segment.arc + (at - segment.a).length();
            // it is the line that ends there, or either of two that cross, that must have come from far enough
            let joins = places.meetings.iter().any(|meeting| {
                let way = if meeting.tip { (meeting.there - there).abs() } else { places.way(meeting.arc, arc) };
                meeting.line == segment.line && way <= limit
            });
            on = visit(&Near { segment, distance, missing: clearance - distance }, vertex.at - at, joins);
        });
    }

    /// The nearest end of a line within `reach`.
    pub(super) fn nearest_tip(&self, at: MmPoint, reach: f32) -> Option<MmPoint> {
        self.tips.nearest(at, reach, |_| true).map(|(_, at, _)| at)
    }

    /// The places of a path whose last vertex ends on lines: it meets all that pass there.
    pub(super) fn arriving(&self, path: &[Vertex]) -> Places {
        let mut places = Places {
            arcs: PolylineRef { vertices: path, closed: false }.arc_lengths(),
            round: None,
            meetings: Vec::new(),
        };
        if let (Some(&arc), Some(tip)) = (places.arcs.last(), path.last()) {
            self.segments.around(tip.at, tip.at, TOUCH, |segment| {
                places.meetings.extend(Meeting::of_end(tip.at, arc, segment));
            });
        }
        places
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
