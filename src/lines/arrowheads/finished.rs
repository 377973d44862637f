//! Arrows among finished lines: a head is two strokes, or rows of dots, that meet at the end of a line.

use super::shapes::{LENGTHS, SPREAD};
use crate::geom::polyline::PolylineRef;
use crate::geom::simplify::simplify;
use crate::lines::line::{Line, Pen, Run};
use crate::lines::row_marks::NEXT_DOT;
use crate::units::{MmPoint, MmVector};

/// Lengths of the strokes of a printed head, mm, as they are drawn or as somebody draws them.
const LENGTH: std::ops::RangeInclusive<f32> = 0.8 * LENGTHS[2]..=1.5 * LENGTHS[0];
/// Its two strokes differ by at most this share.
const ALIKE: f32 = 0.8;
/// How much its spread may differ from that which is drawn, degrees; on a grid it is 45.
const SPREADS: std::ops::RangeInclusive<f32> = SPREAD - 10.0..=SPREAD + 22.0;
/// Greatest distance of the tip from the end of its shaft, mm; on a row of dots it is that of the next dot.
const AT_END: f32 = 0.3;
/// How far a stroke may be off straight, mm.
const STRAIGHT: f32 = 0.1;
/// The direction of a shaft is taken over this length, mm.
const HEADING: f32 = 6.0;

/// An arrow: the end of a line that has a head.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrow {
    /// The number of its line.
    pub line: usize,
    /// The number of the line that is its head; on dots that is part of its own.
    pub head: Option<usize>,
    /// Its tip.
    pub at: MmPoint,
    /// Which way it points.
    pub toward: MmVector,
    /// The ends of the strokes of its head.
    pub wings: [MmPoint; 2],
}

/// The arrows among lines: those whose head is certain.
pub fn arrows(lines: &[Line]) -> Vec<Arrow> {
    let printed = lines.iter().enumerate().filter_map(|(number, line)| {
        let (at, wings) = printed_head(line)?;
        let shafts = lines.iter().enumerate().filter(|(other, _)| *other != number);
        shafts.into_iter().find_map(|(shaft, line)| {
            let toward = ends(line).into_iter().find(|(end, _)| (*end - at).length() <= AT_END)?.1;
            let is_long = line.length() > (wings[0] - at).length();
            let arrow = Arrow { line: shaft, head: Some(number), at, toward, wings };
            (is_long && arrow.points()).then_some(arrow)
        })
    });
    let dotted = lines.iter().enumerate().flat_map(|(number, line)| {
        line.row_heads().map(move |(at, toward, wings)| Arrow { line: number, head: None, at, toward, wings })
    });
    printed.chain(dotted).collect()
}

impl Arrow {
    /// Whether both strokes lead back from the tip at about the angle of a head.
    fn points(&self) -> bool {
        let back = -self.toward;
        let angle = |wing: MmPoint| back.angle_to(wing - self.at).to_degrees();
        let [one, other] = self.wings.map(angle);
        one * other < 0.0 && SPREADS.contains(&one.abs()) && SPREADS.contains(&other.abs())
    }
}

/// The tip and the ends of a line of two strokes that are alike.
fn printed_head(line: &Line) -> Option<(MmPoint, [MmPoint; 2])> {
    let path: Vec<MmPoint> = line.runs.iter().filter(|run| run.pen == Pen::Stroke).flat_map(Run::path).collect();
    let corners = simplify(PolylineRef { vertices: &path, closed: false }, STRAIGHT);
    let [from, tip, to] = corners[..] else { return None };
    let [from, tip, to] = [path[from], path[tip], path[to]];
    let [one, other] = [(from - tip).length(), (to - tip).length()];
    let is_head = LENGTH.contains(&one) && LENGTH.contains(&other) && one.min(other) >= ALIKE * one.max(other);
    is_head.then_some((tip, [from, to]))
}

/// The ends of a printed line, each with the direction in which it leads there.
fn ends(line: &Line) -> Vec<(MmPoint, MmVector)> {
    let path: Vec<MmPoint> = line.runs.iter().filter(|run| run.pen == Pen::Stroke).flat_map(Run::path).collect();
    let is_open = path.first() != path.last();
    let back: Vec<MmPoint> = path.iter().rev().copied().collect();
    [&path, &back].into_iter().filter(|_| is_open).filter_map(|path| end_of(path)).collect()
}

/// The first point of a path, and the direction in which the path leads to it.
fn end_of(path: &[MmPoint]) -> Option<(MmPoint, MmVector)> {
    let first = *path.first()?;
    let inner = path.iter().find(|at| (**at - first).length() >= HEADING).or(path.last())?;
    Some((first, (first - *inner).try_normalize()?))
}

impl Line {
    /// The heads at the ends of a row of dots: where the row ends, which way it leads there, and the outermost dots of
    /// the head.
    pub(crate) fn row_heads(&self) -> impl Iterator<Item = (MmPoint, MmVector, [MmPoint; 2])> {
        let first = self.row();
        let heads = first.map(|first| {
            let back: Vec<MmPoint> = first.points.iter().rev().copied().collect();
            let ends = [&first.points, &back].map(|path| end_of(path));
            let steps = first.points.windows(2).map(|pair| (pair[1] - pair[0]).length());
            let step = steps.fold(f32::INFINITY, f32::min);
            let head = move |run: &Run| ends.into_iter().flatten().find_map(|end| row_head(run, end, step));
            self.runs.iter().skip(1).filter_map(head)
        });
        heads.into_iter().flatten()
    }
}

/// Whether a run of dots is the head at an end of a row with this step.
fn row_head(run: &Run, (at, toward): (MmPoint, MmVector), step: f32) -> Option<(MmPoint, MmVector, [MmPoint; 2])> {
    let count = run.points.len();
    if count < 4 || !count.is_multiple_of(2) {
        return None;
    }
    let wings = [run.points[0], run.points[count - 1]];
    let inner = [run.points[count / 2 - 1], run.points[count / 2]];
    let [one, other] = wings.map(|wing| (wing - at).length());
    let is_near = inner.iter().all(|dot| (*dot - at).length() <= NEXT_DOT * step);
    let arrow = Arrow { line: 0, head: None, at, toward, wings };
    (is_near && one.min(other) >= ALIKE * one.max(other) && arrow.points()).then_some((at, toward, wings))
}

#[cfg(test)]
mod tests;
