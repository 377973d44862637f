//! Several sheets of a device of dots, and words on several sheets.

use crate::common::samples;
use tactograph::internals::page::Page;
use tactograph::internals::pipeline::sheets::Sheets;
use tactograph::internals::units::MmVector;
use tactograph::marks::{Run, TextRole};
use tactograph::medium::{DotArea, Medium};
use tactograph::{
    KeySheets, Label, MmPoint, Note, Options, Position, Profile, RenderOptions, Severity, convert_to_sheets,
};

fn profile(name: &str, settings: &[(&str, &str)]) -> Profile {
    let mut profile = Profile::named(name).expect("built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("the test sets what there is"));
    profile
}

fn sheets(picture: &str, grid: &str, options: &Options) -> Sheets {
    let grid = grid.parse().expect("a grid");
    convert_to_sheets(&samples::read(picture), Some(grid), options).expect("there is room")
}

/// Every dot of a page's figure with its frame.
fn dots(page: &Page) -> Vec<MmPoint> {
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(|glyph| glyph.at);
    let lines = page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied());
    glyphs.chain(lines).chain(page.frame.at.iter().copied()).collect()
}

/// Every dot of everything on a page.
fn all_dots(page: &Page) -> Vec<MmPoint> {
    let marks = page.orientation_mark.iter().chain(&page.registration).flat_map(|run| run.points.iter().copied());
    let braille = page.braille.iter().map(|text| &text.dots).chain(&page.labels).flat_map(|dots| dots.at.clone());
    dots(page).into_iter().chain(marks).chain(braille).collect()
}

/// The dots of the ticks beside the overlap of two sheets side by side, on the first and on the second, in one order.
fn ticks(page: &Page, on_right: bool) -> Vec<MmPoint> {
    let stands = |run: &&Run| (run.points[0].x - run.points[1].x).abs() < 0.01;
    let middle = page.figure.place.center().x;
    let own = page.registration.iter().filter(stands).filter(|run| (run.points[0].x > middle) == on_right);
    own.flat_map(|run| run.points.iter().copied()).collect()
}

/// Laid by their ticks, two sheets have the same dots where both show the picture, and each dot is one of its device.
#[test]
fn sheets_of_dots_agree_in_their_overlap() {
    for (device, pitch) in [("index-basic-d", 2.5), ("viewplus-columbia", 1.27), ("braille-cells", 3.7)] {
        let options = Options::new(profile(device, &[("sheets.overlap", "40"), ("page.orientation", "portrait")]));
        let drawn = sheets("coffee.png", "2x1", &options);
        let [first, second] = &drawn.pages[..] else { panic!("{device}: {} sheets", drawn.pages.len()) };
        for page in drawn.all() {
            let Medium::Dots(medium) = &page.medium else { panic!("{device}: a printed page") };
            let DotArea::Grid(grid) = &medium.area else { panic!("{device}: no grid") };
            let is_dot = |at: &MmPoint| {
                grid.columns.iter().any(|x| (x - at.x).abs() < 1e-3)
                    && grid.rows.iter().any(|y| (y - at.y).abs() < 1e-3)
            };
            let off = all_dots(page).into_iter().find(|at| !is_dot(at));
            assert!(off.is_none(), "{device}, {}: {off:?} is no dot of the device", page.title);
        }
        let (here, there) = (ticks(first, true), ticks(second, false));
        assert!(!here.is_empty() && here.len() == there.len(), "{device}: {} and {} ticks", here.len(), there.len());
        let way: MmVector = here[0] - there[0];
        let apart = here.iter().zip(&there).map(|(a, b)| (*a - (*b + way)).length()).fold(0.0, f32::max);
        assert!(apart < 0.01, "{device}: ticks do not meet, {apart} mm");
        let (here_dots, there_dots): (Vec<MmPoint>, Vec<MmPoint>) =
            (dots(first), dots(second).into_iter().map(|at| at + way).collect());
        // pieces of lines of fewer than three dots at the edge of a window are on one sheet only
        let middle = here[0].x;
        let within = |at: &&MmPoint| (at.x - middle).abs() < 20.0 - 4.0 * pitch;
        let mut compared = 0;
        for (one, other) in [(&here_dots, &there_dots), (&there_dots, &here_dots)] {
            for at in one.iter().filter(within) {
                compared += 1;
                let nearest = other.iter().map(|dot| (*dot - *at).length()).fold(f32::MAX, f32::min);
                assert!(nearest < 0.01, "{device}: the dot at {at:?} is on one sheet only, {nearest} mm");
            }
        }
        assert!(compared > 40, "{device}: {compared} dots to compare");
    }
}

/// Sheets of every kind of device can be written for it, and what fingers need holds on each of them.
#[test]
fn sheets_of_dots_pass_the_check() {
    for (device, grid) in
        [("index-basic-d", "2x2"), ("viewplus-columbia", "1x2"), ("monarch", "2x2"), ("braillerap", "2x1")]
    {
        let options = Options::new(profile(device, &[])).title("A cup of coffee").page_number(3);
        let drawn = sheets("coffee.png", grid, &options);
        assert!(drawn.pages.len() >= 2, "{device}");
        for page in drawn.all() {
            let svg = page.to_svg();
            let checked = tactograph::check(&svg, &tactograph::PageOptions::new()).expect("a page");
            let errors: Vec<String> = checked
                .findings
                .iter()
                .filter(|finding| finding.rule.severity == Severity::Error)
                .map(|finding| finding.to_string())
                .collect();
            assert!(errors.is_empty(), "{device}, {}: {errors:#?}", page.title);
            let again = tactograph::render(&svg, &RenderOptions::new()).expect("a page").page.to_svg();
            assert!(again == svg, "{device}, {}: it is not read as it was written", page.title);
        }
    }
}

