//! The way from bytes to a page: the only module that names every stage.
//!
//! A stage whose result the page does not need does not run; the caller is told which, and why.

mod beside;
pub mod colours;
mod dots;
mod fit;
pub mod sheets;
pub mod trace;

pub use dots::title_of_overview;
pub use fit::Fit;

use crate::classes::{self, Classes};
use crate::devices::Family;
use crate::edges::{self, Edges};
use crate::frame::Frame;
use crate::lines::{self, Drawn, Line};
use crate::page::layout::Layout;
use crate::page::{self, Dots, Figure, Medium, Overview, Page, Parts, Print, Texture, frame};
use crate::picture::Picture;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::raster::decode::{self, Fonts, Limits, Options, Source};
use crate::units::{MmRect, Size};
use crate::{Error, Note, textures};

/// A page and what its maker should know.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// The finished page.
    pub page: Page,
    /// Of a page of dots, the overview, which follows on a sheet of its own.
    pub overview: Option<Page>,
    /// Remarks, in the order of the stages.
    pub notes: Vec<Note>,
}

/// A step on the way, for progress and timings; in the order in which they run, or begin where several run side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Bytes to pixels.
    Decode,
    /// Pixels to contours.
    Edges,
    /// Contours to lines in millimetres.
    Lines,
    /// The lines of the overview.
    Overview,
    /// Telling hues apart, the larger part of [`Stage::Classes`]; only ever told of when it is skipped.
    Hues,
    /// Pixels to colour classes and their regions.
    Classes,
    /// Regions to glyphs.
    Textures,
    /// Everything to a page.
    Page,
}

impl Stage {
    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Decode => "decode",
            Self::Edges => "edges",
            Self::Lines => "lines",
            Self::Overview => "overview",
            Self::Hues => "hues",
            Self::Classes => "classes",
            Self::Textures => "textures",
            Self::Page => "page",
        }
    }
}

/// What the pipeline tells while it works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    /// A stage begins; others may run already.
    Begin(Stage),
    /// A stage that began is done.
    End(Stage),
    /// A stage, or a part of it, is not needed for this page, and why.
    Skip(Stage, &'static str),
}

/// Is told of every stage: where a program keeps its clock or its progress bar. Stages that run side by side tell from the
/// threads that they run on, one at a time.
pub type Watch<'a> = dyn FnMut(Event) + Send + 'a;

/// Everything beside the picture's bytes.
pub struct Request<'a> {
    /// The checked profile.
    pub plan: &'a Plan,
    /// What decoding may cost.
    pub limits: Limits,
    /// Fonts for drawings; asked only when a drawing has text.
    pub fonts: &'a Fonts<'a>,
    /// What the page is called, such as the picture's file name.
    pub title: &'a str,
    /// Which part of the picture is drawn, how large, and whether for the back of the sheet.
    pub fit: Fit,
}

/// Smallest width and height of a picture, px: below this there is nothing to find a contour in.
const MIN_PIXELS: u32 = 8;

/// Share of the contours left out for want of room from which the maker is told. Photographs of many things leave out 0.2
/// to 0.3 and lose little by it.
const CROWDED: f32 = 0.35;

/// Makes the page of a picture. `watch` is told of every stage.
///
/// # Errors
/// When no page can be made at all; see [`Error`].
pub fn convert<'p>(
    picture: impl Into<Picture<'p>>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Drawing, Error> {
    let plan = request.plan;
    let Marks { figure, overview, shares, layout, is_flat, mut notes } =
        draw(picture.into(), request, &|size| request.fit.layout(size, plan), watch)?;
    let (page, overview) = run(watch, Stage::Page, || match &layout.medium {
        Medium::Print(_) => Ok((assemble(figure, overview, shares, &layout, request)?, None)),
        Medium::Dots(medium) => dots::assemble(figure, overview, shares, &layout, medium, request),
    })?;
    if page.is_empty() {
        notes.push(Note::EmptyPage);
    } else if plan.profile().figure.lines && page.figure.lines.is_empty() && !is_flat {
        notes.push(Note::NoLines);
    }
    match &layout.medium {
        Medium::Print(print) => notes.extend(too_black(page.black_share(), print)),
        Medium::Dots(medium) => notes.extend((medium.device.family == Family::Cells).then_some(Note::UnevenDots)),
    }
    Ok(Drawing { page, overview, notes })
}

/// All marks of a picture, where its layout puts them.
struct Marks {
    figure: Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    /// Of each class of colours, where they were looked at.
    shares: Option<[f32; 5]>,
    layout: Layout,
    is_flat: bool,
    notes: Vec<Note>,
}

