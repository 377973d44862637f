//! Nine parts of a rectangle, by which places are named.

use lyon::geom::euclid::{Box2D, Point2D};

/// Names of the parts, row by row from the top left.
pub const NAMES: [&str; 9] = [
    "upper left",
    "upper middle",
    "upper right",
    "middle left",
    "middle",
    "middle right",
    "lower left",
    "lower middle",
    "lower right",
];

/// The part with at least half of what all have, if there is one.
pub fn most_of(parts: [f32; 9]) -> Option<usize> {
    let half = 0.5 * parts.iter().sum::<f32>();
    (0..9).find(|&part| half > 0.0 && parts[part] >= half)
}

/// The part of `area` in which a point lies, row by row from the top left; of points outside the nearest.
pub fn ninth<U>(at: Point2D<f32, U>, area: Box2D<f32, U>) -> usize {
    let third = |at: f32, from: f32, length: f32| {
        ((3.0 * (at - from) / length.max(f32::MIN_POSITIVE)).max(0.0) as usize).min(2)
    };
    3 * third(at.y, area.min.y, area.max.y - area.min.y) + third(at.x, area.min.x, area.max.x - area.min.x)
}
