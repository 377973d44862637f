//! Outlines of regions among the lines: drawn before others, after long strokes and clear rings only.

use super::params::Params;
use super::vertex::{FoundIn, Vertex};
use crate::geom::nearby::Nearby;
use crate::geom::polygon::{area, roundness};
use crate::geom::polyline::Polyline;
use crate::regions::{RegionOutline, TracePoint};
use crate::units::{MmPoint, MmVector, PageTransform};

/// What is drawn before, and in place of, ordinary lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// The outlines, in pixels of the picture.
    pub outlines: Vec<RegionOutline>,
    /// How many of the first regions are what the picture is about.
    pub subjects: usize,
    /// How many shapes they are; neighbours share a border.
    pub shapes: usize,
    /// How many other lines are drawn beside outlines, and the least length of each, mm; all if none.
    pub others: Option<(usize, f32)>,
}

/// When a line is drawn: the greatest first, then by saliency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// A stroke that is much thinner and paler than the others of its drawing.
    Faint,
    /// Any line.
    Ordinary,
    /// An outline of a region, or what is left of one. That of the main thing, which is chosen before others, is one of
    /// these.
    Outline,
    /// A long stroke, which no such outline may displace: it is thin, so that no region could have its shape. Or a
    /// closed contour that is long, round and clear in the mean, and that no closed outline stands for: an open one
    /// that comes near, such as that of a corner of the ground around a disc, may not tear it. Of the two the more
    /// salient goes first, as of other lines.
    StrokeOrRing,
    /// An axis or a wall of a drawing, on which others stand.
    Axis,
    /// An outline of what the picture is about.
    Subject,
    /// A line of an overview that a person drew.
    Person,
}

/// Least length of a stroke that goes before outlines, mm.
const LONG: f32 = 20.0;
/// Least straightness of such a stroke, chord to length: the rim of a cup is a stroke too, and as good an outline.
const STRAIGHTNESS: f32 = 0.97;
/// Share of its vertices that lie in the middle of a stroke.
const MOSTLY: f32 = 0.7;

/// Least length of a ring that goes before outlines, mm: a disc as wide as a fingertip.
const LONG_RING: f32 = 40.0;
/// Least roundness of such a ring, 1 of a circle: a square has 0.79, a rectangle of 3 to 1 has 0.59. What is less round
/// often is no thing but the border of light and shadow.
const ROUND: f32 = 0.6;
/// A closed outline stands for a ring if it is near this share of the ring's vertices.
const ALIKE: f32 = 0.7;

impl Rank {
    /// Whether it is that of an outline of a region.
    pub(super) fn is_outline(self) -> bool {
        matches!(self, Self::Outline | Self::Subject)
    }

    /// That of a line that is no outline.
    pub(super) fn of(polyline: &Polyline<Vertex>) -> Self {
        let in_stroke = polyline.vertices.iter().filter(|vertex| vertex.is_in_stroke()).count();
        let is_stroke = in_stroke as f32 >= MOSTLY * polyline.vertices.len() as f32;
        let chord = polyline.chord();
        let is_straight = chord >= LONG && chord >= STRAIGHTNESS * polyline.length();
        if is_stroke && is_straight { Self::StrokeOrRing } else { Self::Ordinary }
    }

    /// Whether a contour is a long, round ring, clear in the mean.
    pub(super) fn may_be_ring(polyline: &Polyline<Vertex>, params: &Params) -> bool {
        let length = polyline.length();
        // Few shapes are those of the outlines. On dots lines are too far apart for both: the rim of a cup there takes
        // the room of its outline.
        let has_none = params.of_drawing || params.most_shapes.is_some() || params.on_dots();
        if has_none || !polyline.closed || length < LONG_RING {
            return false;
        }
        let places: Vec<MmPoint> = polyline.vertices.iter().map(|vertex| vertex.at).collect();
        let strength = polyline.vertices.iter().map(|vertex| vertex.strength).sum::<f32>() / places.len() as f32;
        strength >= params.full_strength && roundness(area(&places), length) >= ROUND
    }

    /// Whether most of a ring runs along one of these lines.
    pub(super) fn is_along(ring: &Polyline<Vertex>, lines: &Nearby, params: &Params) -> bool {
        let is_near = |vertex: &&Vertex| lines.nearest(vertex.at, params.max_spacing(), |_| true).is_some();
        ring.vertices.iter().filter(is_near).count() as f32 >= ALIKE * ring.vertices.len() as f32
    }
}

impl Outlines {
    /// Those outlines on the sheet that are long enough for lines.
    pub(super) fn on_the_sheet(&self, transform: &PageTransform, params: &Params) -> Vec<(Polyline<Vertex>, Rank)> {
        let line = |RegionOutline { contour, region }: &RegionOutline| {
            let vertex = |point: &TracePoint| Vertex {
                at: transform.to_mm(point.at),
                strength: point.strength.max(params.least_strength),
                contrast: [0.0; 3],
                width: 0.0,
                stroke: 0.0,
                source: FoundIn::Pixels,
                displaced: MmVector::zero(),
            };
            let mut line = Polyline { vertices: contour.vertices.iter().map(vertex).collect(), closed: contour.closed };
            line = line.evened();
            line.fill();
            (line, if *region < self.subjects { Rank::Subject } else { Rank::Outline })
        };
        self.outlines.iter().map(line).filter(|(line, _)| line.length() >= params.min_length).collect()
    }
}

#[cfg(test)]
mod tests;
