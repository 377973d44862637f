//! One line of a page as a person drew it: from runs and marks on them, and what of it lies in the figure.

use crate::lines::{Line, Pen, Run};
use crate::pipeline::cut_contours::parts_left;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, MmVector};

/// Lines may lie this far outside of their figure, mm: a stroke has a width.
const OUTSIDE: f32 = 0.5;
/// Most steps in which a side of a line that leaves the figure is looked at.
const MOST_STEPS: f32 = 10_000.0;
/// Places that differ by less are one but for rounding, in shares of the figure.
const ROUNDED: f32 = 1e-5;
/// So many points are a circle.
const CIRCLE: u32 = 24;

/// A line in shares of the width and height of its figure.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HandLine {
    /// Which line of the figure it is, or a part of.
    pub(super) of_line: usize,
    /// Each with its strength.
    pub(super) vertices: Vec<([f32; 2], f32)>,
    pub(super) closed: bool,
    /// Whether it is the side of a disc: of a filled point on a line.
    pub(super) is_disc: bool,
}

impl HandLine {
    /// The strokes of a line of the figure, which has this number, each of several runs that follow one another.
    /// `share` says where in the figure a place of the sheet is, and `plan` for which strength a width stands.
    pub(super) fn strokes_of(
        line: &Line,
        of_line: usize,
        share: impl Fn(MmPoint) -> [f32; 2],
        plan: &Plan,
    ) -> Vec<Self> {
        let stroke = |runs: Vec<&Run>| {
            let closed = runs.len() == 1 && runs[0].closed;
            let mut vertices = Vec::new();
            for (number, run) in runs.iter().enumerate() {
                let strength = strength(run, line.strength, plan);
                // it begins where the one before it ends
                let skip = usize::from(number > 0);
                vertices.extend(run.points.iter().skip(skip).map(|&at| (share(at), strength)));
            }
            let mut stroke = Self { of_line, vertices, closed, is_disc: false };
            stroke.close();
            stroke
        };
        joined(line.own_runs()).into_iter().map(stroke).collect()
    }

    /// The points and ticks on a line of the figure.
    pub(super) fn marks_of(line: &Line, of_line: usize, share: impl Fn(MmPoint) -> [f32; 2], plan: &Plan) -> Vec<Self> {
        let strength = line.strength.max(plan.lines().full_strength);
        let mark = |LineMark { points, closed, is_disc }: LineMark| {
            let vertices = points.into_iter().map(|at| (share(at), strength)).collect();
            Self { of_line, vertices, closed, is_disc }
        };
        marks_on(line).into_iter().map(mark).collect()
    }

    /// A line of several widths that comes back to where it began is a ring.
    fn close(&mut self) {
        let (Some((first, _)), Some((last, _))) = (self.vertices.first(), self.vertices.last()) else { return };
        let near = (first[0] - last[0]).abs() < ROUNDED && (first[1] - last[1]).abs() < ROUNDED;
        if !self.closed && near && self.vertices.len() > 3 {
            self.vertices.pop();
            self.closed = true;
        }
    }

    /// Its length in a figure of this width and height, mm.
    pub(super) fn length(&self, [width, height]: [f32; 2]) -> f32 {
        let distance = |a: [f32; 2], b: [f32; 2]| ((b[0] - a[0]) * width).hypot((b[1] - a[1]) * height);
        let ends = self.vertices.first().zip(self.vertices.last()).filter(|_| self.closed);
        let back = ends.map_or(0.0, |(first, last)| distance(last.0, first.0));
        back + self.vertices.windows(2).map(|pair| distance(pair[0].0, pair[1].0)).sum::<f32>()
    }

