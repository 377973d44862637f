//! Bitmaps of drawings, as people have them: PNG, and JPEG as on web pages.

use std::error::Error;

use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8, Transform};

use crate::rng::Rng;

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
    encoded(&on_white(&canvas), &canvas, quality)
}

/// How dark the right side of a scan is, of the light on its left.
const SHADE: f64 = 0.06;
/// Standard deviation of the noise of a scan, in code values of 255.
const NOISE: f64 = 4.0;

/// The same as an old scanner or a telephone gives it: in uneven light, with noise that has a seed, as a JPEG of
/// quality 80.
///
/// # Errors
/// As [`png`].
pub fn scan(svg: &str, side: u32, seed: u64) -> Result<Vec<u8>> {
    let canvas = pixels(svg, side)?;
    let mut rng = Rng::new(seed);
    let mut rgb = on_white(&canvas);
    for (at, pixel) in rgb.chunks_exact_mut(3).enumerate() {
        let across = (at % canvas.width() as usize) as f64 / f64::from(canvas.width());
        let noise = NOISE * rng.normal();
        for value in pixel {
            *value = (f64::from(*value) * (1.0 - SHADE * across) + noise).round().clamp(0.0, 255.0) as u8;
        }
    }
    encoded(&rgb, &canvas, 80)
}

fn on_white(canvas: &Pixmap) -> Vec<u8> {
    let on_white = |pixel: &PremultipliedColorU8| {
        let white = 255 - pixel.alpha();
        [pixel.red() + white, pixel.green() + white, pixel.blue() + white]
    };
    canvas.pixels().iter().flat_map(on_white).collect()
}

fn encoded(rgb: &[u8], canvas: &Pixmap, quality: u8) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality);
    encoder.set_sampling_factor(SamplingFactor::F_2_2);
    encoder.encode(rgb, canvas.width().try_into()?, canvas.height().try_into()?, ColorType::Rgb)?;
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
