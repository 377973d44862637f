//! Where each letter of a page stands, and how large it is.

use std::collections::HashSet;

use hayro_interpret::font::{Glyph, GlyphRun, PositionedGlyph};
use hayro_interpret::hayro_cmap::BfString;
use hayro_interpret::hayro_syntax::content::TypedIter;
use hayro_interpret::hayro_syntax::content::ops::TypedInstruction;
use hayro_interpret::hayro_syntax::object::{Dict, Name, Stream};
use hayro_interpret::hayro_syntax::page::Page;
use hayro_interpret::kurbo::{Affine, BezPath, PathEl, Point, Shape};

use super::super::names::letter_named;
use super::words::Letter;

/// Letters are in thousandths of the font size.
const EM: f64 = 1000.0;

/// How wide the letters of a text are on average, in font sizes.
const USUAL_WIDTHS: std::ops::RangeInclusive<f64> = 0.15..=1.5;

/// The letters of a run, which are drawn with a transform.
pub(super) fn of_run(run: &GlyphRun<'_, '_>, transform: Affine, hidden: bool) -> Vec<Letter> {
    let drawn_widths = run.glyphs().iter().filter_map(|glyph| match &**glyph {
        Glyph::Outline(_) => None,
        Glyph::Type3(drawn) => drawn.advance_width().map(|width| f64::from(width).abs()),
    });
    let em = em(drawn_widths);
    run.glyphs().iter().map(|glyph| of_glyph(glyph, em, transform, hidden)).collect()
}

/// The font size of a run, in the units of its letters: a thousand, unless the widths of those that are drawings of
/// their own say that it cannot be. The units of such letters may be anything, as where TeX made them of pixels; most
/// letters are half as wide as their size.
fn em(drawn_widths: impl Iterator<Item = f64>) -> f64 {
    let widths: Vec<f64> = drawn_widths.filter(|width| *width > 0.0).collect();
    let average = widths.iter().sum::<f64>() / widths.len().max(1) as f64;
    if widths.is_empty() || USUAL_WIDTHS.contains(&(average / EM)) { EM } else { 2.0 * average }
}

fn of_glyph(glyph: &PositionedGlyph<'_>, em: f64, transform: Affine, hidden: bool) -> Letter {
    let (advance, is_drawn) = match &**glyph {
        Glyph::Outline(outline) => (outline.advance_width(), false),
        Glyph::Type3(drawn) => (drawn.advance_width(), true),
    };
    let string = glyph.as_unicode().map(|text| match text {
        BfString::Char(char) => char.to_string(),
        BfString::String(string) => string,
    });
    let to_page = transform * glyph.transform();
    let mut letter = placed(string, to_page, advance.map_or(em / 2.0, f64::from), em);
    // letters that are drawings may be upside down in text that is upside down, as where TeX made them of pixels
    if is_drawn && letter.along.cross(letter.up) > 0.0 {
        letter.up = -letter.up;
    }
    Letter { hidden, ..letter }
}

/// A letter that is drawn with a transform, in thousandths of its size.
fn placed(string: Option<String>, to_page: Affine, advance: f64, em: f64) -> Letter {
    let from = to_page * Point::ORIGIN;
    let (up, along) = (to_page * Point::new(0.0, em) - from, to_page * Point::new(em, 0.0) - from);
    Letter { string, from, to: to_page * Point::new(advance, 0.0), up, along, hidden: false }
}

/// Whether two letters are on one line, in one size.
pub(super) fn is_on_line(letter: &Letter, other: &Letter) -> bool {
    let size = letter.up.hypot();
    let is_none = |off: f64| off.abs() <= 0.02 * size;
    is_none((other.up - letter.up).hypot())
        && is_none((other.along - letter.along).hypot())
        && is_none(letter.along.normalize().cross(other.from - letter.from))
}

/// A form that is a letter: matplotlib, before its release 3.11, draws so what has no place among the 256 letters of a
/// font, such as the minus of a number. The form is named after the font and the letter, as `F1-DejaVuSans-minus`, and
/// drawn behind the text in which it stands.
pub(super) struct FormLetter {
    string: Option<String>,
    outline: BezPath,
}

/// Most forms of a page that are looked at; a font has as many letters.
const MOST_FORMS: usize = 512;

/// Most lines and curves of an outline; letters have fewer.
const MOST_ELEMENTS: usize = 500;

