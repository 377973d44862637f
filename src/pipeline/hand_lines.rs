//! Lines of a page as contours of a picture: those that a person gives, and those of a page that is laid out anew.

use lyon::geom::euclid::Box2D;

use super::kept_lines::LineName;
use crate::edges::{ChainKind, ChainRange, Edgel, Edges};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::lines::{Line, Pen, Run};
use crate::listing::first_few;
use crate::page::{Page, PartShown};
use crate::profile::Plan;
use crate::reading::DrawnArea;
use crate::units::{MmPoint, MmRect, MmVector, PageTransform, Px, PxPoint, Size};
use crate::{About, Error, Note};

/// Lines of a page, in shares of its figure, so that they fit any other figure of the same picture.
#[derive(Debug, Clone, PartialEq)]
pub struct HandLines {
    lines: Vec<HandLine>,
    /// Width of the figure by its height.
    aspect: f32,
    /// How much of a picture the figure shows, as far as its page says.
    part: Option<PartShown>,
    /// How much of each of these lines lies outside of the figure and is left out, mm.
    left_outside: Vec<(usize, f32)>,
    /// The areas that somebody drew beside them.
    areas: Vec<DrawnArea>,
    /// What the lines of the figure are called, and which of them a person drew; of none that is not known.
    names: Vec<LineName>,
}

#[derive(Debug, Clone, PartialEq)]
struct HandLine {
    /// Which line of the figure it is, or a part of.
    of_line: usize,
    /// Each with its strength.
    vertices: Vec<([f32; 2], f32)>,
    closed: bool,
    /// Whether it is the side of a disc: of a filled point on a line.
    is_disc: bool,
}

/// Lines may lie this far outside of their figure, mm: a stroke has a width.
const BESIDE: f32 = 0.5;
/// Most steps in which a side of a line that leaves the figure is looked at.
const MOST_STEPS: f32 = 10_000.0;
/// Most lines that are named.
const MOST_NAMED: usize = 5;
/// How far two shapes of a picture may differ, as a share of width by height: figures are rounded to pixels.
pub(super) const SAME_SHAPE: f32 = 0.03;

impl HandLines {
    /// The lines of a page's figure, with the strengths that their widths stand for. `plan` says which those are.
    pub fn of_figure(page: &Page, plan: &Plan) -> Self {
        Self { part: PartShown::of(page), ..Self::of(&page.figure.lines, page.figure.place, plan) }
    }

    /// The same lines, whose figure has lines of these names.
    pub fn called(self, names: Vec<LineName>) -> Self {
        Self { names, ..self }
    }

    /// The same lines of a page on which somebody drew these areas.
    pub fn beside_areas(self, areas: Vec<DrawnArea>) -> Self {
        Self { areas, ..self }
    }

    /// The areas that somebody drew beside them.
    pub(super) fn areas(&self) -> &[DrawnArea] {
        &self.areas
    }

    /// How much of a picture the figure shows.
    pub(super) fn part(&self) -> Option<&PartShown> {
        self.part.as_ref()
    }

    /// The lines of its overview; none if it has none.
    pub fn of_overview(page: &Page, plan: &Plan) -> Option<Self> {
        let overview = page.overview.as_ref().filter(|overview| !overview.lines.is_empty())?;
        Some(Self::of(&overview.lines, overview.place, plan))
    }

