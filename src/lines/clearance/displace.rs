//! A line that is a little too near to others is displaced instead of being cut: a ring stays a ring. It moves by less
//! than a finger notices, and swings back to its place on both sides.

use super::drawn::DrawnLines;
use super::passage::{Passage, TOUCH};
use super::shift::{shifts_of_curve, shifts_of_drawing};
use crate::geom::polyline::Polyline;
use crate::lines::params::{Params, RING_FARTHEST};
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// The farthest that a line is displaced, mm: the index finger tells places from about 0.94 mm (Van Boven and Johnson
/// 1994).
const FARTHEST: f32 = 0.8;
/// A little more than it must, mm, so that it need not do so again.
pub(super) const MORE: f32 = 0.02;
/// What rounding may put outside of the picture, mm.
pub(super) const OUTSIDE: f32 = 0.01;
/// Away from one line can be towards another: after so many rounds it is cut after all.
const ROUNDS: usize = 4;

/// Of so many vertices one is looked at before all are.
const FIRST_EVERY: usize = 16;

/// How far a line may be displaced, mm.
pub(super) fn farthest(polyline: &Polyline<Vertex>, passage: &Passage, params: &Params) -> f32 {
    if is_held(polyline, passage, params) { RING_FARTHEST } else { FARTHEST }
}

/// Whether a line cannot come off its neighbours: it is a ring, or in a drawing both its ends lie on others, as
/// those of a bar on its axis, or of a connector between boxes.
pub(super) fn is_held(polyline: &Polyline<Vertex>, passage: &Passage, params: &Params) -> bool {
    let ends = |arc: f32| passage.junctions.iter().any(|j| j.is_own_end() && (j.arc - arc).abs() < TOUCH);
    polyline.closed || params.of_drawing && ends(0.0) && passage.arcs.last().is_some_and(|&arc| ends(arc))
}

/// The line, which has this passage, moved away from those it is too near to; none if that asks for more than
/// [`farthest`] somewhere, counted from where the line was before it was ever displaced: it may be judged, and
/// displaced, in several rounds.
pub(super) fn displaced(
    polyline: &Polyline<Vertex>,
    mut passage: Passage,
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    let mut polyline = polyline.clone();
    let farthest = farthest(&polyline, &passage, drawn.params);
    for round in 0..ROUNDS {
        if round > 0 {
            passage = drawn.passage(polyline.view());
        }
        let pushes = pushes(&polyline, &passage, drawn, farthest)?;
        if pushes.iter().all(|push| *push == MmVector::zero()) {
            return Some(polyline);
        }
        let shifts = match drawn.params.of_drawing {
            true => shifts_of_drawing(&polyline, &pushes, &passage),
            false => shifts_of_curve(&pushes, &passage),
        };
        for (vertex, shift) in polyline.vertices.iter_mut().zip(shifts) {
            vertex.at += shift;
            vertex.displaced += shift;
            // an outline may end on the border of the picture
            if vertex.displaced.length() > farthest
                || !drawn.area.inflate(OUTSIDE, OUTSIDE).contains_inclusive(vertex.at)
            {
                return None;
            }
        }
    }
    None
}

/// The displacement that each vertex needs, zero where it is near to no line; none if one is longer than `farthest`.
fn pushes(
    polyline: &Polyline<Vertex>,
    passage: &Passage,
    drawn: &DrawnLines<'_>,
    farthest: f32,
) -> Option<Vec<MmVector>> {
    let push = |i: usize| {
        let mut push = MmVector::zero();
        drawn.each_near(&polyline.vertices[i], passage.arcs[i], passage, |near| {
            if near.missing + MORE > push.length() && !near.joins() {
                push = near.away * ((near.missing + MORE) / near.distance.max(MORE));
            }
            true
        });
        (push.length() <= farthest).then_some(push)
    };
    // a line that is far too near to others is so along much of its length: some of its vertices tell
    let count = polyline.vertices.len();
    if (0..count).step_by(FIRST_EVERY).any(|i| push(i).is_none()) {
        return None;
    }
    (0..count).map(push).collect()
}

#[cfg(test)]
mod tests;
