//! A small round shape that stands for a place on lines, or beside them.

use crate::lines::marks::PointMark;
use crate::lines::params::Params;
use crate::units::MmPoint;

/// A line leads to the middle of a point no farther from it than this share of its radius.
pub(super) const MIDDLE: f32 = 0.4;
/// A disc is drawn at most so many times as large as it is: smaller ones are the dots of a dotted line or of a shade.
pub(super) const MAGNIFIED: f32 = 3.0;
/// A disc of a cloud that is found in pixels is at least this large, as a share of the disc that is drawn for it: noise
/// has many smaller ones that are alike.
pub(super) const LEAST_IN_PIXELS: f32 = 0.6;
/// The middle line of the ring that is drawn as a disc, in half widths: its stroke fills it.
pub(super) const SOLID: f32 = 0.9;

/// A point on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::lines) struct Point {
    pub(in crate::lines) at: MmPoint,
    /// As it is in the drawing, mm.
    pub(super) radius: f32,
    pub(super) is_filled: bool,
    pub(super) strength: f32,
    /// The line that it is a point of, with others that are alike.
    pub(super) series: Option<usize>,
    /// Whether it lies beside all lines, and is like others on them.
    pub(super) is_alone: bool,
    /// Whether it is drawn as a disc at its own place, as all of a cloud of points.
    pub(super) is_disc: bool,
    /// Whether its outline is that of a path of a drawing, and not found in pixels.
    pub(super) is_exact: bool,
    /// Whether it is a shape for certain: its outline is that of a path, or in pixels keeps to a circle.
    pub(super) is_sure: bool,
    /// Whether it is as round as a circle, for fingers.
    pub(super) is_circle: bool,
    /// Whether it is a sign of a bitmap that marks a place beside all lines, and was found as a whole.
    pub(super) is_sign: bool,
}

impl Point {
    /// As it is handed on.
    pub(in crate::lines) fn mark(&self) -> PointMark {
        let Self { at, radius, is_filled, strength, series, is_alone, .. } = *self;
        PointMark { at, radius, is_filled, series, is_alone, strength }
    }
}

/// Whether a point is the outline of one of these beside its stroke. Paths say where its middle is; in pixels each may
/// lie within the other.
pub(super) fn is_drawn_twice(point: &Point, points: &[Point]) -> bool {
    let is_same = |other: &Point| {
        let apart = if point.is_exact && other.is_exact { MIDDLE } else { 1.0 };
        (other.at - point.at).length() <= apart * other.radius.max(point.radius)
    };
    points.iter().any(is_same)
}

/// Whether two points look alike.
pub(super) fn is_like(point: &Point, other: &Point) -> bool {
    point.mark().is_like(&other.mark())
}

/// Radius of the ring that stands for a hollow sign, mm: fingers tell it from a disc by its size too, and its hole is
/// as wide as its stroke. Chosen by us.
pub(super) fn ring_radius(params: &Params) -> f32 {
    1.5 * params.width_max
}

/// Radius of a disc that stands for a point, mm: it is nearly twice as broad as the broadest line, and so is felt
/// beside one; as small as that most points of a plot have room. Chosen by us.
pub(super) fn disc_radius(params: &Params) -> f32 {
    0.5 * (1.0 + SOLID) * params.width_max
}