/// Most bytes of a form as it stands in the document: as many as such an outline has that is not packed. Longer ones,
/// and those that are packed several times, are not unpacked, as they could be of any size then.
const MOST_PACKED: usize = 16_384;

/// Most bytes that are unpacked of the forms of a page, up to the one that goes beyond it.
const MOST_UNPACKED: usize = 8_000_000;

impl FormLetter {
    /// Those that a page can draw.
    pub(super) fn all_of(page: &Page<'_>) -> Vec<Self> {
        let resources = page.raw().get::<Dict<'_>>("Resources");
        let Some(forms) = resources.and_then(|own| own.get::<Dict<'_>>("XObject")) else { return Vec::new() };
        let mut names: Vec<Name<'_>> = forms.keys().filter(|name| glyph_name(name.as_str()).is_some()).collect();
        names.sort();
        let (mut known, mut unpacked) = (HashSet::new(), 0);
        let letter = |name: Name<'_>| {
            let glyph = glyph_name(name.as_str())?;
            // one that has several names would be unpacked many times
            let form = forms.get::<Stream<'_>>(name.as_ref()).filter(|form| known.insert(form.obj_id()))?;
            if unpacked > MOST_UNPACKED || form.filters().len() > 1 || form.raw_data().len() > MOST_PACKED {
                return None;
            }
            let content = form.decoded_data().ok()?;
            unpacked += content.len();
            let outline = outline(&content)?;
            Some(Self { string: letter_named(glyph).map(String::from), outline })
        };
        names.into_iter().take(MOST_FORMS).filter_map(letter).collect()
    }

    /// Whether a path is its outline.
    pub(super) fn is(&self, path: &BezPath) -> bool {
        self.outline == *path
    }

    /// The letter where its outline is drawn with a transform. The blank on its right is taken to be as wide as that
    /// on its left.
    pub(super) fn letter(&self, to_page: Affine) -> Letter {
        let extent = self.outline.bounding_box();
        placed(self.string.clone(), to_page, extent.x0 + extent.x1, EM)
    }

    /// How hayro-svg begins the element of its outline: up to the end of the first attribute.
    pub(super) fn element(&self) -> String {
        let of_element = |element: &PathEl| {
            let (sign, points) = match *element {
                PathEl::MoveTo(to) => ('M', vec![to]),
                PathEl::LineTo(to) => ('L', vec![to]),
                PathEl::QuadTo(a, to) => ('Q', vec![a, to]),
                PathEl::CurveTo(a, b, to) => ('C', vec![a, b, to]),
                PathEl::ClosePath => ('Z', Vec::new()),
            };
            let points: Vec<String> = points.iter().map(|at| format!("{},{}", at.x as f32, at.y as f32)).collect();
            format!("{sign}{}", points.join(" "))
        };
        let elements: Vec<String> = self.outline.elements().iter().map(of_element).collect();
        format!("<path d=\"{}\"", elements.join(" "))
    }
}

/// What a form is named after, behind the names of a font in the document and of its file.
fn glyph_name(form: &str) -> Option<&str> {
    let (number, rest) = form.strip_prefix('F')?.split_once('-')?;
    let (_, glyph) = rest.rsplit_once('-')?;
    (!number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())).then_some(glyph)
}

/// The path that a form fills, if it does nothing else and the path is no longer than that of a letter.
fn outline(content: &[u8]) -> Option<BezPath> {
    let mut path = BezPath::new();
    let mut fills = 0;
    let mut steps = TypedIter::new(content);
    while let Some(step) = steps.next() {
        if path.elements().len() > MOST_ELEMENTS {
            return None;
        }
        match step {
            TypedInstruction::MoveTo(to) => path.move_to((to.0.as_f64(), to.1.as_f64())),
            _ if path.elements().is_empty() => return None,
            TypedInstruction::LineTo(to) => path.line_to((to.0.as_f64(), to.1.as_f64())),
            TypedInstruction::CubicTo(to) => {
                let [a, b] = [(to.0.as_f64(), to.1.as_f64()), (to.2.as_f64(), to.3.as_f64())];
                path.curve_to(a, b, (to.4.as_f64(), to.5.as_f64()));
            }
            TypedInstruction::ClosePath(_) => path.close_path(),
            TypedInstruction::FillPathNonZero(_) => fills += 1,
            _ => return None,
        }
    }
    (fills == 1).then_some(path)
}

#[cfg(test)]
mod tests;
