//! Stroke centrelines: the two sides of a thin stroke become one line along its middle. A stroke is a pole, a wire, a
//! line of a pen, the rim of a cup.
//!
//! ```text
//!   colour A | colour B | colour A          A | A
//!            |          |           ->        |        (nearer than a finger can tell apart)
//!          step       -step               centreline
//! ```
//!
//! Sides belong together when they run parallel, nearer than two lines may, and the colour steps back across the second
//! what it stepped across the first.

mod assign;
mod opposite;
mod stretch;
mod trim;

use super::params::Params;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// Replaces the two sides of every stroke that is too thin for two lines by its centreline.
pub(super) fn merge(polylines: Vec<Polyline<Vertex>>, area: MmRect, params: &Params) -> Vec<Polyline<Vertex>> {
    let opposites = opposite::opposites(&polylines, area, params);
    let stretches = stretch::stretches(&polylines, &opposites);
    let assignments = assign::assign(&polylines, &opposites, stretches, params);
    let mut merged = Vec::with_capacity(polylines.len());
    for (polyline, assignment) in polylines.iter().zip(&assignments) {
        if !(polyline.closed && assign::is_rest(assignment)) {
            trim::trim(polyline, assignment, params.max_spacing(), &mut merged);
        }
    }
    merged
}
