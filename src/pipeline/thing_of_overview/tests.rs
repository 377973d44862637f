//! Tests of `thing_of_overview`.

use super::*;
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
fn other_large_things_are_told_with_their_places() {
    let thing = |at: [f32; 2]| Lacking { at, share: 0.2 };
    let told = |things: &[Lacking]| told_of_others(things).map(|note| note.to_string());
    assert_eq!(told(&[]), None);
    let one = told(&[thing([70.4, 20.0])]).expect("one is lacking");
    assert!(one.contains("the outline of a large thing of the figure, at 70%,20%, in the overview"), "{one}");
    let four = told(&[10.0, 20.0, 30.0, 40.0].map(|x| thing([x, 50.0]))).expect("four are lacking");
    assert!(four.contains("of 4 large things of the figure, at 10%,50%, 20%,50%, 30%,50% and 1 more, in"), "{four}");
}
