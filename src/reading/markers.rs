//! Markers at the ends of lines: which are the heads of arrows.

use super::subpath::Subpath;
use crate::units::{MmPoint, MmVector};

/// Which end of which subpath of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LineEnd {
    subpath: usize,
    is_last: bool,
}

/// The direction of a line at its end is taken over this length, mm.
const HEADING: f32 = 2.0;
/// Smallest marker that is the head of an arrow, mm.
const SMALLEST: f32 = 0.3;
/// Share of a head's length in which it narrows to its tip, and of its width that it has there at most.
const AT_TIP: f32 = 0.1;
const TIP: f32 = 0.3;
/// Its ends aside are those within this share of its width.
const WIDEST: f32 = 0.01;
/// It is broadest in this share of its length, from its base.
const AT_BASE: f32 = 0.5;
/// By how much of its width its two sides may differ.
const UNEVEN: f32 = 0.3;

impl LineEnd {
    fn of(self, subpaths: &[Subpath]) -> Option<MmPoint> {
        let points = &subpaths[self.subpath].points;
        if self.is_last { points.last() } else { points.first() }.copied()
    }

    /// Which way the line leads there.
    fn heading(self, subpaths: &[Subpath]) -> Option<MmVector> {
        let (end, points) = (self.of(subpaths)?, &subpaths[self.subpath].points);
        let is_far = |at: &&MmPoint| (**at - end).length() >= HEADING;
        let inner = if self.is_last {
            points.iter().rev().find(is_far).or(points.first())
        } else {
            points.iter().find(is_far).or(points.last())
        };
        (end - *inner?).try_normalize()
    }

    /// Puts the end of the line to another place.
    pub(super) fn put(self, subpaths: &mut [Subpath], at: MmPoint) {
        let points = &mut subpaths[self.subpath].points;
        let end = if self.is_last { points.last_mut() } else { points.first_mut() };
        end.into_iter().for_each(|end| *end = at);
    }
}

/// The end of a line at which a marker of these points is the head of an arrow, its tip, and which way it points.
pub(super) fn head(points: &[MmPoint], line: &[Subpath]) -> Option<(LineEnd, MmPoint, MmVector)> {
    let ends = (0..line.len()).flat_map(|subpath| [false, true].map(|is_last| LineEnd { subpath, is_last }));
    let open = ends.filter(|end| !line[end.subpath].closed);
    let far = |end: &LineEnd| {
        let from = |at: MmPoint| points.iter().map(|other| (*other - at).length()).fold(f32::INFINITY, f32::min);
        end.of(line).map_or(f32::INFINITY, from)
    };
    let end = open.min_by(|a, b| far(a).total_cmp(&far(b)))?;
    let (at, toward) = (end.of(line)?, end.heading(line)?);
    let along = |point: &MmPoint| (*point - at).dot(toward);
    let aside = |point: &MmPoint| (*point - at).cross(toward);
    let range = |of: &dyn Fn(&MmPoint) -> f32| {
        points.iter().map(of).fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
    };
    let ((back, front), (left, right)) = (range(&along), range(&aside));
    let (length, width) = (front - back, right - left);
    let is_at_line = far(&end) <= length.max(width) && back <= length && front >= -length;
    let is_even = (left + right).abs() <= UNEVEN * width;
    let narrows =
        points.iter().filter(|at| along(at) >= front - AT_TIP * length).all(|at| aside(at).abs() <= TIP * width);
    let widest = points.iter().filter(|at| (aside(at) - left).min(right - aside(at)) <= WIDEST * width);
    let has_base = widest.into_iter().all(|at| along(at) <= back + AT_BASE * length);
    let is_head = length.min(width) >= SMALLEST && is_at_line && is_even && narrows && has_base;
    // a line is not cut shorter by its head
    is_head.then(|| (end, at + toward * front.max(0.0), toward))
}

#[cfg(test)]
mod tests;