    fn of(lines: &[Line], place: MmRect, plan: &Plan) -> Self {
        let [width, height] = [place.width(), place.height()].map(|side| side.max(f32::MIN_POSITIVE));
        let share = |at: MmPoint| [(at.x - place.min.x) / width, (at.y - place.min.y) / height];
        let of_lines = lines.iter().enumerate().flat_map(|(of_line, line)| {
            joined(line.own_runs()).into_iter().map(move |runs| {
                let closed = runs.len() == 1 && runs[0].closed;
                let mut vertices = Vec::new();
                for (number, run) in runs.iter().enumerate() {
                    let strength = strength(run, line.strength, plan);
                    let skip = usize::from(number > 0);
                    vertices.extend(run.points.iter().skip(skip).map(|&at| (share(at), strength)));
                }
                HandLine { of_line, vertices, closed, is_disc: false }
            })
        });
        let mut own: Vec<HandLine> = of_lines.collect();
        own.iter_mut().for_each(HandLine::close);
        let marks = lines.iter().enumerate().flat_map(|(of_line, line)| {
            marks_of(line).into_iter().map(move |mark| {
                let strength = line.strength.max(plan.lines().full_strength);
                let vertices = mark.points.iter().map(|&at| (share(at), strength)).collect();
                HandLine { of_line, vertices, closed: mark.closed, is_disc: mark.is_disc }
            })
        });
        own.extend(marks);
        let length = |line: &HandLine| line.length([width, height]);
        let (mut lines, mut left_outside) = (Vec::with_capacity(own.len()), Vec::new());
        for line in own {
            let (of_line, before) = (line.of_line, length(&line));
            let inside = line.inside([width, height]);
            let outside = before - inside.iter().map(length).sum::<f32>();
            left_outside.extend((outside > 0.0).then_some((of_line, outside)));
            lines.extend(inside);
        }
        Self { lines, aspect: width / height, part: None, left_outside, areas: Vec::new(), names: Vec::new() }
    }

    /// The same lines as contours of a picture of this size, those that a person drew as such.
    ///
    /// # Errors
    /// If the picture has another shape than the figure of the page.
    pub(super) fn edges(&self, size: Size) -> Result<Edges, Error> {
        self.edges_of(size, ChainKind { exact: true, of_drawing: true, ..ChainKind::default() })
    }

    /// Whether a person drew a line.
    fn is_by_hand(&self, line: &HandLine) -> bool {
        self.name_by_hand(line.of_line).is_some()
    }

    /// The lines where the figure lies at `place`, each with its number among those of the figure.
    pub(super) fn in_place(&self, place: MmRect) -> Vec<(Line, usize)> {
        let there = |[x, y]: [f32; 2]| place.min + MmVector::new(x * place.width(), y * place.height());
        let line = |line: &HandLine| {
            let points = line.vertices.iter().map(|(at, _)| there(*at)).collect();
            let run = Run { closed: line.closed, ..Run::stroke(1.0, points) };
            (Line { strength: 1.0, runs: vec![run] }, line.of_line)
        };
        self.lines.iter().filter(|line| !line.is_disc).map(line).collect()
    }

    /// Whether a line of the figure lies outside of it as a whole.
    pub(super) fn is_outside(&self, number: usize) -> bool {
        let is_left_out = self.left_outside.iter().any(|(line, _)| *line == number);
        is_left_out && self.lines.iter().all(|line| line.of_line != number)
    }

    /// What a line of the figure is called, if a person drew it.
    pub(super) fn name_by_hand(&self, number: usize) -> Option<&str> {
        self.names.get(number).filter(|name| name.by_hand).map(|name| name.name.as_str())
    }

