//! Contours of the picture: where its colour steps, how high the step is, and which points belong together.
//!
//! ```text
//! Raster -> noise (how much)
//!        -> lab (perceptual rows) -> gradient (colour tensor, row by row) -> thin (points between pixels)
//!                 `-> sides (what lies on both sides) ----v                    |
//!                                             flow -> strength                 |
//!   Edges <- meet <- corner <- refine <- bridge <------- keep <- height <- chain
//! ```
//!
//! All colour planes live for a few rows only; from `thin` on there are points, and the time goes with their number.
//!
//! **Strength is the height of the colour step** in units of lightness, the chroma axes of CIELAB counted twice (`lab`),
//! whatever the working resolution and the blur of the edge: black against white is 100, a step that is barely worth a line
//! about 10. A grey step of N of 255 code values is N / 2.55.

mod bands;
mod bridge;
mod chain;
mod corner;
mod flow;
mod gradient;
mod height;
mod keep;
mod lab;
mod meet;
mod noise;
mod path;
mod refine;
mod sides;
mod strength;
mod thin;

use std::ops::Range;

use noise::Noise;
use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

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
    /// Side of the cells in which colours are averaged before those on both sides of an edge are compared, px.
    pub side_cell: f32,
    /// Distance from the edge at which they are compared, px.
    pub side_offset: f32,
}

impl Default for Params {
    /// For a picture looked at in its own pixels, whatever its size on a sheet: to trace and to measure. Cells and offset
    /// are those that scored best on photographs of 481 x 321 pixels.
    fn default() -> Self {
        Self {
            sigma: 1.5,
            low: 3.5,
            high: 5.0,
            min_length: 6.0,
            strength_window: 10.0,
            suppression: 1.0,
            side_cell: 5.0,
            side_offset: 8.0,
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
    fn from_paths(size: Size, paths: &[path::Path]) -> Self {
        let mut edges = Self { size, points: Vec::new(), chains: Vec::new() };
        for path in paths {
            let start = edges.points.len();
            let point = |mark: &path::Mark| EdgePoint { at: mark.at, strength: mark.strength, step: mark.step };
            edges.points.extend(path.marks.iter().map(point));
            if path.closed {
                edges.points.extend(path.marks.first().map(point));
            }
            edges.chains.push(start..edges.points.len());
        }
        edges
    }

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
    let size = raster.size();
    let noise = Noise::of(raster);
    let params = &noise.adapted(params);
    let (mut points, sides) = bands::walk(raster, &noise.weights, params);
    if points.is_empty() {
        return Edges { size, points: Vec::new(), chains: Vec::new() };
    }
    let chains = chain::link(&points, size, params.min_length);
    height::even_out(&mut points, &chains, params.strength_window.round() as usize, params.sigma);
    let sides = sides.finish(&points, &chains, noise.pretended(params.sigma));
    let kept = keep::keep(&points, &chains, raster, &sides, noise.pixel, params);
    let mut paths = bridge::join(kept, params.sigma);
    paths.par_iter_mut().for_each(|path| {
        refine::refine(path, params.sigma);
        corner::sharpen(path);
    });
    meet::lead_on(&mut paths, size);
    Edges::from_paths(size, &paths)
}
