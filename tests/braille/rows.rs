//! Labels in rows and columns, as at the axes of a chart: in their order, in one form, each at what it names.

use super::labels::{labels_of, options, place};
use std::fmt::Write as _;
use tactograph::marks::{BrailleText, Line};
use tactograph::{Drawing, MmPoint, MmRect, Note, convert};

const MONTHS: [&str; 14] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
    "Undecember",
    "Duodecember",
];
const PROFILES: [&str; 4] = ["swell-a4", "index-basic-d", "viewplus-columbia", "pins-120x60"];

/// A chart of so many bars with months below them, of so many letters, and numbers at its axis.
fn chart(bars: usize, letters: usize) -> String {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600' font-family='sans-serif' \
        font-size='16'><rect width='900' height='600' fill='#fff'/>\
        <path d='M80 60V520H870' fill='none' stroke='#000' stroke-width='3'/>"
        .to_owned();
    for (k, y) in (0..6).map(|k| (k, 520 - 92 * k)) {
        write!(svg, "<text x='68' y='{}' text-anchor='end'>{}</text>", y + 5, 20 * k).expect("a string takes it");
    }
    let step = 790.0 / bars as f32;
    for (i, month) in MONTHS.iter().enumerate().take(bars) {
        let (x, width, height) = (80.0 + step * (i as f32 + 0.5), 0.6 * step, 60 + (i * 137) % 380);
        let (left, top) = (x - 0.5 * width, 520 - height);
        let name: String = month.chars().take(letters).collect();
        write!(
            svg,
            "<rect x='{left}' y='{top}' width='{width}' height='{height}' fill='#2060c0' stroke='#000' \
             stroke-width='2'/><text x='{x}' y='542' text-anchor='middle'>{name}</text>"
        )
        .expect("a string takes it");
    }
    svg + "</svg>"
}

fn drawn(svg: &str, profile: &str) -> Drawing {
    convert(svg.as_bytes(), &options(profile).label_texts(true)).expect("a page")
}

/// Where a share of the picture lies on the sheet.
fn across(figure: MmRect, share: f32) -> f32 {
    figure.min.x + share * figure.width()
}

/// Every month stands below its own bar, in one row or in two by turns, all as words or all abbreviated; every number
/// stands at its height beside the axis. Nothing is left out and no leader line is needed.
#[test]
fn every_label_of_a_chart_stands_at_what_it_names() {
    for (bars, letters) in [(6, 9), (8, 9), (12, 3), (14, 3)] {
        let svg = chart(bars, letters);
        for profile in PROFILES {
            let drawing = drawn(&svg, profile);
            let figure = drawing.page.figure.place;
            let of = |what: &str| format!("{bars} bars on {profile}: {what}");
            let labels = labels_of(&drawing);
            assert!(labels.iter().all(|label| label.leader.is_none()), "{}", of("leader lines"));
            let (numbers, months): (Vec<_>, Vec<_>) =
                labels.into_iter().partition(|label| label.text.starts_with(|first: char| first.is_ascii_digit()));
            assert_eq!((numbers.len(), months.len()), (6, bars), "{}", of("labels are lost"));
            let step = 790.0 / 900.0 / bars as f32;
            for (i, month) in months.iter().enumerate() {
                let at = across(figure, 80.0 / 900.0 + step * (i as f32 + 0.5));
                let off = (place(month).center().x - at).abs();
                // no nearer to the next bar
                let least = (0.35 * step * figure.width()).max(2.6);
                assert!(off < least, "{}: {off} mm", of(&month.text));
                let first = place(months[i % 2]);
                assert!((place(month).max.y - first.max.y).abs() < 2.6, "{} in no row", of(&month.text));
            }
            let short = months.iter().filter(|month| month.abbreviation.is_some()).count();
            assert!(short == 0 || short == bars, "{}", of("two forms in one row"));
            for number in numbers {
                let value: f32 = number.text.parse().expect("a number");
                let at = figure.min.y + (520.0 - 4.6 * value) / 600.0 * figure.height();
                let off = (place(number).center().y - at).abs();
                assert!(off < 5.0, "{}: {off} mm", of(&number.text));
                let axis = across(figure, 80.0 / 900.0);
                assert!(place(number).max.x < axis || value > 99.0, "{} in the chart", of(&number.text));
            }
        }
    }
}