    /// The same. Those that a person drew come first; others are cut where they run along them within `reach` px, and
    /// end `gap` px before those that they only meet, a gap that is closed when lines are drawn.
    /// Those of a person are all of full strength, however thin they are: they are meant.
    ///
    /// # Errors
    /// As [`HandLines::edges`].
    pub(super) fn edges_under_own(
        &self,
        size: Size,
        [reach, gap]: [f32; 2],
        full_strength: f32,
    ) -> Result<Edges, Error> {
        let (by_hand, others): (Vec<&HandLine>, Vec<&HandLine>) =
            self.lines.iter().partition(|line| self.is_by_hand(line));
        let own = |lines: Vec<&HandLine>| Self {
            lines: lines.into_iter().cloned().collect(),
            aspect: self.aspect,
            part: None,
            left_outside: Vec::new(),
            areas: Vec::new(),
            names: Vec::new(),
        };
        let kind = ChainKind { exact: true, of_drawing: true, added: true, ..ChainKind::default() };
        let mut first = own(by_hand).edges_of(size, kind)?;
        first.edgels.iter_mut().for_each(|edgel| edgel.strength = edgel.strength.max(full_strength));
        let found = own(others).edges(size)?;
        if first.is_empty() {
            return Ok(found);
        }
        let near = index_of_edges(&first);
        let mut edges = Edges::none(size);
        for range in &found.chains {
            let polyline = found.chain(range);
            let whole = Polyline { vertices: polyline.vertices.to_vec(), closed: range.closed };
            for (vertices, closed) in beside(whole, &near, [reach, gap]) {
                edges.push_as(range.kind, vertices.into_iter(), closed);
            }
        }
        for range in &first.chains {
            edges.push_as(range.kind, first.chain(range).vertices.iter().copied(), range.closed);
        }
        Ok(edges)
    }

    /// Adds the lines to contours that were found, of which the parts nearer than `reach`, px, give way.
    ///
    /// # Errors
    /// As [`HandLines::edges`].
    pub(super) fn add_to(&self, found: &mut Edges, reach: f32) -> Result<(), Error> {
        let own = self.edges_of(found.size, ChainKind { exact: true, added: true, ..ChainKind::default() })?;
        let near = index_of_edges(&own);
        let is_near = |at: PxPoint| near.nearest(at, reach, |_| true).is_some();
        without(found, |_, _, edgel| is_near(edgel.at));
        for range in &own.chains {
            found.push_as(range.kind, own.chain(range).vertices.iter().copied(), range.closed);
        }
        Ok(())
    }

    /// What is told of lines outside of the figure: there is no picture there that they could belong to.
    pub fn told_outside(&self) -> Option<Note> {
        let mm = self.left_outside.iter().map(|(_, mm)| mm).sum::<f32>().round();
        let named = self.left_outside.iter().filter(|(_, mm)| *mm >= 0.5).filter_map(|(line, _)| self.names.get(*line));
        let mut named: Vec<&str> = named.map(|line| line.name.as_str()).collect();
        named.dedup();
        let names = if named.is_empty() {
            String::new()
        } else {
            format!(" ({})", first_few(&named, MOST_NAMED, |name| (*name).to_owned()))
        };
        let told =
            format!("{mm} mm of lines outside of the figure{names}; move them into it, or make another page of them");
        (mm >= 1.0).then_some(Note::NotOnPage(About::Lines, told))
    }

    /// How many lines are shorter than a length in the figure, as shares of its width.
    pub(super) fn shorter_than(&self, share: f32) -> usize {
        let length = |line: &HandLine| {
            let ends = line.vertices.windows(2).map(|pair| (pair[0].0, pair[1].0));
            ends.map(|(a, b)| (b[0] - a[0]).hypot((b[1] - a[1]) / self.aspect)).sum::<f32>()
        };
        self.lines.iter().filter(|line| !line.is_disc && length(line) < share).count()
    }

    fn edges_of(&self, size: Size, kind: ChainKind) -> Result<Edges, Error> {
        let [width, height] = [size.width as f32, size.height as f32];
        if (self.aspect / (width / height) - 1.0).abs() > SAME_SHAPE + 1.0 / width.min(height) {
            return Err(Error::OtherShape { lines: self.aspect, picture: width / height });
        }
        let mut edges = Edges::none(size);
        for line in self.lines.iter().filter(|line| line.vertices.len() > 1) {
            let edgel = |&([x, y], strength): &([f32; 2], f32)| Edgel {
                at: PxPoint::new(x * width, y * height),
                strength,
                // only a disc has an inside
                contrast: [if line.is_disc { strength } else { 0.0 }, 0.0, 0.0],
            };
            let kind = ChainKind { added: kind.added || self.is_by_hand(line), ..kind };
            edges.push_as(kind, line.vertices.iter().map(edgel), line.closed);
        }
        Ok(edges)
    }
}

