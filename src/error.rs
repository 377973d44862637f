//! What stops everything. Each message says what is wrong and what to do about it, in one line without the file's name
//! (the caller knows it).

use crate::profile::Fault;
use crate::touch::FINGERS;
use crate::units::Size;

/// Why no page could be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// There are no bytes at all.
    #[error("the file is empty; give a picture")]
    Empty,
    /// The bytes begin like no format that is read here.
    #[error(
        "this is not a picture in a format that is read here (JPEG, PNG, WebP, TIFF, BMP, GIF, PNM, SVG{}){}",
        if cfg!(feature = "pdf") { ", PDF" } else { "" },
        hint(.looks_like)
    )]
    UnknownFormat {
        /// What the bytes look like instead, if that can be told: "text", "PDF".
        looks_like: Option<&'static str>,
    },
    /// The format is known but the bytes cannot be decoded.
    #[error(
        "the {format} picture cannot be read: {why}; open and save it again in another program, or use another copy"
    )]
    Undecodable {
        /// Name of the format, such as "JPEG".
        format: &'static str,
        /// What its decoder says.
        why: String,
    },
    /// More pixels than the limit allows.
    #[error("the picture has {size} pixels, which is over the limit of {limit_megapixels} megapixels; {remedy}")]
    TooManyPixels {
        /// What the picture's header says.
        size: Size,
        /// The limit in force, in millions of pixels.
        limit_megapixels: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// Decoding would take more memory than the limit allows.
    #[error(
        "decoding this {format} of {size} pixels would take about {needed_mb} MB of memory, over the limit of \
         {limit_mb} MB; {remedy}"
    )]
    TooMuchMemory {
        /// Name of the format, such as "TIFF".
        format: &'static str,
        /// What the picture's header says.
        size: Size,
        /// Megabytes that decoding would take.
        needed_mb: u64,
        /// The limit in force, in megabytes.
        limit_mb: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// What a compressed file holds takes more memory than the limit allows.
    #[error("{what} of this {format} unpacks to more than the limit of {limit_mb} MB; {remedy}")]
    UnpacksTooFar {
        /// Name of the format, such as "PDF".
        format: &'static str,
        /// Which part of it: "the drawing", "a page".
        what: &'static str,
        /// The limit in force, in megabytes.
        limit_mb: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// Too few pixels, or a shape too narrow for anything to be felt in it.
    #[error("the picture has {size} pixels: {why}")]
    TooSmall {
        /// What the picture's header says.
        size: Size,
        /// What would do.
        why: String,
    },
    /// The part of the picture that is asked for is not in it.
    #[error("the part {part} reaches beyond the picture, which has {size} pixels; give a part that lies in it")]
    NotInPicture {
        /// The part, as it was asked for.
        part: String,
        /// The whole picture.
        size: Size,
    },
    /// The part of the figure that is asked for is not in it.
    #[error(
        "the part {part} reaches beyond the figure, which is {width:.1} x {height:.1} mm and {size} pixels; give a \
         part that lies in it, from the figure's top left corner"
    )]
    NotInFigure {
        /// The part, as it was asked for.
        part: String,
        /// The picture.
        size: Size,
        /// Width of the figure, mm.
        width: f32,
        /// Height of the figure, mm.
        height: f32,
    },
    /// A part of the picture is asked for in mm before the figure is laid out.
    #[error("the part {part} is in mm, and the figure is laid out of that part; give it in pixels or in percent")]
    PartInMm {
        /// The part, as it was asked for.
        part: String,
    },
    /// The document does not have the page that is asked for.
    #[error("there is no page {page}: {}", has_pages(.pages))]
    NoSuchPage {
        /// The page, counted from 1.
        page: u32,
        /// How many there are.
        pages: usize,
    },
    /// The figure would be wider than the sheet has room for.
    #[error(
        "a figure {wanted} mm wide does not fit; {most:.1} mm is the most for this picture on this sheet{}, so take \
         that or a larger sheet",
        or_without(.without_overview)
    )]
    TooWide {
        /// Width that was asked for, mm.
        wanted: f32,
        /// The most there is room for, mm.
        most: f32,
        /// The most without the overview, mm, where that is enough.
        without_overview: Option<f32>,
    },
    /// The width asked for is no length.
    #[error("a figure cannot be {wanted} mm wide; give a width above 0")]
    NoWidth {
        /// Width that was asked for, mm.
        wanted: f32,
    },
    /// The sheets that a picture is to be spread over have no room for it.
    #[error(
        "{grid} sheets of this size have no room for a picture; take a larger sheet, or lessen page.margin or \
         sheets.overlap"
    )]
    NoRoomOnSheets {
        /// How many sheets across and down.
        grid: String,
    },
    /// A mark would lie off the sheet.
    #[error("the page does not fit its sheet: {0}; give more margin or thinner lines")]
    OffSheet(String),
    /// A number on a page is not finite, or a length is below 0.
    #[error("a page cannot have a {what} of {value}")]
    NoMeasure {
        /// Of what it is the measure.
        what: &'static str,
        /// The number that was given.
        value: f32,
    },
    /// There are no pages to write.
    #[error("there are no pages to write; give at least one")]
    NoPages,
    /// The sheet is too small for what must be on it.
    #[error(
        "a sample of {sample} has no room between the margins of a sheet of {sheet}; take larger paper or less margin"
    )]
    NoRoom {
        /// Its size.
        sample: String,
        /// The sheet's size.
        sheet: String,
    },
    /// The device cannot press what is asked for; every reason is listed.
    #[error("{}", .0.join("; "))]
    CannotPress(Vec<String>),
    /// More pixels than a picture of the page may have.
    #[error(
        "at {dpi} dots per inch the page would have {size} pixels, over the limit of {limit_megapixels} megapixels; \
         take fewer dots per inch"
    )]
    TooFine {
        /// The picture of the page.
        size: Size,
        /// What was asked for.
        dpi: u32,
        /// The limit, in millions of pixels.
        limit_megapixels: u64,
    },
    /// A picture was given as pixels, and there are not as many bytes as its size says.
    #[error("{size} pixels of RGBA take 4 bytes each, and {bytes} bytes were given")]
    WrongPixels {
        /// The size that was given.
        size: Size,
        /// How many bytes there are.
        bytes: usize,
    },
    /// A picture of a page was asked for with too few or too many pixels for an inch.
    #[error("{dpi} dots per inch are not drawn; give a number from {least} to {most}")]
    NoSuchDpi {
        /// What was asked for.
        dpi: u32,
        /// The fewest.
        least: u32,
        /// The most.
        most: u32,
    },
    /// Contours of no such strengths can be asked for.
    #[error("thresholds of {low} and {high} are not known; give two numbers from 0 up, the first not above the second")]
    NoSuchThresholds {
        /// The strength down to which a contour goes on.
        low: f32,
        /// The strength that it has somewhere.
        high: f32,
    },
    /// The text says no part of a picture.
    #[error(
        "give four numbers x,y,width,height, each in whole pixels or in percent of the picture from 0% to 100%, such \
         as 10%,0,80%,400; what is erased or kept can also be in mm of the figure, such as 10mm,5mm,30mm,20mm"
    )]
    NotACrop,
    /// The text says no grid of sheets.
    #[error("give how many sheets across and down, from 1x2 to 9x9, such as 2x2")]
    NotASheetGrid,
    /// The text is no sign of a texture.
    #[error("give dot, or rhombus and a direction from 0 to below 180 degrees, such as rhombus 45")]
    NotASign,
    /// The text says no place along a side of a picture.
    #[error("give a number of pixels, such as 412.5, or a percentage, such as 30%")]
    NotAPosition,
    /// A list of labels has rows that are none; every fault is listed, each with its line.
    #[error("{}", .0.join("; "))]
    NotLabels(Vec<String>),
    /// The page is larger than can be felt.
    #[error(
        "the figure is {width} x {height} mm, and at most {longest} x {longest} mm can be felt; \
         check the page's size in mm"
    )]
    TooLargeToFeel {
        /// Width of all that is drawn, mm.
        width: f32,
        /// Its height, mm.
        height: f32,
        /// The limit, mm.
        longest: f32,
    },
    /// There is no such fingertip, mm.
    #[error(
        "a fingertip of {0} mm is not known; give one from {low} to {high} mm",
        low = FINGERS.start(),
        high = FINGERS.end()
    )]
    NoSuchFinger(f32),
    /// What is to be read as a page is none: another kind of file, an SVG without the layers of a page, or one of an
    /// impossible size. What is an SVG and broken is [`Error::Undecodable`].
    #[error("this cannot be read as a page: {why}; {remedy}")]
    NotAPage {
        /// What it is instead, or what it lacks.
        why: &'static str,
        /// What the user can do.
        remedy: &'static str,
    },
    /// What is to be converted is a page already.
    #[error(
        "this is a page that tactograph made, and no picture; render it to write it in another format or for \
         another device"
    )]
    IsAPage,
    /// There is nothing of this name.
    #[error("there is no {what} called {name:?}; take one of {known}")]
    NoSuchName {
        /// Of what kind it would be.
        what: &'static str,
        /// What was asked for.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A language in which nothing is said of pages.
    #[error("there are no sentences in the language {language}; take one of {known}")]
    NoSentences {
        /// What was asked for.
        language: String,
        /// The languages that there are.
        known: String,
    },
    /// Lines are given that belong to another picture, or another part of it.
    #[error(
        "the lines given are of a figure {lines:.2} times as wide as high, and the picture is {picture:.2} times; \
         give the lines of a page of this picture, and the same part of it"
    )]
    OtherShape {
        /// Width of the figure of the lines by its height.
        lines: f32,
        /// The same of the picture.
        picture: f32,
    },
    /// Lines or areas are given of a page that shows another part of the picture.
    #[error(
        "the page given as lines or areas shows {page}, and {drawn} is to be drawn: its lines would lie over something \
         else; draw the same part of the picture as that page, or give a page of this part"
    )]
    OtherPart {
        /// What the page shows.
        page: String,
        /// What is to be drawn.
        drawn: String,
    },
    /// There is no memory left.
    #[error("there is no memory for {what}")]
    NoMemory {
        /// For what.
        what: &'static str,
    },
    /// The caller did not want it any more: see [`Options::cancelled`](crate::Options::cancelled).
    #[error("cancelled; no page was made")]
    Cancelled,
    /// The profile cannot be used; every fault is listed.
    #[error("{}", crate::profile::faults_in_one_line(.0))]
    Profile(Vec<Fault>),
}

