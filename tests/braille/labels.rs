//! Labels in braille on pages: every one reads as its code has it, keeps its distance, and none is lost without a word.

use super::{percent, reading};
use crate::common::samples;
use tactograph::internals::braille::{CellSize, Code};
use tactograph::internals::geom::nearest_on_segment;
use tactograph::internals::page::Medium;
use tactograph::internals::page::cells::CellGrid;
use tactograph::internals::units::MmVector;
use tactograph::marks::{BrailleText, Pen, TextRole};
use tactograph::{Drawing, Fonts, KeySheets, Label, Length, MmPoint, MmRect, Note, Options, Profile, Reason, convert};

/// Blank that labels keep to lines and textures, mm.
const CLEARANCE: f32 = 3.0;

pub(super) fn options(profile: &str) -> Options {
    Options::new(Profile::named(profile).expect("it is built in")).fonts(Fonts::system())
}

pub(super) fn labels_of(drawing: &Drawing) -> Vec<&BrailleText> {
    drawing.page.braille.iter().filter(|text| text.role == TextRole::Label).collect()
}

/// The box around a label's dots.
pub(super) fn place(label: &BrailleText) -> MmRect {
    let radius = 0.5 * label.dots.diameter;
    MmRect::from_points(&label.dots.at).inflate(radius, radius)
}

fn distance_to(place: MmRect, at: MmPoint) -> f32 {
    (at - at.clamp(place.min, place.max)).length()
}

/// Everything that a label owes: its cells, and its distances.
fn check(drawing: &Drawing, name: &str) {
    let page = &drawing.page;
    let table = Code::of_language("en").and_then(Code::table).expect("a table");
    let size = CellGrid::of(&page.medium, CellSize::MARBURG).size();
    let labels = labels_of(drawing);
    for (number, label) in labels.iter().enumerate() {
        let lines = reading::lines(&label.dots.at, size);
        let shown = label.abbreviation.as_ref().unwrap_or(&label.text);
        assert!(reading::say(&lines, &table.translate(shown).unicode()), "{name}: {shown}: {lines:?}");
        assert_eq!(lines, label.lines, "{name}: {shown}");
        // and a reader who knows the code says what the label says
        let whole = lines.len() == 1 || !lines[0].ends_with('⠤');
        if whole {
            assert_eq!(super::back::english(&lines.join("\u{2800}")), *shown, "{name}");
        }

        let place = place(label);
        for run in page.figure.lines.iter().flat_map(|line| &line.runs) {
            let path: Vec<MmPoint> = run.polyline().path().copied().collect();
            let to_stroke = |pair: &[MmPoint]| {
                // corners of the label against the line, and ends of the line against the label
                let [left, top, right, bottom] = [place.min.x, place.min.y, place.max.x, place.max.y];
                let corners = [(left, top), (right, top), (right, bottom), (left, bottom)].map(MmPoint::from);
                let to_corner = |at: &MmPoint| nearest_on_segment(*at, pair[0], pair[1]).0;
                let of_corners = corners.iter().map(to_corner).fold(f32::INFINITY, f32::min);
                of_corners.min(distance_to(place, pair[0])).min(distance_to(place, pair[1]))
            };
            let near = match run.pen {
                Pen::Stroke => path.windows(2).map(to_stroke).fold(f32::INFINITY, f32::min),
                Pen::Dots(_) => path.iter().map(|&at| distance_to(place, at)).fold(f32::INFINITY, f32::min),
            };
            assert!(near - 0.5 * run.width >= CLEARANCE - 0.01, "{name}: {shown} lies {near} mm from a line");
        }
        for glyph in page.figure.textures.iter().flat_map(|texture| &texture.glyphs) {
            let near = distance_to(place, glyph.at) - glyph.radius();
            let least = if matches!(page.medium, Medium::Dots(_)) { 2.0 * CLEARANCE } else { CLEARANCE };
            assert!(near >= least - 0.01, "{name}: {shown} lies {near} mm from a glyph");
        }
        for dot in &page.frame.at {
            let near = distance_to(place, *dot) - 0.5 * page.frame.diameter;
            assert!(near >= CLEARANCE - 0.01, "{name}: {shown} lies {near} mm from the frame");
        }
        for other in &labels[..number] {
            // a blank cell between two in a row, the distance of lines between two in a column
            let near = self::place(other).inflate(5.9, 3.4).intersects(&place);
            assert!(!near, "{name}: {shown} and {} are read as one", other.text);
        }
    }
}

