//! Tests of `description`.

use super::*;
use crate::page::{BrailleText, Dots, Figure, Medium, Parts, Print, Run};
use crate::units::Size;

/// An arrow, seven lines and a disc, as they are felt, on a page that prints marks by this much narrower, mm.
fn told(swell: f32) -> Vec<String> {
    let at = MmPoint::new;
    let line = |points: Vec<MmPoint>| Line { strength: 20.0, runs: vec![Run::stroke(1.0, points)] };
    let mut lines: Vec<Line> = (1..8).map(|k| 20.0 * k as f32).map(|y| line(vec![at(10.0, y), at(60.0, y)])).collect();
    lines.push(line(vec![at(100.0, 60.0), at(100.0, 10.0)]));
    lines.push(line(vec![at(96.0, 15.7), at(100.0, 10.0), at(104.0, 15.7)]));
    let ring = [(1.4, 0.0), (0.0, 1.4), (-1.4, 0.0), (0.0, -1.4)].map(|(x, y)| at(120.0 + x, 100.0 + y));
    let disc = Run { closed: true, ..Run::stroke(3.0, ring.to_vec()) };
    lines.push(Line { strength: 20.0, runs: vec![disc] });
    let place = MmRect::new(MmPoint::zero(), at(150.0, 150.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines };
    let medium = Medium::Print(Print { swell, ..Print::default() });
    let mut parts = Parts { medium, ..Parts::of([150.0, 150.0], figure) };
    parts.narrowed(swell);
    let page = Page::new(parts).expect("it is on the sheet");
    marks(&page, Wording::english()).into_iter().map(|(_, text)| text).collect()
}

/// Printed narrower the disc was counted among the lines, so that these seemed to be too many to tell each of them.
#[test]
fn a_page_that_is_printed_narrower_is_told_as_it_is_felt() {
    let plain = told(0.0);
    assert_eq!(plain.iter().filter(|text| text.to_lowercase().contains("arrow")).count(), 1, "{plain:?}");
    assert!(plain[0].contains("has 8 lines"), "{plain:?}");
    assert_eq!(told(0.5), plain);
}

/// The figure of a key is nothing but patches: shares of it, and that it has no lines, say nothing.
#[test]
fn a_key_is_told_as_one() {
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let dots = Dots { diameter: 1.6, at: vec![MmPoint::new(60.0, 20.0)] };
    let key = BrailleText {
        role: TextRole::Key,
        text: "blue".to_owned(),
        language: "en".to_owned(),
        abbreviation: None,
        lines: vec!["\u{2801}".to_owned()],
        dots,
        leader: None,
    };
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
    let page =
        Page::new(Parts { braille: vec![key], ..Parts::of([150.0, 160.0], figure) }).expect("it is on the sheet");
    let told = |language: &str| -> Vec<String> {
        marks(&page, Wording::nearest(language)).into_iter().map(|(_, text)| text).collect()
    };
    assert_eq!(told("en"), ["A sheet upright, 150 by 160 mm, with a key.", "The key says \"blue\"."]);
    assert_eq!(told("de")[0], "Ein Blatt im Hochformat, 150 mal 160 mm, mit einer Legende.");
}

#[test]
fn what_was_left_out_is_told_in_every_language() {
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
    let left_out = LeftOut { areas: 1, texts: 9, labels: 2, ..LeftOut::default() };
    let parts = Parts { origin: left_out.to_origin(), ..Parts::of([150.0, 150.0], figure) };
    let page = Page::new(parts).expect("it is on the sheet");
    let told = |language: &str| {
        let all = marks(&page, Wording::nearest(language)).into_iter();
        all.filter(|(about, _)| *about == "left-out").map(|(_, text)| text).collect::<Vec<_>>()
    };
    let english = [
        "1 area was too small for a texture when the page was made.",
        "9 texts of the picture were left out when the page was made.",
        "2 labels were left out when the page was made.",
    ];
    assert_eq!(told("en"), english);
    assert_eq!(
        told("pl")[1..],
        ["Przy tworzeniu strony pominięto 9 tekstów obrazu.", "Przy tworzeniu strony pominięto 2 podpisy.",]
    );
    for language in Wording::languages() {
        assert_eq!(told(language).len(), 3, "{language}");
    }
}

/// The sum of all sheets is written on each of them: told as that of a sheet, four of them had four times as much.
#[test]
fn what_all_sheets_together_lack_is_told_as_that() {
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
    let told = |set: Option<InSet>| {
        let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
        let mut origin = LeftOut { millimetres: 623, of: 5664, ..LeftOut::default() }.to_origin();
        origin.extend(set.iter().map(InSet::to_origin));
        let page = Page::new(Parts { origin, ..Parts::of([150.0, 150.0], figure) }).expect("it is on the sheet");
        let all = marks(&page, Wording::english()).into_iter();
        all.filter(|(about, _)| *about == "left-out").map(|(_, text)| text).collect::<Vec<_>>()
    };
    assert_eq!(told(None), ["623 mm of contours, 11 %, had no room and are left out."]);
    let names = ["a1", "a2", "b1", "b2"].map(str::to_owned).to_vec();
    let one = told(Some(InSet::One("b1".to_owned(), names)));
    assert_eq!(one, ["On all 4 sheets together 623 mm of contours, 11 %, had no room and are left out."]);
}
