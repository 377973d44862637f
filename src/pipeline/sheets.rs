//! From bytes to a picture on several sheets.

use super::draw::{DrawnMarks, FromPerson, draw, find};
use super::finish::{finished, origin, title_of_overview, title_of_sheet};
use super::for_words::ForWords;
use super::given::Given;
use super::lost_signs;
use super::progress::{Stage, Watch, run_stage};
use super::read::ReadPicture;
use super::remarks::{FinishedSheets, Remarks};
use super::request::{Request, SLACK};
use super::unwritten::NoRoomAbove;
use super::words::{OnPage, Words, WrittenWords};
use crate::page::heading::HeadingParams;
use crate::page::layout::{self, Layout, Orientation};
use crate::page::spread::{self, Cut, LABEL_CELLS, SheetGrid, Spread};
use crate::page::{BrailleText, Dots, Figure, InSet, LeftOut, Line, Medium, Page, Parts, Run, frame};
use crate::picture::Picture;
use crate::units::{MmRect, Size};
use crate::{Error, Note, dots};

/// The sheets of a picture and what their maker should know.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Sheets {
    /// The overview, which has the first sheet to itself, if there is one.
    pub overview: Option<Page>,
    /// The picture, row by row, without sheets on which nothing of it lies. Which one each is says
    /// [`Page::part_of_set`]: its row as a letter and its column as a number, such as `b1`.
    pub pages: Vec<Page>,
    /// The key, which follows on sheets of its own: the colours that occur and abbreviations.
    pub key: Vec<Page>,
    /// Remarks, first what makes a page wrong or lacks on it. They name the texts of a drawing that are left out.
    pub notes: Vec<Note>,
}

impl Sheets {
    /// All sheets in the order in which they are numbered: the overview, the picture, the key; as
    /// [`write_pdf`](crate::write_pdf) and [`write_dots`](crate::write_dots) take them.
    pub fn all(&self) -> impl Iterator<Item = &Page> {
        self.overview.iter().chain(&self.pages).chain(&self.key)
    }

    /// All sheets in the order of [`Sheets::all`].
    #[must_use]
    pub fn into_pages(self) -> Vec<Page> {
        self.overview.into_iter().chain(self.pages).chain(self.key).collect()
    }
}

/// Makes a picture that is spread over several sheets. It is drawn once, as for one large sheet, and cut: what two
/// sheets both show is the same on both. Each sheet has the title and its own page number; labels are placed in the
/// whole picture, each whole on a sheet. Without a `grid` there are as few sheets as have room for the width asked
/// for. `watch` is told of every stage.
///
/// # Errors
/// When the picture cannot be read or drawn, or the sheets have no room for it; see [`Error`].
pub fn convert<'p>(
    picture: impl Into<Picture<'p>>,
    words: &Words<'_>,
    given: &Given,
    grid: Option<SheetGrid>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Sheets, Error> {
    let plan = request.plan;
    let written = WrittenWords::new(words, plan);
    let lay = |size| lay(size, grid, &written, request);
    let layout_of = |size: Size, _| Ok(together(&lay(size)?));
    let picture = ReadPicture::of(picture.into(), given, request, &layout_of, watch)?;
    let found = find(picture, FromPerson { given, words }, request, &layout_of, &|_, layout, _| layout, watch)?;
    let marks = draw(found, given, request, watch)?;
    let DrawnMarks { mut figure, overview, layout, facts, said, lost_signs, legend, texts, notes, .. } = marks;
    let for_words = ForWords::of(words, legend, &lost_signs, facts.coloured_ground);
    let words = &for_words.known_to(words);
    let mut remarks = Remarks::of_marks(notes);
    remarks.extend(lost_signs::told(&lost_signs, &texts, words, &figure, layout.sheets.as_ref()));
    let laid = lay(figure.source)?;
    let sheet = laid.spread.layout_of_sheet();
    let mut sheets = run_stage(watch, Stage::Page, || {
        let tiles = laid.spread.tiles();
        let OnPage { braille: labels, notes, counts, .. } =
            written.labels(&layout, &tiles, &mut figure, &texts, words, plan);
        let left_out = said.with_labels(counts.left_out).left_out;
        let (sheets, above) = assemble((&figure, &labels), overview, left_out, &laid, &written, request)?;
        let before = sheets.all().count() as u32;
        let key = written.key(words, &labels, &figure, before, &sheet, request)?;
        remarks.add_words(written.notes(), above, notes, &key);
        let pages = sheets.pages.into_iter().map(|page| page.with_key(&key.told)).collect();
        Ok::<_, Error>(Sheets { pages, key: key.sheets, ..sheets })
    })?;
    let of_picture = sheets.overview.iter().chain(&sheets.pages).collect();
    let has_lines = !figure.lines.is_empty();
    let all = FinishedSheets { of_picture, key: &sheets.key, has_lines, medium: &sheet.medium };
    sheets.notes = remarks.of_sheets(&all, facts, plan);
    Ok(sheets)
}

