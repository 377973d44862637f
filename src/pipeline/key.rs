//! The key: a sheet of its own with the colours that occur, each as a patch of its texture, and with abbreviations.
//!
//! ```text
//!  ⠠⠅⠑⠽⠒ title
//!  +--------+
//!  | / / /  |  green        the texture as the figure has it, and its name
//!  +--------+
//!  jn  Jun                  abbreviations, in the order of the page
//! ```

use super::finish::{finished, origin, title_of_key};
use super::request::Request;
use super::unwritten::RefusedTexts;
use crate::braille::{Braille, Divide, Translator, unicode, wrap};
use crate::classes::{Class, Classes, Region};
use crate::dots;
use crate::lines::{Line, Run};
use crate::listing::list;
use crate::page::cells::CellGrid;
use crate::page::layout::Layout;
use crate::page::{BrailleText, DotMedium, Dots, Figure, Medium, Page, Parts, TextRole, Texture, ToldInKey};
use crate::profile::Plan;
use crate::raster::plane::Plane;
use crate::textures;
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{Error, Note, Reason, error};

/// When there is a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum KeySheets {
    /// Where labels are abbreviated, colours have a meaning, or the title has no room above the figure.
    #[default]
    Auto,
    /// Always, as long as there is anything to tell.
    Always,
    /// Never.
    Never,
}

impl KeySheets {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Auto, Self::Always, Self::Never];

    /// Its name: "auto", "always" or "never".
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Always => "always",
            Self::Never => "never",
        }
    }

    /// The one of this name.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are.
    pub fn named(name: &str) -> Result<Self, Error> {
        error::named(name, "choice of keys", Self::ALL, Self::name)
    }
}

/// Width and height of a patch, mm: what is within its outermost rows is more than the 20 x 12 mm that a texture
/// needs to be told, also where its rows lie 5 mm apart.
const PATCH: [f32; 2] = [32.0, 24.0];
/// Blank between a patch and its name, and between a patch and the next, mm.
const PATCH_GAP: f32 = 8.0;
/// HSL lightness of the colours of patches: that of a full colour.
const LIGHTNESS: f32 = 0.5;
/// Side of the squares in which the patches of a page of dots are given to its textures, mm.
const SQUARE: f32 = 0.5;
/// Blank cells between an abbreviation and its text.
const BETWEEN: usize = 2;

/// What a key says.
#[derive(Debug)]
pub(super) struct Entries<'a> {
    pub(super) translator: &'a Translator<'a>,
    pub(super) language: &'a str,
    /// The title of the page.
    pub(super) title: Option<&'a str>,
    /// Whether it has no room above the figure, so that it stands here alone.
    pub(super) has_title_alone: bool,
    pub(super) classes: Vec<Class>,
    /// What colours mean by the legend of the drawing.
    pub(super) meanings: Vec<(Class, String)>,
    /// The colours of areas that have no room for their texture, and what they mean by the legend, if it says so.
    pub(super) blank: Vec<(Class, Option<String>)>,
    /// Abbreviations and what they stand for.
    pub(super) abbreviations: Vec<(String, String)>,
    /// The page number of its first sheet.
    pub(super) number: Option<u32>,
}

impl Entries<'_> {
    /// What a page says of a key with these.
    pub(super) fn told(&self) -> ToldInKey {
        let meanings = |class: Class| {
            let own: Vec<_> = self.meanings.iter().filter(|(of, _)| *of == class).map(|(_, text)| text).collect();
            if own.is_empty() { vec![(class, None)] } else { own.iter().map(|t| (class, Some((*t).clone()))).collect() }
        };
        ToldInKey {
            colours: self.classes.iter().flat_map(|class| meanings(*class)).collect(),
            abbreviations: self.abbreviations.clone(),
            blank: self.blank.clone(),
            title: self.title.filter(|_| self.has_title_alone).map(str::to_owned),
        }
    }
}