/// Small shapes that have no room beside others are told by the label that names them.
#[test]
fn a_town_that_is_not_on_the_page_is_told_by_its_name() {
    let map = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='400' font-family='sans-serif' \
        font-size='16'><rect width='600' height='400' fill='#fff'/>\
        <path d='M50 40C200 120 300 260 560 360' fill='none' stroke='#2060c0' stroke-width='6'/>\
        <circle cx='200' cy='131' r='6' fill='#c02020' stroke='#000'/><text x='220' y='120'>Aston</text>\
        <circle cx='450' cy='90' r='8' fill='#c02020' stroke='#000'/><text x='470' y='80'>Ely</text></svg>";
    let drawing = drawn(map, "viewplus-columbia");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    let lost = told.iter().find(|note| note.contains("small shape")).expect("Aston's mark is lost");
    assert!(lost.contains("\"Aston\"") && !lost.contains("\"Ely\""), "{lost}");
}

/// The road over a town covers two pieces of its outline, which is a small closed shape all the same.
#[test]
fn a_town_under_a_road_that_is_not_on_the_page_is_told_by_its_name() {
    let map = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 700 800' font-family='sans-serif' font-size='18'>\
        <rect width='700' height='800' fill='#fff'/>\
        <path d='M250 100C270 260 220 310 260 380S230 500 270 560 280 680 300 720' fill='none' stroke='#27c' \
        stroke-width='5'/><circle cx='275' cy='480' r='8' fill='#c00'/><circle cx='520' cy='230' r='8' fill='#c00'/>\
        <path d='M150 450L275 480L490 540' stroke='#444' stroke-width='3' stroke-dasharray='10 5' fill='none'/>\
        <text x='300' y='470'>Aston</text><text x='535' y='235'>Ely</text></svg>";
    for profile in ["swell-a4", "viewplus-columbia"] {
        let told: Vec<String> = drawn(map, profile).notes.iter().map(ToString::to_string).collect();
        let lost = told.iter().find(|note| note.contains("small shape"));
        let lost = lost.unwrap_or_else(|| panic!("{profile}: Aston's mark is lost, {told:#?}"));
        assert!(lost.contains("\"Aston\"") && !lost.contains("\"Ely\""), "{profile}: {lost}");
    }
}

/// A grid with axes through its middle, which have numbers at every line, and a curve.
fn grid(lines: usize) -> String {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='620' height='620' font-family='sans-serif' \
        font-size='14'><rect width='620' height='620' fill='#fff'/>"
        .to_owned();
    let step = 500.0 / (lines - 1) as f32;
    let half = (lines / 2) as i32;
    for i in -half..=half {
        let at = 310.0 + step * i as f32;
        write!(svg, "<path d='M{at} 60V560M60 {at}H560' stroke='#ccc' fill='none'/>").expect("a string takes it");
        write!(svg, "<text x='{at}' y='334' text-anchor='middle'>{i}</text>").expect("a string takes it");
        if i != 0 {
            write!(svg, "<text x='300' y='{}' text-anchor='end'>{}</text>", at + 5.0, -i).expect("a string takes it");
        }
    }
    svg + "<path d='M40 310H580M310 580V40' stroke='#000' stroke-width='2'/>\
        <path d='M110 100Q310 800 510 100' fill='none' stroke='#c22' stroke-width='3'/></svg>"
}

/// Numbers of axes through the middle of a grid have no room beside them: they stand in the margin, each in line with its
/// own line of the grid, and that is told.
#[test]
fn numbers_of_axes_in_a_grid_stand_in_the_margin() {
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = drawn(&grid(9), profile);
        let (labels, figure) = (labels_of(&drawing), drawing.page.figure.place);
        assert_eq!(labels.len(), 17, "{profile}: {:?}", drawing.notes);
        let told = drawing.notes.iter().any(|note| note.to_string().contains("stand in the margin"));
        assert!(told, "{profile}: {:?}", drawing.notes);
        let lines = MmRect::from_points(
            drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter()),
        );
        for label in labels {
            let value: f32 = label.text.replace('\u{2212}', "-").parse().expect("a number");
            let (middle, of) = (place(label).center(), format!("{} on {profile}", label.text));
            assert!(label.leader.is_none(), "{of}");
            let at = |value: f32| (310.0 + 62.5 * value) / 620.0;
            if place(label).max.x < lines.min.x {
                assert!((middle.y - (figure.min.y + at(-value) * figure.height())).abs() < 5.0, "{of}");
            } else {
                assert!(middle.y > lines.max.y, "{of} is in the grid");
                assert!((middle.x - across(figure, at(value))).abs() < 6.0, "{of}");
            }
        }
    }
}

