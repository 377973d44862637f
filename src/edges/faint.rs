//! Strokes of a vector drawing that are much thinner and paler than its others, such as the grid behind a curve. How a
//! stroke is painted says how much it matters.

use super::edgel::{ChainRange, Edgel, Edges};

/// A stroke is faint if its width times its contrast is at most this share of that of the drawing's strong ones: one of
/// a third of their width and three quarters of their contrast, but not a black hairline beside lines of three pixels.
const FAINT: f32 = 0.25;
/// The strong ones are this share of all strokes by length: the curve of a chart is short beside its grid.
const STRONG: f32 = 0.1;

/// Which strokes of a vector drawing are faint.
#[derive(Debug, Clone, Copy, Default)]
pub struct FaintStrokes {
    /// The weight of the strong ones; 0 if no stroke is.
    strong: f32,
}

impl FaintStrokes {
    /// Among those of a drawing.
    pub fn of(edges: &Edges) -> Self {
        let weights =
            edges.chains.iter().filter_map(|range| Some((weight_of(edges, range)?, edges.chain(range).length())));
        Self::among(weights.collect())
    }

    /// Among strokes of these weights and lengths.
    pub(super) fn among(mut all: Vec<(f32, f32)>) -> Self {
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        let whole: f32 = all.iter().map(|(_, length)| length).sum();
        let mut sum = 0.0;
        let strong = all.iter().find(|(_, length)| {
            sum += length;
            sum >= STRONG * whole
        });
        Self { strong: strong.map_or(0.0, |(weight, _)| *weight) }
    }

    /// Whether a contour of the drawing is one.
    pub fn holds(self, edges: &Edges, range: &ChainRange) -> bool {
        weight_of(edges, range).is_some_and(|weight| self.holds_weight(weight))
    }

    /// Whether a stroke of this weight is one.
    pub(super) fn holds_weight(self, weight: f32) -> bool {
        weight <= FAINT * self.strong
    }
}

/// The weight of a stroke: its width times its contrast. Where it lies on the border of an area it is seen with the
/// step of that, so the median of its contrasts counts.
pub(super) fn weight(width: f32, along: &[Edgel]) -> f32 {
    let mut strengths: Vec<f32> = along.iter().map(|edgel| edgel.strength).collect();
    let middle = strengths.len() / 2;
    if strengths.is_empty() {
        return 0.0;
    }
    width * *strengths.select_nth_unstable_by(middle, f32::total_cmp).1
}

fn weight_of(edges: &Edges, range: &ChainRange) -> Option<f32> {
    let width = range.kind.stroke.filter(|_| range.kind.exact)?;
    Some(weight(width, &edges.edgels[range.edgels.clone()]))
}
