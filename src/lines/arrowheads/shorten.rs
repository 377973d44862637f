//! Shafts of arrows end before what they point at.

use super::find::FoundHead;
use super::place::{last_piece, leads};
use super::shapes::end;
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::faint::is_faint;
use crate::lines::lead_on::{VERTEX, extend_to, heading};
use crate::lines::links;
use crate::lines::marks::HeadMark;
use crate::lines::params::{HEADING, Params};
use crate::lines::vertex::{SHORTENED_BY, Tip, Vertex, nearby};
use crate::units::{MmPoint, MmRect, MmVector};

/// What is before a tip, and not beside it: the cosine.
const BEFORE: f32 = 0.3;
/// An arrow that ends beyond a line by no more than this share of its head points at that line: the markers of many
/// programs end a little inside of a box.
const BEYOND: f32 = 0.5;
/// Such a line is at least so many times as long as the shortest line: it is no tick of an axis.
const POINTED_AT: f32 = 2.0;
/// A shaft is shortened before what it points at if so much of its last piece is left, mm: the smallest head has room
/// before the bend. Otherwise the head may still touch what it points at, which heads of dots do not.
const LAST_PIECE: f32 = 6.0;
/// A line so near before the end of a shaft, mm, is what it points at, and not one that it crosses.
const AT_END: f32 = 1.0;
/// A tip this near to a line, mm, before it or beyond, is on it: it was put there in steps, up to half a step off.
const JUST_AT: f32 = 0.52 * SHORTENED_BY;

/// Shortens the shafts of heads up to the lines that they point at, and on until nothing is too near before their tips.
pub(super) fn make_room(
    heads: &[FoundHead],
    marks: &mut [HeadMark],
    polylines: &mut [Polyline<Vertex>],
    taken: &[bool],
    area: MmRect,
    params: &Params,
) {
    let reach = params.max_clearance();
    let others = nearby(polylines.iter(), area, params);
    let may_be_pointed_at: Vec<bool> =
        polylines.iter().map(|line| !is_faint(line) && line.length() >= POINTED_AT * params.min_length).collect();
    for (FoundHead { shaft, tip, .. }, mark) in heads.iter().zip(marks) {
        let is_other = |line: u32| line as usize != shaft.line && !taken[line as usize];
        let may_be_at = |line: u32| is_other(line) && may_be_pointed_at[line as usize];
        let to_pointed_at = |at: MmPoint| {
            others.nearest(at, SHORTENED_BY, |segment| may_be_at(segment.line)).map(|(distance, ..)| distance)
        };
        let line = &polylines[shaft.line];
        let most = (line.length() - links::shortest(params)).clamp(0.0, BEYOND * tip.axis().length());
        let up_to = up_to_pointed_at(line, shaft.which, most, to_pointed_at);
        if let Some((shorter, at)) = up_to {
            polylines[shaft.line] = shorter;
            mark.at = at;
        }
        // a head may be a little aslant to its shaft, along which it is drawn
        mark.toward = heading(&polylines[shaft.line], shaft.which, HEADING).unwrap_or(mark.toward);
        let is_free = |at: MmPoint, toward: MmVector| is_free_before(at, toward, &others, reach, is_other);
        let line = &polylines[shaft.line];
        // at a line a short shaft is a link; before one it would be nothing
        let mut most = (line.length() - params.min_length).clamp(0.0, 2.0 * reach);
        if !params.on_dots() {
            most = (last_piece(line, shaft.which, mark.toward, most + LAST_PIECE) - LAST_PIECE).clamp(0.0, most);
        }
        let crossed = crossed_by(line, shaft.which, most + params.max_stub(), &others, may_be_at);
        // of an overview, which has room for few heads, such a shaft may be shortened on to before the line
        let is_at_crossed = |at: MmPoint| {
            !params.in_overview_of_drawing() && crossed.iter().any(|line| others.is_near_line(at, reach, *line))
        };
        let ends = |at: MmPoint, toward: MmVector| is_at_crossed(at) || is_free(at, toward);
        match until_free(line, (shaft.which, mark.toward), most, ends) {
            // what is left beyond that line would be cut off as a stub, and the shaft seem to lead to that line
            Some((_, at, _)) if is_at_crossed(at) => {
                let nearest = others.nearest(mark.at, params.bridged_gap(), |segment| may_be_at(segment.line));
                let pointed_at = nearest.filter(|(far, to, _)| *far > JUST_AT && is_before(mark.at, mark.toward, *to));
                if let Some((_, to, _)) = pointed_at {
                    extend_to(&mut polylines[shaft.line], shaft.which, to);
                    mark.at = to;
                }
            }
            Some((shorter, at, toward)) => {
                mark.shortened = line.length() - shorter.length();
                polylines[shaft.line] = shorter;
                (mark.at, mark.toward) = (at, toward);
            }
            None => {}
        }
    }
}

