//! Which pixels belong to the strokes that were found, and what of another stroke does not.

use super::centre::{LONG, Stroke};
use crate::geom::polyline::Polyline;
use crate::geom::right_of;
use crate::geom::walk::runs;
use crate::units::{PxPoint, Size};

/// Which pixels belong to a stroke that was found.
#[derive(Debug, Clone)]
pub(in crate::edges) struct StrokeCover {
    pub(super) size: Size,
    cells: Vec<bool>,
    /// Those that are covered by a stroke itself.
    covered: Vec<bool>,
}

/// A stroke runs along in another where its middle is no farther beyond the other's width than this, px.
const COVERED: f32 = 1.0;
/// It does so for at least so many of its widths, and this much more, px; over less it crosses the other, or ends on
/// it.
const CROSSED_WIDTHS: f32 = 2.0;
const CROSSED: f32 = 8.0;
/// Of a part that is new one vertex in so many at least lies away from others and their sides.
const AWAY: usize = 3;
/// Beyond its width, a stroke moves edges this far out, in scales of the edge detector.
const OUTSIDE: f32 = 1.6;

impl StrokeCover {
    pub(super) fn new(size: Size) -> Self {
        Self { size, cells: vec![false; size.len()], covered: vec![false; size.len()] }
    }

    /// The pixels of all strokes, and as far around as they have their sides.
    pub(in crate::edges) fn by(strokes: &[Stroke], size: Size, sigma: f32) -> Self {
        let mut taken = Self::new(size);
        strokes.iter().for_each(|stroke| taken.add(stroke, sigma));
        taken
    }

    pub(super) fn add(&mut self, stroke: &Stroke, sigma: f32) {
        let size = self.size;
        let reaches = [(&mut self.cells, OUTSIDE * sigma), (&mut self.covered, COVERED)];
        for (cells, beyond) in reaches {
            let reach = 0.5 * stroke.width + beyond;
            for (a, b) in stroke.contour.segments() {
                let steps = (b.at - a.at).length().ceil().max(1.0) as usize;
                (0..=steps).for_each(|k| add_disc(cells, size, a.at.lerp(b.at, k as f32 / steps as f32), reach));
            }
        }
    }

    /// Whether a point is in a stroke or at its side.
    pub(in crate::edges) fn has(&self, at: PxPoint) -> bool {
        self.cells[self.cell(at)]
    }

    fn cell(&self, at: PxPoint) -> usize {
        let cell = |at: f32, count: u32| (at.max(0.0) as usize).min(count as usize - 1);
        cell(at.y, self.size.height) * self.size.width as usize + cell(at.x, self.size.width)
    }

    /// The parts of a stroke that do not run along in others: of a bar that stands on an axis, not its base.
    /// `is_found` tells that it is mostly another one: found once more, it may lie a little aside.
    pub(super) fn beside(&self, stroke: Stroke, is_found: bool) -> Vec<Stroke> {
        let n = stroke.contour.vertices.len();
        let mut is_own: Vec<bool> =
            stroke.contour.vertices.iter().map(|vertex| !self.covered[self.cell(vertex.at)]).collect();
        // others cross it where they cover less
        let crossed = CROSSED_WIDTHS * stroke.width + CROSSED;
        for run in runs(n, stroke.contour.closed, |a, b| is_own[a] == is_own[b]) {
            let is_end = !stroke.contour.closed && (run[0] == 0 || run.ends_with(&[n - 1]));
            if !is_own[run[0]] && !is_end && part(&stroke, &run).contour.length() < crossed {
                run.iter().for_each(|&i| is_own[i] = true);
            }
        }
        if is_own.iter().all(|own| *own) {
            return vec![stroke];
        }
        let own = runs(n, stroke.contour.closed, |a, b| is_own[a] == is_own[b]).into_iter();
        let parts = own.filter(|run| is_own[run[0]]).map(|run| part(&stroke, &run));
        let is_new = |part: &Stroke| {
            let vertices = &part.contour.vertices;
            let away = vertices.iter().filter(|vertex| !self.has(vertex.at)).count();
            part.contour.length() >= LONG * part.width && (!is_found || AWAY * away >= vertices.len())
        };
        parts.filter(is_new).collect()
    }

    /// What of a stroke is no other's and does not lie between others, if that is long enough to be one: as eaves go on
    /// beyond a wall.
    pub(super) fn rest_of(&self, stroke: &Stroke, sigma: f32) -> Vec<Stroke> {
        let vertices = &stroke.contour.vertices;
        let is_taken = |i: usize| self.has(vertices[i].at) || self.is_between(stroke, i, sigma);
        let is_taken: Vec<bool> = (0..vertices.len()).map(is_taken).collect();
        let runs = runs(vertices.len(), stroke.contour.closed, |a, b| is_taken[a] == is_taken[b]).into_iter();
        let rest = runs.filter(|run| !is_taken[run[0]]).map(|run| part(stroke, &run));
        rest.filter(|rest| rest.contour.length() >= LONG * rest.width).collect()
    }

    /// Whether both sides of a stroke are those of others at one of its vertices: what is seen there is their gap.
    fn is_between(&self, stroke: &Stroke, i: usize, sigma: f32) -> bool {
        let across = right_of(stroke.contour.tangent(i)) * (0.5 * stroke.width + 0.5 * sigma);
        let at = stroke.contour.vertices[i].at;
        self.has(at + across) && self.has(at - across)
    }

    /// What most of a stroke is.
    pub(super) fn most_of(&self, stroke: &Stroke, sigma: f32) -> Most {
        let n = stroke.contour.vertices.len();
        let count = |of: &dyn Fn(usize) -> bool| (0..n).filter(|&i| of(i)).count();
        let on = count(&|i| self.has(stroke.contour.vertices[i].at));
        let between = count(&|i| self.is_between(stroke, i, sigma));
        match (2 * on > n, 2 * between > n) {
            (true, _) => Most::On,
            (false, true) => Most::Between,
            (false, false) => Most::Own,
        }
    }
}

/// The part of a stroke through some of its vertices.
fn part(stroke: &Stroke, vertices: &[usize]) -> Stroke {
    let vertices = vertices.iter().map(|&i| stroke.contour.vertices[i]).collect();
    Stroke { contour: Polyline::open(vertices), ..*stroke }
}

/// What most of a stroke is beside those that were found before.
pub(super) enum Most {
    /// A stroke of its own.
    Own,
    /// Another one, or at its side.
    On,
    /// What lies between others: both its sides are theirs.
    Between,
}

/// Sets the pixels whose centres lie within a disc.
fn add_disc(cells: &mut [bool], size: Size, at: PxPoint, radius: f32) {
    let range = |at: f32, most: u32| {
        let first = (at - radius - 0.5).ceil().max(0.0) as usize;
        first..((at + radius + 0.5).floor().max(0.0) as usize).min(most as usize)
    };
    for y in range(at.y, size.height) {
        for x in range(at.x, size.width) {
            let (dx, dy) = (x as f32 + 0.5 - at.x, y as f32 + 0.5 - at.y);
            if dx * dx + dy * dy <= radius * radius {
                cells[y * size.width as usize + x] = true;
            }
        }
    }
}
