//! Pages of dots in the files that embossers, braille programs and pin displays take.

use super::dots::{DotMatrix, Words, brf, dots, gcode, index, pef, pixels, text, ubrl};
use super::format::DotFormat;
use crate::Error;
use crate::devices::{Device, DotArea};
use crate::page::{DotMedium, Medium, Page};

/// What an Index embosser is told beside the dots; other devices ignore it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Embossing {
    /// How many copies it makes, 1 to 999.
    pub copies: u16,
    /// How hard it strikes, 1 to 3.
    pub impact: u8,
}

impl Default for Embossing {
    /// One copy, struck as usual.
    fn default() -> Self {
        Self { copies: 1, impact: 1 }
    }
}

impl Embossing {
    /// Everything for which an Index embosser refuses a sheet of this width and length, mm, dots this far apart, mm,
    /// or these numbers.
    pub fn faults(&self, device: &Device, sheet: [f32; 2], pitch: f32) -> Vec<String> {
        index::Params::new(device, sheet, pitch, self.copies, self.impact).err().unwrap_or_default()
    }
}

/// The files of pages that belong together and are called `title`: one where the format holds them all, else one a
/// page.
///
/// # Errors
/// [`Error::CannotPress`] if a page is not one of dots, its device does not take the format, or cannot reach all dots.
pub fn write(title: &str, pages: &[Page], format: DotFormat, embossing: Embossing) -> Result<Vec<Vec<u8>>, Error> {
    let pages = pages.iter().map(|page| Ok((page, medium_of(page, format)?))).collect::<Result<Vec<_>, Error>>()?;
    let matrices: Vec<DotMatrix> = pages.iter().filter_map(|(page, _)| DotMatrix::of(page)).collect();
    let one = |text: String| Ok(vec![text.into_bytes()]);
    match format {
        DotFormat::Ubrl => one(ubrl::write(&matrices)),
        DotFormat::Brf => one(brf::write(&matrices)),
        DotFormat::Pef => {
            let words = pages.first().map_or(Words::default(), |(page, _)| words(page));
            one(pef::write(&matrices, &Words { title, ..words }))
        }
        DotFormat::Txt => one(text::write(&matrices)),
        DotFormat::Idx => {
            let Some((page, medium)) = pages.first() else { return Ok(Vec::new()) };
            let Embossing { copies, impact } = embossing;
            let params = index::Params::new(medium.device, page.sheet, medium.pitch, copies, impact);
            let params = params.map_err(|faults| Error::CannotPress(faults.join("; ")))?;
            Ok(vec![index::write(&matrices, &params)])
        }
        DotFormat::Gcode => pages.iter().filter_map(|(page, medium)| gcode_of(page, medium)).collect(),
        DotFormat::Pixels => {
            let of = |((page, medium), matrix): (&(&Page, &DotMedium), &DotMatrix)| {
                pixels::write(matrix, medium.pitch, medium.device.has_heights(), &words(page))
            };
            Ok(pages.iter().zip(&matrices).map(of).collect())
        }
    }
}

/// The dots of a page whose device takes the format.
fn medium_of(page: &Page, format: DotFormat) -> Result<&DotMedium, Error> {
    match &page.medium {
        Medium::Print(_) => Err(Error::CannotPress(format!(
            "{} holds dots, and the page is for printing; take a profile for dots, such as {}",
            format.name().to_uppercase(),
            format.example_profile()
        ))),
        Medium::Dots(medium) => match format.refusal(medium.device) {
            Some(why) => Err(Error::CannotPress(why)),
            None => Ok(medium),
        },
    }
}

fn words(page: &Page) -> Words<'_> {
    Words {
        title: &page.title,
        description: &page.description,
        language: &page.language,
        description_language: &page.description_language,
    }
}

/// The G-code of a page; none where dots lie on a grid, which no machine that takes G-code has.
fn gcode_of(page: &Page, medium: &DotMedium) -> Option<Result<Vec<u8>, Error>> {
    let DotArea::Free(reach) = medium.area else { return None };
    let params = gcode::Params {
        limits: [reach.width(), reach.height()],
        origin: [reach.min.x, reach.min.y],
        paper_length: page.sheet[1],
        title: page.title.clone(),
        ..gcode::Params::a4()
    };
    let at: Vec<_> = dots(page).into_iter().map(|(at, _)| at).collect();
    let written = gcode::write(&at, &params).map(String::into_bytes);
    Some(written.map_err(|refused| Error::CannotPress(refused.to_string())))
}