/// Where a picture lies on its sheets, and where its overview does.
struct Laid {
    grid: SheetGrid,
    spread: Spread,
    overview: Option<Layout>,
}

/// Lays a picture of this size out below its title, or without one where that leaves too little room.
fn lay(size: Size, grid: Option<SheetGrid>, written: &WrittenWords<'_>, request: &Request<'_>) -> Result<Laid, Error> {
    let least = request.plan.profile().figure.min_side;
    let heading = written.heading_beside(LABEL_CELLS);
    let lay = |heading: Option<HeadingParams>| {
        let grid = grid.map_or_else(|| fewest(size, heading, request), Ok)?;
        Ok::<_, Error>((grid, spread_of(size, grid, heading, request)?))
    };
    let is_large = |(_, spread): &(SheetGrid, Spread)| spread.figure.width().min(spread.figure.height()) >= least;
    let below = heading.and_then(|heading| lay(Some(heading)).ok()).filter(is_large);
    let (grid, spread) = below.map_or_else(|| lay(None), Ok)?;
    let overview = request.plan.layout().overview.map(|_| overview_sheet(size, &spread, written, request));
    Ok(Laid { grid, spread, overview })
}

/// The grid of fewest sheets that have room for the width asked for.
fn fewest(size: Size, heading: Option<HeadingParams>, request: &Request<'_>) -> Result<SheetGrid, Error> {
    let mut refused = Error::NoRoomOnSheets { grid: format!("{0}x{0}", SheetGrid::MOST) };
    for grid in SheetGrid::by_number() {
        match spread_of(size, grid, heading, request) {
            Ok(_) => return Ok(grid),
            Err(error) => refused = error,
        }
    }
    Err(refused)
}

/// The figure in the space of all sheets together, the overview on a sheet of its own: the first of them, whose dots
/// are the first of all.
fn together(laid: &Laid) -> Layout {
    let Laid { spread, overview, .. } = laid;
    let (mark, medium) = (spread.mark.clone(), spread.together.clone());
    let overview = overview.as_ref().map(|overview| overview.figure);
    let (figure, room) = (spread.figure, spread.figure);
    let sheets = Some(spread.windows());
    Layout { sheet: spread.sheet, figure, room, overview, mark, heading: None, medium, sheets }
}

fn aspect(size: Size) -> f32 {
    size.width as f32 / size.height as f32
}

fn spread_of(
    size: Size,
    grid: SheetGrid,
    heading: Option<HeadingParams>,
    request: &Request<'_>,
) -> Result<Spread, Error> {
    request.fit.check()?;
    let overlap = request.plan.profile().sheets.overlap;
    let params = layout::Params { heading, ..request.plan.layout() };
    let fit = |widest| spread::fit(aspect(size), widest, grid, overlap, &params);
    let largest = fit(f32::MAX).ok_or_else(|| Error::NoRoomOnSheets { grid: grid.to_string() })?;
    match request.fit.width {
        None => Ok(largest),
        Some(wanted) if wanted > largest.figure.width() + SLACK => {
            Err(Error::TooWide { wanted, most: largest.figure.width(), without_overview: None })
        }
        Some(wanted) => fit(wanted).ok_or_else(|| Error::NoRoomOnSheets { grid: grid.to_string() }),
    }
}

