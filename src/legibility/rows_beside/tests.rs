//! Tests of `rows_beside`.

use super::*;
use crate::page::{Class, DotMedium, Figure, Glyph, Height, Parts, Run, Shape, Sign, Texture};
use crate::profile::{Plan, Profile};
use crate::units::Size;

/// Dots from left to right, `step` mm apart.
fn row(y: f32, step: f32) -> Vec<MmPoint> {
    (0..20).map(|k| MmPoint::new(20.0 + step * k as f32, y)).collect()
}

/// What is found on a page of a built-in profile with one line of these rows, and a texture of these dots.
fn share(profile: &str, line: &[f32], texture: Vec<MmPoint>) -> Option<f32> {
    let profile = Profile::named(profile).expect("it is built in");
    let device = profile.dots.device.expect("a profile of dots");
    let (pitch, sheet) = if device.has_heights() { (1.27, [279.4, 292.1]) } else { (2.0, [210.0, 297.0]) };
    let medium = DotMedium::on(device, pitch, sheet).expect("a sheet that it takes");
    let runs = line.iter().map(|y| Run::dots(1.6, row(*y, 2.0), Height::High)).collect();
    let glyph = |at| Glyph { at, shape: Shape::Dot { diameter: 1.6 } };
    let texture = Texture {
        class: Class::ALL[0],
        sign: Sign::Dot,
        colour: [0, 0, 200],
        area: 400.0,
        glyphs: texture.into_iter().map(glyph).collect(),
    };
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(150.0, 150.0));
    let lines = vec![Line { strength: 50.0, runs }];
    let figure = Figure { place, source: Size::new(1, 1), textures: vec![texture], lines };
    let mut parts = Parts::of(sheet, figure);
    parts.medium = Medium::Dots(medium);
    let page = Page::new(parts).expect("it is on the sheet");
    too_many(&page, &Plan::new(&profile).expect("it is right").limits())
}

#[test]
fn rows_beside_a_line_drown_it_and_those_farther_off_do_not() {
    // from dot to dot 6 mm are 4.4 mm of blank, and 8 mm are 6.4 mm
    let both = |off: f32, step: f32| [row(60.0 - off, step), row(60.0 + off, step)].concat();
    assert_eq!(share("index-basic-d", &[60.0], both(6.0, 2.0)), Some(1.0));
    assert_eq!(share("index-basic-d", &[60.0], both(8.0, 2.0)), None);
    assert_eq!(share("index-basic-d", &[60.0], row(66.0, 2.0)), None, "its other side is blank, as of an outline");
}

#[test]
fn beside_a_tenth_of_a_line_is_not_too_much() {
    // rows of six dots on both sides, the first so far before the beginning of a line of 20: its dots up to 2.7 mm
    // beyond the last lie beside them
    let some = |before: f32| {
        let moved = |y: f32| row(y, 2.0).into_iter().take(6).map(move |at| MmPoint::new(at.x - before, at.y));
        [54.0, 66.0].into_iter().flat_map(moved).collect::<Vec<_>>()
    };
    assert_eq!(share("index-basic-d", &[60.0], some(10.0)), None);
    assert!(share("index-basic-d", &[60.0], some(6.0)).is_some_and(|share| (share - 0.2).abs() < 0.01));
}

#[test]
fn dots_that_stand_apart_and_lines_of_two_rows_are_told_from_one_another() {
    let both = |below: f32, step: f32| [row(54.0, step), row(below, step)].concat();
    assert_eq!(share("index-basic-d", &[60.0], both(66.0, 4.0)), None, "single dots are no row");
    assert_eq!(share("index-basic-d", &[60.0, 62.0], both(66.0, 2.0)), None, "a line of two rows stands out");
}

#[test]
fn where_dots_have_heights_textures_are_lower() {
    assert_eq!(share("viewplus-columbia", &[60.0], [row(54.0, 2.0), row(66.0, 2.0)].concat()), None);
}