/// Everything but the page: decodes a picture and draws it where `layout_of` its size says.
fn draw(
    picture: Picture<'_>,
    request: &Request<'_>,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
    watch: &mut Watch<'_>,
) -> Result<Marks, Error> {
    let (plan, fit) = (request.plan, &request.fit);
    let working_size = |source: Source| working_size(source, layout_of, fit, plan);
    let options = Options { limits: request.limits, fonts: request.fonts, crop: fit.crop, working_size: &working_size };
    let picture = run(watch, Stage::Decode, || decode::decode_picture(picture, &options))?;
    let layout = layout_of(picture.source.size)?;
    let mut notes = picture.notes;

    let is_flat = picture.raster.is_flat();
    let edges = find_edges(&picture.raster, is_flat, &layout, plan, watch);
    let has_lines = plan.profile().figure.lines && edges.as_ref().is_some_and(|edges| !edges.is_empty());
    let (drawn, (overview, classes)) = beside::both(
        has_lines,
        watch,
        |watch| draw_lines(edges.as_ref(), &layout, plan, watch),
        |watch| {
            let overview = draw_overview(edges.as_ref(), &layout, plan, watch);
            (overview, sort_colours(&picture.raster, edges.as_ref(), &layout, plan, watch))
        },
    );
    notes.extend(crowded(&drawn));
    let lines = drawn.lines;
    drop(edges);
    drop(picture.raster);
    let textures = draw_textures(classes.as_ref(), &layout, &lines, plan, watch);
    let figure = Figure { place: layout.figure, source: picture.source.size, textures, lines };
    Ok(Marks { figure, overview, shares: classes.as_ref().map(Classes::shares), layout, is_flat, notes })
}

fn run<T>(watch: &mut Watch<'_>, stage: Stage, work: impl FnOnce() -> T) -> T {
    watch(Event::Begin(stage));
    let result = work();
    watch(Event::End(stage));
    result
}

/// The picture's size in pixels for its size on the sheet: as many as the profile wants for a millimetre, but never more
/// than there are.
fn working_size(
    source: Source,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
    fit: &Fit,
    plan: &Plan,
) -> Result<Size, Error> {
    let Source { size, is_drawing } = source;
    enough_pixels(size)?;
    let place = layout_of(size)?.figure;
    let figure = &plan.profile().figure;
    let side = place.width().min(place.height());
    if side < figure.min_side {
        let least = figure.min_side;
        let why = match fit.width {
            None => format!(
                "so long and narrow a picture would be only {side:.1} mm wide on the sheet, and {least} mm is the least; crop it"
            ),
            Some(_) => format!(
                "at the width asked for, its shorter side would be only {side:.1} mm, and {least} mm is the least; ask for more"
            ),
        };
        return Err(Error::TooSmall { size, why });
    }
    let pixels = |mm: f32, own: u32| {
        let wanted = ((mm * figure.resolution).round() as u32).max(1);
        if is_drawing { wanted } else { wanted.min(own) }
    };
    Ok(Size::new(pixels(place.width(), size.width), pixels(place.height(), size.height)))
}

fn enough_pixels(size: Size) -> Result<(), Error> {
    if size.width < MIN_PIXELS || size.height < MIN_PIXELS {
        let why = format!("too few to find anything in; give one of at least {MIN_PIXELS} x {MIN_PIXELS}");
        return Err(Error::TooSmall { size, why });
    }
    Ok(())
}

fn find_edges(raster: &Raster, is_flat: bool, layout: &Layout, plan: &Plan, watch: &mut Watch<'_>) -> Option<Edges> {
    let reason = if !plan.profile().figure.lines && layout.overview.is_none() {
        "neither the figure nor an overview has lines"
    } else if is_flat {
        "the picture is of one colour"
    } else {
        let px_per_mm = 1.0 / Frame::new(raster.size(), layout.figure).mm_per_px();
        return Some(run(watch, Stage::Edges, || edges::find(raster, &plan.edges(px_per_mm))));
    };
    watch(Event::Skip(Stage::Edges, reason));
    None
}

fn draw_lines(edges: Option<&Edges>, layout: &Layout, plan: &Plan, watch: &mut Watch<'_>) -> Drawn {
    let reason = match edges {
        _ if !plan.profile().figure.lines => "figure.lines is off",
        Some(edges) if !edges.is_empty() => {
            let frame = Frame::new(edges.size, layout.figure);
            return run(watch, Stage::Lines, || {
                let drawn = lines::draw(edges, &frame, layout.figure, &plan.lines());
                dots::pressed(drawn, layout.figure, layout, plan)
            });
        }
        _ => "there are no contours",
    };
    watch(Event::Skip(Stage::Lines, reason));
    Drawn::default()
}

