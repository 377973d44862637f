//! The overview below the figure: the picture's lines once more, small enough to be felt as a whole.

use super::cut_contours::{index_of_drawn, take_out};
use super::decisions::{LinesOf, OutlinedRegions};
use super::dots;
use super::hand_lines::HandLines;
use super::joined_bars::{BarTolerances, Redraw};
use super::kept_lines;
use super::lines_of_part::LinesOfPart;
use super::lost_marks;
use super::outlines::outlines_of_overview;
use super::progress::{Event, Stage, Watch, run_stage};
use super::request::{OverviewSize, scale_of_photograph};
use super::told_bars::BarStyle;
use super::too_near::{self, Rules};
use crate::edges::Edges;
use crate::lines::{self, Line, Lost, LostMarks, PagePart};
use crate::listing::first_few;
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmRect, PageTransform};
use crate::{About, Note, Reason};

/// Shares of the figure's size for overviews of drawings that have no room in the one that the profile asks for: beyond
/// the last it is no overview any more.
const LARGER_OVERVIEWS: [f32; 3] = [0.5, 0.6, 0.7];
/// An overview that lacks this share of a drawing's lines, as its rings have no room to be drawn whole, shows another
/// thing: a hand without its outline. Its rings are drawn in part if it then lacks less. (Of 162 drawings of school
/// books on A4, 28 lacked half of their lines; looked at one by one.)
const MISLEADS: f32 = 0.3;
/// An overview may lack this share of a drawing's lines before a larger one is tried: ticks, and ends of lines.
const MAY_LACK: f32 = 0.04;
/// A drawing with so many times the contours that an overview has room for is drawn in no larger one, nor with parts of
/// rings, as that would lack most of them too, and its lines take seconds in each. (Of 90 pictures of schoolbooks and
/// worksheets none has more than 1.5 times as much; 500 rings one in the other have 11 times.)
const FAR_TOO_DENSE: f32 = 4.0;
/// An overview without this share of a drawing's lines is told of: a bar of a chart may be missing, and less are ticks.
const LACKS: f32 = 0.15;

/// The overview's lines are drawn from the contours anew for their own smaller size: the same millimetre rules leave
/// fewer. Of a drawing, each ring is drawn whole or not at all. Where that leaves out too much the overview is larger,
/// as far as the sheet has room below the figure, or rings are drawn in part ([`Rings`]). Of a photograph it is larger
/// from the first ([`OverviewSize`]).
pub(super) fn draw_overview(
    edges: &Edges,
    lines_of: LinesOf<'_>,
    size: OverviewSize,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> DrawnOverview {
    let reason = match layout.overview {
        None => "overview.on is off",
        Some(_) if edges.is_empty() && !lines_of.has_subject() => "there are no contours",
        Some(place) => {
            let figure = OverviewSource { edges, regions: lines_of.regions(), layout, plan };
            return run_stage(watch, Stage::Overview, || figure.overview(place, lines_of, size));
        }
    };
    watch(Event::Skip(Stage::Overview, reason));
    DrawnOverview::default()
}

/// The contours along which the figure has a line. Of a photograph whose maker wants few shapes, the overview is drawn
/// of them: its own choice among all contours would be another, and a finger would look for these lines in vain. (On 50
/// photographs of BSDS500, val, with four shapes 7.5 percent of its lines were not in the figure; without that limit 2
/// percent are not.)
pub(super) fn seen_in_figure(edges: &Edges, figure: &[Line], layout: &Layout, plan: &Plan) -> Edges {
    let transform = PageTransform::new(edges.size, layout.figure);
    let (near, reach) =
        (index_of_drawn(figure, edges.size, &transform), plan.lines().max_spacing() * transform.px_per_mm());
    let mut seen = edges.clone();
    take_out(&mut seen, |_, _, edgel| near.nearest(edgel.at, reach, |_| true).is_none());
    seen
}

/// What becomes of an overview.
#[derive(Default)]
pub(super) struct DrawnOverview {
    /// Its place and its lines, if it has any.
    pub(super) marks: Option<(MmRect, Vec<Line>)>,
    /// What of a drawing is not drawn.
    pub(super) lost: Lost,
    /// How rings are drawn that have no room as a whole.
    pub(super) rings: Rings,
    /// How the bars of a chart are drawn that have no room as they are.
    pub(super) instead: Option<BarStyle>,
}

impl DrawnOverview {
    /// That of a photograph within its figure, where that has lines: without the lines that are not there, as others
    /// took their room. A finger would look for them in vain. They are contours that the figure lacks, and told as
    /// these.
    pub(super) fn within(mut self, figure: &[Line], layout: &Layout, plan: &Plan) -> Self {
        if let Some((place, lines)) = self.marks.take_if(|_| !figure.is_empty()) {
            let of_figure = LinesOfPart::of(figure, layout.figure, layout, plan);
            let is_there = |line: &Line| of_figure.share_of_line(line, [place, layout.figure]) >= HALF;
            let seen: Vec<Line> = lines.into_iter().filter(is_there).collect();
            self.marks = (!seen.is_empty()).then_some((place, seen));
        }
        self
    }
}

/// A line of one part of the page is in the other if this share of it is.
const HALF: f32 = 0.5;

/// How an overview has the rings of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Rings {
    /// Each whole or not at all.
    #[default]
    Whole,
    /// In part, where there is no room for the whole.
    InParts,
}

