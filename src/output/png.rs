//! A page as a PNG picture of its true size: the SVG rendered by resvg, in pure black and white or with smooth edges.
//!
//! A pixel says how large it is (chunk pHYs), so that a program that prints at the picture's own size prints true
//! millimetres. The sheet is rendered in bands, so that a fine picture of a large sheet does not fill the memory.

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg;

use super::text::{origin_lines, plain};
use super::{seal, svg, zlib};
use crate::Error;
use crate::page::Page;
use crate::units::Size;

/// Pixels of one inch of the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dpi(u32);

impl Dpi {
    /// Coarsest: a pixel is half a millimetre, two thirds of the thinnest line of the built-in profiles. Below that, lines
    /// would come and go with the grid.
    pub const LEAST: u32 = 50;
    /// Finest: the finest that laser printers draw.
    pub const MOST: u32 = 1200;

    /// None outside [`Dpi::LEAST`]..=[`Dpi::MOST`].
    pub fn new(dpi: u32) -> Option<Self> {
        (Self::LEAST..=Self::MOST).contains(&dpi).then_some(Self(dpi))
    }

    fn pixels(self, mm: f32) -> u32 {
        (f64::from(mm) / 25.4 * f64::from(self.0)).round().max(1.0) as u32
    }
}

impl Default for Dpi {
    /// 300, what most laser printers draw.
    fn default() -> Self {
        Self(300)
    }
}

/// What a pixel can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Depth {
    /// Black or white, one bit: black where ink covers at least half of the pixel. Printers then have nothing to screen.
    #[default]
    Bilevel,
    /// One of 256 greys, so that edges look smooth on a display.
    Grey,
}

/// Largest picture, in millions of pixels: A3 at the finest is 278.
const MOST_MEGAPIXELS: u64 = 400;
/// Pixels of a band, at 4 bytes each while it is rendered: an A4 sheet at 300 dpi is one band.
const BAND: u32 = 16 << 20;
/// Of zlib-rs, 1..=9. Measured on pages of photographs: files are 14 % smaller than at 3, and rendering takes most of the time.
const LEVEL: u32 = 6;

pub(super) const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
/// Keyword of the text that holds the seal.
const SEAL: &[u8] = b"Seal\0";
/// Length, type and checksum of a chunk.
const CHUNK: usize = 12;

/// The page as a PNG. The same page gives the same bytes.
///
/// # Errors
/// [`Error::TooFine`] if that would be more pixels than is sensible.
pub fn write(page: &Page, dpi: Dpi, depth: Depth) -> Result<Vec<u8>, Error> {
    let [width, height] = page.sheet.map(|side| dpi.pixels(side));
    let size = Size::new(width, height);
    let too_fine = || Error::TooFine { size, dpi: dpi.0, limit_megapixels: MOST_MEGAPIXELS };
    if size.area() > MOST_MEGAPIXELS * 1_000_000 {
        return Err(too_fine());
    }
    // Heights are greys, which black and white would make all or nothing of.
    let depth = if page.medium.has_heights() { Depth::Grey } else { depth };
    let mut png = SIGNATURE.to_vec();
    let bits = match depth {
        Depth::Bilevel => 1,
        Depth::Grey => 8,
    };
    let mut header = [size.width.to_be_bytes(), size.height.to_be_bytes()].concat();
    header.extend([bits, 0, 0, 0, 0]); // grey, zlib, filters of rows, not interlaced
    chunk(&mut png, b"IHDR", &header);
    let per_metre = (f64::from(dpi.0) / 0.0254).round() as u32;
    chunk(&mut png, b"pHYs", &[&per_metre.to_be_bytes()[..], &per_metre.to_be_bytes(), &[1]].concat());
    let language = plain(&page.language);
    text(&mut png, "Title", &language, &plain(&page.title));
    text(&mut png, "Description", &language, &plain(&page.description));
    text(&mut png, "Software", "", concat!("tactograph ", env!("CARGO_PKG_VERSION")));
    text(&mut png, "Comment", "", &origin_lines(&page.origin).collect::<Vec<_>>().join("\n"));
    chunk(&mut png, b"IDAT", &pixels(page, size, dpi, depth).ok_or_else(too_fine)?);
    Ok(sealed(png))
}

