//! A line of a drawing that has a little too little room beside others, as one that leads down between two boxes, is
//! drawn thinner, by a quarter at most: what is missing of a line is felt before its width is. It is so as a whole.

use super::drawn::{DrawnLines, LineState};
use super::passage::Passage;
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::lines::weight;

/// What rounding may make of a width, mm.
const ROUNDING: f32 = 1e-3;

/// The line, which has this passage, as thin as it must be to have room. None if it would be thinner than the lines of
/// a crowded drawing are, none where lines become dots, which are of one width, and none in overviews: what is not
/// whole there is tried in a larger one.
pub(super) fn thinner(
    polyline: &Polyline<Vertex>,
    passage: &Passage,
    drawn: &DrawnLines<'_>,
) -> Option<Polyline<Vertex>> {
    let params = drawn.params;
    if !params.of_drawing || params.on_dots() || params.in_overview_of_drawing() {
        return None;
    }
    let (least, mut widest) = (params.thin().width_max, f32::INFINITY);
    for (vertex, &arc) in polyline.vertices.iter().zip(&passage.arcs) {
        drawn.each_near(vertex, arc, passage, |near| {
            if !near.joins() {
                // half of a width lies on either side
                widest = widest.min(vertex.width - 2.0 * near.missing);
            }
            widest >= least
        });
        if widest < least {
            return None;
        }
    }
    let width = weight::step_below(widest - ROUNDING, params);
    let mut thinner = polyline.clone();
    thinner.vertices.iter_mut().for_each(|vertex| vertex.width = vertex.width.min(width));
    // thinner lines have shorter approaches
    let has_room = width >= least && !drawn.states_on(&thinner, passage).contains(&LineState::TooNear);
    has_room.then_some(thinner)
}

#[cfg(test)]
mod tests;
