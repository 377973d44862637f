//! Which contours may be the head of an arrow, by their form alone; and the measures of those that are drawn.

use crate::geom::polygon::area;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::geom::simplify::simplify;
use crate::lines::vertex::{FoundIn, Tip, Vertex};
use crate::units::{MmPoint, MmRect, MmVector};

/// The longest side of a head in the drawing, mm: a larger triangle is a shape by itself.
const LARGEST: f32 = 12.0;
/// The shortest side of a head in the drawing, mm: two or three pixels.
const SMALLEST: f32 = 0.6;
/// How far a triangle or a leg may be off its straight sides, as a share of its size.
const OFF_SIDES: f32 = 0.15;
/// How far the hull of a triangle may be off its straight sides, as a share of its size.
const OFF_HULL: f32 = 0.08;
/// How much of a triangle is inside its three corners at least, as a share: of a circle it is 0.41, of a square a half.
const LEAST_INSIDE: f32 = 0.75;
/// How much of the triangle around it a head with a notch fills at least.
const NOTCHED: f32 = 0.35;
/// An open contour is a triangle if it is at least this share of the way around: a shaft may interrupt its base.
const AROUND: f32 = 0.75;
/// The same of one that lacks a side, as another line runs there: the two others of a slim head.
const WITHOUT_SIDE: f32 = 0.58;
/// The two sides of a head differ by at most this share.
const ALIKE: f32 = 0.65;
/// Half the width of a head, as a share of its length.
const WIDTHS: std::ops::RangeInclusive<f32> = 0.2..=1.5;

/// Angle between each stroke of a head and its shaft, degrees: an open head.
pub(super) const SPREAD: f32 = 35.0;
/// Lengths of its strokes, mm, the first that has room: together as wide as a fingertip (8 mm), or a little less.
pub(super) const LENGTHS: [f32; 3] = [7.0, 6.0, 5.0];

/// One end of a line.
pub(super) fn end(line: &Polyline<Vertex>, which: Tip) -> Option<MmPoint> {
    which.of(line).map(|vertex| vertex.at)
}

/// A corner that may be the tip of a head, and the two others.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeadTip {
    pub(super) apex: MmPoint,
    pub(super) wings: [MmPoint; 2],
    /// The side that its contour lacks, from one of its ends to the other: another line has to run there.
    pub(super) lacks: Option<[MmPoint; 2]>,
}

impl HeadTip {
    /// A tip whose two sides are alike.
    pub(super) fn of(apex: MmPoint, wings: [MmPoint; 2]) -> Option<Self> {
        let tip = Self { apex, wings, lacks: None };
        let [one, other] = wings.map(|wing| (wing - apex).length());
        let (half, length) = (0.5 * (wings[1] - wings[0]).length(), tip.axis().length());
        let is_head = one.min(other) >= ALIKE * one.max(other) && WIDTHS.contains(&(half / length.max(f32::EPSILON)));
        (is_head && (SMALLEST..=LARGEST).contains(&one.max(other))).then_some(tip)
    }

    /// The middle between its two other corners.
    pub(super) fn base(&self) -> MmPoint {
        self.wings[0].lerp(self.wings[1], 0.5)
    }

    /// From there to the tip.
    pub(super) fn axis(&self) -> MmVector {
        self.apex - self.base()
    }

    pub(super) fn half_width(&self) -> f32 {
        0.5 * (self.wings[1] - self.wings[0]).length()
    }
}

