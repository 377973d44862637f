//! A page as a PNG picture of its true size: the SVG rendered by resvg, in pure black and white or with smooth edges.
//!
//! A pixel says how large it is (chunk pHYs), so that a program that prints at the picture's own size prints true
//! millimetres. The sheet is rendered in bands, so that a fine picture of a large sheet does not fill the memory.

use std::io::{self, Write};
use std::sync::Arc;

use png::{BitDepth, Filter};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg;
use resvg::usvg::fontdb::Database;

use super::png_file::{self, PngFile};
use super::svg;
use super::text::origin_lines;
use crate::error::{self, Error};
use crate::page::Page;
use crate::units::Size;

/// Pixels of one inch of the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dpi(u32);

impl Dpi {
    /// Coarsest: a pixel is half a millimetre, two thirds of the thinnest line of the built-in profiles. Below that,
    /// lines would come and go with the grid.
    pub const LEAST: u32 = 50;
    /// Finest: the finest that laser printers draw.
    pub const MOST: u32 = 1200;

    /// So many.
    ///
    /// # Errors
    /// [`Error::NoSuchDpi`] outside of [`Dpi::LEAST`]..=[`Dpi::MOST`].
    pub fn new(dpi: u32) -> Result<Self, Error> {
        let (least, most) = (Self::LEAST, Self::MOST);
        (least..=most).contains(&dpi).then_some(Self(dpi)).ok_or(Error::NoSuchDpi { dpi, least, most })
    }

    /// How many.
    pub fn get(self) -> u32 {
        self.0
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
    /// Black or white, one bit: black where ink covers at least half of the pixel. Printers then have nothing to
    /// screen.
    #[default]
    Bilevel,
    /// One of 256 greys, so that edges look smooth on a display.
    Grey,
}

impl Depth {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Bilevel, Self::Grey];

    /// Its name: "bilevel" or "grey".
    pub fn name(self) -> &'static str {
        match self {
            Self::Bilevel => "bilevel",
            Self::Grey => "grey",
        }
    }

    /// The one of this name.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "depth of a picture", Self::ALL, Self::name)
    }
}

/// Largest picture, in millions of pixels: A3 at the finest is 278.
const MOST_MEGAPIXELS: u64 = 400;
/// Pixels of a band, at 4 bytes each while it is rendered: an A4 sheet at 300 dpi is one band.
const BAND: u32 = 16 << 20;
/// Of zlib-rs, 1..=9. Measured on pages of photographs: files are 14 % smaller than at 3, and rendering takes most of
/// the time.
const LEVEL: u8 = 6;

/// The page as a PNG; words in print are left out where there are no fonts. The same page and fonts give the same
/// bytes.
///
/// # Errors
/// [`Error::TooFine`] if that would be more pixels than is sensible; [`Error::TooComplex`] and [`Error::NoMemory`] of a
/// page that cannot be drawn.
pub fn write(page: &Page, dpi: Dpi, depth: Depth, fonts: Arc<Database>) -> Result<Vec<u8>, Error> {
    let [width, height] = page.sheet.map(|side| dpi.pixels(side));
    let size = Size::new(width, height);
    if size.area() > MOST_MEGAPIXELS * 1_000_000 {
        return Err(Error::TooFine { size, dpi: dpi.0, limit_megapixels: MOST_MEGAPIXELS });
    }
    // Heights are greys, which black and white would make all or nothing of.
    // So is print, of which they would make nothing.
    let is_grey = page.medium.has_heights() || !page.print.is_empty();
    let depth = if is_grey { Depth::Grey } else { depth };
    let (bits, filter) = match depth {
        // Bits have nothing in common with the bytes of their neighbours.
        Depth::Bilevel => (BitDepth::One, Filter::NoFilter),
        Depth::Grey => (BitDepth::Eight, Filter::Up),
    };
    let file = PngFile {
        size: [width, height],
        depth: bits,
        filter,
        level: LEVEL,
        per_metre: (f64::from(dpi.0) / 0.0254).round() as u32,
        words: [(&page.title, &page.language), (&page.description, &page.description_language)],
        origin: Some(origin_lines(&page.origin).collect::<Vec<_>>().join("\n")),
    };
    let options = usvg::Options { dpi: dpi.0 as f32, fontdb: fonts, ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(&svg::write(page), &options);
    let tree = tree.map_err(|fault| Error::too_complex("page", fault.to_string()))?;
    file.write(|out| rows(&tree, size, depth, out)).map_err(|_| Error::NoMemory { what: "a picture of the page" })
}

/// Whether these bytes are a PNG as [`write()`] makes it, changed by nobody since.
pub fn is_as_written(bytes: &[u8]) -> bool {
    png_file::is_as_written(bytes)
}

/// Renders the page band by band and writes its rows of pixels. Fails if there is no memory for a band.
fn rows(tree: &usvg::Tree, size: Size, depth: Depth, out: &mut dyn Write) -> io::Result<()> {
    let rows = (BAND / size.width).clamp(1, size.height);
    let mut band = Pixmap::new(size.width, rows).ok_or(io::ErrorKind::OutOfMemory)?;
    let mut packed = Vec::new();
    for top in (0..size.height).step_by(rows as usize) {
        band.fill(Color::WHITE);
        resvg::render(tree, Transform::from_translate(0.0, -(top as f32)), &mut band.as_mut());
        let shown = rows.min(size.height - top) as usize;
        for row in band.data().chunks_exact(4 * size.width as usize).take(shown) {
            // Black on white, so that one channel says it all.
            let grey = row.iter().step_by(4).copied();
            packed.clear();
            match depth {
                Depth::Bilevel => pack(grey, &mut packed),
                Depth::Grey => packed.extend(grey),
            }
            out.write_all(&packed)?;
        }
    }
    Ok(())
}

/// A row of bits, eight a byte, white is 1.
fn pack(grey: impl Iterator<Item = u8>, out: &mut Vec<u8>) {
    for (i, value) in grey.enumerate() {
        if i % 8 == 0 {
            out.push(0);
        }
        if let Some(last) = out.last_mut() {
            *last |= (value >> 7) << (7 - i % 8);
        }
    }
}