/// Where there is no room for all numbers of an axis, every second, fifth or tenth stays, from zero on, and those that
/// are left out are told, all of them.
#[test]
fn numbers_without_room_are_thinned_evenly() {
    let drawing = drawn(&grid(41), "swell-a4");
    let written: Vec<i32> = labels_of(&drawing).iter().filter_map(|label| label.text.parse().ok()).collect();
    let every = [2, 5, 10].into_iter().rev().find(|every| written.iter().all(|value| value % every == 0));
    let every = every.expect("even steps");
    assert!(written.contains(&0) && written.contains(&-every) && written.contains(&every), "{written:?}");
    let told = drawing.notes.iter().filter_map(|note| match note {
        Note::LabelsLeftOut { texts, why: told, .. } if told.contains("number along an axis only") => Some(texts.len()),
        _ => None,
    });
    assert_eq!(written.len() + told.sum::<usize>(), 81, "{:?}", drawing.notes);
}

/// Twelve months under bars, with a legend right below them: all of them stay, in one form, and none has a leader line
/// across others.
#[test]
fn months_above_a_legend_stay_in_one_form() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='570' font-family='sans-serif' \
        font-size='15'><rect width='800' height='570' fill='#fff'/>\
        <path d='M80 70V480H704V70' fill='none' stroke='#000' stroke-width='2'/>\
        <rect x='240' y='530' width='20' height='16' fill='#47d'/><text x='266' y='544'>Rain</text>\
        <path d='M400 538H430' stroke='#d22' stroke-width='4'/><text x='438' y='544'>Temperature</text>"
        .to_owned();
    for (i, month) in MONTHS.iter().enumerate().take(12) {
        let (x, name): (usize, String) = (106 + 52 * i, month.chars().take(3).collect());
        let (left, top) = (x - 16, 250 + (i * 61) % 150);
        let height = 480 - top;
        write!(
            svg,
            "<rect x='{left}' y='{top}' width='32' height='{height}' fill='#47d'/>\
             <text x='{x}' y='502' text-anchor='middle'>{name}</text>"
        )
        .expect("a string takes it");
    }
    for i in 0..6 {
        write!(svg, "<text x='712' y='{}'>{} \u{b0}C</text>", 485 - 80 * i, 5 * i).expect("a string takes it");
    }
    let svg = svg + "</svg>";
    for profile in ["swell-a4", "index-basic-d", "viewplus-columbia"] {
        let drawing = drawn(&svg, profile);
        let labels = labels_of(&drawing);
        let names: Vec<String> = MONTHS.iter().map(|month| month.chars().take(3).collect()).collect();
        let months: Vec<_> = labels.iter().filter(|label| names.contains(&label.text)).collect();
        assert_eq!(months.len(), 12, "{profile}: {:?}", drawing.notes);
        let short = months.iter().filter(|month| month.abbreviation.is_some()).count();
        assert!(short == 0 || short == 12, "{profile}: two forms in one row");
        // a name of the legend may stand on the other side of its sample
        let crossing = drawing
            .notes
            .iter()
            .map(ToString::to_string)
            .filter(|note| note.contains(" other lines, as there is no room for the label"));
        let of_legend = "the leader line of \"Temperature\" crosses";
        assert!(crossing.into_iter().all(|note| note.contains(of_legend)), "{profile}: {:?}", drawing.notes);
        // a unit that has no room behind each number stands with one of them
        let numbers: Vec<_> = labels.iter().filter(|label| label.text.ends_with('C')).collect();
        assert_eq!(numbers.len(), 6, "{profile}: {:?}", drawing.notes);
        let with_unit = numbers.iter().filter(|number| number.lines.concat().contains('\u{2818}')).count();
        assert!(with_unit == 6 || with_unit == 1, "{profile}: {with_unit} units");
    }
}

