//! What render makes of words and lines that a person put on a page, and what it tells of them.

use crate::cli::common::*;
use crate::cli::render::{done, read, with_page};
use crate::common::samples;
use tactograph::MmPoint;
use tactograph::internals::page::{Page, TextRole};

/// The page of a place with something added to it.
fn with(place: &Place, page: &str, added: &str, name: &str) {
    place.put(name, place.text(page).replacen("</svg>", &format!("{added}</svg>"), 1).as_bytes());
}

/// A folder with the chart and its page, without an overview.
fn with_chart(options: &[&str]) -> Place {
    let place = Place::new();
    place.put("chart.svg", &samples::read("chart.svg"));
    let all = [&["convert", "chart.svg", "--no-overview", "-q", "-o", "page.svg"], options].concat();
    let run = place.run(&all);
    assert_eq!(run.code, 0, "{}", run.err);
    place
}

const LONG: &str = "<g id=\"labels-text\"><text x=\"75\" y=\"104\">Thermometers of the whole house</text></g>";

#[test]
fn a_page_with_new_abbreviations_has_a_key() {
    let place = with_chart(&[]);
    with(&place, "page.svg", LONG, "typed.svg");
    let told = done(&place, &["render", "typed.svg", "-o", "done.svg"]);
    assert!(told.contains("abbreviated for want of room: "), "{told}");
    assert!(told.contains("wrote done-1.svg: figure\n") && told.contains("wrote done-2.svg: key\n"), "{told}");
    let (page, key) = (read(&place, "done-1.svg"), read(&place, "done-2.svg"));
    let short = page.braille.iter().find_map(|text| text.abbreviation.clone()).expect("it is abbreviated");
    assert!(told.contains(&format!("{short} for \"Thermometers of the whole house\"")), "{told}");
    let says = |key: &Page| {
        let of_key = key.braille.iter().filter(|text| text.role == TextRole::Key).map(|text| text.text.clone());
        of_key.collect::<Vec<_>>()
    };
    assert!(says(&key).contains(&format!("{short}: Thermometers of the whole house")), "{:?}", says(&key));
    assert!(says(&key).iter().any(|text| text == "blue"), "the colours are named: {:?}", says(&key));
    // of dots, from paper and from the page of dots itself, which has room for all of it
    let dots = ["--profile", "index-basic-d", "--set", "overview=false", "--key", "always"];
    done(&place, &[&["render", "typed.svg", "-o", "dots.svg"][..], &dots].concat());
    assert!(says(&read(&place, "dots-2.svg")).iter().any(|text| text == "blue"));
    done(&place, &["render", "dots-1.svg", "--key", "always", "-o", "again.pef"]);
    done(&place, &["render", "dots-1.svg", "-o", "less.pef"]);
    assert!(place.text("again.pef").len() > place.text("less.pef").len(), "the key follows in the same file");
    // when it is asked for
    let told = done(&place, &["render", "typed.svg", "--key", "never", "-o", "alone.svg"]);
    assert!(told.contains("wrote alone.svg\n"), "{told}");
    done(&place, &["render", "page.svg", "--key", "always", "-o", "with.svg"]);
    assert!(says(&read(&place, "with-2.svg")).iter().any(|text| text == "blue"));
    let told = done(&place, &["render", "with-2.svg", "--key", "always", "-o", "key.svg"]);
    assert!(told.contains("there is no key, as this sheet is one of a key itself"), "{told}");
}

#[test]
fn a_key_that_has_nothing_to_tell_is_told() {
    let place = with_chart(&[]);
    let of = |options: &[&str]| {
        done(&place, &[&["convert", "chart.svg", "--key", "always", "-o", "x.svg"], options].concat())
    };
    let told = of(&["--outlines"]);
    assert!(told.contains("there is no key, as it would tell nothing") && told.contains("wrote x.svg\n"), "{told}");
    for off in [&["--set", "braille=false"][..], &["--no-braille"]] {
        let told = of(&[off, &["--title", "Pets"]].concat());
        assert!(told.contains("there is no key, as braille is off (braille=false)"), "{told}");
        assert!(!place.text("x.svg").contains("data-braille"), "{off:?}");
    }
    let told = of(&["--lang", "ja"]);
    assert!(told.contains("there is no key, as there is no braille code for the language"), "{told}");
    assert!(!of(&[]).contains("there is no key"));
}

