//! Which stretches of a proposal the picture shows.

use pulp::Arch;

use super::proposal::{Confirmed, Proposal, SegmentRun, stretches};
use crate::edges::edgel::Edgel;
use crate::edges::params::Params;
use crate::geom::polyline::Polyline;
use crate::geom::right_of;
use crate::raster::Raster;
use crate::raster::contrast::{length, less};
use crate::raster::lab;
use crate::units::{PxPoint, Size};

/// Distance from an outline at which the two sides are compared, px: an edge is spread over a pixel by rendering and
/// over another by interpolation, at most 1.2 to each side.
const FAR: f32 = 1.25;
/// Distance from an outline, px, at which the step must be seen already, or it is not here.
const CLOSE: f32 = 0.75;
/// Least share of the step at [`FAR`] that is seen at [`CLOSE`]: at least three quarters where the edge is here (in the
/// middle of a pixel it is least), half where it is [`CLOSE`] away.
const HERE: f32 = 0.62;
/// A stroke is summed up in steps of this, px.
const STEP: f32 = 0.25;
/// The middle of what is seen of a stroke lies at most this far from its centre line, px, and this share of its width:
/// a stroke of the colour of the ground on one side, as the white one between the sectors of a chart and the paper, is
/// seen as a step at its other side.
const OFF_CENTRE: f32 = 0.45;
const OFF_CENTRE_WIDTHS: f32 = 0.25;
/// The narrowest stroke whose contrast is computed from what is seen of it, px: below, single code values decide.
const NARROWEST: f32 = 0.1;
/// A stretch that is not seen and no longer than this, px, and half as much again as the stroke is wide, is hidden by
/// something that crosses it, or a stroke like it ends there; it is drawn all the same.
const HIDDEN: f32 = 6.0;
const HIDDEN_WIDTHS: f32 = 1.5;

/// A stroke is on the border of an area where the step between its two grounds is at least this share of its contrast.
/// Chosen by us.
const ON_BORDER: f32 = 0.5;

/// The stretches of a proposal that the picture shows, with their contrast.
pub(super) fn confirmed(proposal: &Proposal, picture: &Lab, params: &Params) -> Vec<Confirmed> {
    let Proposal { line, stroke, .. } = proposal;
    let seen: Vec<SegmentStep> = line.segments().map(|(a, b)| look(*a, *b, *stroke, picture)).collect();
    if seen.iter().all(|seen| seen.strength < params.high) {
        return Vec::new();
    }
    let lengths: Vec<f32> = line.segments().map(|(a, b)| (*b - *a).length()).collect();
    let shown = bridged(
        &seen.iter().map(|seen| seen.strength >= params.low).collect::<Vec<_>>(),
        &lengths,
        most_hidden(*stroke),
        line.closed,
    );
    let length_of = |stretch: &SegmentRun| stretch.indices().map(|i| lengths[i % lengths.len()]).sum::<f32>();
    // a border that nobody sees, as of white on white, shows a step at the end of a stroke that ends on it
    let is_end_of_stroke =
        |stretch: &SegmentRun| stroke.is_none() && !stretch.whole_ring && length_of(stretch) <= HIDDEN;
    stretches(&shown, line.closed)
        .into_iter()
        .filter(|stretch| stretch.indices().any(|i| seen[i % seen.len()].strength >= params.high))
        .filter(|stretch| !is_end_of_stroke(stretch))
        .map(|stretch| {
            let on_borders = stretch.indices().filter(|i| seen[i % seen.len()].is_on_border).count();
            Confirmed { line: part(line, &seen, &stretch, params.low), stroke: *stroke, on_borders, faint: false }
        })
        .collect()
}

/// The longest stretch of a line that something that crosses it hides, px.
pub(super) fn most_hidden(stroke: Option<f32>) -> f32 {
    HIDDEN + HIDDEN_WIDTHS * stroke.unwrap_or(0.0)
}

/// What the picture shows at a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
struct SegmentStep {
    strength: f32,
    /// Colour on the right less colour on the left.
    contrast: [f32; 3],
    /// Whether it is one of a stroke along the border of a darker or lighter area.
    is_on_border: bool,
}

/// Looks across the middle of a segment.
fn look(a: PxPoint, b: PxPoint, stroke: Option<f32>, picture: &Lab) -> SegmentStep {
    let nothing = SegmentStep { strength: 0.0, contrast: [0.0; 3], is_on_border: false };
    let at = a.lerp(b, 0.5);
    let size = picture.size;
    let Some(along) = (b - a).try_normalize() else { return nothing };
    let reach = stroke.unwrap_or(0.0) * 0.5;
    if at.x < -reach || at.y < -reach || at.x > size.width as f32 + reach || at.y > size.height as f32 + reach {
        return nothing;
    }
    // with y down, right of the direction (x, y) is (-y, x)
    let right = right_of(along);
    let colour = |distance: f32| picture.colour(at + right * distance);
    match stroke {
        None => step(colour).unwrap_or(nothing),
        Some(width) => {
            let outside = reach + FAR;
            let grounds = [-outside, outside].map(colour);
            let strength = stroke_contrast(width, grounds, colour);
            // a stroke along the border of the picture has one ground only
            let has_both = [-outside, outside].into_iter().all(|side| picture.holds(at + right * side));
            let step = length(less(grounds[1], grounds[0]));
            let is_on_border = strength > 0.0 && has_both && step >= ON_BORDER * strength;
            SegmentStep { strength, contrast: [0.0; 3], is_on_border }
        }
    }
}

