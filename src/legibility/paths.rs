//! Lines as paths: what a finger follows in one go, with the length along it at each of its segments.

use super::limits::LAST_DIGIT;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::spaced_row::{has_every_second, longest_step};
use crate::geom::walk::arc_between;
use crate::page::{Line, Pen, Run};
use crate::units::{MmPoint, MmRect};

/// Runs whose ends are this near go on in one another, mm: both are rounded.
const SAME: f32 = 2.0 * LAST_DIGIT;
/// At a corner a ring turns by at least 30 degrees (the cosine), over a short and a longer length, mm, as lines of
/// drawings have it (`profile/plan` ties the two).
pub(crate) const RING_CORNER: f32 = 0.866;
pub(crate) const RING_CORNER_ARMS: [f32; 2] = [0.15, 1.0];

/// Joined strokes of one line, in order.
#[derive(Debug)]
pub(super) struct Path {
    /// Its segments in the list of all of them.
    pub(super) segments: std::ops::Range<usize>,
    /// Length, mm.
    pub(super) length: f32,
    /// Whether its end is its beginning.
    pub(super) closed: bool,
    /// Whether it is a row of dots that comes back to where it began.
    pub(super) is_ring_of_dots: bool,
    /// The line it is a part of.
    pub(super) line: usize,
    /// What it consists of.
    pub(super) kind: PathKind,
}

/// What a path consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PathKind {
    /// Strokes.
    Stroke,
    /// A row of dots.
    Row,
    /// Dots beside it: the second row of a heavy line, its points, ticks and arrowheads.
    BesideRow,
}

/// All strokes of a list of lines. The `line` of a segment is the number of its path.
#[derive(Debug, Default)]
pub(super) struct Paths {
    pub(super) paths: Vec<Path>,
    pub(super) segments: Vec<Segment>,
}

impl Paths {
    /// The paths of all strokes; each row of dots is one along the middles of its dots.
    pub(super) fn whole(lines: &[Line]) -> Self {
        Self::broken(lines, f32::INFINITY)
    }

    /// The same with rows of dots in pieces: broken where a step is longer than `step` mm. That of a leader line, which
    /// has every second dot, is whole.
    pub(super) fn broken(lines: &[Line], step: f32) -> Self {
        let mut all = Self::default();
        for (line, of) in lines.iter().enumerate() {
            let mut last: Option<MmPoint> = None;
            for (number, run) in of.runs.iter().enumerate().filter(|(_, run)| !run.points.is_empty()) {
                let before = all.paths.len();
                let kind = match run.pen {
                    Pen::Stroke => PathKind::Stroke,
                    Pen::Dots(_) if number == 0 => PathKind::Row,
                    Pen::Dots(_) => PathKind::BesideRow,
                };
                let goes_on =
                    kind == PathKind::Stroke && last.is_some_and(|last| (last - run.points[0]).length() <= SAME);
                if !goes_on {
                    all.begin(line, kind);
                }
                match kind {
                    PathKind::Stroke => all.add(run),
                    PathKind::Row | PathKind::BesideRow => all.add_row(run, (line, kind), step),
                }
                if let [only] = &mut all.paths[before..] {
                    only.is_ring_of_dots = kind == PathKind::Row && of.is_ring_of_dots();
                }
                last = run.path().last();
            }
        }
        for path in &mut all.paths {
            let segments = &all.segments[path.segments.clone()];
            path.closed = match (segments.first(), segments.last()) {
                (Some(first), Some(last)) => segments.len() > 2 && (first.a - last.b).length() <= SAME,
                _ => false,
            };
        }
        all
    }

    fn begin(&mut self, line: usize, kind: PathKind) {
        let from = self.segments.len();
        self.paths.push(Path { segments: from..from, length: 0.0, closed: false, is_ring_of_dots: false, line, kind });
    }

    fn add_row(&mut self, run: &Run, (line, kind): (usize, PathKind), step: f32) {
        let step = if has_every_second(&run.points, step) { longest_step(step) } else { step };
        let rows = run.points.chunk_by(|a, b| (*b - *a).length() <= step);
        for (number, points) in rows.enumerate() {
            if number > 0 {
                self.begin(line, kind);
            }
            self.add(&Run { points: points.to_vec(), closed: false, ..*run });
        }
    }

    fn add(&mut self, run: &Run) {
        let number = self.paths.len().saturating_sub(1) as u32;
        let Some(path) = self.paths.last_mut() else { return };
        let mut push = |a: MmPoint, b: MmPoint| {
            let index = (self.segments.len() - path.segments.start) as u32;
            self.segments.push(Segment { a, b, half_width: 0.5 * run.width, line: number, index, arc: path.length });
            path.length += (b - a).length();
            path.segments.end = self.segments.len();
        };
        match run.points[..] {
            [only] => push(only, only),
            _ => run.polyline().segments().for_each(|(a, b)| push(*a, *b)),
        }
    }

