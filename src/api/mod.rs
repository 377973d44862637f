//! What the crate offers to those who use it: functions that take a picture and [`Options`], and give what they own.
//!
//! Everything is done below, in the pipeline and the writers; here profiles are checked and options handed on.

mod caller;
mod checking;
mod feeling;
mod fonts;
mod options;
mod page_options;
mod rendering;
mod writing;

pub use checking::{check, describe};
pub use feeling::{Felt, feel};
pub use fonts::Fonts;
pub use options::Options;
pub use page_options::PageOptions;
pub use rendering::{RenderOptions, language_of_page, render};
pub use writing::write_pdf;

use crate::page::Page;
use crate::page::spread::SheetGrid;
use crate::picture::{Picture, PixelSource};
use crate::pipeline::sheets::{self, Sheets};
use crate::pipeline::trace::{self, Traced, Tracing};
use crate::pipeline::{self, Drawing, Request, Stage, Watch};
use crate::profile::{Plan, Profile};
use crate::raster::decode;
use crate::{Error, calibration, output, reading};

/// Makes the page of a picture. The same picture and options give the same page, however many threads there are.
///
/// ```
/// use tactograph::{Options, Profile};
///
/// let profile = Profile::named("swell-a4")?;
/// let options = Options::new(profile).title("A cup of coffee").width_mm(150.0);
/// let drawing = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?;
/// assert_eq!(drawing.page.figure.place.width().round(), 150.0);
/// assert!(drawing.page.to_svg().contains("<title>A cup of coffee</title>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// * [`Error::Profile`] with every fault of the profile.
/// * Of the picture: [`Error::Empty`], [`Error::UnknownFormat`], [`Error::Undecodable`], [`Error::Locked`],
///   [`Error::IsAPage`], [`Error::NoSuchPage`]; over a [limit](crate::Limits) [`Error::TooManyPixels`],
///   [`Error::TooMuchMemory`] or [`Error::UnpacksTooFar`], over one that stays [`Error::TooComplex`];
///   [`Error::TooFewPixels`] with fewer than 8 pixels a side.
/// * Of the part that is drawn, and of those that are erased or kept: [`Error::NotInPicture`], [`Error::PartInMm`],
///   [`Error::NotInFigure`].
/// * Of the sheet: [`Error::NoWidth`], [`Error::TooWide`]; with a side below `figure.min_side` [`Error::NotWideEnough`]
///   where a width was asked for, and else [`Error::TooNarrow`]; [`Error::OffSheet`] if a mark would lie off it.
/// * [`Error::OtherPart`] if lines or areas that were given are of a page of another part of the picture, and
///   [`Error::OtherShape`] if lines are of another picture; of those that are a picture also what only
///   its pixels tell.
/// * [`Error::Cancelled`].
///
/// Everything less is in [`Drawing::notes`].
pub fn convert<'p>(picture: impl Into<Picture<'p>>, options: &Options) -> Result<Drawing, Error> {
    let picture = not_a_page(picture)?;
    let drawing = with_request(options, options.name(), Stage::Page, |request, watch| {
        pipeline::convert_with_words(picture, &options.words(), &options.given, request, watch)
    })?;
    let page = options.with_words(drawing.page, options.own_title());
    let of_overview = options.own_title().map(|title| pipeline::title_of_overview(title, options.own_language()));
    let overview = drawing.overview.map(|page| page.called(of_overview.as_deref(), None, None));
    let of_key = options.own_title().map(|title| pipeline::title_of_key(title, options.own_language()));
    let key = drawing.key.into_iter().map(|page| page.called(of_key.as_deref(), None, None)).collect();
    Ok(Drawing { page, overview, key, ..drawing })
}

/// Makes the pages of a picture that is spread over several sheets, laid side by side: the overview on a sheet of its
/// own if the profile has one, then the picture row by row. It is drawn once and cut, so what two sheets both show is
/// the same on both. Without `grid` there are as few sheets as have room for [`Options::width_mm`], and two where no
/// width is asked for. The title stands on every sheet, and a label on those that show all of it.
///
/// # Errors
/// As [`convert`], and [`Error::NoRoomOnSheets`] if the sheets, at most [`SheetGrid::MOST`] across and down, have no
/// room for a picture between their overlaps.
pub fn convert_to_sheets<'p>(
    picture: impl Into<Picture<'p>>,
    grid: Option<SheetGrid>,
    options: &Options,
) -> Result<Sheets, Error> {
    let picture = not_a_page(picture)?;
    let drawn = with_request(options, options.document_title(), Stage::Page, |request, watch| {
        sheets::convert(picture, &options.words(), &options.given, grid, request, watch)
    })?;
    // The maker's words are about the picture, which all sheets show together.
    let worded = |page: Page| options.with_words(page, None);
    let (overview, pages) = (drawn.overview.map(worded), drawn.pages.into_iter().map(worded).collect());
    let of_key = options.own_title().map(|title| pipeline::title_of_key(title, options.own_language()));
    let key = drawn.key.into_iter().map(|page| page.called(of_key.as_deref(), None, None)).collect();
    Ok(Sheets { overview, pages, key, ..drawn })
}