/// The step of an outline, if it is here.
fn step(colour: impl Fn(f32) -> [f32; 3]) -> Option<SegmentStep> {
    let difference = |distance: f32| less(colour(distance), colour(-distance));
    let (close, far) = (difference(CLOSE), difference(FAR));
    let (near, all) = (length(close), length(far));
    if near < HERE * all {
        return None;
    }
    // a strip narrower than the pixels look has its own ground on both sides
    Some(if all >= near {
        SegmentStep { strength: all, contrast: far, is_on_border: false }
    } else {
        SegmentStep { strength: near, contrast: close, is_on_border: false }
    })
}

/// Contrast of a stroke to its grounds, those on its left and on its right, whatever share of the pixels it covers: the
/// sum of what differs from the ground beside it, over its width. 0 where it is not seen, or not here. Between two
/// grounds it is at least their step.
fn stroke_contrast(width: f32, [left, right]: [[f32; 3]; 2], colour: impl Fn(f32) -> [f32; 3]) -> f32 {
    let outside = 0.5 * width + FAR;
    let steps = (outside / STEP).ceil() as i32;
    let (mut sum, mut moment, mut weight) = ([0.0; 3], 0.0, 0.0);
    for k in -steps..=steps {
        let distance = outside * k as f32 / steps as f32;
        let ground = match k.signum() {
            -1 => left,
            0 => std::array::from_fn(|i| 0.5 * (left[i] + right[i])),
            _ => right,
        };
        let excess = less(colour(distance), ground);
        // half a step at both ends
        let share = if k.abs() == steps { 0.5 } else { 1.0 };
        sum = std::array::from_fn(|i| sum[i] + share * excess[i]);
        moment += share * distance * length(excess);
        weight += share * length(excess);
    }
    let step = outside / steps as f32;
    let contrast = length(sum) * step / width.max(NARROWEST);
    let centred = weight > 0.0 && (moment / weight).abs() <= OFF_CENTRE + OFF_CENTRE_WIDTHS * width;
    if centred { contrast.max(length(less(right, left))).min(MOST) } else { 0.0 }
}

/// Largest contrast: between two colours that a screen can show.
const MOST: f32 = 400.0;

/// A picture as L, 2a and 2b. Rendering mixes code values along an edge, and L is one, so between the centres of pixels
/// these are interpolated, not linear light.
pub(super) struct Lab {
    size: Size,
    planes: Vec<Vec<f32>>,
}

impl Lab {
    pub(super) fn of(raster: &Raster) -> Self {
        let mut planes = vec![vec![0.0; raster.size().len()]; lab::planes(raster)];
        let from: Vec<&[f32]> = raster.planes().iter().map(Vec::as_slice).collect();
        lab::convert(Arch::new(), &from, &mut planes);
        Self { size: raster.size(), planes }
    }

    /// Whether a point lies in the picture.
    fn holds(&self, at: PxPoint) -> bool {
        (0.0..=self.size.width as f32).contains(&at.x) && (0.0..=self.size.height as f32).contains(&at.y)
    }

    /// Colour at a point; beyond the picture that of its border.
    pub(super) fn colour(&self, at: PxPoint) -> [f32; 3] {
        let axis = |at: f32, count: u32| {
            let at = (at - 0.5).clamp(0.0, count as f32 - 1.0);
            let first = (at.floor() as usize).min(count as usize - 1);
            (first, (first + 1).min(count as usize - 1), at - first as f32)
        };
        let ((left, right, x), (above, below, y)) = (axis(at.x, self.size.width), axis(at.y, self.size.height));
        let width = self.size.width as usize;
        let mut colour = [0.0; 3];
        for (value, plane) in colour.iter_mut().zip(&self.planes) {
            let row = |row: usize| plane[row * width + left] * (1.0 - x) + plane[row * width + right] * x;
            *value = row(above) * (1.0 - y) + row(below) * y;
        }
        colour
    }
}

/// Closes the gaps that are no longer than `hidden`, px, also at the ends.
fn bridged(shown: &[bool], lengths: &[f32], hidden: f32, closed: bool) -> Vec<bool> {
    let mut bridged = shown.to_vec();
    if !shown.contains(&true) {
        return bridged;
    }
    for gap in stretches(&shown.iter().map(|shown| !shown).collect::<Vec<_>>(), closed) {
        let indices = || gap.indices().map(|i| i % shown.len());
        if indices().map(|i| lengths[i]).sum::<f32>() <= hidden {
            indices().for_each(|i| bridged[i] = true);
        }
    }
    bridged
}

/// A stretch of a line with what is seen there; what is hidden has the least strength that is drawn.
fn part(line: &Polyline<PxPoint>, seen: &[SegmentStep], stretch: &SegmentRun, least: f32) -> Polyline<Edgel> {
    let n = seen.len();
    let strength_of = |i: usize| SegmentStep { strength: seen[i % n].strength.max(least), ..seen[i % n] };
    // a vertex has the mean of the segments on both sides, as far as they belong to the stretch
    let edgel = |vertex: usize, before: Option<usize>, after: Option<usize>| {
        let both: Vec<SegmentStep> = [before, after].into_iter().flatten().map(strength_of).collect();
        let count = both.len().max(1) as f32;
        Edgel {
            at: line.vertices[vertex % line.vertices.len()],
            strength: both.iter().map(|seen| seen.strength).sum::<f32>() / count,
            contrast: std::array::from_fn(|i| both.iter().map(|seen| seen.contrast[i]).sum::<f32>() / count),
        }
    };
    let last = stretch.first + stretch.count;
    let vertices = if stretch.whole_ring {
        (0..n).map(|i| edgel(i, Some(i + n - 1), Some(i))).collect()
    } else {
        (stretch.first..=last).map(|i| edgel(i, (i > stretch.first).then(|| i - 1), (i < last).then_some(i))).collect()
    };
    Polyline { vertices, closed: stretch.whole_ring }
}

#[cfg(test)]
mod tests;
