//! Filled heads of arrows in a bitmap. They are taken out of the pixels before the strokes are found that count, so
//! that the shaft and what it points at are found as if there were no head; each is then a triangle among the contours,
//! and its shaft ends at its tip.

use std::collections::BTreeSet;

use lyon::geom::euclid::Box2D;

use super::contour::{Contour, ContourPoint};
use super::edgel::{ChainKind, Edgel, Edges};
use super::stroke::{FilledHead, LINE_AT, PlaneColour};
use super::tips::FoundContour;
use crate::geom::nearby::Index;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::geom::right_of;
use crate::raster::contrast;
use crate::raster::plane::Plane;
use crate::units::{Px, PxPoint, PxVector};

/// Pixels show a head this far beyond its sides and its base, px.
const RIM: f32 = 1.5;
const BASE_RIM: f32 = 2.0;
/// What it points at begins this much before its tip, px, and the width of the shaft.
const TIP: f32 = 1.5;
/// A line beside it keeps this much more than half the width of the shaft, px.
const LINE: f32 = 1.25;
/// Edges this far outside of it, in scales of the edge detector, and as far before its tip, are its own.
const EDGES: f32 = 1.5;
const EDGES_TIP: f32 = 2.0;
/// A contour leads through a head if it passes its base and its tip no farther away than this, px; of its tip half the
/// width of the shaft more.
const PASSES_BASE: f32 = 2.5;
const PASSES_TIP: f32 = 3.0;
/// What of a contour lies behind a tip is a part of its own if it is this long, px; less is a gap that was closed.
const GOES_ON: f32 = 6.0;
/// A ring is a shaft that leads to its own start if it is at least so many times as long as the head; a shorter one is
/// a sign on a line. Chosen by us.
const RING: f32 = 6.0;
/// A shaft that ends less than this behind its tip, px, touches what its arrow points at.
const GAP: f32 = 2.5;
/// Heads are found again by cells with this side, px, and farther around them by this than they are asked: what is
/// near a head is computed with rounding.
const CELL: f32 = 16.0;
const ROUNDING: f32 = 0.1;

impl FilledHead {
    /// Where a place is: px along the head from its base, and to the right.
    fn place(&self, at: PxPoint) -> (f32, f32) {
        let along = (self.apex - self.base).normalize();
        let from_base = at - self.base;
        (from_base.dot(along), from_base.dot(right_of(along)))
    }

    fn length(&self) -> f32 {
        (self.apex - self.base).length()
    }

    /// Half its width so far from its base, px.
    fn half_at(&self, along: f32) -> f32 {
        self.half_width * (1.0 - along.max(0.0) / self.length())
    }

    /// The colour that a pixel has without the head, if that is another one.
    fn colour_without(&self, at: PxPoint) -> Option<PlaneColour> {
        let (along, right) = self.place(at);
        let is_in =
            (-BASE_RIM..=self.length() - TIP - self.shaft).contains(&along) && right.abs() <= self.half_at(along) + RIM;
        if !is_in || self.is_on_line(along, right) {
            return None;
        }
        let ink = (0.5 * self.shaft + 0.5 - right.abs()).clamp(0.0, 1.0);
        Some(std::array::from_fn(|k| self.ground[k] + ink * self.ink[k]))
    }

    /// Whether a place is on the line that passes the head.
    fn is_on_line(&self, along: f32, right: f32) -> bool {
        let apex = PxPoint::new(self.length(), 0.0);
        self.line.is_some_and(|line| {
            let beside = PxPoint::new(-LINE_AT, line);
            let before = beside + (beside - apex);
            nearest_on_segment(PxPoint::new(along, right), before, apex).0 <= 0.5 * self.shaft + LINE
        })
    }

