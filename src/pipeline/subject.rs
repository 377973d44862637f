//! What the picture is about, as its maker says by places on it.

use lyon::geom::euclid::Box2D;

use super::cut_contours::take_out;
use super::decisions::Decisions;
use super::given::{Given, blank_where};
use super::lines_of_part::LinesOfPart;
use super::named::NamedThings;
use crate::classes::Classes;
use crate::edges::{Edgel, Edges};
use crate::geom::polyline::Located;
use crate::lines::{Line, PagePart};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{Mask, RegionGrid};
use crate::units::{MmRect, PageTransform, PxPoint, Size};
use crate::{About, Note, Reason};

/// Most places that are looked at, each in all regions: the program takes fewer (`--subject`).
const MOST: usize = 100;
/// A ring around the subject has at least this area, mm2: smaller ones are dots for a finger.
const LEAST_AREA: f32 = 15.0;
/// Lines this near to the subject belong to it, cells: its own contours run along its border.
const MARGIN: f32 = 3.0;
/// An outline is there if lines run along this share of the border of its region: they cut its thin arms off and go
/// around no holes.
const DRAWN: f32 = 0.4;

/// Finds the subjects among regions, or within closed contours, and writes them into the decisions; where a calm
/// background is asked for, takes what is not of them out of the contours.
pub(super) fn prepare(
    given: &Given,
    things: Option<&NamedThings>,
    edges: &mut Edges,
    decisions: &mut Decisions,
    source: Size,
    layout: &Layout,
    plan: &Plan,
) -> Vec<Note> {
    let (mut all, mut notes) = (None::<Mask>, Vec::new());
    let mm_per_px = PageTransform::new(edges.size, layout.figure).mm_per_px();
    let beyond = given.subjects.len().saturating_sub(MOST);
    if beyond > 0 {
        let told = format!("{beyond} of the subjects, as {MOST} are the most");
        notes.push(Note::NotOnPage(About::Lines, Reason::TooManySubjects, told));
    }
    for [x, y] in given.subjects.iter().take(MOST) {
        let share = [x.share(source.width), y.share(source.height)];
        let percent = share.map(|share| (100.0 * share).round() as i32);
        let found = subject_at(edges, share, mm_per_px, things).and_then(|(mask, region)| {
            let [least, greatest] = mask.extent()?;
            let side = (greatest - least) * mm_per_px;
            Some((mask, [side.x, side.y].map(|side| side.round() as u32), region))
        });
        match found {
            Some((mask, mm, region)) => {
                all = Some(all.map_or(mask.clone(), |all| all.united(&mask)));
                if let Some(region) = region.filter(|region| !decisions.subjects.contains(region)) {
                    decisions.subjects.push(region);
                    decisions.borders.push(mask.border());
                }
                notes.push(Note::Subject { at: percent, mm, is_first: region.is_some() });
            }
            None => notes.push(Note::NoSubject(percent)),
        }
    }
    decisions.calmed_around = all.filter(|_| given.calm_background);
    if let Some(subject) = &decisions.calmed_around {
        // lines that a person gave are all meant
        let calmed = if given.lines.is_none() { calm(edges, subject, layout, plan) } else { 0.0 };
        notes.push(Note::BackgroundCalmed(calmed.round() as u32));
    }
    notes
}

/// What the maker is told of subjects whose outlines are not among the lines of the figure, or of the overview that
/// lies in a place, or only pieces of them; `picture` is the size of the picture.
pub(super) fn told_lacking(
    decisions: &Decisions,
    picture: Size,
    figure: &[Line],
    overview: Option<&(MmRect, Vec<Line>)>,
    layout: &Layout,
    plan: &Plan,
) -> impl Iterator<Item = Note> {
    let lacking =
        |lines: &[Line], place: MmRect, part: PagePart| lacking(decisions, lines, picture, place, layout, plan, part);
    let has_lines = plan.profile().figure.lines;
    let of_figure = has_lines.then(|| lacking(figure, layout.figure, PagePart::Figure)).flatten();
    of_figure.into_iter().chain(overview.and_then(|(place, lines)| lacking(lines, *place, PagePart::Overview)))
}

