//! The hands of clocks and gauges in a bitmap. A hand may be broad, pointed, or have the shape of a leaf, and all of
//! them are one dark thing with the hub: its outline says little to a finger, which asks where each hand points. So
//! each is one stroke, from the middle of the dial to its tip.
//!
//! ```text
//! closed contour, round or square -> its middle -> the ink that is connected there -> the farthest ink, as a ray
//!                                                   -> what it explains is taken away, and the next one looked for
//! ```
//!
//! Ink that reaches the rim, as a spoke or the sector of a pie, is no hand, and what is no ray none either.

mod face;
mod marks;
mod rays;

use self::face::Face;
use self::rays::{Ray, hands};
use super::contour::{Contour, ContourPoint};
use super::discs::Disc;
use super::params::Params;
use super::stroke::{FilledHead, Tint};
use super::tips::FoundContour;
use crate::raster::contrast;
use crate::raster::plane::Plane;
use crate::units::PxPoint;

/// A dial has a radius of so many least lengths of a contour at least: 10 mm on the page.
const SMALLEST: f32 = 5.0;
/// A contour is that of the hands if this share of it lies on their ink or beside it, so far in scales of the edge
/// detector and this much more, px.
const OF_HANDS: f32 = 0.7;
const BESIDE_SCALES: f32 = 1.6;
const BESIDE: f32 = 1.5;
/// How far points of a stroke lie from its middle by chance, and its blur beyond half its width, px.
const OFF: f32 = 0.2;
const UNSURE: f32 = 1.5;

/// Contours of a drawing with the hands of dials as strokes. Discs at the middle of a dial are its hub, and go.
/// Hands with filled heads stay as they are: these are found by themselves.
pub(super) fn with_hands(
    mut found: Vec<FoundContour>,
    discs: &mut Vec<Disc>,
    heads: &[FilledHead],
    planes: &[Plane],
    params: &Params,
) -> Vec<FoundContour> {
    let least = SMALLEST * params.min_length;
    let mut rims: Vec<Face> = found.iter().filter_map(|found| Face::within(&found.contour, least)).collect();
    // of two rims round one middle the inner one is nearer to what is in it
    rims.sort_by(|a, b| a.radius.total_cmp(&b.radius));
    let mut dials: Vec<PxPoint> = Vec::new();
    for mut rim in rims {
        marks::as_strokes(&mut found, &rim);
        let is_arrow = |head: &FilledHead| (head.apex - rim.middle).length() < rim.radius;
        if dials.iter().any(|dial| (*dial - rim.middle).length() < least) || heads.iter().any(is_arrow) {
            continue;
        }
        let Some(ink) = rim.ink(planes) else { continue };
        let Some(rays) = hands(&ink, params.widest_stroke) else { continue };
        let beside = BESIDE_SCALES * params.sigma + BESIDE;
        let is_hand = |found: &FoundContour| {
            let vertices = &found.contour.vertices;
            let count = vertices.iter().filter(|vertex| ink.is_near(vertex.at, beside)).count();
            count as f32 >= OF_HANDS * vertices.len() as f32
        };
        found.retain(|found| !is_hand(found));
        discs.retain(|disc| !ink.is_near(disc.at(), beside));
        let stroke = |ray: &Ray| stroke(ray, rim.middle, rim.ground, planes, params);
        found.extend(rays.iter().filter_map(stroke));
        dials.push(rim.middle);
    }
    found
}

/// The stroke along a hand.
fn stroke(ray: &Ray, middle: PxPoint, ground: [f32; 3], planes: &[Plane], params: &Params) -> Option<FoundContour> {
    let excess = |at: PxPoint| -> [f32; 3] {
        std::array::from_fn(|k| planes.get(k).map_or(0.0, |plane| plane.at(at.x, at.y) - ground[k]))
    };
    let tip = middle + ray.way * ray.length;
    let there = excess(middle + ray.way * (ray.length * 0.6));
    let width = ray.width.min(params.widest_stroke).max(1.0);
    let first = ContourPoint {
        at: middle,
        strength: contrast::length(there),
        contrast: [0.0; 3],
        blur: 0.5 * width + UNSURE,
        position_sigma: OFF,
    };
    let mut contour = Contour::open(vec![first]);
    contour.lead_to(tip);
    Some(FoundContour { whole: contour.length(), contour, stroke: Some(width), tint: Tint::of(there) })
}

#[cfg(test)]
mod tests;
