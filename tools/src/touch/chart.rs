//! The chart of the textures: five colours, all densities, three lightnesses.

use std::fmt::Write;

use tactograph::internals::output::svg;
use tactograph::internals::page::{Class, Figure, Page, Parts};
use tactograph::internals::textures::{Params, sample};
use tactograph::internals::units::{MmPoint, MmRect, MmVector, Size};

/// Width and height of a sample, and how far apart they lie, mm.
const SAMPLE: [f32; 2] = [44.0, 24.0];
const STEP: [f32; 2] = [47.0, 27.0];
/// Room for words at the left and at the top, mm.
const LEFT: f32 = 30.0;
const TOP: f32 = 16.0;

const DENSITIES: [(f32, &str); 4] =
    [(0.0, "far from lines"), (0.15, "nearer"), (0.3, "nearer still"), (1.0, "near lines")];
const LIGHTNESSES: [(f32, &str); 3] = [(0.85, "pale"), (0.5, "pure"), (0.2, "dark")];

/// A page with one texture on it.
pub fn page_of_sample(class: Class, lightness: f32, density: f32, place: MmRect, params: &Params) -> Page {
    let texture = sample(class, lightness, density, place, params);
    let figure = Figure { place, source: Size::new(1, 1), textures: vec![texture], lines: Vec::new() };
    let parts = Parts::of([place.max.x + place.min.x, place.max.y + place.min.y], figure);
    Page::new(Parts { title: class.name().into(), ..parts }).expect("a sample lies on its sheet")
}

/// The chart as an SVG drawing in millimetres.
pub fn chart(params: &Params) -> String {
    let rows = Class::ALL.len() * LIGHTNESSES.len();
    let (width, height) = (LEFT + STEP[0] * DENSITIES.len() as f32, TOP + STEP[1] * rows as f32);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"4.5\">\n<title>The five textures at every density, pale, pure and dark</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for (column, (_, words)) in DENSITIES.iter().enumerate() {
        let x = LEFT + STEP[0] * column as f32;
        let _ = writeln!(text, "<text x=\"{x}\" y=\"{}\">{words}</text>", TOP - 5.0);
    }
    for (row, (class, (lightness, words))) in
        Class::ALL.iter().flat_map(|class| LIGHTNESSES.iter().map(move |light| (class, light))).enumerate()
    {
        let y = TOP + STEP[1] * row as f32;
        let _ = writeln!(text, "<text x=\"3\" y=\"{}\">{}, {words}</text>", y + 0.5 * SAMPLE[1], class.name());
        for (column, (density, _)) in DENSITIES.iter().enumerate() {
            let low = MmPoint::new(LEFT + STEP[0] * column as f32, y);
            let place = MmRect::new(low, low + MmVector::new(SAMPLE[0], SAMPLE[1]));
            let page = page_of_sample(*class, *lightness, *density, place, params);
            let drawn = svg::write(&page);
            let path = drawn.split("<path").nth(1).and_then(|rest| rest.split("/>").next()).unwrap_or_default();
            let _ = writeln!(
                text,
                "<rect x=\"{}\" y=\"{y}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#bbb\" stroke-width=\"0.2\"/>\n<path{path}/>",
                low.x, SAMPLE[0], SAMPLE[1]
            );
        }
    }
    text.push_str("</svg>\n");
    text
}
