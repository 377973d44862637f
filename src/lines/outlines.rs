//! Outlines of regions among the lines: drawn before others, after long strokes, clear rings and curves only.

use super::params::{PagePart, Params};
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
    /// A line of a drawing on the outline of the whole, where that goes before what lies inside it.
    Whole,
    /// An outline of a region, or what is left of one. That of the main thing, which is chosen before others, is one of
    /// these.
    Outline,
    /// A line that no such outline may tear: a long stroke, which is thin, so that no region could have its shape; a
    /// closed contour that is long, round and clear in the mean, and that no closed outline stands for (an open one
    /// that comes near may be that of a corner of the ground around a disc); or a very long open one that is clear and
    /// smooth, such as the rim of a saucer behind a cup, and that no outlines stand for. Of these the more salient goes
    /// first, as of other lines.
    Untorn,
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

/// Least length of an open contour that goes before outlines, mm, and most that its direction changes in all, radians,
/// from step to step of [`TURN_STEP`] mm: a circle and a half, with what a contour of pixels sways. From 80 mm on, the
/// head of `astronaut.png` was open, and on 50 photographs of BSDS500 (val) F of the figure was .672 in place of .673,
/// closed .220 (.226) and covering .507 (.505); from 60 mm on and with seven tenths of the strength .671, .177, .488.
const LONG_CURVE: f32 = 150.0;
const MOST_TURNED: f32 = 9.0;
const TURN_STEP: f32 = 3.0;

/// Outlines stand for a ring or a curve if they are near this share of its vertices. With seven tenths, outlines of
/// what stands on the saucer of `samples/coffee.png` tore it in three places; now it has one gap, at its upper right.
const ALIKE: f32 = 0.92;

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
        if is_stroke && is_straight { Self::Untorn } else { Self::Ordinary }
    }

    /// Whether a contour is a long, round ring, clear in the mean.
    pub(super) fn may_be_ring(polyline: &Polyline<Vertex>, params: &Params) -> bool {
        let length = polyline.length();
        if !may_go_first(params) || !polyline.closed || length < LONG_RING || !is_clear(polyline, params) {
            return false;
        }
        let places: Vec<MmPoint> = polyline.vertices.iter().map(|vertex| vertex.at).collect();
        roundness(area(&places), length) >= ROUND
    }

    /// Whether a contour of a figure is a very long, smooth curve, clear in the mean.
    pub(super) fn may_be_curve(polyline: &Polyline<Vertex>, params: &Params) -> bool {
        let is_long = || polyline.length() >= LONG_CURVE;
        let may_be = params.part == PagePart::Figure && may_go_first(params);
        // the steps of a line and of its reverse lie elsewhere
        let is_smooth = || is_smooth(polyline.vertices.iter()) || is_smooth(polyline.vertices.iter().rev());
        may_be && is_long() && is_clear(polyline, params) && is_smooth()
    }

    /// Whether nearly all of a contour runs along one of these lines.
    pub(super) fn is_along(contour: &Polyline<Vertex>, lines: &Nearby, params: &Params) -> bool {
        let is_near = |vertex: &&Vertex| lines.nearest(vertex.at, params.max_spacing(), |_| true).is_some();
        contour.vertices.iter().filter(is_near).count() as f32 >= ALIKE * contour.vertices.len() as f32
    }
}

/// Whether contours that are no strokes may go before outlines. Few shapes are those of the outlines. On dots lines are
/// too far apart for both: the rim of a cup there takes the room of its outline.
fn may_go_first(params: &Params) -> bool {
    !params.of_drawing && params.most_shapes.is_none() && !params.on_dots()
}

/// Whether a contour has the full strength in the mean.
fn is_clear(polyline: &Polyline<Vertex>, params: &Params) -> bool {
    let sum = polyline.vertices.iter().map(|vertex| vertex.strength).sum::<f32>();
    sum >= params.full_strength * polyline.vertices.len() as f32
}

/// Whether the direction of a line changes by at most [`MOST_TURNED`] in all, from step to step of [`TURN_STEP`]. Of a
/// ragged one no more is walked than that takes.
fn is_smooth<'a>(vertices: impl Iterator<Item = &'a Vertex>) -> bool {
    let mut places = vertices.map(|vertex| vertex.at);
    let Some(mut from) = places.next() else { return true };
    let (mut turned, mut before) = (0.0_f32, None);
    for at in places {
        let step = at - from;
        if step.square_length() >= TURN_STEP * TURN_STEP {
            turned += before.map_or(0.0, |before: MmVector| before.angle_to(step).radians.abs());
            if turned > MOST_TURNED {
                return false;
            }
            (from, before) = (at, Some(step));
        }
    }
    true
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
                bar: 0.0,
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
