//! What is written on a page in braille.

use super::key::{self, Entries, Key, KeySheets};
use super::label::Label;
use super::label_params::params;
use super::legend::{self, LegendEntry};
use super::next_cell;
use super::request::{OverviewSize, Request};
use super::texts::Text;
use super::told_labels::{
    self, LabelCounts, NO_CODE, NO_CODE_OF_WORDS, NOTHING_TO_TELL, OFF, OUTSIDE, TOO_LONG, across, left_out,
    nearer_to_others, of_axes, of_headings, of_nothing, told,
};
use super::unwritten::{self, NoRoomAbove};
use crate::braille::{Braille, CellSize, Code, Grade, Translate, Translator, unicode};
use crate::dots;
use crate::labels::{self, MadeRoom, Params, Placed, Wanted, WrittenLabel};
use crate::page::cells::CellGrid;
use crate::page::heading::{Align, HeadingParams};
use crate::page::layout::Layout;
use crate::page::spread::LABEL_CELLS;
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
    pub key: KeySheets,
    /// The page number of the first sheet.
    pub number: Option<u32>,
    /// What writes the words, if not the table of their code.
    pub translate: Option<&'a Translate>,
    /// What colours mean by the legend of a drawing, whose words are labels.
    pub legend: &'a [LegendEntry],
    /// Where small shapes of a drawing are not on the page, such as a stop where routes meet.
    pub lost_points: &'a [MmPoint],
    /// Of a page that is drawn anew, the figure that it had.
    pub before: Option<&'a Figure>,
    /// Boxes that labels keep clear of as of lines.
    pub blocked: &'a [MmRect],
    /// Labels that are on the page already.
    pub written: &'a [WrittenLabel],
    /// Which of the labels, and then of the texts that are labels too, name nothing.
    pub nameless: &'a [usize],
    /// Whether the picture's ground is an area of its own colour, such as the sea around an island.
    pub coloured_ground: bool,
}

/// Words where they stand, and what they change of the page.
pub(super) struct OnPage {
    pub(super) braille: Vec<BrailleText>,
    /// What the maker should know of labels.
    pub(super) notes: Vec<Note>,
    /// How many labels are not there, or not as they are.
    pub(super) counts: LabelCounts,
    /// What has no room above the figure.
    pub(super) above: NoRoomAbove,
    /// Of each line of the figure, which one it is a part of: gridlines are interrupted at labels.
    pub(super) lines: Vec<usize>,
}

impl Words<'_> {
    /// Whether anything is to be written.
    pub fn are_any(&self) -> bool {
        self.title.is_some()
            || !self.labels.is_empty()
            || self.own_texts
            || self.key == KeySheets::Always
            || self.number.is_some()
    }
}

/// The words of a page in braille.
#[derive(Debug, Default)]
pub(super) struct WrittenWords<'a> {
    title: Option<Title>,
    heading: Option<HeadingParams>,
    /// The page number of the first sheet.
    number: Option<u32>,
    language: String,
    translator: Option<Translator<'a>>,
    /// What could not be written.
    notes: Vec<Note>,
}

#[derive(Debug)]
struct Title {
    text: String,
    braille: Braille,
}

/// Most sheets after the first: room for the digits of their numbers is kept.
const MOST_SHEETS: u32 = 50;

