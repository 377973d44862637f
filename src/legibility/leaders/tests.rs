//! Tests of `leaders`.

use super::*;
use crate::page::{Dots, Figure, Line, Parts};
use crate::units::Size;

/// What is found of a label at the left whose line ends at this place, beside a square of 40 mm; the line is its
/// own, or one of the figure.
fn found(is_own: bool, x: f32, y: f32) -> Vec<String> {
    found_with(None, is_own, x, y)
}

/// The same with another line of the figure.
fn found_with(other: Option<[(f32, f32); 2]>, is_own: bool, x: f32, y: f32) -> Vec<String> {
    let other = other.map(|ends| ends.map(MmPoint::from).to_vec());
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let square = [at(60.0, 30.0), at(100.0, 30.0), at(100.0, 70.0), at(60.0, 70.0), at(60.0, 30.0)];
    let line = |points: Vec<MmPoint>| Line { strength: 100.0, runs: vec![Run::stroke(1.0, points)] };
    let leader = vec![at(25.0, 50.0), at(x, y)];
    let figure = Figure {
        place: MmRect::new(at(10.0, 10.0), at(190.0, 130.0)),
        source: Size::new(180, 120),
        textures: Vec::new(),
        lines: std::iter::once(square.to_vec())
            .chain((!is_own).then(|| leader.clone()))
            .chain(other)
            .map(line)
            .collect(),
    };
    let text = BrailleText {
        role: TextRole::Label,
        text: "roof".to_owned(),
        language: "en".to_owned(),
        abbreviation: None,
        lines: vec!["\u{2801}".to_owned()],
        dots: Dots { diameter: 1.3, at: vec![at(20.0, 50.0)] },
        leader: is_own.then(|| Run::stroke(0.75, leader)),
    };
    let page = Page::new(Parts { braille: vec![text], ..Parts::of([210.0, 297.0], figure) }).expect("a page");
    let paths = Paths::whole(&page.figure.lines);
    let found = findings(&page, &Names::of(&page), &paths, &paths.index(5.0), 10.0);
    found.into_iter().map(|found| found.what).collect()
}

#[test]
fn a_line_that_leads_to_nothing_is_told() {
    for is_own in [true, false] {
        assert!(found(is_own, 59.0, 50.0).is_empty() && found(is_own, 80.0, 50.0).is_empty(), "to a side, and in");
    }
    assert_eq!(found(true, 45.0, 50.0), ["the line that leads from \"roof\" ends where nothing is within 6 mm"]);
    let of_figure = ["line 2, which leads from \"roof\", ends where nothing is within 6 mm"];
    assert_eq!(found(false, 45.0, 50.0), of_figure);
    assert!(found(false, 25.0, 75.0).is_empty(), "it is beside the label, and does not lead from it");
}

/// The plate of a battery beside its minus is no leader line, as the wire ends on it.
#[test]
fn a_line_on_which_another_ends_leads_from_no_label() {
    let wire = |y: f32| found_with(Some([(35.0, y), (35.0, 80.0)]), false, 45.0, 50.0);
    assert!(wire(50.5).is_empty());
    assert_eq!(wire(54.0).len(), 1, "beside it");
}

/// A gridline that is interrupted by a label begins beside it too, and leads to nothing.
#[test]
fn a_piece_of_a_gridline_is_no_leader_line() {
    let at = |x: f32, y: f32| MmPoint::new(x, y);
    let line = |strength: f32, points: [MmPoint; 2]| Line { strength, runs: vec![Run::stroke(1.0, points.to_vec())] };
    let of = |ends: [f32; 2]| {
        let grid =
            ends.map(|x| x + 40.0).into_iter().zip([80.0, 110.0]).map(|(x, y)| line(10.0, [at(15.0, y), at(x, y)]));
        let piece = line(10.0, [at(25.0, 50.0), at(85.0, 50.0)]);
        let lines: Vec<Line> = grid.chain([piece, line(100.0, [at(15.0, 20.0), at(180.0, 20.0)])]).collect();
        let figure = Figure {
            place: MmRect::new(at(10.0, 10.0), at(190.0, 130.0)),
            source: Size::new(180, 120),
            textures: Vec::new(),
            lines,
        };
        let page = Page::new(Parts::of([210.0, 297.0], figure)).expect("a page");
        let weak = which_are_weak(&page.figure.lines, 10.0);
        is_of_grid(2, at(85.0, 50.0), &page, &weak)
    };
    assert!(of([45.0, 45.0]), "all end at one place");
    assert!(!of([45.0, 30.0]) && !of([20.0, 30.0]));
}
