//! What of the contours is not drawn: how much, and where most of it is.

use std::collections::BTreeMap;
use std::f32::consts::FRAC_1_SQRT_2;

use super::clearance::LEVEL;
use super::faint::is_faint;
use super::params::{PagePart, Params};
use super::vertex::{Vertex, nearby};
use crate::geom::form::{Form, OpenForm, SLACK, from_to};
use crate::geom::nearby::Segment;
use crate::geom::ninths::{NAMES, most_of, ninth};
use crate::geom::polyline::{self, Polyline};
use crate::geom::segment_distance;
use crate::units::{MmPoint, MmRect};

/// What was worth a line and is not drawn: too near to others, or in a drawing too short.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lost {
    /// Length of all that was worth a line, mm.
    pub wanted: f32,
    /// Length of what is not drawn of it, mm.
    pub lost: f32,
    /// The same in each of nine parts of the figure, row by row from the top left.
    pub by_place: [f32; 9],
    /// How much of that is of gridlines: of level and upright parts of thin and pale lines.
    pub of_gridlines: [f32; 9],
    /// How many rings are not drawn as such.
    pub rings: usize,
    /// Small shapes that are not drawn, or that a device has not all dots for.
    pub signs: Vec<LostSign>,
    /// Marks too short for a line.
    pub marks: LostMarks,
    /// Scales that a page of dots has not all ticks of.
    pub scales: Vec<LostScale>,
    /// Lines of a drawing of which nothing is drawn.
    pub gone: Vec<LostLine>,
    /// The gaps in closed lines of a drawing that are open on the page.
    pub gaps: Vec<LostLine>,
    /// What is missing of open lines of a drawing of which pieces are drawn.
    pub torn: Vec<LostLine>,
    /// What is missing on paper between ends of lines of a drawing and the lines that they met.
    pub loose: Vec<LostLine>,
    /// How many lines a grid has that is left out as a whole: a squared one that is torn on dots, and any in overviews.
    pub gridlines: usize,
}

/// A line of which nothing is drawn, or so little that nobody would know it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LostLine {
    /// The box around it.
    pub extent: MmRect,
    /// Its length, mm.
    pub length: f32,
    /// Whether it is a closed shape.
    pub closed: bool,
    /// Whether it is thin and pale, as one of a grid.
    pub is_faint: bool,
    /// What an open line is of which nothing is drawn.
    pub form: Option<LostForm>,
}

impl LostLine {
    fn of(line: &Polyline<Vertex>) -> Self {
        let path: Vec<MmPoint> = line.vertices.iter().map(|vertex| vertex.at).collect();
        let form = if line.closed { None } else { lost_form(&path) };
        let extent = MmRect::from_points(&path);
        Self { extent, length: line.length(), closed: line.closed, is_faint: is_faint(line), form }
    }
}

/// What an open line is that is not drawn: its form, and from where to where it leads, in words or none.
pub(super) type LostForm = (Form, &'static str);

/// What a line along a path is; none of one that comes back to where it began.
pub(crate) fn lost_form(path: &[MmPoint]) -> Option<LostForm> {
    let (first, last) = (path.first()?, path.last()?);
    (first != last).then(|| (OpenForm::of(path, polyline::length(path), SLACK).form, from_to(path)))
}

/// A line of which less than this share is drawn is gone.
pub const GONE: f32 = 0.2;

/// A piece that is drawn stands for no line that it crosses, as the ring of a lamp the cross in it: their directions
/// differ by at most 60 degrees. Chosen by us: what is moved aside or round a corner differs by less for nearly all of
/// its length. The cosine.
const STANDS_ALONG: f32 = 0.5;

/// Which of these lines are gone, where those of `drawn` stand for them: each piece for the line along it that is
/// nearest to it.
pub(super) fn gone<'a>(
    lines: &[&Polyline<Vertex>],
    drawn: impl Iterator<Item = &'a Polyline<Vertex>>,
    area: MmRect,
    params: &Params,
) -> Vec<LostLine> {
    let near = nearby(lines.iter().copied(), area, params);
    let mut kept = vec![0.0; lines.len()];
    for (a, b) in drawn.flat_map(Polyline::segments) {
        let way = (b.at - a.at).try_normalize().unwrap_or_default();
        let is_along =
            |other: &Segment| way.dot((other.b - other.a).try_normalize().unwrap_or_default()).abs() >= STANDS_ALONG;
        if let Some((_, _, segment)) = near.nearest(a.at.lerp(b.at, 0.5), params.farthest_moved(), is_along) {
            kept[segment.line as usize] += (b.at - a.at).length();
        }
    }
    let gone = lines.iter().zip(kept).filter(|(line, kept)| *kept < GONE * line.length());
    gone.map(|(line, _)| LostLine::of(line)).collect()
}