impl<'a> WrittenWords<'a> {
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
        if settings.grade == Grade::Two && words.translate.is_none() {
            written.notes.push(Note::NotContracted);
        }
        let (title, too_long) = match words.title {
            Some(text) if text.chars().nth(labels::LONGEST).is_some() => (None, Some(text)),
            title => (title, None),
        };
        let (texts, why) = (too_long.map(str::to_owned).into_iter().collect::<Vec<_>>(), TOO_LONG.1.to_owned());
        written.notes.extend((!texts.is_empty()).then_some(Note::NotTranslated { texts, why }));
        if let Some(text) = title {
            let (braille, notes) = unwritten::title(text, &translator);
            written.notes.extend(notes);
            written.title = braille.map(|braille| Title { text: text.to_owned(), braille });
        }
        let none = Braille::default();
        let title = written.title.as_ref().map_or(&none, |title| &title.braille);
        let mut of_number = 0;
        if let Some(number) = words.number {
            let longest = number.saturating_add(MOST_SHEETS).to_string();
            match translator.spell(&longest) {
                Ok(braille) => (written.number, of_number) = (Some(number), braille.cells.len()),
                Err(why) => written.notes.push(Note::NotTranslated { texts: vec![longest], why }),
            }
        }
        written.heading = HeadingParams::of(title, of_number, settings.cell, settings.align);
        written.translator = Some(translator);
        written
    }

    /// Where a picture lies below its title. Where a title would leave the figure too small, or narrower than it is
    /// asked for, there is none.
    pub(super) fn layout(&self, size: Size, overview: OverviewSize, request: &Request<'_>) -> Result<Layout, Error> {
        let (fit, plan) = (&request.fit, request.plan);
        let least = plan.profile().figure.min_side;
        let below = self.heading.and_then(|heading| fit.layout_below(size, plan, Some(heading), overview).ok());
        match below.filter(|layout| layout.figure.width().min(layout.figure.height()) >= least) {
            Some(layout) => Ok(layout),
            None => fit.layout(size, plan, overview),
        }
    }

    /// What writes the words; none where nothing is written.
    pub(super) fn translator(&self) -> Option<&Translator<'a>> {
        self.translator.as_ref()
    }

    /// The words where they stand on the sheet, and what the maker should know of those that can be written. Textures
    /// of the figure make room for labels.
    pub(super) fn on(
        &self,
        layout: &Layout,
        figure: &mut Figure,
        texts: &[Text],
        words: &Words<'_>,
        plan: &Plan,
    ) -> OnPage {
        let (heading, above) = self.heading(0, layout, plan);
        let labels = self.labels(layout, &[], figure, texts, words, plan);
        OnPage { braille: heading.into_iter().chain(labels.braille).collect(), above, ..labels }
    }

    /// What could not be written at all.
    pub(super) fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// What stands at the top of a sheet, counted from the first, and what has no room there.
    pub(super) fn heading(&self, sheet: u32, layout: &Layout, plan: &Plan) -> (Vec<BrailleText>, NoRoomAbove) {
        let cell = plan.profile().braille.cell;
        let title = self.title(layout, cell);
        let number = self.number_of(sheet, layout, cell);
        let no_title = self.title.as_ref().filter(|_| title.is_none());
        let above = NoRoomAbove {
            title: no_title.map(|title| title.braille.cells.len()),
            number: self.number.is_some() && number.is_none(),
        };
        (title.into_iter().chain(number).collect(), above)
    }

    /// What the layout of several sheets needs to know of title and page number, which stand beside the braille that
    /// says which sheet it is.
    pub(super) fn heading_beside(&self, cells: usize) -> Option<HeadingParams> {
        self.heading.map(|heading| heading.beside(cells))
    }

    /// The same with room for the label that says which sheet of a picture a page is.
    pub(super) fn beside_label(self, plan: &Plan) -> Self {
        let settings = &plan.profile().braille;
        let alone = || HeadingParams::of(&Braille::default(), LABEL_CELLS, settings.cell, settings.align);
        // a title that begins on the left would begin where the label stands
        let mut heading = self.heading.map(|heading| heading.beside(LABEL_CELLS)).or_else(alone);
        heading.iter_mut().for_each(|heading| heading.align = Align::Centre);
        Self { heading, ..self }
    }

    /// The labels where they stand in the figure, and what the maker should know of them. Textures make room. Where
    /// there are `tiles`, each label is whole in one of them.
    pub(super) fn labels(
        &self,
        layout: &Layout,
        tiles: &[MmRect],
        figure: &mut Figure,
        texts: &[Text],
        words: &Words<'_>,
        plan: &Plan,
    ) -> OnPage {
        let mut notes = Vec::new();
        let cell = plan.profile().braille.cell;
        let no_texts = words.own_texts && !texts.iter().any(Text::is_read);
        notes.extend(no_texts.then(|| Note::NoTexts { are_unread: texts.iter().any(Text::is_unread) }));
        let (wanted, outside) = wanted(texts, words, figure);
        let beyond = outside.len();
        notes.extend(left_out(outside, OUTSIDE));
        let Some(translator) = &self.translator else {
            let why = if plan.profile().braille.on { NO_CODE } else { OFF };
            let counts = LabelCounts { left_out: beyond + wanted.len(), ..LabelCounts::default() };
            notes.extend(left_out(wanted.into_iter().map(|label| label.text).collect(), why));
            let lines = (0..figure.lines.len()).collect();
            return OnPage { braille: Vec::new(), notes, counts, above: NoRoomAbove::default(), lines };
        };
        let cells = CellGrid::of(&layout.medium, cell);
        let (points, blocked) = (words.lost_points.to_vec(), words.blocked.to_vec());
        let leaders = texts.iter().filter_map(|text| text.kept_leader.map(|(from, _)| from)).collect();
        let written = words.written.to_vec();
        let has_coloured_ground = words.coloured_ground;
        let params = Params { points, leaders, blocked, written, has_coloured_ground, ..params(layout, tiles, plan) };
        let results = labels::place(&wanted, translator, figure, &cells, &params);
        let placed: Vec<&Placed> = results.iter().flatten().collect();
        notes.extend(of_nothing(&wanted, &results, figure, words.before));
        notes.extend(across(&wanted, &results));
        notes.extend(nearer_to_others(&wanted, &results));
        notes.extend(of_axes(&wanted, &results));
        // a page that is drawn anew has what it had
        if words.title.is_none() && words.before.is_none() {
            notes.extend(of_headings(&wanted, &results, figure));
        }
        let of_placed: Vec<&str> =
            wanted.iter().zip(&results).filter(|(_, result)| result.is_ok()).map(|(of, _)| of.text.as_str()).collect();
        let MadeRoom { lines, without_texture, with_less_texture } = labels::make_room(figure, &placed, &params);
        // each time that a page is drawn anew they would become shorter
        if words.before.is_none() {
            let measures = (layout.medium.pitch(), plan.limits().line_length);
            next_cell::begin_off_labels(&mut figure.lines, &kept_leaders(&wanted, &results), &cells, measures);
        }
        let texts = |areas: Vec<Vec<usize>>| -> Vec<Vec<&str>> {
            areas.into_iter().map(|labels| labels.into_iter().map(|label| of_placed[label]).collect()).collect()
        };
        notes.extend(told_labels::without_texture(&texts(without_texture)));
        notes.extend(told_labels::with_less_texture(&texts(with_less_texture)));
        let (of_labels, counts) = told(&wanted, &results);
        notes.extend(of_labels.into_iter().chain(unwritten::told_otherwise(&of_placed, translator)));
        let labels = wanted.iter().zip(&results).filter_map(|(wanted, result)| {
            result.as_ref().ok().map(|placed| self.label(placed, &wanted.text, &cells, layout, plan))
        });
        let counts = LabelCounts { left_out: beyond + counts.left_out, ..counts };
        OnPage { braille: labels.collect(), notes, counts, above: NoRoomAbove::default(), lines }
    }

    /// What stands above the overview where that has a sheet of its own: the same title, and its own number.
    pub(super) fn above_overview(&self, layout: &Layout, plan: &Plan) -> Vec<BrailleText> {
        self.heading(1, layout, plan).0
    }

    /// The page number of a sheet, counted from the first.
    fn number_of(&self, sheet: u32, layout: &Layout, cell: CellSize) -> Option<BrailleText> {
        let (number, heading) = (self.number?.saturating_add(sheet), layout.heading?);
        let cells = self.translator.as_ref()?.spell(&number.to_string()).ok()?.cells;
        let diameter = CellGrid::of(&layout.medium, cell).diameter;
        let at = heading.dots_of_number(&cells, &layout.medium);
        Some(BrailleText::page_number(number, &cells, Dots { diameter, at }, &self.language))
    }

    /// The key of a page that has these words, after so many sheets; what the maker should know of it is also why there
    /// is none where one is asked for.
    pub(super) fn key(
        &self,
        words: &Words<'_>,
        braille: &[BrailleText],
        figure: &Figure,
        sheets_before: u32,
        layout: &Layout,
        request: &Request<'_>,
    ) -> Result<Key, Error> {
        let legend = legend::with_blank(words.legend, figure, request.plan);
        let of_key = Words { legend: &legend, ..*words };
        let mut key = match self.entries_of_key(&of_key, braille, figure, sheets_before, layout) {
            Some(entries) => key::of_entries(&entries, layout, figure.source, request)?,
            None => Key::default(),
        };
        let told = (!key.sheets.is_empty()).then_some(&key.told);
        let of_legend = legend::told(words.legend, figure, told);
        key.notes.extend(of_legend);
        if words.key == KeySheets::Always && key.sheets.is_empty() {
            let (reason, why) = match &self.translator {
                _ if !request.plan.profile().braille.on => OFF,
                None => NO_CODE_OF_WORDS,
                Some(_) => NOTHING_TO_TELL,
            };
            key.notes.push(Note::NoKey(reason, why));
        }
        Ok(key)
    }

    /// What the key of a page says that has these words, after so many sheets; none where there is no key.
    fn entries_of_key<'e>(
        &'e self,
        words: &Words<'_>,
        braille: &[BrailleText],
        figure: &Figure,
        sheets_before: u32,
        layout: &Layout,
    ) -> Option<Entries<'e>> {
        let abbreviations = key::abbreviations(braille);
        let occurs = |class: &Class| legend::occurs(*class, figure);
        let has_heading = layout.heading.is_some_and(|heading| heading.lines > 0);
        // on a page that was read it stands already
        let is_above = has_heading || braille.iter().any(|text| text.role == TextRole::Title);
        let has_title_alone = self.title.is_some() && !is_above;
        let is_wanted = match words.key {
            KeySheets::Auto => {
                let is_told = |entry: &LegendEntry| {
                    entry.has_meaning() && (occurs(&entry.class) || entry.has_blank || entry.place.is_some())
                };
                !abbreviations.is_empty() || words.legend.iter().any(is_told) || has_title_alone
            }
            KeySheets::Always => true,
            KeySheets::Never => false,
        };
        let translator = self.translator.as_ref().filter(|_| is_wanted)?;
        let classes = Class::ALL.into_iter().filter(occurs).collect();
        let meaning = |entry: &LegendEntry| entry.has_meaning().then(|| entry.text.clone());
        let meanings = words.legend.iter().filter_map(|entry| Some((entry.class, meaning(entry)?))).collect();
        // a colour that has a texture on the page has its patch
        let is_blank = |entry: &&LegendEntry| entry.has_blank && (entry.has_meaning() || !occurs(&entry.class));
        let blank = words.legend.iter().filter(is_blank).map(|entry| (entry.class, meaning(entry))).collect();
        let title = self.title.as_ref().map(|title| title.text.as_str());
        let number = self.number.map(|number| number.saturating_add(sheets_before));
        Some(Entries {
            translator,
            language: &self.language,
            title,
            has_title_alone,
            classes,
            meanings,
            blank,
            abbreviations,
            number,
        })
    }

    fn title(&self, layout: &Layout, cell: CellSize) -> Option<BrailleText> {
        let (title, heading) = self.title.as_ref().zip(layout.heading.filter(|heading| heading.lines > 0))?;
        let diameter = CellGrid::of(&layout.medium, cell).diameter;
        Some(BrailleText {
            role: TextRole::Title,
            text: title.text.clone(),
            language: self.language.clone(),
            abbreviation: None,
            lines: heading.lines(&title.braille).iter().map(|line| unicode(line)).collect(),
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
            lines: label.lines.iter().map(|line| unicode(line)).collect(),
            dots: Dots { diameter: cells.diameter, at: cells.dots(&label.lines, label.place.min) },
            leader: label.attachment.leader().map(|ends| {
                let run = leader(ends, layout, plan);
                Run { points: next_cell::off_next_cell(&run.points, label.place, cells), ..run }
            }),
        }
    }
}

