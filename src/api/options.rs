//! Everything that a caller may choose for one picture.

use std::fmt;
use std::sync::Arc;

use super::caller::Caller;
use super::fonts::Fonts;
use crate::braille::{Code, Translate};
use crate::page::{LANGUAGE, Page, PartShown};
use crate::pipeline::{
    self, Event, Fit, Given, GivenLines, HandLines, KeySheets, Label, LineName, Position, TextReader, Words,
};
use crate::profile::{Plan, Profile};
use crate::raster::crop::Crop;
use crate::raster::decode::Limits;
use crate::reading::{self, Reading, TypedText};
use crate::{About, Error, Note, Reason};

/// How a picture is converted: a profile, and what is chosen anew for each picture. A builder: what is not set has a
/// default that does for most pictures. It owns all it holds, can be sent between threads, and clones are cheap enough
/// to make one for each picture.
///
/// ```
/// use tactograph::{Options, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?)
///     .title("A cup of coffee")
///     .crop("10%,0,80%,100%".parse()?)
///     .width_mm(150.0);
/// # let _ = options;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
#[non_exhaustive]
#[must_use]
pub struct Options {
    pub(super) profile: Profile,
    pub(super) picture_name: Option<String>,
    title: Option<String>,
    description: Option<String>,
    language: Option<String>,
    labels: Vec<Label>,
    label_texts: bool,
    key: KeySheets,
    page_number: Option<u32>,
    translate: Option<Arc<Translate>>,
    pub(super) fit: Fit,
    pub(super) limits: Limits,
    pub(super) fonts: Fonts,
    pub(super) given: Given,
    pub(super) caller: Caller,
}

/// What a picture without a name and a title is called.
const NAMELESS: &str = "picture";

impl Options {
    /// Everything as the profile says, the whole picture, as large as the sheet allows. The profile is checked when a
    /// picture is converted; [`Profile::check`] does it before.
    pub fn new(profile: Profile) -> Self {
        Self {
            profile,
            picture_name: None,
            title: None,
            description: None,
            language: None,
            labels: Vec::new(),
            label_texts: false,
            key: KeySheets::default(),
            page_number: None,
            translate: None,
            fit: Fit::default(),
            limits: Limits::default(),
            fonts: Fonts::none(),
            given: Given::default(),
            caller: Caller::default(),
        }
    }

    /// The same for another profile.
    pub fn with_profile(self, profile: Profile) -> Self {
        Self { profile, ..self }
    }

    /// What the page is called: shown by viewers, read out by screen readers, and written in braille above the figure
    /// unless `braille.on` of the profile is off. Default: the picture's name, which is not written.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// The picture's own name, such as that of its file: it is written into the page with how the page was made.
    /// Default: the title, or "picture" where there is none.
    pub fn picture_name(mut self, name: impl Into<String>) -> Self {
        self.picture_name = Some(name.into());
        self
    }

    /// What is on the page, for screen readers. Default: what [`describe`](crate::describe) says of its marks.
    pub fn description(mut self, description: impl Into<String>) -> Self {
        self.description = Some(description.into());
        self
    }

