//! A contour in the making, and what is asked of it again and again: how far along, which way, how straight.

use crate::units::{PxPoint, PxVector};

/// A point of a contour with what its edge looks like there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mark {
    pub(super) at: PxPoint,
    /// Height of the step with texture taken off (see [`super::EdgePoint`]).
    pub(super) strength: f32,
    /// Colour on the right less colour on the left.
    pub(super) step: [f32; 3],
    /// Blur of the step with the scale of the derivative in it, px.
    pub(super) blur: f32,
    /// Standard deviation of the place across the edge that the picture's noise makes, px.
    pub(super) doubt: f32,
}

/// A contour in the making. A closed one goes on from its last mark to its first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Path {
    pub(super) marks: Vec<Mark>,
    pub(super) closed: bool,
}

/// A straight line laid through marks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flank {
    /// The middle of the marks.
    pub(super) at: PxPoint,
    /// Unit direction, the way in which the marks were given.
    pub(super) along: PxVector,
    /// Root mean square distance of the marks from the line, px.
    pub(super) off: f32,
}

impl Path {
    pub(super) fn length(&self) -> f32 {
        let open: f32 = self.marks.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
        match (self.closed, self.marks.first(), self.marks.last()) {
            (true, Some(first), Some(last)) => open + (first.at - last.at).length(),
            _ => open,
        }
    }

    pub(super) fn reverse(&mut self) {
        self.marks.reverse();
        for mark in &mut self.marks {
            mark.step = mark.step.map(|v| -v);
        }
    }

    /// The number of the mark `steps` before or after mark `i`; none beyond the ends of an open path.
    pub(super) fn next(&self, i: usize, steps: isize) -> Option<usize> {
        let n = self.marks.len() as isize;
        let to = i as isize + steps;
        if self.closed { Some(to.rem_euclid(n) as usize) } else { (0..n).contains(&to).then_some(to as usize) }
    }

    /// Marks from `i` on, forwards or backwards, with the way gone to each, once round a ring at most.
    pub(super) fn walk(&self, i: usize, forwards: bool) -> impl Iterator<Item = (usize, f32)> {
        let mut way = 0.0;
        let mut here = i;
        (0..self.marks.len() as isize).map_while(move |step| {
            let to = self.next(i, if forwards { step } else { -step })?;
            way += (self.marks[to].at - self.marks[here].at).length();
            here = to;
            Some((to, way))
        })
    }

    /// The line through the marks that lie between `from` and `to` pixels along the path from mark `i`, directed away from
    /// it; none if they are fewer than three.
    pub(super) fn flank(&self, i: usize, forwards: bool, from: f32, to: f32) -> Option<Flank> {
        let marks = self.walk(i, forwards).skip_while(|(_, way)| *way < from).take_while(|(_, way)| *way <= to);
        Flank::through(marks.map(|(number, _)| self.marks[number].at))
    }
}

impl Flank {
    /// The line through points; none through fewer than three.
    pub(super) fn through(points: impl Iterator<Item = PxPoint>) -> Option<Self> {
        let (mut n, mut sum) = (0.0, PxVector::zero());
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        let mut ends = None;
        for point in points {
            let (first, _) = *ends.get_or_insert((point, point));
            ends = Some((first, point));
            let v = point - first; // small numbers keep their digits
            n += 1.0;
            sum += v;
            (xx, xy, yy) = (xx + v.x * v.x, xy + v.x * v.y, yy + v.y * v.y);
        }
        let (first, last) = ends?;
        if n < 3.0 {
            return None;
        }
        let mean = sum / n;
        let (xx, xy, yy) = (xx / n - mean.x * mean.x, xy / n - mean.x * mean.y, yy / n - mean.y * mean.y);
        let (half, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (difference * difference + xy * xy).sqrt();
        let along =
            if difference >= 0.0 { PxVector::new(difference + root, xy) } else { PxVector::new(xy, root - difference) };
        let along = along.try_normalize()?;
        let along = if along.dot(last - first) < 0.0 { -along } else { along };
        Some(Self { at: first + mean, along, off: (half - root).max(0.0).sqrt() })
    }

    /// Where two lines cross, as the way from each one's middle along it; none if they are nearly parallel.
    pub(super) fn crossing(&self, other: &Self) -> Option<(f32, f32)> {
        let sine = self.along.cross(other.along);
        if sine.abs() < 0.05 {
            return None;
        }
        let between = other.at - self.at;
        Some((between.cross(other.along) / sine, between.cross(self.along) / sine))
    }

    /// The place on the line nearest to `point`.
    pub(super) fn nearest(&self, point: PxPoint) -> PxPoint {
        self.at + self.along * self.along.dot(point - self.at)
    }
}