/// Places that differ by less are one but for rounding, in shares of the figure.
const ROUNDED: f32 = 1e-5;

impl HandLine {
    /// A line of several widths that comes back to where it began is a ring.
    fn close(&mut self) {
        let (Some((first, _)), Some((last, _))) = (self.vertices.first(), self.vertices.last()) else { return };
        let near = (first[0] - last[0]).abs() < ROUNDED && (first[1] - last[1]).abs() < ROUNDED;
        if !self.closed && near && self.vertices.len() > 3 {
            self.vertices.pop();
            self.closed = true;
        }
    }

    /// Its length in a figure of this width and height, mm.
    fn length(&self, [width, height]: [f32; 2]) -> f32 {
        let distance = |a: [f32; 2], b: [f32; 2]| ((b[0] - a[0]) * width).hypot((b[1] - a[1]) * height);
        let ends = self.vertices.first().zip(self.vertices.last()).filter(|_| self.closed);
        let back = ends.map_or(0.0, |(first, last)| distance(last.0, first.0));
        back + self.vertices.windows(2).map(|pair| distance(pair[0].0, pair[1].0)).sum::<f32>()
    }

    /// Its parts inside the figure, of this width and height in mm.
    fn inside(self, [width, height]: [f32; 2]) -> Vec<Self> {
        let (x, y) = (BESIDE / width, BESIDE / height);
        let is_outside = |&([a, b], _): &([f32; 2], f32)| a < -x || a > 1.0 + x || b < -y || b > 1.0 + y;
        if !self.vertices.iter().any(is_outside) {
            return vec![self];
        }
        let Self { of_line, mut vertices, closed, is_disc } = self;
        if closed {
            vertices.extend(vertices.first().copied());
        }
        let mut fine = Vec::new();
        for pair in vertices.windows(2) {
            let [(a, strength), (b, other)] = [pair[0], pair[1]];
            let length = ((b[0] - a[0]) * width).hypot((b[1] - a[1]) * height);
            let steps = (length / BESIDE).ceil().clamp(1.0, MOST_STEPS);
            let at = |k: f32| ([a[0] + (b[0] - a[0]) * k, a[1] + (b[1] - a[1]) * k], strength + (other - strength) * k);
            fine.extend((0..steps as usize).map(|step| at(step as f32 / steps)));
        }
        fine.extend(vertices.last().filter(|_| !closed));
        let parts = outside(&fine, closed, is_outside).into_iter();
        parts.map(|(vertices, closed)| Self { of_line, vertices, closed, is_disc: is_disc && closed }).collect()
    }
}

/// A point or a tick on a line of a page, as it is in a drawing.
struct LineMark {
    points: Vec<MmPoint>,
    closed: bool,
    is_disc: bool,
}

/// So many points are a circle.
const CIRCLE: u32 = 24;

/// The beads of a printed line, and the ticks, points and heads of one of dots.
fn marks_of(line: &Line) -> Vec<LineMark> {
    let circle = |at: MmPoint, radius: f32, is_disc: bool| {
        let turn = |k: u32| (k as f32 * std::f32::consts::TAU / CIRCLE as f32).sin_cos();
        let points = (0..CIRCLE).map(turn).map(|(y, x)| at + MmVector::new(x, y) * radius).collect();
        LineMark { points, closed: true, is_disc }
    };
    let beads = line.beads().map(|run| {
        let middle = MmRect::from_points(&run.points).center();
        circle(middle, 0.5 * run.width, true)
    });
    let points = line.row_points().map(|point| circle(point.at, point.radius, point.is_filled));
    let ticks = line.row_ticks().map(|(run, at)| {
        let points = std::iter::once(at).chain(run.points.last().copied()).collect();
        LineMark { points, closed: false, is_disc: false }
    });
    let heads = line.row_heads().map(|(tip, _, [one, other])| LineMark {
        points: vec![one, tip, other],
        closed: false,
        is_disc: false,
    });
    beads.chain(points).chain(ticks).chain(heads).collect()
}