/// The corners of a contour that may be tips of a head.
pub(super) fn tips(contour: &Polyline<Vertex>) -> Vec<HeadTip> {
    if let [tip, one, other] = contour.vertices[..]
        && tip.source == FoundIn::Head
    {
        return HeadTip::of(tip.at, [one.at, other.at]).into_iter().collect();
    }
    let points: Vec<MmPoint> = contour.vertices.iter().map(|vertex| vertex.at).collect();
    let extent = MmRect::from_points(&points);
    let size = extent.width().max(extent.height());
    // an open head is wider than its sides are long
    if points.len() < 3 || !(SMALLEST..=1.5 * LARGEST).contains(&size) {
        return Vec::new();
    }
    let around = hull(&points);
    let length = PolylineRef { vertices: &around, closed: true }.length();
    let fills = area(&points) >= NOTCHED * area(&around);
    if contour.closed || contour.length() >= AROUND * length && fills {
        return if fills { tips_of_outline(&points, contour.closed, size) } else { Vec::new() };
    }
    let corners = simplify(PolylineRef { vertices: &points, closed: false }, OFF_SIDES * size);
    let mut tips: Vec<HeadTip> = match corners[..] {
        [a, b, c] => HeadTip::of(points[b], [points[a], points[c]]).into_iter().collect(),
        _ => Vec::new(),
    };
    // a side of a head that lies along the box at which it points is one with the line of that
    if fills && contour.length() >= WITHOUT_SIDE * length {
        let lacks = points.first().zip(points.last()).map(|(first, last)| [*first, *last]);
        tips.extend(tips_of_outline(&points, false, size).into_iter().map(|tip| HeadTip { lacks, ..tip }));
    }
    tips
}

/// The corners of a contour around a triangle that may be tips of a head.
fn tips_of_outline(points: &[MmPoint], closed: bool, size: f32) -> Vec<HeadTip> {
    let tolerance = OFF_HULL * size;
    let count = points.len();
    let whole = corners_of_hull(&hull(points), tolerance);
    let corners = if closed || count < 5 {
        whole
    } else {
        // an end was moved aside, onto the line that covers what is lacking
        let without_ends = [1..count, 0..count - 1, 1..count - 1];
        whole.or_else(|| without_ends.into_iter().find_map(|part| corners_of_hull(&hull(&points[part]), tolerance)))
    };
    let Some([a, b, c]) = corners else { return Vec::new() };
    let tips = [(a, [b, c]), (b, [c, a]), (c, [a, b])].into_iter();
    tips.filter_map(|(apex, wings)| HeadTip::of(apex, wings)).collect()
}

/// Whether a contour may be one of the two strokes of a head.
pub(super) fn is_leg(contour: &Polyline<Vertex>) -> bool {
    let (Some(first), Some(last)) = (contour.vertices.first(), contour.vertices.last()) else { return false };
    let (chord, length) = ((last.at - first.at).length(), contour.length());
    !contour.closed && (SMALLEST..=LARGEST).contains(&length) && chord >= (1.0 - OFF_SIDES) * length
}

/// Whether a ring of this size has three corners.
pub fn is_triangle(ring: &[MmPoint], size: f32) -> bool {
    let corners = simplify(PolylineRef { vertices: ring, closed: true }, OFF_SIDES * size);
    let [a, b, c] = corners[..] else { return false };
    // a circle of three corners has more outside of them: most of a triangle is inside
    area(&[ring[a], ring[b], ring[c]]) >= LEAST_INSIDE * area(ring)
}

/// The corners of a convex hull that has three, but for a tolerance.
fn corners_of_hull(hull: &[MmPoint], tolerance: f32) -> Option<[MmPoint; 3]> {
    // what is farthest from any place is a corner
    let far = |i: &usize| (hull[*i] - hull[0]).square_length();
    let start = (0..hull.len()).max_by(|a, b| far(a).total_cmp(&far(b)))?;
    let path: Vec<MmPoint> = (0..=hull.len()).map(|i| hull[(start + i) % hull.len()]).collect();
    let corners = simplify(PolylineRef { vertices: &path, closed: false }, tolerance);
    let [a, b, c, _] = corners[..] else { return None };
    let corners = [path[a], path[b], path[c]];
    (area(&corners) >= LEAST_INSIDE * area(hull)).then_some(corners)
}

/// The convex hull of points (Andrew 1979).
fn hull(points: &[MmPoint]) -> Vec<MmPoint> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let half = |points: &mut dyn Iterator<Item = &MmPoint>| {
        let mut chain: Vec<MmPoint> = Vec::new();
        for &at in points {
            while let [.., a, b] = chain[..]
                && (b - a).cross(at - a) <= 0.0
            {
                chain.pop();
            }
            chain.push(at);
        }
        chain.pop();
        chain
    };
    let (mut lower, upper) = (half(&mut sorted.iter()), half(&mut sorted.iter().rev()));
    lower.extend(upper);
    lower
}