#[test]
fn lines_by_hand_come_first_on_another_device_and_those_that_are_lost_are_named() {
    let place = with_chart(&[]);
    let line = |name: &str, d: &str, width: f32| {
        format!("<path inkscape:label=\"{name}\" d=\"{d}\" fill=\"none\" stroke=\"#000\" stroke-width=\"{width}\"/>")
    };
    let page = read(&place, "page.svg");
    // beside the left side of the middle bar, and across the one left of it
    let middle = page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
    let top = middle.min_by(|a, b| a.y.total_cmp(&b.y)).expect("there are lines");
    let figure = page.figure.place;
    let of_figure =
        |x: f32, y: f32| MmPoint::new(figure.min.x + x * figure.width(), figure.min.y + y * figure.height());
    let (beside, across) = (of_figure(0.503, 0.5), of_figure(0.3, 0.7));
    assert!(top.y < beside.y);
    let roof = line("my roof", &format!("M{},{}v24", beside.x, beside.y), 0.8);
    let cross = line("my cross", &format!("M{},{}h32", across.x, across.y), 1.0);
    let crumb = line("my crumb", &format!("M{},{}h2", of_figure(0.9, 0.1).x, of_figure(0.9, 0.1).y), 1.0);
    with(&place, "page.svg", &(roof + &cross + &crumb), "drawn.svg");
    for profile in ["index-basic-d", "viewplus-columbia", "swell-a3"] {
        let args = ["render", "drawn.svg", "--profile", profile, "--set", "overview=false", "-o", "new.svg"];
        let told = done(&place, &args);
        assert!(told.contains("line \"my crumb\", too short for this page"), "{profile}: {told}");
        assert!(!told.contains("my roof") && !told.contains("my cross"), "{profile}: {told}");
        let new = read(&place, "new.svg");
        let (from, to) = (figure, new.figure.place);
        let there = |at: MmPoint| to.min + (at - from.min) * (to.width() / from.width());
        let points =
            || new.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.path().zip(run.path().skip(1)));
        let near = |at: MmPoint| {
            let of = points().map(|(a, b)| tactograph::internals::geom::nearest_on_segment(at, a, b).0);
            of.fold(f32::MAX, f32::min)
        };
        // a grid has a dot within 1.8 mm of any place
        for (start, step) in [(beside, MmPoint::new(0.0, 2.0)), (across, MmPoint::new(2.0, 0.0))] {
            let off = (1..11).map(|k| near(there(start + step.to_vector() * k as f32))).fold(0.0, f32::max);
            assert!(off < 1.9, "{profile}: the line is {off} mm from where it was drawn");
        }
    }
    // on paper it keeps the width that its maker gave it
    let new = read(&place, "new.svg");
    let widths = new.figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.width);
    assert!(widths.clone().any(|width| (width - 0.8).abs() < 0.011), "{:?}", widths.collect::<Vec<_>>());
}