/// On open ground labels hang on the right of their points, and none beside them runs into another.
#[test]
fn labels_hang_beside_their_points() {
    let blank = b"<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'>\
        <rect width='300' height='200' fill='#fff'/>\
        <path d='M10 190h280' stroke='#000' stroke-width='3'/></svg>";
    let labels = vec![at(20.0, 20.0, "tree"), at(20.0, 50.0, "house"), at(95.0, 35.0, "roof")];
    for profile in ["swell-a4", "viewplus-columbia"] {
        let drawing = convert(&blank[..], &options(profile).labels(labels.clone())).expect("a page");
        let figure = drawing.page.figure.place;
        for (label, wanted) in labels_of(&drawing).into_iter().zip(&labels) {
            let [Length::Percent(x), Length::Percent(y)] = [wanted.x.length(), wanted.y.length()] else {
                panic!("percent")
            };
            let (x, y) = (x as f32, y as f32);
            let anchor = figure.min + MmVector::new(0.01 * x * figure.width(), 0.01 * y * figure.height());
            let place = place(label);
            let is_beside = (place.min.y..place.max.y).contains(&anchor.y);
            assert!(is_beside, "{profile}: {} is above or below", label.text);
            // the last has no room on the right
            let gap = if x < 90.0 { place.min.x - anchor.x } else { anchor.x - place.max.x };
            assert!((1.9..6.0).contains(&gap), "{profile}: {} begins {gap} mm beside its point", label.text);
        }
        let told = drawing.notes.iter().map(ToString::to_string).find(|note| note.starts_with("labels that name"));
        let told = told.expect("nothing is drawn there");
        assert!(told.contains("\"tree\", \"house\", \"roof\""), "{told}");
    }
}

/// Where there is room, labels side by side have two blank cells between them, as columns of a table.
#[test]
fn labels_side_by_side_are_two_blank_cells_apart() {
    let blank = b"<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'>\
        <rect width='300' height='200' fill='#fff'/>\
        <path d='M10 190h280' stroke='#000' stroke-width='3'/></svg>";
    let labels = vec![at(30.0, 50.0, "sun"), at(47.0, 50.0, "moon"), at(68.0, 50.0, "star")];
    for (profile, least) in [("swell-a4", 14.0), ("viewplus-columbia", 14.0)] {
        let drawing = convert(&blank[..], &options(profile).labels(labels.clone())).expect("a page");
        let places: Vec<MmRect> = labels_of(&drawing).into_iter().map(place).collect();
        assert_eq!(places.len(), 3, "{profile}");
        for (a, b) in [(0, 1), (0, 2), (1, 2)].map(|(a, b)| (places[a], places[b])) {
            let is_in_line = a.min.y < b.max.y && b.min.y < a.max.y;
            let gap = (b.min.x - a.max.x).max(a.min.x - b.max.x);
            assert!(is_in_line, "{profile}: there is room for all three side by side: {places:?}");
            assert!(gap >= least, "{profile}: {gap} mm between two labels");
        }
    }
}

/// A point at the lower side of a bar names the bar: its label stands in the middle below it, and not below the next one.
#[test]
fn labels_at_the_lower_side_of_bars_stand_in_the_middle_below_them() {
    let bars = b"<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'>\
        <rect width='300' height='200' fill='#fff'/><g fill='none' stroke='#000' stroke-width='3'>\
        <path d='M20 150V60h40v90z'/><path d='M120 150V30h40v120z'/><path d='M220 150V80h40v70z'/></g></svg>";
    // on the line, a little below it, and at the middle of the upper side, where there is nothing to hang below
    let below = [(40.0, 75.0, "Ann"), (140.0, 77.0, "Bob"), (240.0, 75.0, "Eve")];
    let labels = below.iter().map(|(x, y, text)| at(x / 3.0, *y, text)).chain([at(140.0 / 3.0, 15.0, "top")]).collect();
    // the dots of a capital sign lie in the right half of their cell, and a grid has steps
    for (profile, step) in [("swell-a4", 1.3), ("viewplus-columbia", 2.0)] {
        let drawing = convert(&bars[..], &options(profile).labels(Vec::clone(&labels))).expect("a page");
        let figure = drawing.page.figure.place;
        let placed = labels_of(&drawing);
        for (x, y, text) in below {
            let place = place(placed.iter().find(|label| label.text == text).expect("it has room"));
            let anchor = figure.min + MmVector::new(x / 300.0 * figure.width(), 0.01 * y * figure.height());
            let off = place.center().x - anchor.x;
            assert!(off.abs() <= step && place.min.y > anchor.y, "{profile}: {text} is {off} mm off the middle");
        }
        let top = place(placed.iter().find(|label| label.text == "top").expect("it has room"));
        assert!(top.max.y < figure.min.y + 0.15 * figure.height(), "{profile}: it stands above its bar");
    }
}