/// An overview in one place.
struct PlacedOverview {
    place: MmRect,
    rings: Rings,
    lines: Vec<Line>,
    /// What is not drawn.
    lost: Lost,
}

/// What an overview is drawn of.
struct OverviewSource<'a> {
    edges: &'a Edges,
    regions: Option<OutlinedRegions<'a>>,
    layout: &'a Layout,
    plan: &'a Plan,
}

impl OverviewSource<'_> {
    fn overview(&self, place: MmRect, lines_of: LinesOf<'_>, size: OverviewSize) -> DrawnOverview {
        let first = self.place_of_photograph(size).unwrap_or(place);
        let mut best = self.largest_needed(first);
        // of one that is far too dense parts of rings say no more than the rings that are there
        let may_say_more = best.lines.is_empty() || !self.is_too_dense(first);
        if self.edges.of_drawing() && best.lost.share() >= MISLEADS && may_say_more {
            let in_parts = self.draw_at(first, self.plan.lines().detail, Rings::InParts);
            // parts of rings say more than nothing
            if best.lines.is_empty() || in_parts.lost.share() < best.lost.share() {
                best = in_parts;
            }
        }
        let (drawn, instead) = match lines_of {
            LinesOf::Picture(_) => self.with_whole_bars(best, place),
            LinesOf::Person => (best, None),
        };
        let PlacedOverview { place, rings, lines, lost } = drawn;
        let lost = if self.edges.of_drawing() { lost } else { Lost::default() };
        DrawnOverview { marks: (!lines.is_empty()).then_some((place, lines)), lost, rings, instead }
    }

    /// The overview of whole rings in this place, or in a larger one if it lacks less there.
    fn largest_needed(&self, place: MmRect) -> PlacedOverview {
        let detail = self.plan.lines().detail;
        let mut best = self.draw_at(place, detail, Rings::Whole);
        for place in self.larger_places() {
            if is_enough(&best.lost) {
                break;
            }
            let larger = self.draw_at(place, detail, Rings::Whole);
            if (larger.lost.rings, larger.lost.share()) < (best.lost.rings, best.lost.share()) {
                best = larger;
            }
        }
        best
    }

    /// An overview whose bars are whole, if those of a chart are torn in this one: in the same place or in a larger
    /// one.
    fn with_whole_bars(&self, drawn: PlacedOverview, place: MmRect) -> (PlacedOverview, Option<BarStyle>) {
        let &Self { edges, layout, plan, .. } = self;
        if plan.lines().most_shapes.is_some() {
            return (drawn, None);
        }
        let places: Vec<MmRect> = std::iter::once(place).chain(self.larger_places()).collect();
        let (first, rings) = (drawn.place, drawn.rings);
        let draw =
            |edges: &Edges, place: MmRect, detail: f32| OverviewSource { edges, ..*self }.draw_at(place, detail, rings);
        let (tolerances, detail) = (BarTolerances::of_overview(layout, plan), plan.lines().detail);
        let redraw = Redraw {
            edges,
            places: &places,
            tolerances,
            detail,
            draw: &draw,
            lines: &|drawn: &PlacedOverview| &drawn.lines,
        };
        redraw.whole(drawn, first)
    }

    /// The overview's lines in this place, and what is not drawn.
    fn draw_at(&self, place: MmRect, detail: f32, rings: Rings) -> PlacedOverview {
        let &Self { edges, regions, layout, plan } = self;
        let transform = PageTransform::new(edges.size, place);
        let all = lines::Params { detail, ..plan.lines() };
        let of_photograph = lines::Params { part: PagePart::Overview, ..all };
        let params = match (edges.of_drawing(), rings) {
            (false, _) => of_photograph,
            (true, Rings::Whole) => all.of_overview(),
            (true, Rings::InParts) => lines::Params { whole_rings: false, ..all.of_overview() },
        };
        // what is apart in the drawing is apart here: a gap is bridged that would be in the figure
        let gap_scale = if edges.of_drawing() { (place.width() / layout.figure.width()).min(1.0) } else { 1.0 };
        let params = lines::Params { gap_scale, ..params };
        let outlines = outlines_of_overview(edges, regions, &transform, plan);
        let draw = |params: lines::Params| {
            let drawn = lines::draw_with(edges, &outlines, &transform, place, &params);
            let mut drawn = dots::of_overview(drawn, place, layout, plan);
            let rules = Rules::of(edges, place, params.whole_rings, layout, plan);
            rules.iter().for_each(|rules| too_near::cut(&mut drawn, rules));
            drawn
        };
        let mut drawn = draw(params);
        if !drawn.marks.points.is_empty() && drawn.lost.rings > 0 {
            // what has no room as a point may have room as it is
            let plain = draw(lines::Params { takes_points: false, ..params });
            if lacks_less(&plain.lost, &drawn.lost) {
                drawn = plain;
            }
        }
        drawn.lost.marks = lost_marks::find(edges, &drawn, place, &transform, params.min_length).0;
        PlacedOverview { place, rings, lines: drawn.lines, lost: drawn.lost }
    }

    /// Where the overview of a photograph lies on printed paper, if it was laid out smaller than it may be, as below a
    /// figure of a width that was asked for.
    fn place_of_photograph(&self, size: OverviewSize) -> Option<MmRect> {
        let params = self.plan.layout();
        match (&self.layout.medium, params.overview, size) {
            (Medium::Print(_), Some(overview), OverviewSize::OfPhotograph) => {
                self.layout.largest_overview(scale_of_photograph(overview.scale), &params)
            }
            (Medium::Print(_), _, OverviewSize::OfPhotograph | OverviewSize::Own) | (Medium::Dots(_), ..) => None,
        }
    }

    /// Where a larger overview of a drawing can lie on printed paper, from the smallest on; not where it would be far
    /// too dense.
    fn larger_places(&self) -> Vec<MmRect> {
        let params = self.plan.layout();
        let own = match (&self.layout.medium, params.overview) {
            (Medium::Print(_), Some(overview)) if self.edges.of_drawing() => overview.scale,
            (Medium::Print(_), _) | (Medium::Dots(_), _) => return Vec::new(),
        };
        let scales = LARGER_OVERVIEWS.into_iter().filter(|scale| *scale > own);
        let places = scales.filter_map(|scale| self.layout.overview_at(scale, &params));
        places.filter(|place| !self.is_too_dense(*place)).collect()
    }

    /// Whether a place has room for so little of the contours that there is no use in trying to draw more of them.
    /// Faint ones, as the lines of squared paper, give way to all others, and do not count.
    fn is_too_dense(&self, place: MmRect) -> bool {
        let strong = self.edges.chains.iter().filter(|chain| !chain.kind.faint);
        let px = strong.map(|chain| self.edges.chain(chain).length()).sum::<f32>();
        let mm = px * PageTransform::new(self.edges.size, place).mm_per_px();
        mm * self.plan.lines().max_spacing() > FAR_TOO_DENSE * place.area()
    }
}

