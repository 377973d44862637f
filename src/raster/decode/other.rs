//! The formats whose decoders cannot shrink while they decode: the whole picture is decoded, under the memory limit,
//! and then averaged row by row.

use std::error::Error as _;
use std::io::{Cursor, ErrorKind};

use image::codecs::bmp::BmpDecoder;
use image::codecs::gif::GifDecoder;
use image::codecs::pnm::PnmDecoder;
use image::codecs::tiff::TiffDecoder;
use image::codecs::webp::WebPDecoder;
use image::error::UnsupportedErrorKind;
use image::metadata::Orientation;
use image::{ColorType, ImageDecoder, ImageError};

use super::colour::{ColourKind, one_line};
use super::job::{DecodeOptions, Decoded, Job, Limits, ends_early, unpacks_too_far};
use super::light::{SampleDepth, SampleLayout};
use super::rows::{Extents, Samples};
use crate::Error;
use crate::units::Size;

pub(super) fn webp(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let picture = picture("WebP", WebPDecoder::new(Cursor::new(bytes)), options)?;
    Ok(if is_lossy(bytes) { picture.with_loss() } else { picture })
}

/// Whether a WebP has lossy pixels: a chunk "VP8 " among those of the file, each with its name and length.
fn is_lossy(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(12..).unwrap_or_default();
    while let [a, b, c, d, e, f, g, h, data @ ..] = rest {
        if [*a, *b, *c, *d] == *b"VP8 " {
            return true;
        }
        let length = (u32::from_le_bytes([*e, *f, *g, *h]) as usize).saturating_add(1) & !1;
        rest = data.get(length..).unwrap_or_default();
    }
    false
}

pub(super) fn tiff(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    picture("TIFF", TiffDecoder::new(Cursor::new(bytes)), options)
}

pub(super) fn bmp(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    picture("BMP", BmpDecoder::new(Cursor::new(bytes)), options)
}

pub(super) fn gif(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    picture("GIF", GifDecoder::new(Cursor::new(bytes)), options)
}

pub(super) fn pnm(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    picture("PNM", PnmDecoder::new(Cursor::new(bytes)), options)
}

fn picture<D: ImageDecoder>(
    format: &'static str,
    decoder: Result<D, ImageError>,
    options: &DecodeOptions<'_>,
) -> Result<Decoded, Error> {
    let fault = |fault: ImageError| fault_in(format, options.limits, fault);
    let mut decoder = decoder.map_err(fault)?;
    let (width, height) = decoder.dimensions();
    let size = Size::new(width, height);
    // A picture whose EXIF block is broken is shown as it lies.
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let mut job = Job::begin(format, size, orientation, options)?;
    // Before the limits: those that image 0.25.10 sets for a TIFF drop a profile that is large beside a small picture.
    let icc = decoder.icc_profile().unwrap_or_default();
    // The pixels, and as much again for what the decoders hold beside them (strips of a TIFF, the luma and chroma
    // planes of a WebP, the canvas of a GIF).
    let length = decoder.total_bytes();
    job.check_memory(length.saturating_mul(2))?;
    let mut limits = image::Limits::no_limits();
    limits.max_alloc = Some(options.limits.memory_mb.saturating_mul(1_000_000));
    decoder.set_limits(limits).map_err(fault)?;
    let layout = layout(format, decoder.color_type())?;
    let meaning = job.meaning(icc.as_deref(), layout.kind);
    let mut whole = vec![0; usize::try_from(length).map_err(|_| Error::NoMemory { what: "the picture" })?];
    decoder.read_image(&mut whole).map_err(fault)?;
    let source = Extents::pixels(size.width, job.part);
    let samples = Samples::new(layout, meaning, source, job.target, job.orientation);
    job.end(samples.raster(&whole))
}

fn layout(format: &'static str, colour: ColorType) -> Result<SampleLayout, Error> {
    let (kind, alpha, depth) = match colour {
        ColorType::L8 => (ColourKind::Grey, false, SampleDepth::Eight),
        ColorType::La8 => (ColourKind::Grey, true, SampleDepth::Eight),
        ColorType::Rgb8 => (ColourKind::Rgb, false, SampleDepth::Eight),
        ColorType::Rgba8 => (ColourKind::Rgb, true, SampleDepth::Eight),
        ColorType::L16 => (ColourKind::Grey, false, SampleDepth::SixteenNative),
        ColorType::La16 => (ColourKind::Grey, true, SampleDepth::SixteenNative),
        ColorType::Rgb16 => (ColourKind::Rgb, false, SampleDepth::SixteenNative),
        ColorType::Rgba16 => (ColourKind::Rgb, true, SampleDepth::SixteenNative),
        _ => return Err(Error::undecodable(format, NO_SUCH_SAMPLES)),
    };
    Ok(SampleLayout { kind, alpha, depth })
}

/// Floating point, say.
const NO_SUCH_SAMPLES: &str = "its samples are no whole numbers of 8 or 16 bits";

fn fault_in(format: &'static str, limits: Limits, fault: ImageError) -> Error {
    match &fault {
        ImageError::IoError(io) if is_end_of_file(io) => ends_early(format),
        // The words of the decoder itself, without those that the image crate puts before them.
        ImageError::Decoding(_) => {
            let cause = fault.source().unwrap_or(&fault);
            if is_end_of_file(cause) { ends_early(format) } else { Error::undecodable(format, one_line(&cause)) }
        }
        ImageError::Unsupported(what) if matches!(what.kind(), UnsupportedErrorKind::Color(_)) => {
            Error::undecodable(format, NO_SUCH_SAMPLES)
        }
        ImageError::Unsupported(what) => {
            let what = one_line(&what);
            // "The decoder for Tiff does not support the format features ..."
            let what = what.split_once(" format features ").map_or(what.as_str(), |(_, features)| features);
            Error::undecodable(
                format,
                format!("this kind of {format} is not read ({})", what.trim_end_matches(" is unsupported")),
            )
        }
        ImageError::Limits(_) => unpacks_too_far(format, "the picture", limits),
        other => Error::undecodable(format, one_line(other)),
    }
}

fn is_end_of_file(fault: &(dyn std::error::Error + 'static)) -> bool {
    let io = fault.downcast_ref::<std::io::Error>();
    io.is_some_and(|io| io.kind() == ErrorKind::UnexpectedEof)
        // The gif crate has it in words only.
        || fault.to_string().to_ascii_lowercase().contains("unexpected end of file")
        || fault.source().is_some_and(is_end_of_file)
}
