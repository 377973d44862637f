//! The overview below the figure: the picture's lines once more, small enough to be felt as a whole.

use super::dots;
use super::joined_bars::{BarTolerances, Instead, Redraw};
use super::outlines::outlines_of;
use super::progress::{Event, Stage, Watch, run};
use crate::Note;
use crate::edges::Edges;
use crate::lines::{self, Line, Lost};
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmRect, PageTransform};

/// Shares of the figure's size for overviews of drawings that have no room in the one that the profile asks for: beyond
/// the last it is no overview any more.
const LARGER_OVERVIEWS: [f32; 3] = [0.5, 0.6, 0.7];
/// An overview that lacks this share, as one of squared paper, is too small by far.
const TOO_SMALL: f32 = 0.5;
/// An overview may lack this share of a drawing's lines before a larger one is tried: ticks, and ends of lines.
const MAY_LACK: f32 = 0.04;
/// An overview without this share of a drawing's lines is told of: a bar of a chart may be missing, and less are ticks.
const LACKS: f32 = 0.15;

/// The overview's lines are drawn from the contours anew for their own smaller size: the same millimetre rules leave
/// fewer. Of a drawing, each ring is drawn whole or not at all, and where that leaves out too much the overview is
/// larger, as far as the sheet has room below the figure.
pub(super) fn draw_overview(
    edges: Option<&Edges>,
    may_join: bool,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> DrawnOverview {
    let reason = match (layout.overview, edges) {
        (None, _) => "overview.on is off",
        (Some(place), Some(edges)) if !edges.is_empty() => {
            let (Overview { place, lines, lost }, instead) = run(watch, Stage::Overview, || {
                let detail = plan.lines().detail;
                let mut best = draw_overview_at(place, edges, layout, plan, detail);
                for place in larger_overviews(edges, layout, plan) {
                    if is_enough(&best.lost) || best.lost.share() > TOO_SMALL {
                        break;
                    }
                    let larger = draw_overview_at(place, edges, layout, plan, detail);
                    if (larger.lost.rings, larger.lost.share()) < (best.lost.rings, best.lost.share()) {
                        best = larger;
                    }
                }
                match may_join {
                    true => with_whole_bars(best, place, edges, layout, plan),
                    false => (best, None),
                }
            });
            let lost = if edges.of_drawing() { lost } else { Lost::default() };
            return DrawnOverview { marks: (!lines.is_empty()).then_some((place, lines)), lost, instead };
        }
        _ => "there are no contours",
    };
    watch(Event::Skip(Stage::Overview, reason));
    DrawnOverview::default()
}

/// What becomes of an overview.
#[derive(Default)]
pub(super) struct DrawnOverview {
    /// Its place and its lines, if it has any.
    pub(super) marks: Option<(MmRect, Vec<Line>)>,
    /// What of a drawing is not drawn.
    pub(super) lost: Lost,
    /// How the bars of a chart are drawn that have no room as they are.
    pub(super) instead: Option<Instead>,
}

/// An overview in one place.
struct Overview {
    place: MmRect,
    lines: Vec<Line>,
    /// What is not drawn.
    lost: Lost,
}

/// An overview whose bars are whole, if those of a chart are torn in this one: in the same place or in a larger one.
fn with_whole_bars(
    drawn: Overview,
    place: MmRect,
    edges: &Edges,
    layout: &Layout,
    plan: &Plan,
) -> (Overview, Option<Instead>) {
    if plan.lines().most_shapes.is_some() {
        return (drawn, None);
    }
    let places: Vec<MmRect> = std::iter::once(place).chain(larger_overviews(edges, layout, plan)).collect();
    let transform = |place: &MmRect| PageTransform::new(edges.size, *place);
    let transforms: Vec<PageTransform> = places.iter().map(transform).collect();
    let draw = |edges: &Edges, at: &PageTransform, detail: f32| {
        let place = transforms.iter().zip(&places).find(|(transform, _)| *transform == at).map_or(place, |(_, of)| *of);
        draw_overview_at(place, edges, layout, plan, detail)
    };
    let first = transform(&drawn.place);
    let (tolerances, detail) = (BarTolerances::of(layout, plan), plan.lines().detail);
    let redraw = Redraw {
        edges,
        transforms: &transforms,
        tolerances,
        detail,
        draw: &draw,
        lines: &|drawn: &Overview| &drawn.lines,
    };
    redraw.whole(drawn, &first)
}

/// The overview's lines in this place, and what is not drawn.
fn draw_overview_at(place: MmRect, edges: &Edges, layout: &Layout, plan: &Plan, detail: f32) -> Overview {
    let transform = PageTransform::new(edges.size, place);
    let all = lines::Params { detail, ..plan.lines() };
    let params = if edges.of_drawing() { all.of_overview() } else { all };
    let (outlines, _) = outlines_of(edges, &transform, layout, plan, true);
    let draw = |params: lines::Params| {
        let mut drawn = lines::draw_with(edges, &outlines, &transform, place, &params);
        if drawn.lines.is_empty() {
            // parts of rings say more than nothing
            let params = lines::Params { whole_rings: false, ..params };
            drawn = lines::draw_with(edges, &outlines, &transform, place, &params);
        }
        dots::of_overview(drawn, place, layout, plan)
    };
    let mut drawn = draw(params);
    if !drawn.marks.points.is_empty() && drawn.lost.rings > 0 {
        // what has no room as a point may have room as it is
        let plain = draw(lines::Params { takes_points: false, ..params });
        if plain.lost.rings < drawn.lost.rings {
            drawn = plain;
        }
    }
    Overview { place, lines: drawn.lines, lost: drawn.lost }
}

/// Where a larger overview of a drawing can lie on printed paper, from the smallest on.
fn larger_overviews(edges: &Edges, layout: &Layout, plan: &Plan) -> Vec<MmRect> {
    let params = plan.layout();
    let own = match (&layout.medium, params.overview) {
        (Medium::Print(_), Some(overview)) if edges.of_drawing() => overview.scale,
        _ => return Vec::new(),
    };
    let scales = LARGER_OVERVIEWS.into_iter().filter(|scale| *scale > own);
    scales.filter_map(|scale| layout.overview_at(scale, &params)).collect()
}

/// Whether an overview has all that matters of a drawing.
fn is_enough(lost: &Lost) -> bool {
    lost.rings == 0 && lost.share() < MAY_LACK
}

/// What the maker is told of what the overview of a drawing lacks.
pub(super) fn told_of_overview(lost: &Lost, is_drawn: bool) -> impl Iterator<Item = Note> {
    let shapes = (lost.rings > 0).then_some(Note::ShapesNotInOverview(lost.rings));
    let percent = (100.0 * lost.share()).round() as u32;
    let lines = (lost.share() >= LACKS).then(|| match is_drawn {
        true => Note::LinesNotInOverview { percent, place: lost.place_name() },
        false => Note::NoRoomForOverview,
    });
    shapes.into_iter().chain(lines)
}
