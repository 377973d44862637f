//! Gridlines, as behind the bars of a chart or under a curve: faint straight ones. Labels may stand on them, and
//! they are interrupted there, as in print.

use super::placed::{Params, Placed};
use crate::geom::polygon::distance_to_box;
use crate::page::{Line, Pen, Run, which_are_gridlines, which_are_weak, without_treads};
use crate::units::{MmPoint, MmRect};

/// Least straightness of a gridline, chord to length: one of 100 mm bends by half a mm.
const STRAIGHTNESS: f32 = 0.9999;
/// What is left of such a line between labels, or beside one, and is shorter than this, mm, goes too: it would be felt
/// as a tick. The least length of lines on grids of 2.5 mm.
pub(super) const SCRAP: f32 = 12.0;
/// Step in which a stroke is interrupted, mm.
const STEP: f32 = 0.25;
/// Two lines that end beside one another are nearer than this, mm, or they meet.
const MEETS: f32 = 0.5;

/// A leader line begins where one of a drawing does, mm: lines are moved by less.
const AT_LEADER: f32 = 3.0;

/// Which lines of a figure give way to labels: gridlines. Leader lines of the drawing that lie side by side are none;
/// they begin at these places.
pub(super) fn giving_way(lines: &[Line], least_strength: f32, leaders: &[MmPoint]) -> Vec<bool> {
    let is_leader = |end: MmPoint| leaders.iter().any(|leader| (*leader - end).length() < AT_LEADER);
    let ends = |(line, is_weak): (&Line, bool)| match &line.runs[..] {
        [run] if is_weak && run.points.len() > 1 && run.polyline().chord() >= STRAIGHTNESS * run.length() => {
            let ends = [run.points[0], run.points[run.points.len() - 1]];
            (!ends.into_iter().any(is_leader)).then_some(ends)
        }
        _ => None,
    };
    let ends: Vec<_> = lines.iter().zip(which_are_weak(lines, least_strength)).map(ends).collect();
    let mut found = which_are_gridlines(&ends);
    let points: Vec<Vec<MmPoint>> = lines.iter().map(|line| line.runs.iter().flat_map(Run::path).collect()).collect();
    without_treads(&mut found, &ends, &points);
    found
}

/// Interrupts the gridlines at the labels that stand on them. Gives for each line that is left which one it was.
pub(super) fn interrupt(lines: &mut Vec<Line>, placed: &[&Placed], params: &Params) -> Vec<usize> {
    let blank: Vec<MmRect> =
        placed.iter().map(|label| label.place.inflate(params.clearance, params.clearance)).collect();
    let giving_way = giving_way(lines, params.least_strength, &params.leaders);
    let mut ends = Vec::new();
    let parts = |(number, (line, gives_way))| {
        let parts = if gives_way { outside(line, &blank, &mut ends, params) } else { vec![line] };
        parts.into_iter().map(move |part| (number, part))
    };
    let all = std::mem::take(lines).into_iter().zip(giving_way).enumerate().flat_map(parts);
    let numbers;
    (numbers, *lines) = all.unzip();
    numbers
}

/// The parts of a straight line whose ink lies outside of some boxes. Where they end beside one of the `ends` of others
/// they are shorter: gridlines that cross under the corner of a label.
fn outside(line: Line, blank: &[MmRect], ends: &mut Vec<MmPoint>, params: &Params) -> Vec<Line> {
    let run = &line.runs[0];
    let is_outside = |at: &MmPoint| blank.iter().all(|place| distance_to_box(*at, *place) >= 0.5 * run.width);
    let points = match run.pen {
        Pen::Dots(_) => run.points.clone(),
        Pen::Stroke => steps(run),
    };
    if points.iter().all(is_outside) {
        return vec![line];
    }
    let mut parts = Vec::new();
    let mut at = 0;
    for part in points.chunk_by(|a, b| is_outside(a) == is_outside(b)) {
        let (is_first, is_last) = (at == 0, at + part.len() == points.len());
        at += part.len();
        let is_beside = |end: &MmPoint| {
            let apart = ends.iter().map(|other| (*other - *end).length());
            apart.into_iter().any(|apart| apart > MEETS && apart < params.line_gap + run.width)
        };
        let mut part = if is_outside(&part[0]) { part } else { &[] };
        while let [end, rest @ ..] = part
            && !is_first
            && is_beside(end)
        {
            part = rest;
        }
        while let [rest @ .., end] = part
            && !is_last
            && is_beside(end)
        {
            part = rest;
        }
        let (Some(&first), Some(&last)) = (part.first(), part.last()) else { continue };
        if (last - first).length() >= SCRAP {
            let points = if run.pen == Pen::Stroke { vec![first, last] } else { part.to_vec() };
            parts.push(Line { strength: line.strength, runs: vec![Run { points, ..run.clone() }] });
            ends.extend([(!is_first).then_some(first), (!is_last).then_some(last)].into_iter().flatten());
        }
    }
    parts
}

/// The ends of a straight stroke and what lies between them.
fn steps(run: &Run) -> Vec<MmPoint> {
    let (first, last) = (run.points[0], run.points[run.points.len() - 1]);
    let count = ((last - first).length() / STEP).ceil().max(1.0) as u32;
    (0..=count).map(|step| first.lerp(last, step as f32 / count as f32)).collect()
}

#[cfg(test)]
mod tests;
