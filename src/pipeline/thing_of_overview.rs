//! Whether the overview of a photograph has the outlines of what comes first in the figure, and of other large things
//! there: it has a choice of its own among the regions, and an outline may be in pieces there, of which others took the
//! room.

use super::decisions::Decisions;
use super::lines_of_part::LinesOfPart;
use super::overview::DrawnOverview;
use crate::edges::Edges;
use crate::lines::Line;
use crate::page::layout::Layout;
use crate::page::sheet_windows::place_from_edges;
use crate::profile::Plan;
use crate::regions::{Chosen, Mask};
use crate::units::{MmPoint, MmRect, PageTransform, PxPoint, Size};
use crate::{About, Note, Reason};

/// A region that has no more of its outline on the edge of the picture is a thing: others are ground.
const ON_PICTURE_EDGE: f32 = 0.1;
/// Of other things, such as another person, only large ones are told: of this share of the picture or more, and with no
/// more of their outline on its edge, where people are cut off. Chosen by us.
const LARGE: f64 = 0.03;
const CUT_OFF: f64 = 0.25;
/// The figure outlines a thing if lines run along this share of its border: thin arms of it have none.
const OUTLINED: f32 = 0.6;
/// The overview has a thing if it has this share of that outline. Of the largest closed lines of the figures of 30
/// photographs, four have less there, and six have between this and 0.8.
const THERE: f32 = 0.6;
/// A line of the overview is that of an outline up to this far from it, mm: one that is there lies nearer nearly all
/// along, and one of something else seldom.
const ALONG: f32 = 1.5;

/// What the maker is told of the first region of a figure if the overview lacks most of its outline, and of large ones.
/// Subjects that were named, and pages of few shapes, are told otherwise.
pub(super) fn told(
    edges: &Edges,
    (regions, decisions): (Option<&Chosen>, &Decisions),
    figure: &[Line],
    overview: &DrawnOverview,
    layout: &Layout,
    plan: &Plan,
) -> impl Iterator<Item = Note> {
    let is_told_otherwise = plan.lines().most_shapes.is_some() || !decisions.found.is_empty();
    let parts = edges.regions.as_ref().zip(overview.marks.as_ref()).filter(|_| !is_told_otherwise);
    let parts = parts.zip(regions.and_then(|regions| regions.regions.split_first()));
    let told = parts.map(|((tree, marks), (&first, others))| {
        let outlines = BothOutlines::of(edges.size, figure, marks, layout, plan);
        let thing = tree.mask(&[first]);
        let first = if thing.on_picture_edge() > ON_PICTURE_EDGE { None } else { outlines.lacking(&thing) };
        let is_large = |&&other: &&u32| tree.is_thing(other, [LARGE, CUT_OFF]);
        let others = others.iter().filter(is_large).filter_map(|&other| outlines.lacking(&tree.mask(&[other])));
        (first, others.collect::<Vec<_>>())
    });
    let (first, others) = told.unwrap_or_default();
    first.map(told_of_first).into_iter().chain(told_of_others(&others, layout))
}

/// A thing of the figure of whose outline the overview lacks much.
#[derive(Debug, Clone, Copy)]
struct Lacking {
    /// A place in it, percent of the picture from its left and its top.
    at: [f32; 2],
    /// A place on the page where the figure has what the overview lacks of its outline.
    lacks: MmPoint,
    /// The share of the outline that is there.
    share: f32,
}

impl Lacking {
    /// Its place, as the place of a subject is given.
    fn place(&self) -> String {
        let [across, down] = self.at;
        format!("{across:.0}%,{down:.0}%")
    }
}

/// The lines of a figure and of its overview, along which outlines of things of a picture may run.
struct BothOutlines {
    picture: Size,
    figure: (LinesOfPart, PageTransform),
    overview: (LinesOfPart, PageTransform),
}

impl BothOutlines {
    /// Those of a picture of this size.
    fn of(picture: Size, figure: &[Line], (place, lines): &(MmRect, Vec<Line>), layout: &Layout, plan: &Plan) -> Self {
        let of_overview = LinesOfPart::within(lines, *place, ALONG.max(layout.medium.pitch()));
        Self {
            picture,
            figure: (LinesOfPart::of(figure, layout.figure, layout, plan), PageTransform::new(picture, layout.figure)),
            overview: (of_overview, PageTransform::new(picture, *place)),
        }
    }

    /// A thing, if the figure outlines it and the overview does not.
    fn lacking(&self, thing: &Mask) -> Option<Lacking> {
        let ((of_figure, in_figure), (of_overview, in_overview)) = (&self.figure, &self.overview);
        let border = thing.border();
        let outline: Vec<PxPoint> = border.iter().copied().filter(|at| of_figure.has(in_figure.to_mm(*at))).collect();
        if outline.is_empty() || (outline.len() as f32) < OUTLINED * border.len() as f32 {
            return None;
        }
        let share = of_overview.share(outline.iter().map(|at| in_overview.to_mm(*at)));
        if share >= THERE {
            return None;
        }
        // in the middle of what is missing, row by row
        let missing = outline.iter().filter(|at| !of_overview.has(in_overview.to_mm(**at)));
        let missing: Vec<&PxPoint> = missing.collect();
        let lacks = in_figure.to_mm(**missing.get(missing.len() / 2)?);
        let at = thing.inside()?;
        let at = [at.x / self.picture.width as f32, at.y / self.picture.height as f32].map(|share| 100.0 * share);
        Some(Lacking { at, lacks, share })
    }
}

/// What is told of the thing that comes first.
fn told_of_first(first: Lacking) -> Note {
    let share = if first.share < 0.005 { "nothing".to_owned() } else { format!("{:.0} percent", 100.0 * first.share) };
    let what = format!(
        "much of the outline of the thing at {}, which comes first in the figure, in the overview: {share} of it is \
         there, as other shapes come first there; name this place as the subject if the picture is about it, or ask \
         for few shapes (lines.shapes = 5), which are the same in both",
        first.place()
    );
    Note::NotOnPage(About::Overview, Reason::FirstNotInOverview, what.into())
}

/// What is told of others, the first of the figure first. As its subject a place in one may name something else, which
/// counts more there, so that it is told where the figure has what is missing.
fn told_of_others(others: &[Lacking], layout: &Layout) -> Option<Note> {
    let (outlines, about) = match others.len() {
        0 => return None,
        1 => ("outline of a large thing".to_owned(), "it"),
        count => (format!("outlines of {count} large things"), "one of them"),
    };
    let at = place_from_edges(others.first()?.lacks, layout.sheets.as_ref(), layout.medium.name_of_sheet());
    let what = format!(
        "in the overview, much of the {outlines} of the figure, such as the piece around {at}: other shapes come first \
         there; if the picture is about {about}, name a place on it as the subject, or ask for few shapes \
         (lines.shapes = 5), which are the same in both"
    );
    Some(Note::NotOnPage(About::Overview, Reason::ThingNotInOverview, what.into()))
}

#[cfg(test)]
mod tests;
