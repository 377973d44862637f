//! Which lines of a page are still there where it was drawn anew, so that those that are lost can be named.

use std::collections::BTreeMap;

use crate::geom::nearby::{Nearby, Segment};
use crate::lines::{GONE, Line, Run};
use crate::listing::list;
use crate::page::Names;
use crate::units::{MmPoint, MmRect, MmVector};
use crate::{About, Note, Reason};

/// A line as it is told.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineName {
    /// What it is called.
    pub name: String,
    /// Whether a person drew it.
    pub by_hand: bool,
}

impl LineName {
    /// Those of the lines of a page that was read.
    pub fn of(names: &Names) -> Vec<Self> {
        let of = |name: &String| Self { name: name.clone(), by_hand: names.by_hand.contains(name) };
        names.lines.iter().map(of).collect()
    }
}

/// Lines are looked at this often, mm.
const STEP: f32 = 1.0;
/// Farthest that a line lies from where it was, mm: well beyond what lines are moved aside by
/// (`lines::Params::farthest_moved`).
const REACH: f32 = 8.0;
/// A line that a person drew is lost in part where less than this share is there: every line of theirs is meant, and up
/// to a step of dots and the width of a line is missing where lines meet.
const IN_PART: f32 = 0.7;
/// Most lines that are named.
const MOST: usize = 6;
/// Most lines that are named of those that a person drew.
const MOST_BY_HAND: usize = 20;

/// The line of `before` that each line of `after` stands for, none where none is near, and what share of each line of
/// `before` is there. Both are lines of one figure, that lies in `from` and in `to`.
pub(super) fn matched(before: &[Line], from: MmRect, after: &[Line], to: MmRect) -> (Vec<Option<usize>>, Vec<f32>) {
    let near = index_of(before, from, REACH);
    let scale = from.width() / to.width().max(f32::MIN_POSITIVE);
    let mut lengths = vec![0.0; before.len()];
    let mut stand_for = Vec::with_capacity(after.len());
    for line in after {
        // few lines are near, and the others need not be looked at
        let mut own: BTreeMap<u32, f32> = BTreeMap::new();
        for (a, b) in path_of(line) {
            let length = (b - a).length() * scale;
            let count = (length / STEP).ceil().max(1.0);
            for k in 0..count as u32 {
                let at = from.min + (a.lerp(b, (k as f32 + 0.5) / count) - to.min) * scale;
                if let Some((_, _, found)) = near.nearest(at, REACH, |_| true) {
                    *own.entry(found.line).or_default() += length / count;
                }
            }
        }
        let most = own.iter().fold((None, 0.0), |best, (&line, &of)| if of > best.1 { (Some(line), of) } else { best });
        stand_for.push(most.0.map(|line| line as usize));
        own.into_iter().for_each(|(line, of)| lengths[line as usize] += of);
    }
    let share = |(line, kept): (&Line, f32)| {
        let length: f32 = path_of(line).iter().map(|(a, b)| (*b - *a).length()).sum();
        if length > 0.0 { kept / length } else { 1.0 }
    };
    (stand_for, before.iter().zip(lengths).map(share).collect())
}

/// What share of each line of `before` has some line of `after` within `reach`, mm: dots of others too, at which it
/// ends where it meets them. Both are lines of one figure.
pub(super) fn covered(before: &[Line], after: &[Line], area: MmRect, reach: f32) -> Vec<f32> {
    let near = index_of(after, area, reach);
    let share = |line: &Line| {
        let (mut all, mut met) = (0_u32, 0_u32);
        for (a, b) in path_of(line) {
            let count = ((b - a).length() / STEP).ceil().max(1.0);
            for k in 0..count as u32 {
                let at = a.lerp(b, (k as f32 + 0.5) / count);
                all += 1;
                met += u32::from(near.nearest(at, reach, |_| true).is_some());
            }
        }
        if all > 0 { met as f32 / all as f32 } else { 1.0 }
    };
    before.iter().map(share).collect()
}