/// Whether one way to draw an overview lacks less than another: by the share of lines if they differ by as much as a
/// shape, such as a wheel, and else by rings, of which one may be the hub of a wheel.
fn lacks_less(one: &Lost, other: &Lost) -> bool {
    let less = other.share() - one.share();
    if less.abs() > A_SHAPE { less > 0.0 } else { (one.rings, one.share()) < (other.rings, other.share()) }
}

/// Share of a drawing's lines that is more than a few small rings. Chosen by us.
const A_SHAPE: f32 = 0.02;

/// Whether an overview has all that matters of a drawing.
fn is_enough(lost: &Lost) -> bool {
    lost.rings == 0 && lost.share() < MAY_LACK
}

/// What the maker is told of what an overview lacks; `of_figure` has the marks that the figure lacks.
pub(super) fn told_of_overview(overview: &DrawnOverview, of_figure: &LostMarks) -> impl Iterator<Item = Note> {
    let (lost, is_drawn) = (&overview.lost, overview.marks.is_some());
    let shapes = match overview.rings {
        Rings::Whole => (lost.rings > 0).then_some(Note::ShapesNotInOverview(lost.rings)),
        Rings::InParts => told_open(lost.rings, "there is no room in it to draw them whole"),
    };
    let percent = (100.0 * lost.share()).round() as u32;
    let lines = (lost.share() >= LACKS).then(|| match is_drawn {
        true => Note::LinesNotInOverview { percent, place: lost.place_name() },
        false => Note::NoRoomForOverview,
    });
    let marks = if is_drawn { lost_marks::told_not_in_overview(&lost.marks, of_figure) } else { None };
    let grid = if is_drawn { told_gridlines(lost.gridlines) } else { None };
    // those that become dots with a gap, or hardly any
    let why = "there is no room for dots beside other lines";
    let open = if overview.rings == Rings::Whole { told_open(lost.gaps.len(), why) } else { None };
    shapes.into_iter().chain(open).chain(marks).chain(grid).chain(lines)
}

