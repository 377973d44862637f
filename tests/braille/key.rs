//! The key: everything that is abbreviated or coloured on a page is explained on the sheets that follow.

use super::{percent, reading};
use crate::common::samples;
use std::collections::BTreeSet;
use tactograph::internals::braille::{CellSize, Code, Table};
use tactograph::internals::page::cells::CellGrid;
use tactograph::internals::units::MmVector;
use tactograph::marks::{Shape, TextRole, Texture};
use tactograph::{Class, Drawing, Fonts, KeySheets, Label, MmPoint, MmRect, Options, Page, Profile, convert};

fn options(profile: &str, key: KeySheets) -> Options {
    Options::new(Profile::named(profile).expect("it is built in")).title("Trees").fonts(Fonts::system()).key(key)
}

fn table(language: &str) -> Table {
    Code::of_language(language).and_then(Code::table).expect("a table")
}

/// All texts of the key, as fingers read them.
fn read(key: &[Page], table: &Table) -> Vec<String> {
    let mut texts = Vec::new();
    for page in key {
        let size = CellGrid::of(&page.medium, CellSize::MARBURG).size();
        for text in page.braille.iter().filter(|text| text.role != TextRole::Number) {
            assert_eq!(text.role, TextRole::Key);
            let lines = reading::lines(&text.dots.at, size);
            // where a line begins is not read, and lines below an abbreviation are indented
            let written: Vec<&str> = text.lines.iter().map(|line| line.trim_start_matches('\u{2800}')).collect();
            assert_eq!(lines, written, "{}", text.text);
            let said = lines.join("\u{2800}");
            let plain = table.translate(&text.text.replacen(": ", "  ", 1)).unicode();
            let with_colon = table.translate(&text.text).unicode();
            let squeezed = said.replace("\u{2800}\u{2800}", "\u{2800}");
            assert!(squeezed == plain || said == with_colon, "{}: {said}", text.text);
            texts.push(text.text.clone());
        }
    }
    texts
}

fn classes(page: &Page) -> BTreeSet<Class> {
    page.figure.textures.iter().map(|texture| texture.class).collect()
}

/// The box around all signs of a texture, to their edges.
fn place_of(texture: &Texture) -> MmRect {
    let corners = texture.glyphs.iter().flat_map(|glyph| {
        let half = match glyph.shape {
            Shape::Dot { diameter } => MmVector::splat(0.5 * diameter),
            Shape::Rhombus { length, thickness, degrees } => {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let reach = |a: f32, b: f32| 0.5 * (length * a).abs().max((thickness * b).abs());
                MmVector::new(reach(cos, sin), reach(sin, cos))
            }
        };
        [glyph.at - half, glyph.at + half]
    });
    MmRect::from_points(corners)
}

/// Patches are as large as a texture needs, hold the figure's sign, and stand apart from one another and from words.
fn check_patches(drawing: &Drawing, name: &str) {
    let in_key: BTreeSet<Class> = drawing.key.iter().flat_map(classes).collect();
    assert_eq!(in_key, classes(&drawing.page), "{name}");
    for page in &drawing.key {
        let mut places: Vec<MmRect> = Vec::new();
        for texture in &page.figure.textures {
            let place = place_of(texture);
            assert!(place.width() >= 20.0 && place.height() >= 12.0, "{name}: {} {place:?}", texture.class.name());
            let in_figure = drawing.page.figure.textures.iter().find(|other| other.class == texture.class);
            assert_eq!(in_figure.map(|other| other.sign), Some(texture.sign), "{name}");
            places.push(place);
        }
        places.extend(page.braille.iter().map(|text| MmRect::from_points(&text.dots.at)));
        for (number, place) in places.iter().enumerate() {
            let near = |other: &&MmRect| other.inflate(1.5, 1.5).intersects(&place.inflate(1.0, 1.0));
            assert_eq!(places[..number].iter().find(near), None, "{name}: {place:?}");
        }
    }
}

