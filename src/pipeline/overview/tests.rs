//! Tests of `overview`.

use super::*;
use crate::edges::{ChainKind, Edgel};
use crate::lines::Run;
use crate::pipeline::request::Fit;
use crate::profile::Profile;
use crate::units::{MmPoint, PxPoint, Size};

/// A drawing with a frame and a small square in it of this side, px. On an A4 sheet it has 1.6 px for a millimetre.
fn drawing(side: f32) -> Edges {
    let mut edges = Edges::none(Size::new(300, 200));
    let kind = ChainKind { of_drawing: true, exact: true, ..ChainKind::default() };
    for (at, [width, height]) in [((20.0, 20.0), [260.0, 160.0]), ((150.0, 100.0), [side; 2])] {
        let (left, top) = at;
        let corners = [(left, top), (left + width, top), (left + width, top + height), (left, top + height)];
        let edgel = |(x, y): (f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 90.0, contrast: [90.0, 0.0, 0.0] };
        edges.push_as(kind, corners.into_iter().map(edgel), true);
    }
    edges
}

/// Its overview, and how wide it is laid out, mm.
fn overview(edges: &Edges, settings: &[(&str, &str)], size: OverviewSize) -> (DrawnOverview, f32, Vec<String>) {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("a key and its value"));
    let plan = Plan::new(&profile).expect("it makes sense");
    let layout = Fit::default().layout(edges.size, &plan, OverviewSize::Own).expect("there is room");
    let mut skipped = Vec::new();
    let mut watch = |event: Event| {
        if let Event::Skip(_, why) = event {
            skipped.push(why.to_owned());
        }
    };
    let drawn = draw_overview(edges, LinesOf::Picture(None), size, &layout, &plan, &mut watch);
    (drawn, layout.overview.map_or(0.0, |place| place.width()), skipped)
}

fn width(drawn: &DrawnOverview) -> f32 {
    drawn.marks.as_ref().expect("it has lines").0.width()
}

#[test]
fn an_overview_of_a_photograph_has_no_line_that_its_figure_lacks() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(Size::new(300, 200), &plan, OverviewSize::Own).expect("there is room");
    let place = layout.overview.expect("there is room for one");
    let line = |of: MmRect, [from, to]: [(f32, f32); 2]| {
        let at = |(x, y): (f32, f32)| MmPoint::new(of.min.x + x * of.width(), of.min.y + y * of.height());
        Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![at(from), at(to)])] }
    };
    let (long, half, none) = ([(0.1, 0.2), (0.9, 0.2)], [(0.1, 0.5), (0.9, 0.5)], [(0.1, 0.8), (0.9, 0.8)]);
    let figure = [line(layout.figure, long), line(layout.figure, [(0.1, 0.5), (0.6, 0.5)])];
    let drawn = |lines: Vec<Line>| DrawnOverview { marks: Some((place, lines)), ..DrawnOverview::default() };
    let all = drawn(vec![line(place, long), line(place, half), line(place, none)]);
    let (_, lines) = all.within(&figure, &layout, &plan).marks.expect("two are in the figure");
    assert_eq!(lines, [line(place, long), line(place, half)]);
    let lacking = drawn(vec![line(place, none)]);
    assert!(lacking.within(&figure, &layout, &plan).marks.is_none(), "an overview has lines");
    let beside_textures = drawn(vec![line(place, none)]);
    assert!(beside_textures.within(&[], &layout, &plan).marks.is_some(), "a figure without lines leaves it as it is");
}

#[test]
fn an_overview_that_has_all_of_a_drawing_stays_as_small_as_the_profile_asks_for() {
    let (drawn, own, _) = overview(&drawing(60.0), &[], OverviewSize::Own);
    assert_eq!((width(&drawn), drawn.lost.rings), (own, 0));
}

#[test]
fn an_overview_that_lacks_a_ring_is_larger_and_has_it() {
    let (drawn, own, _) = overview(&drawing(8.0), &[], OverviewSize::Own);
    assert!(width(&drawn) > 1.1 * own, "{} mm, laid out {own} mm", width(&drawn));
    assert_eq!(drawn.lost.rings, 0);
    assert_eq!(told_of_overview(&drawn, &LostMarks::default()).count(), 0);
}

