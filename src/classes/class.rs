//! What the colours are sorted into, and by which numbers.

use crate::error::{self, Error};
use crate::raster::plane::Plane;
use crate::units::Size;

/// A colour that has a texture. White has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Blue, cyan and bluish violet.
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
    pub const ALL: [Self; Self::COUNT] = [Self::Blue, Self::Green, Self::Yellow, Self::Red, Self::Grey];

    /// How many there are: what has a value for each class is an array of this length.
    pub(crate) const COUNT: usize = 5;

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

    /// The class of this name in lower case.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "class of colours", Self::ALL, Self::name)
    }
}

/// How colours are sorted. Lengths are in pixels of the working picture, areas in square pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Side of a cell, px; at least 1.
    pub cell: f32,
    /// Sigma of the blur, px.
    pub blur: f32,
    /// Pixels nearer to a contour than this hardly count for the colour of an area, px.
    pub beside: f32,
    /// Sigma of the smoothing of the boundaries between areas, px.
    pub smoothing: f32,
    /// Colours less saturated than this (HSV, 0..=1) are grey; of dark colours more is asked, of light ones less.
    pub min_saturation: f32,
    /// Colours darker than this (HSV value, 0..=1) are grey.
    pub min_value: f32,
    /// Colours lighter than this (HSL lightness, 0..=1) are white: no texture.
    pub white_from: f32,
    /// An area smaller than this joins the neighbour that suits it best, px^2.
    pub min_area: f32,
    /// Whether to look for the parts of areas that lean to a neighbouring class.
    pub fringe: bool,
}

#[cfg(test)]
impl Params {
    /// The numbers of `swell-a4`, one pixel a cell, and no spatial work at all.
    pub(super) const TEST: Self = Self {
        cell: 1.0,
        blur: 0.0,
        beside: 0.0,
        smoothing: 0.0,
        min_saturation: 0.2,
        min_value: 0.15,
        white_from: 0.92,
        min_area: 0.0,
        fringe: false,
    };
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
    /// For each cell the neighbouring class that its part of the region leans to; empty unless asked for
    /// ([`Params::fringe`]).
    pub fringe: Vec<Option<Class>>,
}

/// A connected area of one class.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Region {
    /// Its class.
    pub class: Class,
    /// Its mean colour (averaged in linear light) as sRGB red, green and blue.
    pub colour: [u8; 3],
    /// How many cells it has.
    pub cells: u32,
}

#[cfg(test)]
impl Classes {
    /// For tests of textures: the cells of a square of `side` by `side`, each in the area of the nearest of some seats
    /// (in cells). A seat has a class by its number in [`Class::ALL`]; beyond that it is blank.
    pub(crate) fn of_seats(seats: &[(f32, f32, u8)], side: u32, lightness: f32) -> Self {
        let size = Size::new(side, side);
        let nearest = |i: u32| {
            let (x, y) = ((i % side) as f32 + 0.5, (i / side) as f32 + 0.5);
            let far = |seat: &(f32, f32, u8)| (seat.0 - x).hypot(seat.1 - y);
            (0..seats.len()).min_by(|a, b| far(&seats[*a]).total_cmp(&far(&seats[*b]))).unwrap_or(0)
        };
        let owners: Vec<usize> = (0..side * side).map(nearest).collect();
        let with_texture: Vec<usize> =
            (0..seats.len()).filter(|&seat| usize::from(seats[seat].2) < Class::COUNT).collect();
        let number = |seat: usize| with_texture.iter().position(|other| *other == seat).map(|number| number as u32);
        let of = |seat: &usize| Region {
            class: Class::ALL[usize::from(seats[*seat].2)],
            colour: [0; 3],
            cells: owners.iter().filter(|owner| *owner == seat).count() as u32,
        };
        Self {
            size,
            region: owners.iter().map(|&seat| number(seat)).collect(),
            regions: with_texture.iter().map(of).collect(),
            lightness: Plane::filled(size, lightness),
            fringe: Vec::new(),
        }
    }
}
