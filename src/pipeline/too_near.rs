//! The last look at the lines of a drawing: where two are nearer than fingers tell apart, the lesser is cut.
//!
//! Lines are kept apart before they are simplified, and before they become dots. In a crowded drawing what comes of
//! that may still be too near: lines that cross at flat angles, or rows of dots that were moved. The rules of the check
//! say where.

use super::hand_lines::has_added;
use super::lost_signs::{extent, is_small};
use super::torn_lines::params_of_dots;
use crate::edges::Edges;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::ninths::ninth;
use crate::legibility::{MediumLimits, Near, RuleLimits, near_lines, short_lines};
use crate::lines::{
    GAP, Line, Lines, LostLine, LostSign, Pen, Run, SignKind, TORN, TearParams, arrows, lost_form, tears,
    which_are_weak,
};
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect};

/// How often lines are cut before those that are still too near to others are left out: where a cut makes two lines of
/// one, each is judged once more. Chosen by us, as all numbers here.
const ROUNDS: usize = 4;
/// How often that is looked at in all: what is left out may have joined two others.
const MOST_ROUNDS: usize = 12;
/// Places of a stroke are looked at this often, mm.
const STEP: f32 = 0.2;
/// A cut ends that much beyond where it must, mm: numbers of a page are rounded.
const BEYOND: f32 = 0.05;
/// A piece between two cuts is at least so many least lengths long.
const SCRAP: f32 = 3.0;

/// What is asked of lines in a part of a page.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules<'a> {
    area: MmRect,
    medium: &'a Medium,
    limits: RuleLimits,
    /// Whether a ring that is cut counts as lost, as in an overview.
    whole_rings: bool,
    /// How open lines that are cut are looked at.
    tears: TearParams,
    /// The least strength of a line.
    least_strength: f32,
}

impl<'a> Rules<'a> {
    /// Those of the lines of a drawing in `area`. None of photographs, and none where a person drew some, which stay as
    /// they are.
    pub(super) fn of(edges: &Edges, area: MmRect, whole_rings: bool, layout: &'a Layout, plan: &Plan) -> Option<Self> {
        let is_asked = edges.of_drawing() && !has_added(edges);
        is_asked.then(|| Self::among(area, whole_rings, &layout.medium, plan))
    }

    fn among(area: MmRect, whole_rings: bool, medium: &'a Medium, plan: &Plan) -> Self {
        let lines = plan.lines();
        let tears = match medium {
            Medium::Print(_) => TearParams { reach: lines.farthest_moved(), least: TORN },
            Medium::Dots(medium) => params_of_dots(medium.pitch),
        };
        Self { area, medium, limits: plan.limits(), whole_rings, tears, least_strength: lines.least_strength }
    }
}

/// Cuts lines that are too near to others, or to themselves, and leaves out what is too short then.
pub(super) fn cut(drawn: &mut Lines, rules: &Rules<'_>) {
    // those that were too short before any was cut stay
    let mut was_short: Option<Vec<bool>> = None;
    for round in 0..MOST_ROUNDS {
        let lines = std::mem::take(&mut drawn.lines);
        let (near, _) = near_lines(&lines, rules.medium, &rules.limits);
        if near.is_empty() && was_short.is_none() {
            drawn.lines = lines;
            return;
        }
        let mut is_short = vec![false; lines.len()];
        short_lines(&lines, &rules.limits).into_iter().for_each(|line| is_short[line] = true);
        let stays_short = was_short.take().unwrap_or_else(|| is_short.clone());
        let short: Vec<usize> = (0..lines.len()).filter(|line| is_short[*line] && !stays_short[*line]).collect();
        if near.is_empty() && short.is_empty() {
            drawn.lines = lines;
            return;
        }
        let (others, weak) = (Others::of(&lines, rules), which_are_weak(&lines, rules.least_strength));
        let heads: Vec<usize> = arrows(&lines).into_iter().filter_map(|arrow| arrow.head).collect();
        let mut cuts: Vec<Vec<Cut>> = vec![Vec::new(); lines.len()];
        let mut is_out = vec![false; lines.len()];
        short.into_iter().for_each(|line| is_out[line] = true);
        for near in &near {
            let (line, other) = lesser_first(&lines, near.lines);
            is_out[line] |= round >= ROUNDS || heads.contains(&line);
            cuts[line].push(Cut::of(near, (line, other), rules));
        }
        let mut kept: Vec<(Line, bool)> = Vec::with_capacity(lines.len());
        for (number, line) in lines.into_iter().enumerate() {
            if !is_out[number] && cuts[number].is_empty() {
                kept.push((line, stays_short[number]));
            } else if !is_out[number] {
                let cut = CutLine { number, is_weak: weak[number], cuts: &cuts[number] };
                let pieces = without(&line, cut, &others, drawn, rules);
                if pieces.is_empty() {
                    tell_gone(&line, drawn, rules);
                }
                kept.extend(pieces.into_iter().map(|line| (line, false)));
            } else if heads.contains(&number) {
                is_not_drawn(&line, drawn);
            } else {
                let length = length(&line);
                drawn.lost.lost += length;
                drawn.lost.by_place[ninth(extent(&line).center(), rules.area)] += length;
                tell_gone(&line, drawn, rules);
            }
        }
        let (lines, short): (Vec<Line>, Vec<bool>) = kept.into_iter().unzip();
        (drawn.lines, was_short) = (lines, Some(short));
    }
}

