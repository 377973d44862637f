//! Contours of the picture: where its colour steps, how high the step is, and which points belong together.
//!
//! ```text
//! Raster -> lab (perceptual planes) -> gradient (colour tensor, row by row) -> thin (points between pixels)
//!                    `-> sides (what lies on both sides) ----------------------> keep
//!                                                            thin -> chain ---^    `-> Edges
//! ```
//!
//! **Strength is the height of the colour step** in CIELAB units with the chroma axes counted twice (`lab`), whatever the
//! working resolution and the blur of the edge: black against white is 100, a step that is barely worth a line about 10.

mod chain;
mod gradient;
mod keep;
mod lab;
mod sides;
mod thin;

use std::ops::Range;

use crate::raster::Raster;
use crate::units::{PxPoint, Size};

/// How to look for edges. Lengths are in pixels of the working picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Scale: sigma of the Gaussian whose derivatives are taken, px.
    pub sigma: f32,
    /// A contour goes on as long as its step is at least this high.
    pub low: f32,
    /// A contour is kept if its step is at least this high somewhere.
    pub high: f32,
    /// A contour shorter than this is dropped, px.
    pub min_length: f32,
    /// Strength is averaged along a contour over this far to both sides, px, so that one weak point does not cut it.
    pub strength_window: f32,
    /// How far texture lowers the strength of the edges inside it: 0 not at all, 1 fully.
    pub suppression: f32,
    /// Sigma of the windows on both sides of an edge whose colours are compared, px.
    pub side_sigma: f32,
    /// Distance of these windows from the edge, px.
    pub side_offset: f32,
}

impl Default for Params {
    /// For a picture looked at in its own pixels, whatever its size on a sheet: to trace and to measure. The windows are
    /// those that scored best on photographs of 481 x 321 pixels.
    fn default() -> Self {
        Self {
            sigma: 1.5,
            low: 3.0,
            high: 6.0,
            min_length: 6.0,
            strength_window: 3.0,
            suppression: 1.0,
            side_sigma: 3.0,
            side_offset: 6.0,
        }
    }
}

/// A point of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Where, in pixels of the working picture.
    pub at: PxPoint,
    /// Height of the colour step here (see the module).
    pub strength: f32,
    /// Colour on the right of the chain less the colour on its left (L, 2a, 2b); two sides of a bar have opposite steps.
    pub step: [f32; 3],
}

/// Contours as chains of points. A chain is closed iff its last point is its first again.
#[derive(Debug, Clone, PartialEq)]
pub struct Edges {
    /// Size of the picture they were found in.
    pub size: Size,
    /// All points, chain after chain.
    pub points: Vec<EdgePoint>,
    /// Which points form which chain.
    pub chains: Vec<Range<usize>>,
}

impl Edges {
    /// The chains one by one.
    pub fn chains(&self) -> impl Iterator<Item = &[EdgePoint]> {
        self.chains.iter().map(|range| &self.points[range.clone()])
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.chains.is_empty()
    }
}

/// Finds the contours of a picture.
pub fn find(raster: &Raster, params: &Params) -> Edges {
    let lab = lab::planes(raster);
    let mut thinner = thin::Thinner::new(raster.size(), params);
    let mut sides = sides::Builder::new(raster.size(), params);
    gradient::each_row(&lab, raster.size(), params.sigma, |tensor| {
        thinner.push(tensor);
        sides.push(tensor);
    });
    let points = thinner.finish();
    if points.is_empty() {
        return Edges { size: raster.size(), points: Vec::new(), chains: Vec::new() };
    }
    let sides = sides.finish(&lab);
    let chains = chain::link(&points, raster.size());
    keep::keep(&points, &chains, &lab, &sides, raster.size(), params)
}
