//! One picture, one setting: the stages as `src/pipeline.rs` calls them, each with its time.

use tactograph::Error;
use tactograph::internals::classes::{self, Classes};
use tactograph::internals::edges;
use tactograph::internals::lines::{self, Line};
use tactograph::internals::output::svg;
use tactograph::internals::page::layout::{self, Layout};
use tactograph::internals::page::{Figure, Overview, Page, Parts};
use tactograph::internals::profile::Plan;
use tactograph::internals::raster::Raster;
use tactograph::internals::raster::decode::{self, DecodeOptions, Header};
use tactograph::internals::raster::shrink::shrink;
use tactograph::internals::textures;
use tactograph::internals::units::{MmRect, PageTransform, Size};

use crate::clock::Clock;
use crate::pictures::Picture;

/// The stages in their order; the last is the page and its SVG.
pub(crate) const STAGES: [&str; 7] = ["decode", "edges", "lines", "overview", "classes", "textures", "page"];

/// What came of it.
pub(crate) struct Outcome {
    /// Of the picture, px.
    pub(crate) source: Size,
    pub(crate) working: Size,
    pub(crate) place: MmRect,
    pub(crate) lines: Vec<Line>,
    pub(crate) classes: Classes,
    pub(crate) svg: String,
    /// Milliseconds of each stage.
    pub(crate) times: [f64; STAGES.len()],
}

/// Makes the page of a picture. A JPEG is decoded at `eighths` of its size, or as the program does.
///
/// # Errors
/// The picture cannot be decoded.
pub(crate) fn run(picture: &Picture, plan: &Plan, eighths: Option<u32>) -> Result<Outcome, Error> {
    let mut clock = Clock::start();
    let mut times = [0.0; STAGES.len()];
    let working_size = |source: Header| {
        Ok(match eighths {
            Some(eighths) => {
                Size::new((source.size.width * eighths).div_ceil(8), (source.size.height * eighths).div_ceil(8))
            }
            None => working_size(source, plan),
        })
    };
    let decoded = decode::decode(&picture.bytes, &DecodeOptions::whole(&working_size))?;
    let source = decoded.source.size;
    let working = self::working_size(decoded.source, plan);
    let raster = smaller(decoded.raster, working);
    times[0] = clock.lap();

    let layout = layout_of(source, plan);
    let frame = PageTransform::new(raster.size(), layout.figure);
    let px_per_mm = 1.0 / frame.mm_per_px();
    let found = edges::find(&raster, &plan.edges(px_per_mm));
    times[1] = clock.lap();
    let lines = lines::draw(&found, &frame, layout.figure, &plan.lines()).lines;
    times[2] = clock.lap();
    let overview = layout.overview.map(|place| {
        let lines = lines::draw(&found, &PageTransform::new(raster.size(), place), place, &plan.lines()).lines;
        Overview { place, frame: Default::default(), lines }
    });
    times[3] = clock.lap();
    let classes = classes::sort(&raster, &found.borders(), &plan.classes(px_per_mm));
    times[4] = clock.lap();
    let textures = textures::fill(&classes, layout.figure, &lines, &plan.textures());
    times[5] = clock.lap();
    let figure = Figure { place: layout.figure, source, textures, lines };
    let page = Page::new(Parts { overview, ..Parts::of(layout.sheet, figure) })?;
    let svg = svg::write(&page);
    times[6] = clock.lap();
    Ok(Outcome { source, working, place: layout.figure, lines: page.figure.lines.clone(), classes, svg, times })
}

/// As `src/pipeline.rs` has it.
fn working_size(source: Header, plan: &Plan) -> Size {
    let Header { size, is_drawing } = source;
    let place = layout_of(size, plan).figure;
    let pixels = |mm: f32, own: u32| {
        let wanted = ((mm * plan.profile().figure.resolution).round() as u32).max(1);
        if is_drawing { wanted } else { wanted.min(own) }
    };
    Size::new(pixels(place.width(), size.width), pixels(place.height(), size.height))
}

fn layout_of(size: Size, plan: &Plan) -> Layout {
    layout::fit(size.width as f32 / size.height as f32, f32::MAX, &plan.layout())
}

fn smaller(raster: Raster, size: Size) -> Raster {
    if raster.size() == size {
        return raster;
    }
    let smaller = |plane: &Vec<f32>| shrink(plane, raster.size(), size).values;
    Raster::new(size, raster.planes().as_ref().map(smaller))
}
