//! Pages in: read, and made ready for their own device or another one.

use std::sync::Arc;

use crate::Error;
use crate::pipeline::{self, Drawing, Fit, Request, Settled};
use crate::profile::{Plan, Profile};
use crate::raster::decode::Limits;
use crate::reading;

/// Reads a page from its SVG, as [`Page::to_svg`](crate::Page::to_svg) wrote it and somebody may have changed it, so
/// that it can be written in any format.
///
/// Without `profile` it stays on its paper or device: what lies in its layers is taken as it is, only widths of lines
/// are brought into the range of its profile, and signs of textures give way to lines that were drawn. With `profile`
/// it is laid out anew for that: lines and areas keep their places in the figure, and textures, overview, frame and
/// braille are made for the new paper or device. What was taken otherwise than it looks, or left out, is in
/// [`Drawing::notes`].
///
/// ```
/// use tactograph::{DotFormat, Options, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let svg = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page.to_svg();
/// // ... somebody corrects the page in an editor ...
/// let pdf = tactograph::render(&svg, None)?.page.to_pdf();
/// let dots = tactograph::render(&svg, Some(&Profile::named("index-basic-d")?))?.page.to_dots(DotFormat::Idx)?;
/// # let _ = (pdf, dots);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotAPage`] if it is none; [`Error::Undecodable`] if it is broken or over a limit; faults of the profile.
pub fn render(svg: impl AsRef<[u8]>, profile: Option<&Profile>) -> Result<Drawing, Error> {
    let mut read = reading::read(svg.as_ref())?;
    let mut notes = std::mem::take(&mut read.notes);
    let own = Plan::new(&Profile::of_page(&read.page.origin)?)?;
    let Settled { page, names, notes: more } = pipeline::settle(&read, &own)?;
    notes.extend(more);
    let Some(profile) = profile else {
        return Ok(Drawing { page, overview: None, key: Vec::new(), texts: Vec::new(), notes });
    };
    let plan = Plan::new(profile)?;
    let request = Request {
        plan: &plan,
        limits: Limits::default(),
        fonts: &Arc::default,
        title: &page.title,
        language: &page.description_language,
        fit: Fit::default(),
        cancelled: &|| false,
    };
    let mut drawing = pipeline::redraw((&page, &names), &own, &request, &mut |_| ())?;
    // words of a person stay, those of ours are of the new page
    let own_words = (!pipeline::is_made(&page)).then_some(page.description.as_str());
    drawing.page = drawing.page.called(None, own_words, Some(&page.language));
    notes.append(&mut drawing.notes);
    Ok(Drawing { notes, ..drawing })
}

/// The profile that a page was made with, as its SVG says: what [`render`] takes if no other is given. What the page
/// does not say, or says of a profile that is not known, is that of the first of [`Profile::built_in`].
///
/// # Errors
/// As [`render`].
pub fn profile_of_page(svg: impl AsRef<[u8]>) -> Result<Profile, Error> {
    Profile::of_page(&reading::read(svg.as_ref())?.page.origin)
}