/// The two numbers of lines that are too near, that which is cut first: an open one before a closed one, and of two
/// the shorter.
fn lesser_first(lines: &[Line], (one, other): (usize, usize)) -> (usize, usize) {
    let rank = |number: usize| (lines[number].goes_round(), length(&lines[number]));
    let ((one_closed, one_length), (other_closed, other_length)) = (rank(one), rank(other));
    let other_first = other_closed.cmp(&one_closed).then(other_length.total_cmp(&one_length)).is_lt();
    if other_first { (other, one) } else { (one, other) }
}

/// Length of a line, mm; of dots that of its row.
fn length(line: &Line) -> f32 {
    line.own_runs().iter().map(Run::length).sum()
}

/// What is taken out of a line: what lies in a box and is near to another line, or the stretch through a place where
/// the line is too near to itself.
#[derive(Debug, Clone, Copy)]
struct Cut {
    within: MmRect,
    /// The other line; none where the line is too near to itself.
    other: Option<u32>,
    at: MmPoint,
}

impl Cut {
    fn of(near: &Near, (line, other): (usize, usize), rules: &Rules<'_>) -> Self {
        let margin = match rules.limits.medium {
            _ if line == other => BEYOND,
            MediumLimits::Print { line_gap, .. } => line_gap,
            MediumLimits::Dots { line_gap, pitch, .. } => (line_gap + 1) as f32 * pitch,
        };
        let other = (line != other).then_some(other as u32);
        Self { within: near.extent.inflate(margin, margin), other, at: near.at }
    }

    /// The places of a line that are taken out.
    fn taken(&self, places: &[Place], others: &Others, limits: &RuleLimits) -> Vec<bool> {
        let is_within = |place: &Place| self.within.contains_inclusive(place.at);
        let Some(other) = self.other else {
            let mut taken = vec![false; places.len()];
            let far = |i: &usize| (places[*i].at - self.at).square_length();
            let Some(middle) = (0..places.len()).min_by(|a, b| far(a).total_cmp(&far(b))) else { return taken };
            let before = places[..middle].iter().rev().take_while(|place| is_within(place)).count();
            let after = places[middle..].iter().take_while(|place| is_within(place)).count();
            taken[middle - before..(middle + after.max(1))].fill(true);
            return taken;
        };
        places.iter().map(|place| is_within(place) && others.is_near(place, other, limits)).collect()
    }
}

/// Lines by place.
struct Others {
    index: Nearby,
    /// Half the greatest width, mm.
    widest: f32,
}

impl Others {
    fn of(lines: &[Line], rules: &Rules<'_>) -> Self {
        let mut index = Nearby::new(rules.area, rules.limits.line_length);
        for (number, line) in (0..).zip(lines) {
            for run in &line.runs {
                let half_width = 0.5 * run.width;
                match run.pen {
                    Pen::Stroke => index.insert_line(number, run.polyline(), half_width),
                    Pen::Dots(_) => run.points.iter().for_each(|&at| {
                        index.insert(Segment { a: at, b: at, half_width, line: number, index: 0, arc: 0.0 });
                    }),
                }
            }
        }
        let widths = lines.iter().flat_map(|line| &line.runs).map(|run| run.width);
        Self { index, widest: 0.5 * widths.fold(0.0, f32::max) }
    }

