//! The picture's colours, averaged as the eye does and sorted into the five that have a texture.
//!
//! ```text
//! Raster, contours -> blur (linear light, not across contours) -> hue (membership of every cell) -> smooth boundaries
//!   -> clean (small components, undecided components) -> Classes
//! ```
//!
//! Of photographs, `unify` then makes them agree with the outlines that are drawn.
//!
//! All of it is done on cells of about a millimetre: a texture cannot show finer detail.

mod blur;
mod class;
mod clean;
mod hue;
mod unify;

use hue::Membership;

use crate::geom::polyline::Polyline;
use crate::raster::Raster;
use crate::units::{PxPoint, Size};

pub use class::{Class, Classes, Params, Region};
pub use hue::{class_of, leaning};
pub use unify::unify_areas;

/// Sorts the colours of a picture. The blur stops at `contours`, polylines in pixels; without any it is an ordinary
/// one.
pub fn sort(raster: &Raster, contours: &[Polyline<PxPoint>], params: &Params) -> Classes {
    let cells = |pixels: u32| ((pixels as f32 / params.cell.max(1.0)).round() as u32).clamp(1, pixels);
    let from = raster.size();
    let size = Size::new(cells(from.width), cells(from.height));
    let cells_per_px = (size.area() as f32 / from.area() as f32).sqrt();
    let grid = blur::average(raster, contours, size, params.blur * cells_per_px, params.beside);
    let colours: Vec<[f32; 3]> = (0..size.len()).map(|cell| grid.colour(cell)).collect();
    let memberships: Vec<Membership> = if raster.is_grey() {
        colours.iter().map(|rgb| hue::membership_of_grey(rgb[0], params)).collect()
    } else {
        colours.iter().map(|rgb| hue::membership(*rgb, params)).collect()
    };

    let sigma = params.smoothing * cells_per_px;
    let min_cells = params.min_area * cells_per_px * cells_per_px;
    let labels = clean::smooth(&memberships, &grid, sigma);
    let labels = clean::join_small(labels, &memberships, &grid, min_cells);
    let labels = clean::join_undecided(labels, &memberships, &grid, min_cells);
    let (region, regions) = clean::regions(&labels, &grid);
    let lightness = clean::lightness(&colours, &region, &grid);
    let fringe = match params.fringe {
        true => clean::fringe(&colours, &region, &regions, size, sigma, min_cells),
        false => Vec::new(),
    };
    Classes { size, region, regions, lightness, fringe }
}
