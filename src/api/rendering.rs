//! Pages in: read, and made ready for their own device or another one.

use std::fmt;
use std::sync::Arc;

use super::caller::Caller;
use crate::braille::Translate;
use crate::listing::first_few;
use crate::page::{BrailleText, InSet, MediumParams, Page, TextRole};
use crate::pipeline::{
    self, Adapted, AsRendered, Drawing, Event, Fit, KeySheets, KeyWanted, OldPage, Request, Stage, Watch, run_stage,
};
use crate::profile::{Plan, Profile};
use crate::raster::decode::Limits;
use crate::reading::{self, Reading};
use crate::{About, Error, Note, Reason};

/// How a page is rendered. A builder, owned and cheap to clone as [`Options`](crate::Options); what is not set has a
/// default.
#[derive(Clone, Default)]
#[non_exhaustive]
#[must_use]
pub struct RenderOptions {
    profile: Option<Profile>,
    title: Option<String>,
    key: KeySheets,
    translate: Option<Arc<Translate>>,
    caller: Caller,
}

impl RenderOptions {
    /// The page on its own paper or device, with a key only where words are abbreviated that were not before.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lays the page out anew for another paper or device. Default: its own.
    pub fn profile(mut self, profile: Profile) -> Self {
        self.profile = Some(profile);
        self
    }

    /// What the page is called, in place of what it was. Where it is laid out anew for a [profile](Self::profile), the
    /// title is written in braille above the figure, as [`Options::title`](crate::Options::title) says; on its own
    /// paper or device a title in braille stays as it is, and that is told. Default: its own.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// When there is a key. Default: where words are abbreviated that were not before, where the key that was made with
    /// the page no longer fits it, and as [`convert`](crate::convert) makes one where another profile is asked for.
    pub fn key(mut self, key: KeySheets) -> Self {
        self.key = key;
        self
    }

    /// Writes words anew in the cells that it gives, as [`Options::translator`](crate::Options::translator) says: for
    /// pages in contracted braille, by [`language_of_page`]. Words of a page that stays on its device stay as they are,
    /// but for those that a person typed. Default: the table of the page's language.
    pub fn translator(mut self, translate: impl Fn(&str) -> Result<Vec<u8>, String> + Send + Sync + 'static) -> Self {
        self.translate = Some(Arc::new(translate));
        self
    }

    /// Is told of stages and of the share of the work that is done, as [`Options::progress`](crate::Options::progress)
    /// is: [`Stage::Decode`] is the page that is read, and only a page that is laid out anew has stages between that
    /// and [`Stage::Page`]. Default: nobody is told.
    pub fn progress(mut self, told: impl Fn(Event) + Send + Sync + 'static) -> Self {
        self.caller.on_progress(told);
        self
    }

    /// Is asked between stages whether the result is still wanted, as
    /// [`Options::cancelled`](crate::Options::cancelled) is. Default: it is always wanted.
    pub fn cancelled(mut self, asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        self.caller.on_question(asked);
        self
    }
}

impl fmt::Debug for RenderOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let profile = self.profile.as_ref().map(|profile| &profile.name);
        f.debug_struct("RenderOptions").field("profile", &profile).field("key", &self.key).finish_non_exhaustive()
    }
}

