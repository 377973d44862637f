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
    use crate::lines::vertex::{FoundIn, SPACING};
    use crate::units::{MmPoint, MmVector};

    /// A line with vertices as close as those of lines in the making. `step` is the lightness on its right less that
    /// on its left.
    pub(super) fn side(points: &[(f32, f32)], closed: bool, step: f32) -> Polyline<Vertex> {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: step.abs(),
            contrast: [step, 0.0, 0.0],
            width: 0.0,
            stroke: 0.0,
            source: FoundIn::Pixels,
            displaced: MmVector::zero(),
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
mod tests {
    use super::testing::{area, bar, stroke};
    use super::*;

    #[test]
    fn a_thin_bar_becomes_one_line_as_long_as_it_wherever_its_ring_begins() {
        let count = bar(3.0, 0).vertices.len();
        for start in 0..count {
            let merged = merge(vec![bar(3.0, start)], area(), &Params::TEST);
            let [line] = &merged[..] else { panic!("{} lines from vertex {start}", merged.len()) };
            assert!(!line.closed && (line.length() - 40.0).abs() < 0.5, "{} from vertex {start}", line.length());
            let off = line.vertices.iter().map(|vertex| (vertex.at.y - 21.5).abs()).fold(0.0, f32::max);
            assert!(off < 0.1, "{off} from vertex {start}");
        }
    }

    #[test]
    fn a_wide_bar_keeps_both_sides() {
        let wide = vec![bar(5.0, 0)];
        assert_eq!(merge(wide.clone(), area(), &Params::TEST), wide);
    }

    #[test]
    fn the_shorter_of_two_sides_goes_and_the_longer_one_runs_in_the_middle_beside_it() {
        let merged = merge(stroke(3.0), area(), &Params::TEST);
        let [line] = &merged[..] else { panic!("{} lines", merged.len()) };
        assert!((line.length() - 40.0).abs() < 1.5, "{}", line.length());
        let height_at = |x: f32| {
            let distance = |vertex: &&Vertex| (vertex.at.x - x).abs();
            line.vertices.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|vertex| vertex.at.y)
        };
        let [before, middle, after] = [11.0, 30.0, 49.0].map(|x| height_at(x).expect("it has vertices"));
        assert!((middle - 21.5).abs() < 0.01 && (before - 20.0).abs() < 0.01 && (after - 20.0).abs() < 0.01);
    }
}
