//! Pictures, and small changes of them that nobody would see.

use std::error::Error;
use std::sync::Arc;

use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
use resvg::tiny_skia::{Pixmap, Transform};
use tactograph_tools::rng::Rng;

pub(crate) type Fault = Box<dyn Error + Send + Sync>;

/// Longest side of a drawing that is rendered, px.
const LONGEST: f32 = 1200.0;

/// Samples of 0 to 255, three a pixel, kept as fractions so that changes do not add up roundings.
#[derive(Debug, Clone)]
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) rgb: Vec<f32>,
}

/// A change of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Change {
    /// Each sample one step of 65535 up or down, at random.
    Last16,
    /// Each sample one step of 255 up or down, at random.
    Last8,
    /// So far to the right and down, px.
    Shift(f32),
    /// Sides times this.
    Resize(f32),
    /// Written as JPEG of this quality, colour at half resolution, and read again.
    Jpeg(u8),
    /// None of the picture; the figure is so many mm wider.
    Wider(f32),
}

impl Change {
    pub(crate) const ALL: [Self; 9] = [
        Self::Last16,
        Self::Last8,
        Self::Shift(0.1),
        Self::Resize(0.99),
        Self::Resize(1.01),
        Self::Jpeg(95),
        Self::Jpeg(80),
        Self::Jpeg(60),
        Self::Wider(1.0),
    ];

    pub(crate) fn name(self) -> String {
        match self {
            Self::Last16 => "1/65535".to_owned(),
            Self::Last8 => "1/255".to_owned(),
            Self::Shift(px) => format!("{px} px"),
            Self::Resize(times) => format!("{:+.0} % px", 100.0 * (times - 1.0)),
            Self::Jpeg(quality) => format!("JPEG {quality}"),
            Self::Wider(mm) => format!("{mm:+} mm"),
        }
    }

    /// The changed picture.
    pub(crate) fn of(self, picture: &Picture) -> Result<Picture, Fault> {
        let mut rng = Rng::new(5);
        let mut noise = |step: f32| {
            let mut changed = picture.clone();
            for sample in &mut changed.rgb {
                *sample = (*sample + if rng.coin() { step } else { -step }).clamp(0.0, 255.0);
            }
            changed
        };
        Ok(match self {
            Self::Last16 => noise(255.0 / 65535.0),
            Self::Last8 => noise(1.0),
            Self::Shift(by) => picture.sampled(picture.width, picture.height, |x, y| (x - by, y - by)),
            Self::Resize(times) => {
                let side = |side: usize| ((side as f32 * times).round() as usize).max(1);
                let (width, height) = (side(picture.width), side(picture.height));
                let scale = (picture.width as f32 / width as f32, picture.height as f32 / height as f32);
                picture.sampled(width, height, |x, y| (x * scale.0, y * scale.1))
            }
            Self::Jpeg(quality) => picture.through_jpeg(quality)?,
            Self::Wider(_) => picture.clone(),
        })
    }
}

impl Picture {
    /// Opens a PNG, a JPEG or an SVG, which is rendered on white.
    pub(crate) fn open(bytes: &[u8]) -> Result<Self, Fault> {
        let mut canvas = if bytes.starts_with(b"\x89PNG") {
            Pixmap::decode_png(bytes)?
        } else if bytes.starts_with(b"\xff\xd8") {
            return Self::of_jpeg(bytes);
        } else {
            let mut fonts = usvg::fontdb::Database::new();
            fonts.load_system_fonts();
            let options = usvg::Options { fontdb: Arc::new(fonts), ..usvg::Options::default() };
            let tree = usvg::Tree::from_data(bytes, &options)?;
            let scale = LONGEST / tree.size().width().max(tree.size().height());
            let side = |side: f32| (side * scale).round() as u32;
            let mut canvas = Pixmap::new(side(tree.size().width()), side(tree.size().height())).ok_or("no canvas")?;
            resvg::render(&tree, Transform::from_scale(scale, scale), &mut canvas.as_mut());
            canvas
        };
        let rgb = canvas.pixels_mut().iter().flat_map(|pixel| {
            // on white; samples are multiplied by their opacity
            let white = f32::from(255 - pixel.alpha());
            [pixel.red(), pixel.green(), pixel.blue()].map(|sample| f32::from(sample) + white)
        });
        let rgb = rgb.collect();
        Ok(Self { width: canvas.width() as usize, height: canvas.height() as usize, rgb })
    }

