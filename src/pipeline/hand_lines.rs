//! Lines of a page as contours of a picture: those that a person gives, and those of a page that is laid out anew.

mod line;
mod thickness;

use std::collections::HashSet;

use super::cut_contours::{index_of_edges, parts_beside, points_taken_out, take_out_along};
use super::kept_lines::LineName;
use crate::edges::{ChainKind, Edgel, Edges};
use crate::geom::polyline::Polyline;
use crate::lines::{Line, Run};
use crate::listing::first_few;
use crate::page::{Page, PartShown};
use crate::profile::Plan;
use crate::reading::DrawnArea;
use crate::units::{MmPoint, MmRect, MmVector, PageTransform, PxPoint, Size};
use crate::{About, Error, Note, Reason};
use line::HandLine;

pub(super) use thickness::weaken_thin_strokes;

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
    /// Width, mm, and number of lines of the overview on their page, if it has one.
    overview: Option<(f32, usize)>,
}

/// Most lines that are named.
const MOST_NAMED: usize = 5;
/// Longest lines together, in longest sides of the figure: one of 174 mm has room for 22. A path of a million corners
/// has half a million sides, of which each step would take minutes and 14 GB.
const MOST_SIDES: f32 = 2000.0;
/// Contours of the lines of a page, and of lines that a person adds to those of a picture.
const OF_PAGE: ChainKind =
    ChainKind { exact: true, of_drawing: true, stroke: None, faint: false, added: false, head: false, sign: None };
const ADDED: ChainKind = ChainKind { of_drawing: false, added: true, ..OF_PAGE };
/// How far two shapes of a picture may differ, as a share of width by height: figures are rounded to pixels.
pub(super) const SAME_SHAPE: f32 = 0.03;

impl HandLines {
    /// The lines of a page's figure, with the strengths that their widths stand for. `plan` says which those are.
    ///
    /// # Errors
    /// If they are longer than can be drawn in some seconds.
    pub fn of_figure(page: &Page, plan: &Plan) -> Result<Self, Error> {
        let overview = page.overview.as_ref().map(|overview| (overview.place.width(), overview.lines.len()));
        let lines = Self::of(&page.figure.lines, page.figure.place, plan);
        lines.check_length()?;
        Ok(Self { part: PartShown::of(page), overview, ..lines })
    }