/// Texts in boxes that have no room in them stand beside their box, or have a leader line that ends at it.
#[test]
fn leader_lines_end_at_the_outline_of_a_box() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='420' font-family='sans-serif' \
        font-size='16'><rect width='600' height='420' fill='#fff'/><g fill='none' stroke='#000' stroke-width='3'>\
        <rect x='220' y='40' width='160' height='40'/><rect x='220' y='180' width='160' height='40'/>\
        <rect x='220' y='320' width='160' height='40'/><path d='M300 80V180M300 220V320'/></g>\
        <g text-anchor='middle'><text x='300' y='66'>Ask for a number</text>\
        <text x='300' y='206'>Add one to it</text><text x='300' y='346'>Tell the sum</text></g></svg>";
    for profile in ["swell-a4", "index-basic-d", "viewplus-columbia"] {
        let drawing = drawn(svg, profile);
        assert!(
            !drawing
                .notes
                .iter()
                .any(|note| note.to_string().contains(" other lines, as there is no room for the label")),
            "{profile}"
        );
        let labels = labels_of(&drawing);
        assert_eq!(labels.len(), 3, "{profile}");
        let figure = drawing.page.figure.place;
        for leader in labels.iter().filter_map(|label| label.leader.as_ref()) {
            let tip = *leader.points.last().expect("two ends");
            let inside = |top: f32| {
                let at = |x: f32, y: f32| MmPoint::new(across(figure, x), figure.min.y + y * figure.height());
                let corners = [(220.0, top), (380.0, top + 40.0)].map(|(x, y)| at(x / 600.0, y / 420.0));
                // on dots a line lies up to half a step aside, and may have a second row
                MmRect::new(corners[0], corners[1]).inflate(-3.5, -3.5).contains(tip)
            };
            assert!(![40.0, 180.0, 320.0].into_iter().any(inside), "{profile}: {tip:?} is in a box");
        }
    }
}

/// On a number line of which only every fifth tick is on the page, as the others have no room, the numbers at these stay where there is
/// no room for all, so that who counts ticks reads the right number.
#[test]
fn numbers_stand_at_the_ticks_that_are_on_the_page() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='1000' height='200' font-family='sans-serif' \
        font-size='18'><rect width='1000' height='200' fill='#fff'/>\
        <line x1='40' y1='100' x2='960' y2='100' stroke='#000' stroke-width='3'/>"
        .to_owned();
    for value in -20..=20 {
        let (x, half) = (500 + 21 * value, if value % 5 == 0 { 20 } else { 12 });
        write!(
            svg,
            "<line x1='{x}' x2='{x}' y1='{}' y2='{}' stroke='#000' stroke-width='2'/>\
             <text x='{x}' y='145' text-anchor='middle'>{value}</text>",
            100 - half,
            100 + half
        )
        .expect("a string takes it");
    }
    let drawing = drawn(&(svg + "</svg>"), "swell-a4");
    let written: Vec<(i32, MmRect)> =
        labels_of(&drawing).iter().map(|label| (label.text.parse().expect("a number"), place(label))).collect();
    assert_eq!(written.iter().map(|(value, _)| *value).collect::<Vec<_>>(), [-20, -15, -10, -5, 0, 5, 10, 15, 20]);
    let figure = drawing.page.figure.place;
    for (value, at) in written {
        let tick = across(figure, 0.5 + 0.021 * value as f32);
        assert!((at.center().x - tick).abs() < 3.5, "{value} stands {} mm beside its tick", at.center().x - tick);
    }
}

