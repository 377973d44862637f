//! Strokes of a vector drawing that are much thinner and paler than its others, such as the grid behind a curve. How a
//! stroke is painted says how much it matters: these are as thin as lines can be, and give way to all others.

use super::clearance::Cleared;
use super::outlines::Rank;
use super::params::{Params, RING_FARTHEST};
use super::vertex::{FoundIn, Vertex};
use crate::edges::{ChainRange, Edges};
use crate::geom::polyline::Polyline;
use crate::units::MmPoint;

/// A stroke is faint if its width times its contrast is at most this share of that of the drawing's strong ones: one of
/// a third of their width and three quarters of their contrast, but not a black hairline beside lines of three pixels.
const FAINT: f32 = 0.25;
/// The strong ones are this share of all strokes by length: the curve of a chart is short beside its grid.
const STRONG: f32 = 0.1;
/// What is left of a faint line between two cuts and is shorter than so many least lengths is left out: it says
/// nothing, and is felt as something.
const SCRAP: f32 = 1.5;

/// Which strokes of a vector drawing are faint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FaintStrokes {
    /// The weight of the strong ones; 0 if no stroke is.
    strong: f32,
}

impl FaintStrokes {
    pub(super) fn of(edges: &Edges) -> Self {
        let mut all: Vec<(f32, f32)> = Vec::new();
        for range in &edges.chains {
            all.extend(weight(edges, range).map(|weight| (weight, edges.chain(range).length())));
        }
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        let whole: f32 = all.iter().map(|(_, length)| length).sum();
        let mut sum = 0.0;
        let strong = all.iter().find(|(_, length)| {
            sum += length;
            sum >= STRONG * whole
        });
        Self { strong: strong.map_or(0.0, |(weight, _)| *weight) }
    }

    /// Whether a contour is one.
    pub(super) fn holds(self, edges: &Edges, range: &ChainRange) -> bool {
        weight(edges, range).is_some_and(|weight| weight <= FAINT * self.strong)
    }
}

/// Width times contrast of a stroke of a vector drawing.
fn weight(edges: &Edges, range: &ChainRange) -> Option<f32> {
    let width = range.kind.stroke.filter(|_| range.kind.exact)?;
    let edgels = &edges.edgels[range.edgels.clone()];
    let strength = edgels.iter().map(|edgel| edgel.strength).sum::<f32>() / edgels.len().max(1) as f32;
    Some(width * strength)
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

/// Leaves out short pieces of faint lines that were cut.
pub(super) fn without_scraps(cleared: &mut Vec<Cleared>, lines: &[(Polyline<Vertex>, Rank)], params: &Params) {
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
    use crate::edges::{ChainKind, Edgel};
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
