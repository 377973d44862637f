//! Subjects: what is found at a place, what is decided, and what is told.

use super::*;
use crate::classes::Region;
use crate::edges::ChainKind;
use crate::pipeline::request::{Fit, OverviewSize};
use crate::profile::Profile;
use crate::raster::plane::Plane;

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
fn prepared(edges: &mut Edges, places: &[[f64; 2]], calm_background: bool) -> (Decisions, Vec<Note>) {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    let subjects = places.iter().map(|place| place.map(|at| Position::percent(at).expect("a number"))).collect();
    let given = Given { subjects, calm_background, ..Given::default() };
    let mut decisions = Decisions::default();
    let mut notes = prepare(&given, None, edges, &mut decisions, SIZE, &layout, &plan);
    notes.extend(told(&decisions, SIZE, &[], None, &layout, &plan));
    (decisions, notes)
}

#[test]
fn without_regions_the_smallest_ring_around_a_place_is_the_subject() {
    let mut edges = rectangles(&[([40.0, 30.0, 320.0, 240.0], 40.0), ([160.0, 120.0, 80.0, 60.0], 40.0)]);
    let before = edges.clone();
    let (decisions, notes) = prepared(&mut edges, &[[50.0, 50.0], [15.0, 15.0], [2.0, 2.0]], false);
    let [none, Note::Subject { mm: [inner, _], is_first: false, .. }, Note::Subject { mm: [outer, _], .. }] =
        &notes[..]
    else {
        panic!("{notes:?}")
    };
    assert!((*outer as f32 / *inner as f32 - 4.0).abs() < 0.1, "{outer} mm around {inner} mm");
    assert_eq!(*none, Note::NoSubject(Reason::NothingThere, "2 %, 2 %".to_owned()));
    assert!(decisions.subjects.is_empty(), "only regions have an outline that comes first");
    assert_eq!(edges, before);
}

#[test]
fn a_place_outside_is_told_as_it_was_given() {
    let place = [Position::pixels(700.0).expect("a number"), Position::percent(50.0).expect("a number")];
    let told = |share: [f32; 2], are_off: bool| nothing_at(place, share, are_off);
    let note = |reason: Reason| Note::NoSubject(reason, "700 px, 50 %".to_owned());
    assert_eq!(told([1.75, 0.5], true), note(Reason::OutsidePart));
    assert_eq!(told([0.75, 0.5], false), note(Reason::NothingThere));
    assert_eq!(told([0.75, 0.5], true), note(Reason::RegionsOff));
}

#[test]
fn without_regions_it_is_said_that_these_are_off() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("lines.regions", "false").expect("a key");
    let plan = Plan::new(&profile).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    let at = Position::percent(50.0).expect("a number");
    let given = Given { subjects: vec![[at, at]], ..Given::default() };
    let told = prepare(&given, None, &mut rectangles(&[]), &mut Decisions::default(), SIZE, &layout, &plan);
    assert_eq!(told, [Note::NoSubject(Reason::RegionsOff, "50 %, 50 %".to_owned())]);
}

