//! A picture as it is given to the library: the bytes of a file, or pixels.

use crate::Error;
use crate::units::Size;

/// A picture to convert: the bytes of a file, or pixels that a program has in memory. It borrows them and copies
/// nothing.
///
/// ```
/// use tactograph::Picture;
///
/// let file = std::fs::read("samples/coffee.png")?;
/// let of_a_file = Picture::from(&file);
/// let pixels = [255; 4 * 16 * 9]; // white
/// let of_pixels = Picture::rgba8(16, 9, &pixels)?;
/// # let _ = (of_a_file, of_pixels);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a>(pub(crate) PixelSource<'a>);

/// Where the pixels are.
#[derive(Debug, Clone, Copy)]
pub(crate) enum PixelSource<'a> {
    /// In a file of any format that is read here.
    File(&'a [u8]),
    /// Here: red, green, blue and opacity, a byte each, row by row; exactly as many as `size` says.
    Rgba8 { size: Size, pixels: &'a [u8] },
}

impl<'a> Picture<'a> {
    /// The bytes of a picture file: JPEG, PNG, WebP, TIFF, BMP, GIF (first frame), PNM, SVG or, with the feature
    /// `pdf`, PDF (see [`Options::page`](crate::Options::page)). The format is told from the bytes. What they
    /// are worth is found out when they are decoded.
    pub fn file(bytes: &'a [u8]) -> Self {
        Self(PixelSource::File(bytes))
    }

    /// Pixels in sRGB, rows from the top, four bytes a pixel: red, green, blue and opacity (0 clear, 255 opaque; not
    /// multiplied into the colours), as a browser's canvas has them. What is not opaque is laid over white.
    ///
    /// # Errors
    /// [`Error::WrongPixels`] unless there are `4 * width * height` bytes, and at least one pixel.
    pub fn rgba8(width: u32, height: u32, pixels: &'a [u8]) -> Result<Self, Error> {
        let size = Size::new(width, height);
        let fits = size.area() > 0 && size.area().checked_mul(4) == Some(pixels.len() as u64);
        if !fits {
            return Err(Error::WrongPixels { size, bytes: pixels.len() });
        }
        Ok(Self(PixelSource::Rgba8 { size, pixels }))
    }
}

impl<'a> From<&'a [u8]> for Picture<'a> {
    fn from(bytes: &'a [u8]) -> Self {
        Self::file(bytes)
    }
}

impl<'a, const N: usize> From<&'a [u8; N]> for Picture<'a> {
    fn from(bytes: &'a [u8; N]) -> Self {
        Self::file(bytes)
    }
}

impl<'a> From<&'a Vec<u8>> for Picture<'a> {
    fn from(bytes: &'a Vec<u8>) -> Self {
        Self::file(bytes)
    }
}

#[cfg(test)]
mod tests;
