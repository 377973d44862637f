//! Bars of a chart among the contours of a drawing: where they stand, and whether the lines on a page have them whole.

use crate::edges::{ChainRange, Edges};
use crate::geom::polyline::PolylineRef;
use crate::geom::simplify::simplify;
use crate::lines::{Line, index_of_lines};
use crate::units::{MmPoint, MmRect, PageTransform, PxPoint};

/// Two coordinates nearer than this, px of the working picture, are one: the sides of a stroke, and what rounds its
/// corners.
pub(super) const SAME: f32 = 3.0;
/// Farthest that a straight piece of a contour may lie from it, px.
const STRAIGHT_WITHIN: f32 = 1.5;
/// Fewer bars have room on any page.
const LEAST: usize = 4;
/// Share of a bar's side that a contour covers at least: a curve may run before it.
const COVERED: f32 = 0.7;
/// A bar's side ends at most so far below its top, px: in a bitmap corners are round.
const BELOW_TOP: f32 = 8.0;
/// Widths of bars differ by this factor at most from their median: a frame around all of them is no bar.
const ALIKE: f32 = 2.0;
/// Of cells between gridlines this share at least, two of three, reaches up to the frame side by side: others seem to
/// end below it.
const CELLS: f32 = 0.66;
/// A level with straight lines over this share of a chart's width is one of its gridlines.
const GRIDLINE: f32 = 0.2;
/// Lines run along this share of a base at least: the lower sides of bars, or an axis.
const GROUND: f32 = 0.4;
/// More straight pieces are no chart, but squared paper or a plan.
const MOST: usize = 4000;
/// Of a short path at most this share may be missing.
const MOST_MISSING: f32 = 0.5;
/// Of a path that may as well not be drawn at all, at most this share may be missing.
const MOST_OF_NONE: f32 = 0.2;
/// What of a path is missing at least where it is not drawn at all: its ends may lie on another line.
const NONE: f32 = 0.8;
/// Distance of the places at which is looked, mm.
const STEP: f32 = 0.5;

/// In which direction bars point: coordinates are across the bars and along them, from the base on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Up,
    Right,
}

impl Direction {
    pub(super) fn of(self, at: PxPoint) -> (f32, f32) {
        match self {
            Self::Up => (at.x, -at.y),
            Self::Right => (at.y, at.x),
        }
    }

    pub(super) fn point(self, (across, along): (f32, f32)) -> PxPoint {
        match self {
            Self::Up => PxPoint::new(across, -along),
            Self::Right => PxPoint::new(along, across),
        }
    }
}

/// A bar: from where to where across, and where it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bar {
    pub(super) from: f32,
    pub(super) to: f32,
    pub(super) top: f32,
}

/// A straight piece of a contour in one of the two directions: at one coordinate, from and to in the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BaseSpan {
    pub(super) at: f32,
    pub(super) from: f32,
    pub(super) to: f32,
}

/// The bars of a chart, side by side on one base.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chart {
    pub(super) direction: Direction,
    pub(super) base: f32,
    /// In order.
    pub(super) bars: Vec<Bar>,
    /// Straight pieces along bars.
    pub(super) sides: Vec<BaseSpan>,
    /// Where gridlines are.
    pub(super) gridlines: Vec<f32>,
    /// Where the side of a frame around the bars is that lies beyond all of them.
    pub(super) frame: Option<f32>,
    /// Whether most of the bars are stacks of parts.
    pub(super) is_divided: bool,
}

impl Chart {
    /// The chart of a drawing; none if it has none.
    pub(super) fn of(edges: &Edges) -> Option<Self> {
        if !edges.of_drawing() || edges.chains.iter().any(|chain| chain.kind.added) {
            return None;
        }
        // a gridline between two bars at the height of the lower one is no bar
        let chains = edges.chains.iter().filter(|chain| !chain.kind.faint);
        let pieces: Vec<(PxPoint, PxPoint)> = chains.flat_map(|chain| straight(edges, chain)).take(MOST + 1).collect();
        if pieces.len() > MOST {
            return None;
        }
        let charts = [Direction::Up, Direction::Right].map(|direction| Self::pointing(direction, edges, &pieces));
        charts.into_iter().flatten().max_by_key(|chart| (chart.bars.len(), chart.direction == Direction::Up))
    }

