//! Marks of a dial inside its rim: short strokes that point at its middle, all as far from it. One is found as a stroke
//! and another as a ring, by a fraction of a pixel; of one kind all are strokes.

use lyon::geom::euclid::Box2D;

use super::face::Face;
use crate::edges::contour::{Contour, ContourPoint};
use crate::edges::tips::FoundContour;
use crate::units::{PxPoint, PxVector};

/// Marks lie between these distances from the middle, and are no longer than this, in radii.
const BETWEEN: [f32; 2] = [0.55, 1.02];
const LONGEST: f32 = 0.2;
/// They are so many times as long as wide.
const LONG: f32 = 1.7;
/// There are so many of a kind at least: their ends are as far from the middle but for this, in radii, and none is so
/// many times as long or as wide as another, but for this, px.
const LEAST: usize = 4;
const AS_FAR: f32 = 0.03;
const ALIKE: f32 = 1.4;
const ROUNDING: f32 = 2.0;

/// A short contour that points at the middle.
#[derive(Debug, Clone, Copy)]
struct Mark {
    /// Of its contour.
    number: usize,
    /// Away from the middle: of length 1.
    way: PxVector,
    /// How far its ends are from there, px.
    inner: f32,
    outer: f32,
    width: f32,
}

impl Mark {
    fn of(number: usize, found: &FoundContour, face: &Face) -> Option<Self> {
        let places = || found.contour.vertices.iter().map(|vertex| vertex.at - face.middle);
        let sum = places().fold(PxVector::zero(), |sum, place| sum + place);
        let way = sum.try_normalize()?;
        // away from the middle, and across
        let turned = Box2D::from_points(places().map(|place| PxPoint::new(place.dot(way), place.cross(way))));
        let (inner, outer) = (turned.min.x, turned.max.x);
        let width = turned.height().max(found.stroke.unwrap_or(0.0));
        let length = outer - inner;
        let [nearest, farthest] = BETWEEN.map(|share| share * face.radius);
        let is_between = inner >= nearest && outer <= farthest;
        let is_mark = is_between && length <= LONGEST * face.radius && length >= LONG * width && width > 0.0;
        is_mark.then_some(Self { number, way, inner, outer, width })
    }

    fn is_like(&self, other: &Self, radius: f32) -> bool {
        let alike = |a: f32, b: f32| a.max(b) <= ALIKE * a.min(b) + ROUNDING;
        (self.outer - other.outer).abs() <= AS_FAR * radius
            && alike(self.outer - self.inner, other.outer - other.inner)
            && alike(self.width, other.width)
    }
}

/// Contours in which all marks of a dial are strokes.
pub(super) fn as_strokes(found: &mut [FoundContour], face: &Face) {
    let all = found.iter().enumerate().filter_map(|(number, found)| Mark::of(number, found, face));
    let marks: Vec<Mark> = all.collect();
    for mark in &marks {
        let alike = marks.iter().filter(|other| mark.is_like(other, face.radius)).count();
        if alike < LEAST || found[mark.number].stroke.is_some() {
            continue;
        }
        let of = &found[mark.number];
        let Some(&first) = of.contour.vertices.first() else { continue };
        let [from, to] = [mark.inner, mark.outer].map(|distance| face.middle + mark.way * distance);
        let point = ContourPoint { at: from, strength: of.height(), contrast: [0.0; 3], ..first };
        let mut contour = Contour::open(vec![point]);
        contour.lead_to(to);
        let whole = contour.length();
        found[mark.number] = FoundContour { contour, stroke: Some(mark.width), whole, tint: None };
    }
}