/// The key of a page.
#[derive(Debug, Default)]
pub struct Key {
    /// Its sheets, none where there is none.
    pub sheets: Vec<Page>,
    /// What they tell.
    pub told: ToldInKey,
    /// What the maker of the page should know of it.
    pub notes: Vec<Note>,
}

impl Key {
    /// Says of bars without a texture which of them this key names as blank.
    pub(super) fn tell_of_blank(&self, notes: &mut [Note]) {
        let name = |(class, means): &(Class, Option<String>)| means.clone().unwrap_or_else(|| class.name().to_owned());
        let names: Vec<String> = self.told.blank.iter().map(name).collect();
        if names.is_empty() {
            return;
        }
        for note in notes {
            if let Note::NotOnPage(_, Reason::BarsTooSmall, told) = note {
                told.add(&format!("; the key names {} as blank", list(&names, "and")));
            }
        }
    }
}

/// One thing on a sheet of the key.
struct Item {
    patch: Option<Class>,
    text: String,
    lines: Vec<Vec<u8>>,
}

impl Item {
    /// The item in parts of at most so many lines of braille, as a sheet has room for; its text is that of each.
    fn over_sheets(self, most: usize) -> Vec<Self> {
        if self.lines.len() <= most {
            return vec![self];
        }
        let part = |(number, lines): (usize, &[Vec<u8>])| Self {
            patch: self.patch.filter(|_| number == 0),
            text: self.text.clone(),
            lines: lines.to_vec(),
        };
        self.lines.chunks(most).enumerate().map(part).collect()
    }
}

/// Texts are in one row if the tops of their dots are less than this below that of the highest, mm: half a row of
/// braille.
const ROW: f32 = 5.0;

/// A row of labels in two lines by turns has its lines less than this one below the other, mm: a line of braille and a
/// half.
const BY_TURNS: f32 = 15.0;
/// From so many labels on two lines by turns are taken for one row: fewer may stand so by chance.
const OF_TURNS: usize = 5;

/// A text and the box around its dots.
type PlacedText<'b> = (MmRect, &'b BrailleText);

/// Abbreviated texts in the order in which hands come to them: row by row from the top, and from the left; a row that
/// stands in two lines by turns, as the months of a chart, is one.
fn as_read(braille: &[BrailleText]) -> Vec<&BrailleText> {
    let short = braille.iter().filter(|text| text.abbreviation.is_some());
    let mut all: Vec<PlacedText<'_>> =
        short.map(|text| (text.dots.bounds().unwrap_or_else(MmRect::zero), text)).collect();
    all.sort_by(|(a, _), (b, _)| a.min.y.total_cmp(&b.min.y));
    let mut rows: Vec<Vec<PlacedText<'_>>> = Vec::new();
    for text in all {
        match rows.last_mut() {
            Some(row) if text.0.min.y - row[0].0.min.y < ROW => row.push(text),
            _ => rows.push(vec![text]),
        }
    }
    let mut read: Vec<Vec<PlacedText<'_>>> = Vec::new();
    for mut row in rows {
        row.sort_by(|(a, _), (b, _)| a.min.x.total_cmp(&b.min.x));
        match read.last().and_then(|above| by_turns(above, &row)) {
            Some(both) => {
                read.pop();
                read.push(both);
            }
            None => read.push(row),
        }
    }
    read.into_iter().flatten().map(|(_, text)| text).collect()
}

