//! What all decoders share: what they are asked for, what they give, the limits, and how faults are reported.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use image::metadata::Orientation;

use super::colour::{ColourKind, Meaning, one_line};
use super::orient;
use crate::raster::crop::{Crop, PixelPart};
use crate::raster::planes::Raster;
use crate::raster::vector::{DrawnText, VectorDrawing};
use crate::units::Size;
use crate::{Error, Note};

/// What a picture may cost. A bitmap over a limit is refused by its header, before anything is decoded. Default: 300
/// megapixels and 1024 MB, chosen by us: pictures of scanners have less.
///
/// These stay whatever the limits are ([`Error::TooComplex`]): a drawing has at most a million elements, with each
/// reference counted as often as it is drawn, 5 million attributes, 200 levels of elements in elements, 30 000 letters
/// in a text and 8000 rules of style sheets; a page of a PDF 20 million steps and 40 parts one inside the other. Of a
/// page that is read there are 100 MB, and 5 million points of paths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Most pixels, in millions.
    pub megapixels: u64,
    /// Most memory for decoding, in megabytes of 10^6 bytes.
    pub memory_mb: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { megapixels: 300, memory_mb: 1024 }
    }
}

/// Where the letters of SVG drawings come from; asked only when a drawing has text.
pub type FontLoader<'a> = dyn Fn() -> Arc<usvg::fontdb::Database> + Sync + 'a;

/// What is known of a picture from the header of its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Header {
    /// Pixels after the turn that EXIF asks for; for an SVG drawing its size in CSS pixels, rounded. Of the part that
    /// is used, where there is a [`Crop`].
    pub size: Size,
    /// Whether it is a vector drawing, which can be rendered at any size.
    pub is_drawing: bool,
}

/// How to decode.
pub struct DecodeOptions<'a> {
    /// What the picture may cost.
    pub limits: Limits,
    /// Fonts for drawings.
    pub fonts: &'a FontLoader<'a>,
    /// The part of the upright picture that is used; all of it without one.
    pub crop: Option<Crop>,
    /// The page of a document, from 1; without it the first. A picture has one page.
    pub page: Option<u32>,
    /// Whether letters of drawings are drawn; if not, texts are left out and given as data.
    pub keep_text: bool,
    /// Whether the ground of a scan stays as it is, and is not taken for paper.
    pub keep_ground: bool,
    /// Whether nothing is wanted but the pixels: of a drawing neither paths nor texts.
    pub pixels_only: bool,
    /// The working size for a source: never larger than the source unless it is a drawing.
    pub working_size: &'a dyn Fn(Header) -> Result<Size, Error>,
}

impl<'a> DecodeOptions<'a> {
    /// All of the first page with its letters, within the default limits, where there are no fonts.
    pub fn whole(working_size: &'a dyn Fn(Header) -> Result<Size, Error>) -> Self {
        let (limits, fonts) = (Limits::default(), &Arc::default);
        Self {
            limits,
            fonts,
            crop: None,
            page: None,
            keep_text: true,
            keep_ground: true,
            pixels_only: false,
            working_size,
        }
    }
}

/// A decoded picture.
#[derive(Debug, Clone)]
pub struct Decoded {
    /// The pixels at working size, upright.
    pub raster: Raster,
    /// Of a picture with lossy compression by blocks, by which factor it was shrunk, at most 1; none without.
    pub lossy: Option<f32>,
    /// What was known from the header.
    pub source: Header,
    /// The paths of a vector drawing that has not too many.
    pub drawing: Option<VectorDrawing>,
    /// The texts of a drawing that are left out of `raster`.
    pub texts: Vec<DrawnText>,
    /// Remarks on what was lost.
    pub notes: Vec<Note>,
}

impl Decoded {
    /// The same, of which it is known that its compression lost something.
    pub(super) fn with_loss(self) -> Self {
        let shrunk = self.raster.size().width as f32 / self.source.size.width.max(1) as f32;
        Self { lossy: Some(shrunk.min(1.0)), ..self }
    }
}

/// What to do about a picture over a limit.
pub(super) const OVER_LIMIT: &str = "make it smaller in a picture editor first, or raise the limit";

/// The same of a file that unpacks to more than the limit.
const OVER_LIMIT_UNPACKED: &str = "open and save it again in another program, or raise the limit";

/// What a decoder knows once the header is read.
pub(super) struct Job {
    pub(super) format: &'static str,
    pub(super) limits: Limits,
    pub(super) orientation: Orientation,
    /// The whole picture as stored.
    pub(super) stored: Size,
    /// The part of it that is used, as stored.
    pub(super) part: PixelPart,
    pub(super) source: Header,
    /// Upright working size; not larger than the source.
    pub(super) target: Size,
    pub(super) notes: Vec<Note>,
}