/// The capital of the map is a small disc, which dots have no room for beside the river: its label stays.
#[test]
fn a_small_shape_that_dots_do_not_show_is_told() {
    let picture = String::from_utf8(samples::read("map.svg")).expect("text");
    let square = "<rect x=\"406\" y=\"286\" width=\"28\" height=\"28\" fill=\"#202020\"/>";
    let of_square = picture.replace("<circle id=\"capital\" cx=\"420\" cy=\"300\" r=\"16\" fill=\"#202020\"/>", square);
    let cases = [
        (&picture, "swell-a4", false),
        (&picture, "viewplus-columbia", false),
        (&picture, "pins-120x60", false),
        (&of_square, "swell-a4", false),
        (&of_square, "viewplus-columbia", true),
    ];
    for (svg, profile, is_told) in cases {
        let drawing = convert(svg.as_bytes(), &options(profile)).expect("a page");
        let told =
            drawing.notes.iter().any(|note| note.to_string().contains("1 small shape (that beside \"Capital\"; at "));
        assert_eq!(told, is_told, "{profile}: {:?}", drawing.notes);
    }
}

/// Every text of a drawing is on its page, in full or abbreviated, or told; on paper and on dots.
#[test]
fn texts_of_drawings_are_labels() {
    for (sample, profile, least) in [
        ("chart.svg", "swell-a4", 9),
        ("chart.svg", "swell-a3", 9),
        ("chart.svg", "viewplus-columbia", 9),
        ("chart.svg", "index-basic-d", 8),
        ("chart.svg", "braillerap", 8),
        ("chart.svg", "pins-120x60", 7),
        ("map.svg", "swell-a4", 6),
        ("map.svg", "viewplus-columbia", 6),
        ("cell.svg", "swell-a4", 5),
        ("cell.svg", "viewplus-columbia", 5),
        ("worksheet.pdf", "swell-a4", 9),
        ("worksheet.pdf", "viewplus-columbia", 9),
    ] {
        let name = format!("{sample} {profile}");
        let drawing = convert(&samples::read(sample), &options(profile).label_texts(true)).expect("a page");
        if drawing.texts.is_empty() {
            // a machine without fonts shows no text of an SVG, and says so
            assert!(drawing.notes.iter().any(|note| matches!(note, Note::LeftOut(..))), "{name}: {:?}", drawing.notes);
            continue;
        }
        check(&drawing, &name);
        let labels = labels_of(&drawing);
        assert!(labels.len() >= least, "{name}: {} of {} texts", labels.len(), drawing.texts.len());
        let left_out = drawing.notes.iter().find_map(|note| match note {
            Note::LabelsLeftOut { texts, .. } => Some(texts.clone()),
            _ => None,
        });
        let left_out = left_out.unwrap_or_default();
        assert_eq!(labels.len() + left_out.len(), drawing.texts.len(), "{name}: {left_out:?}");
        assert!(!drawing.notes.iter().any(|note| matches!(note, Note::TextsLeftOut(_))), "{name}");
        for label in &labels {
            assert!(drawing.page.description.contains(&label.spoken()), "{name}: {}", label.text);
            let is_told = drawing.notes.iter().any(|note| match note {
                Note::Abbreviated(all) => {
                    all.iter().any(|(short, text)| Some(short) == label.abbreviation.as_ref() && *text == label.text)
                }
                _ => false,
            });
            assert_eq!(label.abbreviation.is_some(), is_told, "{name}: {}", label.text);
        }
    }
}

fn at(x: f32, y: f32, text: &str) -> Label {
    Label { x: percent(x), y: percent(y), text: text.to_owned() }
}

