//! Two spaces and the one way from the first to the second.
//!
//! *Picture space* is in pixels, x right, y down, pixel centres at +0.5. *Page space* is in millimetres, x right, y
//! down, (0, 0) the sheet's top-left corner. The types keep them apart: a point in pixels does not fit where a point in
//! millimetres is asked for.

use lyon::geom::euclid;

/// Marks a value in pixels of the working picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Px;

/// Marks a value in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Mm;

/// A place in the working picture, in pixels.
pub type PxPoint = euclid::Point2D<f32, Px>;
/// A direction and distance in the working picture, in pixels.
pub type PxVector = euclid::Vector2D<f32, Px>;
/// A place on the sheet, in millimetres.
pub type MmPoint = euclid::Point2D<f32, Mm>;
/// A direction and distance on the sheet, in millimetres.
pub type MmVector = euclid::Vector2D<f32, Mm>;
/// A rectangle on the sheet, in millimetres.
pub type MmRect = euclid::Box2D<f32, Mm>;

/// Width and height in whole pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Size {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
}

impl Size {
    /// A size of `width` by `height` pixels.
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    /// How many pixels there are in all.
    pub const fn area(self) -> u64 {
        self.width as u64 * self.height as u64
    }

    /// Width and height exchanged, as after a quarter turn.
    pub const fn turned(self) -> Self {
        Self::new(self.height, self.width)
    }

    /// [`Size::area`] as a length for a plane in memory.
    pub(crate) const fn len(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} x {}", self.width, self.height)
    }
}