    /// Its parts inside the figure, of this width and height in mm.
    pub(super) fn parts_inside(self, [width, height]: [f32; 2]) -> Vec<Self> {
        let (x, y) = (OUTSIDE / width, OUTSIDE / height);
        let is_outside = |&([a, b], _): &([f32; 2], f32)| a < -x || a > 1.0 + x || b < -y || b > 1.0 + y;
        if !self.vertices.iter().any(is_outside) {
            return vec![self];
        }
        let Self { of_line, mut vertices, closed, is_disc } = self;
        if closed {
            vertices.extend(vertices.first().copied());
        }
        let mut fine = Vec::new();
        for pair in vertices.windows(2) {
            let [(a, strength), (b, other)] = [pair[0], pair[1]];
            let length = ((b[0] - a[0]) * width).hypot((b[1] - a[1]) * height);
            let steps = (length / OUTSIDE).ceil().clamp(1.0, MOST_STEPS);
            let at = |k: f32| ([a[0] + (b[0] - a[0]) * k, a[1] + (b[1] - a[1]) * k], strength + (other - strength) * k);
            fine.extend((0..steps as usize).map(|step| at(step as f32 / steps)));
        }
        fine.extend(vertices.last().filter(|_| !closed));
        let parts = parts_left(&fine, closed, is_outside).into_iter();
        parts.map(|(vertices, closed)| Self { of_line, vertices, closed, is_disc: is_disc && closed }).collect()
    }
}

/// A point or a tick on a line of a page, as it is in a drawing.
struct LineMark {
    points: Vec<MmPoint>,
    closed: bool,
    is_disc: bool,
}

/// The beads of a printed line, and the ticks, points and heads of one of dots.
fn marks_on(line: &Line) -> Vec<LineMark> {
    let circle = |at: MmPoint, radius: f32, is_disc: bool| {
        let turn = |k: u32| (k as f32 * std::f32::consts::TAU / CIRCLE as f32).sin_cos();
        let points = (0..CIRCLE).map(turn).map(|(y, x)| at + MmVector::new(x, y) * radius).collect();
        LineMark { points, closed: true, is_disc }
    };
    let beads = line.beads().map(|run| {
        let middle = MmRect::from_points(&run.points).center();
        circle(middle, 0.5 * run.width, true)
    });
    let points = line.row_points().map(|point| circle(point.at, point.radius, point.is_filled));
    let ticks = line.row_ticks().map(|(run, at)| {
        let points = std::iter::once(at).chain(run.points.last().copied()).collect();
        LineMark { points, closed: false, is_disc: false }
    });
    let heads = line.row_heads().map(|(tip, _, [one, other])| LineMark {
        points: vec![one, tip, other],
        closed: false,
        is_disc: false,
    });
    beads.chain(points).chain(ticks).chain(heads).collect()
}

/// Runs that follow one another, line by line.
fn joined(runs: &[Run]) -> Vec<Vec<&Run>> {
    let mut all: Vec<Vec<&Run>> = Vec::new();
    for run in runs {
        let last = all.last().and_then(|line| line.last()).filter(|last| !last.closed && !run.closed);
        let follows = last.is_some_and(|last| last.points.last() == run.points.first());
        match all.last_mut() {
            Some(line) if follows => line.push(run),
            _ => all.push(vec![run]),
        }
    }
    all
}

/// The strength whose lines are as wide as a run; of the widest, and of dots, that of the line.
fn strength(run: &Run, of_line: f32, plan: &Plan) -> f32 {
    let swell = plan.profile().print.swell;
    let graded = Some(run.width + swell).filter(|_| run.pen == Pen::Stroke).and_then(|width| graded(width, plan));
    graded.unwrap_or(of_line.max(plan.lines().full_strength))
}

/// The strength whose lines are so wide, mm; none of the widest.
pub(super) fn graded(width: f32, plan: &Plan) -> Option<f32> {
    let params = plan.lines();
    let range = (params.width_max - params.width_min).max(f32::EPSILON);
    let share = ((width - params.width_min) / range).clamp(0.0, 1.0);
    (share <= 0.99).then_some(params.least_strength + share * (params.full_strength - params.least_strength))
}