    /// Whether a place of a line is too near to another line.
    fn is_near(&self, place: &Place, other: u32, limits: &RuleLimits) -> bool {
        let own = 0.5 * place.width;
        let reach = match limits.medium {
            MediumLimits::Print { line_gap, .. } => line_gap + own + self.widest + BEYOND,
            MediumLimits::Dots { line_gap, pitch, .. } => (line_gap + 1) as f32 * pitch * std::f32::consts::SQRT_2,
        };
        let mut is_near = false;
        self.index.around_point(place.at, reach, |segment| {
            let (distance, nearest) = nearest_on_segment(place.at, segment.a, segment.b);
            is_near |= segment.line == other
                && match limits.medium {
                    MediumLimits::Print { line_gap, .. } => distance < line_gap + own + segment.half_width + BEYOND,
                    // so many dots are empty, rounded: along rows, columns and diagonals
                    MediumLimits::Dots { line_gap, pitch, .. } => {
                        let apart = nearest - place.at;
                        apart.x.abs().max(apart.y.abs()) < (line_gap as f32 + 0.5) * pitch
                    }
                };
        });
        is_near
    }
}

/// A place of a line: of strokes every [`STEP`], of dots each.
#[derive(Debug, Clone, Copy)]
struct Place {
    at: MmPoint,
    /// Width from here on.
    width: f32,
    is_vertex: bool,
}

/// The places of a line in order; of a ring of strokes the first comes again at the end.
fn places(line: &Line) -> Vec<Place> {
    let mut all: Vec<Place> = Vec::new();
    for run in line.own_runs() {
        let width = run.width;
        if run.pen != Pen::Stroke {
            return run.points.iter().map(|&at| Place { at, width, is_vertex: true }).collect();
        }
        // each run begins where the one before it ends
        all.pop();
        for (a, b) in run.polyline().segments() {
            let steps = ((*b - *a).length() / STEP).ceil().max(1.0);
            let place = |k: u32| Place { at: a.lerp(*b, k as f32 / steps), width, is_vertex: k == 0 };
            all.extend((0..steps as u32).map(place));
        }
        all.extend(run.path().last().map(|at| Place { at, width, is_vertex: true }));
    }
    all
}

/// A line that is cut.
#[derive(Debug, Clone, Copy)]
struct CutLine<'c> {
    number: usize,
    /// Whether it gives way to all others, as a gridline.
    is_weak: bool,
    cuts: &'c [Cut],
}

/// The pieces of a line that are left without what its cuts take; that is counted as lost.
fn without(line: &Line, of: CutLine<'_>, others: &Others, drawn: &mut Lines, rules: &Rules<'_>) -> Vec<Line> {
    let mut places = places(line);
    let mut is_out = vec![false; places.len()];
    for cut in of.cuts {
        let taken = cut.taken(&places, others, &rules.limits);
        is_out.iter_mut().zip(taken).for_each(|(is_out, taken)| *is_out |= taken);
    }
    if let Some(start) = is_out.iter().position(|is_out| *is_out).filter(|_| line.goes_round()) {
        // the first piece goes on from the last
        if line.row().is_none() {
            places.pop();
            is_out.pop();
        }
        let start = start % places.len().max(1);
        places.rotate_left(start);
        is_out.rotate_left(start);
    }
    // a scrap between two cuts, as where a line crosses another at a flat angle, says nothing
    let ends = |row: &std::ops::Range<usize>| row.start == 0 || row.end == places.len();
    let length = |row: &std::ops::Range<usize>| {
        places[row.clone()].windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum::<f32>()
    };
    let is_scrap = |row: &std::ops::Range<usize>| {
        (line.goes_round() || !ends(row)) && length(row) < SCRAP * rules.limits.line_length
    };
    let scraps: Vec<_> = stretches(&is_out, false).filter(is_scrap).collect();
    scraps.into_iter().for_each(|row| is_out[row].fill(true));
    if !line.goes_round() && !of.is_weak {
        drawn.lost.torn.extend(torn(&places, &is_out, of.number, others, rules));
    }
    for out in stretches(&is_out, true) {
        let from = out.start.saturating_sub(1);
        let stretch = &places[from..(out.end + 1).min(places.len())];
        let mut length = 0.0;
        for pair in stretch.windows(2) {
            let step = (pair[1].at - pair[0].at).length();
            drawn.lost.by_place[ninth(pair[0].at, rules.area)] += step;
            length += step;
        }
        drawn.lost.lost += length;
        if line.goes_round() && length > GAP {
            drawn.lost.rings += usize::from(rules.whole_rings);
            let extent = MmRect::from_points(stretch.iter().map(|place| place.at));
            drawn.lost.gaps.push(LostLine { extent, length, closed: true, is_faint: false, form: None });
        }
    }
    let rows: Vec<_> = stretches(&is_out, false).collect();
    let mut pieces: Vec<Line> =
        rows.iter().map(|row| Line { runs: runs(&places[row.clone()], line), ..line.clone() }).collect();
    add_beside(&mut pieces, line, &places, &rows);
    pieces.retain(|piece| piece.runs.iter().any(|run| run.points.len() > 1));
    pieces
}

