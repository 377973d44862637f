//! Bytes of a picture file become a [`Raster`](super::Raster) at the working size.
//!
//! ```text
//!  bytes -- sniff --> jpeg | png | other | drawing | pdf --> rows (light, shrink, orient)
//!                       `- header: Job::begin checks the limits and asks for the working size,
//!                          before anything is decoded
//! ```

mod canvas;
mod colour;
mod complexity;
mod drawing;
mod edited;
mod filters;
mod job;
mod jpeg;
mod light;
mod mathtext;
mod names;
mod orient;
mod other;
mod outlined;
mod paths;
#[cfg(feature = "pdf")]
mod pdf;
mod place_names;
mod png;
mod rows;
mod scans;
mod segments;
mod sniff;
mod texts;

use self::job::guarded;
use self::sniff::PictureFormat;
use crate::{Error, picture};

pub(crate) use self::canvas::check_canvases;
pub(crate) use self::complexity::no_longer_than;
pub(crate) use self::drawing::{checked_document, start_of_packed, tree_of};
pub(crate) use self::edited::edited;
pub use self::job::{DecodeOptions, Decoded, FontLoader, Header, Limits};

/// Decodes a picture of any format that is read here; the format is detected from the bytes, not from a name.
///
/// # Errors
/// When the bytes are no such picture, are damaged beyond use, or are over a limit. A decoder that panics counts as
/// damage, where panics unwind.
pub fn decode(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    if bytes.is_empty() {
        return Err(Error::Empty);
    }
    let format = sniff::format(bytes).map_err(|looks_like| Error::UnknownFormat { looks_like })?;
    if !format.has_pages() {
        check_page(options.page)?;
    }
    let decoded = guarded(|| match format {
        PictureFormat::Jpeg => jpeg::decode(bytes, options),
        PictureFormat::Png => png::decode(bytes, options),
        PictureFormat::Svg => drawing::decode(bytes, options),
        PictureFormat::Gzip => drawing::decode_gzip(bytes, options),
        #[cfg(feature = "pdf")]
        PictureFormat::Pdf => pdf::decode(bytes, options),
        PictureFormat::WebP => other::webp(bytes, options),
        PictureFormat::Tiff => other::tiff(bytes, options),
        PictureFormat::Bmp => other::bmp(bytes, options),
        PictureFormat::Gif => other::gif(bytes, options),
        PictureFormat::Pnm => other::pnm(bytes, options),
    });
    decoded.unwrap_or_else(|panic| Err(Error::undecodable(format.name(), format!("its decoder failed ({panic})"))))
}

/// Reads a picture as far as its header, decodes nothing, and asks `is_fine` what is thought of it. The limits are the
/// usual ones.
///
/// # Errors
/// As [`decode`], for what the header tells; and what `is_fine` says.
pub(crate) fn look_at(bytes: &[u8], is_fine: &dyn Fn(Header) -> Result<(), Error>) -> Result<(), Error> {
    let seen = std::cell::Cell::new(false);
    let stop = |header: Header| {
        is_fine(header)?;
        seen.set(true);
        Err(Error::Cancelled) // the rest is not wanted
    };
    match decode(bytes, &DecodeOptions::whole(&stop)) {
        Err(Error::Cancelled) if seen.get() => Ok(()),
        other => other.map(drop),
    }
}

/// # Errors
/// If another page is asked for than the one that a picture is.
fn check_page(page: Option<u32>) -> Result<(), Error> {
    match page {
        None | Some(1) => Ok(()),
        Some(page) => Err(Error::NoSuchPage { page, pages: 1 }),
    }
}

/// Decodes a picture that is given as a file or as pixels.
///
/// # Errors
/// As [`decode`].
pub(crate) fn decode_picture(picture: picture::Picture<'_>, options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    match picture.0 {
        picture::PixelSource::File(bytes) => decode(bytes, options),
        picture::PixelSource::Rgba8 { size, pixels } => {
            check_page(options.page)?;
            rows::decode_rgba8(size, pixels, options)
        }
    }
}
