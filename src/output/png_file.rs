//! PNG files: grey pixels, their size on paper, words about them, and the seal before the end.

use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

use png::text_metadata::ITXtChunk;
use png::{BitDepth, ColorType, DeflateCompression, Encoder, EncodingError, Filter, PixelDimensions, Unit};

use super::seal;
use super::text::plain;

/// A picture without its pixels.
pub(super) struct PngFile<'a> {
    /// Pixels across and down, at least 1.
    pub(super) size: [u32; 2],
    /// Bits of a pixel.
    pub(super) depth: BitDepth,
    /// How rows are written: as they are, or as what they differ by from the row above.
    pub(super) filter: Filter,
    /// Of zlib, 1..=9.
    pub(super) level: u8,
    /// Pixels of a metre of paper.
    pub(super) per_metre: u32,
    /// Title and description, each with its language (BCP 47).
    pub(super) words: [(&'a str, &'a str); 2],
    /// How it was made, if there is something to say.
    pub(super) origin: Option<String>,
}

/// Bytes of a chunk of compressed pixels.
const IDAT: usize = 1 << 20;
/// Keyword of the text that holds the seal.
const SEAL: &[u8] = b"Seal\0";
/// The chunk after which nothing comes.
const END: &[u8] = b"\0\0\0\0IEND\xaeB`\x82";

impl PngFile<'_> {
    /// The file; `rows` writes all pixels, row by row, each of whole bytes.
    ///
    /// # Errors
    /// What `rows` gives, and if it writes too few pixels.
    pub(super) fn write(&self, rows: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<Vec<u8>, EncodingError> {
        let out = Shared::default();
        let [width, height] = self.size;
        let mut encoder = Encoder::new(out.clone(), width, height);
        encoder.set_color(ColorType::Grayscale);
        encoder.set_depth(self.depth);
        encoder.set_deflate_compression(DeflateCompression::Level(self.level));
        encoder.set_filter(self.filter);
        let per_metre = self.per_metre;
        encoder.set_pixel_dims(Some(PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter }));
        let mut writer = encoder.write_header()?;
        let mut text = |keyword: &str, language: &str, text: String| {
            let mut chunk = ITXtChunk::new(keyword, text);
            chunk.language_tag = language.to_owned();
            writer.write_text_chunk(&chunk)
        };
        for (keyword, (words, language)) in ["Title", "Description"].into_iter().zip(self.words) {
            // The format has room for a language of ASCII only.
            let language = if language.is_ascii() { plain(language) } else { String::new() };
            text(keyword, &language, plain(words))?;
        }
        text("Software", "", concat!("tactograph ", env!("CARGO_PKG_VERSION")).to_owned())?;
        self.origin.iter().try_for_each(|origin| text("Comment", "", origin.clone()))?;
        let mut stream = writer.stream_writer_with_size(IDAT)?;
        rows(&mut stream)?;
        stream.finish()?;
        let seal = out.seal();
        writer.write_chunk(png::chunk::tEXt, &[SEAL, seal.as_bytes()].concat())?;
        writer.finish()?;
        Ok(out.take())
    }
}

/// Whether these bytes are a PNG as [`PngFile::write`] makes it, changed by nobody since.
pub(super) fn is_as_written(bytes: &[u8]) -> bool {
    let body = bytes.strip_suffix(END).and_then(|rest| {
        // length, type, data and checksum of the chunk before
        let at = rest.len().checked_sub(4 + 4 + SEAL.len() + seal::LENGTH + 4)?;
        rest.split_at_checked(at)
    });
    let Some((body, chunk)) = body else { return false };
    let data = [b"tEXt", SEAL, seal::of(body).as_bytes()].concat();
    let mut sum = flate2::Crc::new();
    sum.update(&data);
    let length = (data.len() as u32 - 4).to_be_bytes();
    chunk == [&length[..], &data, &sum.sum().to_be_bytes()].concat()
}

/// Bytes that the encoder writes and that can be looked at meanwhile: the seal is that of all before it.
#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<u8>>>);

impl Shared {
    fn seal(&self) -> String {
        seal::of(&self.0.borrow())
    }

    fn take(&self) -> Vec<u8> {
        self.0.take()
    }
}

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests;
