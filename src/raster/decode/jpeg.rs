//! JPEG: decoded at 1, 1/2, 1/4 or 1/8 of its size straight from the transform's coefficients, the smallest that is not
//! smaller than the working size, and then averaged down to it.

use std::cell::Cell;
use std::io::{ErrorKind, Read};

use image::metadata::Orientation;
use jpeg_decoder::{CodingProcess, ColorTransform, Decoder, ImageInfo, PixelFormat, UnsupportedFeature};

use super::colour::{ColourKind, one_line};
use super::job::{DecodeOptions, Decoded, Job, ends_early};
use super::light::SampleLayout;
use super::rows::{Extents, Samples};
use super::scans;
use super::segments::{JpegSegments, START_OF_SCAN};
use crate::Error;
use crate::raster::shrink::Extent;
use crate::units::Size;

const FORMAT: &str = "JPEG";

/// Longest side; libjpeg has the same limit, so no program writes more. jpeg-decoder counts rows of blocks in 16 bits
/// and overflows beyond 65528.
const LONGEST_SIDE: u32 = 65_500;

pub(super) fn decode(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let head = Head::read(bytes);
    let at_end = Cell::new(false);
    let mut decoder = Decoder::new(Bytes::new(vec![bytes], &head, &at_end));
    let fault = |fault| fault_in(fault, at_end.get());
    decoder.read_info().map_err(fault)?;
    let info = decoder.info().ok_or_else(|| ends_early(FORMAT))?;
    let size = Size::new(info.width.into(), info.height.into());
    let orientation = decoder.exif_data().and_then(Orientation::from_exif_chunk).unwrap_or(Orientation::NoTransforms);
    let mut job = Job::begin(FORMAT, size, orientation, options)?;
    let kind = kind(&info, size)?;
    let eighths = eighths(job.part.size, job.stored_target());
    if head.progressive && eighths == 1 {
        // most of the time is for scans that say nothing of the means of blocks
        decoder = Decoder::new(Bytes::new(scans::of_means(bytes), &head, &at_end));
        decoder.read_info().map_err(fault)?;
    }
    if kind == ColourKind::Rgb && head.is_adobe_rgb() {
        decoder.set_color_transform(ColorTransform::RGB);
    }

    let scaled = Size::new((size.width * eighths).div_ceil(8), (size.height * eighths).div_ceil(8));
    let layout = SampleLayout::plain(kind);
    job.check_memory(memory(layout, size, scaled, head.progressive))?;
    let (across, down) = asked_size(size, eighths);
    let came = decoder.scale(across, down).map_err(fault)?;
    if (u32::from(came.0), u32::from(came.1)) != (scaled.width, scaled.height) {
        return Err(Error::undecodable(FORMAT, format!("it cannot be scaled to {eighths}/8")));
    }
    #[cfg(feature = "turbojpeg")]
    let quick = (!head.icc_behind_size).then(|| turbo_pixels(bytes, kind, eighths, scaled)).flatten();
    #[cfg(not(feature = "turbojpeg"))]
    let quick = None;
    let mut pixels = quick.map_or_else(|| decoder.decode().map_err(fault), Ok)?;
    let icc = decoder.icc_profile();
    drop(decoder); // and with it the coefficients
    if kind == ColourKind::Cmyk && head.adobe.is_none() {
        // jpeg-decoder takes all inks as Adobe writes them, upside down. Files without Adobe's mark have them upright.
        for ink in &mut pixels {
            *ink = 255 - *ink;
        }
    }
    let meaning = job.meaning(icc.as_deref(), kind);
    let part = job.part;
    let across = Extent::scaled(part.left, part.size.width, eighths);
    let source = Extents { width: scaled.width, across, down: Extent::scaled(part.top, part.size.height, eighths) };
    let samples = Samples::new(layout, meaning, source, job.target, job.orientation);
    Ok(job.end(samples.raster(&pixels))?.with_loss())
}

