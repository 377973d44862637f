//! Pixels of a JPEG through the C library libjpeg-turbo, for those who build with the feature `turbojpeg`.

use turbojpeg::{Decompressor, Image, PixelFormat, ScalingFactor};

use crate::raster::decode::colour::Kind;
use crate::units::Size;

/// The pixels at so many eighths of their size, which is `size`. `None` for pictures of inks and for whatever the library
/// finds wrong: jpeg-decoder then tells what it is, or reads the picture all the same.
pub(super) fn pixels(bytes: &[u8], kind: Kind, eighths: u32, size: Size) -> Option<Vec<u8>> {
    let (format, channels) = match kind {
        Kind::Grey => (PixelFormat::GRAY, 1),
        Kind::Rgb => (PixelFormat::RGB, 3),
        Kind::Cmyk => return None,
    };
    let (width, height) = (size.width as usize, size.height as usize);
    let pitch = channels * width;
    let mut pixels = vec![0; pitch * height];
    let mut decompressor = Decompressor::new().ok()?;
    decompressor.read_header(bytes).ok()?;
    decompressor.set_scaling_factor(ScalingFactor::new(eighths as usize, 8)).ok()?;
    decompressor.decompress(bytes, Image { pixels: &mut pixels[..], width, pitch, height, format }).ok()?;
    Some(pixels)
}
