//! Short lines that lead from shape to shape in the figure of a drawing, such as arrows between boxes, and that its
//! overview lacks: without them nobody feels there what belongs together.

use super::lost_signs::MOVED;
use super::overview::DrawnOverview;
use crate::edges::Edges;
use crate::geom::ALONG;
use crate::geom::nearby::{Nearby, Segment};
use crate::lines::{Line, which_are_weak};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason};

/// Such a line ends no farther from another than this, mm: on dots a step or so before it. The head of an arrow, at
/// which its shaft ends, is another line.
const ENDS_AT: f32 = 2.5;
/// Its chord is at least this share of its length.
const STRAIGHT: f32 = 0.95;

/// What the maker of a drawing's page is told of them.
pub(super) fn told(
    edges: &Edges,
    figure: &[Line],
    overview: &DrawnOverview,
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let (place, lines) = overview.marks.as_ref().filter(|_| edges.of_drawing())?;
    let params = plan.lines();
    let count = lacking(figure, layout.figure, lines, *place, (params.min_length, params.least_strength));
    let (noun, they_have) = if count == 1 { ("line", "it has") } else { ("lines", "they have") };
    let told = format!(
        "{count} short {noun} between shapes of the figure in the overview: {they_have} no room there, or would be too \
         short; do without the overview"
    );
    (count > 0).then_some(Note::NotOnPage(About::Overview, Reason::NoRoomInOverview, told.into()))
}

/// How many lines lead from line to line in a figure, would be shorter than `min_length`, mm, in the overview and are
/// not there. Gridlines, with about the least strength, are told by themselves.
fn lacking(
    figure: &[Line],
    from: MmRect,
    overview: &[Line],
    to: MmRect,
    (min_length, least_strength): (f32, f32),
) -> usize {
    let (of_figure, of_overview) = (index(figure, from), index(overview, to));
    let (scale, weak) = (to.width() / from.width(), which_are_weak(figure, least_strength));
    let is_lacking = |&number: &usize| {
        let line = &figure[number];
        let Some([first, last]) = ends(line).filter(|_| !weak[number]) else { return false };
        let length: f32 = line.own_runs().iter().map(|run| run.length()).sum();
        let chord = last - first;
        let is_short = chord.length() >= STRAIGHT * length && scale * length < min_length;
        let is_at_other =
            |end: MmPoint| of_figure.nearest(end, ENDS_AT, |segment| segment.line as usize != number).is_some();
        let Some(way) = chord.try_normalize().filter(|_| is_short && is_at_other(first) && is_at_other(last)) else {
            return false;
        };
        let middle = to.min + (first.lerp(last, 0.5) - from.min) * scale;
        let is_along =
            |segment: &Segment| way.dot((segment.b - segment.a).try_normalize().unwrap_or_default()).abs() >= ALONG;
        of_overview.nearest(middle, MOVED, is_along).is_none()
    };
    (0..figure.len()).filter(is_lacking).count()
}

/// Lines in a part of the page, by their places.
fn index(lines: &[Line], part: MmRect) -> Nearby {
    let mut index = Nearby::new(part, MOVED);
    for (number, line) in (0..).zip(lines) {
        line.own_runs().iter().for_each(|run| index.insert_line(number, run.polyline(), 0.0));
    }
    index
}

/// The two ends of a line.
fn ends(line: &Line) -> Option<[MmPoint; 2]> {
    let (first, last) = (line.own_runs().first()?, line.own_runs().last()?);
    Some([first.path().next()?, last.path().last()?])
}

#[cfg(test)]
mod tests;