    /// The languages whose words can be written in braille without a [translator](Options::translator), as tags of BCP
    /// 47: those that [`Options::language`] has a code for.
    pub fn languages() -> impl Iterator<Item = &'static str> {
        Code::all().iter().map(|code| code.language)
    }

    /// Language of title and description as a tag of BCP 47, such as `de` or `fr-CA`; braille is written in its code,
    /// one of [`Options::languages`], unless `braille.code` of the profile names another. The description that is made
    /// if none is given is in it too, if it is one of [`Description::languages`](crate::Description::languages), else
    /// in English. Default: `en`.
    pub fn language(mut self, tag: impl Into<String>) -> Self {
        self.language = Some(tag.into());
        self
    }

    /// Labels in braille, each beside its point of the picture: apart from lines and from one another, with a
    /// leader line where they lie further away, abbreviated where there is no room for more. The page tells
    /// what is left out, and why, in [`Note::LabelsLeftOut`](crate::Note::LabelsLeftOut). They are in the language of
    /// the title. At most 300 of at most 1000 characters each; what is beyond is told, too. Default: none.
    pub fn labels(mut self, labels: Vec<Label>) -> Self {
        self.labels = labels;
        self
    }

    /// Makes the texts of an SVG drawing or a page of PDF labels in braille, where they stand, and those of a bitmap
    /// that a [text reader](Options::text_reader) has read. Those of SVG drawings need a font, as without one
    /// nobody knows where they stand: see [`Fonts`](crate::Fonts). Default: false, they are left out.
    pub fn label_texts(mut self, label: bool) -> Self {
        self.label_texts = label;
        self
    }

    /// When there is a key, which follows on sheets of its own in [`Drawing::key`](crate::Drawing::key): the
    /// colours that occur with their textures, and abbreviations. Default: where labels are abbreviated.
    pub fn key(mut self, key: KeySheets) -> Self {
        self.key = key;
        self
    }

    /// The page number in braille of the first sheet, at the top on the right; those that follow (an overview on a
    /// sheet of its own, the key) have the next. A number
    /// that has no room beside the title is left out, and told. Default: none, but a key of several sheets is numbered
    /// from 1.
    pub fn page_number(mut self, number: u32) -> Self {
        self.page_number = Some(number);
        self
    }

    /// Writes words in braille, in place of the table of the language: for contracted braille (`braille.grade`), say.
    /// Gets a title, a label or an entry of the key as one line, with single blanks between its words, and gives its
    /// cells, a byte each: bit 0 is dot 1, bit 5 dot 6, 0 a blank, at which lines may be divided. Or it says why it
    /// cannot, in a line for the maker of the page; such a text is left out and told
    /// ([`Note::NotTranslated`](crate::Note::NotTranslated)), and so is one with dots 7 or 8. Page numbers and
    /// abbreviations are spelled by the table of the language, where there is one, and by the translator only without.
    /// Is called from the thread that converts, for a text perhaps more than once, and has to give the same each time.
    /// Default: the table of the language.
    pub fn translator(mut self, translate: impl Fn(&str) -> Result<Vec<u8>, String> + Send + Sync + 'static) -> Self {
        self.translate = Some(Arc::new(translate));
        self
    }

    /// Reads the text that is found in pixels: gets pictures (PNG, black on white, level) of a line each, and gives as
    /// many texts, empty where it cannot read one; or says why it cannot read at all, which is told in
    /// [`Note::TextsNotRead`](crate::Note::TextsNotRead), as is another number of texts. Is called from the thread that
    /// converts, at most once for a picture. Default: nobody knows what such texts say.
    pub fn text_reader(
        mut self,
        read: impl Fn(&[Vec<u8>]) -> Result<Vec<String>, String> + Send + Sync + 'static,
    ) -> Self {
        self.given.text_reader = Some(TextReader::new(read));
        self
    }

    /// The page of a document (PDF, with the feature `pdf`), counted from 1. Any other picture is one page. A page that
    /// is not there is refused with [`Error::NoSuchPage`](crate::Error::NoSuchPage). Default: the first, with a
    /// [`Note`](crate::Note) if there are more.
    pub fn page(mut self, page: u32) -> Self {
        self.fit.page = Some(page);
        self
    }

    /// Draws a part of the picture only, as if the rest were not there.
    pub fn crop(mut self, crop: Crop) -> Self {
        self.fit.crop = Some(crop);
        self
    }

    /// Width of the figure on the sheet, mm, above 0; the height follows. More than there is room for is refused with
    /// [`Error::TooWide`](crate::Error::TooWide), less than the profile's `figure.min_side` on the shorter side with
    /// [`Error::NotWideEnough`](crate::Error::NotWideEnough), what is no length with
    /// [`Error::NoWidth`](crate::Error::NoWidth). Default: as wide as the sheet has room for.
    pub fn width_mm(mut self, width: f32) -> Self {
        self.fit.width = Some(width);
        self
    }

    /// Exchanges left and right, marks and frames included, for machines that press a page up from its back. Not for
    /// swell paper. Default: false.
    pub fn mirrored(mut self, mirrored: bool) -> Self {
        self.fit.mirrored = mirrored;
        self
    }

    /// Draws the letters of texts, as lines like any others; otherwise texts are left out, and told: those of SVG
    /// drawings and pages of PDF, and what looks like text in the pixels of any picture. Default: false.
    pub fn keep_text(mut self, keep: bool) -> Self {
        self.fit.keep_text = keep;
        self
    }

    /// Draws the ground of a scan or photograph of a drawing in its colour, as a poster's; otherwise, where it can be
    /// paper in uneven light or tinted paper, it is blank, and told. The same of the dark or white rim of a scanned
    /// photograph, which otherwise is left out. Default: false.
    pub fn keep_ground(mut self, keep: bool) -> Self {
        self.fit.keep_ground = keep;
        self
    }

    /// Takes the lines of the figure from a page, an SVG that [`Page::to_svg`] wrote and somebody may have changed, or
    /// from any SVG, of one with a layer (a group) that is called "lines" those in it; or from a picture of lines,
    /// black on white and of the shape of the part that is drawn, along the middle of its strokes. Colours, textures,
    /// overview and frame are made around them. All of them are drawn that have room: `lines.detail` counts as 1 and
    /// `lines.shapes` as 0. The page has to show the same part of the picture; one that says that it shows another is
    /// refused when the picture is converted ([`Error::OtherPart`]). Called again, the last counts.
    ///
    /// # Errors
    /// Of an SVG [`Error::NotAPage`] where its sheet is smaller than 5 mm or larger than 2500 mm, and
    /// [`Error::Undecodable`] or [`Error::TooComplex`] where it is broken or over a limit. Of a picture what its header
    /// says: [`Error::Empty`], [`Error::UnknownFormat`], [`Error::Undecodable`], [`Error::TooComplex`],
    /// [`Error::Locked`] or [`Error::TooFewPixels`]. What only its pixels,
    /// the [limits](Options::limits) or the other picture can tell is refused when that is converted:
    /// [`Error::OtherShape`] above all.
    pub fn lines(mut self, lines: impl AsRef<[u8]>) -> Result<Self, Error> {
        self.given.lines = Some(if reading::is_svg(lines.as_ref()) {
            let (lines, notes) = self.hand_lines(lines.as_ref())?;
            self.given.notes.of_lines = notes;
            GivenLines::Vectors(lines)
        } else {
            let picture = GivenLines::picture(lines.as_ref())?;
            self.given.notes.of_lines.clear();
            picture
        });
        Ok(self)
    }

    /// Adds the lines of a page, or of any SVG as [`Options::lines`] takes them, to those that are found. What is found
    /// along them, too near, gives way. Called again, the last counts.
    ///
    /// # Errors
    /// As [`Options::lines`] of an SVG; [`Error::NotAPage`] of anything else.
    pub fn add_lines(mut self, svg: impl AsRef<[u8]>) -> Result<Self, Error> {
        let (lines, notes) = self.hand_lines(svg.as_ref())?;
        (self.given.added, self.given.notes.of_added) = (Some(lines), notes);
        Ok(self)
    }

    /// Takes the areas of textures from a page that somebody changed, in place of the colours of the picture: an
    /// area that was deleted stays blank, one that was moved to another group of textures has the colour of that,
    /// and a shape that was drawn and filled with a colour is an area of it. Called again, the last counts.
    ///
    /// # Errors
    /// [`Error::NotAPage`] if it is no SVG or has none of the layers of a page, and [`Error::Undecodable`] or
    /// [`Error::TooComplex`] where it is broken or over a limit.
    pub fn areas(mut self, svg: impl AsRef<[u8]>) -> Result<Self, Error> {
        let GivenPage { read, plan, mut notes } = GivenPage::of(reading::read(svg.as_ref())?)?;
        let (areas, told) = pipeline::areas_of(&read.page, &read.names.areas, &read.areas, &plan);
        self.given.part_of_areas = PartShown::of(&read.page);
        self.given.drawn_areas = read.areas;
        self.given.areas = Some(areas);
        notes.extend(told);
        self.given.notes.of_areas = notes;
        Ok(self)
    }

    /// Leaves a part of the picture blank, without lines and textures; of the part that is drawn, where there is a
    /// crop. In mm it is a part of the figure, from its top left corner. Can be called several times.
    pub fn erase(mut self, part: Crop) -> Self {
        self.given.erased.push(part);
        self
    }

    /// Leaves the picture blank outside this part, which stays as large and where it is; the opposite of
    /// [`Options::erase`]. Called several times, what is in any of the parts is kept.
    pub fn keep(mut self, part: Crop) -> Self {
        self.given.kept.push(part);
        self
    }

    /// Says what the picture is about, by a place on it, from the left and from the top, with a
    /// [crop](Options::crop) of its part: the thing around it that stands out is outlined before all else, in figure
    /// and overview. Can be called several times, for at most 100 places. Where nothing is found,
    /// [`Note::NoSubject`](crate::Note::NoSubject) tells. Default: what stands out most comes first.
    pub fn subject(mut self, x: Position, y: Position) -> Self {
        self.given.subjects.push([x, y]);
        self
    }

    /// Leaves out what is not of the [subject](Options::subject): textures, weak lines (narrower than
    /// `lines.width_max`) and outlines of other regions. Without a subject that is found nothing changes. Default:
    /// false.
    pub fn calm_background(mut self, calm: bool) -> Self {
        self.given.calm_background = calm;
        self
    }

    /// What decoding the picture may cost. Default: [`Limits::default`].
    pub fn limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// Fonts for drawings with text; a PNG with words in print is [given them](crate::Page::to_png) again. Default:
    /// [`Fonts::none`].
    pub fn fonts(mut self, fonts: Fonts) -> Self {
        self.fonts = fonts;
        self
    }

    /// Is told of every stage as it begins and ends, for timings, and of the share of the work that is done, for
    /// progress bars ([`Event::Done`]); from the threads that the stages run on, one call at a time. Default: nobody is
    /// told.
    ///
    /// ```
    /// use tactograph::{Event, Options, Profile};
    ///
    /// let options = Options::new(Profile::named("swell-a4")?).progress(|event| {
    ///     if let Event::Done(share) = event {
    ///         println!("{:.0} %", 100.0 * share);
    ///     }
    /// });
    /// let drawing = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?;
    /// # let _ = drawing;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn progress(mut self, told: impl Fn(Event) + Send + Sync + 'static) -> Self {
        self.caller.on_progress(told);
        self
    }

    /// Is asked between stages, from the thread that converts, whether the result is still wanted; once it is not, the
    /// work ends with [`Error::Cancelled`](crate::Error::Cancelled). A stage takes a fraction of a second on a photo of
    /// 12 megapixels; where many labels look for room, the last one takes longer, and so does decoding a drawing with
    /// filters, up to about 10 s (more is refused with [`Error::TooComplex`](crate::Error::TooComplex)). Default: it is
    /// always wanted.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::sync::atomic::{AtomicBool, Ordering};
    /// use tactograph::{Error, Options, Profile};
    ///
    /// let stop = Arc::new(AtomicBool::new(false)); // set by a button, say
    /// let asked = Arc::clone(&stop);
    /// let options = Options::new(Profile::named("swell-a4")?).cancelled(move || asked.load(Ordering::Relaxed));
    /// stop.store(true, Ordering::Relaxed);
    /// let drawing = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options);
    /// assert_eq!(drawing.err(), Some(Error::Cancelled));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cancelled(mut self, asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        self.caller.on_question(asked);
        self
    }

    /// The lines of a page as its own profile means them, and what is told of it.
    fn hand_lines(&mut self, svg: &[u8]) -> Result<(HandLines, Vec<Note>), Error> {
        let GivenPage { read, plan, mut notes } = GivenPage::of(reading::read_any(svg)?)?;
        let page = &read.page;
        notes.extend(pipeline::dots_left_out(page, &plan));
        self.given.texts_of_page = page.braille.len();
        let names = LineName::of(&read.names);
        let lines = HandLines::of_figure(page, &plan)?.called(names).beside_areas(read.areas);
        notes.extend(lines.told_outside());
        if page.figure.lines.is_empty() {
            notes.push(pipeline::told_no_lines("draw some in a layer that is called Lines, and show it"));
        }
        Ok((lines, notes))
    }

    /// The profile.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The picture's name as it is written into the page.
    pub(super) fn name(&self) -> &str {
        self.picture_name.as_deref().or(self.title.as_deref()).unwrap_or(NAMELESS)
    }

    /// What a document of all pages of the picture is called: the title, or the picture's name where there is none.
    pub fn document_title(&self) -> &str {
        self.title.as_deref().unwrap_or_else(|| self.name())
    }

    /// A page with the words that were given for the picture, and with `title`.
    pub(super) fn with_words(&self, page: Page, title: Option<&str>) -> Page {
        page.called(title, self.description.as_deref(), self.language.as_deref())
    }

    pub(super) fn own_title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    pub(super) fn own_language(&self) -> &str {
        self.language.as_deref().unwrap_or(LANGUAGE)
    }

    /// What is written in braille.
    pub(super) fn words(&self) -> Words<'_> {
        Words {
            title: self.own_title(),
            language: self.language.as_deref(),
            labels: &self.labels,
            own_texts: self.label_texts,
            key: self.key,
            number: self.page_number,
            translate: self.translate.as_deref(),
            ..Words::default()
        }
    }
}

