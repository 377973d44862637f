//! The way from bytes to a picture on several sheets.

use super::draw::{Marks, draw};
use super::finish::{finished, origin, title_of_overview, too_black};
use super::given::Given;
use super::progress::{Stage, Watch, run};
use super::request::{Request, SLACK};
use crate::page::layout::{self, Layout};
use crate::page::spread::{self, Cut, Grid, Spread};
use crate::page::{Dots, Figure, InSet, LeftOut, Line, Medium, MediumParams, Page, Parts, Print, frame};
use crate::picture::Picture;
use crate::units::{MmRect, Size};
use crate::{Error, Note};

/// The sheets of a picture and what their maker should know.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Sheets {
    /// The overview on a sheet of its own, if there is one; then the picture, row by row.
    pub pages: Vec<Page>,
    /// Remarks, in the order of the stages.
    pub notes: Vec<Note>,
}

/// Makes a picture that is spread over several sheets. It is drawn once, as for one large sheet, and cut: what two
/// sheets both show is the same on both. Without a `grid` there are as few sheets as have room for the width asked
/// for. `watch` is told of every stage.
///
/// # Errors
/// When the picture cannot be read or drawn, the sheets have no room for it, or the page is one of dots; see [`Error`].
pub fn convert<'p>(
    picture: impl Into<Picture<'p>>,
    given: &Given,
    grid: Option<Grid>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Sheets, Error> {
    let print = match request.plan.medium() {
        MediumParams::Print(print) => print,
        MediumParams::Dots { device, .. } => return Err(Error::OneSheet { device: device.name }),
    };
    let grid = |size| grid.map_or_else(|| fewest(size, request), Ok);
    let Marks { figure, overview, left_out, is_flat, mut notes, .. } =
        draw(picture.into(), given, request, &|size| places(size, grid(size)?, print, request), watch)?;
    let grid = grid(figure.source)?;
    let pages = run(watch, Stage::Page, || assemble(&figure, overview, left_out, (grid, print), request))?;
    if pages.iter().all(Page::is_empty) {
        notes.push(Note::EmptyPage);
    } else if request.plan.profile().figure.lines && figure.lines.is_empty() && !is_flat {
        notes.push(Note::NoLines);
    }
    let blackest = pages.iter().map(Page::black_share).fold(0.0, f32::max);
    notes.extend(too_black(blackest, &print));
    Ok(Sheets { pages, notes })
}

/// The grid of fewest sheets that have room for the width asked for.
fn fewest(size: Size, request: &Request<'_>) -> Result<Grid, Error> {
    let mut refused = Error::NoRoomOnSheets { grid: format!("{0}x{0}", Grid::MOST) };
    for grid in Grid::by_number() {
        match spread_of(size, grid, request) {
            Ok(_) => return Ok(grid),
            Err(error) => refused = error,
        }
    }
    Err(refused)
}

/// The figure in the space of all sheets together, the overview on a sheet of its own.
fn places(size: Size, grid: Grid, print: Print, request: &Request<'_>) -> Result<Layout, Error> {
    let spread = spread_of(size, grid, request)?;
    let params = request.plan.layout();
    let overview = params.overview.map(|_| overview_sheet(size, request).figure);
    let (mark, medium) = (spread.mark, Medium::Print(print));
    Ok(Layout { sheet: spread.sheet, figure: spread.figure, overview, mark, heading: None, medium })
}

fn aspect(size: Size) -> f32 {
    size.width as f32 / size.height as f32
}

fn spread_of(size: Size, grid: Grid, request: &Request<'_>) -> Result<Spread, Error> {
    request.fit.check()?;
    let overlap = request.plan.profile().sheets.overlap;
    let fit = |widest| spread::fit(aspect(size), widest, grid, overlap, &request.plan.layout());
    let largest = fit(f32::MAX).ok_or_else(|| Error::NoRoomOnSheets { grid: grid.to_string() })?;
    match request.fit.width {
        None => Ok(largest),
        Some(wanted) if wanted > largest.figure.width() + SLACK => {
            Err(Error::TooWide { wanted, most: largest.figure.width(), without_overview: None })
        }
        Some(wanted) => fit(wanted).ok_or_else(|| Error::NoRoomOnSheets { grid: grid.to_string() }),
    }
}

/// The overview as large as one sheet allows.
fn overview_sheet(size: Size, request: &Request<'_>) -> Layout {
    layout::fit(aspect(size), f32::MAX, &layout::Params { overview: None, ..request.plan.layout() })
}

fn assemble(
    figure: &Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    left_out: LeftOut,
    (grid, print): (Grid, Print),
    request: &Request<'_>,
) -> Result<Vec<Page>, Error> {
    let params = request.plan.layout();
    let spread = spread_of(figure.source, grid, request)?;
    let cuts = spread.cut(figure, params.frame.as_ref(), params.margin);
    let names: Vec<String> = cuts.iter().map(|cut| cut.name.clone()).collect();
    let mut pages = Vec::new();
    if let Some((place, lines)) = overview {
        let layout = overview_sheet(figure.source, request);
        let own = Figure { place, source: figure.source, textures: Vec::new(), lines };
        let frame = params.frame.as_ref().map_or_else(Dots::default, |params| frame::printed(place, params));
        let title = title_of_overview(request.title);
        let parts = Parts {
            sheet: layout.sheet,
            orientation_mark: layout.mark,
            frame,
            ..parts(title, own, (grid, print), InSet::OverviewOf(names.clone()), request)
        };
        pages.push(finished(parts, request)?);
    }
    // what is left out of the whole picture, as no sheet knows its own share
    let left_out = LeftOut { by_place: None, shapes: 0, ..left_out }.to_origin();
    for cut in &cuts {
        let Cut { figure, frame, ticks, label, name } = cut.clone();
        let title = format!("{}, sheet {name}", request.title);
        let parts = Parts {
            sheet: spread.sheet,
            orientation_mark: spread.mark.clone(),
            frame,
            registration: ticks,
            labels: vec![label],
            ..parts(title, figure, (grid, print), InSet::One(name, names.clone()), request)
        };
        let origin = [parts.origin.clone(), left_out.clone()].concat();
        pages.push(finished(Parts { origin, ..parts }, request)?);
    }
    Ok(pages)
}

/// What all sheets have, with nothing beside the figure.
fn parts(title: String, figure: Figure, (grid, print): (Grid, Print), in_set: InSet, request: &Request<'_>) -> Parts {
    let mut origin = origin(request, figure.source, &[]);
    origin.extend([("sheets".to_owned(), grid.to_string()), in_set.to_origin()]);
    Parts { title, origin, medium: Medium::Print(print), ..Parts::of([0.0, 0.0], figure) }
}