    /// Takes it out of the pixels: its shaft goes on up to its tip.
    fn take_out(&self, planes: &mut [Plane]) {
        let Some(size) = planes.first().map(|plane| plane.size) else { return };
        let reach = self.length() + self.half_width + BASE_RIM + RIM;
        let range = |at: f32, most: u32| {
            let first = (at - reach).floor().max(0.0) as usize;
            first..((at + reach).ceil().max(0.0) as usize).min(most as usize)
        };
        for y in range(self.base.y, size.height) {
            for x in range(self.base.x, size.width) {
                let Some(colour) = self.colour_without(PxPoint::new(x as f32 + 0.5, y as f32 + 0.5)) else { continue };
                for (plane, value) in planes.iter_mut().zip(colour) {
                    plane.values[y * size.width as usize + x] = value;
                }
            }
        }
    }

    /// Whether a point of an edge is its own; `sigma` is the scale of the edge detector, px.
    fn has_edge(&self, at: PxPoint, sigma: f32) -> bool {
        let (along, right) = self.place(at);
        (-EDGES * sigma..=self.length() - EDGES_TIP * sigma).contains(&along)
            && right.abs() <= self.half_at(along) + EDGES * sigma
    }

    /// No edge is its own that is so far from its base, px.
    fn reach_of_edges(&self, sigma: f32) -> f32 {
        self.length() + self.half_width + 2.0 * EDGES * sigma
    }

    /// No contour leads through it that passes its tip farther away than this, px.
    fn reach_of_tip(&self) -> f32 {
        PASSES_TIP + 0.5 * self.shaft
    }

    /// The vertex of a contour at which its tip is, if the contour leads there from its base.
    fn passed_by(&self, contour: &Contour) -> Option<usize> {
        let distance = |i: &usize| (contour.vertices[*i].at - self.apex).length();
        let tip = (0..contour.vertices.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        if distance(&tip) > self.reach_of_tip() {
            return None;
        }
        let reach = self.length() + GOES_ON;
        let passes_base = |forwards: bool| {
            let mut near = contour.walk(tip, forwards).take_while(|(_, arc)| *arc <= reach);
            near.any(|(i, _)| (contour.vertices[i].at - self.base).length() <= PASSES_BASE)
        };
        [true, false].into_iter().any(passes_base).then_some(tip)
    }

    /// Whether the end of a contour is in it, or at its tip or its base.
    pub(super) fn has_end(&self, contour: &Contour) -> bool {
        let near = 0.5 * self.shaft + PASSES_TIP;
        let is_near = |at: PxPoint| nearest_on_segment(at, self.base, self.apex).0 <= near;
        let ends = contour.vertices.first().into_iter().chain(contour.vertices.last());
        !contour.closed && ends.into_iter().any(|end| is_near(end.at))
    }
}

/// Heads found again by place: most of a picture is far from any.
struct HeadsByPlace<'a> {
    heads: &'a [FilledHead],
    /// The numbers of those that are asked in each cell.
    index: Index<usize, Px>,
}

impl<'a> HeadsByPlace<'a> {
    /// Each head is asked as far around a place as `asked` says.
    fn new(heads: &'a [FilledHead], asked: impl Fn(&FilledHead) -> (PxPoint, f32)) -> Self {
        let place = |head: &FilledHead| {
            let (at, reach) = asked(head);
            let beyond = PxVector::splat(reach + ROUNDING);
            Box2D::new(at - beyond, at + beyond)
        };
        let places: Vec<Box2D<f32, Px>> = heads.iter().map(place).collect();
        // what lies farther out than all of them is in cells without any
        let all = Box2D::from_points(places.iter().flat_map(|of| [of.min, of.max])).inflate(CELL, CELL);
        let mut index = Index::new(all, CELL);
        places.iter().enumerate().for_each(|(number, of)| index.put_over(of.min, of.max, number));
        Self { heads, index }
    }

    /// By their tips: a contour leads through none but those that [`Self::along`] gives.
    fn by_tips(heads: &'a [FilledHead]) -> Self {
        Self::new(heads, |head| (head.apex, head.reach_of_tip()))
    }

    /// Those that may be asked at a place.
    fn at(&self, at: PxPoint) -> impl Iterator<Item = &FilledHead> {
        self.index.in_cell_of(at).iter().map(|number| &self.heads[*number])
    }

