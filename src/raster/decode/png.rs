//! PNG: rows are averaged as they are inflated, so a picture of any height takes the memory of a few rows. Interlaced
//! ones come in seven passes over the whole picture and are held whole.

use std::io::{Cursor, ErrorKind};

use image::metadata::Orientation;
use png::{BitDepth, ColorType, Decoder, DecodingError, Reader, Transformations};

use super::colour::{Kind, Meaning, one_line};
use super::rows::{Depth, Layout, Rows};
use super::{Job, Options, Picture, ends_early, undecodable};
use crate::Error;
use crate::units::Size;

const FORMAT: &str = "PNG";

pub(super) fn decode(bytes: &[u8], options: &Options<'_>) -> Result<Picture, Error> {
    let bytes_limit = usize::try_from(options.limits.memory_mb.saturating_mul(1_000_000)).unwrap_or(usize::MAX);
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: bytes_limit });
    decoder.set_transformations(Transformations::EXPAND); // palettes, 1 to 4 bits and the transparent colour
    decoder.set_ignore_text_chunk(true);
    let info = decoder.read_header_info().map_err(fault)?;
    let size = Size::new(info.width, info.height);
    let mut job = Job::begin(FORMAT, size, orientation(bytes), options)?;
    let mut reader = decoder.read_info().map_err(fault)?;
    let layout = layout(&reader)?;
    let meaning = meaning(&mut job, &reader, layout.kind);
    let mut rows = Rows::whole(layout, meaning, (size.width, job.part), job.target, job.orientation);
    if reader.info().interlaced {
        let length = layout.row_bytes(size.width) as u64 * u64::from(size.height);
        job.check_memory(length)?;
        let mut whole = vec![0; length as usize];
        reader.next_frame(&mut whole).map_err(fault)?;
        for row in whole.chunks_exact(layout.row_bytes(size.width)) {
            rows.push(row);
        }
    } else {
        for _ in 0..size.height {
            match reader.next_row().map_err(fault)? {
                Some(row) => rows.push(row.data()),
                None => break,
            }
        }
    }
    job.end(rows.finish())
}

fn layout<R: std::io::BufRead + std::io::Seek>(reader: &Reader<R>) -> Result<Layout, Error> {
    let (colour, depth) = reader.output_color_type();
    let (kind, alpha) = match colour {
        ColorType::Grayscale => (Kind::Grey, false),
        ColorType::GrayscaleAlpha => (Kind::Grey, true),
        ColorType::Rgb => (Kind::Rgb, false),
        ColorType::Rgba => (Kind::Rgb, true),
        ColorType::Indexed => return Err(undecodable(FORMAT, "its palette is missing")),
    };
    let depth = if depth == BitDepth::Sixteen { Depth::SixteenBigEndian } else { Depth::Eight };
    Ok(Layout { kind, alpha, depth })
}

/// By the order of the PNG specification: a profile, else that it is sRGB, else a gamma.
fn meaning<R: std::io::BufRead + std::io::Seek>(job: &mut Job, reader: &Reader<R>, kind: Kind) -> Meaning {
    let info = reader.info();
    match (&info.icc_profile, info.srgb, info.gama_chunk) {
        (None, None, Some(gamma)) => Meaning::from_encoding_gamma(gamma.into_value()),
        (icc, ..) => job.meaning(icc.as_deref(), kind),
    }
}

/// From the eXIf chunk, which may lie behind the pixels as well.
fn orientation(bytes: &[u8]) -> Orientation {
    const SIGNATURE: usize = 8;
    let mut rest = bytes.get(SIGNATURE..).unwrap_or_default();
    // A chunk: length of the data, name, data, checksum.
    while let Some((length, behind)) = rest.split_first_chunk::<4>() {
        let length = u32::from_be_bytes(*length) as usize;
        let Some((name, behind)) = behind.split_first_chunk::<4>() else { break };
        let Some(data) = behind.get(..length) else { break };
        if name == b"eXIf" {
            return Orientation::from_exif_chunk(data).unwrap_or(Orientation::NoTransforms);
        }
        rest = behind.get(length + 4..).unwrap_or_default();
    }
    Orientation::NoTransforms
}

fn fault(fault: DecodingError) -> Error {
    match fault {
        DecodingError::IoError(fault) if fault.kind() == ErrorKind::UnexpectedEof => ends_early(FORMAT),
        DecodingError::LimitsExceeded => {
            undecodable(FORMAT, "its colour profile or its rows are over the memory limit")
        }
        other => undecodable(FORMAT, one_line(&other)),
    }
}