/// Two rows as one from the left, if they are one that stands in two lines by turns: three of four labels have their
/// next in the other line, and all are about as far apart. In the columns of a table one stands below the other.
fn by_turns<'b>(above: &[PlacedText<'b>], below: &[PlacedText<'b>]) -> Option<Vec<PlacedText<'b>>> {
    let top = |row: &[PlacedText<'_>]| row.iter().map(|(place, _)| place.min.y).fold(f32::INFINITY, f32::min);
    let in_line = |is_below: bool, row: &[PlacedText<'b>]| row.iter().map(|&text| (is_below, text)).collect::<Vec<_>>();
    let mut both = [in_line(false, above), in_line(true, below)].concat();
    both.sort_by(|(_, (a, _)), (_, (b, _))| a.center().x.total_cmp(&b.center().x));
    let turns = both.windows(2).filter(|pair| pair[0].0 != pair[1].0).count();
    let steps = both.windows(2).map(|pair| pair[1].1.0.center().x - pair[0].1.0.center().x);
    let (least, sum) = steps.fold((f32::INFINITY, 0.0), |(least, sum), step| (step.min(least), sum + step));
    let count = both.len().saturating_sub(1);
    let is_one = both.len() >= OF_TURNS
        && top(below) - top(above) < BY_TURNS
        && 4 * turns >= 3 * count
        && 2.0 * least * count as f32 >= sum;
    is_one.then(|| both.into_iter().map(|(_, text)| text).collect())
}

/// Abbreviations and what they stand for, each once, in the order of the page.
pub(super) fn abbreviations(braille: &[BrailleText]) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    for text in as_read(braille) {
        if let Some(short) = &text.abbreviation {
            let pair = (short.clone(), text.text.clone());
            if !all.contains(&pair) {
                all.push(pair);
            }
        }
    }
    all
}

/// The key of these entries, without sheets where there is nothing to tell.
pub(super) fn of_entries(
    entries: &Entries<'_>,
    layout: &Layout,
    source: Size,
    request: &Request<'_>,
) -> Result<Key, Error> {
    let Entries { classes, blank, abbreviations, has_title_alone, .. } = entries;
    if classes.is_empty() && blank.is_empty() && abbreviations.is_empty() && !has_title_alone {
        return Ok(Key::default());
    }
    let plan = request.plan;
    let cells = CellGrid::of(&layout.medium, plan.profile().braille.cell);
    let area = area(layout, plan);
    let width = cells.cells_in(area.width());
    // below a page number
    let room = area.height() - cells.size().line;
    let most = (1..).take_while(|&lines| cells.extent(1, lines).y <= room).count().max(1);
    let (items, notes) = items(entries, width, cells.cells_in(area.width() - PATCH[0] - PATCH_GAP));
    let items: Vec<Item> = items.into_iter().flat_map(|item| item.over_sheets(most)).collect();
    let number = Number { first: entries.number, entries, cells: &cells, area };
    let mut sheets = over_sheets(&items, &number);
    // several sheets are numbered in any case
    let number = Number { first: number.first.or((sheets.len() > 1).then_some(1)), ..number };
    if number.first != entries.number {
        sheets = over_sheets(&items, &number);
    }
    let pages = (0..).zip(&sheets).map(|(at, sheet)| page(sheet, &number, at, layout, source, request));
    Ok(Key { sheets: pages.collect::<Result<_, _>>()?, told: entries.told(), notes })
}

/// Page numbers of a key, at the top on the right of its sheets.
#[derive(Clone, Copy)]
struct Number<'a> {
    /// Page number of the first sheet; `None`: sheets have no numbers.
    first: Option<u32>,
    entries: &'a Entries<'a>,
    cells: &'a CellGrid<'a>,
    area: MmRect,
}

impl Number<'_> {
    /// On a sheet, counted from the first.
    fn text(&self, sheet: u32) -> Option<BrailleText> {
        let number = self.first?.saturating_add(sheet);
        let of_number = self.entries.translator.spell(&number.to_string()).ok()?.cells;
        let corner = MmPoint::new(self.area.max.x - self.cells.extent(of_number.len(), 1).x, self.area.min.y);
        let dots =
            Dots { diameter: self.cells.diameter, at: self.cells.dots(std::slice::from_ref(&of_number), corner) };
        Some(BrailleText::page_number(number, &of_number, dots, self.entries.language))
    }

    /// Where a sheet begins below its number, whose line a short first line shares.
    fn top(&self, first: Option<&Item>) -> f32 {
        let longest = first.filter(|item| item.patch.is_none()).map_or(usize::MAX, |item| {
            item.lines.iter().map(Vec::len).max().unwrap_or(0).saturating_add(BEFORE_NUMBER + MOST_DIGITS)
        });
        let is_shared = self.first.is_none() || longest <= self.cells.cells_in(self.area.width());
        self.area.min.y + if is_shared { 0.0 } else { self.cells.size().line }
    }
}