#[test]
fn unicode_braille_stands_where_it_was_typed() {
    let place = with_chart(&[]);
    let added = "<g id=\"labels-text\" transform=\"translate(3 4)\"><text x=\"30\" y=\"50\">\u{2813}\u{280a}</text></g>\
                 <text x=\"75\" y=\"104\">\u{2801}\u{2803}\u{2801}\u{2803}\u{2801}\u{2803}\u{2801}\u{2803}\u{2801}</text>";
    with(&place, "page.svg", added, "typed.svg");
    let told = done(&place, &["render", "typed.svg", "-o", "done.svg"]);
    let page = read(&place, "done.svg");
    let hi = page.braille.iter().find(|text| text.lines == ["\u{2813}\u{280a}"]).expect("it is written");
    let dots = hi.dots.at.iter();
    let [left, low] = [dots.clone().map(|at| at.x).fold(f32::MAX, f32::min), dots.map(|at| at.y).fold(0.0, f32::max)];
    // the first cell has dots 1, 2 and 5, the second 2 and 4: no dot on the lowest row, which stands on the line
    assert!((left - 33.75).abs() < 1.1 && (low - (54.0 - 2.5 - 0.75)).abs() < 1.1, "{left}, {low}");
    assert!(!told.contains("braille \"\u{2813}\u{280a}\" stands beside"), "{told}");
    // the other is wider than a bar, and would lie on its lines
    assert!(told.contains("\u{2801}\u{2803}\u{2801}\" stands beside the place where it was typed"), "{told}");
    let checked = place.run(&["check", "typed.svg"]);
    let of_hi = "33 mm from the left and 54 mm from the top: \"\u{2813}\u{280a}\" is braille in a font";
    assert!(checked.out.contains("warning braille-cell: ") && checked.out.contains(of_hi), "{}", checked.out);
    assert!(!checked.out.contains("written in letters"), "{}", checked.out);
}

/// The page of a labelled chart with the label moved by so much.
fn moved(svg: &str, text: &str, x: f32, y: f32) -> String {
    let label = svg.find(&format!("aria-label=\"{text}\"")).expect("the label");
    let start = svg[..label].rfind("<g ").expect("its group");
    format!("{}<g transform=\"translate({x} {y})\" {}", &svg[..start], &svg[start + 3..])
}

#[test]
fn braille_that_was_moved_onto_something_is_told_and_print_follows_it() {
    let place = with_chart(&[]);
    place.put("labels.csv", b"10%,8%,Rain\n80%,8%,Sun\n");
    let args = ["convert", "chart.svg", "--no-overview", "--labels", "labels.csv", "--set", "braille.print=true"];
    done(&place, &[&args[..], &["-q", "--force", "-o", "page.svg"]].concat());
    let svg = place.text("page.svg");
    let told = done(&place, &["render", "page.svg", "-o", "same.svg"]);
    assert!(!told.contains("note") && place.text("same.svg") == svg, "{told}");
    let first = |page: &Page, text: &str| page.braille.iter().find(|of| of.text == text).expect("the label").dots.at[0];
    let print = |page: &Page, text: &str| page.print.iter().find(|of| of.string == text).expect("its print").at;
    let before = read(&place, "page.svg");
    let off = print(&before, "Rain") - first(&before, "Rain");
    // downwards, onto an axis or a bar
    let bottom = before.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
    let bottom = bottom.map(|at| at.y).fold(0.0, f32::max);
    let down = bottom - first(&before, "Rain").y - 2.0;
    place.put("moved.svg", moved(&svg, "Rain", 40.0, down).as_bytes());
    let told = done(&place, &["render", "moved.svg", "-o", "done.svg"]);
    assert!(
        told.contains("braille stays where it is on the page: \"Rain\" is ") && told.contains(" from line "),
        "{told}"
    );
    assert!(told.contains("3 mm of blank is the least (at "), "{told}");
    assert!(told.contains("the words in print \"Rain\" follow their braille, which was moved"), "{told}");
    let after = read(&place, "done.svg");
    assert!((print(&after, "Rain") - first(&after, "Rain") - off).length() < 0.05);
    assert!((print(&after, "Sun") - print(&before, "Sun")).length() < 0.05, "the other stays");
    // a line that is drawn through a label
    let at = first(&before, "Sun");
    let line = format!("<path d=\"M{},{}h20\" stroke=\"#000\" stroke-width=\"1\"/>", at.x - 5.0, at.y);
    with(&place, "page.svg", &line, "crossed.svg");
    let told = done(&place, &["render", "crossed.svg", "-o", "x.svg"]);
    assert!(told.contains("\"Sun\" is 0 mm from a line without a name"), "{told}");
    // what is typed anew has its print too, and a mirrored page tells that it has none
    with(&place, "page.svg", "<g id=\"labels-text\"><text x=\"60\" y=\"50\">Ice</text></g>", "typed.svg");
    done(&place, &["render", "typed.svg", "-o", "typed-done.svg"]);
    print(&read(&place, "typed-done.svg"), "Ice");
    let told = done(&place, &[&args[..], &["--mirror", "--force", "-o", "mirrored.svg"]].concat());
    assert!(told.contains("words in print (braille.print), as the page is mirrored"), "{told}");
}

