//! The picture's colours, averaged as the eye does and sorted into the five that have a texture.
//!
//! ```text
//! Raster -> shrink -> blur (linear light) -> hue (class of a colour) -> vote -> clean (small areas) -> Classes
//! ```
//!
//! All of it is done on cells of about a millimetre: a texture cannot show finer detail.

mod clean;
mod hue;

use crate::raster::Raster;
use crate::raster::plane::{Plane, shrink};
use crate::units::Size;

/// A colour that has a texture. White has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Blue, cyan and indigo.
    Blue,
    /// Green and olive.
    Green,
    /// Yellow and light orange.
    Yellow,
    /// Red, pink, magenta and brownish red.
    Red,
    /// Black, greys and weakly saturated colours.
    Grey,
}

impl Class {
    /// All five, in the order in which they are written.
    pub const ALL: [Self; 5] = [Self::Blue, Self::Green, Self::Yellow, Self::Red, Self::Grey];

    /// Its name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Blue => "blue",
            Self::Green => "green",
            Self::Yellow => "yellow",
            Self::Red => "red",
            Self::Grey => "grey",
        }
    }
}

/// How colours are sorted. Lengths are in pixels of the working picture, areas in square pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Side of a cell, px; at least 1.
    pub cell: f32,
    /// Sigma of the blur, px.
    pub blur: f32,
    /// Colours less saturated than this (HSV, 0..=1) are grey.
    pub min_saturation: f32,
    /// Colours darker than this (HSV value, 0..=1) are grey.
    pub min_value: f32,
    /// Colours lighter than this (HSL lightness, 0..=1) are white: no texture.
    pub white_from: f32,
    /// An area smaller than this joins the neighbour that surrounds it most, px^2.
    pub min_area: f32,
}

/// The picture in classes, on a grid of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Classes {
    /// Cells from left to right and from top to bottom.
    pub size: Size,
    /// For each cell the number of its region in `regions`, or `None` where the picture is white.
    pub region: Vec<Option<u32>>,
    /// The connected areas of one class, in reading order of their first cell.
    pub regions: Vec<Region>,
    /// HSL lightness (max + min) / 2 of the blurred colour, 0..=1: what decides how bold a texture is.
    pub lightness: Plane,
}

/// A connected area of one class.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Region {
    /// Its colour.
    pub class: Class,
    /// How many cells it has.
    pub cells: u32,
}

impl Classes {
    /// Share of the picture that each class takes, 0..=1, in the order of [`Class::ALL`]; what is left is white.
    pub fn shares(&self) -> [f32; 5] {
        Class::ALL.map(|class| {
            let cells: u32 =
                self.regions.iter().filter(|region| region.class == class).map(|region| region.cells).sum();
            cells as f32 / self.size.area() as f32
        })
    }
}

/// Sorts the colours of a picture.
pub fn sort(raster: &Raster, params: &Params) -> Classes {
    let cells = |pixels: u32| ((pixels as f32 / params.cell.max(1.0)).round() as u32).clamp(1, pixels);
    let from = raster.size();
    let size = Size::new(cells(from.width), cells(from.height));
    let cells_per_px = (size.area() as f32 / from.area() as f32).sqrt();
    let sigma = params.blur * cells_per_px;
    let planes: Vec<Plane> = raster.planes().iter().map(|plane| shrink(plane, from, size).blurred(sigma)).collect();
    let (labels, lightness) = hue::classify(&planes, params);
    let labels = if labels.iter().all(|label| *label == labels[0]) { labels } else { clean::vote(labels, size, sigma) };
    let min_cells = params.min_area * cells_per_px * cells_per_px;
    let labels = clean::clean(labels, size, min_cells);
    let (region, regions) = clean::regions(&labels, size);
    Classes { size, region, regions, lightness }
}
