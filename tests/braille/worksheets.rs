//! Worksheets as teachers make them: what the colours of a legend and of the routes of a map mean.

use super::labels::options;
use std::fmt::Write as _;
use tactograph::{Drawing, convert};

pub(super) const PROFILES: [&str; 4] = ["swell-a4", "index-basic-d", "viewplus-columbia", "dot-pad"];

/// A drawing of this size around these marks.
pub(super) fn svg([width, height]: [f32; 2], marks: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' font-family='sans-serif' \
         font-size='18'><rect width='{width}' height='{height}' fill='#fff'/>{marks}</svg>"
    )
}

pub(super) fn drawn(svg: &str, profile: &str) -> Drawing {
    convert(svg.as_bytes(), &options(profile).label_texts(true)).expect("a page")
}

pub(super) fn notes(drawing: &Drawing) -> String {
    drawing.notes.iter().map(|note| format!("{note}\n")).collect()
}

/// A name, its place and that of its text.
pub(super) type Stop = (&'static str, (f32, f32), (f32, f32));

pub(super) const MAP: [f32; 2] = [800.0, 560.0];
/// Name and place of each stop, and where its name is written.
pub(super) const STOPS: [Stop; 12] = [
    ("Harbour", (60.0, 120.0), (60.0, 104.0)),
    ("Town Hall", (220.0, 120.0), (220.0, 104.0)),
    ("Central Station", (380.0, 240.0), (460.0, 226.0)),
    ("Museum", (560.0, 240.0), (560.0, 224.0)),
    ("Zoo", (740.0, 400.0), (712.0, 386.0)),
    ("School", (120.0, 480.0), (120.0, 512.0)),
    ("Park", (300.0, 400.0), (334.0, 388.0)),
    ("Library", (480.0, 120.0), (528.0, 128.0)),
    ("Mill", (60.0, 320.0), (60.0, 304.0)),
    ("Bridge", (220.0, 320.0), (220.0, 304.0)),
    ("Hospital", (500.0, 460.0), (500.0, 444.0)),
    ("Airport", (720.0, 500.0), (720.0, 532.0)),
];

/// A map of three routes, each in its colour, with names beside their stops.
pub(super) fn map(colours: [&str; 3]) -> String {
    let routes = [
        "60,120 220,120 380,240 560,240 740,400",
        "120,480 300,400 380,240 480,120 560,60",
        "60,320 220,320 300,400 500,460 720,500",
    ];
    let mut marks = String::new();
    for (route, colour) in routes.iter().zip(colours) {
        write!(marks, "<polyline points='{route}' fill='none' stroke='{colour}' stroke-width='6'/>").expect("text");
    }
    for (name, (x, y), (left, base)) in STOPS {
        write!(
            marks,
            "<circle cx='{x}' cy='{y}' r='8' fill='#fff' stroke='#000' stroke-width='3'/>\
             <text x='{left}' y='{base}' text-anchor='middle'>{name}</text>"
        )
        .expect("text");
    }
    svg(MAP, &marks)
}

/// That fingers do not feel which route is which is told once, and only of lines whose colours differ.
#[test]
fn routes_of_several_colours_are_told() {
    let count = |svg: &str| notes(&drawn(svg, "swell-a4")).matches("are alike on the page").count();
    let told = notes(&drawn(&map(["#d22", "#22c", "#191"]), "swell-a4"));
    assert!(told.contains("lines of 3 colours (blue, green and red) are alike on the page"), "{told}");
    assert_eq!(count(&map(["#d22", "#22c", "#191"])), 1);
    assert_eq!(count(&map(["#d22", "#d22", "#000"])), 0, "one colour, and black");
    let outlines = "<rect x='60' y='60' width='200' height='200' fill='#fa8' stroke='#d22' stroke-width='6'/>\
        <rect x='400' y='60' width='200' height='200' fill='#8af' stroke='#22c' stroke-width='6'/>";
    assert_eq!(count(&svg(MAP, outlines)), 0, "outlines of areas that have textures");
}

pub(super) const PIE: [f32; 2] = [720.0, 480.0];

/// A pie of these shares and colours, each with its name: in a legend, or in its sector.
pub(super) fn pie(parts: &[(&str, f32, &str)], has_legend: bool) -> String {
    let whole: f32 = parts.iter().map(|(_, share, _)| share).sum();
    let (x, y, radius) = (240.0, 240.0, 180.0);
    let mut marks = String::new();
    let mut from = 0.0_f32;
    for (number, (name, share, colour)) in parts.iter().enumerate() {
        let to = from + std::f32::consts::TAU * share / whole;
        let on = |angle: f32, share: f32| {
            let (sin, cos) = angle.sin_cos();
            (x + share * radius * sin, y - share * radius * cos)
        };
        let (start, end, large) = (on(from, 1.0), on(to, 1.0), u8::from(2.0 * share > whole));
        write!(
            marks,
            "<path d='M{x},{y}L{},{}A{radius},{radius} 0 {large} 1 {},{}Z' fill='{colour}' stroke='#fff' \
             stroke-width='2'/>",
            start.0, start.1, end.0, end.1
        )
        .expect("text");
        let top = 140 + 34 * number;
        let middle = on(0.5 * (from + to), 0.65);
        if has_legend {
            write!(
                marks,
                "<rect x='500' y='{top}' width='20' height='20' fill='{colour}'/><text x='530' y='{}'>{name}</text>",
                top + 16
            )
            .expect("text");
        } else {
            write!(marks, "<text x='{}' y='{}' text-anchor='middle'>{name}</text>", middle.0, middle.1 + 6.0)
                .expect("text");
        }
        from = to;
    }
    svg(PIE, &marks)
}

/// The key tells which texture has which meaning in a legend, whose own patches are too small for textures.
#[test]
fn the_key_tells_what_the_colours_of_a_legend_mean() {
    let parts = [("Walk", 35.0, "#d33"), ("Bus", 25.0, "#36c"), ("Bike", 22.0, "#3a3"), ("Car", 18.0, "#ec2")];
    let svg = pie(&parts, true);
    for profile in PROFILES {
        let drawing = drawn(&svg, profile);
        let texts: Vec<&str> =
            drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
        for meaning in ["red: Walk", "blue: Bus", "green: Bike", "yellow: Car"] {
            assert!(texts.contains(&meaning), "{profile}: {texts:?}\n{}", notes(&drawing));
        }
    }
    // two that have one texture are told, as are all where there is no key
    let alike = [("Walk", 35.0, "#d33"), ("Bus", 25.0, "#36c"), ("Bike", 22.0, "#26f"), ("Car", 18.0, "#ec2")];
    let told = notes(&drawn(&pie(&alike, true), "swell-a4"));
    assert!(told.contains("(\"Bus\", \"Bike\"), as these colours have one texture"), "{told}");
    let without = options("swell-a4").label_texts(true).key(tactograph::KeySheets::Never);
    let told = notes(&convert(svg.as_bytes(), &without).expect("a page"));
    assert!(told.contains("what the colours of the legend mean (\"Walk\", \"Bus\", \"Bike\", \"Car\")"), "{told}");
    // bars of one colour with words beside them are no legend
    let bars = "<g fill='#36c'><rect x='60' y='60' width='30' height='30'/>\
        <rect x='60' y='120' width='30' height='30'/><rect x='60' y='200' width='400' height='200'/></g>\
        <text x='96' y='82'>two</text><text x='96' y='142'>ten</text>";
    let drawing = drawn(&self::svg(PIE, bars), "swell-a4");
    assert!(drawing.key.is_empty() && !notes(&drawing).contains("legend"), "{}", notes(&drawing));
}

/// On a map the town beside its name has the colour of the sample for towns, and a line is named by its colour.
#[test]
fn a_legend_of_a_map_may_have_samples_of_lines_and_signs() {
    let mut marks = String::from(
        "<rect x='20' y='20' width='560' height='440' fill='#8ec5ff'/>\
         <path d='M90 110C160 50 300 60 380 90C480 120 550 190 520 290C490 390 360 430 240 410C130 390 60 320 60 230Z' \
         fill='#b7e08a' stroke='#000' stroke-width='2'/>\
         <path d='M150 300C190 260 250 280 270 320C260 370 180 380 150 340Z' fill='#f3e06a' stroke='#000'/>\
         <path d='M330 250C310 300 330 340 300 410' fill='none' stroke='#1a5fd0' stroke-width='5'/>\
         <circle cx='140' cy='180' r='7' fill='red'/><text x='152' y='186'>Norton</text>\
         <circle cx='430' cy='320' r='7' fill='red'/><text x='394' y='350'>Easton</text>\
         <rect x='600' y='60' width='180' height='190' fill='#fff' stroke='#000'/>\
         <text x='690' y='88' text-anchor='middle'>Legend</text>",
    );
    for (y, colour, word) in [(105, "#b7e08a", "Grass"), (137, "#f3e06a", "Desert"), (169, "#8ec5ff", "Sea")] {
        let patch = format!("<rect x='615' y='{y}' width='34' height='22' fill='{colour}' stroke='#000'/>");
        write!(marks, "{patch}<text x='660' y='{}'>{word}</text>", y + 17).expect("text");
    }
    marks += "<path d='M615 212H649' stroke='#1a5fd0' stroke-width='5'/><text x='660' y='218'>River</text>\
              <circle cx='632' cy='234' r='6' fill='red'/><text x='660' y='240'>Town</text>";
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = drawn(&svg([800.0, 480.0], &marks), profile);
        let told = notes(&drawing);
        for wanted in [
            "the legend in the figure (\"Grass\", \"Desert\", \"Sea\")",
            "the key has it, but not its heading \"Legend\"",
            "the legend of lines in the figure (\"River\")",
            "the samples of signs in the legend (\"Town\")",
        ] {
            assert!(told.contains(wanted), "{profile}: {wanted}\n{told}");
        }
        let of_key: Vec<&str> =
            drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
        assert!(["green: Grass", "blue: Sea"].iter().all(|meaning| of_key.contains(meaning)), "{profile}: {of_key:?}");
        let labels: Vec<&str> = drawing.page.braille.iter().map(|text| text.text.as_str()).collect();
        assert!(labels.contains(&"River") && !labels.contains(&"Town"), "{profile}: {labels:?}\n{told}");
        let figure = drawing.page.figure.place;
        let left = figure.min.x + 590.0 / 800.0 * figure.width();
        let mut points = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        assert!(points.all(|at| at.x < left), "{profile}: {told}");
    }
}
