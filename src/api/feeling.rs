//! What a fingertip would feel of a page.

use super::page_options::PageOptions;
use crate::touch::{self, Ink, Report};
use crate::{Error, reading};

/// What a fingertip feels of a page's textures; made by [`feel`].
#[derive(Debug, Clone)]
pub struct Felt {
    ink: Ink,
    felt: touch::FeltCells,
    report: Report,
}

/// Feels the textures of a page with [a fingertip](PageOptions::finger_mm). `page` is an SVG file as
/// [`Page::to_svg`](crate::Page::to_svg) writes it, or as somebody changed it in an editor.
///
/// The textures are blurred as by a fingertip, and then their direction is read. This is a model that compares
/// textures well; it does not replace a reader.
///
/// ```
/// use tactograph::{Options, PageOptions, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let page = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page;
/// let felt = tactograph::feel(page.to_svg(), &PageOptions::new())?;
/// for class in &felt.report().classes {
///     let right = 100.0 * class.areas.right_of_judged();
///     println!("{}: {right:.0} % of what is judged is felt right", class.class.name());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotAPage`] if it is no such page or longer than 100 MB, [`Error::Undecodable`] if it is an SVG and broken,
/// [`Error::TooComplex`] if it has too many elements or points ([`Limits`](crate::Limits)),
/// [`Error::TooLargeToFeel`] if a side of what is drawn is longer than 700 mm, [`Error::TooMuchMemory`] if it would
/// take more than [`Limits::default`](crate::Limits) to draw, [`Error::NoSuchFinger`], or [`Error::Cancelled`].
pub fn feel(page: impl AsRef<[u8]>, options: &PageOptions) -> Result<Felt, Error> {
    felt(page.as_ref(), options.finger, &|| options.go_on())
}

/// As [`feel`]; `go_on` is asked between the textures.
pub(super) fn felt(page: &[u8], finger: f32, go_on: &dyn Fn() -> Result<(), Error>) -> Result<Felt, Error> {
    let ink = Ink::of_page(&reading::text_of(page)?, go_on)?;
    go_on()?;
    let felt = ink.felt(finger)?;
    go_on()?;
    let report = touch::report(&ink, &felt);
    Ok(Felt { ink, felt, report })
}

impl Felt {
    /// The shares that are felt right, unclear and wrong, class by class. Its `Display` is a text of some sentences.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// A map as a PNG picture: each class that is felt has its pattern and its name, crosses stand where another class
    /// is felt than is meant, rings where it is unclear.
    ///
    /// # Errors
    /// [`Error::NoMemory`] if there is no memory for it.
    pub fn to_png(&self) -> Result<Vec<u8>, Error> {
        touch::map::png(&self.ink, &self.felt).ok_or(Error::NoMemory { what: "the map" })
    }
}

#[cfg(test)]
mod tests;
