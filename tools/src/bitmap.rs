//! Bitmaps of drawings, as people have them: PNG, and JPEG as on web pages.

use std::error::Error;

use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8, Transform};

type Result<T> = std::result::Result<T, Box<dyn Error + Send + Sync>>;

/// A drawing as a PNG whose longer side has so many pixels.
///
/// # Errors
/// If it is no SVG, or has no size.
pub fn png(svg: &str, side: u32) -> Result<Vec<u8>> {
    Ok(pixels(svg, side)?.encode_png()?)
}

/// The same on white as a JPEG of a quality from 1 to 100, with colour at half resolution.
///
/// # Errors
/// As [`png`].
pub fn jpeg(svg: &str, side: u32, quality: u8) -> Result<Vec<u8>> {
    let canvas = pixels(svg, side)?;
    let on_white = |pixel: &PremultipliedColorU8| {
        let white = 255 - pixel.alpha();
        [pixel.red() + white, pixel.green() + white, pixel.blue() + white]
    };
    let rgb: Vec<u8> = canvas.pixels().iter().flat_map(on_white).collect();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality);
    encoder.set_sampling_factor(SamplingFactor::F_2_2);
    encoder.encode(&rgb, canvas.width().try_into()?, canvas.height().try_into()?, ColorType::Rgb)?;
    Ok(bytes)
}

fn pixels(svg: &str, side: u32) -> Result<Pixmap> {
    let tree = resvg::usvg::Tree::from_str(svg, &resvg::usvg::Options::default())?;
    let size = tree.size();
    let scale = side as f32 / size.width().max(size.height());
    let px = |length: f32| (length * scale).round() as u32;
    let mut canvas = Pixmap::new(px(size.width()), px(size.height())).ok_or("the drawing has no size")?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut canvas.as_mut());
    Ok(canvas)
}