/// Shortest gap in a closed line by which it is felt as open, mm: more than a finger slips over, as on a dashed line.
pub(crate) const GAP: f32 = 4.0;

/// The longest gap of each closed line of which most is drawn, and that is not closed on the page: where no line of
/// `drawn` is near.
pub(super) fn gaps<'a>(
    lines: &[&Polyline<Vertex>],
    drawn: impl Iterator<Item = &'a Polyline<Vertex>> + Clone,
    area: MmRect,
    params: &Params,
) -> Vec<LostLine> {
    let are_closed = closed_on_page(lines, drawn.clone(), area, params);
    let near = nearby(drawn, area, params);
    let is_drawn = |at: MmPoint| near.nearest(at, STANDS, |_| true).is_some();
    let gap = |line: &&Polyline<Vertex>| {
        let drawn: Vec<bool> = line.vertices.iter().map(|vertex| is_drawn(vertex.at)).collect();
        // from a place on that is drawn
        let start = drawn.iter().position(|is_drawn| *is_drawn)?;
        let count = drawn.len();
        let places: Vec<(bool, MmPoint)> =
            (0..count).map(|i| (start + i) % count).map(|i| (drawn[i], line.vertices[i].at)).collect();
        let runs = places.chunk_by(|a, b| a.0 == b.0).filter(|run| !run[0].0);
        let length =
            |run: &[(bool, MmPoint)]| -> f32 { run.windows(2).map(|pair| (pair[1].1 - pair[0].1).length()).sum() };
        let (length, run) = runs.map(|run| (length(run), run)).max_by(|a, b| a.0.total_cmp(&b.0))?;
        let extent = MmRect::from_points(run.iter().map(|(_, at)| *at));
        let lost = LostLine { extent, length: length + 2.0 * STANDS, closed: true, is_faint: false, form: None };
        let share = drawn.iter().filter(|is_drawn| **is_drawn).count() as f32 / count as f32;
        (lost.length > GAP && share >= GONE && !is_faint(line)).then_some(lost)
    };
    let open = lines.iter().zip(are_closed).filter(|(line, is_closed)| line.closed && !is_closed);
    open.filter_map(|(line, _)| gap(line)).collect()
}

/// Which of these lines are closed on the page, if also moved aside in part, as the tip of a triangle below a beam: a
/// closed line of `drawn` lies nearer to each than to all others, for half at least of the longer one of the two.
fn closed_on_page<'a>(
    lines: &[&Polyline<Vertex>],
    drawn: impl Iterator<Item = &'a Polyline<Vertex>>,
    area: MmRect,
    params: &Params,
) -> Vec<bool> {
    let near = nearby(lines.iter().copied(), area, params);
    let mut are_closed = vec![false; lines.len()];
    for ring in drawn.filter(|line| line.closed) {
        let mut beside: BTreeMap<usize, f32> = BTreeMap::new();
        for (a, b) in ring.segments() {
            // long sides have vertices between their corners
            if let Some((_, _, segment)) = near.nearest(a.at.lerp(b.at, 0.5), params.farthest_moved(), |_| true) {
                *beside.entry(segment.line as usize).or_default() += (b.at - a.at).length();
            }
        }
        if let Some((line, length)) = beside.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)) {
            are_closed[line] |= length >= SAME_RING * ring.length().max(lines[line].length());
        }
    }
    are_closed
}

/// A closed line is another one on the page if it is so for at least this share of the longer of the two.
const SAME_RING: f32 = 0.5;

/// Two strokes are a cross if they come so near to one another, mm: one may be cut off where they meet.
const MEET: f32 = 1.2;

