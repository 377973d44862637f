//! What the maker of a page or a trace should know and the result survives.

mod about;
mod harm;
mod order;
mod phrases;
mod reason;
mod repeats;
mod told;

use crate::braille::Code;
use crate::error::id_table;
use crate::listing::{counted, first_few};
pub use about::{About, GivenFile};
pub(crate) use phrases::LEAST_DRAWN;
pub use reason::Reason;
pub use told::Told;
pub(crate) use told::from_edges;

use phrases::{
    MOST_TEXTS, character_at, hexadecimal, it_or_them, listed, mixed_areas, most_in, mostly, no_subject, no_texts,
    or_if_none, outline_of_subject, rather_as_text, shade, share_of, short, sides, simplified, turned,
    what_if_not_meant,
};

/// One remark about a page that was made all the same. It says itself in one line, and is an error only in that it can
/// be handed on as one, to a log of warnings say.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Note {
    /// The picture's colour profile could not be used, so its numbers were taken as sRGB.
    #[error("the picture's colour profile could not be used, colours were taken as sRGB: {0}")]
    ColourProfileIgnored(String),
    /// Something in the picture is left out of the page (say a text without a font, or a linked file).
    #[error("left out: {1}")]
    LeftOut(Reason, String),
    /// Something that a person gave, or that was on a page that was read, is left out; says what, where and why.
    #[error("left out: {2}")]
    NotOnPage(About, Reason, Told),
    /// Something on the page is not in its PNG; says what, why and what to do.
    #[error("not in the PNG: {1}")]
    NotInPng(Reason, &'static str),
    /// Something on a page is taken otherwise than it looks; says what, where and as what.
    #[error("{2}")]
    TakenAs(About, Reason, Told),
    /// Something on the page is as it is all the same and breaks a rule of legibility; says what, where and what to do.
    #[error("{2}")]
    Faulty(About, Reason, String),
    /// It is about a file that was given beside the picture, and its places are in the mm of that file.
    #[error("{}", said_of_file(*.0, .1))]
    OfFile(GivenFile, Box<Note>),
    /// Of a document only the first page was taken, as no page was asked for.
    #[error("this is page 1 of {pages}; ask for another by its number")]
    FirstPageOnly {
        /// How many pages it has.
        pages: usize,
    },
    /// Texts of a drawing are left out, as letters are no lines that fingers can read; all of them.
    #[error("{} left out, as fingers cannot read letters: {}", counted(.0.len(), "text"), listed(.0))]
    TextsLeftOut(Vec<String>),
    /// Text in the pixels of the picture, or in the shapes of a drawing, is left out; what it says is not known.
    #[error(
        "{} left out, {}in the {place}, as fingers cannot read letters; {}keep the text to draw {}{}",
        counted(*.texts, "text"),
        if *.texts == 1 { "" } else { "the largest " },
        rather_as_text(*.are_shapes),
        it_or_them(*.texts),
        or_if_none(*.texts)
    )]
    LetteringLeftOut {
        /// How many lines of text there are.
        texts: usize,
        /// Where in the figure the largest of them is, in words.
        place: &'static str,
        /// Whether they are shapes of a drawing, and no pixels.
        are_shapes: bool,
    },
    /// The ground of a scan or photograph of a drawing is taken for the paper that it is on, and is blank.
    #[error(
        "the ground, {} where it is lightest, is taken for paper and is blank{}; keep the ground to draw it in its \
         colour",
        hexadecimal(*.colour),
        shade(*.darkest)
    )]
    GroundAsPaper {
        /// Its colour where it is lightest, as sRGB red, green and blue.
        colour: [u8; 3],
        /// The light of its darkest part, in percent of that of its lightest.
        darkest: u32,
    },
    /// The dark or white rim of a scanned photograph is left out: its sides, each with its width in percent.
    #[error("the rim of the scan is left out, {}; keep the ground to draw it", sides(.0))]
    RimLeftOut(Vec<(&'static str, u32)>),
    /// Text in the pixels of the picture is not read, though it should have been: why, in the words of the reader.
    #[error("the texts in the pixels are not read: {0}")]
    TextsNotRead(String),
    /// There is no braille code for the language of the words, so they are not written on the page.
    #[error(
        "nothing is written in braille, as there is no code for the language \"{}\"; there are {}; choose one \
         (braille.code), or leave braille out (braille.on = false)",
        short(.0),
        Code::all().iter().map(|code| code.language).collect::<Vec<_>>().join(", ")
    )]
    NoBrailleCode(String),
    /// The braille code lacks characters of a text, so they are left out of its braille.
    #[error(
        "left out of the braille of {}, as its code has no cells for {}: {}; write {} in words, or take a table of \
         braille that has {}",
        listed(.texts),
        it_or_them(.lacking.len()),
        first_few(.lacking, MOST_TEXTS, |&(character, at)| character_at(character, at, .texts)),
        it_or_them(.lacking.len()),
        it_or_them(.lacking.len())
    )]
    NotInBraille {
        /// The texts, each once.
        texts: Vec<String>,
        /// The characters, and which of its text's each is, from 1: of one text all of them, of several texts each
        /// once, at its first place.
        lacking: Vec<(char, usize)>,
    },
    /// So many texts of a page that was read stand in other cells of braille than before, which another table wrote.
    #[error(
        "{} {} written in other cells of braille than on the page, which another table wrote; write them with that \
         table",
        counted(*.0, "text"),
        if *.0 == 1 { "is" } else { "are" }
    )]
    InOtherCells(usize),
    /// Texts that the translator that was given could not write, so they are left out.
    #[error("{} {} not written in braille: {why}", listed(.texts), if .texts.len() == 1 { "is" } else { "are" })]
    NotTranslated {
        /// The texts.
        texts: Vec<String>,
        /// What the translator says.
        why: String,
    },
    /// Contracted braille is asked for, and nothing that writes it is given; the words are uncontracted.
    #[error(
        "braille is uncontracted although braille.grade is 2: contracted braille is written by a translator, such as \
         an installed liblouis, and none was given"
    )]
    NotContracted,
    /// The title does not stand above the figure, as there is no room for it.
    #[error(
        "the title {}: its {cells} cells have no room above the figure, where it may take three lines and a fifth of \
         the height at most; give a shorter one, or a larger sheet",
        if *.in_key { "begins the key and does not stand above the figure" } else { "is not written in braille" }
    )]
    NoRoomForTitle {
        /// How many cells it has.
        cells: usize,
        /// Whether it stands in the key.
        in_key: bool,
    },
    /// The page number is not written in braille, as there is no room for it above the figure.
    #[error(
        "the page number is not written in braille, as it has no room above the figure; take a larger sheet, or leave \
         the number out"
    )]
    NoRoomForNumber,
    /// What was found at the place that was named as the subject.
    #[error(
        "the subject at {} %, {} % is {} mm wide and {} mm high in the figure, around {} %, {} %{}{}; {}",
        .at[0], .at[1], .mm[0], .mm[1], .middle[0], .middle[1],
        mostly(*.colour),
        outline_of_subject(*.is_first, *.drawn),
        what_if_not_meant(*.fills)
    )]
    Subject {
        /// The place, percent from the left and from the top.
        at: [i32; 2],
        /// Width and height of what was found, mm in the figure.
        mm: [u32; 2],
        /// Its middle, percent from the left and from the top.
        middle: [i32; 2],
        /// The colour that most of it has, such as "red" or "white"; none if none has, or if colours are not looked at.
        colour: Option<&'static str>,
        /// Whether it is a region, whose outline is drawn first; otherwise it is what closed lines surround, which are
        /// drawn as any others.
        is_first: bool,
        /// Percent of its border that have a line in the figure; none if the page has no lines.
        drawn: Option<u32>,
        /// Whether it fills most of the figure, or reaches three of its sides, as the ground of a thing does.
        fills: bool,
    },
    /// Nothing is found at the place that was named as the subject; says why, and the place as it was given.
    #[error("{}", no_subject(*.0, .1))]
    NoSubject(Reason, String),
    /// The background was to be calm, and no subject was found.
    #[error("the background is as it would be otherwise, as no subject was found around which it could be calm")]
    NothingCalmed,
    /// Weak lines and textures around the subject are left out, as was asked: how much of contours, mm on the sheet.
    #[error(
        "around the subject {}the outlines of other regions and all textures are left out, as was asked; strong lines \
         stay",
        if *.0 > 0 { format!("weak lines ({0} mm of contours), ", .0) } else { String::new() }
    )]
    BackgroundCalmed(u32),
    /// Labels that are abbreviated on the page, as there is no room for more: the abbreviation and the text of each.
    #[error(
        "{} abbreviated for want of room: {}",
        counted(.0.len(), "word"),
        first_few(.0, MOST_TEXTS, |(brief, text)| format!("{brief} for \"{}\"", short(text)))
    )]
    Abbreviated(Vec<(String, String)>),
    /// A key is asked for, and there is none; says why.
    #[error("there is no key, as {1}")]
    NoKey(Reason, &'static str),
    /// The texts of the picture were to be labels, and it has none.
    #[error("there are no texts for labels{}", no_texts(*.are_unread))]
    NoTexts {
        /// Whether there is text in its pixels or shapes, and what it says is not known.
        are_unread: bool,
    },
    /// Labels that are not on the page.
    #[error("{} left out, as {why}: {}", counted(.texts.len(), "label"), listed(.texts))]
    LabelsLeftOut {
        /// What they say.
        texts: Vec<String>,
        /// Why, for programs.
        reason: Reason,
        /// Why, in words.
        why: &'static str,
    },
    /// No contour was found that is strong and long enough.
    #[error(
        "no contour is strong and long enough for a line, so there is no overview either; lower edges.high and \
         edges.low, or give a brighter picture, one with less around it, or one with larger parts"
    )]
    NoLines,
    /// Nothing was found to trace.
    #[error("nothing to trace: no contour is strong and long enough; lower the thresholds, or give a brighter picture")]
    NoContours,
    /// The lines of a page were to be traced, and the profile draws none.
    #[error("nothing to trace: the profile draws no lines, as figure.lines is off; turn it on, or trace contours")]
    LinesOff,
    /// Contours are not drawn, as they lie too close to others for fingers, or are too short in a drawing.
    #[error(
        "{millimetres} mm of contours, {}, were left out, {}: they lie too close to others for fingers, or are too \
         short; a larger figure, or only a part of the picture, keeps more of them{}",
        share_of(*.percent),
        most_in(*.place, "figure"),
        turned(*.is_larger_turned)
    )]
    LinesLeftOut {
        /// Their length on the sheet, mm.
        millimetres: u32,
        /// Percent of the length of all contours.
        percent: u32,
        /// Where in the figure most of them are, in words; none if they are all over it.
        place: Option<&'static str>,
        /// Whether the figure would be larger on the same sheet lying across, which the device takes.
        is_larger_turned: bool,
    },
    /// A drawing has so many lines for its size that at least a fifth of them has no room.
    #[error(
        "the drawing is too dense for a figure of {width} mm: {millimetres} mm of its lines, {percent} percent, had no \
         room and were left out, {}; spread it over several sheets, or draw only a part of it, so that it is larger{}",
        most_in(*.place, "figure"),
        turned(*.is_larger_turned)
    )]
    TooDense {
        /// Length of those that are not drawn, on the sheet, mm.
        millimetres: u32,
        /// Percent of the length of all.
        percent: u32,
        /// Where in the figure most of them are, in words; none if they are all over it.
        place: Option<&'static str>,
        /// Width of the figure, mm.
        width: u32,
        /// Whether the figure would be larger on the same sheet lying across, which the device takes.
        is_larger_turned: bool,
    },
    /// So many closed shapes of a drawing are not in its overview, as they have no room there as a whole.
    #[error(
        "the overview leaves out {}, as there is no room in it to draw {} whole",
        counted(*.0, "closed shape"),
        it_or_them(*.0)
    )]
    ShapesNotInOverview(usize),
    /// Much of a drawing's lines is not in its overview, for want of room.
    #[error(
        "the overview lacks {percent} percent of the drawing's lines, {}, as they have no room in it; do without it, \
         or, on paper, spread the picture over several sheets",
        most_in(*.place, "overview")
    )]
    LinesNotInOverview {
        /// Share of their length, percent.
        percent: u32,
        /// Where in the overview most of it would be, in words; none if it is all over it.
        place: Option<&'static str>,
    },
    /// No line has room in an overview, so there is none.
    #[error("there is no overview, as no line of the figure has room in it; several sheets of paper may have one")]
    NoRoomForOverview,
    /// Few contours were found, so that the figure shows little and there is no overview: their length, mm.
    #[error(
        "there is no overview, and little in the figure, as few contours were found in the picture ({0} mm): it has \
         little contrast; give one with more contrast, say what it is about (a place on it), or lower edges.high and \
         edges.low"
    )]
    FewContours(u32),
    /// Areas that are outlined have textures of several colours.
    #[error("{}", mixed_areas(*.count, .places))]
    MixedAreas {
        /// How many.
        count: usize,
        /// In which parts of the figure they are, in words, each part once.
        places: Vec<&'static str>,
    },
    /// What was left out as the maker of the page wants few shapes; perhaps nothing.
    #[error("{}", simplified(*.shapes, *.lines, *.most))]
    Simplified {
        /// Shapes that were left out.
        shapes: usize,
        /// Other lines that were.
        lines: usize,
        /// The most of each that were asked for.
        most: usize,
    },
    /// There is nothing on the page but its frame.
    #[error(
        "the page is empty: the picture is white, or what is on it is too pale, too thin or too small for fingers, or \
         the page that was read has nothing on it; of a picture, lower edges.high and edges.low to get more, or draw \
         only a part of it, so that it is larger"
    )]
    EmptyPage,
    /// There is nothing on the page but its frame, as all of it was to be erased.
    #[error(
        "the page is empty, as all that is drawn of the picture lies in the parts to be erased or outside of those to \
         be kept; erase less, or keep more"
    )]
    AllErased,
    /// The dots of the page are those of text cells, which stand apart.
    #[error(
        "the dots of braille cells are no even grid: there is a wider step after every second column and every third \
         row, so shapes are felt less well than from an embosser that has a profile of its own"
    )]
    UnevenDots,
    /// More of the figure is black than the profile allows.
    #[error(
        "{percent} percent of the figure is black, and over {most} percent swell paper may rise too much and curl; \
         make marks smaller or set them further apart (textures.dot_pitch, textures.along, lines.width_max), or \
         raise print.max_black if your paper takes it"
    )]
    TooBlack {
        /// Percent of the figure that are black.
        percent: u32,
        /// Percent that the profile allows.
        most: u32,
    },
}

