//! Lines of the faint strokes of a vector drawing: as thin as lines can be, they give way to all others.

use super::clearance::Cleared;
use super::line::Line;
use super::outlines::Rank;
use super::params::{Params, RING_FARTHEST};
use super::vertex::{FoundIn, Vertex};
use crate::geom::gridlines::{straight_ends, which_are_gridlines};
use crate::geom::polyline::Polyline;
use crate::units::MmPoint;

/// What is left of a faint line between two cuts and is shorter than so many least lengths is left out: it says
/// nothing, and is felt as something.
const SCRAP: f32 = 1.5;

/// A finished line is weak up to this share of the strength of the strongest. Chosen by us.
const WEAK: f32 = 0.1;
/// What rounding may add to the least strength.
const ROUNDED_UP: f32 = 1.001;

/// Which finished lines of a figure are weak, among them those that were drawn as faint strokes, which have the least
/// strength that contours must have.
pub fn which_are_weak(lines: &[Line], least_strength: f32) -> Vec<bool> {
    let strongest = lines.iter().map(|line| line.strength).fold(0.0, f32::max);
    let most = (WEAK * strongest).max(ROUNDED_UP * least_strength);
    lines.iter().map(|line| line.strength <= most).collect()
}

/// Makes a line faint.
pub(super) fn weaken(mut line: Polyline<Vertex>, params: &Params) -> Polyline<Vertex> {
    for vertex in &mut line.vertices {
        vertex.strength = vertex.strength.min(params.least_strength);
        vertex.source = FoundIn::FaintStroke;
    }
    line
}

/// Whether a line is faint.
pub(super) fn is_faint(line: &Polyline<Vertex>) -> bool {
    let faint = line.vertices.iter().filter(|vertex| vertex.source == FoundIn::FaintStroke).count();
    2 * faint > line.vertices.len()
}

/// Takes gridlines out, faint straight lines, and says how many these are. In an overview nobody could tell
/// them from the shapes before them, as its lines are of one width.
pub(super) fn take_gridlines(lines: &mut Vec<Polyline<Vertex>>) -> usize {
    let ends = |line: &Polyline<Vertex>| straight_ends(line.view()).filter(|_| is_faint(line));
    let mut are_gridlines = which_are_gridlines(&lines.iter().map(ends).collect::<Vec<_>>()).into_iter();
    let before = lines.len();
    lines.retain(|_| !are_gridlines.next().unwrap_or(false));
    before - lines.len()
}

/// Leaves out short pieces of faint lines that were cut.
pub(super) fn drop_short_faint(cleared: &mut Vec<Cleared>, lines: &[(Polyline<Vertex>, Rank)], params: &Params) {
    let faint = lines.iter().filter(|(line, rank)| *rank == Rank::Faint && !line.closed);
    let ends: Vec<MmPoint> =
        faint.flat_map(|(line, _)| [line.vertices.first(), line.vertices.last()]).flatten().map(|end| end.at).collect();
    let is_whole_there = |at: MmPoint| ends.iter().any(|end| (*end - at).length() <= 2.0 * RING_FARTHEST);
    cleared.retain(|Cleared { polyline, rank, .. }| {
        let mut own = [polyline.vertices.first(), polyline.vertices.last()].into_iter().flatten();
        *rank != Rank::Faint || polyline.length() >= SCRAP * params.min_length || own.all(|end| is_whole_there(end.at))
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edges::{ChainKind, Edgel, Edges};
    use crate::lines::{Lines, draw};
    use crate::units::{MmRect, PageTransform, PxPoint, Size};

    /// A stroke with its width, its strength and its corners, in px.
    type TestStroke<'a> = (f32, f32, &'a [(f32, f32)]);

    /// A drawing of strokes; two px are a millimetre.
    fn drawn(strokes: &[TestStroke<'_>]) -> Lines {
        let size = Size::new(300, 200);
        let mut edges = Edges::none(size);
        for &(width, strength, corners) in strokes {
            let kind = ChainKind { exact: true, of_drawing: true, stroke: Some(width), added: false };
            let edgel = |&(x, y): &(f32, f32)| Edgel { at: PxPoint::new(x, y), strength, contrast: [0.0; 3] };
            edges.push_as(kind, corners.iter().map(edgel), false);
        }
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 100.0));
        draw(&edges, &PageTransform::new(size, area), area, &Params { of_drawing: true, ..Params::TEST })
    }

    const CURVE: &[(f32, f32)] = &[(20.0, 120.0), (100.0, 60.0), (180.0, 104.0), (280.0, 20.0)];
    const GRID: &[(f32, f32)] = &[(20.0, 110.0), (280.0, 110.0)];

    fn longest(lines: &Lines, is_thin: bool) -> Vec<f32> {
        let width = if is_thin { Params::TEST.width_min } else { Params::TEST.width_max };
        let is_so = |of: f32| (of - width).abs() < 0.01;
        let lines = lines.lines.iter().filter(|line| line.runs.iter().all(|run| is_so(run.width)));
        lines.map(crate::lines::Line::length).collect()
    }

    #[test]
    fn lines_as_weak_as_contours_may_be_are_weak_whatever_the_strongest_is() {
        let line = |strength: f32| Line { strength, runs: Vec::new() };
        let weak = |strongest: f32| which_are_weak(&[line(strongest), line(7.0), line(7.1), line(12.0)], 7.0);
        assert_eq!(weak(100.0), [false, true, true, false]);
        assert_eq!(weak(30.0), [false, true, false, false]);
    }

    #[test]
    fn a_pale_thin_grid_is_thin_and_gives_way_to_the_curve() {
        let whole: f32 = CURVE.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1) / 2.0).sum();
        let grid_first = drawn(&[(1.0, 25.0, GRID), (5.0, 90.0, CURVE)]);
        let [curve] = longest(&grid_first, false)[..] else { panic!("{grid_first:?}") };
        assert!((curve - whole).abs() < 0.5, "{curve} of {whole} mm");
        let grid = longest(&grid_first, true);
        // the piece below the dip of the curve is gone, and no scrap is left
        assert!(!grid.is_empty() && grid.iter().all(|length| *length >= 12.0), "{grid:?}");
        assert!(grid_first.lost.lost > 5.0, "and told");
    }

    #[test]
    fn strokes_that_are_only_thin_or_only_pale_are_lines_as_others() {
        for (width, strength) in [(2.0, 90.0), (5.0, 30.0)] {
            let lines = drawn(&[(width, strength, GRID), (5.0, 90.0, &[(20.0, 30.0), (280.0, 30.0)])]);
            assert_eq!(longest(&lines, false).len(), 2, "{width} px, {strength}");
        }
        assert!(longest(&drawn(&[(1.0, 40.0, GRID)]), true).is_empty(), "of one kind all are strong");
    }
}