/// The overview as large as one sheet allows below the title; of dots, on a sheet that lies as the others do.
fn overview_sheet(size: Size, spread: &Spread, written: &WrittenWords<'_>, request: &Request<'_>) -> Layout {
    let own = request.plan.layout();
    let orientation = match spread.medium {
        Medium::Print(_) => own.orientation,
        Medium::Dots(_) if spread.sheet[0] > spread.sheet[1] => Orientation::Landscape,
        Medium::Dots(_) => Orientation::Portrait,
    };
    let params = layout::Params { overview: None, orientation, heading: written.heading_beside(0), ..own };
    layout::fit(aspect(size), f32::MAX, &params)
}

/// The sheets without their key and without remarks, and what has no room at the top of them.
fn assemble(
    (figure, labels): (&Figure, &[BrailleText]),
    overview: Option<(MmRect, Vec<Line>)>,
    left_out: LeftOut,
    laid: &Laid,
    written: &WrittenWords<'_>,
    request: &Request<'_>,
) -> Result<(Sheets, NoRoomAbove), Error> {
    let Laid { grid, spread, .. } = laid;
    let cuts = spread.cut(figure, &around(figure.place, &spread.together, request), labels);
    let names: Vec<String> = cuts.iter().map(|cut| cut.name.clone()).collect();
    let (mut on_overview, mut pages, mut above) = (None, Vec::new(), NoRoomAbove::default());
    let mut heading = |layout: &Layout, number: usize| {
        let (braille, own) = written.heading(number as u32, layout, request.plan);
        above = above.or(own);
        braille
    };
    if let Some(((place, lines), layout)) = overview.zip(laid.overview.as_ref()) {
        let own = Figure { place, source: figure.source, textures: Vec::new(), lines };
        let title = title_of_overview(request.title, request.language);
        let in_set = InSet::OverviewOf(names.clone());
        let parts = Parts {
            frame: around(place, &layout.medium, request),
            ..parts(title, own, heading(layout, 0), (*grid, layout), in_set, request)
        };
        on_overview = Some(finished(parts, request)?);
    }
    // what is left out of the whole picture, as no sheet knows its own share
    let left_out = LeftOut { by_place: None, shapes: 0, ..left_out }.to_origin();
    let layout = spread.layout_of_sheet();
    let before = usize::from(on_overview.is_some());
    for (number, cut) in (before..).zip(cuts) {
        let Cut { figure, frame, ticks, label, braille, name } = cut;
        let title = title_of_sheet(request.title, &name, request.language);
        let braille = [heading(&layout, number), braille].concat();
        let in_set = InSet::One(name, names.clone());
        let parts = Parts {
            frame,
            registration: ticks.iter().map(|tick| as_marked(tick, &layout.medium, request)).collect(),
            labels: vec![label],
            ..parts(title, figure, braille, (*grid, &layout), in_set, request)
        };
        let origin = [parts.origin.clone(), left_out.clone()].concat();
        pages.push(finished(Parts { origin, ..parts }, request)?);
    }
    Ok((Sheets { overview: on_overview, pages, key: Vec::new(), notes: Vec::new() }, above))
}

/// The frame around a picture.
fn around(place: MmRect, medium: &Medium, request: &Request<'_>) -> Dots {
    match (request.plan.layout().frame, medium) {
        (None, _) => Dots::default(),
        (Some(params), Medium::Print(_)) => frame::printed(place, &params),
        (Some(params), Medium::Dots(medium)) => frame::dotted(place, &params, medium),
    }
}

/// A mark beside the picture, as ink or as dots.
fn as_marked(run: &Run, medium: &Medium, request: &Request<'_>) -> Run {
    match medium {
        Medium::Print(_) => run.clone(),
        Medium::Dots(medium) => dots::mark(&run.points, &medium.area, &request.plan.dots(medium)),
    }
}

/// What all sheets have, with nothing beside the figure but the mark.
fn parts(
    title: String,
    figure: Figure,
    braille: Vec<BrailleText>,
    (grid, layout): (SheetGrid, &Layout),
    in_set: InSet,
    request: &Request<'_>,
) -> Parts {
    let mut origin = origin(request, figure.source, &braille);
    origin.extend([("sheets".to_owned(), grid.to_string()), in_set.to_origin()]);
    let orientation_mark = layout.mark.as_ref().map(|mark| as_marked(mark, &layout.medium, request));
    let medium = layout.medium.clone();
    Parts { title, origin, medium, orientation_mark, braille, ..Parts::of(layout.sheet, figure) }
}