    /// The segments of a path.
    pub(super) fn segments_of(&self, path: usize) -> &[Segment] {
        &self.segments[self.paths[path].segments.clone()]
    }

    /// Half the width of the widest stroke, mm.
    pub(super) fn widest(&self) -> f32 {
        self.segments.iter().map(|segment| segment.half_width).fold(0.0, f32::max)
    }

    /// The segments, to be found by place.
    pub(super) fn index(&self, reach: f32) -> Nearby {
        let points = self.segments.iter().flat_map(|segment| [segment.a, segment.b]);
        let area = super::finding::around(points).unwrap_or_else(MmRect::zero);
        let mut index = Nearby::new(area, reach);
        self.segments.iter().for_each(|segment| index.insert(*segment));
        index
    }

    /// Whether a path has a corner at an arc, seen over arms of this length, mm.
    pub(super) fn turns(&self, path: usize, arc: f32, arm: f32) -> bool {
        let at = |arc: f32| self.at(path, arc);
        let (before, after) = (arc - arm, arc + arm);
        if before < 0.0 || after > self.paths[path].length {
            return false;
        }
        let (Some(a), Some(b), Some(c)) = (at(before), at(arc), at(after)) else { return false };
        let arms = (b - a).try_normalize().zip((c - b).try_normalize());
        arms.is_some_and(|(one, other)| one.dot(other) <= RING_CORNER)
    }

    /// The place of a path at an arc; none if it has no segments.
    pub(super) fn at(&self, path: usize, arc: f32) -> Option<MmPoint> {
        let segments = self.segments_of(path);
        let at = segments.partition_point(|segment| segment.arc <= arc).saturating_sub(1);
        segments.get(at).map(|segment| point_at(segment, arc))
    }

    /// The corners of a ring of strokes, with their places along it: it may stand on other lines with them.
    pub(super) fn corners_of_ring(&self, path: usize) -> Vec<(Segment, MmPoint, f32)> {
        let Path { closed, kind, length, .. } = self.paths[path];
        if !closed || kind != PathKind::Stroke {
            return Vec::new();
        }
        let segments = self.segments_of(path);
        let is_corner = |segment: &&Segment| {
            RING_CORNER_ARMS.iter().all(|arm| {
                let way = |to: f32| (self.at(path, (segment.arc + to).rem_euclid(length))? - segment.a).try_normalize();
                way(*arm).zip(way(-arm)).is_some_and(|(on, back)| on.dot(back) >= -RING_CORNER)
            })
        };
        segments.iter().filter(is_corner).map(|segment| (*segment, segment.a, segment.arc)).collect()
    }

    /// The ends of a path, with their places along it; a ring has none.
    pub(super) fn tips(&self, path: usize) -> Vec<(Segment, MmPoint, f32)> {
        let segments = self.segments_of(path);
        match (segments.first(), segments.last()) {
            (Some(first), Some(last)) if !self.paths[path].closed => {
                vec![(*first, first.a, 0.0), (*last, last.b, self.paths[path].length)]
            }
            _ => Vec::new(),
        }
    }
}

impl Path {
    /// The length along it between two of its places, the shorter arc of a ring.
    pub(super) fn between(&self, s: f32, t: f32) -> f32 {
        arc_between(s, t, self.closed.then_some(self.length))
    }
}

/// The place along a path of the point of a segment that is nearest to `at`, and the distance.
pub(super) fn nearest(segment: &Segment, at: MmPoint) -> (f32, MmPoint, f32) {
    let (distance, point) = nearest_on_segment(at, segment.a, segment.b);
    (distance, point, segment.arc + (point - segment.a).length())
}

/// The point of a segment at a place along its path.
pub(super) fn point_at(segment: &Segment, arc: f32) -> MmPoint {
    let length = (segment.b - segment.a).length();
    if length > 0.0 { segment.a.lerp(segment.b, ((arc - segment.arc) / length).clamp(0.0, 1.0)) } else { segment.a }
}

/// Whether two segments may come within `reach` of one another: a quick look at their boxes.
pub(super) fn may_be_near(a: &Segment, b: &Segment, reach: f32) -> bool {
    let apart = |a: f32, b: f32, c: f32, d: f32| a.min(b) - c.max(d) > reach || c.min(d) - a.max(b) > reach;
    !apart(a.a.x, a.b.x, b.a.x, b.b.x) && !apart(a.a.y, a.b.y, b.a.y, b.b.y)
}

#[cfg(test)]
mod tests;