/// Labels lie beside their points, on the same side of lines; a leader line leads to those further away.
#[test]
fn labels_lie_beside_what_they_name() {
    let wanted = [
        (22.0, 12.0, "cloud"),
        (20.0, 35.0, "tree"),
        (50.0, 35.0, "roof"),
        (86.0, 22.0, "sun"),
        (50.0, 87.0, "pond"),
        (50.0, 65.0, "wall"),
        (80.0, 60.0, "fir tree"),
    ];
    let labels = wanted.map(|(x, y, text)| at(x, y, text)).to_vec();
    for profile in ["swell-a4", "swell-a3", "viewplus-columbia", "index-basic-d"] {
        let drawing =
            convert(&samples::read("landscape.svg"), &options(profile).labels(labels.clone())).expect("a page");
        check(&drawing, profile);
        let place = drawing.page.figure.place;
        let found = labels_of(&drawing);
        assert!(found.len() >= 6, "{profile}: {:?}", drawing.notes);
        for label in found {
            let (x, y, _) = wanted.iter().find(|(_, _, text)| *text == label.text).expect("a wanted one");
            let anchor = place.min + MmVector::new(0.01 * x * place.width(), 0.01 * y * place.height());
            let gap = distance_to(self::place(label), anchor);
            assert!(gap <= 38.0, "{profile}: {} lies {gap} mm away", label.text);
            assert!(gap <= 12.5 || label.leader.is_some(), "{profile}: {} has no leader line", label.text);
            if let Some(leader) = &label.leader {
                let ends = [leader.points.first(), leader.points.last()].into_iter().flatten();
                let to_anchor = ends.map(|end| (*end - anchor).length()).fold(f32::INFINITY, f32::min);
                assert!(to_anchor < 2.0, "{profile}: the leader line of {} ends elsewhere", label.text);
            }
        }
    }
}

/// Lines of a grid part a text from nothing, and where a label has no other room it interrupts them.
#[test]
fn labels_stand_on_lines_of_a_grid_and_interrupt_them() {
    let mut svg = String::from(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 600' font-size='20'><rect width='800' height='600' \
         fill='#fff'/>",
    );
    for level in 0..9 {
        let y = 520 - 50 * level;
        svg += &format!("<path d='M90 {y}H760' stroke='#ccc'/>");
    }
    for (bar, value) in [7, 4, 3, 5, 6].into_iter().enumerate() {
        let (x, y) = (120 + 130 * bar, 520 - 50 * value);
        svg += &format!("<rect x='{x}' y='{y}' width='80' height='{}' fill='#d33'/>", 50 * value);
        svg += &format!("<text x='{}' y='{}' text-anchor='middle'>{value}</text>", x + 40, y - 10);
    }
    svg += "<path d='M90 120V520H760' fill='none' stroke='#000' stroke-width='2.5'/></svg>";
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = convert(svg.as_bytes(), &options(profile).label_texts(true)).expect("a page");
        let found = labels_of(&drawing);
        assert_eq!(found.len(), 5, "{profile}: {:?}", drawing.notes);
        assert!(found.iter().all(|label| label.leader.is_none()), "{profile}: {:?}", drawing.notes);
        check(&drawing, profile);
    }
}

/// A text that is longer than anything on a page is left out and told, without working on it for long: with a key of all
/// of it, this took two minutes.
#[test]
fn a_text_of_a_megabyte_is_told() {
    let long = "an apple, red ".repeat(70_000);
    let options = options("swell-a4").labels(vec![at(50.0, 50.0, &long)]).title(long.clone()).key(KeySheets::Always);
    let drawing = convert(&samples::read("bars.svg"), &options).expect("a page");
    assert!(labels_of(&drawing).is_empty() && drawing.page.braille.is_empty());
    let why = "a text of a page has 1000 characters at most";
    let left_out = Note::LabelsLeftOut { texts: vec![long.clone()], reason: Reason::TextTooLong, why };
    assert!(drawing.notes.contains(&left_out), "{:?}", drawing.notes);
    assert!(drawing.notes.contains(&Note::NotTranslated { texts: vec![long], why: why.to_owned() }));
    assert!(drawing.key.len() <= 1, "{} sheets of a key", drawing.key.len());
}

