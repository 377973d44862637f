//! What a filled head of an arrow is, and colours in planes.

use crate::raster::plane::Plane;
use crate::units::PxPoint;

/// A colour, or how far one is from another: a value of each plane.
pub(in crate::edges) type PlaneColour = [f32; 3];

/// A filled head at the end of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::edges) struct FilledHead {
    /// Its tip.
    pub(in crate::edges) apex: PxPoint,
    /// The middle of its base.
    pub(in crate::edges) base: PxPoint,
    /// Half the width of its base, px.
    pub(in crate::edges) half_width: f32,
    /// Width of its shaft, px.
    pub(in crate::edges) shaft: f32,
    /// The colour around it, and how far its own is from that.
    pub(in crate::edges) ground: PlaneColour,
    pub(in crate::edges) ink: PlaneColour,
    /// Where a line that comes from the tip passes `LINE_AT` before the base, px to the right of the shaft: the side
    /// of a box at which the arrow points aslant, or another one at its tip.
    pub(in crate::edges) line: Option<f32>,
}

impl FilledHead {
    /// Whether it points the same way as another: the least cosine between the two.
    pub(super) fn points_as(&self, other: &Self, least: f32) -> bool {
        let [a, b] = [self, other].map(|head| (head.apex - head.base).normalize());
        a.dot(b) > least
    }
}

pub(super) fn colour(planes: &[Plane], at: PxPoint) -> PlaneColour {
    std::array::from_fn(|k| planes.get(k).map_or(0.0, |plane| plane.at(at.x, at.y)))
}