impl Note {
    id_table! {
        Self::ColourProfileIgnored(..) => "colour-profile-ignored",
        Self::LeftOut(..) => "left-out",
        Self::OfFile(..) => "of-file",
        Self::NotOnPage(..) => "not-on-page",
        Self::NotInPng(..) => "not-in-png",
        Self::TakenAs(..) => "taken-as",
        Self::Faulty(..) => "faulty",
        Self::FirstPageOnly { .. } => "first-page-only",
        Self::TextsLeftOut(..) => "texts-left-out",
        Self::LetteringLeftOut { .. } => "lettering-left-out",
        Self::GroundAsPaper { .. } => "ground-as-paper",
        Self::RimLeftOut(..) => "rim-left-out",
        Self::TextsNotRead(..) => "texts-not-read",
        Self::NoBrailleCode(..) => "no-braille-code",
        Self::NotInBraille { .. } => "not-in-braille",
        Self::InOtherCells(..) => "in-other-cells",
        Self::NotTranslated { .. } => "not-translated",
        Self::NotContracted => "not-contracted",
        Self::NoRoomForTitle { .. } => "no-room-for-title",
        Self::NoRoomForNumber => "no-room-for-number",
        Self::Subject { .. } => "subject",
        Self::NoSubject(..) => "no-subject",
        Self::FewContours(..) => "few-contours",
        Self::NothingCalmed => "nothing-calmed",
        Self::BackgroundCalmed(..) => "background-calmed",
        Self::Abbreviated(..) => "abbreviated",
        Self::NoKey(..) => "no-key",
        Self::NoTexts { .. } => "no-texts",
        Self::LabelsLeftOut { .. } => "labels-left-out",
        Self::NoLines => "no-lines",
        Self::NoContours => "no-contours",
        Self::LinesOff => "lines-off",
        Self::LinesLeftOut { .. } => "lines-left-out",
        Self::TooDense { .. } => "too-dense",
        Self::ShapesNotInOverview(..) => "shapes-not-in-overview",
        Self::LinesNotInOverview { .. } => "lines-not-in-overview",
        Self::NoRoomForOverview => "no-room-for-overview",
        Self::MixedAreas { .. } => "mixed-areas",
        Self::Simplified { .. } => "simplified",
        Self::EmptyPage => "empty-page",
        Self::AllErased => "all-erased",
        Self::UnevenDots => "uneven-dots",
        Self::TooBlack { .. } => "too-black",
    }