/// The labels that are wanted, and the texts of those that lie outside of the picture.
fn wanted(texts: &[Text], words: &Words<'_>, figure: &Figure) -> (Vec<Wanted>, Vec<String>) {
    let (mut wanted, mut outside) = (Vec::new(), Vec::new());
    for label in words.labels {
        match label.on(figure.place, figure.source) {
            Some(at) => {
                let anchor = MmRect::new(at, at);
                let text = label.text.clone();
                wanted.push(Wanted { text, anchor, lost_leader: None, kept_leader: None, is_nameless: false });
            }
            None => outside.push(label.text.clone()),
        }
    }
    wanted.extend(own_texts(texts, words).map(|text| Wanted {
        text: text.string.clone(),
        anchor: text.anchor_among(&figure.lines),
        lost_leader: text.lost_leader.map(|(from, _)| from),
        kept_leader: text.kept_leader.map(|(from, _)| from),
        is_nameless: false,
    }));
    for &nameless in words.nameless {
        if let Some(wanted) = wanted.get_mut(nameless) {
            wanted.is_nameless = true;
        }
    }
    (wanted, outside)
}

/// The texts of a drawing that become labels. It often has its title in it, which stands above it already.
pub(super) fn own_texts<'t>(texts: &'t [Text], words: &Words<'_>) -> impl Iterator<Item = &'t Text> {
    let is_label = become_labels(words);
    let heading = words.title.filter(|_| words.before.is_none()).and_then(|title| heading_in(texts, title));
    let own = move |(number, text): &(usize, &Text)| Some(*number) != heading && is_label(text);
    texts.iter().enumerate().filter(own).map(|(_, text)| text)
}

