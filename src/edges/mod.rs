//! Edge detection: where the colour of the picture steps, how high the steps are, and which edgels form a contour.
//!
//! ```text
//! Raster -> noise (of a pixel; adapts the parameters)
//!        -> lab (perceptual rows) -> gradient (structure tensor, row by row) -> maxima (ridge points)
//!                 `-> side_statistics (colours on both sides) ----v                  |
//!                                  edge_stopping (filter) -> strength                |
//!   Edges <- junction <- corner <- refine <- bridge <---------- hysteresis <- step_height <- chain
//! ```
//!
//! All colour planes exist for a few rows only. From `maxima` on there are points, and the time grows with their
//! number.
//!
//! **Strength is the height of the colour step** in units of lightness, with double weight for the chroma axes of
//! CIELAB (`lab`), whatever the working resolution and the blur of the edge. Black against white is 100, a step that
//! is barely worth a line about 10. A grey step of N of 255 code values is N / 2.55. Where there is texture, strength
//! is less (`strength`).

mod bands;
mod bridge;
mod chain;
mod contour;
mod corner;
mod drawing;
mod edge_stopping;
mod edgel;
mod gradient;
mod hysteresis;
mod junction;
mod lab;
mod maxima;
mod noise;
mod params;
mod refine;
mod ridge;
mod side_statistics;
mod step_height;
mod strength;

use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

use contour::ContourPoint;
pub use drawing::find_drawn;
pub use edgel::{ChainKind, ChainRange, Edgel, Edges};
use hysteresis::Selection;
use noise::Noise;
pub use params::Params;

use crate::raster::Raster;

/// Finds the contours of a picture.
pub fn find(raster: &Raster, params: &Params) -> Edges {
    let size = raster.size();
    let noise = Noise::of(raster);
    let params = &noise.adapted(params);
    let (mut points, sides) = bands::scan(raster, &noise.weights, params);
    if points.is_empty() {
        return Edges::none(size);
    }
    let chains = chain::link(&points, size, params.min_length);
    step_height::average(&mut points, &chains, params.strength_window.round() as usize, params.sigma);
    let sides = &sides.finish(&points, &chains, noise.height_sigma(params.sigma));
    let selection = Selection { points: &points, raster, sides, noise: noise.pixel, params };
    let mut contours = bridge::join(selection.contours(&chains), params.sigma);
    contours.par_iter_mut().for_each(|contour| {
        refine::refine(contour, params.sigma);
        corner::sharpen(contour);
    });
    junction::extend(&mut contours, size);
    let mut edges = Edges::none(size);
    for contour in &contours {
        let edgel = |&ContourPoint { at, strength, contrast, .. }: &ContourPoint| Edgel { at, strength, contrast };
        edges.push(contour.vertices.iter().map(edgel), contour.closed);
    }
    edges
}
