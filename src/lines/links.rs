//! Short lines that lead from line to line: a bond between two atoms, an arrow between two boxes, the rung of a ladder.
//! Fingers find them by what they join, so they may be shorter than a line that stands alone.

use super::clearance::{Cleared, TOUCH};
use super::params::Params;
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect};

/// The chord of a straight line is at least this share of it: an arc of 60 degrees has .955.
const STRAIGHT: f32 = 0.95;

/// The straight lines that are too short for lines as they came, by their places; none if there are none.
pub(super) fn short_ones(lines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Option<Nearby> {
    let is_short =
        |line: &&Polyline<Vertex>| is_straight(line) && (params.min_link()..params.min_length).contains(&line.length());
    let short: Vec<&Polyline<Vertex>> = lines.iter().filter(is_short).collect();
    (!short.is_empty()).then(|| nearby(short.into_iter(), area, params))
}

/// Takes those of `short` lines out whose two ends lie at long `lines`, or before gaps that a line may be extended
/// over, and that are what came as such a line (`whole`) and not a remnant of a longer one, such as the top of a bar.
/// Whether they are drawn is decided when those are ([`super::clearance`]).
pub(super) fn take(
    short: &mut Vec<Polyline<Vertex>>,
    lines: &[Polyline<Vertex>],
    whole: &Nearby,
    area: MmRect,
    params: &Params,
) -> Vec<Polyline<Vertex>> {
    let all = nearby(lines.iter(), area, params);
    let is_whole = |line: &Polyline<Vertex>| {
        let middle = line.vertices.get(line.vertices.len() / 2);
        middle.is_some_and(|middle| whole.nearest(middle.at, params.max_offset(), |_| true).is_some())
    };
    let is_link = |line: &Polyline<Vertex>| {
        let is_joined =
            |which: Tip| which.of(line).is_some_and(|tip| all.nearest(tip.at, params.join_gap, |_| true).is_some());
        let may_link = is_straight(line) && line.length() >= params.min_link();
        may_link && is_whole(line) && Tip::BOTH.into_iter().all(is_joined)
    };
    short.extract_if(.., |line| is_link(line)).collect()
}

/// Drops those of which a line that they led to is not drawn after all.
pub(super) fn drop_loose(drawn: &mut Vec<&Cleared>, area: MmRect, params: &Params) {
    if drawn.iter().all(|line| !params.must_link(line.polyline.length())) {
        return;
    }
    let all = nearby(drawn.iter().map(|line| &line.polyline), area, params);
    let mut number = 0..;
    drawn.retain(|line| {
        let own = number.next();
        let leads = |end: Option<&Vertex>| {
            let on_other = |at: MmPoint| all.nearest(at, TOUCH, |segment| Some(segment.line) != own).is_some();
            end.is_some_and(|end| on_other(end.at))
        };
        let ends = [line.polyline.vertices.first(), line.polyline.vertices.last()];
        !params.must_link(line.polyline.length()) || ends.into_iter().all(leads)
    });
}

/// What is so short and bent is a part of a shape, such as half of a mouth.
pub(super) fn is_straight(line: &Polyline<Vertex>) -> bool {
    !line.closed && line.chord() >= STRAIGHT * line.length()
}

#[cfg(test)]
mod tests;
