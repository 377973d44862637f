//! A picture as planes of linear light: one where it is grey, three where it has colour.

use crate::units::Size;

/// One of something for a grey picture, three for a colour picture: red, green and blue, or whatever is made of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Planes<P> {
    /// Of the only plane.
    Grey(P),
    /// Of the three planes.
    Colour([P; 3]),
}

impl<P> Planes<P> {
    /// The same of each plane.
    pub fn map<Q>(self, of: impl FnMut(P) -> Q) -> Planes<Q> {
        let mut of = of;
        match self {
            Self::Grey(grey) => Planes::Grey(of(grey)),
            Self::Colour(colours) => Planes::Colour(colours.map(of)),
        }
    }

    /// [`Planes::map`], side by side where there are cores.
    pub fn par_map<Q: Send>(self, of: impl Fn(P) -> Q + Sync) -> Planes<Q>
    where
        P: Send,
    {
        match self {
            Self::Grey(grey) => Planes::Grey(of(grey)),
            Self::Colour([red, green, blue]) => {
                let (red, (green, blue)) = rayon::join(|| of(red), || rayon::join(|| of(green), || of(blue)));
                Planes::Colour([red, green, blue])
            }
        }
    }

    /// References to each plane.
    pub fn as_ref(&self) -> Planes<&P> {
        match self {
            Self::Grey(grey) => Planes::Grey(grey),
            Self::Colour(colours) => Planes::Colour(colours.each_ref()),
        }
    }

    /// All planes, one or three.
    pub fn as_slice(&self) -> &[P] {
        match self {
            Self::Grey(grey) => std::slice::from_ref(grey),
            Self::Colour(colours) => colours,
        }
    }

    /// All planes, one or three.
    pub fn as_mut_slice(&mut self) -> &mut [P] {
        match self {
            Self::Grey(grey) => std::slice::from_mut(grey),
            Self::Colour(colours) => colours,
        }
    }

    /// Visits each plane.
    pub fn iter(&self) -> std::slice::Iter<'_, P> {
        self.as_slice().iter()
    }
}

impl<P> Planes<Option<P>> {
    /// All planes, if there is none missing.
    pub fn all(self) -> Option<Planes<P>> {
        Some(match self {
            Self::Grey(grey) => Planes::Grey(grey?),
            Self::Colour([red, green, blue]) => Planes::Colour([red?, green?, blue?]),
        })
    }
}

impl<T: Clone> Planes<T> {
    /// Three values, all alike in a grey picture.
    pub fn as_colour(self) -> [T; 3] {
        match self {
            Self::Grey(grey) => [grey.clone(), grey.clone(), grey],
            Self::Colour(colours) => colours,
        }
    }
}

/// A picture in linear light: one plane (grey) or three (red, green, blue with the primaries of sRGB), each of
/// `width * height` values 0..=1, rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    size: Size,
    planes: Planes<Vec<f32>>,
}

impl Raster {
    /// A picture from its planes.
    ///
    /// # Panics
    /// If a plane's length is not that of `size`.
    pub fn new(size: Size, planes: Planes<Vec<f32>>) -> Self {
        assert!(planes.iter().all(|plane| plane.len() == size.len()), "planes and size disagree");
        Self { size, planes }
    }

    /// A grey picture.
    ///
    /// # Panics
    /// If the plane's length is not that of `size`.
    pub fn grey(size: Size, plane: Vec<f32>) -> Self {
        Self::new(size, Planes::Grey(plane))
    }

    /// A colour picture from its red, green and blue planes.
    ///
    /// # Panics
    /// If a plane's length is not that of `size`.
    pub fn colour(size: Size, planes: [Vec<f32>; 3]) -> Self {
        Self::new(size, Planes::Colour(planes))
    }

    /// Width and height in pixels.
    pub fn size(&self) -> Size {
        self.size
    }

    /// One plane for a grey picture, three (red, green, blue) for a colour picture.
    pub fn planes(&self) -> &Planes<Vec<f32>> {
        &self.planes
    }

    /// Whether there is but one plane.
    pub fn is_grey(&self) -> bool {
        matches!(self.planes, Planes::Grey(_))
    }

    /// Whether all pixels are of one colour.
    pub fn is_flat(&self) -> bool {
        // a few at a time: vectors hold several, and most pictures differ soon
        const AT_ONCE: usize = 64;
        let is_one_colour = |plane: &Vec<f32>| {
            let first = plane.first().map_or(0, |first| first.to_bits());
            let differing =
                |values: &[f32]| values.iter().fold(0, |differing, value| differing | (value.to_bits() ^ first));
            plane.chunks(AT_ONCE).all(|values| differing(values) == 0)
        };
        self.planes.iter().all(is_one_colour)
    }
}

#[cfg(test)]
mod tests;
