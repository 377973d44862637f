//! Bars that have no room side by side: as transcribers do, gridlines are left out, or bars are drawn touching one
//! another, and where a line between every two has no room either, as one common outline.

use super::bar_rows::{BarRow, RowEnd};
use super::bars::{Bar, Chart, SAME, WantedPath, missing};
use super::told_bars::{BarStyle, Bars, LeftOut};
use crate::edges::{ChainKind, ChainRange, Edgel, Edges};
use crate::geom::polyline::Polyline;
use crate::lines::Line;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmRect, PageTransform, PxPoint, PxVector};

/// A contour that is interrupted over less than this, px, crosses a bar and is none of its sides.
const CROSSES: f32 = 4.0 * SAME;
/// What runs along a side or a top differs from its direction by at most 25 degrees (the cosine).
const ALONG: f32 = 0.9;

/// A variant of drawing a chart.
#[derive(Debug, Clone, Copy)]
struct Variant {
    bars: Bars,
    /// Whether its gridlines are drawn.
    has_gridlines: bool,
    /// Penalty of the variant itself, as a share of the length of the chart's lines.
    lacks: f32,
}

const fn variant(bars: Bars, has_gridlines: bool, lacks: f32) -> Variant {
    Variant { bars, has_gridlines, lacks }
}

/// What else is tried, in this order: what says most comes first. Where none has all bars whole, what lacks least is
/// taken. The penalties are chosen by us, in the order of what a reader loses: width least, then gridlines, the blank
/// between bars, then the sides by which bars are counted.
const VARIANTS: [Variant; 7] = [
    variant(Bars::Apart, true, 0.0),
    NARROWER,
    variant(Bars::Apart, false, 0.02),
    variant(Bars::Touching, true, 0.03),
    variant(Bars::Touching, false, 0.05),
    variant(Bars::Outline, true, 0.15),
    variant(Bars::Outline, false, 0.17),
];

/// Stacked bars that are narrower and moved aside.
const NARROWER: Variant = variant(Bars::Narrower, true, 0.01);

/// The contours of a chart that rows of bars do not replace.
struct Kept {
    edges: Edges,
    /// Kind and mean strength of the contours that are replaced; none if none is.
    replaced: Option<(ChainKind, f32)>,
    /// Stretches of the base that stay, from and to along it, px.
    ground: Vec<(f32, f32)>,
}

/// How near lines may be, and how far they may lie from what they stand for, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct BarTolerances {
    /// A gap between bars narrower than this is no gap for fingers.
    gap: f32,
    /// A bar lower than this has no room for its outline beside its base.
    low: f32,
    /// A line stands for contours within this distance.
    reach: f32,
    /// A bar of which as much is missing is torn; less is missing where lines meet.
    torn: f32,
    /// Stacked bars may be narrower by so much on each side, and moved aside by as much, mm.
    moved: f32,
}

impl BarTolerances {
    /// Of a page. On a grid of dots lines are drawn on the rows of it beside them.
    pub(super) fn of(layout: &Layout, plan: &Plan) -> Self {
        let pitch = layout.medium.pitch();
        let lines = plan.lines();
        let reach = lines.farthest_moved().max(1.5 * pitch);
        let (gap, low) = (lines.max_spacing() + pitch, lines.max_spacing());
        Self { gap, low, reach, torn: TORN.max(3.0 * pitch), moved: 0.0 }
    }

    /// The same in an overview, where no labels stand at bars.
    pub(super) fn of_overview(layout: &Layout, plan: &Plan) -> Self {
        let of_figure = Self::of(layout, plan);
        Self { moved: 0.5 * of_figure.reach, ..of_figure }
    }
}

