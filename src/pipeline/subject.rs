//! What the picture is about, as its maker says by places on it.

use super::decisions::Decisions;
use super::given::{Given, blank_where};
use super::hand_lines::without;
use crate::classes::Classes;
use crate::edges::{Edgel, Edges};
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Located;
use crate::lines::Line;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{Mask, RegionGrid};
use crate::units::{MmRect, PageTransform, PxPoint, Size};
use crate::{About, Note};

/// Most places that are looked at: more is what a picture has, not what it is about.
const MOST: usize = 100;
/// A ring around the subject has at least this area, mm2: smaller ones are dots for a finger.
const LEAST_AREA: f32 = 15.0;
/// Lines this near to the subject belong to it, cells: its own contours run along its border.
const MARGIN: f32 = 3.0;
/// An outline is there if lines run along this share of the border of its region: they cut its thin arms off and go
/// around no holes.
const DRAWN: f32 = 0.4;
/// Lines are smoothed, mm, beyond what they give way.
const SMOOTHED: f32 = 1.0;

/// Finds the subjects among regions, or within closed contours, and writes them into the decisions; where a calm
/// background is asked for, takes what is not of them out of the contours.
pub(super) fn prepare(
    given: &Given,
    (edges, decisions): (&mut Edges, &mut Decisions),
    source: Size,
    layout: &Layout,
    plan: &Plan,
) -> Vec<Note> {
    let (mut all, mut notes) = (None::<Mask>, Vec::new());
    let mm_per_px = PageTransform::new(edges.size, layout.figure).mm_per_px();
    let tree = edges.regions.as_ref().filter(|_| !given.subjects.is_empty());
    let most_telling = tree.map_or_else(Vec::new, |tree| tree.most_telling(mm_per_px, &plan.regions(false)));
    let beyond = given.subjects.len().saturating_sub(MOST);
    if beyond > 0 {
        let told = format!("{beyond} of the subjects, as {MOST} are the most");
        notes.push(Note::NotOnPage(About::Lines, told));
    }
    for [x, y] in given.subjects.iter().take(MOST) {
        let share = [x.share(source.width), y.share(source.height)];
        let percent = share.map(|share| (100.0 * share).round() as i32);
        let found = subject_at(edges, share, mm_per_px, &most_telling).and_then(|(mask, region)| {
            let [least, greatest] = mask.extent()?;
            let side = (greatest - least) * mm_per_px;
            Some((mask, [side.x, side.y].map(|side| side.round() as u32), region))
        });
        match found {
            Some((mask, mm, region)) => {
                all = Some(all.map_or(mask.clone(), |all| all.with(&mask)));
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
    let lacking = |lines: &[Line], place: MmRect, about: About| {
        lacking(decisions, lines, (picture, place), (layout, plan), about)
    };
    let of_figure = lacking(figure, layout.figure, About::Lines);
    of_figure.into_iter().chain(overview.and_then(|(place, lines)| lacking(lines, *place, About::Overview)))
}

/// The same of one part of the page, in which the picture lies at `place`.
fn lacking(
    decisions: &Decisions,
    lines: &[Line],
    (picture, place): (Size, MmRect),
    (layout, plan): (&Layout, &Plan),
    about: About,
) -> Option<Note> {
    let reach = plan.lines().farthest_moved().max(1.5 * layout.medium.pitch()) + SMOOTHED;
    let runs = || lines.iter().flat_map(|line| &line.runs);
    let (at, mut index) = (PageTransform::new(picture, place), Nearby::new(place, reach));
    for (number, run) in (0..).zip(runs()) {
        index.insert_line(number, run.polyline(), 0.0);
    }
    let is_drawn = |border: &&Vec<PxPoint>| {
        let near = border.iter().filter(|point| index.nearest(at.to_mm(**point), reach, |_| true).is_some()).count();
        near as f32 >= DRAWN * border.len() as f32
    };
    let lacking = decisions.borders.iter().filter(|border| !is_drawn(border)).count();
    let (part, what_to_do) = match about {
        About::Overview => ("overview", "crop the picture around it"),
        _ => ("figure", "make the figure larger, or crop the picture around it"),
    };
    let subjects = match lacking {
        0 => return None,
        1 => "the outline of the subject".to_owned(),
        count => format!("the outlines of {count} of the subjects"),
    };
    Some(Note::NotOnPage(
        about,
        format!("{subjects} in the {part}, as a whole or for the most part, for want of room; {what_to_do}"),
    ))
}

/// The cells of the subject at a place, in shares of the picture, and which region it is, if it is one, whose outline
/// is drawn first.
fn subject_at(edges: &Edges, [x, y]: [f32; 2], mm_per_px: f32, most_telling: &[u32]) -> Option<(Mask, Option<u32>)> {
    let at = PxPoint::new(x * edges.size.width as f32, y * edges.size.height as f32);
    let found = edges.regions.as_ref().and_then(|tree| {
        let region = tree.subject_at(at, mm_per_px, most_telling)?;
        Some((tree.mask(&[region]), Some(region)))
    });
    found.or_else(|| Some((ring_around(edges, at, mm_per_px)?, None)))
}

/// The inside of the smallest closed contour around a place.
fn ring_around(edges: &Edges, at: PxPoint, mm_per_px: f32) -> Option<Mask> {
    let grid = RegionGrid::new(edges.size);
    let rings = edges.chains.iter().filter(|range| range.closed).map(|range| edges.chain(range));
    let inside = rings.map(|ring| {
        let points: Vec<PxPoint> = ring.vertices.iter().map(Located::at).collect();
        Mask::of_ring(grid, &points)
    });
    let cell = mm_per_px * edges.size.width as f32 / grid.cells.width as f32;
    let least = (LEAST_AREA / (cell * cell)) as usize;
    inside.filter(|mask| mask.contains(at) && mask.cells() >= least).min_by_key(Mask::cells)
}

/// Takes weak lines that are not of the subject out, and the outlines of other regions. Returns how much, mm.
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
    without(edges, |number, range, edgel| is_weak[number] && !range.kind.added && !near.contains(edgel.at));
    (before - length(edges)) * PageTransform::new(edges.size, layout.figure).mm_per_px()
}

/// Leaves the cells of colours that are not of the subject blank.
pub(super) fn blank_around(classes: &mut Classes, subject: &Mask, picture: Size) {
    blank_where(classes, |[x, y]| !subject.contains(PxPoint::new(x * picture.width as f32, y * picture.height as f32)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edges::ChainKind;
    use crate::pipeline::label::Position;
    use crate::pipeline::request::{Fit, OverviewSize};
    use crate::profile::Profile;

    const SIZE: Size = Size { width: 400, height: 300 };

    /// Contours of a picture: rectangles (left, top, width, height) of a strength.
    fn rectangles(of: &[([f32; 4], f32)]) -> Edges {
        let mut edges = Edges::none(SIZE);
        for &([left, top, width, height], strength) in of {
            push(&mut edges, [left, top, width, height], strength, ChainKind::default());
        }
        edges
    }

    fn push(edges: &mut Edges, [left, top, width, height]: [f32; 4], strength: f32, kind: ChainKind) {
        let corners = [(left, top), (left + width, top), (left + width, top + height), (left, top + height)];
        let edgel = |(x, y): (f32, f32)| Edgel { at: PxPoint::new(x, y), strength, contrast: [0.0; 3] };
        edges.push_as(kind, corners.into_iter().map(edgel), true);
    }

    /// What is decided and told of these places, in percent of the picture.
    fn prepared(edges: &mut Edges, places: &[[f32; 2]], calm_background: bool) -> (Decisions, Vec<Note>) {
        let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
        let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
        let subjects = places.iter().map(|place| place.map(Position::Percent)).collect();
        let given = Given { subjects, calm_background, ..Given::default() };
        let mut decisions = Decisions::default();
        let notes = prepare(&given, (edges, &mut decisions), SIZE, &layout, &plan);
        (decisions, notes)
    }

    #[test]
    fn without_regions_the_smallest_ring_around_a_place_is_the_subject() {
        let mut edges = rectangles(&[([40.0, 30.0, 320.0, 240.0], 40.0), ([160.0, 120.0, 80.0, 60.0], 40.0)]);
        let before = edges.clone();
        let (decisions, notes) = prepared(&mut edges, &[[50.0, 50.0], [15.0, 15.0], [2.0, 2.0]], false);
        let [Note::Subject { mm: [inner, _], is_first: false, .. }, Note::Subject { mm: [outer, _], .. }, none] =
            &notes[..]
        else {
            panic!("{notes:?}")
        };
        assert!((*outer as f32 / *inner as f32 - 4.0).abs() < 0.1, "{outer} mm around {inner} mm");
        assert_eq!(*none, Note::NoSubject([2, 2]));
        assert_eq!(decisions, Decisions::default(), "only regions have an outline that comes first");
        assert_eq!(edges, before);
    }

    #[test]
    fn a_ring_too_small_for_a_finger_is_no_subject() {
        let mut edges = rectangles(&[([193.0, 144.0, 6.0, 6.0], 40.0)]);
        let (_, notes) = prepared(&mut edges, &[[49.0, 49.0]], false);
        assert_eq!(notes, [Note::NoSubject([49, 49])]);
    }

    #[test]
    fn around_a_calm_subject_weak_lines_go_and_strong_and_added_ones_stay() {
        let subject = ([160.0, 120.0, 80.0, 60.0], 12.0);
        let (weak, strong) = (([20.0, 20.0, 60.0, 40.0], 12.0), ([300.0, 20.0, 60.0, 40.0], 90.0));
        let mut edges = rectangles(&[subject, weak, strong]);
        let added = [20.0, 220.0, 60.0, 40.0];
        push(&mut edges, added, 12.0, ChainKind { added: true, ..ChainKind::default() });
        let (decisions, notes) = prepared(&mut edges, &[[50.0, 50.0]], true);
        let firsts: Vec<(f32, f32)> = edges.chains().map(|chain| chain.vertices[0].at.to_tuple()).collect();
        assert_eq!(firsts, [(160.0, 120.0), (300.0, 20.0), (20.0, 220.0)]);
        assert!(matches!(notes[..], [Note::Subject { .. }, Note::BackgroundCalmed(mm)] if mm > 0), "{notes:?}");
        let around = decisions.calmed_around.expect("textures around it are left out too");
        assert!(around.contains(PxPoint::new(200.0, 150.0)) && !around.contains(PxPoint::new(50.0, 40.0)));
    }

    #[test]
    fn places_beyond_the_most_are_told() {
        let mut edges = rectangles(&[([40.0, 30.0, 320.0, 240.0], 40.0)]);
        let (_, notes) = prepared(&mut edges, &[[50.0, 50.0]; MOST + 3], false);
        assert_eq!(notes.len(), MOST + 1);
        assert!(notes[0].to_string().contains("3 of the subjects, as 100 are the most"), "{}", notes[0]);
    }
}
