//! Pages of PDF documents. hayro interprets a page and writes it as an SVG drawing, which is decoded as any other;
//! its texts, which are outlines of letters there, come from the document itself.
//!
//! ```text
//!  bytes -- unpacked --> document -- cost --> page -- survey --> texts, pictures within the limits
//!                                               `---- hayro-svg -- markup --> SVG without letters --> drawing
//! ```

mod cost;
mod letters;
mod markup;
mod survey;
mod unpacked;
mod words;

use hayro_interpret::hayro_syntax::page::Page;
use hayro_interpret::hayro_syntax::{DecryptionError, LoadPdfError, Pdf};
use hayro_interpret::{InterpreterSettings, InterpreterWarning};
use hayro_svg::{RenderCache, SvgRenderSettings};
use std::sync::{Arc, Mutex};

use self::unpacked::FORMAT;
use super::drawing::{self, Target};
use super::job::{DecodeOptions, Decoded};
use crate::raster::vector::DrawnText;
use crate::{Error, Note, Reason};

/// The page of a document that is asked for; the first if none is.
pub(super) fn decode(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    unpacked::check(bytes, options.limits)?;
    let pdf = Pdf::new(bytes.to_vec()).map_err(not_opened)?;
    let pages = pdf.pages();
    if pages.is_empty() {
        return Err(Error::undecodable(FORMAT, "it has no page"));
    }
    let number = options.page.unwrap_or(1);
    let nowhere = Error::NoSuchPage { page: number, pages: pages.len() };
    let page = number.checked_sub(1).and_then(|index| pages.get(index as usize)).ok_or(nowhere)?;
    let mut picture = decode_page(page, options)?;
    if options.page.is_none() && pages.len() > 1 {
        picture.notes.insert(0, Note::FirstPageOnly { pages: pages.len() });
    }
    Ok(picture)
}

fn decode_page(page: &Page<'_>, options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    cost::check(page, options.limits)?;
    let warnings = Warnings::default();
    let settings = warnings.settings();
    let found = survey::of_page(page, &settings, options.limits)?;
    let svg = hayro_svg::convert(page, &RenderCache::new(), &settings, &SvgRenderSettings::default());
    let letters = (!options.keep_text).then_some(&found.form_letters[..]);
    let drawing = markup::prepared(&svg, page.render_dimensions(), letters);
    drop(svg);
    let texts = |Target { transform, size, .. }: Target<'_>| -> Vec<DrawnText> {
        if options.keep_text { Vec::new() } else { words::on_canvas(&found.texts, transform, size) }
    };
    let mut picture = drawing::decode_page(&drawing, options, texts).map_err(of_pdf)?;
    if !options.keep_text && found.unknown_letters > 0 {
        let count = found.unknown_letters;
        let what = format!("{count} letters or signs, of which the document does not tell which they are");
        picture.notes.push(Note::LeftOut(Reason::UnknownLetters, what));
    }
    picture.notes.extend(warnings.notes(options.keep_text));
    Ok(picture)
}

/// What a page says of the drawing that is made of it is said of the document.
fn of_pdf(error: Error) -> Error {
    match error {
        Error::Undecodable { why, .. } => Error::undecodable(FORMAT, why),
        Error::TooComplex { why, .. } => Error::too_complex(FORMAT, why),
        Error::TooMuchMemory { size, needed_mb, limit_mb, remedy, .. } => {
            Error::TooMuchMemory { format: FORMAT, size, needed_mb, limit_mb, remedy }
        }
        other => other,
    }
}

fn not_opened(fault: LoadPdfError) -> Error {
    match fault {
        LoadPdfError::Decryption(DecryptionError::PasswordProtected) => Error::Locked { format: FORMAT },
        LoadPdfError::Decryption(_) => Error::undecodable(FORMAT, "it is encrypted in a way that is not known here"),
        LoadPdfError::Invalid => Error::undecodable(FORMAT, "it is damaged, or has no page"),
    }
}

/// What hayro could not draw, each kind once.
#[derive(Default)]
struct Warnings(Arc<Mutex<NotDrawn>>);

#[derive(Default)]
struct NotDrawn {
    fonts: bool,
    pictures: bool,
    annotations: bool,
}

impl Warnings {
    fn settings(&self) -> InterpreterSettings {
        let found = Arc::clone(&self.0);
        let warning_sink = Arc::new(move |warning| {
            if let Ok(mut found) = found.lock() {
                match warning {
                    InterpreterWarning::UnsupportedFont => found.fonts = true,
                    InterpreterWarning::ImageDecodeFailure => found.pictures = true,
                    InterpreterWarning::UnresolvedAnnotationAppearance => found.annotations = true,
                    // kinds that later releases of the interpreter may add
                    _ => {}
                }
            }
        });
        InterpreterSettings { warning_sink, ..InterpreterSettings::default() }
    }

    fn notes(&self, keep_text: bool) -> Vec<Note> {
        let Ok(found) = self.0.lock() else { return Vec::new() };
        let kinds = [
            (found.pictures, Reason::Unreadable, "a picture inside the page, which cannot be read"),
            (found.fonts && keep_text, Reason::NoFonts, "a text whose font cannot be used"),
            (found.annotations, Reason::NoAppearance, "a form field or remark that does not say what it looks like"),
        ];
        let found = kinds.into_iter().filter(|(is_found, ..)| *is_found);
        found.map(|(_, why, what)| Note::LeftOut(why, what.to_owned())).collect()
    }
}
