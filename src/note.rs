//! What the maker of a page or a trace should know and the result survives.

use crate::braille::Code;

/// What on a page a remark is about, for programs: its sentence may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum About {
    /// Marks of any kind.
    Marks,
    /// Lines, or contours that would be lines.
    Lines,
    /// How wide lines are.
    Widths,
    /// Areas and their textures.
    Areas,
    /// Single signs of textures.
    Signs,
    /// Texts that a person typed.
    Texts,
    /// Words in braille.
    Braille,
    /// Leader lines of labels.
    Leaders,
    /// Words in print beside braille.
    Print,
    /// Dots that a person drew.
    Dots,
    /// The overview.
    Overview,
}

/// One remark about a page that was made all the same.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Note {
    /// The picture's colour profile could not be used, so its numbers were taken as sRGB.
    ColourProfileIgnored(String),
    /// Something in the picture is left out of the page (say a text without a font, or a linked file).
    LeftOut(String),
    /// Something that a person gave, or that was on a page that was read, is left out; says what, where and why.
    NotOnPage(About, String),
    /// Something on the page is not in its PNG; says what, why and what to do.
    NotInPng(&'static str),
    /// Something on a page is taken otherwise than it looks; says what, where and as what.
    TakenAs(About, String),
    /// Something on the page is as it was given and breaks a rule of legibility; says what, where and what to do.
    Faulty(About, String),
    /// Of a document only the first page was taken, as no page was asked for.
    FirstPageOnly {
        /// How many pages it has.
        pages: usize,
    },
    /// Texts of a drawing are left out, as letters are no lines that fingers can read; all of them.
    TextsLeftOut(Vec<String>),
    /// Text in the pixels of the picture is left out; what it says is not known.
    LetteringLeftOut {
        /// How many lines of text there are.
        texts: usize,
        /// Where in the figure the largest of them is, in words.
        place: &'static str,
    },
    /// Text in the pixels of the picture is not read, though it should have been: why, in the words of the reader.
    TextsNotRead(String),
    /// There is no braille code for the language of the words, so they are not written on the page.
    NoBrailleCode(String),
    /// The braille code lacks characters of a text, so they are left out of its braille.
    NotInBraille {
        /// The text.
        text: String,
        /// Each character, and which of the text's it is, from 1.
        lacking: Vec<(char, usize)>,
    },
    /// Texts that the translator that was given could not write, so they are left out.
    NotTranslated {
        /// The texts.
        texts: Vec<String>,
        /// What the translator says.
        why: String,
    },
    /// Contracted braille is asked for, and nothing that writes it is given; the words are uncontracted.
    NotContracted,
    /// The title is not written in braille, as there is no room for it above the figure.
    NoRoomForTitle {
        /// How many cells it has.
        cells: usize,
    },
    /// The page number is not written in braille, as there is no room for it above the figure.
    NoRoomForNumber,
    /// What was found at the place that was named as the subject.
    Subject {
        /// The place, percent from the left and from the top.
        at: [i32; 2],
        /// Width and height of what was found, mm in the figure.
        mm: [u32; 2],
    },
    /// Nothing with an outline is around the place that was named as the subject, in percent from the left and the top.
    NoSubject([i32; 2]),
    /// Weak lines and textures around the subject are left out, as was asked: how much of lines, mm on the sheet.
    BackgroundCalmed(u32),
    /// Labels that are abbreviated on the page, as there is no room for more: the abbreviation and the text of each.
    Abbreviated(Vec<(String, String)>),
    /// A key is asked for, and there is none; says why.
    NoKey(&'static str),
    /// The texts of the picture were to be labels, and it has none.
    NoTexts,
    /// Labels that are not on the page.
    LabelsLeftOut {
        /// What they say.
        texts: Vec<String>,
        /// Why, in words.
        why: &'static str,
    },
    /// No contour was found that is strong and long enough.
    NoLines,
    /// Nothing was found to trace.
    NoContours,
    /// The lines of a page were to be traced, and the profile draws none.
    LinesOff,
    /// Contours are not drawn, as they lie too close to others for fingers, or are too short in a drawing.
    LinesLeftOut {
        /// Their length on the sheet, mm.
        millimetres: u32,
        /// Percent of the length of all contours.
        percent: u32,
        /// Where in the figure most of them are, in words; none if they are all over it.
        place: Option<&'static str>,
    },
    /// A drawing has so many lines for its size that at least a fifth of them has no room.
    TooDense {
        /// Length of those that are not drawn, on the sheet, mm.
        millimetres: u32,
        /// Percent of the length of all.
        percent: u32,
        /// Where in the figure most of them are, in words; none if they are all over it.
        place: Option<&'static str>,
        /// Width of the figure, mm.
        width: u32,
    },
    /// So many closed shapes of a drawing are not in its overview, as they have no room there as a whole.
    ShapesNotInOverview(usize),
    /// Much of a drawing's lines is not in its overview, for want of room.
    LinesNotInOverview {
        /// Share of their length, percent.
        percent: u32,
        /// Where in the overview most of it would be, in words; none if it is all over it.
        place: Option<&'static str>,
    },
    /// So many areas that are outlined have textures of several colours, as none of these holds the area clearly.
    MixedAreas(usize),
    /// What was left out as the maker of the page wants few shapes; perhaps nothing.
    Simplified {
        /// Shapes that were left out.
        shapes: usize,
        /// Other lines that were.
        lines: usize,
        /// The most of each that were asked for.
        most: usize,
    },
    /// There is nothing on the page but its frame.
    EmptyPage,
    /// The dots of the page are those of text cells, which stand apart.
    UnevenDots,
    /// More of the figure is black than the profile allows.
    TooBlack {
        /// Percent of the figure that are black.
        percent: u32,
        /// Percent that the profile allows.
        most: u32,
    },
}

impl Note {
    /// What on the page it is about, of the kinds `not-on-page`, `taken-as` and `faulty`.
    pub fn about(&self) -> Option<About> {
        match self {
            Self::NotOnPage(about, _) | Self::TakenAs(about, _) | Self::Faulty(about, _) => Some(*about),
            _ => None,
        }
    }

    /// Its kind as a word for programs, such as `lines-left-out`, which stays the same when the sentence changes.
    pub fn id(&self) -> &'static str {
        match self {
            Self::ColourProfileIgnored(..) => "colour-profile-ignored",
            Self::LeftOut(..) => "left-out",
            Self::NotOnPage(..) => "not-on-page",
            Self::NotInPng(..) => "not-in-png",
            Self::TakenAs(..) => "taken-as",
            Self::Faulty(..) => "faulty",
            Self::FirstPageOnly { .. } => "first-page-only",
            Self::TextsLeftOut(..) => "texts-left-out",
            Self::LetteringLeftOut { .. } => "lettering-left-out",
            Self::TextsNotRead(..) => "texts-not-read",
            Self::NoBrailleCode(..) => "no-braille-code",
            Self::NotInBraille { .. } => "not-in-braille",
            Self::NotTranslated { .. } => "not-translated",
            Self::NotContracted => "not-contracted",
            Self::NoRoomForTitle { .. } => "no-room-for-title",
            Self::NoRoomForNumber => "no-room-for-number",
            Self::Subject { .. } => "subject",
            Self::NoSubject(..) => "no-subject",
            Self::BackgroundCalmed(..) => "background-calmed",
            Self::Abbreviated(..) => "abbreviated",
            Self::NoKey(..) => "no-key",
            Self::NoTexts => "no-texts",
            Self::LabelsLeftOut { .. } => "labels-left-out",
            Self::NoLines => "no-lines",
            Self::NoContours => "no-contours",
            Self::LinesOff => "lines-off",
            Self::LinesLeftOut { .. } => "lines-left-out",
            Self::TooDense { .. } => "too-dense",
            Self::ShapesNotInOverview(..) => "shapes-not-in-overview",
            Self::LinesNotInOverview { .. } => "lines-not-in-overview",
            Self::MixedAreas(..) => "mixed-areas",
            Self::Simplified { .. } => "simplified",
            Self::EmptyPage => "empty-page",
            Self::UnevenDots => "uneven-dots",
            Self::TooBlack { .. } => "too-black",
        }
    }
}

