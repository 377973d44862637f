//! The title in braille: on paper as SVG has it, and on every kind of device; apart from everything else.

use super::reading;
use crate::common::samples;
use tactograph::internals::braille::{CellSize, Code};
use tactograph::internals::page::cells::CellGrid;
use tactograph::marks::TextRole;
use tactograph::medium::Medium;
use tactograph::{DotFormat, Drawing, Fonts, KeySheets, MmPoint, Note, Options, Page, Profile, RenderOptions, convert};

const TITLE: &str = "Rain in mm, March to July 2024";

/// The chart with a title, for a profile with these settings.
fn drawn(title: &str, language: &str, profile: &str, settings: &[(&str, &str)]) -> Drawing {
    let mut profile = Profile::named(profile).expect("it is built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("a setting"));
    let options = Options::new(profile).title(title).language(language);
    convert(&samples::read("bars.svg"), &options).expect("a page")
}

/// The title's cells as the code has them, without what lines take away.
fn cells(title: &str, language: &str) -> String {
    let table = Code::of_language(language).and_then(Code::table).expect("a table");
    table.translate(title).unicode()
}

/// The lines of a title as fingers find them on the page.
fn read(page: &Page, size: CellSize) -> Vec<String> {
    let [title] = &page.braille[..] else { panic!("{} texts in braille", page.braille.len()) };
    assert_eq!(title.role, TextRole::Title);
    let cells = CellGrid::of(&page.medium, size);
    let lines = reading::lines(&title.dots.at, cells.size());
    assert_eq!(lines, title.lines);
    lines
}

/// Distance from the title to everything else on the page, from edge to edge, mm.
fn distance(page: &Page) -> f32 {
    let title = &page.braille[0].dots;
    let frame = page.frame.at.iter().map(|&at| (at, 0.5 * page.frame.diameter));
    let runs = page.orientation_mark.iter().chain(page.figure.lines.iter().flat_map(|line| &line.runs));
    let runs = runs.flat_map(|run| {
        // along the mark too
        let ends = run.points.windows(2).flat_map(|pair| (0..=20).map(|i| pair[0].lerp(pair[1], i as f32 / 20.0)));
        ends.map(|at| (at, 0.5 * run.width)).collect::<Vec<_>>()
    });
    let others: Vec<(MmPoint, f32)> = frame.chain(runs).collect();
    let to_others =
        |dot: &MmPoint| others.iter().map(|(at, radius)| (*at - *dot).length() - radius).fold(f32::INFINITY, f32::min);
    title.at.iter().map(to_others).fold(f32::INFINITY, f32::min) - 0.5 * title.diameter
}

#[test]
fn a_title_reads_as_its_code_has_it_on_every_device() {
    for (profile, settings, lines) in [
        ("swell-a4", &[][..], 2),
        ("swell-a4", &[("braille.cell", "us")], 2),
        ("swell-a4", &[("braille.cell", "large"), ("braille.align", "left")], 2),
        ("swell-a3", &[], 1),
        ("plain-print", &[("mark", "false")], 2),
        ("index-basic-d", &[], 2),
        ("index-basic-d", &[("dots.pitch", "1.6")], 2),
        ("index-basic-d", &[("dots.pitch", "2.5")], 2),
        ("viewplus-columbia", &[], 1),
        ("braillerap", &[], 2),
        ("braille-cells", &[], 1),
        ("pins-120x60", &[], 1),
    ] {
        let drawing = drawn(TITLE, "en", profile, settings);
        let size = settings.iter().find(|(key, _)| *key == "braille.cell").map_or("de", |(_, name)| name);
        let size = CellSize::named(size).expect("in the table");
        let read = read(&drawing.page, size);
        assert_eq!(read.join("\u{2800}"), cells(TITLE, "en"), "{profile} {settings:?}");
        assert_eq!(read.len(), lines, "{profile} {settings:?}");
        let distance = distance(&drawing.page);
        assert!(distance >= 3.0, "{profile} {settings:?}: {distance} mm to the next mark");
        if let Medium::Dots(_) = drawing.page.medium {
            let overview = drawing.overview.expect("dots have it on a sheet of its own");
            assert_eq!(overview.braille, drawing.page.braille, "{profile}");
        }
    }
}

/// Cells have the measures that are asked for, to 0.05 mm, also as the SVG has them.
#[test]
fn an_svg_has_the_title_for_fingers_and_ears() {
    for (cell, [dot, from_cell, line]) in
        [("de", [2.5, 6.0, 10.0]), ("us", [2.34, 6.2, 10.0]), ("no", [2.5, 6.1, 10.0])]
    {
        let title = "Wärme: 20 °C & mehr <als> je zuvor, \"hier\"";
        let page = drawn(title, "de", "swell-a4", &[("braille.cell", cell)]).page;
        let svg = page.to_svg();
        let document = roxmltree::Document::parse(&svg).expect("a page is well-formed");
        let layer = document.descendants().find(|node| node.attribute("id") == Some("braille-title"));
        let text = layer.and_then(|layer| layer.first_element_child()).expect("the title");
        assert_eq!(text.attribute("aria-label"), Some(title));
        assert_eq!(text.attribute(("http://www.w3.org/XML/1998/namespace", "lang")), Some("de"));
        let path = text.first_element_child().and_then(|path| path.attribute("d")).expect("its dots");
        // each dot is M left,middle a radius ...
        let dots = path.split('M').skip(1).map(|disc| {
            let (start, arc) = disc.split_once('a').expect("an arc");
            let (x, y) = start.split_once(',').expect("a point");
            let number = |text: &str| text.parse::<f32>().expect("a number");
            let radius = number(arc.split(' ').next().expect("a radius"));
            assert!((2.0 * radius - 1.3).abs() < 0.05, "diameter");
            MmPoint::new(number(x) + radius, number(y))
        });
        let size = CellSize { dot, cell: from_cell, line, ..CellSize::MARBURG };
        let lines = reading::lines(&dots.collect::<Vec<_>>(), size);
        assert_eq!(lines.join(" "), text.attribute("data-braille").expect("its cells"));
        assert_eq!(lines.join("\u{2800}"), cells(title, "de"));
    }
}

/// A title whose words are too long for a sheet is divided by the rules of its language; where whole words have room,
/// none is.
#[test]
fn long_words_of_a_title_are_divided() {
    let title = "Niederschlagsmengen im Jahresdurchschnitt nach Bundesländern";
    let whole = drawn(title, "de", "swell-a4", &[]).page;
    let lines = read(&whole, CellSize::MARBURG);
    assert_eq!(lines.join("\u{2800}"), cells(title, "de"));
    // longer than a line
    let long = "Niederschlagsmengendurchschnittswerte";
    let page = drawn(long, "de", "swell-a4", &[]).page;
    let lines = read(&page, CellSize::MARBURG);
    assert!(lines.len() == 2 && lines[0].ends_with('⠤'), "{lines:?}");
    assert!(reading::say(&lines, &cells(long, "de")), "{lines:?}");
}

/// A file of text cells has the title as text.
#[test]
fn brf_begins_with_the_title() {
    let page = drawn("Apples, 5 kg", "en", "braille-cells", &[]).page;
    let brf = String::from_utf8(page.to_dots(DotFormat::Brf).expect("its format")).expect("ASCII");
    assert_eq!(brf.lines().next().map(|line| &line[..line.len() - 1].trim_start()[..12]), Some(",APPLES1 #E "));
}

#[test]
fn titles_that_cannot_be_written_are_told() {
    let has = |drawing: &Drawing, wanted: fn(&Note) -> bool| drawing.notes.iter().any(wanted);
    let unwritten = |title: &str, language: &str, profile: &str, settings: &[(&str, &str)]| {
        let drawing = drawn(title, language, profile, settings);
        assert!(drawing.page.braille.is_empty(), "{title}");
        drawing
    };
    let longer = "word ".repeat(500);
    assert!(has(&unwritten(&longer, "en", "swell-a4", &[]), |note| matches!(note, Note::NotTranslated { .. })));
    let note = Note::NoBrailleCode("ja".into());
    assert!(unwritten(TITLE, "ja", "swell-a4", &[]).notes.contains(&note));
    // nothing is told where braille is off, and the page is as without it
    let off = unwritten(TITLE, "en", "swell-a4", &[("braille", "false")]);
    assert!(!has(&off, |note| matches!(note, Note::NoRoomForTitle { .. })));
    let mut bare = Options::new(Profile::named("swell-a4").expect("built in"));
    bare = bare.picture_name(TITLE);
    let bare = convert(&samples::read("bars.svg"), &bare).expect("a page");
    assert_eq!(bare.page.figure, off.page.figure);
    // a code that is named overrides the language
    let named = drawn("Zahl 5", "ja", "swell-a4", &[("braille.code", "de")]).page;
    assert_eq!(read(&named, CellSize::MARBURG), [cells("Zahl 5", "de")]);
    // characters that the code lacks
    let lacking = drawn("Kaffee \u{65e5}", "de", "swell-a4", &[]);
    let note = Note::NotInBraille { texts: vec!["Kaffee \u{65e5}".into()], lacking: vec![('\u{65e5}', 8)] };
    assert!(lacking.notes.contains(&note), "{:?}", lacking.notes);
}

/// A title that is too long for a display of 60 x 40 pins, and one for any sheet, begin a key; where the maker wants none
/// they are left out. Drawn anew on larger paper, the page has its title above the figure.
#[test]
fn a_title_without_room_begins_the_key() {
    let told = |drawing: &Drawing| {
        let mut told = drawing.notes.iter().filter_map(|note| match note {
            Note::NoRoomForTitle { in_key, .. } => Some(*in_key),
            _ => None,
        });
        told.next()
    };
    let long = "word ".repeat(180);
    for (title, profile) in [(TITLE, "graphiti"), (long.trim(), "swell-a4")] {
        let drawing = drawn(title, "en", profile, &[]);
        assert!(drawing.page.braille.is_empty(), "{profile}");
        assert_eq!(told(&drawing), Some(true), "{profile}");
        let texts: Vec<&str> =
            drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
        assert!(texts.iter().any(|text| *text == format!("Key: {title}")), "{profile}: {texts:?}");
        let profile = Profile::named(profile).expect("built in");
        let options = Options::new(profile).title(title).key(KeySheets::Never);
        let without = convert(&samples::read("bars.svg"), &options).expect("a page");
        assert!(without.key.is_empty());
        assert_eq!(told(&without), Some(false));
    }
    let short = drawn("Rain", "en", "graphiti", &[]);
    assert!(short.page.braille.len() == 1 && short.key.is_empty() && told(&short).is_none());
    let paper = RenderOptions::new().profile(Profile::named("swell-a4").expect("built in"));
    let pins = drawn(TITLE, "en", "graphiti", &[]).page.to_svg();
    let anew = tactograph::render(pins, &paper).expect("a page");
    assert!(anew.page.braille.iter().any(|text| text.role == TextRole::Title && text.text == TITLE));
    assert!(anew.key.is_empty());
    // a sheet of a key with nothing but the title stays one
    let bare = Profile::named("graphiti").and_then(|mut profile| {
        profile.set("figure.textures", "false")?;
        Ok(profile)
    });
    let bare = convert(&samples::read("bars.svg"), &Options::new(bare.expect("a setting")).title(TITLE));
    let key = bare.expect("a page").key.remove(0);
    let anew = tactograph::render(key.to_svg(), &paper).expect("a page").page;
    assert!(anew.braille.iter().any(|text| text.text == format!("Key: {TITLE}")), "{:?}", anew.braille);
}

/// A title never stands in the way of a figure: where both have no room, the figure stays.
#[test]
fn a_width_that_leaves_no_room_for_a_title_stays() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("overview", "false").expect("a setting");
    let tall = || Options::new(profile.clone()).crop("0,0,20%,100%".parse().expect("a part"));
    let picture = samples::read("bars.svg");
    let most = convert(&picture, &tall()).expect("a page").page.figure.place.width();
    let drawing = convert(&picture, &tall().title(TITLE).width_mm(most)).expect("a page");
    assert!(drawing.page.braille.is_empty());
    assert!(drawing.notes.iter().any(|note| matches!(note, Note::NoRoomForTitle { .. })));
    let drawing = convert(&picture, &tall().title(TITLE)).expect("a page");
    assert!(drawing.page.figure.place.width() < most && drawing.page.braille.len() == 1);
}

