//! Bumps of outlines whose sides nobody sees. Where the colour changes slowly, as out of focus, several contours run
//! side by side, and a border of basins leaps from one to the next and back, like battlements:
//!
//! ```text
//!              ,------.                                  contours: - and =
//!    =========='      '========   becomes   ==========================
//! ```

use std::ops::Range;

use crate::units::PxPoint;

/// A vertex is on a side of a bump, where no contour runs along the border, if less than this share of the strength
/// around it is seen there: a contour is seen by its cosine with the border, which is this at 60 degrees.
const FAINT: f32 = 0.5;
/// The strength around a vertex is the greatest within so many vertices.
const AROUND: usize = 8;
/// Longest side of a bump, longest bump, and highest one, mm on the sheet. What is larger has a shape that a finger can
/// follow. Chosen by us, by looking at a bear on a meadow: its shores had bumps of 3 to 7 by 2 mm.
const SIDE: f32 = 3.0;
const LONGEST: f32 = 9.0;
const HIGHEST: f32 = 2.5;
/// Before and behind a bump the border goes straight on: so far, mm, it is no farther than that from the line between
/// the ends of the bump, which is less than half the width of a line.
const STRAIGHT: f32 = 2.0;
const ASIDE: f32 = 0.35;

/// A border before it is smoothed.
pub(super) struct Places<'a> {
    /// Where its vertices are, about a cell from one another, in cells.
    pub(super) points: &'a [PxPoint],
    /// What is seen along the border at each.
    pub(super) strengths: &'a [f32],
    pub(super) closed: bool,
    /// The side of a cell on the sheet, mm.
    pub(super) mm: f32,
}

/// A bump: the vertices beside it, counted on over the seam of a ring.
struct Bump {
    from: usize,
    to: usize,
    /// The sum of what is seen along it.
    seen: f32,
}

impl Places<'_> {
    /// The vertices, with those of bumps moved to the line between the ends of each. Of two that share a side the
    /// shorter one goes, else the fainter.
    pub(super) fn without_bumps(&self) -> Vec<PxPoint> {
        let mut points = self.points.to_vec();
        let n = points.len();
        if n < 4 * AROUND {
            return points;
        }
        let mut bumps = self.bumps();
        bumps.sort_by(|a, b| (a.to - a.from).cmp(&(b.to - b.from)).then(a.seen.total_cmp(&b.seen)));
        let mut is_moved = vec![false; n];
        for Bump { from, to, .. } in bumps {
            if (from + 1..to).any(|i| is_moved[i % n]) {
                continue;
            }
            for i in from + 1..to {
                let share = (i - from) as f32 / (to - from) as f32;
                points[i % n] = self.at(from).lerp(self.at(to), share);
                is_moved[i % n] = true;
            }
        }
        points
    }

    fn at(&self, i: usize) -> PxPoint {
        self.points[i % self.points.len()]
    }

    fn cells(&self, mm: f32) -> f32 {
        mm / self.mm
    }

    fn bumps(&self) -> Vec<Bump> {
        let n = self.points.len();
        let mut sides = self.sides();
        if let (true, Some(first)) = (self.closed, sides.first().cloned()) {
            sides.push(first.start + n..first.end + n);
        }
        let bump = |pair: &[Range<usize>]| {
            let (from, to) = (pair[0].start.checked_sub(1)?, pair[1].end);
            let is_short = pair.iter().all(|side| side.len() as f32 <= self.cells(SIDE));
            let is_there = (self.closed || to < n) && 2 * (to - from) < n;
            let seen = (from..=to).map(|i| self.strengths[i % n]).sum::<f32>();
            (is_short && is_there && self.is_bump(from, to)).then_some(Bump { from, to, seen })
        };
        sides.windows(2).filter_map(bump).collect()
    }

    /// Whether what is between two vertices is low, and the border straight but for it.
    fn is_bump(&self, from: usize, to: usize) -> bool {
        let n = self.points.len();
        let chord = self.at(to) - self.at(from);
        let Some(along) = chord.try_normalize().filter(|_| chord.length() <= self.cells(LONGEST)) else { return false };
        let aside = |i: usize| (self.at(i) - self.at(from)).cross(along).abs();
        let steps = self.cells(STRAIGHT).ceil() as usize;
        let before = |k: usize| if self.closed { Some(from + n - k % n) } else { from.checked_sub(k) };
        let after = |k: usize| Some(to + k).filter(|i| self.closed || *i < n);
        let is_straight = |i: Option<usize>| i.is_some_and(|i| aside(i) <= self.cells(ASIDE));
        (from..=to).all(|i| aside(i) <= self.cells(HIGHEST))
            && (1..=steps).all(|k| is_straight(before(k)) && is_straight(after(k)))
    }

    /// Runs of vertices at which hardly anything is seen along the border, from the first on at which something is.
    fn sides(&self) -> Vec<Range<usize>> {
        let n = self.points.len();
        let first = if self.closed { (0..n).find(|&i| !self.is_faint(i)) } else { Some(0) };
        let mut sides: Vec<Range<usize>> = Vec::new();
        let Some(first) = first else { return sides };
        for i in (first..first + n).filter(|&i| self.is_faint(i % n)) {
            match sides.last_mut() {
                Some(side) if side.end == i => side.end += 1,
                _ => sides.push(i..i + 1),
            }
        }
        sides
    }

    /// Whether little is seen at a vertex, for what is seen around it.
    fn is_faint(&self, i: usize) -> bool {
        let n = self.strengths.len();
        let other = |k: usize| match self.closed {
            true => Some((i + n + k - AROUND) % n),
            false => (i + k).checked_sub(AROUND).filter(|at| *at < n),
        };
        let greatest = (0..=2 * AROUND).filter_map(other).map(|at| self.strengths[at]).fold(0.0, f32::max);
        self.strengths[i] < FAINT * greatest
    }
}

#[cfg(test)]
mod tests;