/// Narrower bars are farther apart by so much more, mm, than a gap for fingers is wide.
const MORE: f32 = 0.05;
/// A bar of which a contour of this length, mm, is not drawn is torn, on paper.
const TORN: f32 = 3.0;
/// The middle of a top, and how near a line lies to it, as a share of the bar's width: nearer than its sides.
const MIDDLE: [f32; 2] = [0.4, 0.6];
const NEAR_TOP: f32 = 0.38;
/// The same of a low bar and its base.
const NEAR_LOW: f32 = 0.4;
/// Bars that touch are as wide as the distance from one to the next, of which this share is nearer to one line than to
/// the next.
const NEARER_OF_TOUCHING: f32 = 0.45;
/// A side that is not drawn is seen by what is nearer to it than to the next line, as a share of their distance.
const NEARER: f32 = 0.6;

/// The sides of two bars nearer than this, px, are one contour.
const ONE_SIDE: f32 = 1.0;

/// Width of a line that stands for the outlines of bars, mm on the page: more than that of any line.
const BROAD: f32 = 8.0;

/// All lines that have room (`lines.detail`).
const ALL: f32 = 1.0;

/// How the lines of a drawing are made, for a chart in which bars are torn.
pub(super) struct Redraw<'a, T> {
    /// The contours of the drawing.
    pub(super) edges: &'a Edges,
    /// Where it may be drawn.
    pub(super) places: &'a [MmRect],
    pub(super) tolerances: BarTolerances,
    /// Of its lines (`lines.detail`).
    pub(super) detail: f32,
    /// Draws contours in a place with such a detail.
    pub(super) draw: &'a dyn Fn(&Edges, MmRect, f32) -> T,
    /// The lines of what it drew.
    pub(super) lines: &'a dyn Fn(&T) -> &[Line],
}

impl<T> Redraw<'_, T> {
    /// Draws a drawing whose bars are torn as `first`, drawn in this `place`, in other variants, until they are whole:
    /// each variant in each place. Gives what lacks least of them, and how it was drawn if it is not the first or is
    /// torn.
    pub(super) fn whole(&self, first: T, place: MmRect) -> (T, Option<BarStyle>) {
        let Self { edges, tolerances, detail, draw, .. } = *self;
        let Some(chart) = Chart::of(edges) else { return (first, None) };
        // judged by all lines whatever the detail, so that less of it is a part of more
        let all_lines = (detail < ALL).then(|| draw(edges, place, ALL));
        let at = &PageTransform::new(edges.size, place);
        let mut least = self.lacking(&chart.wanted(tolerances, at), all_lines.as_ref().unwrap_or(&first), at);
        if least <= 0.0
            && let Some((drawn, instead)) = self.narrowed(&chart, place)
        {
            return (drawn, Some(instead));
        }
        let mut best = None;
        let mut torn = percent(least);
        'variants: for variant in VARIANTS {
            for &place in self.places.iter().filter(|_| variant.has_gridlines || chart.has_more_than_bars()) {
                if least <= 0.0 {
                    break 'variants;
                }
                let transform = PageTransform::new(edges.size, place);
                let Some(Redrawn { edges, wanted, instead }) = chart.drawn(edges, variant, tolerances, &transform)
                else {
                    continue;
                };
                let drawn = draw(&edges, place, ALL);
                let lacking = self.lacking(&wanted, &drawn, &transform);
                let share = if lacking > 0.0 { variant.lacks + lacking } else { 0.0 };
                if share < least {
                    torn = percent(lacking);
                    (least, best) = (share, Some((drawn, edges, place, BarStyle { torn, ..instead })));
                }
            }
        }
        match best {
            None => (first, (torn > 0).then_some(BarStyle { torn, ..BarStyle::AS_IT_IS })),
            Some((drawn, .., instead)) if detail >= ALL => (drawn, Some(instead)),
            Some((_, edges, place, instead)) => (draw(&edges, place, detail), Some(instead)),
        }
    }

    /// The chart in this place with narrower bars, if these have no room as they are and are whole then: stacked bars
    /// cannot move apart by themselves, as what divides them ends on their sides. Where they are torn, what is left of
    /// each may be near enough to stand for all of it.
    fn narrowed(&self, chart: &Chart, place: MmRect) -> Option<(T, BarStyle)> {
        let transform = PageTransform::new(self.edges.size, place);
        let Redrawn { edges, wanted, instead } = chart.drawn(self.edges, NARROWER, self.tolerances, &transform)?;
        let drawn = (self.draw)(&edges, place, ALL);
        if self.lacking(&wanted, &drawn, &transform) > 0.0 {
            return None;
        }
        let drawn = if self.detail < ALL { (self.draw)(&edges, place, self.detail) } else { drawn };
        Some((drawn, instead))
    }

    /// Which share of the paths that are wanted is not drawn.
    fn lacking(&self, wanted: &[WantedPath], drawn: &T, at: &PageTransform) -> f32 {
        let (lost, all) = missing(wanted, (self.lines)(drawn), at, self.tolerances.torn);
        lost / all.max(f32::MIN_POSITIVE)
    }
}