impl About {
    /// Its name, such as "lines".
    pub fn name(self) -> &'static str {
        match self {
            Self::Marks => "marks",
            Self::Lines => "lines",
            Self::Widths => "widths",
            Self::Areas => "areas",
            Self::Signs => "signs",
            Self::Texts => "texts",
            Self::Braille => "braille",
            Self::Leaders => "leaders",
            Self::Print => "print",
            Self::Dots => "dots",
            Self::Overview => "overview",
        }
    }
}

impl std::fmt::Display for Note {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::ColourProfileIgnored(why) => {
                write!(f, "the picture's colour profile could not be used, colours were taken as sRGB: {why}")
            }
            Self::LeftOut(what) | Self::NotOnPage(_, what) => write!(f, "left out of the page: {what}"),
            Self::NotInPng(what) => write!(f, "not in the PNG: {what}"),
            Self::TakenAs(_, what) | Self::Faulty(_, what) => f.write_str(what),
            Self::FirstPageOnly { pages } => {
                write!(f, "this is page 1 of {pages}; ask for another by its number")
            }
            Self::TextsLeftOut(texts) => {
                let (count, noun) = (texts.len(), if texts.len() == 1 { "text" } else { "texts" });
                write!(f, "{count} {noun} left out, as fingers cannot read letters: {}", listed(texts))
            }
            Self::LetteringLeftOut { texts: 1, place } => {
                write!(f, "1 text left out, in the {place}, as fingers cannot read letters; keep the text to draw it")
            }
            Self::LetteringLeftOut { texts, place } => write!(
                f,
                "{texts} texts left out, the largest in the {place}, as fingers cannot read letters; keep the text to \
                 draw them"
            ),
            Self::TextsNotRead(why) => write!(f, "the texts in the pixels are not read: {why}"),
            Self::NoBrailleCode(language) => {
                let codes: Vec<&str> = Code::all().iter().map(|code| code.language).collect();
                write!(
                    f,
                    "nothing is written in braille, as there is no code for the language \"{}\"; there are {}; \
                     choose one (braille.code), or leave braille out (braille.on = false)",
                    short(language),
                    codes.join(", ")
                )
            }
            Self::NotInBraille { text, lacking } => {
                write!(f, "left out of the braille of \"{}\", as its code has no cells for it: ", short(text))?;
                let shown = lacking.len().min(MOST_TEXTS);
                for (i, (character, at)) in lacking[..shown].iter().enumerate() {
                    write!(f, "{}{character:?} (character {at})", if i > 0 { ", " } else { "" })?;
                }
                let more = lacking.len() - shown;
                if more > 0 {
                    write!(f, " and {more} more")?;
                }
                f.write_str("; write it in words, or take a table of liblouis that has it (--braille-table TABLE)")
            }
            Self::NotTranslated { texts, why } => {
                let verb = if texts.len() == 1 { "is" } else { "are" };
                write!(f, "{} {verb} not written in braille: {why}", listed(texts))
            }
            Self::NotContracted => f.write_str(
                "braille is uncontracted although braille.grade is 2: contracted braille is written by a translator, \
                 such as an installed liblouis, and none was given",
            ),
            Self::NoRoomForTitle { cells } => write!(
                f,
                "the title is not written in braille: its {cells} cells have no room above the figure, where three \
                 lines may take a fifth of the sheet; give a shorter one, or a larger sheet"
            ),
            Self::NoRoomForNumber => f.write_str(
                "the page number is not written in braille, as it has no room above the figure; take a larger sheet, \
                 or leave the number out",
            ),
            Self::Subject { at: [x, y], mm: [width, height] } => write!(
                f,
                "the subject at {x} %, {y} % is {width} mm wide and {height} mm high in the figure, and outlined \
                 first; if that is not the whole of it, name another place on it as well"
            ),
            Self::NoSubject([x, y]) if !(0..=100).contains(x) || !(0..=100).contains(y) => write!(
                f,
                "{x} %, {y} % is outside of the picture, so that nothing comes first there; name a place on it, from \
                 0 to 100 percent or within its pixels, from the left and from the top"
            ),
            Self::NoSubject([x, y]) => write!(
                f,
                "at {x} %, {y} % there is nothing with a clear outline, so that nothing comes first there; name a \
                 place in the middle of a thing that stands out from what is around it"
            ),
            Self::BackgroundCalmed(millimetres) => write!(
                f,
                "around the subject {millimetres} mm of weak lines, the outlines of other regions and all textures are \
                 left out, as was asked"
            ),
            Self::Abbreviated(labels) => {
                let all: Vec<String> =
                    labels.iter().map(|(abbreviation, text)| format!("{abbreviation} = {}", short(text))).collect();
                write!(f, "abbreviated for want of room: {}", all.join(", "))
            }
            Self::NoKey(why) => write!(f, "there is no key, as {why}"),
            Self::NoTexts => f.write_str(
                "there are no texts for labels: none was found in this picture, or its letters are pixels that \
                 nobody has read; write a list of labels",
            ),
            Self::LabelsLeftOut { texts, why } => {
                let (count, noun) = (texts.len(), if texts.len() == 1 { "label" } else { "labels" });
                write!(f, "{count} {noun} left out, as {why}: {}", listed(texts))
            }
            Self::NoLines => f.write_str(
                "no contour is strong and long enough for a line, so there is no overview either; lower edges.high \
                 and edges.low, or give a brighter picture, one with less around it, or one with larger parts",
            ),
            Self::NoContours => f.write_str(
                "nothing to trace: no contour is strong and long enough; lower the thresholds, or give a brighter \
                 picture",
            ),
            Self::LinesOff => f.write_str(
                "nothing to trace: the profile draws no lines, as figure.lines is off; turn it on, or trace contours",
            ),
            Self::LinesLeftOut { millimetres, percent, place } => write!(
                f,
                "{millimetres} mm of contours, {percent} percent, were left out, {}: they lie too close to others for \
                 fingers, or are too short; a larger figure, on larger paper if there is any, or only a part of the \
                 picture keeps more of them",
                most_in(*place, "figure")
            ),
            Self::TooDense { millimetres, percent, place, width } => write!(
                f,
                "the drawing is too dense for a figure of {width} mm: {millimetres} mm of its lines, {percent} \
                 percent, had no room and were left out, {}; spread it over several sheets, or draw only a part of it, \
                 so that it is larger",
                most_in(*place, "figure")
            ),
            Self::ShapesNotInOverview(count) => write!(
                f,
                "the overview leaves out {count} closed {}, as there is no room in it to draw {} whole",
                if *count == 1 { "shape" } else { "shapes" },
                if *count == 1 { "it" } else { "them" },
            ),
            Self::LinesNotInOverview { percent: 100, .. } => f.write_str(
                "there is no overview, as no line of the drawing has room in it; spread the figure over several sheets",
            ),
            Self::LinesNotInOverview { percent, place } => write!(
                f,
                "the overview lacks {percent} percent of the drawing's lines, {}, as they have no room in it; do \
                 without it (--no-overview), or spread the figure over several sheets",
                most_in(*place, "overview")
            ),
            Self::Simplified { shapes: 0, lines: 0, most } => write!(
                f,
                "nothing is left out for few shapes (lines.shapes = {most}), as there are no more; ask for fewer to \
                 have less"
            ),
            Self::Simplified { shapes, lines, most } => {
                let counted = [(*shapes, "shape"), (*lines, "other line")].into_iter().filter(|(count, _)| *count > 0);
                let counted: Vec<String> = counted
                    .map(|(count, noun)| format!("{count} {noun}{}", if count == 1 { "" } else { "s" }))
                    .collect();
                write!(f, "left out, as few shapes are asked for (lines.shapes = {most}): {}", counted.join(" and "))
            }
            Self::MixedAreas(1) => f.write_str(
                "1 outlined area has the textures of several colours, as none of them fills two thirds of it",
            ),
            Self::MixedAreas(count) => write!(
                f,
                "{count} outlined areas have the textures of several colours each, as none of them fills two thirds"
            ),
            Self::TooBlack { percent, most } => write!(
                f,
                "{percent} percent of the figure is black, and over {most} percent swell paper may rise too much and \
                 curl; make marks smaller or set them further apart (textures.dot_pitch, textures.along, \
                 lines.width_max), or raise print.max_black if your paper takes it"
            ),
            Self::UnevenDots => f.write_str(
                "the dots of braille cells are no even grid: there is a wider step after every second column and \
                 every third row, so shapes are felt less well than from an embosser that has a profile of its own",
            ),
            Self::EmptyPage => f.write_str(
                "the page is empty: the picture is white, or what is on it is too pale, too thin or too small for \
                 fingers; lower edges.high and edges.low to get more, or draw only a part of it, so that it is larger \
                 (--crop)",
            ),
        }
    }
}

/// Where most of something is, within a sentence.
fn most_in(place: Option<&str>, whole: &str) -> String {
    place.map_or_else(|| format!("all over the {whole}"), |place| format!("most of them in the {place}"))
}

/// Most texts that a note shows; it is read aloud.
const MOST_TEXTS: usize = 12;

/// Texts in quotation marks, as many as a note shows.
fn listed(texts: &[String]) -> String {
    let shown = texts.len().min(MOST_TEXTS);
    let quoted: Vec<String> = texts[..shown].iter().map(|text| format!("\"{}\"", short(text))).collect();
    let more = texts.len() - shown;
    if more > 0 { format!("{} and {more} more", quoted.join(", ")) } else { quoted.join(", ") }
}

/// The beginning of a text.
fn short(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