/// Finds the contours of a picture, as data: for programs that go on with them. Lines that are given or added, and what
/// is erased, count as on a page, and for [`Tracing::lines`] so does what the picture is about. All words (title,
/// description, language, labels, key, page number and what goes with them), areas, mirroring and what reads text have
/// no meaning here.
///
/// ```
/// use tactograph::{Options, Profile, Tracing};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let traced = tactograph::trace(&std::fs::read("samples/coffee.png")?, &Tracing::contours(), &options)?;
/// let rings = traced.trace.polylines.iter().filter(|polyline| polyline.closed).count();
/// assert!(rings > 0);
/// std::fs::write(std::env::temp_dir().join("coffee.json"), traced.trace.to_json())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`convert`], but for [`Error::OffSheet`].
pub fn trace<'p>(picture: impl Into<Picture<'p>>, tracing: &Tracing, options: &Options) -> Result<Traced, Error> {
    let picture = not_a_page(picture)?;
    with_request(options, options.name(), tracing.last_stage(), |request, watch| {
        trace::trace(picture, tracing, &options.given, request, watch)
    })
}

/// Makes the calibration sheets of a profile: samples of lines, gaps, braille, frames, glyphs and textures, to be
/// printed once and felt, so that a workshop finds the numbers for its own paper; for a device of dots samples of its
/// pitch, gaps, weights of lines, frames and textures. One page a sheet, as many as the samples take.
///
/// # Errors
/// [`Error::Profile`] with every fault of the profile, [`Error::NoRoom`] if its sheet has no room for a sample.
pub fn calibrate(profile: &Profile) -> Result<Calibration, Error> {
    let plan = Plan::new(profile)?;
    Ok(Calibration { title: calibration::title(&plan), pages: calibration::sheets(&plan)? })
}

/// Calibration sheets; made by [`calibrate`].
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Calibration {
    /// What they are called together, as a document.
    pub title: String,
    /// The sheets, each with what is on it in its description.
    pub pages: Vec<Page>,
}

/// A picture that is none of our pages: converting one would draw its frame as lines.
///
/// # Errors
/// [`Error::IsAPage`] if it is one, and [`Error::IsAPageIn`] if it is one as a PDF or PNG.
fn not_a_page<'p>(picture: impl Into<Picture<'p>>) -> Result<Picture<'p>, Error> {
    let picture = picture.into();
    match picture.0 {
        PixelSource::File(bytes) if reading::is_page(bytes) || is_packed_page(bytes) => Err(Error::IsAPage),
        PixelSource::File(bytes) => match output::written_as(bytes) {
            Some(format) => Err(Error::IsAPageIn { format }),
            None => Ok(picture),
        },
        PixelSource::Rgba8 { .. } => Ok(picture),
    }
}

/// Whether a file is a page that was compressed with gzip, as an editor saves SVGZ.
fn is_packed_page(bytes: &[u8]) -> bool {
    // the layer of the figure begins behind the frame, whose dots take some 50 kB
    let start = decode::start_of_packed(bytes, 1_000_000);
    start.is_some_and(|start| reading::is_page(String::from_utf8_lossy(&start).as_bytes()))
}

/// Calls `work`, which ends with the stage `last`, with what the pipeline needs, and whom it tells.
fn with_request<T>(
    options: &Options,
    title: &str,
    last: Stage,
    work: impl FnOnce(&Request<'_>, &mut Watch<'_>) -> Result<T, Error>,
) -> Result<T, Error> {
    options.given.check_parts(&options.fit)?;
    let plan = options.given.plan(&options.profile)?;
    let fonts = || options.fonts.database();
    let cancelled = || options.caller.has_cancelled();
    let request = Request {
        plan: &plan,
        limits: options.limits,
        fonts: &fonts,
        title,
        language: options.own_language(),
        fit: options.fit,
        cancelled: &cancelled,
    };
    request.go_on()?;
    options.caller.watched(last, |watch| work(&request, watch))
}
