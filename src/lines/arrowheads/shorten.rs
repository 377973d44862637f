//! Shafts of arrows end before what they point at.

use super::find::FoundHead;
use super::shapes::end;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::faint::is_faint;
use crate::lines::lead_on::heading;
use crate::lines::marks::HeadMark;
use crate::lines::params::{HEADING, Params};
use crate::lines::vertex::{Tip, Vertex, nearby};
use crate::units::{MmPoint, MmRect, MmVector};

/// Steps in which a shaft is shortened, mm.
const STEP: f32 = 0.25;
/// What is before a tip, and not beside it: the cosine.
const BEFORE: f32 = 0.3;
/// An arrow that ends beyond a line by no more than this share of its head points at that line: the markers of many
/// programs end a little inside of a box.
const BEYOND: f32 = 0.5;
/// Such a line is at least so many times as long as the shortest line: it is no tick of an axis.
const POINTED_AT: f32 = 2.0;

/// Shortens the shafts of heads until nothing is too near before their tips.
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
        let to_other = |at: MmPoint| {
            let counts = |line: u32| is_other(line) && may_be_pointed_at[line as usize];
            others.nearest(at, STEP, |segment| counts(segment.line)).map(|(distance, ..)| distance)
        };
        let most = (polylines[shaft.line].length() - params.min_length).clamp(0.0, BEYOND * tip.axis().length());
        let inside = (0..=(most / STEP) as u32).map(|step| step as f32 * STEP);
        let cut = |cut: f32| {
            let line = shortened(&polylines[shaft.line], shaft.which, cut);
            end(&line, shaft.which).and_then(to_other).map(|distance| (distance, line))
        };
        let up_to_other = inside.filter_map(cut).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, line)| line);
        if let Some((shorter, at)) = up_to_other.and_then(|line| end(&line, shaft.which).map(|at| (line, at))) {
            polylines[shaft.line] = shorter;
            mark.at = at;
        }
        let is_free = |at: MmPoint, toward: MmVector| {
            let is_before = |of: MmPoint| (of - at).dot(toward) >= BEFORE * (of - at).length();
            let mut is_free = true;
            others.around_point(at, reach, |segment| {
                let (distance, nearest) = nearest_on_segment(at, segment.a, segment.b);
                is_free &= distance >= reach || !is_other(segment.line) || !is_before(nearest);
            });
            is_free
        };
        let line = &polylines[shaft.line];
        let most = (line.length() - params.min_length).clamp(0.0, 2.0 * reach);
        let cuts = (0..=(most / STEP) as u32).map(|step| step as f32 * STEP);
        let free = cuts.map(|cut| shortened(line, shaft.which, cut)).find_map(|line| {
            let (at, toward) = (end(&line, shaft.which)?, heading(&line, shaft.which, HEADING)?);
            is_free(at, toward).then_some((line, at, toward))
        });
        if let Some((shorter, at, toward)) = free {
            polylines[shaft.line] = shorter;
            (mark.at, mark.toward) = (at, toward);
        }
    }
}

/// An open line without so much of one of its ends, mm.
pub(in crate::lines) fn shortened(line: &Polyline<Vertex>, which: Tip, cut: f32) -> Polyline<Vertex> {
    let mut vertices = line.vertices.clone();
    if which == Tip::First {
        vertices.reverse();
    }
    let mut left = cut;
    while let [.., before, last] = vertices[..] {
        let step = (last.at - before.at).length();
        if step > left {
            let share = if step > 0.0 { left / step } else { 0.0 };
            if let Some(end) = vertices.last_mut() {
                *end = Vertex { at: last.at.lerp(before.at, share), ..last };
            }
            break;
        }
        left -= step;
        vertices.pop();
    }
    if which == Tip::First {
        vertices.reverse();
    }
    Polyline { vertices, closed: false }
}