/// A picture that lacks nothing but its end, with its seal and its end.
pub(super) fn sealed(mut png: Vec<u8>) -> Vec<u8> {
    let seal = seal::of(&png);
    chunk(&mut png, b"tEXt", &[SEAL, seal.as_bytes()].concat());
    chunk(&mut png, b"IEND", &[]);
    png
}

/// Whether these bytes are a PNG as [`write()`] makes it, changed by nobody since.
pub fn is_as_written(bytes: &[u8]) -> bool {
    let end = CHUNK + SEAL.len() + seal::LENGTH + CHUNK;
    let Some((picture, tail)) = bytes.len().checked_sub(end).and_then(|at| bytes.split_at_checked(at)) else {
        return false;
    };
    picture.starts_with(SIGNATURE) && {
        let whole = sealed(picture.to_vec());
        whole.ends_with(tail)
    }
}

/// The rows of pixels, compressed. None if there is no memory for a band.
fn pixels(page: &Page, size: Size, dpi: Dpi, depth: Depth) -> Option<Vec<u8>> {
    let options = usvg::Options { dpi: dpi.0 as f32, ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(&svg::write(page), &options).ok()?;
    let rows = (BAND / size.width).clamp(1, size.height);
    let mut band = Pixmap::new(size.width, rows)?;
    let mut stream = zlib::Stream::new(LEVEL);
    let mut above = vec![0; size.width as usize];
    let mut packed = Vec::new();
    for top in (0..size.height).step_by(rows as usize) {
        band.fill(Color::WHITE);
        resvg::render(&tree, Transform::from_translate(0.0, -(top as f32)), &mut band.as_mut());
        let shown = rows.min(size.height - top) as usize;
        for row in band.data().chunks_exact(4 * size.width as usize).take(shown) {
            // Black on white, so that one channel says it all.
            let grey = row.iter().step_by(4).copied();
            packed.clear();
            match depth {
                Depth::Bilevel => pack(grey, &mut packed),
                Depth::Grey => less_above(grey, &mut above, &mut packed),
            }
            stream.push(&packed);
        }
    }
    Some(stream.finish())
}

/// A row of bits, eight a byte, white is 1; as it is (filter 0): bits have nothing in common with their neighbours' bytes.
fn pack(grey: impl Iterator<Item = u8>, out: &mut Vec<u8>) {
    out.push(0);
    for (i, value) in grey.enumerate() {
        if i % 8 == 0 {
            out.push(0);
        }
        if let Some(last) = out.last_mut() {
            *last |= (value >> 7) << (7 - i % 8);
        }
    }
}

/// A row of greys as what it differs by from the row above (filter 2).
fn less_above(grey: impl Iterator<Item = u8>, above: &mut [u8], out: &mut Vec<u8>) {
    out.push(2);
    for (value, above) in grey.zip(above) {
        out.push(value.wrapping_sub(*above));
        *above = value;
    }
}

/// A text of any language; `text` is in UTF-8, not compressed.
pub(super) fn text(png: &mut Vec<u8>, keyword: &str, language: &str, text: &str) {
    // keyword, compressed?, by what, language, the keyword in that language, text
    chunk(png, b"iTXt", &[keyword.as_bytes(), b"\0\0\0", language.as_bytes(), b"\0\0", text.as_bytes()].concat());
}

pub(super) fn chunk(png: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    png.extend((data.len() as u32).to_be_bytes());
    let start = png.len();
    png.extend(kind);
    png.extend(data);
    let mut sum = flate2::Crc::new();
    sum.update(&png[start..]);
    png.extend(sum.sum().to_be_bytes());
}