#[test]
fn a_ring_too_small_for_a_finger_is_no_subject() {
    let mut edges = rectangles(&[([193.0, 144.0, 6.0, 6.0], 40.0)]);
    let (_, notes) = prepared(&mut edges, &[[49.0, 49.0]], false);
    assert_eq!(notes, [Note::NoSubject(Reason::NothingThere, "49 %, 49 %".to_owned())]);
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

#[test]
fn a_subject_of_which_most_is_not_drawn_is_told() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    // a square of 100 px, of which so many sides are drawn
    let corners = [(100.0, 100.0), (200.0, 100.0), (200.0, 200.0), (100.0, 200.0), (100.0, 100.0)];
    let corners = corners.map(|(x, y)| PxPoint::new(x, y));
    let mask = Mask::of_ring(RegionGrid::new(SIZE), &corners);
    let (border, middle, colour) = (mask.border(), [38, 50], Some("white"));
    let found =
        FoundSubject { at: [50, 50], mm: [40, 40], middle, colour, fills: false, region: Some(7), mask, border };
    let decisions = Decisions { subjects: vec![7], found: vec![found], ..Decisions::default() };
    let lines = |sides: usize, place: MmRect| {
        let at = PageTransform::new(SIZE, place);
        let points = corners[..=sides].iter().map(|corner| at.to_mm(*corner)).collect();
        vec![Line { strength: 50.0, runs: vec![crate::lines::Run::stroke(1.5, points)] }]
    };
    let texts = |of_figure: usize, of_overview: Option<usize>, decisions: &Decisions| {
        let small = MmRect::new(layout.figure.min, layout.figure.min + layout.figure.size().to_vector() * 0.5);
        let overview = of_overview.map(|sides| (small, lines(sides, small)));
        let figure = lines(of_figure, layout.figure);
        let notes = told(decisions, SIZE, &figure, overview.as_ref(), &layout, &plan);
        notes.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    let [whole] = &texts(4, Some(4), &decisions)[..] else { panic!("one note") };
    assert!(whole.contains("and its outline is drawn before other lines"), "{whole}");
    assert!(whole.contains("40 mm high in the figure, around 38 %, 50 %, mostly white, and its outline"), "{whole}");
    let [half] = &texts(2, None, &decisions)[..] else { panic!("one note") };
    assert!(half.contains("percent of its outline is drawn, before other lines"), "{half}");
    let [_, of_overview] = &texts(4, Some(1), &decisions)[..] else { panic!("two notes") };
    assert!(of_overview.contains("the outline of the subject in the overview, as a whole or for the most part"));
    let [most, of_figure] = &texts(1, None, &decisions)[..] else { panic!("two notes") };
    assert!(most.contains("most of its outline is not drawn"), "{most}");
    assert!(of_figure.contains("the outline of the subject in the figure"), "{of_figure}");
    assert!(of_figure.contains("for want of room"), "{of_figure}");
    let erased = Decisions { erased: vec![[0.0, 0.0, 1.0, 1.0]], ..decisions };
    let [_, of_erased] = &texts(0, None, &erased)[..] else { panic!("two notes") };
    assert!(of_erased.contains("lies in what is erased") && !of_erased.contains("want of room"), "{of_erased}");
}

/// By it a maker who does not see the page knows whether it is the swan or the water.
#[test]
fn a_subject_is_told_with_its_middle_and_its_colour() {
    let (decisions, notes) = prepared(&mut rectangles(&[([40.0, 60.0, 80.0, 60.0], 40.0)]), &[[15.0, 35.0]], false);
    assert!(matches!(notes[..], [Note::Subject { middle: [20, 30], colour: None, .. }]), "{notes:?}");
    // eight by six cells of 50 px, of which columns are blue
    let colour = |blue: std::ops::Range<usize>| {
        let region: Vec<Option<u32>> = (0..48).map(|cell| blue.contains(&(cell % 8)).then_some(0)).collect();
        let cells = region.iter().flatten().count() as u32;
        let classes = Classes {
            size: Size::new(8, 6),
            region,
            regions: vec![Region { class: Class::Blue, colour: [0; 3], cells }],
            lightness: Plane::filled(Size::new(8, 6), 0.3),
            fringe: Vec::new(),
        };
        let mut found = decisions.found.clone();
        name_colours(&mut found, &classes, SIZE);
        found[0].colour
    };
    assert_eq!([colour(0..3), colour(3..8)], [Some("blue"), Some("white")]);
}

#[test]
fn where_nothing_is_found_nothing_is_calmed() {
    let (_, notes) = prepared(&mut rectangles(&[]), &[[50.0, 50.0]], true);
    assert_eq!(notes, [Note::NoSubject(Reason::NothingThere, "50 %, 50 %".to_owned()), Note::NothingCalmed]);
}

#[test]
fn what_fills_most_of_the_picture_is_told_so() {
    let (_, notes) = prepared(&mut rectangles(&[([5.0, 5.0, 390.0, 290.0], 40.0)]), &[[50.0, 50.0]], false);
    let [note @ Note::Subject { fills: true, .. }] = &notes[..] else { panic!("{notes:?}") };
    assert!(note.to_string().contains("name a place on the thing itself"), "{note}");
}

#[test]
fn a_field_between_lines_that_meet_is_a_subject_of_a_drawing() {
    let mut edges = rectangles(&[]);
    let kind = ChainKind { of_drawing: true, exact: true, ..ChainKind::default() };
    push(&mut edges, [40.0, 30.0, 320.0, 240.0], 40.0, kind);
    let ends = [PxPoint::new(200.0, 30.0), PxPoint::new(200.0, 270.0)];
    edges.push_as(kind, ends.into_iter().map(|at| Edgel { at, strength: 40.0, contrast: [0.0; 3] }), false);
    let (_, notes) = prepared(&mut edges, &[[30.0, 50.0]], false);
    let [Note::Subject { mm: [width, height], .. }] = &notes[..] else { panic!("{notes:?}") };
    assert!(width < height, "{width} x {height} mm");
}