/// Reads a page from its SVG, as [`Page::to_svg`](crate::Page::to_svg) wrote it and somebody may have changed it, so
/// that it can be written in any format.
///
/// Without a [profile](RenderOptions::profile) it stays on its paper or device: what lies in its layers is taken as it
/// is, only widths of lines are brought into the range of its profile, and signs of textures give way to lines that
/// were drawn. With a profile it is laid out anew for that: lines and areas keep their places in the figure, and
/// textures, overview, frame and braille are made for the new paper or device. What was taken otherwise than it looks,
/// or left out, is in [`Drawing::notes`].
///
/// ```
/// use tactograph::{DotFormat, Embossing, Options, Profile, RenderOptions};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let svg = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page.to_svg();
/// // ... somebody corrects the page in an editor ...
/// let pdf = tactograph::render(&svg, &RenderOptions::new())?.page.to_pdf();
/// let embosser = RenderOptions::new().profile(Profile::named("index-basic-d")?);
/// // the overview may be a sheet of its own
/// let sheets = tactograph::render(&svg, &embosser)?.into_pages();
/// let dots = tactograph::write_dots("coffee", &sheets, DotFormat::Idx, Embossing::default())?;
/// # let _ = (pdf, dots);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotAPage`] if it is none; [`Error::Undecodable`] if it is broken, [`Error::TooComplex`] if it is over a
/// limit of elements or points; [`Error::Profile`] with the faults of the profile; [`Error::TooNarrow`] if the figure
/// would have a side below its `figure.min_side` there;
/// [`Error::OffSheet`] if a mark would lie off the sheet; [`Error::Cancelled`].
pub fn render(svg: impl AsRef<[u8]>, options: &RenderOptions) -> Result<Drawing, Error> {
    options.caller.watched(Stage::Page, |watch| rendered(svg.as_ref(), options, watch))
}

fn rendered(svg: &[u8], options: &RenderOptions, watch: &mut Watch<'_>) -> Result<Drawing, Error> {
    let mut read = run_stage(watch, Stage::Decode, || reading::read(svg))?;
    let mut notes = std::mem::take(&mut read.notes);
    options.caller.go_on()?;
    if let Some(title) = options.title.as_deref() {
        read.page = read.page.called(Some(title), None, None);
    }
    let (own, refused) = Profile::of_origin(&read.page.origin)?;
    notes.extend(refused);
    let own = Plan::new(&own)?;
    let was_mirrored = read.page.is_mirrored();
    let for_another = options.profile.is_some();
    let AsRendered { adapted, read, turned_over } =
        pipeline::as_rendered(read, &own, for_another, options.translate.as_deref())?;
    let page = AdaptedPage { options, read: &read, own: &own, adapted: &adapted, was_mirrored, turned_over };
    let mut drawing = match &options.profile {
        None => run_stage(watch, Stage::Page, || page.as_it_is(notes))?,
        Some(profile) => page.laid_out_anew(profile, notes, watch)?,
    };
    Note::sort(&mut drawing.notes);
    Ok(drawing)
}

/// A page that was read, as its own paper or device takes it.
struct AdaptedPage<'a> {
    options: &'a RenderOptions,
    read: &'a Reading,
    /// What it was made with.
    own: &'a Plan,
    adapted: &'a Adapted,
    was_mirrored: bool,
    /// Whether it is here as it is felt, and not as it was read.
    turned_over: bool,
}