/// What the pixels are made of.
///
/// # Errors
/// If it is a picture that jpeg-decoder cannot decode or that is too long.
fn kind(info: &ImageInfo, size: Size) -> Result<ColourKind, Error> {
    if info.coding_process == CodingProcess::Lossless || info.pixel_format == PixelFormat::L16 {
        return Err(Error::undecodable(FORMAT, "it is of the lossless kind, which hardly any program reads"));
    }
    if size.width.max(size.height) > LONGEST_SIDE {
        return Err(Error::undecodable(FORMAT, format!("no side may be longer than {LONGEST_SIDE} pixels")));
    }
    Ok(match info.pixel_format {
        PixelFormat::L8 | PixelFormat::L16 => ColourKind::Grey,
        PixelFormat::RGB24 => ColourKind::Rgb,
        PixelFormat::CMYK32 => ColourKind::Cmyk,
    })
}

/// Bytes that decoding takes: the planes before and after colours are made of them; a progressive picture also has all
/// its coefficients, of two bytes each.
fn memory(layout: SampleLayout, size: Size, scaled: Size, progressive: bool) -> u64 {
    let bytes = |size: Size| layout.row_bytes(size.width) as u64 * u64::from(size.height);
    2 * bytes(scaled) + if progressive { 2 * bytes(size) } else { 0 }
}

/// The pixels at so many eighths of their size, which is `size`, through the C library libjpeg-turbo. `None` for
/// pictures of inks and for whatever that library finds wrong: jpeg-decoder then names the fault, or reads the picture
/// all the same.
#[cfg(feature = "turbojpeg")]
fn turbo_pixels(bytes: &[u8], kind: ColourKind, eighths: u32, size: Size) -> Option<Vec<u8>> {
    use turbojpeg::{Decompressor, Image, PixelFormat, ScalingFactor};

    let (format, channels) = match kind {
        ColourKind::Grey => (PixelFormat::GRAY, 1),
        ColourKind::Rgb => (PixelFormat::RGB, 3),
        ColourKind::Cmyk => return None,
    };
    let (width, height) = (size.width as usize, size.height as usize);
    let pitch = channels * width;
    let mut pixels = vec![0; pitch * height];
    let mut decompressor = Decompressor::new().ok()?;
    decompressor.read_header(bytes).ok()?;
    decompressor.set_scaling_factor(ScalingFactor::new(eighths as usize, 8)).ok()?;
    decompressor.decompress(bytes, Image { pixels: &mut pixels[..], width, pitch, height, format }).ok()?;
    Some(pixels)
}

/// The smallest scale, in eighths, at which no side is shorter than the target's.
fn eighths(size: Size, target: Size) -> u32 {
    // jpeg-decoder is asked for a scale by the length of a side; below this, two scales have the same.
    const SHORT: u32 = 16;
    if size.width.max(size.height) < SHORT {
        return 8;
    }
    let enough = |eighths: &u32| size.width * eighths >= target.width * 8 && size.height * eighths >= target.height * 8;
    [1, 2, 4].into_iter().find(enough).unwrap_or(8)
}

/// The size to ask of jpeg-decoder for a scale. It takes the first scale at which *either* side is long enough, so the
/// shorter side is asked for longer than it can be.
fn asked_size(size: Size, eighths: u32) -> (u16, u16) {
    let side = |length: u32| (length * eighths).div_ceil(8) as u16;
    if size.width >= size.height { (side(size.width), u16::MAX) } else { (u16::MAX, side(size.height)) }
}

/// What jpeg-decoder does not pass on.
#[derive(Default)]
struct Head {
    /// The transform in Adobe's mark, if that is there: 0 for none, 1 for YCbCr, 2 for YCCK.
    adobe: Option<u8>,
    /// Whether the mark of JFIF is there, which allows YCbCr and grey only.
    jfif: bool,
    progressive: bool,
    /// Whether a colour profile stands behind the size, where jpeg-decoder sees it only while decoding.
    #[cfg(feature = "turbojpeg")]
    icc_behind_size: bool,
}