/// How much of lines has no line of `after` within `reach`, mm, and where the middle of that is, as far as `is_asked`
/// lets places pass; none if nothing is missing. Both are lines of one figure.
pub(super) fn missing(
    lines: &[Line],
    after: &[Line],
    area: MmRect,
    reach: f32,
    is_asked: impl Fn(MmPoint) -> bool,
) -> Option<(f32, MmPoint)> {
    let near = index_of(after, area, reach);
    let mut gone: Vec<(f32, MmPoint)> = Vec::new();
    for (a, b) in lines.iter().flat_map(path_of) {
        let length = (b - a).length();
        let count = (length / STEP).ceil().max(1.0);
        for k in 0..count as u32 {
            let at = a.lerp(b, (k as f32 + 0.5) / count);
            if is_asked(at) && near.nearest(at, reach, |_| true).is_none() {
                gone.push((length / count, at));
            }
        }
    }
    let all: f32 = gone.iter().map(|(mm, _)| mm).sum();
    gone.get(gone.len() / 2).map(|(_, middle)| (all, *middle))
}

/// The segments of lines, to be found by their places.
pub(super) fn index_of(lines: &[Line], area: MmRect, reach: f32) -> Nearby {
    let mut near = Nearby::new(area, reach);
    for (line, of) in (0..).zip(lines) {
        for (a, b) in of.runs.iter().flat_map(steps_of) {
            near.insert(Segment { a, b, half_width: 0.0, line, index: 0, arc: 0.0 });
        }
    }
    near
}

/// The segments of a run; of one point, that point.
fn steps_of(run: &Run) -> Vec<(MmPoint, MmPoint)> {
    match run.points[..] {
        [only] => vec![(only, only)],
        _ => run.polyline().segments().map(|(a, b)| (*a, *b)).collect(),
    }
}

/// The segments of a line, without the second row of a heavy line of dots.
fn path_of(line: &Line) -> Vec<(MmPoint, MmPoint)> {
    let ticks = line.row_ticks().filter_map(|(run, at)| Some((at, *run.points.last()?)));
    let points = line.row_points().flat_map(|point| {
        let corner = move |k: u32| {
            let (y, x) = (k as f32 * std::f32::consts::TAU / CIRCLE as f32).sin_cos();
            point.at + MmVector::new(x, y) * point.radius
        };
        (0..CIRCLE).map(move |k| (corner(k), corner(k + 1)))
    });
    line.own_runs().iter().flat_map(steps_of).chain(ticks).chain(points).collect()
}

/// So many sides are a circle.
const CIRCLE: u32 = 12;

/// Names the lines that are lost, those that a person drew first, and more of them: our own are numbered. None if none
/// is lost.
pub(super) fn lost(names: &[LineName], shares: &[f32]) -> Option<Note> {
    let told = |(share, LineName { name, by_hand }): (&f32, &LineName)| match *share {
        share if share < GONE => Some((*by_hand, name.clone())),
        share if share < IN_PART && *by_hand => Some((true, format!("{name} in part"))),
        _ => None,
    };
    let (by_hand, ours): (Vec<_>, Vec<_>) =
        shares.iter().zip(names).filter_map(told).partition(|(by_hand, _)| *by_hand);
    // a number says nothing to those who have not opened the page
    let numbered = if ours.is_empty() { "" } else { "; an editor lists them by these names in the page that was read" };
    let (count, most) = (by_hand.len() + ours.len(), MOST.max(by_hand.len().min(MOST_BY_HAND)));
    let named: Vec<String> = by_hand.into_iter().chain(ours).map(|(_, name)| name).take(most).collect();
    if named.is_empty() {
        return None;
    }
    let named = match count - named.len() {
        0 => list(&named, "and"),
        more => format!("{} and {more} more", named.join(", ")),
    };
    let why = |them: &str| {
        format!("too short for this page or too near to others; move {them} apart, or take a larger sheet{numbered}")
    };
    let told = match count {
        1 => format!("{named}, {}", why("the lines")),
        _ => format!("{count} lines, {named}: {}", why("them")),
    };
    Some(Note::NotOnPage(About::Lines, Reason::ShortOrNear, told.into()))
}

#[cfg(test)]
mod tests;