#[test]
fn a_drawing_with_far_more_lines_than_have_room_is_drawn_in_no_larger_overview() {
    let profile = Profile::named("swell-a4").expect("it is built in");
    let plan = Plan::new(&profile).expect("it makes sense");
    let layout = Fit::default().layout(Size::new(300, 200), &plan, OverviewSize::Own).expect("there is room");
    let larger = |lines: u16, faint: bool| {
        let mut edges = Edges::none(Size::new(300, 200));
        let kind = ChainKind { of_drawing: true, exact: true, faint, ..ChainKind::default() };
        let edgel = |(x, y): (f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 90.0, contrast: [90.0, 0.0, 0.0] };
        for line in 0..lines {
            let y = 10.0 + 180.0 * f32::from(line) / f32::from(lines);
            edges.push_as(kind, [(20.0, y), (280.0, y)].into_iter().map(edgel), false);
        }
        OverviewSource { edges: &edges, regions: None, layout: &layout, plan: &plan }.larger_places().len()
    };
    assert!(larger(20, false) > 0);
    assert_eq!(larger(250, false), 0);
    assert!(larger(250, true) > 0, "a grid gives way to what is drawn on it");
}

#[test]
fn a_ring_that_has_no_room_in_any_overview_is_told() {
    let (drawn, ..) = overview(&drawing(4.0), &[], OverviewSize::Own);
    let told: Vec<Note> = told_of_overview(&drawn, &LostMarks::default()).collect();
    assert!(told.contains(&Note::ShapesNotInOverview(1)), "{told:?}");
}

/// A comb: a ring that has no room as a whole where its teeth are near one another.
fn comb() -> Edges {
    let mut edges = Edges::none(Size::new(300, 200));
    let kind = ChainKind { of_drawing: true, exact: true, ..ChainKind::default() };
    let teeth = (0..6).flat_map(|tooth| {
        let left = 60.0 + 30.0 * tooth as f32;
        [(left, 60.0), (left, 150.0), (left + 4.0, 150.0), (left + 4.0, 60.0)]
    });
    let corners = [(20.0, 60.0)].into_iter().chain(teeth).chain([(280.0, 60.0), (280.0, 20.0), (20.0, 20.0)]);
    let edgel = |(x, y): (f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 90.0, contrast: [90.0, 0.0, 0.0] };
    edges.push_as(kind, corners.map(edgel), true);
    edges
}

#[test]
fn where_whole_rings_would_leave_nearly_nothing_they_are_drawn_in_part() {
    let (drawn, ..) = overview(&comb(), &[], OverviewSize::Own);
    let (_, lines) = drawn.marks.as_ref().expect("it has lines");
    assert_eq!(drawn.rings, Rings::InParts);
    assert!(drawn.lost.share() < 0.8 && lines.len() > 1, "{} lines, lost {}", lines.len(), drawn.lost.share());
    let told: Vec<String> = told_of_overview(&drawn, &LostMarks::default()).map(|note| note.to_string()).collect();
    assert!(told.iter().any(|told| told.starts_with("1 closed shape is open or missing in the overview")), "{told:?}");
}

#[test]
fn the_overview_of_a_photograph_is_larger_from_the_first() {
    let mut edges = drawing(60.0);
    edges.chains.iter_mut().for_each(|chain| chain.kind = ChainKind::default());
    let (own, laid_out, _) = overview(&edges, &[], OverviewSize::Own);
    let (larger, ..) = overview(&edges, &[], OverviewSize::OfPhotograph);
    assert!((width(&own) - laid_out).abs() < 1e-3, "{} mm, laid out {laid_out} mm", width(&own));
    assert!(width(&larger) > 1.2 * laid_out, "{} mm, laid out {laid_out} mm", width(&larger));
}

#[test]
fn without_contours_or_an_overview_nothing_is_drawn_and_it_is_said_why() {
    let (drawn, _, skipped) = overview(&Edges::none(Size::new(300, 200)), &[], OverviewSize::Own);
    assert!(drawn.marks.is_none());
    assert_eq!(skipped, ["there are no contours"]);
    let (_, _, skipped) = overview(&drawing(60.0), &[("overview.on", "false")], OverviewSize::Own);
    assert_eq!(skipped, ["overview.on is off"]);
}
