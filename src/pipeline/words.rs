//! What is written on a page in braille.

use super::key::{Entries, Key};
use super::label::Label;
use super::request::Request;
use super::texts::Text;
use crate::braille::{Braille, CellSize, Code, Lacking, Translate, Translator};
use crate::dots;
use crate::labels::{self, Params, Placed, Wanted};
use crate::page::cells::CellGrid;
use crate::page::heading::HeadingParams;
use crate::page::layout::Layout;
use crate::page::{BrailleText, Class, Dots, Figure, LANGUAGE, Medium, Run, TextRole};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, Size};
use crate::{Error, Note};

/// What the maker of a page wants to be written on it.
#[derive(Clone, Copy, Default)]
pub struct Words<'a> {
    /// The title; none if the maker gave none: a file's name is no title.
    pub title: Option<&'a str>,
    /// The language of the words (BCP 47); without it they are English.
    pub language: Option<&'a str>,
    /// Labels in the figure.
    pub labels: &'a [Label],
    /// Whether the texts of a drawing are labels too.
    pub own_texts: bool,
    /// When there is a key.
    pub key: Key,
    /// What writes the words, if not the table of their code.
    pub translate: Option<&'a Translate>,
}

impl Words<'_> {
    /// Whether anything is to be written.
    pub fn are_any(&self) -> bool {
        self.title.is_some() || !self.labels.is_empty() || self.own_texts || self.key == Key::Always
    }
}

/// Blank between labels and lines or textures, mm: as other programs leave around braille on graphics.
const CLEARANCE: f32 = 3.0;
/// Step in which places for labels are looked for on paper, mm: less than a fingertip can tell.
const STEP: f32 = 1.0;

/// The words of a page in braille.
#[derive(Debug, Default)]
pub(super) struct Written<'a> {
    title: Option<Title>,
    language: String,
    translator: Option<Translator<'a>>,
    /// What could not be written.
    notes: Vec<Note>,
}

#[derive(Debug)]
struct Title {
    text: String,
    braille: Braille,
    params: HeadingParams,
}

impl<'a> Written<'a> {
    /// The words in the code that the profile names, or that of their language.
    pub(super) fn new(words: &Words<'a>, plan: &Plan) -> Self {
        let settings = &plan.profile().braille;
        let language = words.language.unwrap_or(LANGUAGE);
        let mut written = Self { language: language.to_owned(), ..Self::default() };
        if !settings.on || !words.are_any() {
            return written;
        }
        let table = settings.code.or_else(|| Code::of_language(language)).and_then(Code::table);
        let Some(translator) = Translator::new(table, words.translate) else {
            written.notes.push(Note::NoBrailleCode(language.to_owned()));
            return written;
        };
        if let Some(text) = words.title {
            let braille = translator.translate(text).unwrap_or_else(|why| {
                written.notes.push(Note::NotTranslated { text: text.to_owned(), why });
                Braille::default()
            });
            written.notes.extend(not_written(text, &braille.lacking));
            let title = |params| Title { text: text.to_owned(), braille: braille.clone(), params };
            written.title = HeadingParams::of(&braille, settings.cell, settings.align).map(title);
        }
        written.translator = Some(translator);
        written
    }

    /// Where a picture lies below its title. Where a title would leave the figure too small, or narrower than it is
    /// asked for, there is none.
    pub(super) fn layout(&self, size: Size, request: &Request<'_>) -> Result<Layout, Error> {
        let (fit, plan) = (&request.fit, request.plan);
        let least = plan.profile().figure.min_side;
        let below = self.title.as_ref().and_then(|title| fit.layout_below(size, plan, Some(title.params)).ok());
        match below.filter(|layout| layout.figure.width().min(layout.figure.height()) >= least) {
            Some(layout) => Ok(layout),
            None => fit.layout(size, plan),
        }
    }

    /// The words where they stand on the sheet, and what the maker should know of them. Textures of the figure
    /// make room for labels.
    pub(super) fn on(
        &self,
        layout: &Layout,
        figure: &mut Figure,
        texts: &[Text],
        words: &Words<'_>,
        plan: &Plan,
    ) -> (Vec<BrailleText>, Vec<Note>) {
        let mut notes = self.notes.clone();
        let cell = plan.profile().braille.cell;
        let title = self.title(layout, cell);
        if let (Some(title), None) = (&self.title, &title) {
            notes.push(Note::NoRoomForTitle { cells: title.braille.cells.len() });
        }
        let no_texts = words.own_texts && !texts.iter().any(Text::is_read);
        notes.extend(no_texts.then_some(Note::NoTexts));
        let (wanted, mut left_out) = wanted(texts, words, figure);
        let Some(translator) = &self.translator else {
            left_out.extend(wanted.into_iter().map(|label| label.text));
            notes.extend((!left_out.is_empty()).then_some(Note::LabelsLeftOut(left_out)));
            return (title.into_iter().collect(), notes);
        };
        let cells = CellGrid::of(&layout.medium, cell);
        let params = params(layout, plan);
        let placed = labels::place(&wanted, translator, figure, &cells, &params);
        labels::make_room(figure, &placed, &params);
        let missing = |&of: &usize| placed.iter().all(|label| label.of != of);
        left_out.extend((0..wanted.len()).filter(missing).map(|of| wanted[of].text.clone()));
        let mut abbreviated = Vec::new();
        for label in &placed {
            let text = &wanted[label.of].text;
            match &label.abbreviation {
                None => notes.extend(not_written(text, &label.lacking)),
                Some(short) if !abbreviated.iter().any(|(known, _)| known == short) => {
                    abbreviated.push((short.clone(), text.clone()));
                }
                Some(_) => {}
            }
        }
        notes.extend((!abbreviated.is_empty()).then_some(Note::Abbreviated(abbreviated)));
        notes.extend((!left_out.is_empty()).then_some(Note::LabelsLeftOut(left_out)));
        let labels = placed.iter().map(|label| self.label(label, &wanted[label.of].text, &cells, layout, plan));
        (title.into_iter().chain(labels).collect(), notes)
    }

