//! Tests of `description`.

use super::*;
use crate::page::{Figure, Medium, Parts, Print, Run};
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
