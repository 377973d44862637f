//! Whether a page is legible, and the page in sentences.

use usvg::{ImageHrefResolver, Tree};

use super::feeling::feel;
use crate::description::{self, Description};
use crate::legibility::{self, Checked, Drawn, Fingertip, Render};
use crate::page::{Figure, Page, Parts};
use crate::profile::{Plan, Profile};
use crate::raster::decode::checked_document;
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect, Size};
use crate::wording::Wording;
use crate::{Error, pipeline, reading};

/// Fingertip by which textures are judged, mm.
const FINGER: f32 = 1.0;

/// Holds a page against the rules of legibility: the SVG of a page, as [`Page::to_svg`](crate::Page::to_svg) writes it
/// or as somebody changed it in an editor. Its numbers are those of `profile` or, without one, of the profile that the
/// page says it was made with; a page of an unknown profile, and a drawing, are held against the first of
/// [`Profile::built_in`]. A drawing that has no layers of a page is judged as ink. What [`render`](crate::render) puts
/// right on a page that somebody changed is a warning that says so ([`Finding::mended`](crate::Finding::mended)),
/// unless a `profile` is given.
///
/// ```
/// use tactograph::{Options, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let page = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page;
/// let checked = tactograph::check(page.to_svg(), None)?;
/// assert_eq!(checked.errors(), 0, "{checked}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotAPage`] or [`Error::Undecodable`] if it is no SVG that can be read, [`Error::Profile`] if the profile
/// has faults.
pub fn check(page: impl AsRef<[u8]>, profile: Option<&Profile>) -> Result<Checked, Error> {
    Ok(check_marked(page, profile)?.0)
}

/// As [`check`], and the page with a layer on top, `findings`, in which a box is drawn around each finding.
///
/// # Errors
/// As [`check`].
pub fn check_marked(page: impl AsRef<[u8]>, profile: Option<&Profile>) -> Result<(Checked, String), Error> {
    let bytes = page.as_ref();
    let read = match reading::read(bytes) {
        Ok(read) => Some(read),
        Err(why @ Error::NotAPage(_)) if !reading::is_drawing(bytes) => return Err(why),
        Err(Error::NotAPage(_)) => None,
        Err(other) => return Err(other),
    };
    let undecodable = |why: String| Error::Undecodable { format: "SVG", why: why.replace(['\n', '\r'], " ") };
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let document = checked_document(text).map_err(undecodable)?;
    let nothing = ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = usvg::Options { image_href_resolver: nothing, ..usvg::Options::default() };
    let tree = Tree::from_xmltree(&document, &options).map_err(|fault| undecodable(fault.to_string()))?;
    let is_written_anew = profile.is_none() && read.as_ref().is_some_and(|read| read.is_changed);
    let render = if is_written_anew { Render::Mends } else { Render::LeavesAsItIs };
    let drawn = Drawn { document: &document, tree: &tree, render };
    let limits = |page: &Page| match profile {
        Some(profile) => Ok::<_, Error>(Plan::new(profile)?.limits()),
        None => Ok(Plan::new(&Profile::of_page(&page.origin)?.0)?.limits()),
    };
    let empty = || {
        let corner = MmPoint::new(tree.size().width(), tree.size().height()) * MM_PER_CSS_PX;
        let place = MmRect::new(MmPoint::zero(), corner);
        let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
        Page::new(Parts::of([corner.x, corner.y], figure))
    };
    let checked = match read {
        Some(read) => {
            let limits = limits(&read.page)?;
            let felt = feel(bytes, FINGER);
            let fingertip = match &felt {
                Ok(felt) => Fingertip::Felt(felt.report()),
                Err(Error::TooLargeToFeel { .. }) => Fingertip::TooLarge,
                // a page whose layers have labels and no ids of ours
                Err(_) => Fingertip::NotAsked,
            };
            let checked = drawn.check(&read, &limits, fingertip);
            let mut notes = read.notes;
            if profile.is_none() {
                notes.extend(Profile::of_page(&read.page.origin)?.1);
            }
            Checked { notes, ..checked }
        }
        None => {
            let sheet = empty()?;
            drawn.check_as_ink(&sheet, &limits(&sheet)?)
        }
    };
    let marked = legibility::marked(&document, &checked);
    Ok((checked, marked))
}

/// The rules that pages are held against, one a line, with their numbers for pages of a profile.
///
/// # Errors
/// [`Error::Profile`] if the profile has faults.
pub fn rules(profile: &Profile) -> Result<String, Error> {
    Ok(legibility::rules_as_text(&Plan::new(profile)?.limits()))
}

/// Describes a page in plain sentences, the most important first: the SVG of a page, as
/// [`Page::to_svg`](crate::Page::to_svg) writes it or as somebody changed it in an editor. The last sentence is the
/// verdict of [`check`], with the numbers of `profile` or of the profile that the page was made with. `language` is a
/// tag of BCP 47: `en`, `de`, `es`, `fr` or `pl`; without it the language of the page's own description is taken.
///
/// # Errors
/// As [`check`], [`Error::NotAPage`] of a drawing that has no layers of a page, and [`Error::NoSentences`] of another
/// language.
pub fn describe(
    page: impl AsRef<[u8]>,
    profile: Option<&Profile>,
    language: Option<&str>,
) -> Result<Description, Error> {
    let wording = language.map(|tag| {
        Wording::of_language(tag).ok_or_else(|| Error::NoSentences {
            language: tag.to_owned(),
            known: Wording::languages().collect::<Vec<_>>().join(", "),
        })
    });
    let wording = wording.transpose()?;
    let bytes = page.as_ref();
    let read = reading::read(bytes)?;
    let checked = check(bytes, profile)?;
    let wording = wording.unwrap_or_else(|| Wording::nearest(&read.page.description_language));
    // what somebody drew or typed is told as render makes it
    let page = if read.areas.is_empty() && read.texts.is_empty() {
        read.page
    } else {
        let plan = Plan::new(&Profile::of_page(&read.page.origin)?.0)?;
        pipeline::adapted(&read, &plan, None)?.page
    };
    Ok(description::describe(&page, &checked.verdict, wording))
}