/// Labels outside of the picture, without room or without a code are told.
#[test]
fn labels_that_are_not_there_are_told() {
    let left_out = |drawing: &Drawing| -> Vec<(Vec<String>, &'static str)> {
        let of_note = |note: &Note| match note {
            Note::LabelsLeftOut { texts, why, .. } => Some((texts.clone(), *why)),
            _ => None,
        };
        drawing.notes.iter().filter_map(of_note).collect()
    };
    let told = |text: &str, why: &'static str| (vec![text.to_owned()], why);
    let outside = || told("outside", "what lies outside of the picture is not drawn");
    let picture = samples::read("bars.svg");
    let labels = vec![at(120.0, 50.0, "outside"), at(50.0, 50.0, "in")];
    let drawing = convert(&picture, &options("swell-a4").labels(labels.clone())).expect("a page");
    assert_eq!(left_out(&drawing), [outside()]);
    assert_eq!(labels_of(&drawing).len(), 1);
    // without a code
    let drawing = convert(&picture, &options("swell-a4").labels(labels.clone()).language("ja")).expect("a page");
    assert_eq!(left_out(&drawing), [outside(), told("in", "there is no braille code for this language")]);
    assert!(drawing.notes.contains(&Note::NoBrailleCode("ja".into())));
    // without braille
    let mut off = Profile::named("swell-a4").expect("it is built in");
    off.set("braille", "false").expect("a setting");
    let drawing = convert(&picture, &Options::new(off).labels(labels)).expect("a page");
    assert_eq!(left_out(&drawing), [outside(), told("in", "braille is off (braille=false)")]);
    // of a text without cells, and of one that is abbreviated, every character is told
    let labels = vec![at(50.0, 50.0, "\u{65e5}\u{672c}"), at(20.0, 50.0, &"long\u{65e5}".repeat(40))];
    let drawing = convert(&picture, &options("swell-a4").labels(labels.clone())).expect("a page");
    let misleading = "without characters that the braille code has no cells for such a text would say something else";
    let no_cells = told("\u{65e5}\u{672c}", "the braille code has no cells for such a text");
    assert_eq!(left_out(&drawing), [no_cells, told(&labels[1].text, misleading)]);
    let told: Vec<String> =
        drawing.notes.iter().map(Note::to_string).filter(|note| note.contains("left out of the braille")).collect();
    let [told] = &told[..] else { panic!("one note for all: {told:?}") };
    let names = |what: &str| assert!(told.contains(what), "{what}: {told}");
    ["'\u{65e5}'", "'\u{672c}'", &labels[0].text, "\"long\u{65e5}long\u{65e5}"].into_iter().for_each(names);
    // an ornament is told, and the rest says what it said
    let labels = vec![at(50.0, 50.0, "sun \u{2600}")];
    let drawing = convert(&picture, &options("swell-a4").labels(labels)).expect("a page");
    assert_eq!((labels_of(&drawing).len(), left_out(&drawing)), (1, vec![]));
    assert!(drawing.notes.iter().any(|note| note.to_string().contains("write it in words")), "{:?}", drawing.notes);
    // a translator that fails says why, once for all labels, and for what is on the key
    let fails = |text: &str| match text {
        "trees" => Ok(vec![1, 2, 3]),
        _ => Err("there is no such table".to_owned()),
    };
    let labels = ["trees", "houses", "rivers"].map(|text| at(50.0, 50.0, text)).to_vec();
    let options_of = options("swell-a4").labels(labels).key(KeySheets::Always).translator(fails);
    let drawing = convert(&samples::read("landscape.svg"), &options_of).expect("a page");
    let why = || "there is no such table".to_owned();
    let refused =
        |texts: &[&str]| Note::NotTranslated { texts: texts.iter().map(ToString::to_string).collect(), why: why() };
    assert!(drawing.notes.contains(&refused(&["houses", "rivers"])), "{:?}", drawing.notes);
    let of_key = refused(&["Key", "blue", "green", "yellow", "red", "grey"]);
    assert!(drawing.notes.contains(&of_key), "{:?}", drawing.notes);
    assert!(left_out(&drawing).is_empty() && drawing.key[0].braille.is_empty());
    // far more than there is room for: those that are there keep their distances
    let many: Vec<Label> = (0..200).map(|i| at((i % 20) as f32 * 5.0, (i / 20) as f32 * 10.0, "many words")).collect();
    let drawing = convert(&picture, &options("swell-a4").labels(many)).expect("a page");
    check(&drawing, "many");
    let there = labels_of(&drawing).len();
    assert_eq!(there + left_out(&drawing).iter().map(|(texts, _)| texts.len()).sum::<usize>(), 200);
    assert!(there >= 40, "{there} labels");
}

/// The same page with labels, whatever the number of threads, and mirrored as a whole.
#[test]
fn labels_are_the_same_every_time_and_in_the_mirror() {
    let picture = samples::read("chart.svg");
    let page = || convert(&picture, &options("swell-a4").label_texts(true)).expect("a page").page;
    assert_eq!(page().to_svg(), page().to_svg());
    let mirrored = convert(&picture, &options("swell-a4").label_texts(true).mirrored(true)).expect("a page").page;
    for (label, other) in page().braille.iter().zip(&mirrored.braille) {
        let flipped: Vec<MmPoint> = label.dots.at.iter().map(|at| MmPoint::new(210.0 - at.x, at.y)).collect();
        assert!(flipped.iter().zip(&other.dots.at).all(|(a, b)| (*a - *b).length() < 1e-3), "{}", label.text);
    }
}
