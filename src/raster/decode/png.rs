//! PNG: rows are averaged as they are inflated, so a picture of any height takes the memory of a few rows. Interlaced
//! ones come in seven passes over the whole picture and are held whole.

use std::io::{Cursor, ErrorKind};

use image::metadata::Orientation;
use png::{BitDepth, ColorType, Decoder, DecodingError, Reader, Transformations};

use super::colour::{ColourKind, Meaning, one_line};
use super::job::{DecodeOptions, Decoded, Job, Limits, ends_early, unpacks_too_far};
use super::light::{SampleDepth, SampleLayout};
use super::rows::{Extents, Rows, Samples};
use crate::Error;
use crate::units::Size;

const FORMAT: &str = "PNG";

pub(super) fn decode(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let bytes_limit = usize::try_from(options.limits.memory_mb.saturating_mul(1_000_000)).unwrap_or(usize::MAX);
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: bytes_limit });
    decoder.set_transformations(Transformations::EXPAND); // palettes, 1 to 4 bits and the transparent colour
    decoder.set_ignore_text_chunk(true);
    let info = decoder.read_header_info().map_err(|fault| fault_in(fault, options.limits))?;
    let size = Size::new(info.width, info.height);
    check_palette(info.color_type, bytes)?;
    let mut job = Job::begin(FORMAT, size, orientation(bytes), options)?;
    let mut reader = decoder.read_info().map_err(|fault| fault_in(fault, options.limits))?;
    let layout = layout(&reader)?;
    let meaning = meaning(&mut job, &reader, layout.kind);
    let source = Extents::pixels(size.width, job.part);
    let samples = Samples::new(layout, meaning, source, job.target, job.orientation);
    if reader.info().interlaced {
        let length = layout.row_bytes(size.width) as u64 * u64::from(size.height);
        job.check_memory(length)?;
        let mut whole = vec![0; length as usize];
        reader.next_frame(&mut whole).map_err(|fault| fault_in(fault, options.limits))?;
        return job.end(samples.raster(&whole));
    }
    let mut rows = samples.rows();
    push_while_inflating(&mut reader, layout.row_bytes(size.width), size.height, &mut rows)
        .map_err(|fault| fault_in(fault, options.limits))?;
    job.end(rows.finish())
}

/// Bytes of rows that are inflated before they are averaged: few enough to stay in a core's cache.
const BLOCK_BYTES: usize = 1 << 18;

/// Averages a block of rows while the next is inflated, on another core if there is one. Inflating takes several times
/// as long, so more cores would have nothing to do.
fn push_while_inflating<R: std::io::BufRead + std::io::Seek + Send>(
    reader: &mut Reader<R>,
    row_bytes: usize,
    height: u32,
    rows: &mut Rows,
) -> Result<(), DecodingError> {
    let at_once = (BLOCK_BYTES / row_bytes).clamp(1, height as usize);
    let mut left = height as usize;
    let mut inflate = |block: &mut Vec<u8>| -> Result<(), DecodingError> {
        block.resize(at_once.min(left) * row_bytes, 0);
        for (number, row) in block.chunks_exact_mut(row_bytes).enumerate() {
            if reader.read_row(row)?.is_none() {
                block.truncate(number * row_bytes); // fewer rows than the header says
                left = 0;
                return Ok(());
            }
        }
        left -= block.len() / row_bytes;
        Ok(())
    };
    let (mut here, mut next) = (Vec::new(), Vec::new());
    inflate(&mut here)?;
    while !here.is_empty() {
        let (inflated, ()) =
            rayon::join(|| inflate(&mut next), || here.chunks_exact(row_bytes).for_each(|row| rows.push(row)));
        inflated?;
        std::mem::swap(&mut here, &mut next);
    }
    Ok(())
}

fn layout<R: std::io::BufRead + std::io::Seek>(reader: &Reader<R>) -> Result<SampleLayout, Error> {
    let (colour, depth) = reader.output_color_type();
    let (kind, alpha) = match colour {
        ColorType::Grayscale => (ColourKind::Grey, false),
        ColorType::GrayscaleAlpha => (ColourKind::Grey, true),
        ColorType::Rgb => (ColourKind::Rgb, false),
        ColorType::Rgba => (ColourKind::Rgb, true),
        ColorType::Indexed => return Err(Error::undecodable(FORMAT, "its palette is missing")),
    };
    let depth = if depth == BitDepth::Sixteen { SampleDepth::SixteenBigEndian } else { SampleDepth::Eight };
    Ok(SampleLayout { kind, alpha, depth })
}

/// By the order of the PNG specification: a profile, else that it is sRGB, else a gamma.
fn meaning<R: std::io::BufRead + std::io::Seek>(job: &mut Job, reader: &Reader<R>, kind: ColourKind) -> Meaning {
    let info = reader.info();
    match (&info.icc_profile, info.srgb, info.gama_chunk) {
        (None, None, Some(gamma)) => Meaning::from_encoding_gamma(gamma.into_value()),
        (icc, ..) => job.meaning(icc.as_deref(), kind),
    }
}

/// From the eXIf chunk, which may lie behind the pixels as well.
fn orientation(bytes: &[u8]) -> Orientation {
    let exif = chunks(bytes).find(|chunk| chunk.name == *b"eXIf");
    exif.and_then(|chunk| Orientation::from_exif_chunk(chunk.data)).unwrap_or(Orientation::NoTransforms)
}

/// png 0.18.1 panics when it expands a palette whose bytes are no whole number of colours.
///
/// # Errors
/// If this is such a palette.
pub(super) fn check_palette(colour: ColorType, bytes: &[u8]) -> Result<(), Error> {
    if colour != ColorType::Indexed {
        return Ok(());
    }
    match chunks(bytes).find(|chunk| chunk.name == *b"PLTE" && chunk.data.len() % 3 != 0) {
        Some(Chunk { at, data, .. }) => {
            let length = data.len();
            let why = format!("its palette (chunk PLTE at byte {at}) has {length} bytes, and a colour takes 3");
            Err(Error::undecodable(FORMAT, why))
        }
        None => Ok(()),
    }
}

/// A chunk of a PNG.
struct Chunk<'a> {
    /// Where it begins in the file.
    at: usize,
    name: [u8; 4],
    data: &'a [u8],
}

/// The chunks of a file, as far as they are whole; checksums are not looked at.
fn chunks(bytes: &[u8]) -> impl Iterator<Item = Chunk<'_>> {
    const SIGNATURE: usize = 8;
    let mut at = SIGNATURE;
    // A chunk: length of the data, name, data, checksum.
    std::iter::from_fn(move || {
        let (length, behind) = bytes.get(at..)?.split_first_chunk::<4>()?;
        let (name, behind) = behind.split_first_chunk::<4>()?;
        let data = behind.get(..u32::from_be_bytes(*length) as usize)?;
        let chunk = Chunk { at, name: *name, data };
        at += 12 + data.len();
        Some(chunk)
    })
}

fn fault_in(fault: DecodingError, limits: Limits) -> Error {
    match fault {
        DecodingError::IoError(fault) if fault.kind() == ErrorKind::UnexpectedEof => ends_early(FORMAT),
        DecodingError::LimitsExceeded => unpacks_too_far(FORMAT, "a row or the colour profile", limits),
        other => Error::undecodable(FORMAT, one_line(&other)),
    }
}
