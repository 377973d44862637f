//! Signs in a bitmap that mark places, such as the points of a scatter plot: many that are small, alike and scattered.
//! What is found of one as strokes and edges is torn where a gridline or another sign touches it, and is too short for
//! a line elsewhere. So they are found in the pixels as wholes, and taken out of them; then each is a ring among the
//! contours, as points of a vector drawing are:
//!
//! ```text
//! Lab planes -> blobs (small, by themselves) -> kinds (alike in size and colour) -> template (what they look like)
//!            -> matches (all that look so, also where something touches them) -> Signs -> rings; pixels without them
//! ```
//!
//! No signs are letters (they stand beside others), the dots and dashes of a line, windows, bricks and patterns (they
//! are in rows, or near one another), and the points of a curve in its colour (the curve touches them). Those of a
//! vector drawing are found among its paths (`drawing/painted_signs`), by nearly the same rules.

mod blobs;
mod template;

use std::f32::consts::TAU;

use self::blobs::{Blob, kinds};
use self::template::{Shape, Sought, Template};
use super::edgel::{ChainKind, Edgel, Edges};
use crate::geom::polygon::circle_points;
use crate::raster::plane::Plane;
use crate::raster::{Planes, Raster};
use crate::units::{PxPoint, Size};

/// So many that are alike are signs, as so many points on one line are a series.
pub(super) const LEAST: usize = 4;
/// The sizes of signs, mm: a larger one has room as it is, a smaller one is the dot of a shade.
pub(super) const SMALLEST: f32 = 1.0;
const LARGEST: f32 = 5.0;
/// From most of them the next one of their kind is this far, mm, and in their sides: fingers can tell them apart, and
/// they are no pattern.
const APART: f32 = 4.0;
const APART_SIDES: f32 = 2.2;
/// These distances differ by at least this share of their mean, or the signs are a dotted line or a pattern.
const EVEN: f32 = 0.08;
/// Of so many signs in a row or a column, as a share of all, there is one in each.
const SCATTERED: f32 = 0.5;
/// At most this share of them may have something else that is small beside them, as letters have, within so many of
/// their sides.
const BESIDE: f32 = 0.25;
const BESIDE_SIDES: f32 = 1.3;

/// Two places are those of one sign if they are less than this share of its side apart.
const SAME: f32 = 0.6;

/// A small thing at the place of a sign is that if it is at most so many times as large.
const AS_LARGE: f32 = 1.4;

/// The strength of thin strokes along their length, as a share of that of their strongest pixel: what is beside them,
/// such as an axis, is no paler than it is. Chosen by us.
const THIN: f32 = 0.7;

/// A sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sign {
    pub(super) at: PxPoint,
    pub(super) radius: f32,
    pub(super) strength: f32,
}

/// Something small that is no sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Neighbour {
    pub(super) middle: [f32; 2],
    pub(super) sides: [f32; 2],
}

/// Signs of a kind in the pixels.
struct Found {
    template: Template,
    shape: Shape,
    /// Where the picture of each begins, and its middle.
    places: Vec<([i32; 2], [f32; 2])>,
}

impl Found {
    /// All signs that look like these small things, which are alike, if they are scattered and of a shape that marks
    /// places.
    fn of(kind: Vec<Blob>, planes: &[Plane], px_per_mm: f32) -> Option<Self> {
        let template = Template::of(&kind, planes);
        let shape = template.shape()?;
        let side = template.side();
        if side < SMALLEST * px_per_mm {
            return None;
        }
        let sought = Sought::of(&template, &kind, planes)?;
        let count = kind.len();
        let own: Vec<Blob> = kind.into_iter().filter(|blob| sought.has(blob)).collect();
        // letters of one size are of many shapes
        if own.len() < LEAST.max(count.div_ceil(2)) {
            return None;
        }
        let matches = sought.matches(shape);
        let touched = matches.iter().filter(|found| found.is_touched()).count();
        let mut places: Vec<([i32; 2], [f32; 2])> =
            matches.iter().map(|found| (found.min, template.middle(found))).collect();
        for blob in &own {
            let at = blob.middle();
            match places.iter_mut().find(|(_, of)| distance(*of, at) < SAME * side) {
                Some((_, of)) => *of = at,
                None => places.push((template.corner_at(blob), at)),
            }
        }
        let at: Vec<[f32; 2]> = places.iter().map(|(_, at)| *at).collect();
        let apart = (APART_SIDES * side).max(APART * px_per_mm);
        let are_signs = 2 * touched <= places.len() && are_scattered(&at, apart);
        are_signs.then_some(Self { template, shape, places })
    }

