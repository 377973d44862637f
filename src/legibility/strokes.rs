//! Lines one by one: their width and length, and the blank between them.

use std::collections::BTreeSet;
use std::f32::consts::SQRT_2;

use super::dotted;
use super::finding::{FoundBreach, around};
use super::gaps::{self, Near};
use super::joins::APPROACH;
use super::limits::{CELL, LAST_DIGIT, MediumLimits, RuleLimits};
use super::marks::name_in;
use super::rules::{LINE_GAP, LINE_LENGTH, LINE_WIDTH};
use super::spaces::millimetres;
use crate::geom::nearby::{Index, Nearby};
use crate::geom::{nearest_on_segment, polyline};
use crate::listing::counted;
use crate::page::{Line, Medium, Pen, Run};
use crate::units::{Mm, MmPoint, MmRect};

/// What lines of one picture break; `names` say what they are called. Of one of several sheets, `window` is what it
/// shows of the picture: lines that end there go on on the next.
pub(super) fn findings(
    lines: &[Line],
    names: &[String],
    window: Option<MmRect>,
    medium: &Medium,
    limits: &RuleLimits,
) -> Vec<FoundBreach> {
    let mut found = Vec::new();
    let near = Surroundings::of(lines, limits);
    for (number, line) in lines.iter().enumerate() {
        found.extend(too_thin(line, name_in(names, number), limits));
        if !window.is_some_and(|window| goes_on(line, window, limits)) {
            found.extend(
                too_short_alone(number, lines, &near, limits).map(|short| short.breach(name_in(names, number), limits)),
            );
        }
    }
    let (near, are_all) = near_lines(lines, medium, limits);
    // two lines that are cut there may join on the next sheet
    let meet_beyond = |near: &&Near| window.is_some_and(|window| meet_beyond(near, lines, window, limits));
    let near = near.iter().filter(|near| !meet_beyond(near));
    found.extend(near.map(|near| too_near(near, names, medium, limits)));
    if !are_all {
        let what = "so many lines lie on one another that not all of their gaps were looked at";
        found.push(FoundBreach::of_page(LINE_GAP, None, what.to_owned()));
    }
    found
}

/// All places where lines of a page of this medium are nearer than they may be, and whether these are all.
pub fn near_lines(lines: &[Line], medium: &Medium, limits: &RuleLimits) -> (Vec<Near>, bool) {
    match (limits.medium, medium) {
        (MediumLimits::Print { line_gap, .. }, _) => {
            let (mut near, are_all) = gaps::all_too_near(lines, line_gap);
            near.retain(|near| !is_beside_disc(near, lines, line_gap));
            (near, are_all)
        }
        (MediumLimits::Dots { line_gap, .. }, Medium::Dots(dots)) => dotted::too_near(lines, line_gap, dots),
        (MediumLimits::Dots { line_gap, pitch, .. }, Medium::Print(_)) => {
            gaps::all_too_near(lines, line_gap as f32 * pitch)
        }
    }
}

/// Whether two lines are as near as a disc that stands for a point, such as one of a scatter plot, may be to another
/// line: with half the blank, or with none, so that it lies on that.
fn is_beside_disc(Near { lines: (a, b), gap, .. }: &Near, lines: &[Line], line_gap: f32) -> bool {
    let discs = [a, b].into_iter().filter(|line| lines[**line].is_disc()).count();
    let is_on = discs == 1 && *gap < -LAST_DIGIT;
    discs > 0 && (a == b || is_on || *gap >= Line::DISC_GAP * line_gap - LAST_DIGIT)
}

/// The numbers of the lines that are too short.
pub fn short_lines(lines: &[Line], limits: &RuleLimits) -> Vec<usize> {
    let near = Surroundings::of(lines, limits);
    (0..lines.len()).filter(|number| too_short_alone(*number, lines, &near, limits).is_some()).collect()
}

