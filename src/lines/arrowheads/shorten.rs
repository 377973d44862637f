//! Shafts of arrows end before what they point at.

use super::find::FoundHead;
use super::shapes::end;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::lines::lead_on::heading;
use crate::lines::marks::HeadMark;
use crate::lines::params::{HEADING, Params};
use crate::lines::vertex::{Tip, Vertex, nearby};
use crate::units::{MmPoint, MmRect, MmVector};

/// Steps in which a shaft is shortened, mm.
const STEP: f32 = 0.25;
/// What is before a tip, and not beside it: the cosine.
const BEFORE: f32 = 0.3;

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
    for (FoundHead { shaft, .. }, mark) in heads.iter().zip(marks) {
        let is_other = |line: u32| line as usize != shaft.line && !taken[line as usize];
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
