//! A line of a drawing that leaves another at a flat angle, as one hand of a clock beside the other, has no room until
//! the two are apart. Where little would be left of it, or it would end before the other, it branches off the other a
//! little later and more steeply:
//!
//! ```text
//!   o------------------------------------      o----------___-----------------------
//!    ``````------______                                      ``--__________
//! ```

use super::drawn::{DrawnLines, LineState};
use super::passage::TOUCH;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::lines::lead_on;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// What is taken off the way from the other line, mm, so that rounding does not make it too long.
const MARGIN: f32 = 0.1;
/// A near branch begins no farther from its place than this, in clearances: what is farther is elsewhere.
const FARTHEST: f32 = 1.1;

/// A line that ends on another, is too near to that up to some place and free of all beyond, as a branch of the other;
/// none if it is no such line.
pub(super) fn branch(
    polyline: &Polyline<Vertex>,
    states: &[LineState],
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    branch_where(polyline, states, drawn, |_| true)
}

/// [`branch`] that begins near to where the line meets the other: there they are felt to meet, and others that end at
/// that place, as the middle one of three strokes from a box, have room beside it.
pub(super) fn near_branch(
    polyline: &Polyline<Vertex>,
    states: &[LineState],
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    let params = drawn.params;
    let has_room_beside = |moved: f32| moved <= params.cluster_spacing() || moved >= params.max_clearance();
    let may_begin = |moved: f32| has_room_beside(moved) && moved <= FARTHEST * params.max_clearance();
    branch_where(polyline, states, drawn, may_begin)
}

/// [`branch`] that begins as far from the end of the line as `may_begin` says, mm.
fn branch_where(
    polyline: &Polyline<Vertex>,
    states: &[LineState],
    drawn: &DrawnLines<'_>,
    may_begin: impl Fn(f32) -> bool,
) -> Option<Polyline<Vertex>> {
    if polyline.closed || !drawn.params.of_drawing {
        return None;
    }
    from_first(&polyline.vertices, states, drawn, &may_begin).or_else(|| {
        let reversed: Vec<Vertex> = polyline.vertices.iter().rev().copied().collect();
        let states: Vec<LineState> = states.iter().rev().copied().collect();
        from_first(&reversed, &states, drawn, &may_begin)
    })
}

/// [`branch_where`] of a line whose first vertex is on the other.
fn from_first(
    vertices: &[Vertex],
    states: &[LineState],
    drawn: &DrawnLines<'_>,
    may_begin: impl Fn(f32) -> bool,
) -> Option<Polyline<Vertex>> {
    let (_, _, joined) = drawn.segments.nearest(vertices.first()?.at, TOUCH, |_| true)?;
    let line = joined.line;
    let apart = vertices.iter().position(|vertex| !drawn.is_near(vertex, line))?;
    if states[apart..].contains(&LineState::TooNear) {
        return None;
    }
    let start = &vertices[apart];
    // as far back on the other line as the way from there to the place where the two are apart may be long
    let mut feet: Vec<MmPoint> = Vec::new();
    for vertex in vertices[..apart].iter().rev() {
        let Some((_, at, segment)) = drawn.segments.nearest_of_line(vertex.at, drawn.params.max_clearance(), line)
        else {
            break;
        };
        // dots are apart where lines leave one another more steeply
        let longest = match drawn.params.on_dots() {
            true => drawn.params.max_stub(),
            false => drawn.params.approach(0.5 * start.width, segment.half_width),
        };
        if (at - start.at).length() > longest - MARGIN {
            break;
        }
        feet.push(at);
    }
    let end = vertices.first()?.at;
    let foot = feet.into_iter().rev().find(|foot| may_begin((*foot - end).length()))?;
    let first = Vertex { at: foot, ..*start };
    let way = lead_on::straight(&first, start.at);
    let vertices: Vec<Vertex> = [first].into_iter().chain(way).chain(vertices[apart + 1..].iter().copied()).collect();
    let length = PolylineRef { vertices: &vertices, closed: false }.length();
    (length >= drawn.params.min_length).then(|| Polyline::open(vertices))
}

#[cfg(test)]
mod tests;
