//! Whether a page is legible, and the page in sentences.

use usvg::ImageHrefResolver;

use super::feeling::felt;
use super::page_options::{PageOptions, USUAL_FINGER};
use crate::description::{self, Description};
use crate::legibility::{self, Checked, Drawn, Fingertip, Render, Rule};
use crate::page::{Figure, Page, Parts};
use crate::profile::{Plan, Profile};
use crate::raster::decode::{check_canvases, checked_document, tree_of};
use crate::reading::Reading;
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect, Size};
use crate::wording::Wording;
use crate::{Error, Note, Reason, pipeline, reading};

/// Holds a page against the rules of legibility: the SVG of a page, as [`Page::to_svg`](crate::Page::to_svg) writes it
/// or as somebody changed it in an editor. A drawing that has no layers of a page is judged as ink. What
/// [`render`](crate::render) puts right on a page that somebody changed is a warning that says so
/// ([`Finding::mended`](crate::Finding::mended)), unless a [profile](PageOptions::profile) is asked for.
///
/// ```
/// use tactograph::{Options, PageOptions, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let svg = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page.to_svg();
/// let checked = tactograph::check(&svg, &PageOptions::new())?;
/// assert_eq!(checked.errors(), 0, "{checked}");
/// std::fs::write(std::env::temp_dir().join("marked.svg"), checked.marked(&svg)?)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotAPage`] if it is no SVG, [`Error::Undecodable`] if it is one that is broken, [`Error::TooComplex`] if it
/// is over a limit,
/// [`Error::TooMuchMemory`] if it would take more than [`Limits::default`](crate::Limits) to draw,
/// [`Error::Profile`] if the profile has faults, [`Error::Cancelled`].
pub fn check(page: impl AsRef<[u8]>, options: &PageOptions) -> Result<Checked, Error> {
    let bytes = page.as_ref();
    let read = match reading::read(bytes) {
        Ok(read) => Some(read),
        Err(why @ Error::NotAPage { .. }) if !reading::is_drawing(bytes) => return Err(why),
        Err(Error::NotAPage { .. }) => None,
        Err(other) => return Err(other),
    };
    checked(bytes, read.as_ref(), options)
}

/// The check of a page that was read, or of a drawing that is none.
fn checked(bytes: &[u8], read: Option<&Reading>, options: &PageOptions) -> Result<Checked, Error> {
    let go_on = || options.go_on();
    go_on()?;
    let text = reading::text_of(bytes)?;
    let document = document(&text)?;
    let nothing = ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let parsing = usvg::Options { image_href_resolver: nothing, ..usvg::Options::default() };
    let tree = tree_of(&document, &parsing)?;
    legibility::canvas_of(&tree).map_or(Ok(()), |size| check_canvases(&tree, legibility::to_canvas(), size))?;
    go_on()?;
    let is_written_anew = options.profile.is_none() && read.is_some_and(|read| read.is_changed);
    let render = if is_written_anew { Render::Mends } else { Render::LeavesAsItIs };
    let drawn = Drawn { document: &document, tree: &tree, render };
    let Some(read) = read else {
        let corner = MmPoint::new(tree.size().width(), tree.size().height()) * MM_PER_CSS_PX;
        let place = MmRect::new(MmPoint::zero(), corner);
        let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
        let empty = Page::new(Parts::of([corner.x, corner.y], figure))?;
        let letters = reading::letters_of(bytes)?;
        return Ok(drawn.check_as_ink(&empty, &letters, &options.plan(&empty.origin)?.limits()));
    };
    let limits = options.plan(&read.page.origin)?.limits();
    let felt = match felt(bytes, USUAL_FINGER, &go_on) {
        // also a page whose layers have labels and no ids of ours
        felt @ (Ok(_) | Err(Error::TooLargeToFeel { .. } | Error::NotAPage { .. })) => felt,
        Err(why) => return Err(why),
    };
    let fingertip = match &felt {
        Ok(felt) => Fingertip::Felt(felt.report()),
        Err(Error::TooLargeToFeel { .. }) => Fingertip::TooLarge,
        Err(_) => Fingertip::NotAsked,
    };
    let (own, refused) = Profile::of_origin(&read.page.origin)?;
    let mut notes = read.notes.clone();
    // they are findings, with their places
    notes.retain(|note| !matches!(note, Note::NotOnPage(_, Reason::Elsewhere | Reason::Pixels, _)));
    if options.profile.is_none() {
        notes.extend(refused);
    } else {
        notes.retain(|note| !matches!(note, Note::TakenAs(_, Reason::NoMetadata, _)));
    }
    // strokes are judged as the dots that the device presses for them
    let as_dots = pipeline::with_strokes_as_dots(read, &Plan::new(&own)?)?;
    let read = as_dots.as_ref().map_or(read, |(read, _)| read);
    let checked = drawn.check(read, &limits, fingertip, &go_on)?;
    notes.extend(legibility::told_left_out(&read.page));
    notes.extend(as_dots.iter().flat_map(|(_, told)| told).cloned());
    Ok(Checked { notes, ..checked })
}