#[test]
fn colours_and_abbreviations_are_explained_on_every_device() {
    let at = |x, y, text: &str| Label { x: percent(x), y: percent(y), text: text.to_owned() };
    let labels = vec![at(80.0, 60.0, "fir tree"), at(50.0, 87.0, "pond"), at(20.0, 42.0, "a very broad oak tree")];
    for profile in ["swell-a4", "viewplus-columbia", "index-basic-d", "braillerap", "pins-120x60"] {
        let options = options(profile, KeySheets::Always).labels(labels.clone());
        let drawing = convert(&samples::read("landscape.svg"), &options).expect("a page");
        let said = read(&drawing.key, &table("en"));
        assert_eq!(said.first().map(String::as_str), Some("Key: Trees"), "{profile}");
        for class in classes(&drawing.page) {
            assert!(said.iter().any(|text| text == class.name()), "{profile}: {}", class.name());
        }
        let abbreviated: Vec<_> = drawing.page.braille.iter().filter(|text| text.abbreviation.is_some()).collect();
        assert!(!abbreviated.is_empty(), "{profile}: nothing is abbreviated");
        for label in abbreviated {
            assert!(said.contains(&label.spoken()), "{profile}: {}", label.text);
        }
        check_patches(&drawing, profile);
    }
}

#[test]
fn a_key_is_there_when_it_is_wanted() {
    let picture = samples::read("landscape.svg");
    let of = |key, labels: Vec<Label>| {
        convert(&picture, &options("swell-a4", key).labels(labels).language("de")).expect("a page").key
    };
    let tight = || {
        let at = |x, text: &str| Label { x: percent(x), y: percent(60.0), text: text.to_owned() };
        vec![at(80.0, "ein sehr großer Tannenbaum"), at(81.0, "Zweig")]
    };
    assert!(of(KeySheets::Auto, Vec::new()).is_empty());
    assert!(of(KeySheets::Never, tight()).is_empty());
    assert_eq!(of(KeySheets::Auto, tight()).len(), 1);
    let always = of(KeySheets::Always, Vec::new());
    let said = read(&always, &table("de"));
    assert_eq!(said[0], "Legende: Trees");
    assert!(
        ["blau", "grün", "gelb", "rot", "grau"].iter().all(|name| said.iter().any(|text| text == name)),
        "{said:?}"
    );
    assert!(always[0].title.ends_with(", Legende") && always[0].description.contains("grün"));
    let corner = always[0].braille[0].dots.at.iter().fold(MmPoint::splat(f32::MAX), |corner, at| corner.min(*at));
    assert!(corner.x >= 10.0 && corner.y >= 10.0, "it keeps the margin: {corner:?}");
}

#[test]
fn a_text_longer_than_a_sheet_goes_on_on_the_next() {
    let text = vec!["kilometre"; 60].join(" ");
    let label = Label { x: percent(50.0), y: percent(50.0), text };
    for profile in ["monarch", "index-basic-d", "swell-a4"] {
        let picture = samples::read("landscape.svg");
        let drawing = convert(&picture, &options(profile, KeySheets::Auto).labels(vec![label.clone()])).expect("pages");
        let texts: Vec<_> = drawing.key.iter().flat_map(|page| &page.braille).collect();
        // several sheets are numbered, in their order
        let numbers = texts.iter().filter(|text| text.role == TextRole::Number).map(|text| text.text.as_str());
        let wanted: Vec<String> = (1..=drawing.key.len()).map(|number| number.to_string()).collect();
        assert_eq!(numbers.collect::<Vec<_>>(), if wanted.len() > 1 { wanted } else { Vec::new() }, "{profile}");
        let raised = |line: &String| line.chars().map(|cell| (cell as u32 - 0x2800).count_ones()).sum::<u32>();
        for text in &texts {
            let dots: u32 = text.lines.iter().map(raised).sum();
            assert_eq!(text.dots.at.len(), dots as usize, "{profile}: dots are missing");
        }
        let read = texts.iter().flat_map(|text| &text.lines).map(|line| line.matches('⠅').count()).sum::<usize>();
        assert!(read >= 60, "{profile}: only {read} letters k");
    }
}

#[test]
fn a_key_of_words_alone_is_no_empty_page() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("figure.textures", "false").expect("the key is there");
    let plain = Options::new(profile).title("Trees").fonts(Fonts::system());
    let at = |x, text: &str| Label { x: percent(x), y: percent(60.0), text: text.to_owned() };
    let labels = vec![at(80.0, "a very large fir tree"), at(81.0, "twig")];
    let key = convert(&samples::read("landscape.svg"), &plain.labels(labels)).expect("a page").key;
    assert_eq!(key.len(), 1);
    let checked = tactograph::check(key[0].to_svg(), &tactograph::PageOptions::new()).expect("it can be read");
    assert!(checked.findings.iter().all(|finding| finding.rule.id != "empty"), "{checked}");
}