/// Another translator in place of the tables, such as one for contracted braille; what it cannot write is told.
#[test]
fn another_translator_writes_all_words() {
    let options = |text: &str| {
        let of_length = |text: &str| match text.len() {
            0..=9 => Ok(vec![0b11_1111; text.len()]),
            10 => Ok(vec![0b1100_0000]),
            _ => Err("too many letters".to_owned()),
        };
        Options::new(Profile::named("swell-a4").expect("built in")).title(text).language("ja").translator(of_length)
    };
    let picture = samples::read("bars.svg");
    let page = convert(&picture, &options(" two\nwords ")).expect("a page").page;
    assert_eq!(read(&page, CellSize::MARBURG), ["⠿".repeat(9)]);
    for (text, why) in [("eleven keys", "too many letters"), ("ten keys !", "cells of eight dots")] {
        let drawing = convert(&picture, &options(text)).expect("a page");
        assert!(drawing.page.braille.is_empty());
        let note = Note::NotTranslated { texts: vec![text.into()], why: why.into() };
        assert!(drawing.notes.contains(&note), "{:?}", drawing.notes);
    }
}

/// A heading of a drawing with which the title begins stands in that; a text that the title only has within it stays.
#[test]
fn a_heading_that_begins_the_title_is_written_once() {
    let labels = |title: &str| -> Vec<String> {
        let profile = Profile::named("swell-a4").expect("it is built in");
        let options = Options::new(profile).title(title).language("en").label_texts(true).fonts(Fonts::system());
        let page = convert(&samples::read("chart.svg"), &options).expect("a page").page;
        let labels = page.braille.iter().filter(|text| text.role == TextRole::Label);
        labels.map(|text| text.text.clone()).collect()
    };
    let once = labels("Rain in mm, March to July");
    // a machine without fonts shows no text of an SVG
    if once.is_empty() {
        return;
    }
    assert!(!once.contains(&"Rain in mm".to_owned()), "{once:?}");
    let both = labels("Rain in mm of five months");
    assert!(both.contains(&"Rain in mm".to_owned()), "{both:?}");
    assert_eq!(both.len(), once.len() + 1);
    let months = labels("Mar, Apr, May, Jun and Jul");
    assert_eq!(months.len(), both.len(), "names of months stay");
}
