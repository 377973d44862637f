//! Contours as data: polylines in the pixels of the source picture, whatever size the picture was worked on.
//!
//! Points are in *source space*: pixels of the upright source picture (after the turn that EXIF asks for), x right, y
//! down, pixel centres at +0.5; for an SVG drawing, its own CSS pixels. **Strength is the height of the colour step** in
//! CIELAB units with the chroma axes counted twice (see [`crate::edges`]): black against white is 100.

use crate::edges::Edges;
use crate::units::{PxPoint, Size};

/// The contours of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Size of the upright source picture, px.
    pub size: Size,
    /// The contours, none of them without points.
    pub polylines: Vec<Polyline>,
}

/// One contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    /// Whether the last point goes on to the first. The first point is not repeated.
    pub closed: bool,
    /// Its points, in pixels of the source picture.
    pub points: Vec<PxPoint>,
    /// Height of the colour step at each point (see the module).
    pub strength: Vec<f32>,
    /// For a line of the page, its width in mm from each point to the next; the last point of an open line has that of the
    /// piece before it.
    pub width: Option<Vec<f32>>,
}

impl Trace {
    /// The contours as they were found in a working picture of the source picture of size `source`.
    pub fn of_edges(edges: &Edges, source: Size) -> Self {
        let scale = Scale::new(edges.size, source);
        let polylines = edges.chains().map(|chain| {
            let closed = chain.len() > 3 && chain.first().map(|p| p.at) == chain.last().map(|p| p.at);
            let chain = &chain[..chain.len() - usize::from(closed)];
            Polyline {
                closed,
                points: chain.iter().map(|point| scale.to_source(point.at)).collect(),
                strength: chain.iter().map(|point| point.strength).collect(),
                width: None,
            }
        });
        Self { size: source, polylines: polylines.collect() }
    }
}

/// The way from the working picture to the source picture. Both sides have a scale of their own, as each is rounded to
/// whole pixels.
struct Scale {
    across: f64,
    down: f64,
}

impl Scale {
    fn new(working: Size, source: Size) -> Self {
        let scale = |source: u32, working: u32| f64::from(source) / f64::from(working.max(1));
        Self { across: scale(source.width, working.width), down: scale(source.height, working.height) }
    }

    fn to_source(&self, at: PxPoint) -> PxPoint {
        PxPoint::new((f64::from(at.x) * self.across) as f32, (f64::from(at.y) * self.down) as f32)
    }
}
