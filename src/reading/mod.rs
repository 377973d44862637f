//! A page read back from its SVG, as it was written or as somebody changed it in an editor.
//!
//! ```text
//! bytes -> document (limits, ids) -> usvg -> marks (paths in mm, each with its layer and object) -> build -> Page
//!                                  `-> words (title, description, origin, braille)
//! ```
//!
//! usvg resolves what an editor may do: transforms, styles, clones, shapes, hidden layers. It knows no attributes of
//! other programs, so these are looked up in the elements by their ids.
//!
//! What is drawn counts, not what was written once: a mark is taken as it is now, of any width and colour, and as
//! what the layer says in which it lies. What lies in no layer is taken by its kind: a stroke is a line, a disc is a
//! dot, a large filled shape in a colour an area of that colour, and any other a line around it. What is taken
//! otherwise than it looks, or not at all, is told in a [`Note`].

mod areas;
mod build;
mod clip;
mod cuts;
mod document;
mod entities;
mod kind;
mod leaders;
mod markers;
mod marks;
mod names;
mod print;
mod said;
mod shapes;
mod sized;
mod style;
mod subpath;
mod tally;
mod texts;
mod tone;
mod typed;
mod unread;
mod words;

use usvg::roxmltree::{Document, Node};
use usvg::{ImageHrefResolver, Tree};

use crate::output::svg;
use crate::page::{Names, Page};
use crate::raster::decode::tree_of;
use crate::units::MM_PER_CSS_PX;
use crate::{Error, Note};
use build::Built;
use document::Elements;
use style::is_shown;
use tally::OfFile;

pub use areas::DrawnArea;
pub use document::{FINDINGS, text_of};
pub use tone::{is_black, is_white};
pub use typed::{SeenText, TypedText, is_braille};
pub use unread::{UnreadKind, UnreadObject, in_mm};

/// Sides of sheets that are read, mm: from less than a pin display's field to twice an A0 poster.
const LEAST_SHEET: f32 = 5.0;
const LARGEST_SHEET: f32 = 2500.0;

/// A page that was read.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Reading {
    /// The page. Its `origin` is what the file says of how it was made.
    pub page: Page,
    /// What its lines and areas are called in the file.
    pub names: Names,
    /// What was taken otherwise than it looks, or left out.
    pub notes: Vec<Note>,
    /// Areas that a person drew, which are not on the page as long as they have no signs.
    pub areas: Vec<DrawnArea>,
    /// Whether somebody has changed or saved it since it was written.
    pub is_changed: bool,
    /// The texts in braille that a person moved, by their names.
    pub moved_texts: Vec<String>,
    /// Texts that a person typed and that are to be written in braille, which are not on the page either.
    pub texts: Vec<TypedText>,
    /// All texts that are shown in letters, or in a font of braille, and may rise.
    pub letters: Vec<SeenText>,
}

impl Reading {
    /// What fingers meet of a page for the back of the sheet, and the other way round; so many cells of braille are
    /// `width_of` mm wide.
    pub fn turned_over(mut self, width_of: impl Fn(usize) -> f32) -> Self {
        let sum = self.page.mirror_sum();
        for text in &mut self.texts {
            let width = if text.is_braille { width_of(text.string.chars().count()) } else { 0.0 };
            text.at.x = sum - text.at.x - (1.0 - 2.0 * text.anchor) * width;
        }
        let points = self.areas.iter_mut().flat_map(|area| &mut area.outlines).flatten();
        points.for_each(|at| at.x = sum - at.x);
        Self { page: self.page.mirrored(), ..self }
    }
}

/// Reads a page from an SVG that [`svg::write`](crate::output::svg::write) wrote, changed by an editor or not.
/// Marks are as they are drawn: nothing is put right.
///
/// A page that nobody changed is read as it was, up to the 0.005 mm to which coordinates are written, and is the same
/// to the byte when it is written again.
///
/// # Errors
/// [`Error::NotAPage`] if it is no SVG, or none with the layers of a page; [`Error::Undecodable`] if it is broken, and
/// [`Error::TooComplex`] if it is over a limit.
pub fn read(svg: &[u8]) -> Result<Reading, Error> {
    read_as(svg, true)
}

/// As [`read`], of any SVG: what is drawn in one without layers is taken by its kind, as on a page what lies outside
/// of them.
///
/// # Errors
/// As [`read`], but for the layers.
pub fn read_any(svg: &[u8]) -> Result<Reading, Error> {
    read_as(svg, false)
}