/// Which text of a drawing is a heading with which the title begins, as "Rain in mm" of "Rain in mm, March to July": of
/// several words, above all other texts and in larger letters, so that it is the name of no place.
fn heading_in(texts: &[Text], title: &str) -> Option<usize> {
    let begins_title = |text: &Text| {
        let heading = text.string.trim();
        let rest = title.trim().strip_prefix(heading).map(str::trim_start);
        let goes_on = |rest: &str| rest.starts_with([',', ':', ';', '.', '(', '\u{2013}', '\u{2014}']);
        heading.contains(char::is_whitespace) && rest.is_some_and(goes_on)
    };
    let heading = texts.iter().position(|text| text.is_read() && begins_title(text))?;
    let Text { place, size, .. } = &texts[heading];
    let others = texts.iter().enumerate().filter(|(number, text)| *number != heading && text.is_read());
    let is_below = |other: &Text| other.place.min.y >= place.max.y && other.size < *size;
    let below: Vec<bool> = others.map(|(_, other)| is_below(other)).collect();
    (!below.is_empty() && !below.contains(&false)).then_some(heading)
}

/// Whether a text of a drawing becomes a label.
pub(super) fn become_labels(words: &Words<'_>) -> impl Fn(&Text) -> bool + use<> {
    // on a page that is drawn anew both may say the same
    let title = words.title.filter(|_| words.before.is_none());
    let (are_wanted, title) = (words.own_texts, title.map(|title| title.trim().to_owned()));
    let is_title = move |text: &Text| title.as_deref().is_some_and(|title| title == text.string.trim());
    move |text| are_wanted && text.is_read() && !text.of_legend && !is_title(text)
}

/// A leader line: as thin as lines can be, and of dots with wider steps.
fn leader(ends: [MmPoint; 2], layout: &Layout, plan: &Plan) -> Run {
    match &layout.medium {
        Medium::Print(_) => Run::stroke(plan.lines().width_min, ends.to_vec()),
        Medium::Dots(medium) => dots::leader_line(&ends, &medium.area, &plan.dots(medium)),
    }
}

/// Where the leader lines that a drawing has and the page keeps begin, and the places of their labels.
fn kept_leaders(wanted: &[Wanted], results: &[Result<Placed, labels::Unplaced>]) -> Vec<(MmPoint, MmRect)> {
    let kept =
        |(wanted, result): (&Wanted, &Result<Placed, _>)| Some((wanted.kept_leader?, result.as_ref().ok()?.place));
    wanted.iter().zip(results).filter_map(kept).collect()
}
