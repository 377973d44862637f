//! Every rule is found: for each there is a page that breaks it.

use crate::common::{page, samples};
use tactograph::internals::page::{Line, Page, Parts, Run, Shape, TextRole};
use tactograph::internals::units::MmPoint;
use tactograph::{Options, PageOptions, Profile, Rule, check};

/// The page of a sample for swell paper with one thing changed.
fn with(sample: &str, change: impl FnOnce(&mut Parts)) -> String {
    changed(page::of_sample(sample, "swell-a4").page.clone(), change)
}

fn changed(page: Page, change: impl FnOnce(&mut Parts)) -> String {
    let mut parts = Parts::clone(&page);
    change(&mut parts);
    Page::new(parts).expect("a page").to_svg()
}

/// A page with a title in braille.
fn titled() -> Page {
    let options = Options::new(Profile::named("swell-a4").expect("it is built in")).title("A cell");
    tactograph::convert(&samples::read("cell.svg"), &options).expect("a page").page
}

/// The same with something added behind all else.
fn and(svg: &str, added: &str) -> String {
    svg.replacen("</svg>", &format!("{added}</svg>"), 1)
}

/// The page of bars with lines along these paths below the figure, 1 mm wide.
fn with_lines(paths: &[&str]) -> String {
    let lines = paths.iter().map(|d| format!("<path d=\"{d}\" fill=\"none\" stroke=\"#000\" stroke-width=\"1\"/>"));
    and(&with("bars.svg", |_| ()), &lines.collect::<String>())
}

fn line(from: MmPoint, to: MmPoint) -> Line {
    Line { strength: 50.0, runs: vec![Run::stroke(1.0, vec![from, to])] }
}

fn set_shapes(parts: &mut Parts, shape: impl Fn(usize) -> Shape) {
    let glyphs = parts.figure.textures.iter_mut().flat_map(|texture| &mut texture.glyphs);
    glyphs.enumerate().for_each(|(number, glyph)| glyph.shape = shape(number));
}

/// A page that breaks a rule, as an SVG.
fn broken(rule: &str) -> String {
    const DOT: &str =
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";
    match rule {
        "layers" => {
            "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='90mm'><path d='M9 9h9v9z'/></svg>".into()
        }
        "empty" => with("bars.svg", |parts| {
            (parts.figure.lines, parts.figure.textures, parts.overview) = (Vec::new(), Vec::new(), None);
        }),
        "black-only" => with("bars.svg", |_| ()).replacen("stroke=\"#000000\"", "stroke=\"#777777\"", 1),
        "picture" => {
            let href = format!("href=\"data:image/png;base64,{DOT}\"");
            and(&with("bars.svg", |_| ()), &format!("<image x=\"60\" y=\"240\" width=\"20\" height=\"20\" {href}/>"))
        }
        "letters" => and(&with("bars.svg", |_| ()), "<text x=\"30\" y=\"40\">Rain</text>"),
        "elsewhere" => and(&with("bars.svg", |_| ()), "<use href=\"other.svg#cup\" x=\"60\" y=\"240\"/>"),
        "filled" => and(&with("bars.svg", |_| ()), "<path d=\"M40,235 h60 v20 h-60 z\" fill=\"#000\"/>"),
        "line-gap" => with_lines(&["M60,250 H120", "M60,252 H120"]),
        "line-width" => with_lines(&["M60,250 H120"]).replace("stroke-width=\"1\"", "stroke-width=\"0.2\""),
        "line-length" => with_lines(&["M60,250 H63"]),
        "broken-line" => with_lines(&["M60,250 H87", "M93,250 H120"]),
        "loose-ends" => with("coffee.png", |parts| {
            let min = parts.figure.place.min.to_vector();
            let at = |k: usize| MmPoint::new(15.0 + 20.0 * (k % 8) as f32, 15.0 + 14.0 * (k / 8) as f32) + min;
            let scrap = |at: MmPoint| line(at, at + MmPoint::new(10.0, 0.0).to_vector());
            parts.figure.lines = (0..48).map(at).map(scrap).collect();
        }),
        "margin" => with_lines(&["M60,292 H120"]),
        "overlap" => with_lines(&["M60,250 H120", "M60,250 H120"]),
        "texture-gap" => with("coffee.png", |parts| {
            let at = parts.figure.textures[0].glyphs[0].at;
            parts.figure.lines.push(line(at, at + MmPoint::new(9.0, 0.0).to_vector()));
        }),
        "texture-area" => with("coffee.png", |parts| parts.figure.textures.iter_mut().for_each(|of| of.area = 60.0)),
        "texture-sign" => with("coffee.png", |parts| {
            let own = parts.figure.textures[0].class;
            let mut others = parts.figure.textures.iter().map(|texture| texture.class);
            parts.figure.textures[0].class = others.find(|class| *class != own).expect("two colours");
        }),
        "mark-size" => with("coffee.png", |parts| {
            set_shapes(parts, |_| Shape::Rhombus { length: 3.0, thickness: 0.2, degrees: 0.0 })
        }),
        "textures" => with("coffee.png", |parts| {
            set_shapes(parts, |number| Shape::Rhombus {
                length: 2.0,
                thickness: 0.8,
                degrees: 25.0 * (number % 7) as f32,
            })
        }),
        "black" => with("coffee.png", |parts| {
            parts.figure.lines.iter_mut().flat_map(|line| &mut line.runs).for_each(|run| run.width = 30.0);
        }),
        "braille-cell" => {
            and(&with("bars.svg", |_| ()), "<text x=\"30\" y=\"240\" font-size=\"6\">\u{2817}\u{2801}</text>")
        }
        "braille-gap" => changed(titled(), |parts| {
            let at = parts.braille[0].dots.at[0];
            parts.figure.lines.push(line(at, at + MmPoint::new(20.0, 0.0).to_vector()));
        }),
        "lines-among-rows" => changed(page::of_sample("coffee.png", "index-basic-d").page.clone(), |parts| {
            // those of two rows stand out
            parts.figure.lines.iter_mut().for_each(|line| line.runs.truncate(1));
        }),
        "label-line" => changed(titled(), |parts| {
            (parts.figure.lines, parts.figure.textures) = (parts.figure.lines[..1].to_vec(), Vec::new());
            let (label, to) = (&mut parts.braille[0], parts.figure.place.min + MmPoint::new(8.0, 8.0).to_vector());
            label.leader = Some(Run::stroke(1.0, vec![label.dots.at[0] + MmPoint::new(0.0, 12.0).to_vector(), to]));
            label.role = TextRole::Label;
        }),
        "left-out" => {
            let svg = with("bars.svg", |_| ());
            svg.replacen("<metadata>", "<metadata>contours left out in mm = 300 of 500\n", 1)
        }
        "overview" => with("cell.svg", |parts| parts.figure.lines.truncate(1)),
        "overview-lacks" => with("landscape.svg", |parts| {
            parts.overview.as_mut().expect("there is one").lines.truncate(1);
        }),
        _ => panic!("no page here breaks the rule {rule}"),
    }
}

#[test]
fn every_rule_is_found_on_a_page_that_breaks_it() {
    let mut missed = Vec::new();
    for rule in Rule::all() {
        let checked = check(broken(rule.id), &PageOptions::new()).expect("it can be read");
        if !checked.findings.iter().any(|finding| finding.rule == *rule) {
            missed.push(format!("{}: {checked}", rule.id));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}
