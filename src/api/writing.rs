//! Pages and traces to bytes.

use std::sync::Arc;

use super::fonts::Fonts;
use crate::contours::Trace;
use crate::output::dots::{gcode, pef};
use crate::output::png::{Depth, Dpi};
use crate::output::{DotFormat, DrawingFormat, Embossing, Format, json, pdf, png, svg, write_dots};
use crate::page::Page;
use crate::{Error, Note, Reason};

impl Page {
    /// An SVG drawing in true millimetres, with a layer for each texture, for the lines, the frame and the overview:
    /// for looking at, and for changing it in a drawing program.
    #[must_use]
    pub fn to_svg(&self) -> String {
        svg::write(self)
    }

    /// A PDF document of this one page in true millimetres, with the layers of the SVG: for printing. For several
    /// pages there is [`write_pdf`].
    #[must_use]
    pub fn to_pdf(&self) -> Vec<u8> {
        pdf::write(&self.title, std::slice::from_ref(self))
    }

    /// A PNG picture that says how large it is, for printers and displays, with title and description as its texts. It
    /// has as many pixels as its sheet at `dpi`, without a part that is clear. A page of a device with heights, or with
    /// words in print, is grey, whatever the `depth`: black and white would make all or nothing of both. `fonts` are
    /// for words in print beside their braille (`braille.print` of a profile), and need not be those of the conversion;
    /// without a font they are left out, as [`Page::not_in_png`] tells. It is rendered on the calling thread, in less
    /// than a second for A4 at 300 dots per inch, with 64 MB of memory beside its file, and cannot be cancelled.
    ///
    /// # Errors
    /// [`Error::TooFine`] if that would be more than 400 megapixels, [`Error::TooComplex`] of a page of more than a
    /// million marks, [`Error::NoMemory`].
    pub fn to_png(&self, dpi: Dpi, depth: Depth, fonts: &Fonts) -> Result<Vec<u8>, Error> {
        let fonts = if self.print.is_empty() { Arc::default() } else { fonts.database() };
        png::write(self, dpi, depth, fonts)
    }

    /// What of the page a PNG made with these fonts would lack: words in print, where there are no fonts. None if it
    /// has all.
    #[must_use]
    pub fn not_in_png(&self, fonts: &Fonts) -> Option<Note> {
        let why = "words in print (braille.print): there are no fonts for them; install one, or write a PDF";
        let lacks = !self.print.is_empty() && fonts.database().is_empty();
        lacks.then_some(Note::NotInPng(Reason::NoFonts, why))
    }

    /// The page in a format of drawings that is chosen while the program runs. `dpi`, `depth` and `fonts` are for PNG.
    ///
    /// # Errors
    /// As [`Page::to_png`].
    pub fn to_drawing(&self, format: DrawingFormat, dpi: Dpi, depth: Depth, fonts: &Fonts) -> Result<Vec<u8>, Error> {
        match format {
            DrawingFormat::Svg => Ok(self.to_svg().into_bytes()),
            DrawingFormat::Pdf => Ok(self.to_pdf()),
            DrawingFormat::Png => self.to_png(dpi, depth, fonts),
        }
    }

    /// The dots of a page that was made with the profile of an embosser or a pin display, as a file that it or its
    /// driver takes. For several pages, or other [`Embossing`] than the usual, there is [`write_dots`].
    ///
    /// # Errors
    /// As [`write_dots`].
    pub fn to_dots(&self, format: DotFormat) -> Result<Vec<u8>, Error> {
        let files = write_dots(&self.title, std::slice::from_ref(self), format, Embossing::default())?;
        files.into_iter().next().ok_or(Error::NoPages)
    }
}

/// One PDF document of several pages, such as those of [`convert_to_sheets`](super::convert_to_sheets) or
/// [`calibrate`](super::calibrate). It has the language and the origin of the first. `title` is what it is called as a
/// whole, such as [`Options::document_title`](super::Options::document_title), or of a page that was rendered its
/// `title`: viewers show it. Each page keeps its own
/// title, such as that of an overview or a key, as the name of its figure for screen readers.
///
/// # Errors
/// [`Error::NoPages`] without pages: a PDF has at least one.
pub fn write_pdf<'p>(title: &str, pages: impl IntoIterator<Item = &'p Page>) -> Result<Vec<u8>, Error> {
    let mut pages = pages.into_iter().peekable();
    if pages.peek().is_none() { Err(Error::NoPages) } else { Ok(pdf::write(title, pages)) }
}

impl Trace {
    /// The contours as JSON, one polyline a line:
    ///
    /// ```text
    /// {"program":"tactograph 0.1.0","image":[width,height],"polylines":[
    /// {"closed":true,"points":[[x,y],...],"strength":[one for each point]},
    /// ...
    /// ]}
    /// ```
    ///
    /// Lines of a page also have `"width_mm":[one for each point]`. Units are those of the fields of [`Trace`].
    #[must_use]
    pub fn to_json(&self) -> String {
        json::write(self)
    }

    /// Whether a file that begins with these bytes is one as [`Trace::to_json`] writes it. Whatever reads JSON and
    /// writes it again sets its spaces otherwise.
    #[must_use]
    pub fn is_json_as_written(head: &[u8]) -> bool {
        head.starts_with(json::MARK.as_bytes())
    }
}

impl Format {
    /// Whether these bytes are a whole file of this format as this crate wrote it, changed by nobody since. `None` for
    /// formats that cannot tell, as every byte of theirs is a dot: ubrl, brf, idx and txt.
    #[must_use]
    pub fn is_as_written(self, bytes: &[u8]) -> Option<bool> {
        match self {
            Self::Drawing(DrawingFormat::Svg) => Some(svg::is_as_written(bytes)),
            Self::Drawing(DrawingFormat::Pdf) => Some(pdf::is_as_written(bytes)),
            Self::Drawing(DrawingFormat::Png) | Self::Dots(DotFormat::Pixels) => Some(png::is_as_written(bytes)),
            Self::Dots(DotFormat::Pef) => Some(pef::is_as_written(bytes)),
            Self::Dots(DotFormat::Gcode) => Some(gcode::is_as_written(bytes)),
            Self::Dots(DotFormat::Ubrl | DotFormat::Brf | DotFormat::Idx | DotFormat::Txt) => None,
        }
    }
}