/// Whether two straight strokes between these ends are a cross: they cross or meet at 45 degrees or more.
pub(crate) fn is_cross([a, b]: [MmPoint; 2], [c, d]: [MmPoint; 2]) -> bool {
    let (one, other) = (b - a, d - c);
    let (across, longest) = (one.cross(other).abs(), one.length() * other.length());
    longest > 0.0 && across >= FRAC_1_SQRT_2 * longest && segment_distance((a, b), (c, d)) <= MEET
}

/// The ends of a line; none of one without points.
fn ends(line: &Polyline<Vertex>) -> Option<[MmPoint; 2]> {
    Some([line.vertices.first()?.at, line.vertices.last()?.at])
}

/// A straight line with this box around it is one of these two.
fn diagonals(extent: MmRect) -> [[MmPoint; 2]; 2] {
    let (min, max) = (extent.min, extent.max);
    [[min, max], [MmPoint::new(min.x, max.y), MmPoint::new(max.x, min.y)]]
}

/// A line stands for a closed one if it is so near, mm: nearly all are moved by less, and those side by side are
/// further apart.
pub(super) const STANDS: f32 = 2.0;

/// A scale of which ticks are not drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LostScale {
    /// How many ticks it has.
    pub ticks: usize,
    /// How many of them are not drawn.
    pub lost: usize,
    /// Every how many-th there is room for.
    pub every: usize,
    /// Where the first is that is not drawn.
    pub first: MmPoint,
}

/// Marks of a drawing that are too short for a line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LostMarks {
    /// Ticks: straight ones on a line.
    pub ticks: usize,
    /// Arcs between two lines.
    pub arcs: usize,
    /// Corners between two lines, which mark right angles.
    pub corners: usize,
    /// Pieces of small rings, such as the hub of a clock's hands.
    pub pieces: usize,
    /// Other strokes, such as the rays of a sun.
    pub strokes: usize,
    /// Length of all, mm.
    pub length: f32,
    /// Where the first of them is.
    pub first: Option<MmPoint>,
}

/// A small shape that is not drawn, such as a town on a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LostSign {
    /// Its middle.
    pub at: MmPoint,
    /// What it is.
    pub kind: SignKind,
}

/// Which kind of a small shape is lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignKind {
    /// A small ring.
    Ring,
    /// One of many small shapes that are alike, as the triangles of a scatter plot, of which none is drawn.
    Series,
    /// The head of an arrow.
    Arrowhead,
    /// One of a cloud of points.
    Point,
}

impl Lost {
    /// Share of what is not drawn, 0..=1.
    pub fn share(&self) -> f32 {
        if self.wanted > 0.0 { (self.lost / self.wanted).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Where most of it is, in words; none if less than half of it is in any place.
    pub fn place_name(&self) -> Option<&'static str> {
        most_of(self.by_place).map(|ninth| NAMES[ninth])
    }

    /// There were to be few shapes of a photograph: that most contours have no line is not for want of room.
    pub fn lack_on_purpose(&mut self) {
        (self.lost, self.by_place, self.of_gridlines) = (0.0, [0.0; 9], [0.0; 9]);
    }

    /// A squared grid of so many lines, of which this length was drawn, is left out as a whole, and told as such: what
    /// its lines lacked before is no loss of others.
    pub fn without_gridlines(&mut self, lines: usize, length: f32) {
        self.gridlines = lines + self.gone.iter().filter(|line| line.is_faint).count();
        self.gone.retain(|line| !line.is_faint);
        let lacked = self.of_gridlines.iter().sum::<f32>();
        self.by_place.iter_mut().zip(self.of_gridlines).for_each(|(of, lacked)| *of -= lacked);
        self.lost = (self.lost - lacked).max(0.0);
        self.wanted = (self.wanted - lacked - length).max(self.lost);
        self.of_gridlines = [0.0; 9];
    }

    /// Adds lines that were to be drawn, and are not after all.
    pub(super) fn add<'a>(&mut self, lines: impl IntoIterator<Item = &'a Polyline<Vertex>>, area: MmRect) {
        let mut more = LossTally::new(area);
        lines.into_iter().for_each(|line| more.add_where(line, |_| true));
        self.lost += more.length();
        self.by_place.iter_mut().zip(more.lengths).for_each(|(of, more)| *of += more);
    }