    fn pointing(direction: Direction, edges: &Edges, pieces: &[(PxPoint, PxPoint)]) -> Option<Self> {
        let (mut sides, mut levels) = (Vec::new(), Vec::new());
        for &(a, b) in pieces {
            let ((a, up), (b, down)) = (direction.of(a), direction.of(b));
            if (a - b).abs() <= SAME && (up - down).abs() > SAME {
                sides.push(BaseSpan { at: 0.5 * (a + b), from: up.min(down), to: up.max(down) });
            } else if (up - down).abs() <= SAME && (a - b).abs() > SAME {
                levels.push(BaseSpan { at: 0.5 * (up + down), from: a.min(b), to: a.max(b) });
            }
        }
        let levels = joined(levels);
        let base = base(&sides, &levels)?;
        let (bars, gridlines, frame, is_divided) = (Vec::new(), Vec::new(), None, false);
        let mut chart = Self { direction, base, bars, sides, gridlines, frame, is_divided };
        chart.bars = chart.bars_below(&levels);
        chart.is_divided = 2 * chart.lowest_parts(&levels).len() > chart.bars.len();
        if are_cells(&chart.bars, &levels) {
            return None;
        }
        // where both sides of a bar go on above its top, they may be squared paper that a curve hides in part: such
        // tops do not count
        let is_above = |across: f32, top: f32| {
            chart.sides.iter().any(|side| (side.at - across).abs() <= SAME && side.to > top + 2.0 * SAME)
        };
        let ends = |bar: &&Bar| !(is_above(bar.from, bar.top) && is_above(bar.to, bar.top));
        let tops = || chart.bars.iter().filter(ends).map(|bar| bar.top);
        let (lowest, highest) = (tops().fold(f32::MAX, f32::min), tops().fold(f32::MIN, f32::max));
        // a row of windows is no chart
        let are_stacks = || lowest <= highest && chart.are_stacks(&levels);
        if chart.bars.len() < LEAST || highest - lowest <= SAME && !are_stacks() {
            return None;
        }
        // in a bitmap the top of a bar that ends on a gridline is a part of that, and is missing without it
        if edges.chains.iter().all(|chain| chain.kind.exact) {
            chart.gridlines = chart.gridlines(edges);
        }
        chart.frame = chart.frame_beyond(&levels);
        Some(chart)
    }

    /// Whether bars of one height are stacks of parts, as in a chart of shares, where all end at 100 percent: they are
    /// apart from one another, and most of them are divided, their lowest parts at heights of which none is that of
    /// most. Windows are divided alike.
    fn are_stacks(&self, levels: &[BaseSpan]) -> bool {
        let are_apart = self.bars.windows(2).all(|pair| pair[1].from - pair[0].to > SAME);
        let parts = self.lowest_parts(levels);
        let alike = |at: &f32| parts.iter().filter(|other| (*other - at).abs() <= SAME).count();
        let most_alike = parts.iter().map(alike).max().unwrap_or(0);
        are_apart && 2 * parts.len() > self.bars.len() && 2 * most_alike <= parts.len()
    }

    /// How high the lowest parts of those bars are that some of these levels divide.
    fn lowest_parts(&self, levels: &[BaseSpan]) -> Vec<f32> {
        let lowest_part = |bar: &Bar| {
            let (low, high) = (self.base + 2.0 * SAME, bar.top - 2.0 * SAME);
            let divides = |level: &&BaseSpan| {
                let is_within = level.from >= bar.from - SAME && level.to <= bar.to + SAME;
                is_within && level.to - level.from >= COVERED * (bar.to - bar.from) && (low..high).contains(&level.at)
            };
            levels.iter().filter(divides).map(|level| level.at).min_by(f32::total_cmp)
        };
        self.bars.iter().filter_map(lowest_part).collect()
    }