/// Blank cells before a page number, and the cells that it may have.
const BEFORE_NUMBER: usize = 3;
const MOST_DIGITS: usize = 6;

/// What stands on each sheet, and where.
fn over_sheets<'i>(items: &'i [Item], number: &Number<'_>) -> Vec<Vec<(MmPoint, &'i Item)>> {
    let (area, cells) = (number.area, number.cells);
    let mut sheets: Vec<Vec<(MmPoint, &Item)>> = vec![Vec::new()];
    let mut top = number.top(items.first());
    for (at, item) in items.iter().enumerate() {
        let of_text = cells.extent(1, item.lines.len()).y;
        let height = item.patch.map_or(of_text, |_| of_text.max(PATCH[1]));
        if top + height > area.max.y && sheets.last().is_some_and(|sheet| !sheet.is_empty()) {
            sheets.push(Vec::new());
            top = number.top(Some(item));
        }
        if let Some(sheet) = sheets.last_mut() {
            sheet.push((MmPoint::new(area.min.x, top), item));
        }
        // lines of one list stand as lines of braille do; everything else is set apart
        let is_list = at > 0 && item.patch.is_none();
        let blank = if is_list { cells.size().line - cells.extent(1, 1).y } else { PATCH_GAP };
        top += height + blank;
    }
    sheets
}

/// Where marks can be.
fn area(layout: &Layout, plan: &Plan) -> MmRect {
    let margin = plan.profile().page.margin;
    let reach = match &layout.medium {
        Medium::Print(_) => MmRect::new(MmPoint::zero(), layout.sheet.into()),
        Medium::Dots(dots) => {
            let radius = 0.5 * dots.diameter();
            dots.area.bounds().inflate(radius, radius)
        }
    };
    reach.inflate(-margin, -margin)
}

/// What stands on the sheets, and what could not be written: a patch stands there without its name.
fn items(entries: &Entries<'_>, width: usize, beside_patch: usize) -> (Vec<Item>, Vec<Note>) {
    let translator = entries.translator;
    let mut refused = RefusedTexts::default();
    let mut or_told = |text: &str, braille: Result<Braille, String>| {
        braille.unwrap_or_else(|why| {
            refused.add(text, why);
            Braille::default()
        })
    };
    let word = |name: &str| translator.word(name).to_owned();
    let heading = match entries.title {
        Some(title) => format!("{}: {title}", word("key")),
        None => word("key"),
    };
    let mut lines =
        |text: &str, width: usize| wrap(&or_told(text, translator.translate(text)), width, Divide::Words).lines;
    let mut items = vec![Item { patch: None, lines: lines(&heading, width), text: heading }];
    items.extend(entries.classes.iter().map(|&class| {
        let meanings = entries.meanings.iter().filter(|(of, _)| *of == class).map(|(_, text)| text.as_str());
        let text = match meanings.collect::<Vec<_>>().join(", ") {
            none if none.is_empty() => word(class.name()),
            meanings => format!("{}: {meanings}", word(class.name())),
        };
        Item { patch: Some(class), lines: lines(&text, beside_patch), text }
    }));
    let name = |(class, text): &(Class, Option<String>)| text.clone().unwrap_or_else(|| word(class.name()));
    let blank: Vec<String> = entries.blank.iter().map(name).collect();
    items.extend((!blank.is_empty()).then(|| {
        let text = format!("{}: {}", word("blank"), blank.join(", "));
        Item { patch: None, lines: lines(&text, width), text }
    }));
    items.extend(entries.abbreviations.iter().map(|(short, text)| {
        // letter by letter, as on the page
        let mut first = or_told(short, translator.spell(short)).cells;
        first.resize(first.len() + BETWEEN, 0);
        // what does not fit into the first line goes on below its text
        let indent = first.len();
        let text_of = or_told(text, translator.translate(text));
        let rest = wrap(&text_of, width.saturating_sub(indent).max(1), Divide::Words).lines;
        let lines = rest.into_iter().enumerate().map(|(i, line)| {
            let before = if i == 0 { first.clone() } else { vec![0; indent] };
            [before, line].concat()
        });
        Item { patch: None, lines: lines.collect(), text: format!("{short}: {text}") }
    }));
    items.retain(|item| item.patch.is_some() || !item.lines.is_empty());
    (items, refused.notes().collect())
}

