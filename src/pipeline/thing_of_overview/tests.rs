//! Tests of `thing_of_overview`.

use super::*;
use crate::geom::nearest_on_segment;
use crate::lines::Run;
use crate::pipeline::request::{Fit, OverviewSize};
use crate::profile::Profile;
use crate::regions::RegionGrid;
use crate::units::MmVector;

const SIZE: Size = Size { width: 400, height: 300 };

#[test]
fn an_outline_of_the_figure_that_the_overview_lacks_is_told_with_its_place() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    // a square of 100 px, of which so many sides are drawn
    let corners = [(100.0, 100.0), (200.0, 100.0), (200.0, 200.0), (100.0, 200.0), (100.0, 100.0)];
    let corners = corners.map(|(x, y)| PxPoint::new(x, y));
    let thing = Mask::of_ring(RegionGrid::new(SIZE), &corners);
    let lines = |sides: usize, place: MmRect| {
        let at = PageTransform::new(SIZE, place);
        let points = corners[..=sides].iter().map(|corner| at.to_mm(*corner)).collect();
        vec![Line { strength: 50.0, runs: vec![Run::stroke(1.5, points)] }]
    };
    let small = MmRect::new(layout.figure.min, layout.figure.min + layout.figure.size().to_vector() * 0.5);
    let told = |of_figure: usize, of_overview: usize| {
        let overview = (small, lines(of_overview, small));
        let outlines = BothOutlines::of(SIZE, &lines(of_figure, layout.figure), &overview, &layout, &plan);
        outlines.lacking(&thing).map(|thing| told_of_first(thing).to_string())
    };
    assert_eq!(told(4, 4), None);
    assert_eq!(told(4, 3), None, "three of four sides are enough to be known");
    assert_eq!(told(1, 1), None, "the figure does not outline it either");
    let lacks = told(4, 1).expect("three sides are missing");
    assert!(lacks.contains("the thing at 38%,50%, which comes first in the figure, in the overview: 2"), "{lacks}");
    assert!(lacks.contains("lines.shapes = 5"), "{lacks}");
    // lines beside it are those of something else
    let overview = (small, lines(4, small.translate(MmVector::new(2.5, 2.5))));
    let outlines = BothOutlines::of(SIZE, &lines(4, layout.figure), &overview, &layout, &plan);
    assert!(outlines.lacking(&thing).is_some());
}

#[test]
fn other_large_things_are_told_with_where_the_figure_has_what_is_missing() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    let thing = |x: f32| Lacking { at: [50.0, 50.0], lacks: MmPoint::new(x, 40.0), share: 0.2 };
    let told = |things: &[Lacking]| told_of_others(things, &layout).map(|note| note.to_string());
    assert_eq!(told(&[]), None);
    let place = "such as the piece around 24, 40 mm from the left and the top of the sheet: other";
    let one = told(&[thing(24.0)]).expect("one is lacking");
    assert!(one.contains(&format!("much of the outline of a large thing of the figure, {place}")), "{one}");
    assert!(one.contains("if the picture is about it, name a place on it as the subject"), "{one}");
    let two = told(&[thing(24.0), thing(60.0)]).expect("two are lacking");
    assert!(two.contains(&format!("much of the outlines of 2 large things of the figure, {place}")), "{two}");
}

#[test]
fn a_place_of_what_is_missing_lies_on_the_outline() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let layout = Fit::default().layout(SIZE, &plan, OverviewSize::Own).expect("there is room");
    let corners = [(100.0, 100.0), (200.0, 100.0), (200.0, 200.0), (100.0, 200.0), (100.0, 100.0)];
    let corners = corners.map(|(x, y)| PxPoint::new(x, y));
    let lines = |corners: &[PxPoint], place: MmRect| {
        let at = PageTransform::new(SIZE, place);
        let points = corners.iter().map(|corner| at.to_mm(*corner)).collect();
        vec![Line { strength: 50.0, runs: vec![Run::stroke(1.5, points)] }]
    };
    // the overview has the upper side only
    let small = MmRect::new(layout.figure.min, layout.figure.min + layout.figure.size().to_vector() * 0.5);
    let overview = (small, lines(&corners[..2], small));
    let outlines = BothOutlines::of(SIZE, &lines(&corners, layout.figure), &overview, &layout, &plan);
    let lacks = outlines.lacking(&Mask::of_ring(RegionGrid::new(SIZE), &corners)).expect("three sides").lacks;
    let at = PageTransform::new(SIZE, layout.figure);
    let sides = corners.windows(2).map(|side| nearest_on_segment(lacks, at.to_mm(side[0]), at.to_mm(side[1])).0);
    let distances: Vec<f32> = sides.collect();
    assert!(distances.iter().any(|distance| *distance < 1.0) && distances[0] > 5.0, "{distances:?}");
}