fn percent(share: f32) -> u32 {
    (100.0 * share).ceil() as u32
}

/// Contours in which bars are drawn otherwise.
struct Redrawn {
    edges: Edges,
    /// The paths along which there should be lines then.
    wanted: Vec<WantedPath>,
    instead: BarStyle,
}

impl Chart {
    /// The paths along which there should be lines if all bars are drawn as they are.
    fn wanted(&self, tolerances: BarTolerances, transform: &PageTransform) -> Vec<WantedPath> {
        let gap_px = tolerances.gap / transform.mm_per_px();
        let mut wanted = Vec::new();
        for (number, bar) in self.bars.iter().enumerate() {
            let height = (bar.top - self.base) * transform.mm_per_px();
            let is_low = height < tolerances.low;
            // nearer to it than the other side of the bar, or the line in the middle of a narrow one
            let width = (bar.to - bar.from) * transform.mm_per_px();
            let reach = if is_low { NEAR_LOW * height } else { tolerances.reach.min((NEARER * width).max(1.0)) };
            wanted.push(WantedPath { path: self.outline(bar), reach, or_none: is_low, weight: 1.0 });
            wanted.extend((!is_low).then(|| self.middle_of_top(bar, tolerances, transform)));
            // a side is not the axis beside it or the side of the next bar, and may have moved away from that
            let beside = [self.bars[..number].last().map(|bar| bar.to), self.bars.get(number + 1).map(|bar| bar.from)];
            for (is_last, own) in [(false, bar.from), (true, bar.to)] {
                let RowEnd { at, is_axis } = self.end(bar, gap_px, is_last);
                let is_other = |at: &f32| (ONE_SIDE..=gap_px).contains(&(own - at).abs());
                let other = beside[usize::from(is_last)].filter(is_other);
                if let Some(at) = is_axis.then_some(at).or(other.filter(|_| !is_low)) {
                    let inwards = 0.5 * tolerances.reach / transform.mm_per_px();
                    let across = own + if is_last { -inwards } else { inwards };
                    let path = [self.base, bar.top].map(|along| self.direction.point((across, along))).to_vec();
                    let reach = 0.5 * tolerances.reach + NEARER * (at - own).abs() * transform.mm_per_px();
                    wanted.push(WantedPath { path, reach, or_none: false, weight: 1.0 });
                }
            }
        }
        wanted
    }

    /// The middle of a bar's top, which is as near to its sides as they are to one another: a line nearer to it than
    /// these is the top. Towards the frame above it, a line nearer to that is none.
    fn middle_of_top(&self, bar: &Bar, tolerances: BarTolerances, transform: &PageTransform) -> WantedPath {
        let (width, mm_per_px) = (bar.to - bar.from, transform.mm_per_px());
        let down = tolerances.reach.min(NEAR_TOP * width * mm_per_px);
        let up = self.frame.map_or(down, |frame| down.min(NEARER * (frame - bar.top) * mm_per_px));
        let along = bar.top - 0.5 * (down - up) / mm_per_px;
        let path = MIDDLE.map(|share| self.direction.point((bar.from + share * width, along))).to_vec();
        WantedPath { path, reach: 0.5 * (down + up), or_none: false, weight: 1.0 / (MIDDLE[1] - MIDDLE[0]) }
    }

