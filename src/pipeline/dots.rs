//! Pages of dots: what is done otherwise than for a printed page.

use super::{Request, finished, origin};
use crate::Error;
use crate::classes::Classes;
use crate::devices::Room;
use crate::dots;
use crate::geom::polyline;
use crate::lines::{Drawn, Line, Run};
use crate::page::layout::Layout;
use crate::page::{self, Dots, Figure, Page, Parts, Press, Texture, dot_layout, frame_dots};
use crate::profile::Plan;
use crate::units::MmRect;

/// Lines in `area` as the device presses them; on a printed page they stay.
pub(super) fn pressed(drawn: Drawn, area: MmRect, layout: &Layout, plan: &Plan) -> Drawn {
    let (Some(room), Some(params)) = (&layout.room, plan.dots()) else { return drawn };
    // What the grid has no room for counts as crowded out too, by length.
    let length = |lines: &[Line]| lines.iter().map(|line| line.runs.first().map_or(0.0, run_length)).sum::<f32>();
    let whole: f32 = drawn.lines.iter().map(Line::length).sum();
    let lines = dots::lines(&drawn.lines, area, room, &params);
    let kept = if whole > 0.0 { (length(&lines) / whole).min(1.0) } else { 1.0 };
    Drawn { lines, crowded_out: 1.0 - (1.0 - drawn.crowded_out) * kept }
}

fn run_length(run: &Run) -> f32 {
    polyline::length(&run.points)
}

/// The lines of the overview: all of one width and, where there are heights, high.
pub(super) fn of_overview(lines: Vec<Line>, area: MmRect, layout: &Layout, plan: &Plan) -> Vec<Line> {
    let (Some(room), Some(params)) = (&layout.room, plan.dots()) else { return lines };
    let heavy_from = if params.has_heights { 0.0 } else { f32::INFINITY };
    dots::lines(&lines, area, room, &dots::Params { heavy_from, ..params })
}

/// What the overview of a page is called, which has a sheet to itself.
pub fn title_of_overview(title: &str) -> String {
    format!("{title}, overview")
}

/// Textures of dots.
pub(super) fn textures(classes: &Classes, area: MmRect, lines: &[Line], room: &Room, plan: &Plan) -> Vec<Texture> {
    plan.dot_textures().map_or_else(Vec::new, |params| dots::textures::fill(classes, area, lines, room, &params))
}

/// The page of a figure, and that of its overview, which has a sheet to itself: one of dots has no room for both.
pub(super) fn assemble(
    figure: Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    shares: Option<[f32; 5]>,
    layout: &Layout,
    room: &Room,
    request: &Request<'_>,
) -> Result<(Page, Option<Page>), Error> {
    let source = figure.source;
    let overview = overview
        .map(|(place, lines)| {
            let own = Figure { place, source, textures: Vec::new(), lines };
            let description = format!("Overview, lines only. {}", page::describe(&own, None, None));
            let title = title_of_overview(request.title);
            finished(parts(title, description, own, layout, room, request), request)
        })
        .transpose()?;
    let mut description = page::describe(&figure, None, shares);
    if overview.is_some() {
        description += " An overview of lines only follows on the next sheet.";
    }
    let page = finished(parts(request.title.to_owned(), description, figure, layout, room, request), request)?;
    Ok((page, overview))
}

fn parts(
    title: String,
    description: String,
    figure: Figure,
    layout: &Layout,
    room: &Room,
    request: &Request<'_>,
) -> Parts {
    let plan = request.plan;
    let params = plan.dots();
    let mark = |run: &Run| params.map(|params| dots::mark(&run.points, room, &params));
    Parts {
        title,
        description,
        origin: origin(request, figure.source),
        frame: frame(figure.place, room, plan),
        orientation_mark: layout.mark.as_ref().and_then(mark),
        press: params.map(|params| Press {
            room: room.clone(),
            pitch: params.pitch,
            diameter: params.diameter,
            has_heights: params.has_heights,
        }),
        ..Parts::of(layout.sheet, figure)
    }
}

fn frame(place: MmRect, room: &Room, plan: &Plan) -> Dots {
    let layout = plan.layout();
    let (Some(frame), Some(press)) = (layout.frame, layout.press) else { return Dots::default() };
    match room {
        Room::Grid(grid) => dot_layout::ring(place, grid, frame, &press),
        Room::Free(_) => frame_dots::around(place, &dot_layout::row(frame, &press)),
    }
}
