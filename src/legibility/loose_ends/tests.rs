//! Tests of `loose_ends`.

use super::*;
use crate::page::{Figure, Line, Parts, Run};
use crate::profile::{Plan, Profile};
use crate::units::{MmRect, Size};

/// A line from a place to the right or downwards.
fn line(x: f32, y: f32, [right, down]: [f32; 2]) -> Line {
    let points = vec![MmPoint::new(x, y), MmPoint::new(x + right, y + down)];
    Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] }
}

/// Lines that are 10 mm long and at least 10 mm apart.
fn scraps(count: usize) -> Vec<Line> {
    (0..count).map(|k| line(25.0 + 20.0 * (k % 6) as f32, 25.0 + 20.0 * (k / 6) as f32, [10.0, 0.0])).collect()
}

/// How many ends in 100 square cm are too many of these lines, in a figure of 225 square cm for swell paper.
fn too_many(lines: Vec<Line>, of_photograph: bool) -> Option<f32> {
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(160.0, 160.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines };
    let origin = LeftOut { of: 400, of_photograph, ..LeftOut::default() }.to_origin();
    let page = Page::new(Parts { origin, ..Parts::of([210.0, 297.0], figure) }).expect("it is on the sheet");
    let limits = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it is right").limits();
    let paths = Paths::whole(&page.figure.lines);
    let found = findings(&page, &paths, &paths.index(CELL), &limits);
    let of_page = LooseEnds::of(&page, &limits).map(|ends| ends.each);
    assert_eq!(of_page, found.as_ref().and_then(|found| found.measured), "convert and check find the same");
    of_page
}

#[test]
fn a_photograph_in_scraps_is_told_and_a_drawing_is_not() {
    // 48 ends, and 44
    assert!(too_many(scraps(24), true).is_some_and(|each| (each - 21.3).abs() < 0.1));
    assert_eq!(too_many(scraps(22), true), None);
    assert_eq!(too_many(scraps(24), false), None);
}

#[test]
fn an_end_on_a_line_leads_to_that() {
    // each begins on a line down the figure
    let posts = (0..6).map(|k| line(25.0 + 20.0 * k as f32, 20.0, [0.0, 120.0]));
    assert_eq!(too_many(scraps(24).into_iter().chain(posts).collect(), true), None);
}

#[test]
fn a_line_that_comes_back_to_itself_has_no_end_there() {
    // a loop that begins on its own way
    let loops = scraps(24).into_iter().map(|scrap| {
        let from = scrap.runs[0].points[0];
        let to = |x: f32, y: f32| MmPoint::new(from.x + x, from.y + y);
        let points = vec![from, to(10.0, 0.0), to(10.0, 10.0), to(2.0, 10.0), to(2.0, 1.0)];
        Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] }
    });
    assert_eq!(too_many(loops.collect(), true), None);
}

#[test]
fn what_leaves_the_figure_has_no_end_at_its_border() {
    let level = |x: f32| -> Vec<Line> { (0..23).map(|k| line(x, 20.0 + 6.0 * k as f32, [60.0, 0.0])).collect() };
    assert_eq!(too_many(level(12.0), true), None);
    assert!(too_many(level(30.0), true).is_some());
}
