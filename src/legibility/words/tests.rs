//! Tests of `words`.

use super::*;
use crate::page::{Dots, Figure, Parts, TextRole};
use crate::profile::{Plan, Profile};
use crate::units::{MmRect, Size};

/// What is found of the first letters of the alphabet, as these lines of braille, with their dots as `change` makes
/// them.
fn found(lines: &[&str], change: impl Fn(&mut Vec<MmPoint>)) -> Vec<FoundBreach> {
    let limits = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it is right").limits();
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
    let mut parts = Parts::of([100.0, 100.0], figure);
    let size = CellGrid::of(&parts.medium, limits.cell).size();
    let of_line =
        |down: f32| size.dots(&[0x01, 0x03, 0x09], 0.0).into_iter().map(move |at| at + MmVector::new(20.0, down));
    let mut at: Vec<MmPoint> = (0..lines.len()).flat_map(|line| of_line(20.0 + line as f32 * size.line)).collect();
    change(&mut at);
    parts.braille.push(BrailleText {
        role: TextRole::Label,
        text: "abc".into(),
        language: String::new(),
        abbreviation: None,
        lines: lines.iter().map(|line| (*line).to_owned()).collect(),
        dots: Dots { diameter: 1.5, at },
        leader: None,
    });
    let page = Page::new(parts).expect("it is on the sheet");
    findings(&page, &Names::of(&page), &limits)
}

#[test]
fn a_dot_on_another_leaves_its_place_empty() {
    let lines = ["\u{2801}\u{2803}\u{2809}"; 2];
    assert!(found(&lines, |_| {}).is_empty());
    let off =
        |breaches: Vec<FoundBreach>| breaches.iter().map(|breach| breach.measured.unwrap_or(0.0)).collect::<Vec<_>>();
    // the second dot of "b" on its first one, which is 2.5 mm above it
    let stacked = off(found(&lines, |at| at[2] = at[1]));
    assert!(stacked.len() == 1 && (stacked[0] - 2.5).abs() < 0.05, "{stacked:?}");
    // all of the second line on the first one
    let stacked = off(found(&lines, |at| (0..5).for_each(|dot| at[5 + dot] = at[dot])));
    assert!(stacked.len() == 1 && (stacked[0] - 10.0).abs() < 1.0, "{stacked:?}");
}

#[test]
fn a_letter_is_no_cell() {
    let found = found(&["\u{2801}\u{2803}\u{2809}a"], |_| {});
    assert_eq!(found.len(), 1);
    assert!(found[0].what.contains("\"a\" in it is no sign of that") && found[0].measured.is_none());
}