/// What the maker is told of closed shapes of an overview that are open or missing, and why.
fn told_open(count: usize, why: &str) -> Option<Note> {
    let shapes = if count == 1 { "1 closed shape is" } else { &format!("{count} closed shapes are") };
    let told = format!("{shapes} open or missing in the overview, as {why}");
    (count > 0).then_some(Note::TakenAs(About::Overview, Reason::NoRoomInOverview, told.into()))
}

/// What the maker is told of a photograph's figure that has lines and no overview: of those of a drawing is told what
/// is lost. Contours that are not as long as a line across the figure are few: it is for want of them that nothing is
/// in the overview.
pub(super) fn told_without_overview(
    overview: &DrawnOverview,
    edges: &Edges,
    figure: &[Line],
    layout: &Layout,
) -> Option<Note> {
    let is_missing = layout.overview.is_some() && overview.marks.is_none() && !figure.is_empty();
    let contours = edges.chains().map(|chain| chain.length()).sum::<f32>();
    let mm = contours * PageTransform::new(edges.size, layout.figure).mm_per_px();
    let are_few = !edges.of_drawing() && mm < layout.figure.width().max(layout.figure.height());
    (is_missing && overview.lost.share() < LACKS).then(|| match are_few {
        true => Note::FewContours(mm.round() as u32),
        false => Note::NoRoomForOverview,
    })
}

