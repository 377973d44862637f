//! Tests of `areas`.

use super::*;
use crate::page::{Class, Figure, Palette, Parts};
use crate::profile::{Plan, Profile};

/// A texture over a box of left, top, width and height, mm: signs in a square of this step.
fn texture(class: Class, [left, top, width, height]: [f32; 4], step: f32) -> Texture {
    let sign = Palette::PAPER.sign(class);
    let shape = match Palette::PAPER.degrees(class) {
        Some(degrees) => Shape::Rhombus { length: 2.4, thickness: 1.3, degrees },
        None => Shape::Dot { diameter: 1.5 },
    };
    let along = |from: f32, side: f32| (0..(side / step) as u32).map(move |k| from + (k as f32 + 0.5) * step);
    let row = |y: f32| along(left, width).map(move |x| Glyph { at: MmPoint::new(x, y), shape });
    let glyphs = along(top, height).flat_map(row).collect();
    Texture { class, sign, colour: [128; 3], area: width * height, glyphs }
}

fn page(textures: Vec<Texture>) -> Page {
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(110.0, 110.0));
    let figure = Figure { place, source: Size::new(100, 100), textures, lines: Vec::new() };
    Page::new(Parts::of([120.0, 120.0], figure)).expect("a page")
}

fn plan() -> Plan {
    Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("a plan")
}

/// The number of the area at a place.
fn area_at(areas: &PageAreas, x: f32, y: f32) -> Option<u32> {
    areas.classes.region[(y - 10.0) as usize * areas.classes.size.width as usize + (x - 10.0) as usize]
}

fn names(page: &Page) -> Vec<String> {
    crate::page::Names::of(page).areas
}

const LARGE: [f32; 4] = [20.0, 20.0, 60.0, 60.0];

#[test]
fn an_area_that_was_moved_onto_a_larger_one_is_whole() {
    let (large, small) = (texture(Class::Red, LARGE, 3.0), texture(Class::Grey, [40.0, 40.0, 20.0, 20.0], 3.7));
    for (textures, number) in [(vec![large.clone(), small.clone()], 1_usize), (vec![small, large], 0)] {
        let page = page(textures);
        let areas = of_page(&page, &plan());
        assert_eq!(areas.lies_on[number], [1 - number as u32]);
        for (x, y) in (42..58).flat_map(|y| (42..58).map(move |x| (x, y))) {
            let found = area_at(&areas, x as f32 + 0.5, y as f32 + 0.5);
            assert_eq!(found, Some(number as u32), "{x}, {y}");
        }
        let cells = |number: usize| areas.classes.regions[number].cells as f32;
        assert!((cells(number) / 400.0 - 1.0).abs() < 0.03, "{} cells", cells(number));
        assert!((cells(1 - number) / 3200.0 - 1.0).abs() < 0.03, "{} cells under it", cells(1 - number));
        assert!(lost(&page, &areas).is_empty());
    }
}

#[test]
fn an_area_under_its_copy_is_told_by_name() {
    let (own, copy) = (texture(Class::Red, LARGE, 3.0), texture(Class::Blue, LARGE, 3.0));
    let page = page(vec![own, copy]);
    let areas = of_page(&page, &plan());
    assert_eq!((area_at(&areas, 50.0, 50.0), areas.classes.regions[0].cells), (Some(1), 0));
    let told = told_lost(&page, &areas, &names(&page), &lost(&page, &areas));
    let told: Vec<String> = told.iter().map(ToString::to_string).collect();
    assert!(matches!(&told[..], [one] if one.contains("the texture of red area 1 (under blue area 1)")), "{told:?}");
}

#[test]
fn an_area_is_as_large_after_ten_pages() {
    let plan = plan();
    let mut made = page(vec![texture(Class::Red, LARGE, 3.0)]);
    for _ in 0..10 {
        let Classes { size, .. } = of_page(&made, &plan).classes;
        assert_eq!(size, Size::new(100, 100));
        made = page(crate::textures::fill(&of_page(&made, &plan).classes, made.figure.place, &[], &plan.textures()));
    }
    let area = made.figure.textures[0].area;
    assert!((area / 3600.0 - 1.0).abs() < 0.01, "{area} square mm");
}

#[test]
fn areas_side_by_side_lie_on_none() {
    // signs nearly as near as they are set: 0.7 mm apart at the border
    let beside = texture(Class::Blue, [79.5, 20.0, 20.0, 60.0], 3.0);
    let areas = of_page(&page(vec![texture(Class::Red, LARGE, 3.0), beside]), &plan());
    assert!(areas.lies_on.iter().all(Vec::is_empty), "{:?}", areas.lies_on);
    assert_eq!((area_at(&areas, 78.5, 50.5), area_at(&areas, 81.5, 50.5)), (Some(0), Some(1)));
}

#[test]
fn an_area_beside_the_figure_is_told() {
    let mut beside = texture(Class::Blue, [20.0, 20.0, 20.0, 20.0], 3.0);
    beside.glyphs.retain(|glyph| glyph.at.x < 30.0);
    beside.glyphs.iter_mut().for_each(|glyph| glyph.at.x = 2.0);
    let place = MmRect::new(MmPoint::new(30.0, 10.0), MmPoint::new(110.0, 110.0));
    let figure = Figure { place, source: Size::new(80, 100), textures: vec![beside], lines: Vec::new() };
    let page = Page::new(Parts::of([120.0, 120.0], figure)).expect("a page");
    let areas = of_page(&page, &plan());
    let told = told_lost(&page, &areas, &names(&page), &lost(&page, &areas));
    let told: Vec<String> = told.iter().map(ToString::to_string).collect();
    assert!(matches!(&told[..], [one] if one.contains("the texture of blue area 1, outside the figure")), "{told:?}");
}