    /// Whether straight pieces run from the base up to `top` at this place across.
    pub(super) fn has_side(&self, across: f32, top: f32) -> bool {
        let mut here: Vec<(f32, f32)> = self
            .sides
            .iter()
            .filter(|side| (side.at - across).abs() <= SAME)
            .map(|side| (side.from.max(self.base), side.to.min(top)))
            .collect();
        here.sort_by(|a, b| a.0.total_cmp(&b.0));
        if !here.iter().any(|(_, to)| *to >= top - BELOW_TOP) {
            return false;
        }
        let (mut covered, mut until) = (0.0, f32::MIN);
        for (from, to) in here {
            covered += (to - from.max(until)).max(0.0);
            until = until.max(to);
        }
        covered >= COVERED * (top - self.base)
    }

    /// Whether a straight piece runs on beyond `top` at this place across.
    fn goes_on(&self, across: f32, top: f32) -> bool {
        let is_here = |side: &&BaseSpan| (side.at - across).abs() <= SAME;
        self.sides.iter().filter(is_here).any(|side| side.from <= top && side.to > top + 2.0 * SAME)
    }

    /// The bars that end at some of these levels.
    fn bars_below(&self, levels: &[BaseSpan]) -> Vec<Bar> {
        let mut found: Vec<(Bar, bool)> = Vec::new();
        for level in levels.iter().filter(|level| level.at > self.base + 2.0 * SAME) {
            // the tops of bars of one height that touch are one level
            let inside = |side: &&BaseSpan| side.at > level.from + SAME && side.at < level.to - SAME;
            let mut cuts: Vec<f32> = self.sides.iter().filter(inside).map(|side| side.at).collect();
            cuts.retain(|&across| self.has_side(across, level.at));
            cuts.extend([level.from, level.to]);
            cuts.sort_by(f32::total_cmp);
            cuts.dedup_by(|a, b| *a - *b <= SAME);
            for pair in cuts.windows(2) {
                let bar = Bar { from: pair[0], to: pair[1], top: level.at };
                if self.has_side(bar.from, bar.top) && self.has_side(bar.to, bar.top) {
                    found.push((bar, self.goes_on(bar.from, bar.top) && self.goes_on(bar.to, bar.top)));
                }
            }
        }
        // a gridline between two bars that are higher is no bar: there are several at its level
        let at_level = |bar: &Bar| found.iter().filter(|(other, _)| (other.top - bar.top).abs() <= SAME).count();
        let mut bars: Vec<Bar> =
            found.iter().filter(|(bar, between)| !between || at_level(bar) == 1).map(|(bar, _)| *bar).collect();
        let width = |bar: &Bar| bar.to - bar.from;
        bars.sort_by(|a, b| width(a).total_cmp(&width(b)).then(b.top.total_cmp(&a.top)));
        let Some(median) = bars.get(bars.len() / 2).map(width) else { return Vec::new() };
        bars.retain(|bar| width(bar) <= ALIKE * median && width(bar) >= median / ALIKE);
        let mut apart: Vec<Bar> = Vec::new();
        for bar in bars {
            let overlap = |other: &&mut Bar| bar.from < other.to - SAME && bar.to > other.from + SAME;
            match apart.iter_mut().find(overlap) {
                // the parts of a stacked bar
                Some(other) if (width(other) - width(&bar)).abs() <= 2.0 * SAME => other.top = other.top.max(bar.top),
                // of bars that overlap the narrower stays, which came first
                Some(_) => {}
                None => apart.push(bar),
            }
        }
        apart.sort_by(|a, b| a.from.total_cmp(&b.from));
        apart
    }

    /// At which levels straight lines run over much of the chart that are no tops of bars.
    fn gridlines(&self, edges: &Edges) -> Vec<f32> {
        let (first, last) = (self.bars[0].from, self.bars[self.bars.len() - 1].to);
        let is_top = |level: &BaseSpan| {
            let within = |bar: &Bar| level.from >= bar.from - SAME && level.to <= bar.to + SAME;
            self.bars.iter().any(|bar| within(bar) && (bar.top - level.at).abs() <= SAME)
        };
        let mut levels: Vec<BaseSpan> =
            edges.chains.iter().filter_map(|chain| self.level(edges, chain)).filter(|level| !is_top(level)).collect();
        levels.retain(|level| level.at > self.base + 2.0 * SAME);
        levels.sort_by(|a, b| a.at.total_cmp(&b.at));
        let same = levels.chunk_by(|a, b| b.at - a.at <= SAME);
        let length = |level: &[BaseSpan]| level.iter().map(|span| span.to - span.from).sum::<f32>();
        let grid: Vec<f32> = same.filter(|level| length(level) >= GRIDLINE * (last - first)).map(|l| l[0].at).collect();
        // one line across may say something by itself, such as a mean
        if grid.len() > 1 { grid } else { Vec::new() }
    }

