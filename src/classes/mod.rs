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
use crate::raster::plane::Plane;
use crate::units::{PxPoint, Size};

pub use class::{Class, Classes, Params, Region};
pub use hue::{class_at, class_of, leaning};
pub use unify::unify_areas;

/// Sorts the colours of a picture. The blur stops at `contours`, polylines in pixels; without any it is an ordinary
/// one.
pub fn sort(raster: &Raster, contours: &[Polyline<PxPoint>], params: &Params) -> Classes {
    let [classes] = sort_for(raster, contours, params, [params.min_area]);
    classes
}

/// [`sort`] for several least areas, px2, in place of that of the parameters: most of the work is the same for all.
pub fn sort_for<const N: usize>(
    raster: &Raster,
    contours: &[Polyline<PxPoint>],
    params: &Params,
    min_areas: [f32; N],
) -> [Classes; N] {
    let cells = |pixels: u32| ((pixels as f32 / params.cell.max(1.0)).round() as u32).clamp(1, pixels);
    let from = raster.size();
    let size = Size::new(cells(from.width), cells(from.height));
    if contours.is_empty() && size.len() > 1 && raster.is_flat() {
        return min_areas.map(|_| of_one_colour(raster, size, params));
    }
    let cells_per_px = (size.area() as f32 / from.area() as f32).sqrt();
    let grid = blur::average(raster, contours, size, params.blur * cells_per_px, params.beside);
    let colours: Vec<[f32; 3]> = (0..size.len()).map(|cell| grid.colour(cell)).collect();
    let memberships: Vec<Membership> = if raster.is_grey() {
        colours.iter().map(|rgb| hue::membership_of_grey(rgb[0], params)).collect()
    } else {
        colours.iter().map(|rgb| hue::membership(*rgb, params)).collect()
    };

    let sigma = params.smoothing * cells_per_px;
    let smooth = clean::smooth(&memberships, &grid, sigma);
    min_areas.map(|min_area| {
        let min_cells = min_area * cells_per_px * cells_per_px;
        let labels = clean::join_small(smooth.clone(), &memberships, &grid, min_cells);
        let labels = clean::join_undecided(labels, &memberships, &grid, min_cells);
        let (region, regions) = clean::regions(&labels, &grid);
        let lightness = clean::lightness(&colours, &region, &grid);
        let fringe = match params.fringe {
            true => clean::fringe(&colours, &region, &regions, size, sigma, min_cells),
            false => Vec::new(),
        };
        Classes { size, region, regions, lightness, fringe }
    })
}

/// A picture of one colour: as one cell has it, so have all.
fn of_one_colour(raster: &Raster, size: Size, params: &Params) -> Classes {
    let pixel = Raster::new(Size::new(1, 1), raster.planes().as_ref().map(|plane| vec![plane[0]]));
    let of_pixel = sort(&pixel, &[], &Params { min_area: 0.0, ..*params });
    let regions = of_pixel.regions.into_iter().map(|region| Region { cells: size.len() as u32, ..region });
    Classes {
        size,
        region: vec![of_pixel.region[0]; size.len()],
        regions: regions.collect(),
        lightness: Plane::filled(size, of_pixel.lightness.values[0]),
        fringe: of_pixel.fringe.first().map_or_else(Vec::new, |fringe| vec![*fringe; size.len()]),
    }
}

#[cfg(test)]
mod tests;