/// The title of an upright axis stands above its numbers, that of a level one below its own; neither covers another
/// label, and neither is left out or abbreviated.
#[test]
fn titles_of_axes_stand_at_their_ends() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='480' font-family='sans-serif' \
        font-size='18'><rect width='640' height='480' fill='#fff'/>\
        <path d='M100 60V400H560' fill='none' stroke='#000' stroke-width='3'/>\
        <path d='M100 380L260 250L420 120L500 100' fill='none' stroke='#c22' stroke-width='3'/>\
        <text x='330' y='455' text-anchor='middle'>Time in hours</text>\
        <text x='40' y='230' text-anchor='middle' transform='rotate(-90 40 230)'>Height in cm</text>"
        .to_owned();
    for i in 0..6 {
        write!(svg, "<text x='{}' y='425' text-anchor='middle'>{i}</text>", 100 + 80 * i).expect("a string takes it");
    }
    for i in 1..5 {
        write!(svg, "<text x='85' y='{}' text-anchor='end'>{}</text>", 406 - 80 * i, 10 * i)
            .expect("a string takes it");
    }
    for profile in ["swell-a4", "index-basic-d", "viewplus-columbia"] {
        let drawing = drawn(&(svg.clone() + "</svg>"), profile);
        let labels = labels_of(&drawing);
        assert!(labels.iter().all(|label| label.abbreviation.is_none()), "{profile}: {:?}", drawing.notes);
        let of = |text: &str| {
            let found = labels.iter().find(|label| label.text == text);
            place(found.unwrap_or_else(|| panic!("{profile}: {text} is left out: {:?}", drawing.notes)))
        };
        let (upright, level, top, first) = (of("Height in cm"), of("Time in hours"), of("40"), of("0"));
        assert!(upright.max.y < top.min.y && upright.min.x <= top.max.x, "{profile}: {upright:?} {top:?}");
        assert!(level.min.y > first.max.y, "{profile}: {level:?} {first:?}");
    }
}

/// Ticks that are drawn longer reach beyond a title that stands close to its numbers, as in charts of matplotlib: it
/// stands above them all the same, without a leader line, which would end at a number.
#[test]
fn a_title_beside_ticks_that_are_drawn_longer_stands_above_its_numbers() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='504' height='360' font-family='sans-serif' \
        font-size='10'><rect width='504' height='360' fill='#fff'/>\
        <path d='M44 30V320H490M60 320V220H120V320M120 220V120H180V320M180 180H240V320' fill='none' stroke='#000'/>\
        <text x='18.5' y='175' text-anchor='middle' transform='rotate(-90 18.5 175)'>Frequency</text>"
        .to_owned();
    for k in 0..5 {
        let y = 320 - 60 * k;
        write!(
            svg,
            "<path d='M40.5 {y}H44' stroke='#000'/><text x='37' y='{}' text-anchor='end'>{}</text>",
            y + 4,
            2 * k
        )
        .expect("a string takes it");
    }
    let drawing = drawn(&(svg + "</svg>"), "swell-a4");
    let labels = labels_of(&drawing);
    let of = |text: &str| {
        let found = labels.iter().find(|label| label.text == text);
        found.unwrap_or_else(|| panic!("{text} is left out: {:?}", drawing.notes))
    };
    let (title, top) = (of("Frequency"), place(of("8")));
    assert!(place(title).max.y < top.min.y && title.leader.is_none(), "{title:?} {top:?}");
}

/// Where the short ticks of an axis are drawn longer, its numbers stand at them and not in their place, the one at the
/// corner of two axes too; the title of the axis, which is level in print, stands above all of them and names no bar.
#[test]
fn numbers_stand_at_ticks_that_are_drawn_longer_and_the_title_above_them() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600' font-family='sans-serif' \
        font-size='20'><rect width='900' height='600' fill='#fff'/>\
        <path d='M120 80V500H860' fill='none' stroke='#000' stroke-width='3'/>\
        <text x='120' y='62' text-anchor='middle'>Pupils</text>"
        .to_owned();
    for k in 0..5 {
        let y = 500 - 84 * k;
        write!(
            svg,
            "<path d='M108 {y}H120' stroke='#000' stroke-width='3'/><text x='100' y='{}' text-anchor='end'>{}</text>",
            y + 7,
            3 * k
        )
        .expect("a string takes it");
    }
    for (k, height) in (0..5).zip([336, 252, 112, 56, 196]) {
        let (x, y) = (160 + 140 * k, 500 - height);
        write!(svg, "<rect x='{x}' y='{y}' width='80' height='{height}' fill='#fff' stroke='#000' stroke-width='2'/>")
            .expect("a string takes it");
    }
    let drawing = drawn(&(svg + "</svg>"), "swell-a4");
    let figure = drawing.page.figure.place;
    let labels = labels_of(&drawing);
    let at = |text: &str| {
        let found = labels.iter().find(|label| label.text == text);
        place(found.unwrap_or_else(|| panic!("{text} is left out: {:?}", drawing.notes)))
    };
    for k in 0..5 {
        let tick = figure.min.y + (500.0 - 84.0 * k as f32) / 600.0 * figure.height();
        let number = at(&(3 * k).to_string());
        assert!((number.center().y - tick).abs() < 3.0, "{}: {number:?}, its tick at {tick}", 3 * k);
        let is_tick = |line: &&Line| {
            let points = || line.runs.iter().flat_map(|run| &run.points);
            points().all(|at| (at.y - tick).abs() < 0.5) && line.length() < 20.0
        };
        let ticks = drawing.page.figure.lines.iter().filter(is_tick).count();
        assert!(k == 0 || ticks == 1, "{} has its tick", 3 * k);
    }
    let (title, highest) = (at("Pupils"), at("12"));
    assert!(title.max.y < highest.min.y && title.min.x < across(figure, 160.0 / 900.0), "{title:?}");
}