    /// The contours of the chart in this variant; none if the variant changes nothing.
    fn drawn(
        &self,
        edges: &Edges,
        Variant { bars, has_gridlines, .. }: Variant,
        tolerances: BarTolerances,
        transform: &PageTransform,
    ) -> Option<Redrawn> {
        let gap_px = tolerances.gap / transform.mm_per_px();
        let (low, high): (Vec<Bar>, Vec<Bar>) =
            self.bars.iter().partition(|bar| (bar.top - self.base) * transform.mm_per_px() < tolerances.low);
        if bars == Bars::Narrower {
            return if low.is_empty() { self.narrower(edges, tolerances, transform) } else { None };
        }
        let joins = bars != Bars::Apart;
        let row = |bars: &[Bar]| {
            let ends = [self.end(&bars[0], gap_px, false), self.end(&bars[bars.len() - 1], gap_px, true)];
            BarRow { bars: bars.to_vec(), ends }
        };
        let mut rows: Vec<BarRow> = high.chunk_by(|a, b| joins && b.from - a.to <= gap_px).map(row).collect();
        let is_at_axis = |row: &BarRow| row.ends.iter().any(|end| end.is_axis);
        let apart: Vec<BarRow> = rows.extract_if(.., |row| !joins && !is_at_axis(row)).collect();
        if rows.is_empty() && low.is_empty() && has_gridlines {
            return None;
        }
        let Kept { edges: mut kept, replaced, ground } =
            self.kept(edges, has_gridlines, &rows, &low, tolerances.moved > 0.0);
        let paths = self.paths(&rows, bars == Bars::Touching);
        if let Some((kind, strength)) = replaced {
            // like the middle of a broad stroke, which has no other side
            let kind = ChainKind { stroke: kind.stroke.or(Some(BROAD / transform.mm_per_px())), ..kind };
            for path in paths.iter().chain(&self.gaps_of_base(&rows, ground)) {
                let edgel = |at: PxPoint| Edgel { at, strength, contrast: [0.0; 3] };
                let mut path = Polyline::open(path.clone());
                path.vertices.dedup();
                path.subdivide(1.0);
                kept.push_as(kind, path.vertices.into_iter().map(edgel), false);
            }
        }
        // those that are far enough apart are drawn anew each by itself
        let bars = if rows.iter().any(|row| row.bars.len() > 1) { bars } else { Bars::Apart };
        let is_at_axis = rows.iter().any(is_at_axis);
        let left_out = LeftOut::of(has_gridlines, !self.gridlines.is_empty());
        let instead = BarStyle { bars, left_out, low: low.len(), is_at_axis, torn: 0 };
        let unchanged = Self { bars: apart.into_iter().flat_map(|row| row.bars).collect(), ..self.clone() };
        let narrowest = high.windows(2).map(|pair| pair[1].from - pair[0].from).fold(f32::INFINITY, f32::min);
        let reach = tolerances.reach.min(NEARER_OF_TOUCHING * narrowest * transform.mm_per_px());
        let paths = paths.into_iter().map(|path| WantedPath { path, reach, or_none: false, weight: 1.0 });
        let in_rows = rows.iter().flat_map(|row| &row.bars);
        let tops = in_rows.map(|bar| self.middle_of_top(bar, tolerances, transform));
        let wanted = paths.chain(tops).chain(unchanged.wanted(tolerances, transform)).collect();
        Some(Redrawn { edges: kept, wanted, instead })
    }

    /// The contours of a chart of stacked bars that are narrower, and moved aside from an axis.
    fn narrower(&self, edges: &Edges, tolerances: BarTolerances, transform: &PageTransform) -> Option<Redrawn> {
        let to_px = |mm: f32| mm / transform.mm_per_px();
        let gap = to_px(tolerances.gap + MORE);
        let [first, .., last] = &self.bars[..] else { return None };
        let before = [(first, false), (last, true)].map(|(bar, is_last)| {
            let RowEnd { at, is_axis } = self.end(bar, gap, is_last);
            let own = if is_last { bar.to } else { bar.from };
            if is_axis { (at - own).abs() } else { f32::INFINITY }
        });
        let (edges, chart) = self.with_room(edges, before, gap, to_px(tolerances.moved))?;
        let instead = BarStyle { bars: Bars::Narrower, ..BarStyle::AS_IT_IS };
        Some(Redrawn { edges, wanted: chart.wanted(tolerances, transform), instead })
    }

