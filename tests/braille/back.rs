//! English braille back to text, by the cells that the table's own file lists: what a reader would say who knows it.

use std::collections::BTreeMap;

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