/// Of words in a column only those without room are abbreviated: the names of a cell's parts, which stand one below
/// another, are all there in full.
#[test]
fn words_of_a_column_are_written_in_full_where_each_has_room() {
    let svg = std::fs::read("samples/cell.svg").expect("a sample");
    let drawing = convert(&svg, &options("swell-a4").label_texts(true)).expect("a page");
    let labels = labels_of(&drawing);
    let is_whole = |word: &&str| labels.iter().any(|label| label.text == **word && label.abbreviation.is_none());
    let whole = ["membrane", "mitochondrion", "nucleus", "vacuole"].iter().filter(|word| is_whole(word)).count();
    assert_eq!(whole, 4, "{:?}", drawing.notes);
}

/// All numbers of an axis with a unit are written, however much blank there is beside them: before, some margins lost
/// all of them but one, which larger and smaller ones did not.
#[test]
fn numbers_with_a_unit_are_written_whatever_the_margin_is() {
    let cases = [("index-basic-d", "km/h", [56, 62, 80, 86]), ("pins-120x60", "°C", [62, 68, 80, 86])];
    for (profile, unit, margins) in cases {
        for x in margins {
            let mut svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='400' font-size='14'>\
                <rect width='100%' height='100%' fill='#fff'/><g fill='none' stroke='#000' stroke-width='3'>\
                <path d='M{x} 40V360H{}M{x} 200l120 -80 100 130 120 -160 120 210'/></g>",
                x + 520,
                x + 480
            );
            for (i, number) in [10, 5, 0, -5, -10].into_iter().enumerate() {
                let (right, y) = (x - 10, 45 + 79 * i);
                write!(svg, "<text x='{right}' y='{y}' text-anchor='end'>{number} {unit}</text>").expect("text");
            }
            let options = options(profile).label_texts(true).title("Speed");
            let drawing = convert((svg + "</svg>").as_bytes(), &options).expect("a page");
            assert_eq!(labels_of(&drawing).len(), 5, "{x} px on {profile}: {:?}", drawing.notes);
        }
    }
}

/// Words beside a drawing are whole and in one line where the sheet is blank there, however long they are: the drawing
/// is as large with them.
#[test]
fn words_stand_on_the_blank_of_the_sheet() {
    let words = ["membranatorium", "mitochondriono", "nucleoluminate", "vacuolationist"];
    for letters in [11, 12, 14] {
        let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='400' font-size='14'>\
            <rect width='600' height='400' fill='#fff'/>\
            <path d='M140 40H560V360H140Z' fill='none' stroke='#000' stroke-width='3'/>"
            .to_owned();
        for (i, word) in words.iter().enumerate() {
            let (y, word) = (75 + 80 * i, &word[..letters]);
            write!(svg, "<text x='130' y='{y}' text-anchor='end'>{word}</text>").expect("text");
        }
        let drawing = drawn(&(svg + "</svg>"), "pins-120x60");
        let labels = labels_of(&drawing);
        let is_whole = |label: &&&BrailleText| label.abbreviation.is_none() && place(label).height() < 7.5;
        assert_eq!(labels.iter().filter(is_whole).count(), 4, "{letters}: {:?}", drawing.notes);
    }
}
