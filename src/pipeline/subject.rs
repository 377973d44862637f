//! What the picture is about, as its maker says by places on it.

use std::collections::BTreeMap;

use lyon::geom::euclid::Box2D;

use super::cut_contours::take_out;
use super::decisions::{Decisions, FoundSubject};
use super::given::{Given, blank_where, is_in};
use super::label::Position;
use super::lines_of_part::LinesOfPart;
use super::named::NamedThings;
use crate::classes::{Class, Classes};
use crate::edges::{ChainRange, Edgel, Edges};
use crate::geom::polyline::Located;
use crate::lines::{Line, PagePart};
use crate::note::LEAST_DRAWN;
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{Mask, RegionGrid};
use crate::units::{Length, MmRect, PageTransform, PxPoint, Size};
use crate::{About, Note, Reason, Told};

/// Most places that are looked at, each in all regions: the program takes fewer (`--subject`).
const MOST: usize = 100;
const _: () = assert!(MOST == 100, "Options::subject says so");
/// A ring around the subject has at least this area, mm2: smaller ones are dots for a finger.
const LEAST_AREA: f32 = 15.0;
/// Lines this near to the subject belong to it, cells: its own contours run along its border.
const MARGIN: f32 = 3.0;
/// An outline is there if lines run along this share of the border of its region: they cut its thin arms off and go
/// around no holes.
const DRAWN: f32 = LEAST_DRAWN as f32 / 100.0;
/// A thing that has this share of the picture, or more, is mostly the ground of what was meant.
const MOST_OF_PICTURE: f32 = 0.7;
/// What lines enclose together is a part of the inside of a closed line if it has less than this share of its cells:
/// cells along the lines themselves make a few percent of difference.
const SMALLER: f32 = 0.85;

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
    // in a drawing closed lines surround things
    let are_off = plan.region_detail().is_none() && !edges.of_drawing();
    let beyond = given.subjects.len().saturating_sub(MOST);
    if beyond > 0 {
        let told = format!("{beyond} of the subjects, as {MOST} are the most");
        notes.push(Note::NotOnPage(About::Lines, Reason::TooManySubjects, told.into()));
    }
    for [x, y] in given.subjects.iter().take(MOST) {
        let share = [x.share(source.width), y.share(source.height)];
        let percent = share.map(in_percent);
        let found = subject_at(edges, share, mm_per_px, things).and_then(|(mask, region)| {
            let extent = mask.extent()?;
            let side = (extent[1] - extent[0]) * mm_per_px;
            let mm = [side.x, side.y].map(|side| side.round() as u32);
            let at = extent[0].lerp(extent[1], 0.5);
            let middle = [at.x / edges.size.width as f32, at.y / edges.size.height as f32].map(in_percent);
            let (fills, border) = (mask.fills(MOST_OF_PICTURE), mask.border());
            Some(FoundSubject { at: percent, mm, middle, colour: None, fills, region, mask, border })
        });
        match found {
            Some(found) => {
                all = Some(all.map_or(found.mask.clone(), |all| all.united(&found.mask)));
                decisions.subjects.extend(found.region.filter(|region| !decisions.subjects.contains(region)));
                decisions.found.push(found);
            }
            None => notes.push(nothing_at([*x, *y], share, are_off)),
        }
    }
    if given.calm_background && all.is_none() && !given.subjects.is_empty() {
        notes.push(Note::NothingCalmed);
    }
    decisions.calmed_around = all.filter(|_| given.calm_background);
    if let Some(subject) = &decisions.calmed_around {
        // lines that a person gave are all meant
        let calmed = if given.lines.is_none() { calm(edges, subject, layout, plan) } else { 0.0 };
        decisions.calmed_mm = calmed.round() as u32;
    }
    notes
}

/// A share of a side in whole percent.
fn in_percent(share: f32) -> i32 {
    (100.0 * share).round() as i32
}

/// That nothing is found at a place, in these shares of the part that is drawn; regions may be off (`are_off`).
fn nothing_at(place: [Position; 2], share: [f32; 2], are_off: bool) -> Note {
    let said = |position: Position| match position.length() {
        Length::Percent(percent) => format!("{percent} %"),
        Length::Pixels(pixels) => format!("{pixels} px"),
        length @ Length::Mm(_) => length.to_string(),
    };
    let [x, y] = place.map(said);
    let is_on_it = share.iter().all(|share| (0.0..=1.0).contains(share));
    let reason = match is_on_it {
        false => Reason::OutsidePart,
        true if are_off => Reason::RegionsOff,
        true => Reason::NothingThere,
    };
    Note::NoSubject(reason, format!("{x}, {y}"))
}

/// What the maker is told of the subjects: what each is, and those whose outlines are not among the lines of the
/// figure, or of the overview that lies in a place, or only pieces of them; `picture` is the size of the picture.
pub(super) fn told(
    decisions: &Decisions,
    picture: Size,
    figure: &[Line],
    overview: Option<&(MmRect, Vec<Line>)>,
    layout: &Layout,
    plan: &Plan,
) -> Vec<Note> {
    if decisions.found.is_empty() {
        return Vec::new();
    }
    let shares = |lines: &[Line], place: MmRect| -> Vec<f32> {
        let (at, drawn) = (PageTransform::new(picture, place), LinesOfPart::of(lines, place, layout, plan));
        let of_border = |found: &FoundSubject| drawn.share(found.border.iter().map(|point| at.to_mm(*point)));
        decisions.found.iter().map(of_border).collect()
    };
    let has_lines = plan.profile().figure.lines;
    let of_figure = shares(figure, layout.figure);
    let what = decisions.found.iter().zip(&of_figure).map(|(found, &drawn)| Note::Subject {
        at: found.at,
        mm: found.mm,
        middle: found.middle,
        colour: found.colour,
        is_first: found.region.is_some(),
        drawn: has_lines.then_some((100.0 * drawn) as u32),
        fills: found.fills,
    });
    let in_figure = has_lines.then(|| lacking(decisions, picture, &of_figure, PagePart::Figure, layout)).flatten();
    let in_overview = overview
        .and_then(|(place, lines)| lacking(decisions, picture, &shares(lines, *place), PagePart::Overview, layout));
    let calmed = decisions.calmed_around.as_ref().map(|_| Note::BackgroundCalmed(decisions.calmed_mm));
    what.chain(calmed).chain(in_figure).chain(in_overview).collect()
}

