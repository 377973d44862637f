//! Whether the overview of a photograph has the outline of what comes first in the figure: it has a choice of its own
//! among the regions, and an outline may be in pieces there, of which others took the room.

use super::decisions::Decisions;
use super::lines_of_part::LinesOfPart;
use super::overview::DrawnOverview;
use crate::edges::Edges;
use crate::lines::Line;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{Chosen, Mask};
use crate::units::{MmRect, PageTransform, PxPoint, Size};
use crate::{About, Note, Reason};

/// A region that has no more of its outline on the edge of the picture is a thing: others are ground.
const ON_PICTURE_EDGE: f32 = 0.1;
/// The figure outlines a thing if lines run along this share of its border: thin arms of it have none.
const OUTLINED: f32 = 0.6;
/// The overview has a thing if it has this share of that outline. Of the largest closed lines of the figures of 30
/// photographs, four have less there, and six have between this and 0.8.
const THERE: f32 = 0.6;
/// A line of the overview is that of an outline up to this far from it, mm: one that is there lies nearer nearly all
/// along, and one of something else seldom.
const ALONG: f32 = 1.5;

/// What the maker is told of the first region of a figure if the overview lacks most of its outline. Subjects that
/// were named, and pages of few shapes, are told otherwise.
pub(super) fn told(
    edges: &Edges,
    (regions, decisions): (Option<&Chosen>, &Decisions),
    figure: &[Line],
    overview: &DrawnOverview,
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let is_told_otherwise = plan.lines().most_shapes.is_some() || !decisions.found.is_empty();
    let (tree, overview) = edges.regions.as_ref().zip(overview.marks.as_ref()).filter(|_| !is_told_otherwise)?;
    let first = regions?.regions.first()?;
    let thing = tree.mask(&[*first]);
    if thing.on_picture_edge() > ON_PICTURE_EDGE {
        return None;
    }
    told_of(&thing, edges.size, figure, overview, layout, plan)
}

/// The same of a thing in a picture of this size.
fn told_of(
    thing: &Mask,
    picture: Size,
    figure: &[Line],
    (place, lines): &(MmRect, Vec<Line>),
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let (in_figure, in_overview) = (PageTransform::new(picture, layout.figure), PageTransform::new(picture, *place));
    let (of_figure, border) = (LinesOfPart::of(figure, layout.figure, layout, plan), thing.border());
    let outline: Vec<PxPoint> = border.iter().copied().filter(|at| of_figure.has(in_figure.to_mm(*at))).collect();
    if outline.is_empty() || (outline.len() as f32) < OUTLINED * border.len() as f32 {
        return None;
    }
    let of_overview = LinesOfPart::within(lines, *place, ALONG.max(layout.medium.pitch()));
    let there = of_overview.share(outline.iter().map(|at| in_overview.to_mm(*at)));
    if there >= THERE {
        return None;
    }
    let at = thing.inside()?;
    let [across, down] = [at.x / picture.width as f32, at.y / picture.height as f32].map(|share| 100.0 * share);
    let share = if there < 0.005 { "nothing".to_owned() } else { format!("{:.0} percent", 100.0 * there) };
    let what = format!(
        "much of the outline of the thing at {across:.0}%,{down:.0}%, which comes first in the figure, in the \
         overview: {share} of it is there, as other shapes come first there; name this place as the subject if \
         the picture is about it, or ask for few shapes (lines.shapes = 5), which are the same in both"
    );
    Some(Note::NotOnPage(About::Overview, Reason::FirstNotInOverview, what))
}

#[cfg(test)]
mod tests;
