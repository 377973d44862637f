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

/// Sides of strokes for tests.
#[cfg(test)]
mod testing {
    use super::*;
    pub(super) use crate::lines::tests::area;
    use crate::lines::vertex::SPACING;
    use crate::units::MmPoint;

    /// A line with vertices as close as those of lines in the making. `step` is the lightness on its right less that
    /// on its left.
    pub(super) fn side(points: &[(f32, f32)], closed: bool, step: f32) -> Polyline<Vertex> {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: step.abs(),
            contrast: [step, 0.0, 0.0],
            ..Vertex::TEST
        };
        let mut polyline = Polyline { vertices: points.iter().map(vertex).collect(), closed };
        polyline.subdivide(SPACING);
        polyline
    }

    /// The two sides of a level stroke as wide as this, from x = 10 to x = 50 and from x = 20 to x = 40.
    pub(super) fn stroke(width: f32) -> Vec<Polyline<Vertex>> {
        vec![
            side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0),
            side(&[(20.0, 20.0 + width), (40.0, 20.0 + width)], false, -60.0),
        ]
    }

    /// A level bar as wide as this and 40 mm long, as one ring that starts at a vertex of this number.
    pub(super) fn bar(width: f32, start: usize) -> Polyline<Vertex> {
        let mut bar = side(&[(10.0, 20.0), (50.0, 20.0), (50.0, 20.0 + width), (10.0, 20.0 + width)], true, 60.0);
        let count = bar.vertices.len();
        bar.vertices.rotate_left(start % count);
        bar
    }
}

#[cfg(test)]
mod tests;