impl Error {
    /// Its kind as a word for programs, such as `too-wide`, which stays the same when the sentence changes.
    pub fn id(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::UnknownFormat { .. } => "unknown-format",
            Self::Undecodable { .. } => "undecodable",
            Self::TooManyPixels { .. } => "too-many-pixels",
            Self::TooMuchMemory { .. } => "too-much-memory",
            Self::UnpacksTooFar { .. } => "unpacks-too-far",
            Self::TooSmall { .. } => "too-small",
            Self::NotInPicture { .. } => "not-in-picture",
            Self::NotInFigure { .. } => "not-in-figure",
            Self::PartInMm { .. } => "part-in-mm",
            Self::NoSuchPage { .. } => "no-such-page",
            Self::TooWide { .. } => "too-wide",
            Self::NoWidth { .. } => "no-width",
            Self::NoRoomOnSheets { .. } => "no-room-on-sheets",
            Self::OffSheet(..) => "off-sheet",
            Self::NoMeasure { .. } => "no-measure",
            Self::NoPages => "no-pages",
            Self::NoRoom { .. } => "no-room",
            Self::CannotPress(..) => "cannot-press",
            Self::TooFine { .. } => "too-fine",
            Self::WrongPixels { .. } => "wrong-pixels",
            Self::NoSuchDpi { .. } => "no-such-dpi",
            Self::NoSuchThresholds { .. } => "no-such-thresholds",
            Self::NotACrop => "not-a-crop",
            Self::NotASheetGrid => "not-a-sheet-grid",
            Self::NotASign => "not-a-sign",
            Self::NotAPosition => "not-a-position",
            Self::NotLabels(..) => "not-labels",
            Self::TooLargeToFeel { .. } => "too-large-to-feel",
            Self::NoSuchFinger(..) => "no-such-finger",
            Self::NotAPage { .. } => "not-a-page",
            Self::IsAPage => "is-a-page",
            Self::NoSuchName { .. } => "no-such-name",
            Self::NoSentences { .. } => "no-sentences",
            Self::OtherShape { .. } => "other-shape",
            Self::OtherPart { .. } => "other-part",
            Self::NoMemory { .. } => "no-memory",
            Self::Cancelled => "cancelled",
            Self::Profile(..) => "profile",
        }
    }
}