/// The same of one part of the page, in which the picture lies at `place`.
fn lacking(
    decisions: &Decisions,
    lines: &[Line],
    picture: Size,
    place: MmRect,
    layout: &Layout,
    plan: &Plan,
    part: PagePart,
) -> Option<Note> {
    if decisions.borders.is_empty() {
        return None;
    }
    let (at, drawn) = (PageTransform::new(picture, place), LinesOfPart::of(lines, place, layout, plan));
    let is_drawn = |border: &&Vec<PxPoint>| drawn.share(border.iter().map(|point| at.to_mm(*point))) >= DRAWN;
    let lacking = decisions.borders.iter().filter(|border| !is_drawn(border)).count();
    let (about, part, what_to_do) = match part {
        PagePart::Overview => (About::Overview, "overview", "crop the picture around it"),
        PagePart::Figure => (About::Lines, "figure", "make the figure larger, or crop the picture around it"),
    };
    let subjects = match lacking {
        0 => return None,
        1 => "the outline of the subject".to_owned(),
        count => format!("the outlines of {count} of the subjects"),
    };
    Some(Note::NotOnPage(
        about,
        Reason::NoRoomForSubject,
        format!("{subjects} in the {part}, as a whole or for the most part, for want of room; {what_to_do}"),
    ))
}

/// The cells of the subject at a place, in shares of the picture, and which region it is, if it is one, whose outline
/// is drawn first: that most like the thing that the place names. There are no regions where no lines are drawn.
fn subject_at(
    edges: &Edges,
    [x, y]: [f32; 2],
    mm_per_px: f32,
    things: Option<&NamedThings>,
) -> Option<(Mask, Option<u32>)> {
    let found = things.and_then(|things| {
        let thing = things.at([x, y])?.on(RegionGrid::new(edges.size));
        let region = edges.regions.as_ref().and_then(|tree| tree.most_like(&thing));
        Some((thing, region))
    });
    let at = PxPoint::new(x * edges.size.width as f32, y * edges.size.height as f32);
    found.or_else(|| Some((ring_around(edges, at, mm_per_px)?, None)))
}

/// The inside of the smallest closed contour around a place.
fn ring_around(edges: &Edges, at: PxPoint, mm_per_px: f32) -> Option<Mask> {
    let grid = RegionGrid::new(edges.size);
    let rings = edges.chains.iter().filter(|range| range.closed).map(|range| edges.chain(range));
    let inside = rings.filter_map(|ring| {
        let points: Vec<PxPoint> = ring.vertices.iter().map(Located::at).collect();
        // a drawing may have thousands
        Box2D::from_points(&points).contains_inclusive(at).then(|| Mask::of_ring(grid, &points))
    });
    let cell = mm_per_px * edges.size.width as f32 / grid.cells.width as f32;
    let least = (LEAST_AREA / (cell * cell)) as usize;
    inside.filter(|mask| mask.contains(at) && mask.cells() >= least).min_by_key(Mask::cells)
}

/// Takes weak lines that are not of the subject out. Returns how much, mm.
fn calm(edges: &mut Edges, subject: &Mask, layout: &Layout, plan: &Plan) -> f32 {
    let (strong, near) = (plan.lines().full_strength, subject.clone().grown(MARGIN));
    let length = |edges: &Edges| edges.chains().map(|chain| chain.length()).sum::<f32>();
    let before = length(edges);
    let mean = |edges: &Edges| -> Vec<f32> {
        let mean = |strengths: &[Edgel]| {
            strengths.iter().map(|edgel| edgel.strength).sum::<f32>() / strengths.len().max(1) as f32
        };
        edges.chains().map(|chain| mean(chain.vertices)).collect()
    };
    let is_weak: Vec<bool> = mean(edges).into_iter().map(|strength| strength < strong).collect();
    take_out(edges, |number, range, edgel| is_weak[number] && !range.kind.added && !near.contains(edgel.at));
    (before - length(edges)) * PageTransform::new(edges.size, layout.figure).mm_per_px()
}

/// Leaves the cells of colours that are not of the subject blank.
pub(super) fn blank_around(classes: &mut Classes, subject: &Mask, picture: Size) {
    blank_where(classes, |[x, y]| !subject.contains(PxPoint::new(x * picture.width as f32, y * picture.height as f32)));
}

#[cfg(test)]
mod tests;