    fn side(&self) -> f32 {
        self.template.side()
    }

    fn middles(&self) -> impl Iterator<Item = [f32; 2]> + '_ {
        self.places.iter().map(|(_, at)| *at)
    }

    /// Their pixels.
    fn cells(&self, size: Size) -> impl Iterator<Item = usize> + '_ {
        self.places.iter().flat_map(move |(min, _)| self.template.cells(*min, size))
    }

    fn signs(&self) -> Vec<Sign> {
        let share = if self.shape == Shape::Filled { 1.0 } else { THIN };
        let (radius, strength) = (0.5 * self.side(), share * self.template.contrast());
        self.middles().map(|at| Sign { at: PxPoint::new(at[0], at[1]), radius, strength }).collect()
    }
}

/// The signs of a picture, in pixels or among paths.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Signs {
    /// Kind by kind: filled ones first, then those that are many.
    kinds: Vec<Vec<Sign>>,
    /// The pixels of all of them.
    cells: Vec<usize>,
}

impl Signs {
    /// Those of a drawing of this size, given as planes of Lab.
    pub(super) fn find(planes: &[Plane], size: Size, px_per_mm: f32) -> Self {
        let Some((signs, others)) = blobs::find(planes, (LARGEST * px_per_mm).ceil() as usize) else {
            return Self::default();
        };
        let mut found: Vec<Found> =
            kinds(signs, LEAST).into_iter().filter_map(|kind| Found::of(kind, planes, px_per_mm)).collect();
        // beside signs there may be signs of another kind
        let is_of = |kind: &Found, other: &Blob| {
            let is_there = |at: [f32; 2]| distance(at, other.middle()) < SAME * kind.side();
            other.side() as f32 <= AS_LARGE * kind.side() && kind.middles().any(is_there)
        };
        let is_sign = |other: &Blob| found.iter().any(|kind| is_of(kind, other));
        let neighbour = |other: &Blob| Neighbour { middle: other.middle(), sides: other.sides.map(|side| side as f32) };
        let others: Vec<Neighbour> = others.iter().filter(|other| !is_sign(other)).map(neighbour).collect();
        found.retain(|kind| !are_letters(&kind.middles().collect::<Vec<_>>(), kind.side(), &others));
        found.sort_by_key(|kind| (kind.shape != Shape::Filled, std::cmp::Reverse(kind.places.len())));
        let cells = found.iter().flat_map(|kind| kind.cells(size)).collect();
        Self { kinds: found.iter().map(Found::signs).collect(), cells }
    }