fn page(
    items: &[(MmPoint, &Item)],
    number: &Number<'_>,
    sheet: u32,
    layout: &Layout,
    source: Size,
    request: &Request<'_>,
) -> Result<Page, Error> {
    let Number { entries, cells, area, .. } = *number;
    let (mut textures, mut braille) = (Vec::new(), Vec::from_iter(number.text(sheet)));
    for &(corner, item) in items {
        let place = item.patch.map(|_| MmRect::new(corner, corner + MmVector::from(PATCH)));
        if let (Some(class), Some(place)) = (item.patch, place) {
            textures.extend(patch(class, place, &layout.medium, request.plan));
        }
        let beside = place.map_or(MmVector::zero(), |place| {
            let down = 0.5 * (place.height() - cells.extent(1, item.lines.len()).y);
            MmVector::new(place.width() + PATCH_GAP, down.max(0.0))
        });
        if item.lines.is_empty() {
            continue; // a name that could not be written, which was told
        }
        braille.push(BrailleText {
            role: TextRole::Key,
            text: item.text.clone(),
            language: entries.language.to_owned(),
            abbreviation: None,
            lines: item.lines.iter().map(|line| unicode(line)).collect(),
            dots: Dots { diameter: cells.diameter, at: cells.dots(&item.lines, corner + beside) },
            leader: None,
        });
    }
    let figure = Figure { place: area, source, textures, lines: Vec::new() };
    let parts = Parts {
        title: title_of_key(request.title, request.language),
        origin: origin(request, source, &braille),
        braille,
        medium: layout.medium.clone(),
        ..Parts::of(layout.sheet, figure)
    };
    finished(parts, request)
}

/// A patch of the texture that stands for a class.
fn patch(class: Class, place: MmRect, medium: &Medium, plan: &Plan) -> Vec<Texture> {
    match medium {
        Medium::Print(_) => vec![textures::sample(class, LIGHTNESS, 1.0, place, &plan.textures())],
        Medium::Dots(medium) => pressed(class, place, medium, plan),
    }
}

/// A patch of dots: what the figure has for an area of this class beside lines, as textures are dense there.
fn pressed(class: Class, place: MmRect, medium: &DotMedium, plan: &Plan) -> Vec<Texture> {
    let params = plan.dot_textures(medium);
    let size = Size::new((place.width() / SQUARE) as u32, (place.height() / SQUARE) as u32);
    let count = size.width * size.height;
    let grey = (255.0 * LIGHTNESS) as u8;
    let classes = Classes {
        size,
        region: vec![Some(0); count as usize],
        regions: vec![Region { class, colour: [grey; 3], cells: count }],
        lightness: Plane::filled(size, LIGHTNESS),
        fringe: Vec::new(),
    };
    // lines all around that are not drawn, too far away to take any dots
    let away = (params.line_gap + 1) as f32 * params.pitch + params.pitch;
    let around = place.inflate(away, away);
    let corners = [
        around.min,
        MmPoint::new(around.max.x, around.min.y),
        around.max,
        MmPoint::new(around.min.x, around.max.y),
        around.min,
    ];
    let line = Line { strength: 0.0, runs: vec![Run::stroke(params.diameter, corners.to_vec())] };
    dots::textures::fill(&classes, place, &[line], &medium.area, &params)
}

#[cfg(test)]
mod tests;