impl Job {
    /// Checks the header's size against the limits and asks for the working size.
    pub(super) fn begin(
        format: &'static str,
        stored: Size,
        orientation: Orientation,
        options: &DecodeOptions<'_>,
    ) -> Result<Self, Error> {
        if stored.area() == 0 {
            return Err(Error::undecodable(format, format!("its header says that it has {stored} pixels")));
        }
        let limits = options.limits;
        if stored.area() > limits.megapixels.saturating_mul(1_000_000) {
            let limit_megapixels = limits.megapixels;
            return Err(Error::TooManyPixels { size: stored, limit_megapixels, remedy: OVER_LIMIT });
        }
        let upright = part(orient::turned(stored, orientation), options)?;
        let source = Header { size: upright.size, is_drawing: false };
        let target = (options.working_size)(source)?;
        let target = Size::new(target.width.clamp(1, source.size.width), target.height.clamp(1, source.size.height));
        check_memory(format, stored, working_bytes(target), limits)?;
        let part = orient::part_as_stored(upright, stored, orientation);
        Ok(Self { format, limits, orientation, stored, part, source, target, notes: Vec::new() })
    }

    /// The working size before the turn.
    pub(super) fn stored_target(&self) -> Size {
        orient::turned(self.target, self.orientation)
    }

    /// Stops when decoding would take more than the limit.
    pub(super) fn check_memory(&self, needed_bytes: u64) -> Result<(), Error> {
        check_memory(self.format, orient::turned(self.stored, self.orientation), needed_bytes, self.limits)
    }

    /// What the samples mean; a profile that cannot be used leaves a note.
    pub(super) fn meaning(&mut self, icc: Option<&[u8]>, kind: ColourKind) -> Meaning {
        let meaning = icc.map_or(Ok(Meaning::Srgb), |icc| Meaning::from_profile(icc, kind));
        meaning.unwrap_or_else(|why| {
            self.notes.push(Note::ColourProfileIgnored(why));
            Meaning::Srgb
        })
    }

    /// The picture, when no rows are missing.
    pub(super) fn end(self, raster: Option<Raster>) -> Result<Decoded, Error> {
        let raster = raster.ok_or_else(|| ends_early(self.format))?;
        Ok(Decoded { raster, lossy: None, source: self.source, drawing: None, texts: Vec::new(), notes: self.notes })
    }
}

/// The part of an upright picture that is used.
pub(super) fn part(upright: Size, options: &DecodeOptions<'_>) -> Result<PixelPart, Error> {
    options.crop.map_or_else(|| Ok(PixelPart::whole(upright)), |crop| crop.part(upright))
}

/// Memory that a page takes for a working picture of this size: three planes in linear light and three in the space
/// where edges are found, 4 bytes a value.
pub(super) fn working_bytes(target: Size) -> u64 {
    target.area().saturating_mul(2 * 3 * 4)
}

pub(super) fn check_memory(format: &'static str, size: Size, needed_bytes: u64, limits: Limits) -> Result<(), Error> {
    let needed_mb = needed_bytes.div_ceil(1_000_000);
    if needed_mb > limits.memory_mb {
        let limit_mb = limits.memory_mb;
        return Err(Error::TooMuchMemory { format, size, needed_mb, limit_mb, remedy: OVER_LIMIT });
    }
    Ok(())
}

/// What is packed in a file is more than the limit.
pub(super) fn unpacks_too_far(format: &'static str, what: &'static str, limits: Limits) -> Error {
    Error::UnpacksTooFar { format, what, limit_mb: limits.memory_mb, remedy: OVER_LIMIT_UNPACKED }
}

pub(super) fn ends_early(format: &'static str) -> Error {
    Error::undecodable(format, "the file ends before the picture does")
}

/// Runs a decoder of others, and gives the message of its panic if it does.
///
/// The decoders are programs of others that are fed with bytes from anywhere, and single ones of these make them panic
/// (png 0.18.1, usvg 0.49; both have a test). That is the picture's fault, and must not stop a caller that has more
/// pictures to convert. Nothing that a decoder leaves half done is used again.
///
/// Two things stay as they are:
/// * Where panics abort (`panic = "abort"`, and WebAssembly, which does not unwind) nothing is caught. So what is known
///   to panic is refused before the decoder sees it, and this is only the second line.
/// * The panic hook of the process runs before anything is caught; Rust's own writes the message to standard error. A
///   hook belongs to the program and not to a library, so none is set here. The program `tactograph` sets a silent one.
pub(super) fn guarded<T>(decoder: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(decoder)).map_err(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no reason given");
        one_line(&text)
    })
}

#[cfg(test)]
mod tests;