fn read_as(svg: &[u8], needs_layers: bool) -> Result<Reading, Error> {
    let given = document::text_of(svg)?;
    let (text, cut) = document::with_ids(&given)?;
    let document = document::parse(&text)?;
    let elements = Elements::of(&document);
    if needs_layers && !elements.are_of_page {
        let why = "it has none of the layers of a page, such as lines in a figure";
        let remedy = "convert it, if it is a drawing, or give the SVG of a page that tactograph made";
        return Err(Error::NotAPage { why, remedy });
    }
    let tree = without_pictures(&document)?;
    let marks = marks::of(&tree, &elements)?;
    let round = |px: f32| (f64::from(px * MM_PER_CSS_PX) * 1000.0).round() as f32 / 1000.0;
    let sheet = [round(tree.size().width()), round(tree.size().height())];
    if !sheet.iter().all(|side| (LEAST_SHEET..=LARGEST_SHEET).contains(side)) {
        let why = "its sheet is smaller than 5 mm or larger than 2500 mm";
        return Err(Error::NotAPage { why, remedy: "check its size in mm" });
    }
    let words = words::of(&document);
    let is_picture = |node: &Node<'_, '_>| node.tag_name().name() == "image" && is_shown(node);
    let pictures = document.descendants().filter(is_picture).count();
    let elsewhere = document.descendants().filter(|node| elements.is_elsewhere(*node)).count();
    let texts = elements.texts(&document);
    let letters = typed::seen(&texts, &marks.texts);
    let file = OfFile { pictures, elsewhere, cut, ..OfFile::default() };
    let (texts, print, told) = typed::sorted(texts, &marks.texts);
    let Built { page, names, mut notes, areas, moved_texts } =
        build::page((marks, print, file), words, &elements, sheet)?;
    notes.extend(told);
    notes.extend(document::says_no_size(svg).then(|| tally::told_no_size(sheet)));
    if needs_layers {
        notes.extend(tally::told_no_metadata(&page, &elements));
    }
    let is_changed = !svg::is_as_written(given.as_bytes());
    Ok(Reading { page, names, notes, areas, is_changed, moved_texts, texts, letters })
}

/// What is drawn, without pictures of pixels.
fn without_pictures(document: &Document<'_>) -> Result<Tree, Error> {
    let nothing = ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    tree_of(document, &usvg::Options { image_href_resolver: nothing, ..usvg::Options::default() })
}

/// The texts that an SVG shows in letters, be it a page or not.
///
/// # Errors
/// As [`read_any`].
pub fn letters_of(svg: &[u8]) -> Result<Vec<SeenText>, Error> {
    let (text, _) = document::with_ids(&document::text_of(svg)?)?;
    let document = document::parse(&text)?;
    let elements = Elements::of(&document);
    let texts = elements.texts(&document);
    if texts.is_empty() {
        return Ok(Vec::new());
    }
    let marks = marks::of(&without_pictures(&document)?, &elements)?;
    Ok(typed::seen(&texts, &marks.texts))
}

/// What a drawing shows and no page has, such as pictures of pixels, each with its box.
pub fn unread_of<'a>(document: &'a Document<'a>) -> Vec<UnreadObject> {
    let found = unread::elements_of(document, &Elements::of(document));
    if found.is_empty() {
        return Vec::new();
    }
    let text = unread::with_boxes(document, &found);
    // without their boxes they are told all the same
    let tree = document::parse(&text).ok().and_then(|boxed| without_pictures(&boxed).ok());
    unread::placed(found, tree.as_ref())
}

/// Whether bytes are text in XML, as all pages are.
pub fn is_svg(bytes: &[u8]) -> bool {
    document::text_of(bytes).is_ok()
}

/// Whether bytes are an SVG that can be read, be it a page or not.
pub fn is_drawing(bytes: &[u8]) -> bool {
    let is_root = |document: &Document<'_>| document.root_element().tag_name().name() == "svg";
    document::text_of(bytes).is_ok_and(|text| document::parse(&text).is_ok_and(|document| is_root(&document)))
}

/// Whether a text is a page of ours: it has the layer of a figure with the place that the writer gives it.
pub fn is_page(svg: &[u8]) -> bool {
    let text = std::str::from_utf8(svg).unwrap_or_default();
    let has = |what: &str| text.contains(what);
    has("data-box=") && has("data-source=") && has("<svg")
}

#[cfg(test)]
mod tests;