/// What the maker is told when much was left out for want of room.
fn crowded(drawn: &Drawn) -> Option<Note> {
    (drawn.crowded_out >= CROWDED).then(|| Note::Crowded((100.0 * drawn.crowded_out).round() as u32))
}

/// The overview's lines are drawn from the contours anew for their own smaller size: the same millimetre rules leave fewer.
fn draw_overview(
    edges: Option<&Edges>,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Option<(MmRect, Vec<Line>)> {
    let reason = match (layout.overview, edges) {
        (None, _) => "overview.on is off",
        (Some(place), Some(edges)) if !edges.is_empty() => {
            let frame = Frame::new(edges.size, place);
            let lines = run(watch, Stage::Overview, || {
                let drawn = lines::draw(edges, &frame, place, &plan.lines());
                dots::of_overview(drawn.lines, place, layout, plan)
            });
            return (!lines.is_empty()).then_some((place, lines));
        }
        _ => "there are no contours",
    };
    watch(Event::Skip(Stage::Overview, reason));
    None
}

fn sort_colours(
    raster: &Raster,
    edges: Option<&Edges>,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Option<Classes> {
    if !plan.profile().figure.textures {
        watch(Event::Skip(Stage::Classes, "figure.textures is off"));
        return None;
    }
    if raster.is_grey() {
        watch(Event::Skip(Stage::Hues, "the picture is grey"));
    }
    let px_per_mm = 1.0 / Frame::new(raster.size(), layout.figure).mm_per_px();
    Some(run(watch, Stage::Classes, || {
        let edges = edges.filter(|_| plan.profile().colours.stop_at_lines);
        let contours = edges.map(Edges::polylines).unwrap_or_default();
        classes::sort(raster, &contours, &plan.classes(px_per_mm))
    }))
}

fn draw_textures(
    classes: Option<&Classes>,
    layout: &Layout,
    lines: &[Line],
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Vec<Texture> {
    let reason = match classes {
        None => "figure.textures is off",
        Some(classes) if classes.regions.is_empty() => "the picture is white",
        Some(classes) => {
            return run(watch, Stage::Textures, || match &layout.medium {
                Medium::Print(_) => textures::fill(classes, layout.figure, lines, &plan.textures()),
                Medium::Dots(medium) => dots::textures(classes, layout.figure, lines, medium, plan),
            });
        }
    };
    watch(Event::Skip(Stage::Textures, reason));
    Vec::new()
}

/// Puts all marks on the sheet.
fn assemble(
    figure: Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    shares: Option<[f32; 5]>,
    layout: &Layout,
    request: &Request<'_>,
) -> Result<Page, Error> {
    let params = request.plan.layout();
    let around = |place| params.frame.as_ref().map_or_else(Dots::default, |params| frame::printed(place, params));
    let overview = overview.map(|(place, lines)| Overview { place, frame: around(place), lines });
    let parts = Parts {
        title: request.title.to_owned(),
        description: page::describe(&figure, overview.as_ref(), shares),
        origin: origin(request, figure.source),
        frame: around(figure.place),
        orientation_mark: layout.mark.clone(),
        overview,
        medium: layout.medium.clone(),
        ..Parts::of(layout.sheet, figure)
    };
    finished(parts, request)
}

/// The page of these marks, as it is printed.
fn finished(mut parts: Parts, request: &Request<'_>) -> Result<Page, Error> {
    // Up to here every mark has the size that fingers meet.
    if let Medium::Print(print) = parts.medium {
        parts.narrowed(print.swell);
    }
    let page = Page::new(parts).map_err(|fault| Error::OffSheet(fault.to_string()))?;
    Ok(if request.fit.mirrored { page.mirrored() } else { page })
}

/// What the maker is told when more of the figure is black than the profile allows.
fn too_black(share: f32, print: &Print) -> Option<Note> {
    let most = print.max_black;
    let percent = |share: f32| (100.0 * share).round() as u32;
    (share > most).then(|| Note::TooBlack { percent: percent(share), most: percent(most) })
}

/// How the page was made, so that it can be made again.
fn origin(request: &Request<'_>, source: Size) -> Vec<(String, String)> {
    let profile = request.plan.profile();
    let own = |name: &str, value: String| (name.to_owned(), value);
    let mut origin = vec![
        own("program", concat!("tactograph ", env!("CARGO_PKG_VERSION")).to_owned()),
        own("picture", request.title.to_owned()),
        own("source size in pixels", source.to_string()),
        own("profile", profile.name.clone()),
    ];
    origin.extend(request.fit.origin());
    origin.extend(profile.parameters().into_iter().map(|(key, value)| (key.to_owned(), value)));
    origin
}