/// Runs that follow one another, line by line.
fn joined(runs: &[Run]) -> Vec<Vec<&Run>> {
    let mut all: Vec<Vec<&Run>> = Vec::new();
    for run in runs {
        let last = all.last().and_then(|line| line.last()).filter(|last| !last.closed && !run.closed);
        let follows = last.is_some_and(|last| last.points.last() == run.points.first());
        match all.last_mut() {
            Some(line) if follows => line.push(run),
            _ => all.push(vec![run]),
        }
    }
    all
}

/// The strength whose lines are as wide as a run; of the widest, and of dots, that of the line.
fn strength(run: &Run, of_line: f32, plan: &Plan) -> f32 {
    let params = plan.lines();
    let swell = plan.profile().print.swell;
    let range = (params.width_max - params.width_min).max(f32::EPSILON);
    let share = ((run.width + swell - params.width_min) / range).clamp(0.0, 1.0);
    if run.pen != Pen::Stroke || share > 0.99 {
        return of_line.max(params.full_strength);
    }
    params.least_strength + share * (params.full_strength - params.least_strength)
}

/// The segments of contours, to be found by their places.
pub(super) fn index_of_edges(edges: &Edges) -> Nearby<Px> {
    let mut near = empty_index(edges.size);
    (0..).zip(edges.chains()).for_each(|(line, chain)| near.insert_line(line, chain, 0.0));
    near
}

/// The segments of drawn lines, to be found by their places in a picture of this size.
pub(super) fn index_of_drawn(lines: &[Line], size: Size, transform: &PageTransform) -> Nearby<Px> {
    let mut near = empty_index(size);
    for (line, run) in (0..).zip(lines).flat_map(|(number, line)| line.runs.iter().map(move |run| (number, run))) {
        let points: Vec<PxPoint> = run.points.iter().map(|&at| transform.to_px(at)).collect();
        near.insert_line(line, PolylineRef { vertices: &points, closed: run.closed }, 0.0);
    }
    near
}

/// An index for a picture of this size.
fn empty_index(size: Size) -> Nearby<Px> {
    let area = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    Nearby::new(area, CELL)
}

/// Side of the cells of that, px.
const CELL: f32 = 16.0;

/// The parts of a contour that do not run along lines nearer than `reach`, px; where it meets one, up to `gap` from it.
fn beside(whole: Polyline<Edgel>, near: &Nearby<Px>, [reach, gap]: [f32; 2]) -> Vec<(Vec<Edgel>, bool)> {
    let distance = |edgel: &Edgel| near.nearest(edgel.at, reach, |_| true).map(|(distance, ..)| distance);
    let closed = whole.closed;
    let mut vertices: Vec<Edgel> = whole.segments().flat_map(|(a, b)| steps(a, b, STEP * reach)).collect();
    vertices.extend(whole.vertices.last().filter(|_| !closed));
    if closed {
        // begun away from them, no part along them is cut in two
        let first = vertices.iter().position(|edgel| distance(edgel).is_none());
        vertices.rotate_left(first.unwrap_or(0));
    }
    let distances: Vec<Option<f32>> = vertices.iter().map(distance).collect();
    let mut is_gone = vec![false; vertices.len()];
    let mut at = 0;
    for part in distances.chunk_by(|a, b| a.is_some() == b.is_some()) {
        let range = at..at + part.len();
        at = range.end;
        let nearest = part.iter().flatten().copied().fold(f32::MAX, f32::min);
        let arc: f32 = vertices[range.clone()].windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
        let meets = nearest <= MEETS * reach && arc <= CROSSING * reach;
        for (is_gone, distance) in is_gone[range].iter_mut().zip(part) {
            *is_gone = distance.is_some_and(|distance| !meets || distance < gap);
        }
    }
    if is_gone.iter().all(|gone| !gone) {
        return vec![(whole.vertices, closed)];
    }
    let marked: Vec<(Edgel, bool)> = vertices.into_iter().zip(is_gone).collect();
    let parts = outside(&marked, closed, |(_, gone)| *gone);
    parts.into_iter().map(|(part, closed)| (part.into_iter().map(|(edgel, _)| edgel).collect(), closed)).collect()
}

