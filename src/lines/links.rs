//! Links: short lines that lead from line to line, such as a bond between two atoms, an arrow between two boxes, the
//! rung of a ladder. Fingers find them by what they join, so they may be shorter than a line that stands alone.
//!
//! A link is an open, straight line of a drawing, shorter than [`Params::min_length`] and no shorter than
//! [`shortest`], both ends of which lie on other lines. That is asked whenever more is known of it:
//!
//! 1. of contours, whose ends may still be a gap away from what they lead to ([`take`]),
//! 2. of a line whose turn it is to be drawn ([`can_be`]; `clearance::extend` leads its ends over those gaps),
//! 3. of what is left of a longer line that was cut ([`is_piece`]),
//! 4. of lines that are drawn, after some of them were left out ([`drop_loose`]).
//!
//! The same on a grid, where lines become dots one by one, is `is_link` in `dots/clearance/on_grid`; the check has its
//! own `is_link` for finished lines (`legibility/strokes`).

use super::clearance::{Cleared, TOUCH};
use super::params::{PagePart, Params};
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect};

/// The chord of a straight line is at least this share of it: an arc of 60 degrees has .955.
const STRAIGHT: f32 = 0.95;
/// The shortest link, as a share of the shortest line that stands alone.
const SHORTEST: f32 = 0.5;

/// Length of the shortest link, mm.
pub(super) fn shortest(params: &Params) -> f32 {
    SHORTEST * params.min_length
}

/// Whether a line is so short that it is drawn as a link or not at all.
pub(super) fn must_be(line: &Polyline<Vertex>, params: &Params) -> bool {
    params.of_drawing && line.length() < params.min_length
}

/// Whether a line has the form of a link, wherever its ends lie. What is so short and bent is a part of a shape, such
/// as half of a mouth.
pub(super) fn can_be(line: &Polyline<Vertex>, params: &Params) -> bool {
    let is_straight = !line.closed && line.chord() >= STRAIGHT * line.length();
    must_be(line, params) && is_straight && line.length() >= shortest(params)
}

/// Whether both ends of a line lie on others, by what `is_on_other` says of an end.
fn leads(line: &Polyline<Vertex>, is_on_other: impl Fn(MmPoint) -> bool) -> bool {
    Tip::BOTH.into_iter().all(|which| which.of(line).is_some_and(|tip| is_on_other(tip.at)))
}

/// Whether a piece of a line that was cut is a link. In an overview it would say where something was, not what.
pub(super) fn is_piece(piece: &Polyline<Vertex>, params: &Params, is_on_other: impl Fn(MmPoint) -> bool) -> bool {
    params.part == PagePart::Figure && can_be(piece, params) && leads(piece, is_on_other)
}

/// The lines that can be links as they came, by their places; none if there are none.
pub(super) fn short_ones(lines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Option<Nearby> {
    let short: Vec<&Polyline<Vertex>> = lines.iter().filter(|line| can_be(line, params)).collect();
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
    let is_joined = |at: MmPoint| all.nearest(at, params.join_gap, |_| true).is_some();
    let is_link = |line: &Polyline<Vertex>| can_be(line, params) && is_whole(line) && leads(line, is_joined);
    short.extract_if(.., |line| is_link(line)).collect()
}

/// Drops those links of which a line that they led to is not drawn after all.
pub(super) fn drop_loose(drawn: &mut Vec<&Cleared>, area: MmRect, params: &Params) {
    if !drawn.iter().any(|line| must_be(&line.polyline, params)) {
        return;
    }
    let all = nearby(drawn.iter().map(|line| &line.polyline), area, params);
    let mut number = 0..;
    drawn.retain(|line| {
        let own = number.next();
        let on_other = |at: MmPoint| all.nearest(at, TOUCH, |segment| Some(segment.line) != own).is_some();
        !must_be(&line.polyline, params) || leads(&line.polyline, on_other)
    });
}

#[cfg(test)]
mod tests;