    /// The highest of these levels, if no bar reaches it and two lines run up to its ends from the base, on either side
    /// of the bars.
    fn frame_beyond(&self, levels: &[BaseSpan]) -> Option<f32> {
        let (first, last) = (self.bars.first()?, self.bars.last()?);
        let highest = levels.iter().max_by(|a, b| a.at.total_cmp(&b.at))?;
        let is_around = highest.from <= first.from + SAME && highest.to >= last.to - SAME;
        let is_beyond = self.bars.iter().all(|bar| bar.top + SAME < highest.at);
        let has_sides = self.has_side(highest.from, highest.at) && self.has_side(highest.to, highest.at);
        (is_around && is_beyond && has_sides).then_some(highest.at)
    }

    /// A chain that is one straight line across the bars.
    fn level(&self, edges: &Edges, chain: &ChainRange) -> Option<BaseSpan> {
        let mut pieces = straight(edges, chain).into_iter();
        let (Some((a, b)), None, false) = (pieces.next(), pieces.next(), chain.closed) else { return None };
        let ((a, up), (b, down)) = (self.direction.of(a), self.direction.of(b));
        ((up - down).abs() <= SAME).then(|| BaseSpan { at: 0.5 * (up + down), from: a.min(b), to: a.max(b) })
    }

    /// Whether a chain is a gridline or a part of one, or, where there are none, the side of the frame beyond the bars.
    pub(super) fn is_gridline(&self, edges: &Edges, chain: &ChainRange) -> bool {
        let frame = self.frame.filter(|_| self.gridlines.is_empty());
        let is_at = |level: BaseSpan| self.gridlines.iter().chain(&frame).any(|at| (at - level.at).abs() <= 2.0 * SAME);
        self.level(edges, chain).is_some_and(is_at)
    }

    /// Whether there is anything beside the bars that they can do without: gridlines, or the side of a frame.
    pub(super) fn has_more_than_bars(&self) -> bool {
        !self.gridlines.is_empty() || self.frame.is_some()
    }

    /// The outline of a bar, from the base to the base.
    pub(super) fn outline(&self, bar: &Bar) -> Vec<PxPoint> {
        [(bar.from, self.base), (bar.from, bar.top), (bar.to, bar.top), (bar.to, self.base)]
            .map(|at| self.direction.point(at))
            .to_vec()
    }
}

/// The straight pieces of a chain.
fn straight(edges: &Edges, chain: &ChainRange) -> Vec<(PxPoint, PxPoint)> {
    let points: Vec<PxPoint> = edges.edgels[chain.edgels.clone()].iter().map(|edgel| edgel.at).collect();
    let corners = simplify(PolylineRef { vertices: &points, closed: chain.closed }, STRAIGHT_WITHIN);
    let mut pieces: Vec<(PxPoint, PxPoint)> =
        corners.windows(2).map(|pair| (points[pair[0]], points[pair[1]])).collect();
    if let (true, Some(&first), Some(&last)) = (chain.closed, corners.first(), corners.last()) {
        pieces.push((points[last], points[first]));
    }
    pieces
}

/// Where most of the sides of bars begin, on straight lines across; none if too few do.
fn base(sides: &[BaseSpan], levels: &[BaseSpan]) -> Option<f32> {
    let mut from: Vec<f32> = sides.iter().map(|side| side.from).collect();
    from.sort_by(f32::total_cmp);
    let until = |i: usize| from.partition_point(|at| *at <= from[i] + SAME);
    let is_ground = |at: f32| {
        let here = sides.iter().filter(|side| (side.from - at).abs() <= SAME).map(|side| side.at);
        let (first, last) = here.fold((f32::MAX, f32::MIN), |(a, b), at| (a.min(at), b.max(at)));
        let along = levels.iter().filter(|level| (level.at - at).abs() <= SAME);
        along.map(|level| (level.to.min(last) - level.from.max(first)).max(0.0)).sum::<f32>() >= GROUND * (last - first)
    };
    let candidates = (0..from.len()).map(|i| (until(i) - i, i)).filter(|(count, _)| *count > LEAST);
    let grounds = candidates.map(|(count, i)| (count, from[i + count / 2])).filter(|(_, at)| is_ground(*at));
    grounds.max_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1))).map(|(_, at)| at)
}