    /// Adds lines of a drawing that lie in a hollow point, where nothing is drawn, each with the middle of that. Two
    /// that cross are the strokes of a cross, as in the sign of a lamp, also if one of them is gone already; others are
    /// ticks behind their point, which nobody misses.
    pub(super) fn add_crosses(&mut self, hidden: &[(MmPoint, &Polyline<Vertex>)], area: MmRect, params: &Params) {
        if !params.of_drawing || params.part != PagePart::Figure {
            return;
        }
        let is_crossed = |at: MmPoint, line: &Polyline<Vertex>| {
            let Some(stroke) = ends(line) else { return false };
            let crosses = |other: [MmPoint; 2]| is_cross(stroke, other);
            let is_here = |line: &&LostLine| !line.closed && (line.extent.center() - at).length() <= STANDS;
            let beside = hidden.iter().filter(|(of, _)| *of == at).filter_map(|(_, other)| ends(other));
            self.gone.iter().filter(is_here).flat_map(|line| diagonals(line.extent)).chain(beside).any(crosses)
        };
        let of_crosses = hidden.iter().filter(|(at, line)| is_crossed(*at, line)).map(|(_, line)| *line);
        let of_crosses: Vec<&Polyline<Vertex>> = of_crosses.collect();
        self.add(of_crosses.iter().copied(), area);
        self.gone.extend(of_crosses.into_iter().map(LostLine::of));
    }

    /// The same if of what is drawn only a share is kept after all.
    #[must_use]
    pub fn keeping(self, share: f32) -> Self {
        let lost = self.wanted - (self.wanted - self.lost) * share;
        let (more, parts) = (lost - self.lost, self.by_place);
        // where what is dropped now would have been is not known: as what was dropped before
        let part = |of: f32| if self.lost > 0.0 { of / self.lost } else { 1.0 / 9.0 };
        Self { lost, by_place: parts.map(|of| of + more * part(of)), ..self }
    }
}

/// Lengths of lines in the nine parts of a figure.
#[derive(Debug, Clone, Copy)]
pub(super) struct LossTally {
    area: MmRect,
    lengths: [f32; 9],
    of_gridlines: [f32; 9],
    rings: usize,
}

impl LossTally {
    pub(super) fn new(area: MmRect) -> Self {
        Self { area, lengths: [0.0; 9], of_gridlines: [0.0; 9], rings: 0 }
    }

    /// Adds the length of a line.
    pub(super) fn add(&mut self, line: &Polyline<Vertex>) {
        self.rings += usize::from(line.closed);
        self.add_where(line, |_| true);
    }

    /// Length of all, mm.
    pub(super) fn length(&self) -> f32 {
        self.lengths.iter().sum()
    }

    /// Counts the rings among lines.
    pub(super) fn count_rings<'a>(&mut self, lines: impl Iterator<Item = &'a Polyline<Vertex>>) {
        self.rings += lines.filter(|line| line.closed).count();
    }

    /// Adds the length of those parts of a line for which `counts` is true.
    pub(super) fn add_where(&mut self, line: &Polyline<Vertex>, counts: impl Fn(MmPoint) -> bool) {
        let is_faint = is_faint(line);
        for (a, b) in line.segments() {
            let (middle, step) = (a.at.lerp(b.at, 0.5), b.at - a.at);
            if counts(middle) {
                let place = ninth(middle, self.area);
                self.lengths[place] += step.length();
                if is_faint && step.x.abs().min(step.y.abs()) <= LEVEL * step.length() {
                    self.of_gridlines[place] += step.length();
                }
            }
        }
    }

    /// What of this is not in `kept`.
    pub(super) fn lost(&self, kept: &Self) -> Lost {
        let by_place: [f32; 9] = std::array::from_fn(|i| self.lengths[i] - kept.lengths[i]);
        let of_gridlines: [f32; 9] = std::array::from_fn(|i| self.of_gridlines[i] - kept.of_gridlines[i]);
        let kept_rings = kept.rings;
        let (wanted, kept) = (self.length(), kept.length());
        let rings = self.rings.saturating_sub(kept_rings);
        Lost { wanted, lost: (wanted - kept).max(0.0), by_place, of_gridlines, rings, ..Lost::default() }
    }
}

#[cfg(test)]
mod tests;
