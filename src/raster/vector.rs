//! What a vector drawing is painted with, in pixels of the working picture.

use resvg::tiny_skia::{self, Path, PathSegment, Stroke};

use crate::units::{PxPoint, PxVector, Size};

/// The paths of a drawing, and where something else is painted.
#[derive(Debug, Clone, Default)]
pub struct VectorDrawing {
    /// Paths in the order in which they are painted; outlines of clip paths that may cut something off are among them.
    pub paths: Vec<PaintedPath>,
    /// Where contours may be seen that are on no path: pictures inside the drawing, gradients, patterns, masks and
    /// filters.
    pub pixel_areas: Vec<PixelArea>,
}

/// A path and how it is painted.
#[derive(Debug, Clone)]
pub struct PaintedPath {
    /// Its geometry.
    pub path: Path,
    /// Its stroke, widths in pixels; none if it is filled only.
    pub stroke: Option<Stroke>,
    /// Whether the stroke has dashes; the path has no gaps.
    pub dashed: bool,
    /// Whether it is filled with the colour of its stroke.
    pub filled_alike: bool,
    /// The colours of its area and of its stroke, with their opacity; none where that is not painted, or in more than
    /// one colour.
    pub colours: [Option<[u8; 4]>; 2],
}

impl PaintedPath {
    /// One without a stroke.
    pub fn filled(path: Path) -> Self {
        Self { path, stroke: None, dashed: false, filled_alike: false, colours: [None; 2] }
    }

    /// Whether it is nothing but straight strokes, each by itself, such as ticks.
    pub fn is_of_straight_strokes(&self) -> bool {
        let mut sides = 0;
        let is_straight = self.path.segments().all(|segment| {
            sides = if matches!(segment, PathSegment::LineTo(_)) { sides + 1 } else { 0 };
            matches!(segment, PathSegment::MoveTo(_) | PathSegment::LineTo(_)) && sides <= 1
        });
        self.stroke.is_some() && is_straight
    }

    /// Whether it may paint letters, of its own or as a piece of them: not if it is nothing but straight strokes, or
    /// one convex area of one colour, such as a bar or a dot.
    pub fn may_be_letters(&self) -> bool {
        let is_of_one_colour = self.stroke.is_none() || self.filled_alike && !self.dashed;
        !(self.is_of_straight_strokes() || is_of_one_colour && self.is_one_convex_part())
    }

    /// Whether it has one part, whose control points are the corners of a convex polygon.
    fn is_one_convex_part(&self) -> bool {
        let mut corners: Vec<PxPoint> = Vec::new();
        for segment in self.path.segments() {
            let points: &[tiny_skia::Point] = match &segment {
                PathSegment::MoveTo(_) if !corners.is_empty() => return false,
                PathSegment::MoveTo(at) | PathSegment::LineTo(at) => &[*at],
                PathSegment::QuadTo(a, at) => &[*a, *at],
                PathSegment::CubicTo(a, b, at) => &[*a, *b, *at],
                PathSegment::Close => &[],
            };
            corners.extend(points.iter().map(|at| PxPoint::new(at.x, at.y)));
        }
        corners.dedup();
        is_convex(&corners)
    }

    /// The boxes around its parts, each from where its pen is set down to where it is lifted.
    pub fn parts(&self) -> Vec<PixelArea> {
        let mut parts: Vec<PixelArea> = Vec::new();
        let mut pen_is_down = false;
        for segment in self.path.segments() {
            let points = match segment {
                PathSegment::MoveTo(at) => {
                    pen_is_down = false;
                    vec![at]
                }
                PathSegment::LineTo(at) => vec![at],
                PathSegment::QuadTo(a, at) => vec![a, at],
                PathSegment::CubicTo(a, b, at) => vec![a, b, at],
                PathSegment::Close => Vec::new(),
            };
            for at in points {
                let at = PxPoint::new(at.x, at.y);
                match parts.last_mut().filter(|_| pen_is_down) {
                    Some(part) => (part.min, part.max) = (part.min.min(at), part.max.max(at)),
                    None => parts.push(PixelArea { min: at, max: at }),
                }
                pen_is_down = true;
            }
        }
        parts
    }
}

/// Whether the sides of a closed polygon all turn the same way, once around.
fn is_convex(corners: &[PxPoint]) -> bool {
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let sides: Vec<PxVector> = (0..corners.len()).filter_map(|i| (next(i) - corners[i]).try_normalize()).collect();
    let turns = sides.iter().zip(sides.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b));
    let (left, right) = turns.fold((0.0_f32, 0.0_f32), |(left, right), turn| (left.min(turn), right.max(turn)));
    // of one that goes round once, sides point to the right in one stretch
    let to_right: Vec<bool> = sides.iter().filter(|side| side.x.abs() > STRAIGHT_ON).map(|side| side.x > 0.0).collect();
    let changes = to_right.iter().zip(to_right.iter().cycle().skip(1)).filter(|(a, b)| a != b).count();
    left.abs().min(right) <= STRAIGHT_ON && changes <= 2
}

/// Sine of a turn that is none, and of a side's angle to the upright that is none: where pieces of a curve meet, their
/// control points lie on one line but for rounding.
const STRAIGHT_ON: f32 = 1e-3;

/// A text of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnText {
    /// Its letters, without line breaks; empty where they are not known.
    pub string: String,
    /// Top left corner of the box around it.
    pub min: PxPoint,
    /// Bottom right corner of the box around it.
    pub max: PxPoint,
    /// Direction in which it is read, degrees counter-clockwise from left to right.
    pub angle: f32,
    /// Size of its font, px.
    pub size: f32,
    /// Whether it is not painted, as the texts that lie behind a scanned page are not.
    pub hidden: bool,
}

/// A box whose contours are found in the pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelArea {
    /// Its top left corner.
    pub min: PxPoint,
    /// Its bottom right corner.
    pub max: PxPoint,
}

impl PixelArea {
    /// Whether a point lies in it.
    pub fn contains(&self, at: PxPoint) -> bool {
        (self.min.x..=self.max.x).contains(&at.x) && (self.min.y..=self.max.y).contains(&at.y)
    }

    /// Whether it has a part of a picture of this size inside.
    pub fn is_seen(&self, size: Size) -> bool {
        self.min.x < size.width as f32 && self.min.y < size.height as f32 && self.max.x > 0.0 && self.max.y > 0.0
    }
}

#[cfg(test)]
mod tests;