    /// Those that may be asked at vertices of a contour, in their order.
    fn along(&self, contour: &Contour) -> Vec<&'a FilledHead> {
        let numbers = contour.vertices.iter().flat_map(|vertex| self.index.in_cell_of(vertex.at)).copied();
        let numbers: BTreeSet<usize> = numbers.collect();
        numbers.into_iter().map(|number| &self.heads[number]).collect()
    }
}

/// The edges of heads.
pub(super) struct EdgesOfHeads<'a> {
    heads: HeadsByPlace<'a>,
    /// The scale of the edge detector, px.
    sigma: f32,
}

impl<'a> EdgesOfHeads<'a> {
    pub(super) fn of(heads: &'a [FilledHead], sigma: f32) -> Self {
        Self { heads: HeadsByPlace::new(heads, |head| (head.base, head.reach_of_edges(sigma))), sigma }
    }

    /// Whether a point of an edge is one of them.
    pub(super) fn has(&self, at: PxPoint) -> bool {
        self.heads.at(at).any(|head| head.has_edge(at, self.sigma))
    }
}

/// Takes heads out of the pixels.
pub(super) fn take_out(heads: &[FilledHead], planes: &mut [Plane]) {
    heads.iter().for_each(|head| head.take_out(planes));
}

/// The contours, of which those that lead through a head into what it points at are parted at its tip.
pub(super) fn parted(found: Vec<FoundContour>, heads: &[FilledHead]) -> Vec<FoundContour> {
    let heads = HeadsByPlace::by_tips(heads);
    let parts_of = |found: FoundContour| {
        let passed = heads.along(&found.contour);
        let mut parts = vec![found];
        for head in passed {
            parts = parts.into_iter().flat_map(|found| parted_at(found, head)).collect();
        }
        parts
    };
    found.into_iter().flat_map(parts_of).collect()
}

fn parted_at(found: FoundContour, head: &FilledHead) -> Vec<FoundContour> {
    let Some(parts) = parts_at(&found.contour, head) else { return vec![found] };
    parts.into_iter().map(|contour| FoundContour { contour, ..found }).collect()
}

/// The parts of a contour that leads through a head, but for short ones. A shaft whose tip touches its own start is a
/// ring without its head: that is opened at the tip.
fn parts_at(contour: &Contour, head: &FilledHead) -> Option<Vec<Contour>> {
    let tip = head.passed_by(contour)?;
    if contour.closed {
        return (contour.length() >= RING * head.length()).then(|| vec![contour.opened_at(tip)]);
    }
    let part = |vertices: &[ContourPoint]| Polyline::open(vertices.to_vec());
    let mut parts = vec![part(&contour.vertices[..=tip]), part(&contour.vertices[tip..])];
    parts.retain(|part| part.length() >= GOES_ON);
    Some(parts)
}

/// Shafts that were led on over a gap, to what their arrows point at, end at their tips again.
pub(super) fn shorten(contours: &mut [Contour], heads: &[FilledHead]) {
    let heads = HeadsByPlace::by_tips(heads);
    for contour in contours {
        for head in heads.along(contour) {
            if let Some([part]) = parts_at(contour, head).as_deref()
                && contour.length() - part.length() > GAP
            {
                *contour = part.clone();
            }
        }
    }
}

/// Adds heads: a triangle each, dark on its right as it is drawn.
pub(super) fn add(heads: &[FilledHead], edges: &mut Edges) {
    let kind = ChainKind { exact: true, of_drawing: true, head: true, ..ChainKind::default() };
    for head in heads {
        let aside = right_of((head.apex - head.base).normalize()) * head.half_width;
        let strength = contrast::length(head.ink);
        let corners = [head.apex, head.base + aside, head.base - aside].into_iter();
        edges.push_as(kind, corners.map(|at| Edgel { at, strength, contrast: head.ink }), true);
    }
}

#[cfg(test)]
mod tests;