fn too_near(near: &Near, names: &[String], medium: &Medium, limits: &RuleLimits) -> FoundBreach {
    let Near { lines: (a, b), gap, at, length, extent } = *near;
    let (apart, least, gap) = match (limits.medium, medium) {
        (MediumLimits::Print { line_gap, .. }, _) => (millimetres(gap), format!("{line_gap} mm is the least"), gap),
        (MediumLimits::Dots { line_gap, .. }, Medium::Dots(_)) => {
            (counted(gap.round() as usize, "empty dot"), format!("{line_gap} are the least"), gap)
        }
        (MediumLimits::Dots { line_gap, pitch, .. }, Medium::Print(_)) => {
            let mm = millimetres(line_gap as f32 * pitch);
            (millimetres(gap), format!("{line_gap} empty dots of the device, {mm}, are the least"), gap / pitch)
        }
    };
    let along = format!("along {:.0} mm", length.max(1.0));
    let (one, other) = (name_in(names, a.min(b)), name_in(names, a.max(b)));
    let what = match a == b {
        true => format!("{one} comes back to itself and is {apart} from itself {along}; {least}"),
        false => format!("{} are {apart} apart {along}; {least}", both(one, other)),
    };
    FoundBreach::at(LINE_GAP, at, extent, gap, what).of(one)
}

/// Two lines by their names; those of one object have the same.
pub(super) fn both(one: &str, other: &str) -> String {
    if one == other { format!("two parts of {one}") } else { format!("{one} and {other}") }
}

fn points(line: &Line) -> impl Iterator<Item = MmPoint> + '_ {
    line.runs.iter().flat_map(|run| run.points.iter().copied())
}

fn too_thin(line: &Line, name: &str, limits: &RuleLimits) -> Option<FoundBreach> {
    let MediumLimits::Print { line_width, .. } = limits.medium else { return None };
    let is_thin = |run: &&Run| run.pen == Pen::Stroke && run.width < line_width - LAST_DIGIT;
    let thinnest = line.runs.iter().filter(is_thin).min_by(|a, b| a.width.total_cmp(&b.width))?;
    let length: f32 = line.runs.iter().filter(is_thin).map(Run::length).sum();
    let at = thinnest.points.get(thinnest.points.len() / 2).copied()?;
    let extent = around(line.runs.iter().filter(is_thin).flat_map(|run| run.points.iter().copied()))?;
    let what = format!("{name} is {:.2} mm wide along {length:.0} mm; {line_width} mm is the least", thinnest.width);
    Some(FoundBreach::at(LINE_WIDTH, at, extent, thinnest.width, what).of(name))
}

/// Whether a line ends at the edge of a window.
fn goes_on(line: &Line, window: MmRect, limits: &RuleLimits) -> bool {
    let reach = match limits.medium {
        MediumLimits::Print { .. } => line.runs.iter().map(|run| run.width).fold(0.0, f32::max),
        MediumLimits::Dots { pitch, .. } => pitch,
    };
    let inner = window.inflate(-reach, -reach);
    let ends = line.runs.iter().flat_map(|run| [run.points.first(), run.points.last()]).flatten();
    inner.is_negative() || ends.into_iter().any(|end| !inner.contains(*end))
}

/// Whether two lines, or a line and itself, are near to one another where both end at the edge of a window, so near to
/// that that they may join beyond it.
fn meet_beyond(near: &Near, lines: &[Line], window: MmRect, limits: &RuleLimits) -> bool {
    let least = match limits.medium {
        MediumLimits::Print { line_gap, .. } => line_gap,
        MediumLimits::Dots { line_gap, pitch, .. } => line_gap as f32 * pitch,
    };
    let (one, other) = near.lines;
    let inner = window.inflate(-APPROACH * least, -APPROACH * least);
    let is_at_edge = inner.is_negative() || !inner.contains(near.at);
    is_at_edge && goes_on(&lines[one], window, limits) && goes_on(&lines[other], window, limits)
}

/// The marks of lines by their places, to ask which others are near an end of one.
enum Surroundings {
    /// Strokes, with half of their widths, and the greatest width.
    Strokes(Nearby, f32),
    /// Dots, with their lines.
    Dots(Index<(usize, MmPoint), Mm>),
}

