//! Pages that are refused, each with its reason.

use super::*;
use crate::devices::Device;
use crate::page::{Class, DotMedium, Figure, Overview, Print, PrintText};
use crate::units::Size;

fn parts() -> Parts {
    let at = MmPoint::new(50.0, 50.0);
    let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(80.0, 80.0));
    let line = || Line { strength: 20.0, runs: vec![Run::stroke(1.0, vec![at, MmPoint::new(60.0, 50.0)])] };
    let rhombus = Glyph { at, shape: Shape::Rhombus { length: 3.0, thickness: 1.0, degrees: 45.0 } };
    let dot = Glyph { at, shape: Shape::Dot { diameter: 1.0 } };
    let texture = Texture {
        class: Class::Green,
        sign: Sign::Rhombus { degrees: 45.0 },
        colour: [0, 200, 0],
        area: 100.0,
        glyphs: vec![rhombus, dot],
    };
    let figure = Figure { place, source: Size::new(60, 60), textures: vec![texture], lines: vec![line()] };
    let dots = || Dots { diameter: 1.0, at: vec![at] };
    Parts {
        frame: dots(),
        orientation_mark: Some(Run::stroke(1.0, vec![at])),
        registration: vec![Run::stroke(1.0, vec![at])],
        overview: Some(Overview { place, frame: dots(), lines: vec![line()] }),
        labels: vec![dots()],
        print: vec![PrintText { string: "cup".into(), at, size: 3.0 }],
        ..Parts::of([100.0, 100.0], figure)
    }
}

/// A number of a page: its name, and where it is.
type Number = (&'static str, fn(&mut Parts) -> &mut f32);

/// Every number of a page, each by itself.
fn numbers() -> Vec<Number> {
    fn rhombus(parts: &mut Parts) -> [&mut f32; 3] {
        match &mut parts.figure.textures[0].glyphs[0].shape {
            Shape::Rhombus { length, thickness, degrees } => [length, thickness, degrees],
            Shape::Dot { .. } => unreachable!("the first is a rhombus"),
        }
    }
    fn print(parts: &mut Parts) -> &mut Print {
        match &mut parts.medium {
            Medium::Print(print) => print,
            Medium::Dots(_) => unreachable!("it is printed"),
        }
    }
    vec![
        ("sheet", |parts| &mut parts.sheet[1]),
        ("frame", |parts| &mut parts.frame.diameter),
        ("frame's dot", |parts| &mut parts.frame.at[0].x),
        ("mark", |parts| &mut parts.orientation_mark.as_mut().expect("there is one").width),
        ("tick", |parts| &mut parts.registration[0].points[0].y),
        ("place", |parts| &mut parts.figure.place.max.x),
        ("line", |parts| &mut parts.figure.lines[0].runs[0].width),
        ("strength", |parts| &mut parts.figure.lines[0].strength),
        ("area", |parts| &mut parts.figure.textures[0].area),
        ("sign", |parts| match &mut parts.figure.textures[0].sign {
            Sign::Rhombus { degrees } => degrees,
            Sign::Dot => unreachable!("it is one of rhombuses"),
        }),
        ("glyph", |parts| &mut parts.figure.textures[0].glyphs[0].at.x),
        ("length", |parts| rhombus(parts).into_iter().next().expect("three")),
        ("thickness", |parts| rhombus(parts).into_iter().nth(1).expect("three")),
        ("degrees", |parts| rhombus(parts).into_iter().nth(2).expect("three")),
        ("diameter", |parts| match &mut parts.figure.textures[0].glyphs[1].shape {
            Shape::Dot { diameter } => diameter,
            Shape::Rhombus { .. } => unreachable!("the second is a dot"),
        }),
        ("overview", |parts| &mut parts.overview.as_mut().expect("there is one").place.min.y),
        ("overview's frame", |parts| &mut parts.overview.as_mut().expect("there is one").frame.diameter),
        ("overview's line", |parts| &mut parts.overview.as_mut().expect("there is one").lines[0].runs[0].width),
        ("label", |parts| &mut parts.labels[0].diameter),
        ("size of print", |parts| &mut parts.print[0].size),
        ("place of print", |parts| &mut parts.print[0].at.y),
        ("swell", |parts| &mut print(parts).swell),
        ("black", |parts| &mut print(parts).max_black),
    ]
}

#[test]
fn a_number_that_is_not_finite_is_refused_wherever_it_stands() {
    assert!(Page::new(parts()).is_ok());
    for (name, number) in numbers() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut parts = parts();
            *number(&mut parts) = bad;
            let refused = Page::new(parts);
            assert!(matches!(refused, Err(Error::NoMeasure { .. } | Error::OffSheet(_))), "{name} of {bad}");
        }
    }
}

#[test]
fn a_length_below_zero_is_refused() {
    for name in ["sheet", "frame", "mark", "line", "area", "sign", "length", "thickness", "diameter", "label"] {
        let (_, number) = numbers().into_iter().find(|(known, _)| *known == name).expect("in the list");
        let mut parts = parts();
        *number(&mut parts) = -1.0;
        let refused = Page::new(parts).expect_err(name);
        assert!(matches!(refused, Error::NoMeasure { value: -1.0, .. }), "{name}: {refused}");
    }
}

#[test]
fn dots_lie_on_columns_that_ascend() {
    let device = Device::named("graphiti").expect("in the table");
    let field = device.field().expect("a display has a field");
    let medium = DotMedium::on(device, 2.5, field).expect("its own sheet and pitch");
    for bad in [f32::NAN, 0.0, f32::INFINITY] {
        let of_pitch = Medium::Dots(DotMedium { pitch: bad, ..medium.clone() });
        let mut turned = medium.clone();
        let DotArea::Grid(grid) = &mut turned.area else { unreachable!("pins are a grid") };
        grid.columns[3] = bad;
        for medium in [of_pitch, Medium::Dots(turned)] {
            let place = MmRect::new(MmPoint::zero(), MmPoint::new(10.0, 10.0));
            let figure = Figure { place, source: Size::new(9, 9), textures: vec![], lines: vec![] };
            let refused = Page::new(Parts { medium, ..Parts::of(field, figure) });
            assert!(matches!(refused, Err(Error::NoMeasure { .. })), "{bad}: {refused:?}");
        }
    }
}