fn label(x: f64, y: f64, text: &str) -> Label {
    let percent = |at| Position::percent(at).expect("a number");
    Label { x: percent(x), y: percent(y), text: text.to_owned() }
}

/// Every sheet has the title and its number, every label is whole on a sheet, and what is abbreviated is in the key.
#[test]
fn words_stand_on_several_sheets() {
    let names = ["corner", "left", "middle", "beside the middle", "right", "low"];
    let places = [(5.0, 5.0), (20.0, 50.0), (50.0, 50.0), (53.0, 47.0), (80.0, 50.0), (50.0, 95.0)];
    let labels: Vec<Label> = names.iter().zip(places).map(|(text, (x, y))| label(x, y, text)).collect();
    for (device, align) in [("swell-a4", "centre"), ("swell-a4", "left"), ("index-basic-d", "centre")] {
        let options = Options::new(profile(device, &[("braille.align", align)]));
        let options = options.title("Rain").page_number(7).labels(labels.clone()).key(KeySheets::Always);
        let drawn = sheets("bars.svg", "2x2", &options);
        assert_eq!(drawn.pages.len(), 4, "{device}");
        assert!(!drawn.key.is_empty(), "{device}: no key");
        assert!(drawn.key.iter().all(|page| page.title == "Rain, key"), "{device}");
        for (number, page) in (7..).zip(drawn.overview.iter().chain(&drawn.pages)) {
            let of = |role: TextRole| page.braille.iter().filter(move |text| text.role == role);
            let title: Vec<&str> = of(TextRole::Title).map(|text| text.text.as_str()).collect();
            assert_eq!(title, ["Rain"], "{device}, {}", page.title);
            let own: Vec<String> = of(TextRole::Number).map(|text| text.text.clone()).collect();
            assert_eq!(own, [number.to_string()], "{device}, {}", page.title);
            // title, number and the braille of the sheet keep apart, on one line
            let boxes = of(TextRole::Title).chain(of(TextRole::Number)).map(|text| &text.dots).chain(&page.labels);
            let mut spans: Vec<[f32; 2]> = boxes
                .map(|dots| {
                    let x = || dots.at.iter().map(|at| at.x);
                    [x().fold(f32::MAX, f32::min), x().fold(0.0, f32::max)]
                })
                .collect();
            spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
            assert!(spans.windows(2).all(|pair| pair[1][0] - pair[0][1] > 12.0), "{device}: {spans:?}");
            // sheets may be cut at the ticks: no label lies across
            for tick in &page.registration {
                let (a, b) = (tick.points[0], tick.points[1]);
                let along = |at: &MmPoint| if (a.x - b.x).abs() < 0.01 { at.x - a.x } else { at.y - a.y };
                for text in of(TextRole::Label) {
                    let sides = text.dots.at.iter().map(|at| along(at) > 0.0);
                    let first = sides.clone().next();
                    assert!(sides.clone().all(|side| Some(side) == first), "{device}: {} is cut", text.text);
                }
            }
        }
        let left_out: Vec<String> = drawn
            .notes
            .iter()
            .filter_map(|note| match note {
                Note::LabelsLeftOut { texts, .. } => Some(texts.clone()),
                _ => None,
            })
            .flatten()
            .collect();
        for name in names.iter().filter(|name| !left_out.iter().any(|text| text == *name)) {
            let on = drawn.pages.iter().filter(|page| page.braille.iter().any(|text| text.text == *name)).count();
            assert!(on >= 1, "{device}: {name} is on no sheet");
        }
        assert!(left_out.len() <= 2, "{device}: {left_out:?}");
    }
}

/// A title for which the sheets have no room is told once, and a page that was made already is refused.
#[test]
fn what_cannot_be_on_several_sheets_is_told() {
    let long = "A title that is far too long for the three lines that a sheet has for it ".repeat(4);
    let drawn = sheets("bars.svg", "2x1", &Options::new(profile("swell-a4", &[])).title(long));
    let told = drawn.notes.iter().filter(|note| matches!(note, Note::NoRoomForTitle { .. })).count();
    assert_eq!(told, 1, "{:?}", drawn.notes);
    let page = drawn.pages[0].to_svg();
    let refused = convert_to_sheets(page.as_bytes(), None, &Options::new(profile("swell-a4", &[])));
    assert_eq!(refused.err(), Some(tactograph::Error::IsAPage));
}

#[test]
fn remarks_with_a_place_name_its_sheet_and_count_from_the_edges_of_that() {
    let made = sheets("landscape.svg", "2x2", &Options::new(profile("index-basic-d", &[])));
    let told = |made: &Sheets, what: &str| {
        let told: Vec<String> = made.notes.iter().map(ToString::to_string).collect();
        told.iter().find(|told| told.contains(what)).cloned().unwrap_or_else(|| panic!("no {what} in {told:?}"))
    };
    let line = told(&made, "1 line as a whole");
    assert!(line.contains("mm from the left and the top of sheet "), "{line}");
    let map = sheets("map.svg", "2x2", &Options::new(profile("index-basic-d", &[])));
    let area = told(&map, "areas that are closed in the figure");
    assert!(area.contains(" mm on sheet "), "{area}");
    let numbers = line.split_once("around ").and_then(|(_, place)| place.split_once(" mm")).expect("a place").0;
    let numbers: Vec<f32> = numbers.split(", ").map(|number| number.parse().expect("a number")).collect();
    let [width, height] = made.pages[0].sheet;
    assert!(numbers[0] <= width && numbers[1] <= height, "{line}");
}
