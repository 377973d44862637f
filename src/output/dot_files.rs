//! Pages of dots in the files that embossers, braille programs and pin displays take.

use super::dots::index::{self, Embossing};
use super::dots::{DocumentWords, DotMatrix, brf, dots, gcode, pef, pixels, text, ubrl};
use super::format::DotFormat;
use crate::Error;
use crate::devices::DotArea;
use crate::page::{BrailleText, DotMedium, Medium, Page, Pen, Shape, TextRole};

/// The files of pages that belong together: one where the format holds them all, else one a page. `title` is what they
/// are called as a whole, such as [`Options::document_title`](crate::Options::document_title). Only a PEF that holds
/// them all says it; files of one page say that page's own title, and the other formats have no place for words.
///
/// # Errors
/// * [`Error::NoPages`] without pages.
/// * [`Error::NotOfDots`] if a page is for printing, and [`Error::NotAllDots`] if it has other marks.
/// * [`Error::NotItsFormat`] if the device does not take the format.
/// * [`Error::NotTogether`] if pages are for different devices, or an Index embosser would need different sheets.
/// * [`Error::NotItsDots`] if dots are where the device or the format has none, and [`Error::CannotPress`] if an Index
///   embosser does not take the sheet. Neither happens to pages that the crate made.
pub fn write<'p>(
    title: &str,
    pages: impl IntoIterator<Item = &'p Page>,
    format: DotFormat,
    embossing: Embossing,
) -> Result<Vec<Vec<u8>>, Error> {
    let with_medium = |page: &'p Page| Ok((page, medium_of(page, format)?));
    let pages = pages.into_iter().map(with_medium).collect::<Result<Vec<_>, Error>>()?;
    let &(first, medium) = pages.first().ok_or(Error::NoPages)?;
    let of_one_device = |(page, own): &&(&Page, &DotMedium)| is_for_same(first, medium, page, own, format);
    if let Some((_, other)) = pages.iter().find(|page| !of_one_device(page)) {
        return Err(different(medium, other));
    }
    let matrices = || pages.iter().map(|(page, medium)| matrix_of(page, medium)).collect::<Result<Vec<_>, Error>>();
    let one = |text: String| Ok(vec![text.into_bytes()]);
    match format {
        DotFormat::Ubrl => one(ubrl::write(&matrices()?)),
        DotFormat::Brf => one(brf::write(&matrices()?)),
        DotFormat::Pef => {
            let text = text_of(pages.iter().map(|(page, _)| *page));
            one(pef::write(&matrices()?, &DocumentWords { title, text: &text, ..words(first) }))
        }
        DotFormat::Txt => one(text::write(&matrices()?)),
        DotFormat::Idx => {
            let params = index::Params::new(medium.device, first.sheet, medium.pitch, embossing);
            let params = params.map_err(Error::CannotPress)?;
            Ok(vec![index::write(&matrices()?, &params)])
        }
        DotFormat::Gcode => pages.iter().map(|(page, medium)| gcode_of(page, medium)).collect(),
        DotFormat::Pixels => {
            let of = |((page, medium), matrix): (&(&Page, &DotMedium), &DotMatrix)| {
                pixels::write(matrix, medium.pitch, medium.device.has_heights(), &words(page))
            };
            Ok(pages.iter().zip(&matrices()?).map(of).collect())
        }
    }
}

/// The dots of a page whose device takes the format.
fn medium_of(page: &Page, format: DotFormat) -> Result<&DotMedium, Error> {
    match &page.medium {
        Medium::Print(_) => Err(Error::NotOfDots { format: format.name(), profile: format.example_profile() }),
        Medium::Dots(medium) => {
            format.check(medium.device)?;
            if has_other_marks(page) { Err(Error::NotAllDots) } else { Ok(medium) }
        }
    }
}

/// Whether a page has marks that are no dots: pages that the program makes have none.
fn has_other_marks(page: &Page) -> bool {
    let lines = page.figure.lines.iter().chain(page.overview.iter().flat_map(|overview| &overview.lines));
    let beside = page.orientation_mark.iter().chain(&page.registration);
    let leaders = page.braille.iter().filter_map(|text| text.leader.as_ref());
    let mut runs = lines.flat_map(|line| &line.runs).chain(beside).chain(leaders);
    let mut glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    runs.any(|run| run.pen == Pen::Stroke) || glyphs.any(|glyph| matches!(glyph.shape, Shape::Rhombus { .. }))
}

fn words(page: &Page) -> DocumentWords<'_> {
    DocumentWords {
        title: &page.title,
        description: &page.description,
        language: &page.language,
        description_language: &page.description_language,
        text: &[],
    }
}

/// What is written on pages in braille: the title, and everything in their key, set apart by a blank line.
fn text_of<'p>(pages: impl Iterator<Item = &'p Page>) -> Vec<String> {
    let all: Vec<&BrailleText> = pages.flat_map(|page| &page.braille).collect();
    let of = |role: TextRole| all.iter().filter(move |text| text.role == role);
    let title = of(TextRole::Title).next().map(|text| text.lines.clone()).unwrap_or_default();
    let key: Vec<String> = of(TextRole::Key).flat_map(|text| text.lines.clone()).collect();
    let blank = (!title.is_empty() && !key.is_empty()).then(String::new);
    title.into_iter().chain(blank).chain(key).collect()
}

/// Whether two pages can be pressed in one go. What a file tells an embosser of sheet and pitch holds for all its
/// pages.
fn is_for_same(first: &Page, medium: &DotMedium, page: &Page, own: &DotMedium, format: DotFormat) -> bool {
    let numbers = |page: &Page, medium: &DotMedium| [page.sheet[0], page.sheet[1], medium.pitch].map(f32::to_bits);
    let is_same_sheet = || numbers(first, medium) == numbers(page, own);
    medium.device == own.device && (!format.tells_embosser() || is_same_sheet())
}

fn different(first: &DotMedium, other: &DotMedium) -> Error {
    let what = if first.device == other.device {
        format!("the pages for {} have different sheets or pitches", first.device.name)
    } else {
        format!("the pages are for different devices, {} and {}", first.device.name, other.device.name)
    };
    Error::NotTogether(what)
}

/// The dots of a page on the grid of its device.
fn matrix_of(page: &Page, medium: &DotMedium) -> Result<DotMatrix, Error> {
    DotMatrix::of(page).ok_or_else(|| {
        let name = medium.device.name;
        Error::NotItsDots(format!("the page for {name} has no grid of dots that this format could hold"))
    })
}

/// The G-code of a page, whose dots lie anywhere.
fn gcode_of(page: &Page, medium: &DotMedium) -> Result<Vec<u8>, Error> {
    let DotArea::Free(reach) = medium.area else {
        let name = medium.device.name;
        return Err(Error::NotItsDots(format!("the dots of this page lie on a grid, which {name} does not have")));
    };
    let params = gcode::Params {
        limits: [reach.width(), reach.height()],
        origin: [reach.min.x, reach.min.y],
        paper_length: page.sheet[1],
        title: page.title.clone(),
        ..gcode::Params::a4()
    };
    let at: Vec<_> = dots(page).into_iter().map(|(at, _)| at).collect();
    let written = gcode::write(&at, &params).map(String::into_bytes);
    written.map_err(|refused| Error::NotItsDots(refused.to_string()))
}