/// A segment from its first end on, in steps of at most this length, px.
fn steps(a: &Edgel, b: &Edgel, longest: f32) -> impl Iterator<Item = Edgel> + use<> {
    let (a, b) = (*a, *b);
    let count = ((b.at - a.at).length() / longest).ceil().max(1.0);
    (0..count as u32).map(move |k| {
        let share = k as f32 / count;
        Edgel { at: a.at.lerp(b.at, share), strength: a.strength + share * (b.strength - a.strength), ..a }
    })
}

/// Contours are looked at this often, as a share of how far lines reach.
const STEP: f32 = 0.1;
/// A line meets another if it comes this near, as a share of that: two lines that were drawn to touch seldom do
/// exactly.
const MEETS: f32 = 0.25;
/// A line only crosses another if it is beside it for no longer than this, in the same unit: at 42 degrees or more.
const CROSSING: f32 = 3.0;

/// Takes the parts of contours out that are `gone`; each chain has its number.
pub(super) fn without(edges: &mut Edges, gone: impl Fn(usize, &ChainRange, &Edgel) -> bool) {
    let (edgels, chains) = (std::mem::take(&mut edges.edgels), std::mem::take(&mut edges.chains));
    for (number, range) in chains.iter().enumerate() {
        let vertices = &edgels[range.edgels.clone()];
        for (vertices, closed) in outside(vertices, range.closed, |edgel| gone(number, range, edgel)) {
            edges.push_as(range.kind, vertices.into_iter(), closed);
        }
    }
}

/// The lines with those first that a person drew or added; within both groups the order stays.
pub(super) fn by_hand_first(lines: Vec<Line>, edges: &Edges, transform: &PageTransform) -> Vec<Line> {
    let own = added(edges);
    if own.is_empty() {
        return lines;
    }
    let near = index_of_edges(&own);
    let reach = BY_HAND / transform.mm_per_px();
    let is_there = |at: MmPoint| near.nearest(transform.to_px(at), reach, |_| true).is_some();
    let is_by_hand = |line: &Line| {
        let points = || line.runs.iter().flat_map(|run| &run.points);
        2 * points().filter(|at| is_there(**at)).count() > points().count()
    };
    let (mut first, others): (Vec<Line>, Vec<Line>) = lines.into_iter().partition(is_by_hand);
    first.extend(others);
    first
}

/// How far a line may lie from where a person drew it, mm: lines are moved aside only where others came first.
const BY_HAND: f32 = 0.5;

/// The contours that a person drew or added.
pub(super) fn added(edges: &Edges) -> Edges {
    let mut own = Edges::none(edges.size);
    for range in edges.chains.iter().filter(|range| range.kind.added) {
        own.push_as(range.kind, edges.chain(range).vertices.iter().copied(), range.closed);
    }
    own
}

/// The parts of a chain of which nothing is `inside`, and whether each is closed.
pub(super) fn outside<V: Copy>(vertices: &[V], closed: bool, inside: impl Fn(&V) -> bool) -> Vec<(Vec<V>, bool)> {
    let Some(first) = vertices.iter().position(&inside) else { return vec![(vertices.to_vec(), closed)] };
    let mut vertices = vertices.to_vec();
    if closed {
        // begun inside, no other part is cut in two
        vertices.rotate_left(first);
    }
    let parts = vertices.chunk_by(|a, b| inside(a) == inside(b)).filter(|part| !inside(&part[0]) && part.len() > 1);
    parts.map(|part| (part.to_vec(), false)).collect()
}

#[cfg(test)]
mod tests;