/// A shaft that ends a little beyond what it points at, shortened by at most `most`, mm, up to that, and its end.
/// `to_pointed_at` says how far that is from a place, if it is near.
fn up_to_pointed_at(
    shaft: &Polyline<Vertex>,
    which: Tip,
    most: f32,
    to_pointed_at: impl Fn(MmPoint) -> Option<f32>,
) -> Option<(Polyline<Vertex>, MmPoint)> {
    let near = shaft.shorter_ones(which, most).filter_map(|line| {
        let at = end(&line, which)?;
        Some((to_pointed_at(at)?, line, at))
    });
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, line, at)| (line, at))
}

/// The lines that count which a shaft crosses in its last `most` mm, but for what it points at.
fn crossed_by(
    shaft: &Polyline<Vertex>,
    which: Tip,
    most: f32,
    lines: &Nearby,
    counts: impl Fn(u32) -> bool,
) -> Vec<u32> {
    // a place between two segments is met by one of them
    let wider = |a: MmPoint, b: MmPoint| (a - (b - a) * VERTEX, b + (b - a) * VERTEX);
    let (length, mut crossed) = (shaft.length(), Vec::new());
    for ((a, b), arc) in shaft.segments().zip(shaft.arc_lengths()) {
        let (a, b) = (a.at, b.at);
        lines.around(a.min(b), a.max(b), 0.0, |segment| {
            let place = crossing(wider(a, b), wider(segment.a, segment.b)).filter(|_| counts(segment.line));
            let arc = place.map(|at| arc + (at - a).length());
            let from_end = arc.map(|arc| if which == Tip::First { arc } else { length - arc });
            if from_end.is_some_and(|far| far > AT_END && far <= most) && !crossed.contains(&segment.line) {
                crossed.push(segment.line);
            }
        });
    }
    crossed
}

/// A shaft shortened by at most `most`, mm, until its end is free, with its end and which way it leads there; not as
/// far as a bend, before which it leads otherwise than its head points.
fn until_free(
    shaft: &Polyline<Vertex>,
    (which, toward): (Tip, MmVector),
    most: f32,
    is_free: impl Fn(MmPoint, MmVector) -> bool,
) -> Option<(Polyline<Vertex>, MmPoint, MmVector)> {
    let mut shorter = shaft.shorter_ones(which, most).take_while(|line| leads(line, which, toward));
    shorter.find_map(|line| {
        let (at, toward) = (end(&line, which)?, heading(&line, which, HEADING)?);
        is_free(at, toward).then_some((line, at, toward))
    })
}

/// Whether none of those of `lines` that count is within `reach`, mm, before a tip that points this way.
fn is_free_before(at: MmPoint, toward: MmVector, lines: &Nearby, reach: f32, counts: impl Fn(u32) -> bool) -> bool {
    let mut is_free = true;
    lines.around_point(at, reach, |segment| {
        let (distance, nearest) = nearest_on_segment(at, segment.a, segment.b);
        is_free &= distance >= reach || !counts(segment.line) || !is_before(at, toward, nearest);
    });
    is_free
}

/// Whether a place is before a tip that points this way, and not beside it, or just at it.
fn is_before(at: MmPoint, toward: MmVector, place: MmPoint) -> bool {
    let way = place - at;
    way.length() <= JUST_AT || way.dot(toward) >= BEFORE * way.length()
}