    /// What the key of a page says that has these words; none where there is no key.
    pub(super) fn key<'e>(
        &'e self,
        words: &Words<'_>,
        braille: &[BrailleText],
        figure: &Figure,
    ) -> Option<Entries<'e>> {
        let mut abbreviations: Vec<(String, String)> = Vec::new();
        for text in braille {
            if let Some(short) = &text.abbreviation
                && !abbreviations.iter().any(|(known, _)| known == short)
            {
                abbreviations.push((short.clone(), text.text.clone()));
            }
        }
        let is_wanted = match words.key {
            Key::Auto => !abbreviations.is_empty(),
            Key::Always => true,
            Key::Never => false,
        };
        let translator = self.translator.as_ref().filter(|_| is_wanted)?;
        let occurs = |class: &Class| figure.textures.iter().any(|texture| texture.class == *class);
        let classes = Class::ALL.into_iter().filter(occurs).collect();
        let title = self.title.as_ref().map(|title| title.text.as_str());
        Some(Entries { translator, language: &self.language, title, classes, abbreviations })
    }

    fn title(&self, layout: &Layout, cell: CellSize) -> Option<BrailleText> {
        let (title, heading) = self.title.as_ref().zip(layout.heading)?;
        let diameter = CellGrid::of(&layout.medium, cell).diameter;
        Some(BrailleText {
            role: TextRole::Title,
            text: title.text.clone(),
            language: self.language.clone(),
            abbreviation: None,
            lines: unicode(&heading.lines(&title.braille)),
            dots: Dots { diameter, at: heading.dots(&title.braille, &layout.medium) },
            leader: None,
        })
    }

    fn label(&self, label: &Placed, text: &str, cells: &CellGrid<'_>, layout: &Layout, plan: &Plan) -> BrailleText {
        BrailleText {
            role: TextRole::Label,
            text: text.to_owned(),
            language: self.language.clone(),
            abbreviation: label.abbreviation.clone(),
            lines: unicode(&label.lines),
            dots: Dots { diameter: cells.diameter, at: cells.dots(&label.lines, label.place.min) },
            leader: label.leader.map(|ends| leader(ends, layout, plan)),
        }
    }
}

/// The labels that are wanted, and the texts of those that lie outside of the picture.
fn wanted(texts: &[Text], words: &Words<'_>, figure: &Figure) -> (Vec<Wanted>, Vec<String>) {
    let (mut wanted, mut outside) = (Vec::new(), Vec::new());
    for label in words.labels {
        match label.on(figure.place, figure.source) {
            Some(at) => wanted.push(Wanted { text: label.text.clone(), anchor: MmRect::new(at, at) }),
            None => outside.push(label.text.clone()),
        }
    }
    let own = texts.iter().filter(|text| words.own_texts && text.is_read());
    wanted.extend(own.map(|text| Wanted { text: text.string.clone(), anchor: text.place }));
    (wanted, outside)
}

/// Labels may lie in the figure, and on paper beside it, as far as the frame leaves its clearance. On a grid the
/// frame is some columns from the outermost of the figure, which may lie a step within it.
fn params(layout: &Layout, plan: &Plan) -> Params {
    let beside = plan.layout().frame.map_or(0.0, |frame| (frame.gap - CLEARANCE).max(0.0));
    let (step, area) = match &layout.medium {
        Medium::Print(_) => (STEP, layout.figure.inflate(beside, beside)),
        Medium::Dots(dots) => {
            let radius = 0.5 * dots.diameter();
            let reach = dots.area.bounds().inflate(radius, radius);
            (dots.pitch, layout.figure.intersection_unchecked(&reach))
        }
    };
    Params { area, clearance: CLEARANCE, step }
}

/// A leader line: as thin as lines can be.
fn leader(ends: [MmPoint; 2], layout: &Layout, plan: &Plan) -> Run {
    match &layout.medium {
        Medium::Print(_) => Run::stroke(plan.lines().width_min, ends.to_vec()),
        Medium::Dots(medium) => dots::mark(&ends, &medium.area, &plan.dots(medium)),
    }
}

fn unicode(lines: &[Vec<u8>]) -> Vec<String> {
    lines.iter().map(|line| Braille { cells: line.clone(), ..Braille::default() }.unicode()).collect()
}

/// What is told of characters that the code has no cells for.
fn not_written(text: &str, lacking: &[Lacking]) -> Option<Note> {
    let characters = lacking.iter().map(|lacking| (lacking.character, lacking.at)).collect();
    (!lacking.is_empty()).then(|| Note::NotInBraille { text: text.to_owned(), lacking: characters })
}
