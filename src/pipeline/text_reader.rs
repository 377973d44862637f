//! Words of the text in a picture's pixels, by whoever can read it.

use std::fmt;
use std::sync::Arc;

use crate::lettering::{Lettering, LinePicture};
use crate::raster::Raster;

/// Gives the words in pictures (PNG, black on white) of a line of text each, empty where it cannot read them; or says
/// why it cannot read at all.
type ReadText = dyn Fn(&[Vec<u8>]) -> Result<Vec<String>, String> + Send + Sync;

/// Somebody who reads text in pixels.
#[derive(Clone)]
pub struct TextReader(Arc<ReadText>);

/// Longest text that is kept, characters: more than any page has room for in braille.
const LONGEST: usize = 400;

impl TextReader {
    pub(crate) fn new(read: impl Fn(&[Vec<u8>]) -> Result<Vec<String>, String> + Send + Sync + 'static) -> Self {
        Self(Arc::new(read))
    }

    /// The words of each line that was found in a picture.
    ///
    /// # Errors
    /// In one line, what the reader says; or that it gave something else than asked for.
    pub(super) fn words(&self, found: &Lettering, raster: &Raster) -> Result<Vec<String>, String> {
        let pictures: Result<Vec<Vec<u8>>, png::EncodingError> = found.pictures(raster).iter().map(encoded).collect();
        let pictures = pictures.map_err(|error| format!("a picture of a line cannot be written: {error}"))?;
        let words = (self.0)(&pictures)?;
        if words.len() != pictures.len() {
            return Err(format!("{} texts were given to be read, and {} came back", pictures.len(), words.len()));
        }
        let plain = |text: &String| -> String {
            let words = text.split(|c: char| c.is_whitespace() || c.is_control()).filter(|word| !word.is_empty());
            words.collect::<Vec<_>>().join(" ").chars().take(LONGEST).collect()
        };
        Ok(words.iter().map(plain).collect())
    }
}

impl fmt::Debug for TextReader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TextReader").finish_non_exhaustive()
    }
}

fn encoded(line: &LinePicture) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, line.size.width, line.size.height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&line.pixels)?;
    writer.finish()?;
    Ok(bytes)
}