    /// The contours without those that rows of bars and low bars replace, and without gridlines where there is to be
    /// no grid.
    fn kept(&self, edges: &Edges, has_gridlines: bool, rows: &[BarRow], low: &[Bar], only_axes: bool) -> Kept {
        let mut others = Edges { dashed: edges.dashed, ..Edges::none(edges.size) };
        let (mut sum, mut count, mut kind, mut ground) = (0.0, 0, None, Vec::new());
        for chain in &edges.chains {
            let is_grid = !has_gridlines && self.is_gridline(edges, chain);
            let view = edges.chain(chain);
            // a bar may end on a gridline
            let is_out = |i: usize| {
                let at = view.vertices[i].at;
                is_grid && !self.is_top(at) || self.is_replaced(at, view.tangent(i), rows, low)
            };
            let is_level = |i: usize| self.direction.of(view.tangent(i).to_point()).0.abs() >= ALONG;
            let is_of_base = |i: usize| self.is_base(view.vertices[i].at) && is_level(i);
            let kept = kept_runs(edges, chain, is_out, is_of_base);
            let dropped = view.vertices.len() - kept.iter().map(Vec::len).sum::<usize>();
            if dropped > 0 && !is_grid {
                sum += view.vertices.iter().map(|edgel| edgel.strength).sum::<f32>();
                count += view.vertices.len();
                kind.get_or_insert(chain.kind);
            }
            for run in kept {
                let on_base = |edgel: &Edgel| self.is_base(edgel.at).then(|| self.direction.of(edgel.at).0);
                let pairs = run.windows(2).filter_map(|pair| Some((on_base(&pair[0])?, on_base(&pair[1])?)));
                ground.extend(pairs.map(|(a, b)| (a.min(b), a.max(b))));
                if chain.closed && dropped == 0 {
                    others.push_as(chain.kind, run.into_iter(), true);
                } else {
                    let run = self.with_divider_led_on(Polyline::open(run), rows, only_axes);
                    others.push_as(chain.kind, run.vertices.into_iter(), false);
                }
            }
        }
        Kept { edges: others, replaced: kind.map(|kind| (kind, sum / count.max(1) as f32)), ground }
    }

    /// Where a row ends beside a bar: at an axis no further than `gap_px` from it, or at its own side.
    fn end(&self, bar: &Bar, gap_px: f32, is_last: bool) -> RowEnd {
        let (own, outwards) = if is_last { (bar.to, 1.0) } else { (bar.from, -1.0) };
        let beyond = |at: f32| (at - own) * outwards;
        let is_of_bar =
            |at: f32| self.bars.iter().any(|bar| (at - bar.from).abs() <= SAME || (at - bar.to).abs() <= SAME);
        let is_axis =
            |at: f32| beyond(at) > SAME && beyond(at) <= gap_px && self.has_side(at, bar.top) && !is_of_bar(at);
        let axis = self.sides.iter().map(|side| side.at).filter(|&at| is_axis(at));
        let axis = axis.min_by(|a, b| beyond(*a).total_cmp(&beyond(*b)));
        RowEnd { at: axis.unwrap_or(own), is_axis: axis.is_some() }
    }

    /// Whether a place is on the top of a bar.
    fn is_top(&self, at: PxPoint) -> bool {
        let (across, along) = self.direction.of(at);
        let is_of = |bar: &Bar| (bar.from - SAME..=bar.to + SAME).contains(&across) && (bar.top - along).abs() <= SAME;
        self.bars.iter().any(is_of)
    }

    /// Whether a place is on the base.
    fn is_base(&self, at: PxPoint) -> bool {
        (self.direction.of(at).1 - self.base).abs() <= SAME
    }