    fn check_length(&self) -> Result<(), Error> {
        // of a figure whose longest side is 1
        let size = [self.aspect.min(1.0), self.aspect.recip().min(1.0)];
        let sides = self.lines.iter().map(|line| line.length(size)).sum::<f32>();
        let why = || {
            format!(
                "its lines are {sides:.0} times as long as the longest side of its figure, and more than {MOST_SIDES} \
                 are not drawn"
            )
        };
        if sides > MOST_SIDES { Err(Error::too_complex("page", why())) } else { Ok(()) }
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

    /// Strokes come first, and after them the marks on all lines; each is cut where it leaves the figure.
    fn of(lines: &[Line], place: MmRect, plan: &Plan) -> Self {
        let size = [place.width(), place.height()].map(|side| side.max(f32::MIN_POSITIVE));
        let share = |at: MmPoint| [(at.x - place.min.x) / size[0], (at.y - place.min.y) / size[1]];
        let numbered = || lines.iter().enumerate();
        let strokes = numbered().flat_map(|(number, line)| HandLine::strokes_of(line, number, share, plan));
        let marks = numbered().flat_map(|(number, line)| HandLine::marks_of(line, number, share, plan));
        let (mut inside, mut left_outside) = (Vec::new(), Vec::new());
        for line in strokes.chain(marks) {
            let (of_line, length) = (line.of_line, line.length(size));
            let parts = line.parts_inside(size);
            let outside = length - parts.iter().map(|part| part.length(size)).sum::<f32>();
            left_outside.extend((outside > 0.0).then_some((of_line, outside)));
            inside.extend(parts);
        }
        let aspect = size[0] / size[1];
        let (areas, names) = (Vec::new(), Vec::new());
        Self { lines: inside, aspect, part: None, left_outside, areas, names, overview: None }
    }

    /// The same lines as contours of a picture of this size, those that a person drew as such.
    ///
    /// # Errors
    /// If the picture has another shape than the figure of the page.
    pub(super) fn contours(&self, size: Size) -> Result<Edges, Error> {
        self.contours_of(self.lines.iter(), size, OF_PAGE)
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

    /// The same. Those that a person drew go before others: these are cut where they run along them within `reach` px,
    /// and end `gap` px before those that they only meet, a gap that is closed when lines are drawn.
    /// Those of a person are all of full strength, however thin they are: they are meant.
    ///
    /// # Errors
    /// As [`HandLines::contours`].
    pub(super) fn contours_by_hand_first(
        &self,
        size: Size,
        [reach, gap]: [f32; 2],
        full_strength: f32,
    ) -> Result<Edges, Error> {
        let (by_hand, others): (Vec<&HandLine>, Vec<&HandLine>) =
            self.lines.iter().partition(|line| self.is_by_hand(line));
        let mut first = self.contours_of(by_hand.into_iter(), size, OF_PAGE)?;
        first.edgels.iter_mut().for_each(|edgel| edgel.strength = edgel.strength.max(full_strength));
        let found = self.contours_of(others.into_iter(), size, OF_PAGE)?;
        if first.is_empty() {
            return Ok(found);
        }
        let near = index_of_edges(&first);
        let mut edges = Edges::none(size);
        for range in &found.chains {
            let polyline = found.chain(range);
            let whole = Polyline { vertices: polyline.vertices.to_vec(), closed: range.closed };
            for (vertices, closed) in parts_beside(whole, &near, [reach, gap]) {
                edges.push_as(range.kind, vertices.into_iter(), closed);
            }
        }
        for range in &first.chains {
            edges.push_as(range.kind, first.chain(range).vertices.iter().copied(), range.closed);
        }
        Ok(edges)
    }

    /// Adds the lines to contours that were found, of which the parts that run along them, nearer than `reach`, px,
    /// give way; what did, as shares of the width and height of the picture.
    ///
    /// # Errors
    /// As [`HandLines::contours`].
    pub(super) fn add_to(&self, found: &mut Edges, reach: f32) -> Result<Vec<[f32; 2]>, Error> {
        let own = self.contours_of(self.lines.iter(), found.size, ADDED)?;
        let (near, [width, height]) = (index_of_edges(&own), [found.size.width as f32, found.size.height as f32]);
        let gave_way =
            points_taken_out(found, &near, reach).into_iter().map(|at| [at.x / width, at.y / height]).collect();
        take_out_along(found, &near, reach);
        for range in &own.chains {
            found.push_as(range.kind, own.chain(range).vertices.iter().copied(), range.closed);
        }
        Ok(gave_way)
    }

    /// What is told of lines outside of the figure: there is no picture there that they could belong to.
    pub fn told_outside(&self) -> Option<Note> {
        let mm = self.left_outside.iter().map(|(_, mm)| mm).sum::<f32>().round();
        let named = self.left_outside.iter().filter(|(_, mm)| *mm >= 0.5).filter_map(|(line, _)| self.names.get(*line));
        let mut named: Vec<&str> = named.map(|line| line.name.as_str()).collect();
        let mut known = HashSet::new();
        named.retain(|name| known.insert(*name));
        let names = if named.is_empty() {
            String::new()
        } else {
            format!(" ({})", first_few(&named, MOST_NAMED, |name| (*name).to_owned()))
        };
        let told =
            format!("{mm} mm of lines outside of the figure{names}; move them into it, or make another page of them");
        (mm >= 1.0).then_some(Note::NotOnPage(About::Lines, Reason::OutsideFigure, told.into()))
    }

    /// What is told of the overview that is made of the lines, here and of so many lines, where that of their page is
    /// another one: it is drawn of all lines of the figure, and that of a photograph of its regions.
    pub(super) fn told_overview_anew(&self, place: MmRect, lines: usize) -> Option<Note> {
        let (width, before) = self.overview?;
        let counted = |lines: usize| if lines == 1 { "1 line".to_owned() } else { format!("{lines} lines") };
        let told = format!(
            "the overview is made anew of the lines that are given, and is {:.0} mm wide with {}; that of their page \
             is {width:.0} mm wide with {}: look whether it is what you want, and change it in the page that is made",
            place.width(),
            counted(lines),
            counted(before)
        );
        let is_another = before != lines || (place.width() - width).abs() >= 1.0;
        is_another.then_some(Note::TakenAs(About::Overview, Reason::OverviewOfLines, told.into()))
    }

    /// The lines that are shorter than a length in the figure, as shares of its width: what each is called, as far as
    /// that is known, and where it begins, in shares of the figure.
    pub(super) fn shorter_than(&self, share: f32) -> impl Iterator<Item = (Option<&str>, [f32; 2])> {
        let size = [1.0, 1.0 / self.aspect];
        let short = self.lines.iter().filter(move |line| !line.is_disc && line.length(size) < share);
        let name = |line: &HandLine| self.names.get(line.of_line).map(|name| name.name.as_str());
        short.filter_map(move |line| Some((name(line), line.vertices.first()?.0)))
    }

    /// Some of the lines as contours of this kind; those that a person drew are added ones.
    fn contours_of<'a>(
        &self,
        lines: impl Iterator<Item = &'a HandLine>,
        size: Size,
        kind: ChainKind,
    ) -> Result<Edges, Error> {
        let [width, height] = [size.width as f32, size.height as f32];
        if (self.aspect / (width / height) - 1.0).abs() > SAME_SHAPE + 1.0 / width.min(height) {
            return Err(Error::OtherShape { lines: self.aspect, picture: width / height });
        }
        let mut edges = Edges::none(size);
        for line in lines.filter(|line| line.vertices.len() > 1) {
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

/// Whether there are contours that a person drew or added.
pub(super) fn has_added(edges: &Edges) -> bool {
    edges.chains.iter().any(|range| range.kind.added)
}

/// The contours that a person drew or added.
pub(super) fn added(edges: &Edges) -> Edges {
    let mut own = Edges::none(edges.size);
    for range in edges.chains.iter().filter(|range| range.kind.added) {
        own.push_as(range.kind, edges.chain(range).vertices.iter().copied(), range.closed);
    }
    own
}

#[cfg(test)]
mod tests;