impl AdaptedPage<'_> {
    fn request<'r>(&'r self, plan: &'r Plan, mirrored: bool, cancelled: &'r (dyn Fn() -> bool + Sync)) -> Request<'r> {
        let page = &self.adapted.page;
        Request {
            plan,
            limits: Limits::default(),
            fonts: &Arc::default,
            title: &page.title,
            language: &page.description_language,
            fit: Fit { mirrored, ..Fit::default() },
            cancelled,
        }
    }

    /// On its own paper or device.
    fn as_it_is(&self, mut notes: Vec<Note>) -> Result<Drawing, Error> {
        let Self { options, read, own, adapted, was_mirrored, turned_over } = self;
        let Adapted { page, notes: more, of_places, of_overview, abbreviates, .. } = adapted;
        notes.extend(more.iter().chain(of_places).cloned());
        notes.extend(overview_stays(of_overview.as_deref(), page, read));
        notes.extend(options.title.as_deref().and_then(|title| title_stays(title, page)));
        let wanted = KeyWanted { key: options.key, abbreviates: *abbreviates, is_changed: read.is_changed };
        let cancelled = || options.caller.has_cancelled();
        let request = self.request(own, *was_mirrored, &cancelled);
        let key = pipeline::key_of_page(page, wanted, options.translate.as_deref(), &request)?;
        notes.extend(key.notes);
        let page = if key.sheets.is_empty() { page.clone() } else { page.clone().with_key(&key.told) };
        let page = if *turned_over { page.mirrored() } else { page };
        let key = in_language(key.sheets, &page);
        Ok(Drawing::of_key(page, key, notes))
    }

    /// For another paper or device.
    fn laid_out_anew(&self, profile: &Profile, mut notes: Vec<Note>, watch: &mut Watch<'_>) -> Result<Drawing, Error> {
        let Self { options, read, own, adapted, was_mirrored, .. } = *self;
        let Adapted { page, lines, areas, notes: more, of_overview, .. } = adapted;
        let mut profile = profile.clone();
        // of one of several sheets there is no overview: that of all is a sheet of its own
        if page.is_sheet_of_set() {
            profile.set("overview.on", "false")?;
        }
        let plan = Plan::new(&profile)?;
        // no paper is printed on its back
        let mirrored = was_mirrored && matches!(plan.medium(), MediumParams::Dots { .. });
        if was_mirrored && !mirrored {
            notes.push(Note::TakenAs(About::Marks, Reason::Mirrored, FROM_THE_BACK.to_owned().into()));
        }
        // words are placed anew, wherever they stand on the page
        notes.retain(|note| !matches!(note, Note::TakenAs(About::Braille | About::Leaders | About::Print, ..)));
        // rows of dots have no width
        let are_dots = matches!(plan.medium(), MediumParams::Dots { .. });
        let holds = |note: &&Note| !are_dots || !matches!(note, Note::TakenAs(_, Reason::WidthOutOfRange, _));
        notes.extend(more.iter().filter(holds).cloned());
        notes.extend(overview_drawn_of(of_overview.as_deref(), page, &plan));
        notes.extend(placed_anew(&read.moved_texts));
        let old = OldPage { page, lines, areas, title: options.title.as_deref(), plan: own };
        let cancelled = || options.caller.has_cancelled();
        let request = self.request(&plan, mirrored, &cancelled);
        let mut drawing = pipeline::redraw(old, options.key, options.translate.as_deref(), &request, watch)?;
        // words of a person stay, those of ours are of the new page
        let own_words = (!pipeline::is_made(page)).then_some(page.description.as_str());
        drawing.page = drawing.page.called(None, own_words, Some(&page.language));
        drawing.key = in_language(drawing.key, page);
        // who asks for another code or grade wants other cells
        let [before, after] = [own, &plan].map(|plan| (plan.profile().braille.code, plan.profile().braille.grade));
        if before == after {
            notes.extend(in_other_cells(page, &drawing.page));
        }
        // what is so on the page and on the new one is told once
        notes.retain(|note| !drawing.notes.contains(note));
        notes.append(&mut drawing.notes);
        Ok(Drawing { notes, ..drawing })
    }
}

/// What is told of a mirrored page that is rendered for a paper.
const FROM_THE_BACK: &str = "the page is mirrored, for a machine that presses it from the back, and this paper is \
                             read from the side that is printed: left and right are exchanged again";

/// What is told of the overview of a page that is written as it is: what is unlike the figure, or that it has a sheet
/// of its own.
fn overview_stays(unlike: Option<&str>, page: &Page, read: &Reading) -> Option<Note> {
    let has_own_sheet = InSet::of(page) == Some(InSet::Followed) && !read.names.by_hand.is_empty();
    let own = "the overview of this page has a sheet of its own, and is as it was: change it there too, or lay this \
               page out anew for its device, which draws it of the figure";
    let told = unlike.map(|told| format!("the overview is as it was: {told}; change it there too, or delete it"));
    let told = told.or_else(|| has_own_sheet.then(|| own.to_owned()));
    told.map(|told| Note::TakenAs(About::Overview, Reason::OverviewStays, told.into()))
}

/// What is told of a title in braille that is not the one that a page is given, and stays on its paper or device.
fn title_stays(title: &str, page: &Page) -> Option<Note> {
    let of_page = page.braille.iter().find(|text| text.role == TextRole::Title && text.text != title)?;
    let told = format!(
        "the title in braille is as it was ({}); to have it written anew, lay the page out anew for a profile, such as \
         its own",
        of_page.text
    );
    Some(Note::TakenAs(About::Braille, Reason::TitleStays, told.into()))
}

