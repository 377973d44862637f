//! Outlines of regions among the lines: drawn before others, after long strokes only.

use super::params::Params;
use super::vertex::{FoundIn, Vertex};
use crate::geom::polyline::Polyline;
use crate::regions::TracedContour;
use crate::units::PageTransform;

/// What is drawn before, and in place of, ordinary lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// The outlines, in pixels of the picture.
    pub traces: Vec<TracedContour>,
    /// How many shapes they are; neighbours share a border.
    pub shapes: usize,
    /// How many other lines are drawn, and the least length of each, mm; all if none.
    pub others: Option<(usize, f32)>,
}

/// When a line is drawn: the greatest first, then by saliency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// Any line.
    Ordinary,
    /// An outline of a region, or what is left of one.
    Outline,
    /// A long stroke, which no outline may displace: it is thin, so that no region could have its shape.
    Stroke,
}

/// Least length of a stroke that goes before outlines, mm.
const LONG: f32 = 20.0;
/// ... and how straight it is, chord to length: the rim of a cup is a stroke too, and as good an outline.
const STRAIGHTNESS: f32 = 0.97;
/// Share of its vertices that lie in the middle of a stroke.
const MOSTLY: f32 = 0.7;

impl Rank {
    /// That of a line that is no outline.
    pub(super) fn of(polyline: &Polyline<Vertex>) -> Self {
        // in the middle of a stroke there is no step
        let in_stroke = polyline.vertices.iter().filter(|v| v.contrast.iter().all(|c| c.abs() <= 0.0)).count();
        let is_stroke = in_stroke as f32 >= MOSTLY * polyline.vertices.len() as f32;
        let chord = match (polyline.vertices.first(), polyline.vertices.last(), polyline.closed) {
            (Some(first), Some(last), false) => (last.at - first.at).length(),
            _ => 0.0,
        };
        let is_straight = chord >= LONG && chord >= STRAIGHTNESS * polyline.length();
        if is_stroke && is_straight { Self::Stroke } else { Self::Ordinary }
    }
}

impl Outlines {
    /// Those outlines on the sheet that are long enough for lines.
    pub(super) fn on_the_sheet(&self, transform: &PageTransform, params: &Params) -> Vec<Polyline<Vertex>> {
        let line = |trace: &TracedContour| {
            let vertex = |point: &crate::regions::TracePoint| Vertex {
                at: transform.to_mm(point.at),
                strength: point.strength.max(params.least_strength),
                contrast: [0.0; 3],
                width: 0.0,
                source: FoundIn::Pixels,
            };
            let mut line = Polyline { vertices: trace.vertices.iter().map(vertex).collect(), closed: trace.closed };
            line = line.evened();
            line.fill();
            line
        };
        self.traces.iter().map(line).filter(|line| line.length() >= params.min_length).collect()
    }
}
