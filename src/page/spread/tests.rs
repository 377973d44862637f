//! Tests of `spread`.

use super::*;
use crate::page::{Class, Shape, Sign};

fn rect() -> MmRect {
    MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(10.0, 10.0))
}

#[test]
fn a_line_is_cut_into_what_lies_in_the_window() {
    let at = |x, y| MmPoint::new(x, y);
    let zigzag = [at(-5.0, 5.0), at(5.0, 5.0), at(15.0, 5.0), at(15.0, 8.0), at(5.0, 8.0)];
    let cut = |vertices: &[MmPoint], closed| cut_polyline(PolylineRef { vertices, closed }, rect());
    let pieces = cut(&zigzag, false);
    assert_eq!(pieces, [vec![at(0.0, 5.0), at(5.0, 5.0), at(10.0, 5.0)], vec![at(10.0, 8.0), at(5.0, 8.0)]]);
    assert!(cut(&[at(-1.0, 11.0), at(12.0, 10.5)], false).is_empty());
    let ring = [at(2.0, 2.0), at(8.0, 2.0), at(8.0, 8.0)];
    assert_eq!(cut(&ring, true), [vec![ring[0], ring[1], ring[2], ring[0]]], "what lies within stays as it is");
}

fn params() -> Params {
    Params {
        sheet: [210.0, 297.0],
        orientation: Orientation::Portrait,
        margin: 10.0,
        frame: None,
        overview: None,
        mark: None,
        heading: None,
        medium: MediumParams::Print(Print::default()),
    }
}

fn spread(aspect: f32, grid: &str, params: &Params) -> Spread {
    fit(aspect, f32::MAX, grid.parse().expect("a grid"), 15.0, params).expect("room")
}

#[test]
fn sheets_lie_as_they_are_asked_to() {
    let on = |orientation| spread(1.0, "2x1", &Params { orientation, ..params() });
    assert_eq!(on(Orientation::Portrait).sheet.to_vec(), [210.0, 297.0]);
    assert_eq!(on(Orientation::Landscape).sheet.to_vec(), [297.0, 210.0]);
    // the one of which the picture is larger
    let [upright, across] = [Orientation::Portrait, Orientation::Landscape].map(on);
    let larger = if across.figure.width() > upright.figure.width() { across } else { upright };
    assert_eq!(on(Orientation::Auto), larger);
}

#[test]
fn tiles_touch_in_the_middle_of_overlaps_and_cover_all_windows() {
    let spread = spread(1.0, "2x2", &params());
    let tiles = spread.tiles();
    let [a, b, c, d] = tiles[..] else { panic!("four sheets") };
    assert!((a.max.x - b.min.x).abs() < 1e-3 && (c.max.x - d.min.x).abs() < 1e-3, "{tiles:?}");
    assert!((a.max.y - c.min.y).abs() < 1e-3 && (b.max.y - d.min.y).abs() < 1e-3, "{tiles:?}");
    assert!((a.max.x - (spread.first.max.x - 7.5)).abs() < 1e-3, "half of the overlap: {a:?}");
    assert_eq!((a.min, d.max), (spread.window(0, 0).min, spread.window(1, 1).max));
}

#[test]
fn each_sheet_shows_its_part_where_its_window_is() {
    let spread = spread(1.0, "2x1", &params());
    let place = spread.figure;
    let glyph = |share: f32| Glyph {
        at: MmPoint::new(place.min.x + share * place.width(), place.center().y),
        shape: Shape::Dot { diameter: 1.0 },
    };
    // three of four on the left sheet
    let glyphs = [0.05, 0.1, 0.15, 0.9].map(glyph).to_vec();
    let texture = Texture { class: Class::Red, sign: Sign::Dot, colour: [255, 0, 0], area: 400.0, glyphs };
    let figure = Figure { place, source: Size::new(400, 400), textures: vec![texture], lines: Vec::new() };
    let cuts = spread.cut(&figure, &Dots::default(), &[]);
    let [left, right] = &cuts[..] else { panic!("two sheets") };
    let window = MmRect::new(spread.corner, spread.corner + spread.first.size().to_vector());
    assert!((left.figure.place.max.x - window.max.x).abs() < 1e-3, "it goes on to the right");
    assert!((right.figure.place.min.x - window.min.x).abs() < 1e-3, "it goes on to the left");
    assert!([left, right].iter().all(|cut| window.inflate(1e-3, 1e-3).contains_box(&cut.figure.place)));
    let areas: Vec<f32> = cuts.iter().map(|cut| cut.figure.textures[0].area).collect();
    assert_eq!(areas, [300.0, 100.0]);
    for cut in [left, right] {
        let Figure { place: part, source, .. } = &cut.figure;
        assert!((source.width as f32 / 400.0 - part.width() / place.width()).abs() < 0.005, "{source:?}");
        assert!((source.height as f32 / 400.0 - part.height() / place.height()).abs() < 0.005, "{source:?}");
    }
}

#[test]
fn a_piece_that_is_shorter_than_wide_is_left_out() {
    let line = |to: f32| Line {
        strength: 20.0,
        runs: vec![Run::stroke(1.0, vec![MmPoint::new(-5.0, 5.0), MmPoint::new(to, 5.0)])],
    };
    assert_eq!(cut_line(&line(6.0), rect()).len(), 1);
    assert_eq!(cut_line(&line(1.2), rect()), []);
}

/// It is read back from the name alone where a page is drawn anew.
#[test]
fn the_name_of_a_sheet_stands_in_its_corner_within_the_margin() {
    let device = crate::devices::Device::named("index-basic-d-v5").expect("a device");
    let dots = Params { medium: MediumParams::Dots { device, pitch: 2.0 }, margin: 6.0, ..params() };
    for params in [params(), dots] {
        let spread = spread(1.0, "2x2", &params);
        let figure = Figure { place: spread.figure, source: Size::new(9, 9), textures: Vec::new(), lines: Vec::new() };
        let cuts = spread.cut(&figure, &Dots::default(), &[]);
        assert_eq!(cuts.iter().map(|cut| &cut.name[..]).collect::<Vec<_>>(), ["a1", "a2", "b1", "b2"]);
        let corner = match &spread.medium {
            Medium::Print(_) => MmPoint::zero(),
            Medium::Dots(medium) => medium.usable().min,
        };
        for cut in &cuts {
            assert_eq!(label(&cut.name, &spread.medium, params.margin).as_ref(), Some(&cut.label), "{}", cut.name);
            let first = |of: fn(&MmPoint) -> f32| cut.label.at.iter().map(of).fold(f32::MAX, f32::min);
            let off = [first(|at| at.x) - corner.x, first(|at| at.y) - corner.y];
            assert!(off.iter().all(|mm| (params.margin..params.margin + 3.0).contains(mm)), "{}: {off:?}", cut.name);
        }
        let marks: Vec<&Dots> = cuts.iter().map(|cut| &cut.label).collect();
        assert!((0..4).all(|a| (0..a).all(|b| marks[a] != marks[b])));
        let are_none = ["", "a", "a0", "a10", "A1", "1a"];
        assert!(are_none.iter().all(|name| label(name, &spread.medium, params.margin).is_none()));
    }
}