    /// Those of a vector drawing, kind by kind.
    pub(super) fn of_kinds(kinds: Vec<Vec<Sign>>) -> Self {
        Self { kinds, cells: Vec::new() }
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// Strength and length of their outlines.
    pub(super) fn outlines(&self) -> Vec<(f32, f32)> {
        let signs = self.kinds.iter().flatten();
        signs.map(|sign| (sign.strength, TAU * sign.radius)).collect()
    }

    /// The picture without them: what lies on both sides of a sign, in its row or its column, goes on through it.
    pub(super) fn erased_from(&self, raster: &Raster) -> Raster {
        let size = raster.size();
        let mut is_sign = vec![false; size.len()];
        self.cells.iter().for_each(|cell| is_sign[*cell] = true);
        let mut planes = raster.planes().clone();
        for cell in (0..size.len()).filter(|cell| is_sign[*cell]) {
            let values = beneath(raster.planes(), &is_sign, cell, size);
            planes.as_mut_slice().iter_mut().zip(values).for_each(|(plane, value)| plane[cell] = value);
        }
        Raster::new(size, planes)
    }

    /// Adds them to contours: those of the first kind as filled points, others as hollow ones, so that fingers can tell
    /// them apart.
    pub(super) fn add_to(&self, edges: &mut Edges) {
        for (number, kind) in self.kinds.iter().enumerate() {
            let of_kind = Some(u8::try_from(number).unwrap_or(u8::MAX));
            for sign in kind {
                let is_filled = number == 0;
                let contrast = [if is_filled { sign.strength } else { 0.0 }, 0.0, 0.0];
                let edgel = |at: PxPoint| Edgel { at, strength: sign.strength, contrast };
                let count = ((TAU * sign.radius).ceil() as usize).max(16);
                let stroke = (!is_filled).then_some(1.0);
                edges.push_as(
                    ChainKind { exact: true, of_drawing: true, sign: of_kind, stroke, ..ChainKind::default() },
                    circle_points(sign.at, sign.radius, count).map(edgel),
                    true,
                );
            }
        }
    }
}

fn distance(a: [f32; 2], b: [f32; 2]) -> f32 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Whether signs lie so far apart, px, most of them, and in no rows, columns or even distances.
pub(super) fn are_scattered(at: &[[f32; 2]], least_apart: f32) -> bool {
    let nearest = |i: usize| {
        let others = (0..at.len()).filter(|other| *other != i);
        others.map(|other| distance(at[i], at[other])).fold(f32::INFINITY, f32::min)
    };
    let mut apart: Vec<f32> = (0..at.len()).map(nearest).collect();
    apart.sort_by(f32::total_cmp);
    let mean = apart.iter().sum::<f32>() / apart.len() as f32;
    let spread = (apart.iter().map(|of| (of - mean).powi(2)).sum::<f32>() / apart.len() as f32).sqrt();
    let lanes = |axis: usize| {
        let mut places: Vec<f32> = at.iter().map(|at| at[axis]).collect();
        places.sort_by(f32::total_cmp);
        1 + places.windows(2).filter(|pair| pair[1] - pair[0] > 1.0).count()
    };
    let least = SCATTERED * at.len() as f32;
    apart[apart.len() / 2] >= least_apart
        && spread >= EVEN * mean
        && [0, 1].into_iter().all(|axis| lanes(axis) as f32 >= least)
}

/// Whether other small things stand beside many of them, as letters do.
pub(super) fn are_letters(at: &[[f32; 2]], side: f32, others: &[Neighbour]) -> bool {
    let has_beside = |at: &&[f32; 2]| {
        others.iter().any(|other| {
            let gap = |axis: usize| (other.middle[axis] - at[axis]).abs() - 0.5 * (other.sides[axis] + side);
            let is_own = distance(other.middle, **at) < SAME * side;
            !is_own && gap(0).max(gap(1)) < BESIDE_SIDES * side
        })
    };
    at.iter().filter(has_beside).count() as f32 > BESIDE * at.len() as f32
}

/// The colour that a pixel has without the signs: between the nearest ones beside these in its row or its column. Of
/// the two, what differs less between its sides, or else the darker one, as a line that leads on.
fn beneath(planes: &Planes<Vec<f32>>, is_sign: &[bool], cell: usize, size: Size) -> Vec<f32> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    let left = (0..x).rev().map(|x| y * width + x).find(|at| !is_sign[*at]);
    let right = (x + 1..width).map(|x| y * width + x).find(|at| !is_sign[*at]);
    let above = (0..y).rev().map(|y| y * width + x).find(|at| !is_sign[*at]);
    let below = (y + 1..height).map(|y| y * width + x).find(|at| !is_sign[*at]);
    let sum = |at: usize| planes.iter().map(|plane| plane[at]).sum::<f32>();
    let pair = |a: Option<usize>, b: Option<usize>| {
        let (a, b) = (a.or(b)?, b.or(a)?);
        Some(([a, b], (sum(a) - sum(b)).abs(), sum(a) + sum(b)))
    };
    let ways: Vec<_> = [pair(left, right), pair(above, below)].into_iter().flatten().collect();
    let even = |of: f32| of <= EVEN_ENDS;
    let best = ways.into_iter().min_by(|a, b| match (even(a.1), even(b.1)) {
        (true, true) => a.2.total_cmp(&b.2),
        _ => a.1.total_cmp(&b.1),
    });
    planes.iter().map(|plane| best.map_or(plane[cell], |([a, b], ..)| 0.5 * (plane[a] + plane[b]))).collect()
}

/// Two pixels are of one colour if their sums differ by no more, in linear light.
const EVEN_ENDS: f32 = 0.15;

#[cfg(test)]
mod tests;
