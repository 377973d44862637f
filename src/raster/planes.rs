//! A picture as planes of linear light.

use crate::units::Size;

/// A picture in linear light: one plane (grey) or three (red, green, blue with the primaries of sRGB), each of
/// `width * height` values 0..=1, rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    size: Size,
    planes: Vec<Vec<f32>>,
}

impl Raster {
    /// A grey picture.
    ///
    /// # Panics
    /// If the plane's length is not that of `size`.
    pub fn grey(size: Size, plane: Vec<f32>) -> Self {
        assert_eq!(plane.len(), size.len(), "plane and size disagree");
        Self { size, planes: vec![plane] }
    }

    /// A colour picture from its red, green and blue planes.
    ///
    /// # Panics
    /// If a plane's length is not that of `size`.
    pub fn colour(size: Size, planes: [Vec<f32>; 3]) -> Self {
        assert!(planes.iter().all(|plane| plane.len() == size.len()), "planes and size disagree");
        Self { size, planes: planes.into() }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> Size {
        self.size
    }

    /// One plane for a grey picture, three (red, green, blue) for a colour picture.
    pub fn planes(&self) -> &[Vec<f32>] {
        &self.planes
    }

    /// Whether there is but one plane.
    pub fn is_grey(&self) -> bool {
        self.planes.len() == 1
    }

    /// Whether all pixels are of one colour.
    pub fn is_flat(&self) -> bool {
        self.planes.iter().all(|plane| plane.iter().all(|value| value.to_bits() == plane[0].to_bits()))
    }
}
