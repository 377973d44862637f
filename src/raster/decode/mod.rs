//! Bytes of a picture file become a [`Raster`] at the working size.

//!
//! ```text
//!  bytes -- sniff --> jpeg | png | other | drawing --> rows (colour -> light, over white) --> shrink --> orient
//!                       `- header: Job::begin checks the limits and asks for the working size before anything is decoded
//! ```

mod burden;
mod colour;
mod drawing;
mod jpeg;
mod orient;
mod other;
mod pixels;
mod png;
mod rows;
mod shrink;
mod sniff;

use std::sync::Arc;

use image::metadata::Orientation;

use self::colour::{Kind, Meaning};
pub(crate) use self::drawing::checked_document;
use self::sniff::Format;
use crate::raster::Raster;
use crate::raster::crop::{Crop, Part};
use crate::units::Size;
use crate::{Error, Note, picture};

/// What a picture may cost. A picture over a limit is refused by its header, before anything is decoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Most pixels, in millions.
    pub megapixels: u64,
    /// Most memory for decoding, in megabytes.
    pub memory_mb: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { megapixels: 300, memory_mb: 1024 }
    }
}

/// Where the letters of SVG drawings come from; asked only when a drawing has text.
pub type Fonts<'a> = dyn Fn() -> Arc<usvg::fontdb::Database> + Sync + 'a;

/// What a file's header says of its picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Pixels after the turn that EXIF asks for; for an SVG drawing its size in CSS pixels, rounded. Of the part that is
    /// used, where there is a [`Crop`].
    pub size: Size,
    /// Whether it is a vector drawing, which can be rendered at any size.
    pub is_drawing: bool,
}

/// How to decode.
pub struct Options<'a> {
    /// What the picture may cost.
    pub limits: Limits,
    /// Fonts for drawings.
    pub fonts: &'a Fonts<'a>,
    /// The part of the upright picture that is used; all of it without one.
    pub crop: Option<Crop>,
    /// The working size for a source: never larger than the source unless it is a drawing.
    pub working_size: &'a dyn Fn(Source) -> Result<Size, Error>,
}

/// A decoded picture.
#[derive(Debug, Clone)]
pub struct Picture {
    /// The pixels at working size, upright.
    pub raster: Raster,
    /// What the header said.
    pub source: Source,
    /// Remarks on what was lost.
    pub notes: Vec<Note>,
}

/// Decodes a picture of any format that is read here; the format is told from the bytes, not from a name.
///
/// # Errors
/// When the bytes are no such picture, are damaged beyond use, or are over a limit.
pub fn decode(bytes: &[u8], options: &Options<'_>) -> Result<Picture, Error> {
    if bytes.is_empty() {
        return Err(Error::Empty);
    }
    match sniff::format(bytes).map_err(|looks_like| Error::UnknownFormat { looks_like })? {
        Format::Jpeg => jpeg::decode(bytes, options),
        Format::Png => png::decode(bytes, options),
        Format::Svg => drawing::decode(bytes, options),
        Format::Gzip => drawing::decode_gzip(bytes, options),
        Format::WebP => other::webp(bytes, options),
        Format::Tiff => other::tiff(bytes, options),
        Format::Bmp => other::bmp(bytes, options),
        Format::Gif => other::gif(bytes, options),
        Format::Pnm => other::pnm(bytes, options),
    }
}

/// Decodes a picture that is given as a file or as pixels.
///
/// # Errors
/// As [`decode`].
pub(crate) fn decode_picture(picture: picture::Picture<'_>, options: &Options<'_>) -> Result<Picture, Error> {
    match picture.0 {
        picture::Source::File(bytes) => decode(bytes, options),
        picture::Source::Rgba8 { size, pixels } => pixels::decode_rgba8(size, pixels, options),
    }
}

/// What to do about a picture over a limit.
const OVER_LIMIT: &str = "make it smaller in a picture editor first, or raise the limit";

/// What a decoder knows once the header is read.
struct Job {
    format: &'static str,
    limits: Limits,
    orientation: Orientation,
    /// The whole picture as stored.
    stored: Size,
    /// The part of it that is used, as stored.
    part: Part,
    source: Source,
    /// Upright working size; not larger than the source.
    target: Size,
    notes: Vec<Note>,
}

impl Job {
    /// Checks the header's size against the limits and asks for the working size.
    fn begin(
        format: &'static str,
        stored: Size,
        orientation: Orientation,
        options: &Options<'_>,
    ) -> Result<Self, Error> {
        if stored.area() == 0 {
            return Err(undecodable(format, format!("its header says that it has {stored} pixels")));
        }
        let limits = options.limits;
        if stored.area() > limits.megapixels.saturating_mul(1_000_000) {
            let limit_megapixels = limits.megapixels;
            return Err(Error::TooManyPixels { size: stored, limit_megapixels, remedy: OVER_LIMIT });
        }
        let upright = part(orient::turned(stored, orientation), options)?;
        let source = Source { size: upright.size, is_drawing: false };
        let target = (options.working_size)(source)?;
        let target = Size::new(target.width.clamp(1, source.size.width), target.height.clamp(1, source.size.height));
        check_memory(format, stored, working_bytes(target), limits)?;
        let part = orient::part_as_stored(upright, stored, orientation);
        Ok(Self { format, limits, orientation, stored, part, source, target, notes: Vec::new() })
    }

    /// The working size before the turn.
    fn stored_target(&self) -> Size {
        orient::turned(self.target, self.orientation)
    }

    /// Stops when decoding would take more than the limit.
    fn check_memory(&self, needed_bytes: u64) -> Result<(), Error> {
        check_memory(self.format, orient::turned(self.stored, self.orientation), needed_bytes, self.limits)
    }

    /// What the samples mean; a profile that cannot be used leaves a note.
    fn meaning(&mut self, icc: Option<&[u8]>, kind: Kind) -> Meaning {
        let meaning = icc.map_or(Ok(Meaning::Srgb), |icc| Meaning::from_profile(icc, kind));
        meaning.unwrap_or_else(|why| {
            self.notes.push(Note::ColourProfileIgnored(why));
            Meaning::Srgb
        })
    }

    /// The picture, when no rows are missing.
    fn end(self, raster: Option<Raster>) -> Result<Picture, Error> {
        let raster = raster.ok_or_else(|| ends_early(self.format))?;
        Ok(Picture { raster, source: self.source, notes: self.notes })
    }
}

/// The part of an upright picture that is used.
fn part(upright: Size, options: &Options<'_>) -> Result<Part, Error> {
    options.crop.map_or_else(|| Ok(Part::whole(upright)), |crop| crop.part(upright))
}

/// Memory that a page takes for a working picture of this size: three planes in linear light and three in the space where
/// edges are found, 4 bytes a value.
fn working_bytes(target: Size) -> u64 {
    target.area().saturating_mul(2 * 3 * 4)
}

fn check_memory(format: &'static str, size: Size, needed_bytes: u64, limits: Limits) -> Result<(), Error> {
    let needed_mb = needed_bytes.div_ceil(1_000_000);
    if needed_mb > limits.memory_mb {
        let limit_mb = limits.memory_mb;
        return Err(Error::TooMuchMemory { format, size, needed_mb, limit_mb, remedy: OVER_LIMIT });
    }
    Ok(())
}

fn undecodable(format: &'static str, why: impl Into<String>) -> Error {
    Error::Undecodable { format, why: why.into() }
}

fn ends_early(format: &'static str) -> Error {
    undecodable(format, "the file ends before the picture does")
}
