//! The clearance between lines whose dots can be anywhere. Their middles keep their distance already; where they
//! join, dots would fall on dots.

use crate::dots::marks::{self, Lattice, Placed, Row, Shown};
use crate::dots::params::{LEAST_DOTS, LEAST_STEP, Params, ROUNDED_OFF, polyline_of};
use crate::dots::{second_row, spacing};
use crate::geom::nearby::Index;
use crate::geom::polyline;
use crate::lines::{Line, LineMarks, which_are_weak};
use crate::units::{Mm, MmPoint, MmRect};

/// A row of dots leads to a line of which a dot is no farther from its end, in pitches.
const LEADS_TO: f32 = 1.5;

/// A line as its first row of dots.
struct FirstRow<'a> {
    line: &'a Line,
    row: Row,
}

/// Lines whose dots can be anywhere in `part` of the sheet, the strongest first. Second rows come last, where they
/// keep the gap from all other lines.
pub(in crate::dots) fn anywhere(
    lines: &[Line],
    marks: &LineMarks,
    part: MmRect,
    params: &Params,
) -> (Vec<Line>, Shown) {
    let part = part.inflate(ROUNDED_OFF, ROUNDED_OFF);
    let mut rows = first_rows(lines, part, params);
    let all: Vec<Row> = rows.iter().map(|first| first.row.clone()).collect();
    let free = Lattice::Free { part, pitch: params.pitch };
    let Placed { runs, hidden, has_points, alone, shown } = marks::place(marks, &all, free, params);
    for (own, first) in rows.iter_mut().enumerate() {
        first.row.dots.retain(|dot| !hidden[own].contains(dot));
    }
    drop_short(&mut rows, &has_points, part, params);
    let mut placed = ByPlace(Index::new(part, params.pitch));
    for (own, first) in rows.iter().enumerate() {
        first.row.dots.iter().chain(runs[own].iter().flatten()).for_each(|&at| placed.place(at, own));
    }
    let mut out = Vec::with_capacity(rows.len());
    for (own, FirstRow { line, row }) in rows.iter().enumerate() {
        let mut dots = vec![row.dots.clone()];
        if row.is_heavy && !has_points[own] && row.dots.len() >= LEAST_DOTS {
            dots.push(placed.second_row(own, row, part, params));
        }
        dots.extend(runs[own].iter().cloned());
        dots.retain(|dots| !dots.is_empty());
        let runs: Vec<_> = dots.into_iter().map(|dots| params.run(dots, params.height(line))).collect();
        out.extend((!runs.is_empty()).then_some(Line { strength: line.strength, runs }));
    }
    out.extend(alone.into_iter().map(|point| point.line(params)));
    (out, shown)
}

/// Takes all dots of those rows that too many dots of others have left too short for a line, as the two sides of a thin
/// shape do to one another; a row that leads from line to line may be short, and one with points on it is none.
fn drop_short(rows: &mut [FirstRow<'_>], has_points: &[bool], part: MmRect, params: &Params) {
    let mut placed = ByPlace(Index::new(part, params.pitch));
    for (own, first) in rows.iter().enumerate() {
        first.row.dots.iter().for_each(|&at| placed.place(at, own));
    }
    for (own, first) in rows.iter_mut().enumerate().filter(|(own, _)| !has_points[*own]) {
        let dots = &first.row.dots;
        let leads = |end: Option<&MmPoint>| {
            end.is_some_and(|&end| !placed.is_free(end, LEADS_TO * params.pitch, |line| line != own))
        };
        // a dot stands for half a pitch to both sides
        let length = polyline::length(dots) + params.pitch + ROUNDED_OFF;
        if length < params.min_length && !(leads(dots.first()) && leads(dots.last())) {
            first.row.dots.clear();
        }
    }
}

/// The first rows of lines, without dots that would fall on others.
fn first_rows<'a>(lines: &'a [Line], part: MmRect, params: &Params) -> Vec<FirstRow<'a>> {
    let least = LEAST_STEP * params.pitch;
    let mut placed = ByPlace(Index::new(part, params.pitch));
    let mut rows: Vec<FirstRow<'a>> = Vec::new();
    for (line, is_weak) in lines.iter().zip(which_are_weak(lines, params.least_strength)) {
        let polyline = polyline_of(line);
        let mut dots = spacing::evenly(polyline.view(), params.pitch);
        dots.retain(|&at| part.contains_inclusive(at) && placed.is_free(at, least, |_| true));
        // in millimetres they are long enough, or lead from line to line: dots of others stand for their ends
        if dots.len() >= LEAST_DOTS {
            let dots = placed.row(&dots, rows.len(), least);
            let row = Row { dots, closed: polyline.closed, is_heavy: params.has_second_row(line), is_weak };
            rows.push(FirstRow { line, row });
        }
    }
    rows
}

/// Dots by place, each with the number of its line.
struct ByPlace(Index<(MmPoint, usize), Mm>);

impl ByPlace {
    fn place(&mut self, at: MmPoint, line: usize) {
        self.0.put_at(at, (at, line));
    }

    /// Whether no dot of the lines that `counts` accepts is nearer than `gap` mm.
    fn is_free(&self, at: MmPoint, gap: f32, counts: impl Fn(usize) -> bool) -> bool {
        let mut is_free = true;
        self.0.around(at, at, gap, |&(other, line)| is_free &= !counts(line) || (other - at).length() >= gap);
        is_free
    }

    /// Places the dots of a line. It may come near itself at a corner: the dot there goes between its neighbours, as a
    /// line without it would be broken, or is left out.
    fn row(&mut self, dots: &[MmPoint], line: usize, least: f32) -> Vec<MmPoint> {
        let mut row: Vec<MmPoint> = Vec::new();
        for (i, &at) in dots.iter().enumerate() {
            let between = || row.last().zip(dots.get(i + 1)).map(|(before, after)| before.lerp(*after, 0.5));
            let place = [Some(at), between()].into_iter().flatten().find(|&at| self.is_free(at, least, |_| true));
            if let Some(at) = place {
                self.place(at, line);
                row.push(at);
            }
        }
        row
    }

    /// Places the second row of a line where it keeps the gap from all other lines; empty if that leaves too few dots.
    fn second_row(&mut self, own: usize, row: &Row, part: MmRect, params: &Params) -> Vec<MmPoint> {
        let gap = params.clearance() - ROUNDED_OFF;
        let mut second = Vec::new();
        for (_, at) in second_row::anywhere(&row.dots, row.closed, params.pitch) {
            let is_free = self.is_free(at, LEAST_STEP * params.pitch, |_| true);
            if part.contains_inclusive(at) && is_free && self.is_free(at, gap, |line| line != own) {
                self.place(at, own);
                second.push(at);
            }
        }
        if second.len() >= LEAST_DOTS { second } else { Vec::new() }
    }
}

#[cfg(test)]
mod tests;
