//! English braille back to text, by the cells that the table's own file lists: what a reader would say who knows it.

use std::collections::BTreeMap;

use super::{labels, reading};
use crate::common::samples;
use tactograph::internals::braille::CellSize;
use tactograph::internals::page::cells::CellGrid;
use tactograph::marks::{BrailleText, TextRole};
use tactograph::{KeySheets, Page, convert};

const EN: &str = include_str!("../../src/braille/tables/en.txt");

/// What stands before capitals: of one, of a word, of a passage, and the end of these.
const CAPITALS: [&str; 4] = ["⠠", "⠠⠠", "⠠⠠⠠", "⠠⠄"];

/// Cells as letters and signs; digits and their sign apart.
struct Reverse {
    signs: BTreeMap<String, String>,
    digits: Vec<char>,
    number: char,
}

fn cell(dots: &str) -> char {
    let bits = dots.chars().filter_map(|dot| dot.to_digit(10)).filter(|dot| *dot > 0).map(|dot| 1 << (dot - 1));
    char::from_u32(0x2800 + bits.sum::<u32>()).expect("a cell")
}

fn cells(dots: &str) -> String {
    dots.split('-').map(cell).collect()
}

fn reverse() -> Reverse {
    let mut reverse = Reverse { signs: BTreeMap::new(), digits: Vec::new(), number: ' ' };
    for line in EN.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["letters", ref pairs @ ..] => {
                for pair in pairs.chunks(2) {
                    reverse.signs.insert(cells(pair[1]), pair[0].to_owned());
                }
            }
            // what has two meanings is read as the first
            ["sign", sign, _, dots, ..] => {
                reverse.signs.entry(cells(dots)).or_insert_with(|| sign.to_owned());
            }
            ["digits", ref digits @ ..] => reverse.digits = digits.iter().map(|dots| cell(dots)).collect(),
            ["number", dots] => reverse.number = cell(dots),
            _ => {}
        }
    }
    reverse
}

/// The text of cells. Panics at cells that are none of the code.
pub(super) fn english(braille: &str) -> String {
    let reverse = reverse();
    let mut text = String::new();
    let (mut capital, mut word, mut passage, mut in_number) = (false, false, false, false);
    let mut rest = braille;
    while let Some(first) = rest.chars().next() {
        let digit = reverse.digits.iter().position(|digit| *digit == first).filter(|_| in_number);
        if first == '\u{2800}' {
            (word, in_number) = (false, false);
            text.push(' ');
            rest = &rest[first.len_utf8()..];
        } else if let Some(digit) = digit {
            text.push_str(&digit.to_string());
            rest = &rest[first.len_utf8()..];
        } else if first == reverse.number {
            in_number = true;
            rest = &rest[first.len_utf8()..];
        } else if let Some(after) = rest.strip_prefix(CAPITALS[3]) {
            (word, passage) = (false, false);
            rest = after;
        } else if let Some(at) = (0..3).rev().find(|&at| rest.starts_with(CAPITALS[at])) {
            [capital, word, passage] = [at == 0, word || at == 1, passage || at == 2];
            in_number = false;
            rest = &rest[CAPITALS[at].len()..];
        } else {
            let signs = reverse.signs.iter().filter(|(cells, _)| rest.starts_with(cells.as_str()));
            let (cells, sign) =
                signs.max_by_key(|(cells, _)| cells.len()).unwrap_or_else(|| panic!("{braille}: {rest}"));
            let is_capital = capital || word || passage;
            text += &if is_capital { sign.to_uppercase() } else { sign.clone() };
            in_number &= [".", ","].contains(&sign.as_str());
            capital = false;
            rest = &rest[cells.len()..];
        }
    }
    text
}

#[test]
fn cells_are_read_back() {
    let code = tactograph::internals::braille::Code::of_language("en").expect("English");
    let table = code.table().expect("a table");
    for text in
        ["Rain in mm, 2024", "NASA and the EU", "SEA LEVEL RISE", "12.5 km", "Key: Trees", "a-b (c)", "5 cm x 7"]
    {
        assert_eq!(english(&table.translate(text).unicode()), text);
    }
}

/// What lines of cells may say: a hyphen at the end of one is the text's own, or that of a word divided there.
fn joined(lines: &[String]) -> Vec<String> {
    let Some((last, before)) = lines.split_last() else { return Vec::new() };
    let mut all = vec![String::new()];
    for line in before {
        let apart = format!("{line}\u{2800}");
        let ends = match line.strip_suffix('⠤') {
            Some(divided) => vec![divided.to_owned(), line.clone(), apart],
            None => vec![apart],
        };
        all = all.iter().flat_map(|text| ends.iter().map(move |end| format!("{text}{end}"))).collect();
    }
    all.into_iter().map(|text| text + last).collect()
}

/// A text with one blank between its words.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What stands on the page for a text: its abbreviation, if it has one. In a key a blank parts the two.
fn shown(text: &BrailleText) -> Vec<String> {
    match (&text.abbreviation, text.role) {
        (Some(short), _) => vec![short.clone()],
        (None, TextRole::Key) => vec![squeezed(&text.text), squeezed(&text.text.replacen(": ", " ", 1))],
        (None, TextRole::Title | TextRole::Label | TextRole::Number) => vec![squeezed(&text.text)],
    }
}

/// The texts of a page, each read from its dots by a person who knows the code, and the same as the page says it is.
fn read_back(page: &Page, name: &str) -> Vec<String> {
    let size = CellGrid::of(&page.medium, CellSize::MARBURG).size();
    let read = |text: &BrailleText| {
        let lines = reading::lines(&text.dots.at, size);
        let read: Vec<String> = joined(&lines).iter().map(|cells| squeezed(&english(cells))).collect();
        let shown = shown(text);
        let said = read.iter().find(|read| shown.contains(read));
        said.unwrap_or_else(|| panic!("{name}: {shown:?} is read as {read:?}")).clone()
    };
    page.braille.iter().map(read).collect()
}

/// Title, labels, key and page numbers of every sample, on paper, embossers and pins.
#[test]
fn every_text_on_every_sample_is_read_back() {
    const TITLE: &str = "Sheet (a), 3 of 12: what it shows";
    for sample in samples::names() {
        let picture = samples::read(&sample);
        for profile in ["swell-a4", "index-basic-d", "viewplus-columbia", "pins-120x60"] {
            let name = format!("{sample} on {profile}");
            let options = labels::options(profile).title(TITLE).label_texts(true);
            let drawing = convert(&picture, &options.key(KeySheets::Always).page_number(12)).expect("a page");
            let sheets = [&drawing.page].into_iter().chain(&drawing.overview).chain(&drawing.key);
            let read: Vec<String> = sheets.flat_map(|page| read_back(page, &name)).collect();
            assert!(read.iter().any(|text| text.ends_with(TITLE)), "{name}: no title among {read:?}");
            assert!(read.iter().any(|text| text == "12"), "{name}: no page number among {read:?}");
            assert!(sample != "cell.svg" || read.iter().any(|text| text == "nucleus"), "{name}: {read:?}");
        }
    }
}