/// What is missing of an open line, of which these places are out.
fn torn(places: &[Place], is_out: &[bool], number: usize, others: &Others, rules: &Rules<'_>) -> Vec<LostLine> {
    let mut piece_at = vec![None; places.len()];
    // a single place is no piece
    let pieces = stretches(is_out, false).filter(|piece| piece.len() > 1).enumerate();
    pieces.for_each(|(piece, row)| piece_at[row].fill(Some(piece)));
    let kept: Vec<MmPoint> =
        places.iter().zip(&piece_at).filter(|(_, piece)| piece.is_some()).map(|(place, _)| place.at).collect();
    let reach = rules.tears.reach;
    let is_near = |at: MmPoint| {
        let is_other = |segment: &Segment| segment.line as usize != number;
        others.index.nearest(at, reach, is_other).is_some() || kept.iter().any(|own| (*own - at).length() <= reach)
    };
    let path: Vec<MmPoint> = places.iter().map(|place| place.at).collect();
    tears(&path, &piece_at, is_near, [false; 2], rules.tears)
}

/// Adds to the pieces of a row of dots, with the places of each, what stands beside it: with the nearest of its dots.
fn add_beside(pieces: &mut [Line], line: &Line, places: &[Place], rows: &[std::ops::Range<usize>]) {
    for run in line.runs.iter().skip(line.own_runs().len()) {
        let piece_of = |at: &MmPoint| {
            let distance = |i: &usize| (places[*i].at - *at).square_length();
            let nearest = (0..places.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
            rows.iter().position(|row| row.contains(&nearest))
        };
        let owners: Vec<Option<usize>> = run.points.iter().map(piece_of).collect();
        for (number, piece) in pieces.iter_mut().enumerate() {
            let own = run.points.iter().zip(&owners).filter(|(_, owner)| **owner == Some(number));
            let points: Vec<MmPoint> = own.map(|(at, _)| *at).collect();
            if !points.is_empty() {
                piece.runs.push(Run { points, ..run.clone() });
            }
        }
    }
}

/// The ranges in which all are `which`.
fn stretches(of: &[bool], which: bool) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut from = 0;
    let chunks = of.chunk_by(|a, b| a == b).map(move |chunk| {
        let range = from..from + chunk.len();
        from = range.end;
        (chunk[0], range)
    });
    chunks.filter(move |(is, _)| *is == which).map(|(_, range)| range)
}

/// The runs of a piece of a line.
fn runs(places: &[Place], line: &Line) -> Vec<Run> {
    if let Some(row) = line.row() {
        return vec![Run { points: places.iter().map(|place| place.at).collect(), ..row.clone() }];
    }
    let mut runs: Vec<(f32, Vec<MmPoint>)> = Vec::new();
    let last = places.len() - 1;
    for (i, place) in places.iter().enumerate() {
        if let Some((width, points)) = runs.last_mut() {
            if place.is_vertex || i == last {
                points.push(place.at);
            }
            if width.total_cmp(&place.width).is_eq() {
                continue;
            }
        }
        if i < last {
            runs.push((place.width, vec![place.at]));
        }
    }
    runs.into_iter().map(|(width, points)| Run::stroke(width, points)).collect()
}

/// Says of the head of an arrow that it is not drawn.
fn is_not_drawn(head: &Line, drawn: &mut Lines) {
    let far = |at: MmPoint| (at - extent(head).center()).square_length();
    let marks = drawn.marks.heads.iter_mut().filter(|mark| mark.is_drawn);
    if let Some(mark) = marks.min_by(|a, b| far(a.at).total_cmp(&far(b.at))) {
        mark.is_drawn = false;
    }
}

/// Names a line that is left out as a whole.
fn tell_gone(line: &Line, drawn: &mut Lines, rules: &Rules<'_>) {
    let (extent, length, closed, lost) = (extent(line), length(line), line.goes_round(), &mut drawn.lost);
    lost.rings += usize::from(closed);
    // on paper small rings that are lost are looked for later
    if closed && is_small(extent) && matches!(rules.medium, Medium::Dots(_)) {
        lost.signs.push(LostSign { at: extent.center(), kind: SignKind::Ring });
    }
    let form = if closed { None } else { lost_form(&line.own_path()) };
    lost.gone.push(LostLine { extent, length, closed, is_faint: false, form });
}

#[cfg(test)]
mod tests;