    /// What on the page it is about, of the kinds `not-on-page`, `taken-as` and `faulty`.
    pub fn about(&self) -> Option<About> {
        match self {
            Self::NotOnPage(about, ..) | Self::TakenAs(about, ..) | Self::Faulty(about, ..) => Some(*about),
            Self::OfFile(_, note) => note.about(),
            _ => None,
        }
    }

    /// Why it is made, of the kinds that have several reasons: `left-out`, `not-on-page`, `taken-as`, `faulty`,
    /// `labels-left-out`, `no-key`, `no-subject` and `not-in-png`.
    pub fn reason(&self) -> Option<Reason> {
        match self {
            Self::LeftOut(reason, _)
            | Self::NotOnPage(_, reason, _)
            | Self::TakenAs(_, reason, _)
            | Self::Faulty(_, reason, _)
            | Self::LabelsLeftOut { reason, .. }
            | Self::NoKey(reason, _)
            | Self::NoSubject(reason, _)
            | Self::NotInPng(reason, _) => Some(*reason),
            Self::OfFile(_, note) => note.reason(),
            _ => None,
        }
    }

    /// The same with `how` the figure is made larger, such as with which options of a program; none of a remark that
    /// does not say that a larger figure helps.
    pub fn with_how_larger(&self, how: &str) -> Option<Self> {
        let mut note = self.clone();
        let (Self::NotOnPage(_, _, told) | Self::TakenAs(_, _, told)) = &mut note else { return None };
        told.say_how_larger(how).then_some(note)
    }
}

/// What a remark on a file beside the picture says.
fn said_of_file(file: GivenFile, note: &Note) -> String {
    let said = note.to_string();
    let places = if said.contains(" mm") { ", in its own mm" } else { "" };
    format!("{said} (said of the file of {}{places})", file.name())
}
