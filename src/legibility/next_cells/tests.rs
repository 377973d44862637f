//! Tests of `next_cells`.

use super::*;
use crate::braille::CellSize;
use crate::devices::Device;
use crate::page::{DotMedium, Dots, Figure, Height, Medium, Parts};
use crate::profile::{Plan, Profile};
use crate::units::{MmPoint, Size};

/// What is found of a label on pins whose leader line has dots so many steps left of its first column, and is its own
/// or a line of the drawing.
fn found(steps: &[usize], is_own: bool) -> Vec<String> {
    let (sheet, pitch) = ([240.0, 100.0], 2.5);
    let device = Device::named("monarch").expect("in the table");
    let medium = Medium::Dots(DotMedium::on(device, pitch, sheet).expect("its own sheet"));
    let (at, diameter) = {
        let cells = CellGrid::of(&medium, CellSize::MARBURG);
        (cells.dots(&[vec![0b11_1111]], MmPoint::new(120.0, 40.0)), cells.diameter)
    };
    let row = steps.iter().map(|step| MmPoint::new(at[0].x - pitch * *step as f32, at[0].y)).collect();
    let leader = Run::dots(diameter, row, Height::High);
    let lines = if is_own { Vec::new() } else { vec![Line { strength: 20.0, runs: vec![leader.clone()] }] };
    let text = BrailleText {
        role: TextRole::Label,
        text: "roof".to_owned(),
        language: "en".to_owned(),
        abbreviation: None,
        lines: vec!["\u{283f}".to_owned()],
        dots: Dots { diameter, at },
        leader: is_own.then_some(leader),
    };
    let place = MmRect::new(MmPoint::new(20.0, 10.0), MmPoint::new(200.0, 90.0));
    let figure = Figure { place, source: Size::new(180, 80), textures: Vec::new(), lines };
    let page = Page::new(Parts { braille: vec![text], medium, ..Parts::of(sheet, figure) }).expect("a page");
    let plan = Plan::new(&Profile::named("monarch").expect("it is built in")).expect("it is right");
    findings(&page, &plan.limits()).into_iter().map(|found| found.what).collect()
}

#[test]
fn a_leader_line_in_the_cell_beside_its_label_is_told() {
    assert!(found(&[4, 6, 8, 10, 12, 14], true).is_empty());
    let told = found(&[3, 4, 6, 8, 10, 12, 14], true);
    assert!(told.len() == 1 && told[0].starts_with("the line that leads from \"roof\" begins in the cell"), "{told:?}");
    // beyond the cell there are five dots and more, or fewer
    assert_eq!(found(&[3, 4, 6, 8, 10, 12], true).len(), 1);
    assert!(found(&[3, 4, 6, 8, 10], true).is_empty(), "too short to be made shorter");
    assert!(found(&[2, 4, 6, 8], true).is_empty());
}

#[test]
fn a_leader_line_of_the_drawing_is_told_likewise() {
    assert!(found(&[4, 6, 8, 10, 12, 14], false).is_empty());
    let told = found(&[3, 4, 6, 8, 10, 12], false);
    assert!(told.len() == 1 && told[0].starts_with("a leader line of the drawing ends in the cell beside"), "{told:?}");
    assert!(found(&[2, 3, 4, 5, 6, 7, 8, 9], false).is_empty(), "a line of all dots is none");
}