#[test]
fn areas_of_a_corrected_page_are_taken_without_what_render_tells() {
    let place = with_page("swell-a4");
    let line = "<path d=\"M30,115h30\" stroke=\"#000\" stroke-width=\"0.2\"/>";
    let area = "<path d=\"M30,100h30v30h-30z\" fill=\"#1040d0\"/>";
    with(&place, "cup.svg", &format!("{area}{line}"), "edited.svg");
    let told = done(&place, &["convert", "cup.png", "--regions", "edited.svg", "--no-overview", "-o", "new.svg"]);
    assert!(told.contains("1 drawn area filled with the texture of its colour"), "{told}");
    for of_render in ["mm wide, the least of the profile", "too near to a line", "the overview is as it was"] {
        assert!(!told.contains(of_render), "{told}");
    }
}

#[test]
fn what_render_finds_wrong_and_what_lines_of_a_page_leave_behind_is_told() {
    let place = with_chart(&["--title", "Rain", "--key", "never"]);
    let told = done(&place, &["render", "page.svg", "-o", "whole.svg"]);
    assert!(!told.contains("a check finds"), "{told}");
    let near = "<path d=\"M40,30H90M40,31.5H90\" fill=\"none\" stroke=\"#000\" stroke-width=\"1\"/>";
    with(&place, "page.svg", near, "near.svg");
    let told = done(&place, &["render", "near.svg", "-o", "near.pdf"]);
    let found = "note: a check finds 1 error (line-gap): upper left of the sheet, 42 mm from the left";
    assert!(told.contains(found) && told.contains("tactograph check of the page tells all"), "{told}");
    assert!(!told.contains("line 1"), "its numbers are not those of the file: {told}");
    let again = ["convert", "chart.svg", "--lines", "page.svg", "--no-overview", "-o"];
    let told = done(&place, &[&again[..], &["lines.svg"]].concat());
    assert!(told.contains("1 braille text of the page that the lines are of; give title and labels again"), "{told}");
    let told = done(&place, &[&again[..], &["titled.svg", "--title", "Rain"]].concat());
    assert!(!told.contains("that the lines are of"), "{told}");
}

#[test]
fn a_file_of_lines_without_lines_is_told_and_a_photograph_too() {
    let place = Place::new();
    place.put("cup.png", &samples::read("coffee.png"));
    place.put("white.png", &png(600, 400, &vec![255; 600 * 400 * 3]));
    place.put("black.png", &png(600, 400, &vec![0; 600 * 400 * 3]));
    let svg = |around: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 315 216'><g id='lines' fill='none' stroke='#000' \
             {around}><path d='M20 20H280'/></g></svg>"
        )
    };
    place.put("hidden.svg", svg("style='display:none'").as_bytes());
    place.put("shown.svg", svg("").as_bytes());
    let told = |option: &str, file: &str| {
        let run = place.run(&["convert", "cup.png", option, file, "-o", "page.svg", "--force"]);
        assert_eq!(run.code, 0, "{}", run.err);
        run.err
    };
    for (option, file) in
        [("--lines", "white.png"), ("--lines", "black.png"), ("--lines", "hidden.svg"), ("--add-lines", "hidden.svg")]
    {
        let told = told(option, file);
        assert!(told.contains("it has no lines") && !told.contains("edges.high"), "{option} {file}: {told}");
    }
    let photograph = told("--lines", "cup.png");
    assert!(photograph.contains("it looks like no picture of lines"), "{photograph}");
    for (option, file) in [("--lines", "shown.svg"), ("--add-lines", "shown.svg")] {
        let told = told(option, file);
        assert!(!told.contains("it has no lines") && !told.contains("no picture of lines"), "{option} {file}: {told}");
    }
}