/// The one of `all` that is called `name`; `what` says of what kind they are.
///
/// # Errors
/// [`Error::NoSuchName`] with the names that there are.
pub(crate) fn named<T: Copy>(
    name: &str,
    what: &'static str,
    all: impl IntoIterator<Item = T> + Clone,
    name_of: impl Fn(T) -> &'static str,
) -> Result<T, Error> {
    let found = all.clone().into_iter().find(|one| name_of(*one) == name);
    found.ok_or_else(|| {
        let known: Vec<&str> = all.into_iter().map(name_of).collect();
        Error::NoSuchName { what, name: name.to_owned(), known: known.join(", ") }
    })
}

impl From<Vec<Fault>> for Error {
    fn from(faults: Vec<Fault>) -> Self {
        Self::Profile(faults)
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self::Profile(vec![fault])
    }
}

fn or_without(overview: &Option<f32>) -> String {
    overview.map_or_else(String::new, |most| format!(", or {most:.1} mm without the overview (overview = false)"))
}

fn has_pages(pages: &usize) -> String {
    match pages {
        1 => "the file has one page; leave the page out, or give 1".to_owned(),
        _ => format!("the document has {pages} pages; give a number from 1 to {pages}"),
    }
}

fn hint(looks_like: &Option<&'static str>) -> String {
    looks_like.map_or_else(String::new, |what| format!("; it looks like {what}"))
}