/// # Errors
/// [`Error::Undecodable`] and [`Error::TooComplex`].
fn document(text: &str) -> Result<usvg::roxmltree::Document<'_>, Error> {
    checked_document(text)
}

impl Checked {
    /// The page that was checked, an SVG, with a layer on top, `findings`, in which a box is drawn around each finding.
    /// It takes the place of one that is there.
    ///
    /// # Errors
    /// [`Error::NotAPage`] if it is no SVG, [`Error::Undecodable`] if it is one that is broken, and
    /// [`Error::TooComplex`] if it is over a limit.
    pub fn marked(&self, page: impl AsRef<[u8]>) -> Result<String, Error> {
        Ok(legibility::marked(&document(&reading::text_of(page.as_ref())?)?, self))
    }
}

impl Rule {
    /// The number that it asks for on pages of a profile, and its unit (`mm`, `square mm`, `%`, `dots`, `textures`);
    /// none where it has none.
    ///
    /// # Errors
    /// [`Error::Profile`] if the profile has faults.
    pub fn limit(&self, profile: &Profile) -> Result<Option<(f32, &'static str)>, Error> {
        Ok(self.number(&Plan::new(profile)?.limits()))
    }

    /// All rules as a text, one a line, with their numbers for pages of a profile.
    ///
    /// # Errors
    /// [`Error::Profile`] if the profile has faults.
    pub fn listed(profile: &Profile) -> Result<String, Error> {
        Ok(legibility::rules_as_text(&Plan::new(profile)?.limits()))
    }

    /// All rules as JSON, with their numbers for pages of a profile: an array of objects with `rule`, `severity`,
    /// `number` and `unit` (null where it asks for none), `asks`, `source` and `remedy`.
    ///
    /// # Errors
    /// [`Error::Profile`] if the profile has faults.
    pub fn listed_as_json(profile: &Profile) -> Result<String, Error> {
        Ok(legibility::rules_as_json(&Plan::new(profile)?.limits()))
    }
}

/// Describes a page in plain sentences, the most important first: the SVG of a page, as
/// [`Page::to_svg`](crate::Page::to_svg) writes it or as somebody changed it in an editor. What somebody drew or typed
/// is told as [`render`](crate::render) makes it. The last sentence is the verdict of [`check`], which is part of the
/// work; its findings are not told. Without a [language](PageOptions::language) the sentences are in that of the page's
/// own description, and in English where that is none of [`Description::languages`].
///
/// ```
/// use tactograph::{Options, PageOptions, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?).title("A cup of coffee");
/// let svg = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page.to_svg();
/// let described = tactograph::describe(&svg, &PageOptions::new())?;
/// let about: Vec<&str> = described.sentences.iter().map(|(about, _)| *about).collect();
/// assert_eq!((about[0], about[1], about[about.len() - 1]), ("title", "sheet", "verdict"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`check`], [`Error::NotAPage`] also of a drawing that has no layers of a page, and [`Error::NoSuchName`] of a
/// language that is none of [`Description::languages`].
pub fn describe(page: impl AsRef<[u8]>, options: &PageOptions) -> Result<Description, Error> {
    let wording = options.language.as_deref().map(|tag| {
        let known: Vec<&str> = Wording::languages().collect();
        Wording::of_language(tag)
            .ok_or_else(|| Error::no_such_name("language of descriptions", tag, &known, Vec::new()))
    });
    let wording = wording.transpose()?;
    let bytes = page.as_ref();
    let read = reading::read(bytes)?;
    let checked = checked(bytes, Some(&read), options)?;
    options.go_on()?;
    let wording = wording.unwrap_or_else(|| Wording::nearest(&read.page.description_language));
    // what somebody drew or typed is told as render makes it
    let plan = Plan::new(&Profile::of_origin(&read.page.origin)?.0)?;
    let rendered = pipeline::as_rendered(read, &plan, false, None)?;
    let page = rendered.adapted.page;
    let page = if rendered.turned_over { page.mirrored() } else { page };
    Ok(description::describe(&page, &checked.verdict, wording))
}