impl Surroundings {
    fn of(lines: &[Line], limits: &RuleLimits) -> Self {
        let area = around(lines.iter().flat_map(points)).unwrap_or_else(MmRect::zero);
        match limits.medium {
            MediumLimits::Print { .. } => {
                let mut strokes = Nearby::new(area, CELL);
                let runs = (0..).zip(lines).flat_map(|(line, of)| of.runs.iter().map(move |run| (line, run)));
                runs.for_each(|(line, run)| strokes.insert_line(line, run.polyline(), 0.5 * run.width));
                let widths = lines.iter().flat_map(|line| &line.runs).map(|run| run.width);
                Self::Strokes(strokes, widths.fold(0.0, f32::max))
            }
            MediumLimits::Dots { .. } => {
                let mut dots = Index::new(area, CELL);
                let all = lines.iter().enumerate().flat_map(|(line, of)| points(of).map(move |at| (line, at)));
                all.for_each(|(line, at)| dots.put_at(at, (line, at)));
                Self::Dots(dots)
            }
        }
    }

    /// Whether an end of a line, so broad, lies on a stroke of another.
    fn is_on_stroke(&self, line: usize, end: MmPoint, width: f32) -> bool {
        let Self::Strokes(strokes, widest) = self else { return false };
        let mut is_on = false;
        strokes.around(end, end, 0.5 * (width + *widest) + LAST_DIGIT, |of| {
            let near = || nearest_on_segment(end, of.a, of.b).0 <= 0.5 * width + of.half_width;
            is_on = is_on || of.line as usize != line && near();
        });
        is_on
    }

    /// Whether a dot of another line than these, within `reach` of the box around two places, is as asked.
    fn has_dot(
        &self,
        but: [usize; 2],
        (a, b): (MmPoint, MmPoint),
        reach: f32,
        is_it: impl Fn(MmPoint) -> bool,
    ) -> bool {
        let Self::Dots(dots) = self else { return false };
        let mut has = false;
        dots.around(a.min(b), a.max(b), reach + LAST_DIGIT, |(line, at)| {
            has = has || !but.contains(line) && is_it(*at)
        });
        has
    }

    /// The lines of dots of which some may lie within `reach` of a place.
    fn lines_around(&self, at: MmPoint, reach: f32) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        if let Self::Dots(dots) = self {
            dots.around(at, at, reach + LAST_DIGIT, |(line, _)| {
                found.insert(*line);
            });
        }
        found
    }
}

/// Whether both ends of a line lie on others, or beside dots of others, as those of an arrow between two boxes, which
/// may be short.
fn is_link(number: usize, lines: &[Line], near: &Surroundings, limits: &RuleLimits) -> bool {
    let own = &lines[number].runs;
    let end = |run: Option<&Run>, which: fn(&[MmPoint]) -> Option<&MmPoint>| Some((run?.width, *which(&run?.points)?));
    // the second row of a line of dots has ends of its own
    let (first, last) = match limits.medium {
        MediumLimits::Print { .. } => (own.first(), own.last()),
        MediumLimits::Dots { .. } => (lines[number].row(), lines[number].row()),
    };
    let is_on = |(width, end): (f32, MmPoint)| match limits.medium {
        MediumLimits::Print { .. } => near.is_on_stroke(number, end, width),
        MediumLimits::Dots { .. } => {
            let reach = limits.next_dot();
            near.has_dot([number; 2], (end, end), reach, |dot| (dot - end).length() <= reach)
        }
    };
    [end(first, <[_]>::first), end(last, <[_]>::last)].into_iter().all(|end| end.is_some_and(is_on))
}

/// A line of dots goes on beyond another that it crosses if this is the least cosine between its end and the step to
/// the other piece: 45 degrees.
pub(crate) const GOES_ON: f32 = 0.7;
/// Over so many dots the direction of its end is taken: from one to the next it is a multiple of 45 degrees.
pub(crate) const STEPS: usize = 3;

/// Most dots that are left out of a line where it crosses another with a gap of so many dots (`profile/plan` ties it to
/// how lines are drawn).
pub(crate) const fn longest_cut(gap: u32) -> u32 {
    4 * gap + 1
}