    fn of_jpeg(bytes: &[u8]) -> Result<Self, Fault> {
        let mut decoder = jpeg_decoder::Decoder::new(bytes);
        let samples = decoder.decode()?;
        let info = decoder.info().ok_or("a JPEG without a header")?;
        let rgb: Vec<f32> = match info.pixel_format {
            jpeg_decoder::PixelFormat::RGB24 => samples.into_iter().map(f32::from).collect(),
            jpeg_decoder::PixelFormat::L8 => samples.into_iter().flat_map(|grey| [f32::from(grey); 3]).collect(),
            other => return Err(format!("a JPEG of kind {other:?}").into()),
        };
        Ok(Self { width: info.width.into(), height: info.height.into(), rgb })
    }

    /// As PNG of 16 bits, so that no change is lost to rounding that the change itself does not make.
    pub(crate) fn png(&self) -> Result<Vec<u8>, Fault> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, u32::try_from(self.width)?, u32::try_from(self.height)?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Sixteen);
        let samples = self.rgb.iter().flat_map(|sample| ((sample * 257.0).round() as u16).to_be_bytes());
        encoder.write_header()?.write_image_data(&samples.collect::<Vec<_>>())?;
        Ok(bytes)
    }

    fn through_jpeg(&self, quality: u8) -> Result<Self, Fault> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, quality);
        encoder.set_sampling_factor(SamplingFactor::F_2_2);
        let samples: Vec<u8> = self.rgb.iter().map(|sample| sample.round() as u8).collect();
        encoder.encode(&samples, u16::try_from(self.width)?, u16::try_from(self.height)?, ColorType::Rgb)?;
        Self::of_jpeg(&bytes)
    }

    /// Sampled anew; `from` gives where in this picture a point of the new one is, both from the top left corner, px.
    /// Cubic convolution with a = -1/2 (Keys 1981).
    fn sampled(&self, width: usize, height: usize, from: impl Fn(f32, f32) -> (f32, f32)) -> Self {
        let weight = |distance: f32| {
            let d = distance.abs();
            match d {
                ..1.0 => (1.5 * d - 2.5) * d * d + 1.0,
                ..2.0 => ((-0.5 * d + 2.5) * d - 4.0) * d + 2.0,
                _ => 0.0,
            }
        };
        let mut rgb = Vec::with_capacity(width * height * 3);
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let (x, y) = from(x as f32 + 0.5, y as f32 + 0.5);
            let (x, y) = (x - 0.5, y - 0.5);
            let (left, top) = (x.floor() as i64 - 1, y.floor() as i64 - 1);
            let mut sums = [0.0_f32; 3];
            for (row, column) in (top..top + 4).flat_map(|row| (left..left + 4).map(move |column| (row, column))) {
                let w = weight(y - row as f32) * weight(x - column as f32);
                let inside = |at: i64, side: usize| at.clamp(0, side as i64 - 1) as usize;
                let pixel = 3 * (inside(row, self.height) * self.width + inside(column, self.width));
                (0..3).for_each(|i| sums[i] += w * self.rgb[pixel + i]);
            }
            rgb.extend(sums.map(|sum| sum.clamp(0.0, 255.0)));
        }
        Self { width, height, rgb }
    }

    /// Root mean square of what was changed, of 255; none if the sizes differ.
    pub(crate) fn difference(&self, other: &Self) -> Option<f64> {
        let squares = || self.rgb.iter().zip(&other.rgb).map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>();
        let alike = (self.width, self.height) == (other.width, other.height);
        alike.then(|| (squares() / self.rgb.len() as f64).sqrt() / 255.0)
    }
}
