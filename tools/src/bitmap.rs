//! Bitmaps of drawings, as people have them: PNG, JPEG as on web pages, and paper that was scanned or photographed.

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

/// How the light lies on a sheet of paper: linear, 1 where it is brightest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// The same everywhere.
    Even,
    /// Falls to this from one side to the other.
    Across(f64),
    /// Falls to this from a place near the middle outwards, with the square of the distance.
    Around(f64),
    /// A hand's shadow of this light, on light that falls across to 0.8; its edge is as wide as this share of the
    /// longer side.
    Shadow(f64, f64),
}

/// What lies between a drawing and its bitmap where it was printed, and scanned or photographed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capture {
    /// How the light lies.
    pub light: Light,
    /// The paper as sRGB.
    pub paper: [u8; 3],
    /// By how much red is more and blue is less than in white light, as shares of both.
    pub cast: f64,
    /// Standard deviation of the noise of a pixel, in code values of 255.
    pub noise: f64,
    /// Quality of the JPEG, 1 to 100.
    pub quality: u8,
    /// Longer side, px.
    pub side: u32,
    /// Of the noise and of where the light comes from.
    pub seed: u64,
}

/// A drawing on paper, as a JPEG.
///
/// # Errors
/// As [`png`].
pub fn captured(svg: &str, capture: &Capture) -> Result<Vec<u8>> {
    let canvas = pixels(svg, capture.side)?;
    let mut rng = Rng::new(capture.seed);
    let lit = lit(capture.light, &mut rng);
    let cast = [1.0 + capture.cast, 1.0, 1.0 - capture.cast].map(|cast| cast / (1.0 + capture.cast.abs()));
    let (width, longer) = (canvas.width() as usize, f64::from(canvas.width().max(canvas.height())));
    let middle = [canvas.width(), canvas.height()].map(|side| 0.5 * f64::from(side));
    let mut rgb = on_white(&canvas);
    for (at, pixel) in rgb.chunks_exact_mut(3).enumerate() {
        let place = [(at % width) as f64 - middle[0], (at / width) as f64 - middle[1]].map(|at| 2.0 * at / longer);
        let light = lit(place);
        let noise = capture.noise * rng.normal();
        for ((value, paper), cast) in pixel.iter_mut().zip(capture.paper).zip(cast) {
            let code = encode(linear(*value) * linear(paper) * cast * light);
            // a camera's colours are a little noisy by themselves
            let noise = noise + 0.3 * capture.noise * rng.normal();
            *value = (255.0 * code + noise).round().clamp(0.0, 255.0) as u8;
        }
    }
    encoded(&rgb, &canvas, capture.quality)
}

/// The light at a place, which goes from -1 to 1 along the longer side.
fn lit(light: Light, rng: &mut Rng) -> impl Fn([f64; 2]) -> f64 + use<> {
    let angle = rng.between(0.0, std::f64::consts::TAU);
    let (along, centre) = ([angle.cos(), angle.sin()], [rng.between(-0.3, 0.3), rng.between(-0.3, 0.3)]);
    let across = move |[x, y]: [f64; 2]| (0.5 + 0.5 * (along[0] * x + along[1] * y)).clamp(0.0, 1.0);
    move |at: [f64; 2]| match light {
        Light::Even => 1.0,
        Light::Across(dark) => 1.0 - (1.0 - dark) * across(at),
        Light::Around(dark) => {
            let square = (at[0] - centre[0]).powi(2) + (at[1] - centre[1]).powi(2);
            1.0 - (1.0 - dark) * (square / 1.5).min(1.0)
        }
        Light::Shadow(dark, edge) => {
            // bent, as a hand is
            let bent = across(at) - 0.5 + 0.08 * (4.0 * (at[1] * along[0] - at[0] * along[1])).sin();
            let inside = (0.5 + bent / edge).clamp(0.0, 1.0);
            let smooth = inside * inside * (3.0 - 2.0 * inside);
            (1.0 - 0.2 * across(at)) * (1.0 - (1.0 - dark) * smooth)
        }
    }
}

/// A code value in linear light.
fn linear(code: u8) -> f64 {
    let value = f64::from(code) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// Linear light as a code value of 1.
fn encode(value: f64) -> f64 {
    if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 }
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

/// A drawing whose longer side has so many pixels.
///
/// # Errors
/// As [`png`].
pub fn pixels(svg: &str, side: u32) -> Result<Pixmap> {
    let tree = resvg::usvg::Tree::from_str(svg, &resvg::usvg::Options::default())?;
    let size = tree.size();
    let scale = side as f32 / size.width().max(size.height());
    let px = |length: f32| (length * scale).round() as u32;
    let mut canvas = Pixmap::new(px(size.width()), px(size.height())).ok_or("the drawing has no size")?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut canvas.as_mut());
    Ok(canvas)
}