/// Whether bars are cells between gridlines in the frame of a plot: most reach up to the highest of these levels (in
/// order) that any does, side by side, and that goes on over all of them, as the top of no histogram does. Some may
/// seem to end below it, at a legend or where a curve hides a piece of a gridline.
fn are_cells(bars: &[Bar], levels: &[BaseSpan]) -> bool {
    let [Some(first), Some(last)] = [bars.first(), bars.last()] else { return false };
    let highest = bars.iter().map(|bar| bar.top).fold(f32::MIN, f32::max);
    // in a bitmap corners are round, and a curve may cut the frame
    let gap = bars.iter().map(|bar| 0.5 * (bar.to - bar.from)).fold(BELOW_TOP, f32::min);
    let frame = levels.iter().filter(|level| (level.at - highest).abs() <= SAME);
    let until =
        frame.fold(first.from, |until, level| if level.from <= until + gap { until.max(level.to) } else { until });
    let is_framed = until >= last.to - gap;
    let high: Vec<&Bar> = bars.iter().filter(|bar| highest - bar.top <= SAME).collect();
    let touch = |a: &Bar, b: &Bar| (a.to - b.from).abs() <= SAME || (b.to - a.from).abs() <= SAME;
    let cells = high.iter().filter(|bar| high.iter().any(|other| touch(bar, other))).count();
    cells > 0 && cells as f32 >= CELLS * bars.len() as f32 && is_framed
}

/// Levels that continue one another as one.
fn joined(mut levels: Vec<BaseSpan>) -> Vec<BaseSpan> {
    levels.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut all: Vec<BaseSpan> = Vec::new();
    for level in levels {
        match all.iter_mut().find(|to| (to.at - level.at).abs() <= SAME && level.from <= to.to + SAME) {
            Some(to) => to.to = to.to.max(level.to),
            None => all.push(level),
        }
    }
    all
}

/// A path along which there should be a line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct WantedPath {
    pub(super) path: Vec<PxPoint>,
    /// Farthest that the line may lie from it, mm.
    pub(super) reach: f32,
    /// Whether it may as well not be drawn at all.
    pub(super) or_none: bool,
    /// What it counts for, in its lengths.
    pub(super) weight: f32,
}

/// How much of some paths is not drawn, mm, and the length of all. What is missing of a path less than `least` is
/// where lines join.
pub(super) fn missing(wanted: &[WantedPath], lines: &[Line], transform: &PageTransform, least: f32) -> (f32, f32) {
    let area = MmRect::from_points(wanted.iter().flat_map(|wanted| &wanted.path).map(|&at| transform.to_mm(at)));
    let index = index_of_lines(lines, area, wanted.iter().map(|wanted| wanted.reach).fold(0.0, f32::max));
    let is_drawn = |at: MmPoint, reach: f32| index.nearest(at, reach, |_| true).is_some();
    let (mut missing, mut all) = (0.0, 0.0);
    for WantedPath { path, reach, or_none, weight } in wanted {
        let (mut undrawn, mut length) = (0.0, 0.0);
        for pair in path.windows(2) {
            let (a, b) = (transform.to_mm(pair[0]), transform.to_mm(pair[1]));
            let steps = ((b - a).length() / STEP).ceil().max(1.0) as u32;
            let share = |step: u32| (step as f32 + 0.5) / steps as f32;
            let count = (0..steps).filter(|&step| !is_drawn(a.lerp(b, share(step)), *reach)).count();
            undrawn += (b - a).length() * count as f32 / steps as f32;
            length += (b - a).length();
        }
        all += weight * length;
        let is_none = *or_none && undrawn >= NONE * length;
        let most = if *or_none { MOST_OF_NONE } else { MOST_MISSING };
        missing += if undrawn > least.min(most * length) && !is_none { weight * undrawn } else { 0.0 };
    }
    (missing, all)
}

#[cfg(test)]
mod tests;
