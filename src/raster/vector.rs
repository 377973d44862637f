//! What a vector drawing is painted with, in pixels of the working picture.

use resvg::tiny_skia::{Path, Stroke};

use crate::units::{PxPoint, Size};

/// The paths of a drawing, and where something else is painted.
#[derive(Debug, Clone, Default)]
pub struct VectorDrawing {
    /// Paths in the order in which they are painted; outlines of clip paths are among them.
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
}

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