    /// The base of rows where nothing of what is left runs along it: what bars stood on was theirs, too.
    fn gaps_of_base(&self, rows: &[BarRow], mut ground: Vec<(f32, f32)>) -> Vec<Vec<PxPoint>> {
        ground.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut gaps = Vec::new();
        for BarRow { ends: [first, last], .. } in rows {
            let mut until = first.at;
            for &(from, to) in ground.iter().chain([&(last.at, last.at)]) {
                if from - until > SAME && until < last.at {
                    gaps.push(vec![
                        self.direction.point((until, self.base)),
                        self.direction.point((from.min(last.at), self.base)),
                    ]);
                }
                until = until.max(to);
            }
        }
        gaps
    }

    /// Whether the place `at`, where the contour runs along `direction`, is on a side or the top of a bar in `rows` or
    /// `low`, or between two bars of one row.
    fn is_replaced(&self, at: PxPoint, direction: PxVector, rows: &[BarRow], low: &[Bar]) -> bool {
        let (across, along) = self.direction.of(at);
        if along <= self.base + SAME {
            return false;
        }
        let (to_side, to_level) = self.direction.of(direction.to_point());
        let (is_level, is_side) = (to_side.abs() >= ALONG, to_level.abs() >= ALONG);
        let near = |a: f32, b: f32| (a - b).abs() <= SAME;
        let of_bar = |bar: &Bar| {
            let is_on = |across: f32| across >= bar.from - SAME && across <= bar.to + SAME;
            let beside = near(across, bar.from) || near(across, bar.to);
            let is_top = near(along, bar.top) && is_on(across);
            is_side && beside && along <= bar.top + SAME
                || is_level && is_top
                // the direction at a corner is that of neither
                || is_top && beside
        };
        let between = |row: &BarRow| {
            let inside = across > row.ends[0].at + SAME && across < row.ends[1].at - SAME;
            let nearest = |bar: &&Bar| (across - bar.from).abs().min((across - bar.to).abs());
            let in_bar = row.bars.iter().any(|bar| across > bar.from && across < bar.to);
            let highest = row.bars.iter().min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
            inside && !in_bar && is_level && highest.is_some_and(|bar| along <= bar.top + SAME)
        };
        // a side that a low bar shares with a higher one is that of the higher one
        let is_of_higher = |bar: &Bar| {
            !low.contains(bar) && (near(across, bar.from) || near(across, bar.to)) && along <= bar.top + SAME
        };
        low.iter().any(of_bar) && !(is_side && self.bars.iter().any(is_of_higher))
            || rows.iter().any(|row| row.bars.iter().any(of_bar) || between(row))
    }
}

/// What of a chain is not taken out, in runs.
fn kept_runs(
    edges: &Edges,
    chain: &ChainRange,
    is_out: impl Fn(usize) -> bool,
    is_of_base: impl Fn(usize) -> bool,
) -> Vec<Vec<Edgel>> {
    let edgels = &edges.edgels[chain.edgels.clone()];
    let count = edgels.len();
    let mut out: Vec<bool> = (0..count).map(is_out).collect();
    let length =
        |run: &[usize]| run.windows(2).map(|pair| (edgels[pair[1]].at - edgels[pair[0]].at).length()).sum::<f32>();
    let runs = |out: &[bool]| crate::geom::walk::runs(count, chain.closed, |a, b| out[a] == out[b]);
    let of_all = runs(&out);
    if of_all.len() > 1 {
        let is_end = |i: usize| !chain.closed && (i == 0 || i + 1 == of_all.len());
        // a gap where a contour only crosses a bar is closed; short remains of a bar's side are dropped
        for (i, run) in of_all.iter().enumerate().filter(|(_, run)| length(run) < CROSSES) {
            let is_base = !out[run[0]] && run.iter().all(|&at| is_of_base(at));
            if !(is_base || out[run[0]] && is_end(i)) {
                run.iter().for_each(|&at| out[at] = !out[at]);
            }
        }
    }
    let all = runs(&out);
    all.iter().filter(|run| !out[run[0]]).map(|run| run.iter().map(|&at| edgels[at]).collect()).collect()
}

#[cfg(test)]
mod tests;