/// A page of which lines or areas are taken, as its picture lies.
struct GivenPage {
    read: Reading,
    /// What it was made with.
    plan: Plan,
    /// What was taken otherwise than it looks, and what is not taken.
    notes: Vec<Note>,
}

impl GivenPage {
    /// # Errors
    /// If the profile that it names has faults.
    fn of(mut read: Reading) -> Result<Self, Error> {
        let mut notes = std::mem::take(&mut read.notes);
        notes.extend(not_written(&read.texts));
        let (own, refused) = Profile::of_origin(&read.page.origin)?;
        notes.extend(refused);
        let plan = Plan::new(&own)?;
        if read.page.is_mirrored() {
            read = pipeline::as_felt(read, &plan);
        }
        Ok(Self { read, plan, notes })
    }
}

/// What is told of texts that were typed into a page of which lines or areas are taken.
fn not_written(texts: &[TypedText]) -> Option<Note> {
    let [first, ..] = texts else { return None };
    let (string, at) = (&first.string, first.at);
    let texts = match texts.len() {
        1 => format!("the text \"{string}\" that was typed at {:.0}, {:.0} mm", at.x, at.y),
        count => format!("{count} texts that were typed, the first \"{string}\" at {:.0}, {:.0} mm", at.x, at.y),
    };
    let why = "lines and areas are taken from a corrected page, and no words; give them as labels";
    Some(Note::NotOnPage(About::Texts, Reason::WordsOfPage, format!("{texts}: {why}").into()))
}

impl fmt::Debug for Options {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { profile, picture_name, title, description, language, labels, label_texts, key, .. } = self;
        let Self { fit, limits, fonts, .. } = self;
        f.debug_struct("Options")
            .field("profile", &profile.name)
            .field("picture_name", picture_name)
            .field("title", title)
            .field("description", description)
            .field("language", language)
            .field("labels", labels)
            .field("label_texts", label_texts)
            .field("key", key)
            .field("fit", fit)
            .field("limits", limits)
            .field("fonts", fonts)
            .finish_non_exhaustive()
    }
}
