//! Braille by an installed liblouis, for contracted braille: its program `lou_translate`, run for each text.
//!
//! It exits with 0 whatever happens: a table that is missing is told on standard error only, and a character that
//! the table lacks is written as its number in braille, as a blank, or as the sign that the table has for all of these.
//! So nothing may stand on standard error, there must be as many lines as were asked for, and each sign is looked at by
//! itself, beside one that no table has.

use std::collections::BTreeSet;
use std::time::Duration;

use tactograph::{Profile, Value};

use super::external::Program;

/// The program of liblouis.
const PROGRAM: Program =
    Program { name: "lou_translate", remedy: "install liblouis (liblouis-bin), or write uncontracted braille" };
/// How long a text may take; it takes some milliseconds.
const LIMIT: Duration = Duration::from_secs(20);

/// Contracted braille of a language, as liblouis calls its tables.
const CONTRACTED: &[(&str, &str)] = &[
    ("de", "de-g2.ctb"),
    ("en", "en-ueb-g2.ctb"),
    ("es", "es-g2.ctb"),
    ("fr", "fr-bfu-g2.ctb"),
    ("pt", "pt-pt-g2.ctb"),
    ("sv", "sv-g2.ctb"),
];
/// Longest text, bytes: more than any page has room for.
const LONGEST: usize = 4000;
/// A character that no table has: one of those for private use.
const UNKNOWN: char = '\u{f8fe}';
/// The word for these tables.
const BY_LANGUAGE: &str = "contracted";

/// The table that words are written with: the one that is asked for by its name, else that of contracted braille, if
/// `braille.grade` is 2; none where a table of the program's own does. `language` is that of the words, which
/// `braille.code` overrides.
///
/// # Errors
/// In one line, if there is no such table, or liblouis is not installed.
pub(super) fn wanted(asked: Option<&str>, profile: &Profile, language: &str) -> Result<Option<String>, String> {
    let code = match profile.get("braille.code") {
        Ok(Value::Text(code)) if code != "auto" => Some(code),
        _ => None,
    };
    let language = code.as_deref().unwrap_or(language);
    let is_off = profile.get("braille.on") == Ok(Value::Switch(false));
    let is_contracted = profile.get("braille.grade") == Ok(Value::Number(2.0));
    match asked {
        _ if is_off => Ok(None),
        Some(name) => table(name, language, &format!("--braille-table {name}")).map(Some),
        None if is_contracted => table(BY_LANGUAGE, language, "braille.grade = 2").map(Some),
        None => Ok(None),
    }
}

/// The table of this name; `contracted` is that of the language.
fn table(name: &str, language: &str, asked_by: &str) -> Result<String, String> {
    let primary = language.split('-').next().unwrap_or(language);
    let known = CONTRACTED.iter().find(|(own, _)| own.eq_ignore_ascii_case(primary)).map(|(_, table)| *table);
    let table = match name {
        BY_LANGUAGE => known.ok_or_else(|| {
            let languages: Vec<&str> = CONTRACTED.iter().map(|(language, _)| *language).collect();
            format!(
                "{asked_by}: no contracted table is known for the language {primary}, only for {}; name a table of \
                 liblouis with --braille-table, or take grade 1",
                languages.join(", ")
            )
        })?,
        name => name,
    };
    let is_name = !table.starts_with('-') && table.chars().all(|c| c.is_ascii_alphanumeric() || "._-/".contains(c));
    if !is_name {
        return Err(format!("{asked_by}: name a table of liblouis, such as en-ueb-g2.ctb"));
    }
    match lines(table, &["a".to_owned()]) {
        Ok(_) => Ok(table.to_owned()),
        Err(why) => Err(format!("{asked_by}: {why}")),
    }
}

/// The cells of a text.
///
/// # Errors
/// If the table lacks a character of it, with the place of the first, from 1; or if liblouis fails.
pub(super) fn translate(table: &str, text: &str) -> Result<Vec<u8>, String> {
    if text.len() > LONGEST {
        return Err("the text is too long".to_owned());
    }
    let signs: BTreeSet<char> = text.chars().filter(|c| !c.is_ascii_alphanumeric() && *c != ' ').collect();
    let asked = [text.to_owned(), UNKNOWN.to_string()].into_iter().chain(signs.iter().map(char::to_string));
    let written = lines(table, &asked.collect::<Vec<_>>())?;
    let unknown = &written[1];
    let lacks = |(sign, cells): &(&char, &String)| {
        let is_blank = cells.chars().all(|cell| cell == '\u{2800}') && !sign.is_whitespace() && !is_invisible(**sign);
        is_number(cells) || is_blank || !sign.is_ascii() && *cells == unknown
    };
    let place = |sign: char| 1 + text.chars().take_while(|&of_text| of_text != sign).count();
    let lacking = signs.iter().zip(&written[2..]).filter(lacks).map(|(&sign, _)| (place(sign), sign));
    if let Some((at, sign)) = lacking.min() {
        return Err(format!("the table {table} has no cells for {sign:?} (character {at})"));
    }
    let cell = |c: char| u8::try_from(u32::from(c).wrapping_sub(0x2800)).map_err(|_| format!("{c:?} is no braille"));
    written[0].chars().map(cell).collect()
}

/// Whether a character has no cells of its own in any code: a place where a word may be divided, or joined.
fn is_invisible(sign: char) -> bool {
    matches!(sign, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}')
}

/// Whether the cells of a sign are those of its number, such as '\x65e5' in quotation marks: at least eight, the first
/// and the last the same; or with dots that only the table's backslash has.
fn is_number(cells: &str) -> bool {
    let cells: Vec<char> = cells.chars().collect();
    let of_eight_dots = cells.iter().any(|&cell| u32::from(cell) >= 0x2840);
    of_eight_dots || cells.len() >= 8 && cells.first() == cells.last()
}

/// What liblouis makes of lines of text, in Unicode braille.
fn lines(table: &str, asked: &[String]) -> Result<Vec<String>, String> {
    let tables = format!("unicode.dis,{table}");
    let text: String = asked.iter().map(|line| line.replace('\\', "\\\\") + "\n").collect();
    let done = PROGRAM.run(&["--forward", &tables], text.as_bytes(), LIMIT)?;
    if let Some(line) = done.told.lines().next() {
        return Err(format!("{} says: {}", PROGRAM.name, line.trim()));
    }
    let written = String::from_utf8(done.out).map_err(|_| format!("{} writes no text", PROGRAM.name))?;
    let written: Vec<String> = written.lines().map(str::to_owned).collect();
    if written.len() == asked.len() {
        Ok(written)
    } else {
        Err(format!("{} gives another number of lines", PROGRAM.name))
    }
}

#[cfg(test)]
mod tests;
