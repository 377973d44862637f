//! Points and lines, found again by place: a bitmap of a halftone has ten thousand small rings, of which each asks what
//! is near it.

use std::slice;

use super::point::{Point, is_drawn_twice};
use crate::geom::nearby::{Index, Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::{Vertex, nearby};
use crate::units::{Mm, MmPoint, MmRect};

/// What rounding may make of a distance, mm.
const ROUNDING: f32 = 0.01;

/// Points with the numbers of their lines.
pub(super) struct PointIndex {
    by_place: Index<(usize, Point), Mm>,
    /// The radius of the largest that it may hold, mm.
    largest: f32,
}

impl PointIndex {
    /// An empty one over the places of these, none of which is larger than the largest of them.
    pub(super) fn over(points: &[(usize, Point)], params: &Params) -> Self {
        let largest = points.iter().map(|(_, point)| point.radius).fold(0.0, f32::max);
        let area = MmRect::from_points(points.iter().map(|(_, point)| point.at));
        Self { by_place: Index::new(area, params.max_spacing()), largest }
    }

    pub(super) fn put(&mut self, number: usize, point: Point) {
        self.by_place.put_at(point.at, (number, point));
    }

    /// Whether another one of these is the same as a point ([`is_drawn_twice`]).
    pub(super) fn is_any_same(&self, number: usize, point: &Point) -> bool {
        self.is_any(point, |other, of| other != number && is_drawn_twice(of, slice::from_ref(point)))
    }

    /// Whether one of these that are near to a point is as asked.
    fn is_any(&self, point: &Point, is_it: impl Fn(usize, &Point) -> bool) -> bool {
        let mut is_there = false;
        self.by_place.around(point.at, point.at, self.largest + ROUNDING, |(number, of)| {
            is_there = is_there || is_it(*number, of);
        });
        is_there
    }
}

/// The points that are taken, in the order in which they were.
pub(super) struct TakenPoints {
    pub(super) all: Vec<Point>,
    by_place: PointIndex,
}

impl TakenPoints {
    /// None yet of those that were found.
    pub(super) fn none_of(found: &[(usize, Point)], params: &Params) -> Self {
        Self { all: Vec::new(), by_place: PointIndex::over(found, params) }
    }

    pub(super) fn push(&mut self, number: usize, point: Point) {
        self.by_place.put(number, point);
        self.all.push(point);
    }

    /// Whether one of them is the same as a point ([`is_drawn_twice`]).
    pub(super) fn has(&self, point: &Point) -> bool {
        self.by_place.is_any(point, |_, of| is_drawn_twice(of, slice::from_ref(point)))
    }
}

/// The lines of a drawing, some of which are led on while points are taken.
pub(super) struct LineIndex {
    segments: Nearby,
}

impl LineIndex {
    pub(super) fn of(polylines: &[Polyline<Vertex>], params: &Params) -> Self {
        let area = MmRect::from_points(polylines.iter().flat_map(|line| &line.vertices).map(|vertex| vertex.at));
        Self { segments: nearby(polylines.iter(), area, params) }
    }

    /// Adds a straight piece to the line of this number.
    pub(super) fn lead_on(&mut self, line: usize, a: MmPoint, b: MmPoint) {
        self.segments.insert(Segment { a, b, half_width: 0.0, line: line as u32, index: 0, arc: 0.0 });
    }

    /// The numbers of the lines that come within `reach` of a place, in order; those of some farther ones come too.
    pub(super) fn around(&self, at: MmPoint, reach: f32) -> Vec<usize> {
        let mut lines: Vec<usize> = Vec::new();
        self.segments.around(at, at, reach + ROUNDING, |segment| {
            // in a cell those of one line mostly follow one another
            if lines.last() != Some(&(segment.line as usize)) {
                lines.push(segment.line as usize);
            }
        });
        lines.sort_unstable();
        lines.dedup();
        lines
    }
}

#[cfg(test)]
mod tests;
