//! Labels in rows and columns, as at the axes of a chart: in their order, in one form, each at what it names.

use super::labels::{labels_of, options, place};
use std::fmt::Write as _;
use tactograph::{Drawing, MmRect, convert};

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
    let lost = told.iter().find(|note| note.contains("small closed shape")).expect("Aston's mark is lost");
    assert!(lost.contains("\"Aston\"") && !lost.contains("\"Ely\""), "{lost}");
}