impl Head {
    /// Walks the segments before the pixels.
    fn read(bytes: &[u8]) -> Self {
        let mut head = Self::default();
        #[cfg(feature = "turbojpeg")]
        let mut is_sized = false;
        let segments = JpegSegments::of(bytes).map_while(Result::ok);
        for segment in segments.take_while(|segment| segment.kind != START_OF_SCAN) {
            match (segment.kind, segment.data) {
                // Version and two flags of two bytes each lie between.
                (0xEE, [b'A', b'd', b'o', b'b', b'e', _, _, _, _, _, _, transform, ..]) => {
                    head.adobe = Some(*transform);
                }
                (0xE0, [b'J', b'F', b'I', b'F', 0, ..]) => head.jfif = true,
                _ => (), // other segments do not matter here
            }
            head.progressive |= segment.kind == 0xC2;
            #[cfg(feature = "turbojpeg")]
            {
                // tables of codes and arithmetic conditions have numbers among those of frames
                is_sized |= matches!(segment.kind, 0xC0..=0xCF) && !matches!(segment.kind, 0xC4 | 0xC8 | 0xCC);
                head.icc_behind_size |= is_sized && segment.kind == 0xE2;
            }
        }
        head
    }

    /// Whether three channels are red, green and blue. By libjpeg's rule (which all browsers follow) Adobe's mark goes
    /// before the names of the channels; jpeg-decoder does the opposite.
    fn is_adobe_rgb(&self) -> bool {
        self.adobe == Some(0) && !self.jfif
    }

    /// What to read after the file's end. Some cameras forget the end mark, and their pictures are whole. For a picture
    /// in one pass many one-bits and then the mark do: no code is made of ones only, so a picture that lacks more than
    /// the mark is found by a decoding error. One in several passes could lose whole passes unnoticed, and gets
    /// nothing.
    fn fill(&self) -> &'static [u8] {
        const ONES_AND_END: [u8; 66] = {
            let mut fill = [0; 66];
            let mut i = 0;
            while i < 64 {
                fill[i] = 0xFF; // FF 00 stands for eight one-bits
                i += 2;
            }
            fill[64] = 0xFF;
            fill[65] = 0xD9;
            fill
        };
        if self.progressive { &[] } else { &ONES_AND_END }
    }
}

/// The file's bytes and then the fill; `at_end` becomes true when the file is used up.
struct Bytes<'a> {
    rest: &'a [u8],
    /// What follows, the next one last.
    parts: Vec<&'a [u8]>,
    fill: &'static [u8],
    at_end: &'a Cell<bool>,
}

impl<'a> Bytes<'a> {
    fn new(mut parts: Vec<&'a [u8]>, head: &Head, at_end: &'a Cell<bool>) -> Self {
        parts.reverse();
        Self { rest: parts.pop().unwrap_or_default(), parts, fill: head.fill(), at_end }
    }
}

impl Read for Bytes<'_> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        while self.rest.is_empty() && !self.parts.is_empty() {
            self.rest = self.parts.pop().unwrap_or_default();
        }
        if self.rest.is_empty() && !out.is_empty() {
            self.at_end.set(true);
            self.rest = std::mem::take(&mut self.fill);
        }
        self.rest.read(out)
    }

    /// The decoder reads byte by byte, so this is called for every one of them.
    #[inline]
    fn read_exact(&mut self, mut out: &mut [u8]) -> std::io::Result<()> {
        if let ([first, rest @ ..], [only]) = (self.rest, &mut *out) {
            (*only, self.rest) = (*first, rest);
            return Ok(());
        }
        while !out.is_empty() {
            match self.read(out)? {
                0 => return Err(ErrorKind::UnexpectedEof.into()),
                count => out = &mut out[count..],
            }
        }
        Ok(())
    }
}

fn fault_in(fault: jpeg_decoder::Error, at_end: bool) -> Error {
    use jpeg_decoder::Error as Fault;
    let why = match fault {
        _ if at_end => return ends_early(FORMAT),
        Fault::Unsupported(UnsupportedFeature::SamplePrecision(bits)) => {
            format!("it has {bits} bits for a sample; only 8 are read")
        }
        Fault::Unsupported(UnsupportedFeature::ArithmeticEntropyCoding) => {
            "its arithmetic coding is not read; save it with Huffman coding, as all common programs do".into()
        }
        Fault::Unsupported(UnsupportedFeature::Hierarchical) => {
            "it is of the hierarchical kind, which is not read".into()
        }
        Fault::Unsupported(UnsupportedFeature::DNL) => "its header does not say how high it is".into(),
        Fault::Format(what) => one_line(&what),
        other => one_line(&other),
    };
    Error::undecodable(FORMAT, why)
}

#[cfg(test)]
mod tests;