/// What the maker is told of gridlines that an overview has not.
fn told_gridlines(lines: usize) -> Option<Note> {
    // how many says little: bars part them
    let told = "thin, pale lines, such as gridlines, are not in the overview, as they would hide its shapes";
    (lines > 0).then(|| Note::TakenAs(About::Overview, Reason::GridNotInOverview, told.to_owned().into()))
}

/// What the maker of a photograph's page of few shapes is told of lines of the figure that the overview lacks: there it
/// should have all of them.
pub(super) fn told_of_few(figure: &[Line], overview: &DrawnOverview, layout: &Layout, plan: &Plan) -> Option<Note> {
    plan.lines().most_shapes?;
    let (place, lines) = overview.marks.as_ref()?;
    let drawn = LinesOfPart::of(lines, *place, layout, plan);
    let is_lacking = |line: &&Line| drawn.share_of_line(line, [layout.figure, *place]) < HALF;
    let count = figure.iter().filter(is_lacking).count();
    let (noun, it_has) = if count == 1 { ("line", "it has") } else { ("lines", "they have") };
    let fewer = if plan.lines().most_shapes == Some(1) { "" } else { "ask for fewer shapes, or " };
    let why = format!("{it_has} no room there, or would be too short; {fewer}do without the overview");
    (count > 0).then(|| {
        Note::NotOnPage(
            About::Overview,
            Reason::NoRoomInOverview,
            format!("{count} {noun} of the figure in the overview: {why}").into(),
        )
    })
}

/// What the maker is told of closed lines that a person drew and that are not in the overview, the largest first:
/// where each is in the figure, by its name. What the figure lacks itself is told there.
pub(super) fn told_by_hand<'l>(
    given: impl Iterator<Item = &'l HandLines>,
    figure: &[Line],
    overview: &DrawnOverview,
    layout: &Layout,
) -> Option<Note> {
    let (place, lines) = overview.marks.as_ref()?;
    let mut missing: Vec<(&str, MmRect)> = Vec::new();
    for given in given {
        let (own, numbers): (Vec<Line>, Vec<usize>) = given.in_place(layout.figure).into_iter().unzip();
        let shares = |lines: &[Line], place: MmRect| kept_lines::matched(&own, layout.figure, lines, place).1;
        let shares = shares(figure, layout.figure).into_iter().zip(shares(lines, *place));
        for ((line, number), (of_figure, of_overview)) in own.iter().zip(numbers).zip(shares) {
            let run = line.runs.first().filter(|run| run.closed && of_figure >= HALF && of_overview < HALF);
            let extent = run.map(|run| MmRect::from_points(&run.points));
            missing.extend(given.name_by_hand(number).zip(extent));
        }
    }
    missing.sort_by(|a, b| b.1.area().total_cmp(&a.1.area()));
    let said = |(name, extent): &(&str, MmRect)| {
        let (middle, size) = (extent.center(), extent.size());
        let [width, height, x, y] = [size.width, size.height, middle.x, middle.y].map(f32::round);
        format!("{name} ({width} x {height} mm, around {x}, {y} mm)")
    };
    let (shapes, them) = match missing.len() {
        0 => return None,
        1 => ("the closed line that you drew", "it"),
        _ => ("closed lines that you drew", "them"),
    };
    let named = first_few(&missing, MOST_NAMED, said);
    let why = format!("there is no room for {them} there; draw {them} simpler, or do without the overview");
    Some(Note::NotOnPage(
        About::Overview,
        Reason::ByHandNotInOverview,
        format!("{shapes}, in the overview: {named}: {why}").into(),
    ))
}

/// Most closed lines that are named.
const MOST_NAMED: usize = 5;

#[cfg(test)]
mod tests;