/// What is told of the overview of a page that is laid out anew, which is drawn of the one that the page has.
fn overview_drawn_of(unlike: Option<&str>, page: &Page, plan: &Plan) -> Option<Note> {
    plan.layout().overview?;
    // one without lines is drawn of the figure
    page.overview.as_ref().filter(|overview| !overview.lines.is_empty())?;
    let where_it_is = match plan.medium() {
        MediumParams::Print(_) => "the overview",
        MediumParams::Dots { .. } => "the overview, on a sheet of its own,",
    };
    let told = unlike.map(|unlike| {
        format!(
            "{where_it_is} is drawn of that of the page that was read: {unlike}; change it on that page too, or delete \
             it there, and it is drawn of the figure"
        )
    });
    told.map(|told| Note::TakenAs(About::Overview, Reason::OverviewOfPage, told.into()))
}

/// What is told of words that a person moved on a page that is laid out anew.
fn placed_anew(moved: &[String]) -> Option<Note> {
    let (was, it_has) = if moved.len() == 1 { ("was", "it has its place") } else { ("were", "they have their places") };
    let named = first_few(moved, MOST_NAMED, String::clone);
    (!moved.is_empty()).then(|| {
        let told = format!(
            "{named} {was} moved on the page, and {it_has} anew here: words stay where they were moved to only on the \
             page's own paper or device"
        );
        Note::TakenAs(About::Braille, Reason::PlacedAnew, told.into())
    })
}

/// Most texts that are named.
const MOST_NAMED: usize = 5;

/// Tells of words that stand in other cells than on the page that was read, which another table wrote.
fn in_other_cells(before: &Page, after: &Page) -> Option<Note> {
    // without blanks and hyphens, as lines may be divided elsewhere
    let cells = |text: &BrailleText| -> String {
        text.lines.concat().chars().filter(|cell| !matches!(cell, '\u{2800}' | '\u{2824}')).collect()
    };
    let whole = |page: &'_ Page| -> Vec<BrailleText> {
        page.braille.iter().filter(|text| text.abbreviation.is_none()).cloned().collect()
    };
    let after = whole(after);
    let is_other = |text: &&BrailleText| {
        let same = |other: &&BrailleText| other.role == text.role && other.text == text.text;
        // the unit of a number may stand with one of its axis only, and is no other table's
        let is_part = |a: &str, b: &str| a.starts_with(b) || b.starts_with(a);
        after.iter().find(same).is_some_and(|other| !is_part(&cells(other), &cells(text)))
    };
    let count = whole(before).iter().filter(is_other).count();
    (count > 0).then_some(Note::InOtherCells(count))
}

/// Sheets of a key, whose titles are in the language of the page's.
fn in_language(key: Vec<Page>, page: &Page) -> Vec<Page> {
    key.into_iter().map(|sheet| sheet.called(None, None, Some(&page.language))).collect()
}

impl Profile {
    /// The profile that a page was made with, as its SVG says: what [`render`] takes if no other is given. What the
    /// page does not say, or says of a profile that is not known, is that of the first of [`Profile::built_in`].
    ///
    /// # Errors
    /// [`Error::NotAPage`] if it is none; [`Error::Undecodable`] if it is broken, [`Error::TooComplex`] if over a
    /// limit.
    pub fn of_page(svg: impl AsRef<[u8]>) -> Result<Self, Error> {
        Ok(Self::of_origin(&reading::read(svg.as_ref())?.page.origin)?.0)
    }
}

/// The language of a page's words (BCP 47), such as `de`: what a [translator](RenderOptions::translator) is chosen by.
///
/// # Errors
/// [`Error::NotAPage`] if it is none; [`Error::Undecodable`] if it is broken, [`Error::TooComplex`] if over a limit.
pub fn language_of_page(svg: impl AsRef<[u8]>) -> Result<String, Error> {
    Ok(reading::read(svg.as_ref())?.page.language.clone())
}