/// What is told of the regions of which most of the border is not drawn in one part of the page, given the share of
/// each that is.
fn lacking(decisions: &Decisions, picture: Size, drawn: &[f32], part: PagePart, layout: &Layout) -> Option<Note> {
    let is_lacking = |found: &FoundSubject, drawn: f32| found.region.is_some() && drawn < DRAWN;
    let mut lacking: Vec<&FoundSubject> = Vec::new();
    for (found, _) in decisions.found.iter().zip(drawn).filter(|(found, drawn)| is_lacking(found, **drawn)) {
        if !lacking.iter().any(|other| other.region == found.region) {
            lacking.push(found);
        }
    }
    let (about, name) = match part {
        PagePart::Overview => (About::Overview, "overview"),
        PagePart::Figure => (About::Lines, "figure"),
    };
    let (subjects, them) = match lacking.len() {
        0 => return None,
        1 => ("the outline of the subject".to_owned(), "it"),
        count => (format!("the outlines of {count} of the subjects"), "them"),
    };
    let is_erased =
        |point: &&PxPoint| is_in([point.x / picture.width as f32, point.y / picture.height as f32], &decisions.erased);
    let mostly_erased = |found: &&FoundSubject| 2 * found.border.iter().filter(is_erased).count() > found.border.len();
    let told = |why: &str| Told::from(format!("{subjects} in the {name}, as a whole or for the most part, {why}"));
    let (reason, helped) = if lacking.iter().all(mostly_erased) {
        let why = format!("as most of {them} lies in what is erased");
        (Reason::SubjectErased, told(&why).or("erase less"))
    } else {
        let narrow = "parts of it are too near to one another or to other lines, or it is narrower than a line";
        let told = told(&format!("for want of room: {narrow}"));
        let told = match (part, &layout.medium) {
            (PagePart::Figure, Medium::Print(_)) => told.or_larger(),
            (PagePart::Figure | PagePart::Overview, _) => told,
        };
        (Reason::NoRoomForSubject, told.or(format!("crop the picture around {them}")))
    };
    Some(Note::NotOnPage(about, reason, helped))
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
    found.or_else(|| Some((closed_around(edges, at, mm_per_px)?, None)))
}

/// The smallest part of the picture around a place that closed lines surround: the inside of one that is closed, or
/// what several that meet enclose together.
fn closed_around(edges: &Edges, at: PxPoint, mm_per_px: f32) -> Option<Mask> {
    let grid = RegionGrid::new(edges.size);
    let cell = mm_per_px * edges.size.width as f32 / grid.cells.width as f32;
    let least = (LEAST_AREA / (cell * cell)) as usize;
    let is_enough = |mask: &Mask| mask.contains(at) && mask.cells() >= least;
    let points = |range: &ChainRange| -> Vec<PxPoint> { edges.chain(range).path().map(Located::at).collect() };
    let rings = edges.chains.iter().filter(|range| range.closed).map(points);
    let inside = rings.filter_map(|ring| {
        // a drawing may have thousands
        Box2D::from_points(&ring).contains_inclusive(at).then(|| Mask::of_ring(grid, &ring))
    });
    let ring = inside.filter(is_enough).min_by_key(Mask::cells);
    // contours of a photograph that meet seldom surround a thing
    let lines: Vec<Vec<PxPoint>> = match edges.of_drawing() {
        true => edges.chains.iter().map(points).collect(),
        false => Vec::new(),
    };
    let face = Mask::enclosed(grid, &lines, at).filter(is_enough);
    match (ring, face) {
        (Some(ring), Some(face)) if (face.cells() as f32) < SMALLER * ring.cells() as f32 => Some(face),
        (Some(ring), _) => Some(ring),
        (None, face) => face,
    }
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

/// Looks which colour most of each subject in a picture of this size has: white, where there is none.
pub(super) fn name_colours(found: &mut [FoundSubject], classes: &Classes, picture: Size) {
    let [width, height] = [classes.size.width, classes.size.height].map(|side| side as usize);
    let (across, down) = (picture.width as f32 / width as f32, picture.height as f32 / height as f32);
    for found in found {
        let is_in = |cell: &usize| {
            let (x, y) = ((cell % width) as f32 + 0.5, (cell / width) as f32 + 0.5);
            found.mask.contains(PxPoint::new(x * across, y * down))
        };
        let (mut cells, mut of_class) = (0_usize, BTreeMap::<Option<Class>, usize>::new());
        for cell in (0..classes.region.len()).filter(is_in) {
            let class = classes.region[cell].map(|region| classes.regions[region as usize].class);
            cells += 1;
            *of_class.entry(class).or_default() += 1;
        }
        let most = of_class.into_iter().find(|(_, count)| 2 * count > cells);
        found.colour = most.map(|(class, _)| class.map_or("white", Class::name));
    }
}

/// Leaves the cells of colours that are not of the subject blank.
pub(super) fn blank_around(classes: &mut Classes, subject: &Mask, picture: Size) {
    blank_where(classes, |[x, y]| !subject.contains(PxPoint::new(x * picture.width as f32, y * picture.height as f32)));
}

#[cfg(test)]
mod tests;