/// Whether a line of dots is an arm of a cross: at one end it goes on beyond a third line, after a gap on both sides of
/// that, and both arms together are long enough. Where they lead is also taken outside of the gap: within it they may
/// bend towards the line, as the two arms of an angle do.
fn is_arm(number: usize, lines: &[Line], near: &Surroundings, limits: &RuleLimits) -> bool {
    let MediumLimits::Dots { pitch, line_gap, .. } = limits.medium else { return false };
    let gap = (line_gap as f32 + 0.5) * pitch;
    let is_near = |a: MmPoint, b: MmPoint| (a.x - b.x).abs().max((a.y - b.y).abs()) <= gap;
    let row = |line: usize| lines[line].row().map_or(&[][..], |row| &row.points);
    // a row without the dots of its ends that are near to other lines than these two
    let clear = |line: usize, but: usize| -> Vec<MmPoint> {
        let row = row(line);
        let is_clear = |at: &MmPoint| !near.has_dot([line, but], (*at, *at), gap, |dot| is_near(dot, *at));
        let range = row.iter().position(is_clear).zip(row.iter().rposition(is_clear));
        range.map_or_else(Vec::new, |(first, last)| row[first..=last].to_vec())
    };
    // along a diagonal, and with a dot to both sides
    let reach = SQRT_2 * (longest_cut(line_gap) + 2) as f32 * pitch;
    let lies_between = |a: MmPoint, b: MmPoint, but: usize| {
        near.has_dot([number, but], (a, b), pitch, |dot| nearest_on_segment(dot, a, b).0 <= pitch)
    };
    let goes_on_as = |own: &[MmPoint], beyond: &[MmPoint], other: usize| {
        let (Some(first), Some(last)) = (own.first(), own.last()) else { return false };
        let back = STEPS.min(own.len() - 1);
        let long = limits.line_length - pitch - polyline::length(own) - polyline::length(beyond);
        [(*first, own[back]), (*last, own[own.len() - 1 - back])].into_iter().any(|(tip, before)| {
            let way = (tip - before).try_normalize().unwrap_or_default();
            [beyond.first(), beyond.last()].into_iter().flatten().any(|&end| {
                let (step, length) = (end - tip, (end - tip).length());
                let leads = length <= reach && way.dot(step) >= GOES_ON * length;
                leads && length >= long && lies_between(tip, end, other)
            })
        })
    };
    let ends = |line: usize| [row(line).first(), row(line).last()].into_iter().flatten().copied();
    let is_in_reach = |other: usize| ends(other).any(|b| ends(number).any(|a| (b - a).length() <= reach));
    let others: BTreeSet<usize> = ends(number).flat_map(|end| near.lines_around(end, reach)).collect();
    others.into_iter().any(|other| {
        other != number
            && is_in_reach(other)
            && (goes_on_as(row(number), row(other), other)
                || goes_on_as(&clear(number, other), &clear(other, number), other))
    })
}

/// A line that is too short.
struct Short<'a> {
    line: &'a Line,
    /// From tip to tip, mm.
    length: f32,
}

impl Short<'_> {
    fn breach(&self, name: &str, limits: &RuleLimits) -> FoundBreach {
        let extent = around(points(self.line)).unwrap_or_else(MmRect::zero);
        let what = format!("{name} is {:.1} mm long; {} mm is the least", self.length, limits.line_length);
        let at = points(self.line).next().unwrap_or_else(MmPoint::zero);
        FoundBreach::at(LINE_LENGTH, at, extent, self.length, what).of(name)
    }
}

/// A line if it is too short and neither a link nor an arm of a cross.
fn too_short_alone<'a>(
    number: usize,
    lines: &'a [Line],
    near: &Surroundings,
    limits: &RuleLimits,
) -> Option<Short<'a>> {
    let short = too_short(&lines[number], limits);
    short.filter(|_| !is_link(number, lines, near, limits) && !is_arm(number, lines, near, limits))
}

fn too_short<'a>(line: &'a Line, limits: &RuleLimits) -> Option<Short<'a>> {
    // a dot stands for half a pitch to both sides
    let tips = match limits.medium {
        MediumLimits::Print { .. } => line.runs.first().map_or(0.0, |run| run.width),
        MediumLimits::Dots { pitch, .. } => pitch,
    };
    let strokes = line.runs.iter().filter(|run| run.pen == Pen::Stroke).map(Run::length).sum::<f32>();
    // of dots, the second row of a broad line is no length of its own
    let dots = line.runs.iter().filter(|run| run.pen != Pen::Stroke).map(Run::length).fold(0.0, f32::max);
    let length = strokes.max(dots) + tips;
    let is_point = line.is_disc() || line.is_block_of_dots();
    let is_short = length < limits.line_length - LAST_DIGIT && points(line).next().is_some() && !is_point;
    is_short.then_some(Short { line, length })
}
