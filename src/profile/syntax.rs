//! Reading TOML past its mistakes. The TOML reader stops at some mistakes and takes others for something else that
//! swallows the rest of the file. A profile has one value on each line, so a line with a mistake can be left out and
//! the rest read again, until what is left is right: then all mistakes are known at once.

use std::collections::BTreeSet;

use toml::de::{DeTable, DeValue};

use super::Found;
use super::parse::Lines;
use super::suggest::quoted;

/// How often the text is read again. Each time finds all the mistakes that do not hide behind others.
const MOST_ROUNDS: usize = 30;

/// Reads a text as TOML. `see` gets what the TOML reader made of the text: `Table::Damaged` each time that there were
/// still mistakes, with the lines known so far, then `Table::Sound` for the lines without any. Returned are the
/// mistakes, at most one for each line.
pub(super) fn read(text: &str, lines: &Lines, see: &mut dyn FnMut(Table<'_>)) -> Vec<Found> {
    let mut text = text.to_owned();
    let (mut faults, mut told) = (Vec::new(), BTreeSet::new());
    for _ in 0..MOST_ROUNDS {
        let before = faults.len();
        let (table, errors) = DeTable::parse_recoverable(&text);
        let table = table.get_ref();
        if errors.is_empty() {
            see(Table::Sound(table));
            break;
        }
        let mut errors: Vec<_> =
            errors.iter().map(|error| (error.span().map_or(0, |span| span.start), error.message())).collect();
        errors.sort_by_key(|&(at, _)| at);
        // A value that does not end swallows what follows: from its start on, only the value itself is to blame.
        let long = long_values(table, lines);
        let swallower =
            long.iter().filter(|value| errors.iter().any(|(at, _)| value.contains(at))).map(|v| v.start).min();
        for (at, message) in errors {
            let swallowed = swallower.filter(|&start| start <= at);
            let line = lines.line(swallowed.unwrap_or(at));
            let content = text.get(lines.bytes(line, text.len())).unwrap_or_default().trim();
            // A mistake that shows only at the end of the text has another one before it.
            if (content.is_empty() && !told.is_empty()) || !told.insert(line) {
                continue;
            }
            let what = match swallowed {
                Some(_) => "the value does not end on its line, close the quotes or brackets".to_owned(),
                None => explain(message, content),
            };
            faults.push(Found::new(line, what));
        }
        see(Table::Damaged(table, &told));
        if faults.len() == before {
            break; // Leaving lines out does not help; what is known is all there is.
        }
        for fault in &faults[before..] {
            leave_out(&mut text, fault.line, lines);
        }
    }
    faults
}

/// What the TOML reader made of a text.
pub(super) enum Table<'a> {
    /// The text has mistakes, in these lines so far.
    Damaged(&'a DeTable<'a>, &'a BTreeSet<usize>),
    /// The text has none (any more).
    Sound(&'a DeTable<'a>),
}

/// The values that go over more than one line: where they begin to one past their end.
fn long_values(table: &DeTable<'_>, lines: &Lines) -> Vec<std::ops::Range<usize>> {
    let mut long = Vec::new();
    for value in table.values() {
        let span = value.span();
        match value.get_ref() {
            // The span of a section is its heading; of a table in braces, all of it.
            DeValue::Table(keys) => long.extend(long_values(keys, lines)),
            DeValue::Array(list) => {
                for table in list.iter().filter_map(|item| item.get_ref().as_table()) {
                    long.extend(long_values(table, lines));
                }
            }
            _ => {}
        }
        if lines.line(span.start) < lines.line(span.end) {
            long.push(span.start..span.end + 1);
        }
    }
    long
}

/// Blanks a line so that all others keep their number; of a heading, all that stands below it, since it is not known to
/// which section that belongs.
fn leave_out(text: &mut String, line: usize, lines: &Lines) {
    let is_heading = |text: &str, line| {
        let content = text.get(lines.bytes(line, text.len())).unwrap_or_default();
        content.split(['=', '#']).next().is_some_and(|start| start.contains('['))
    };
    let mut last = line;
    if is_heading(text, line) {
        while last < lines.count() && !is_heading(text, last + 1) {
            last += 1;
        }
    }
    let bytes = lines.bytes(line, text.len()).start..lines.bytes(last, text.len()).end;
    if let Some(content) = text.get(bytes.clone()) {
        let blank: String = content.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect();
        text.replace_range(bytes, &blank);
    }
}

/// A mistake in words; `message` is the TOML reader's own.
fn explain(message: &str, content: &str) -> String {
    if message == "duplicate key" {
        let kind = if content.starts_with('[') { "section" } else { "key" };
        return format!("this {kind} is given twice, take one of the two away");
    }
    let value = content.split_once('=').map_or("", |(_, value)| value).as_bytes();
    let decimal_comma = value.windows(3).any(|w| w[0].is_ascii_digit() && w[1] == b',' && w[2].is_ascii_digit());
    if decimal_comma {
        return format!("{} has a decimal comma, write a point as in 1.5", quoted(content));
    }
    let message: String = message.replace('`', "\"").chars().filter(|c| !c.is_control()).collect();
    format!("{} cannot be read as TOML: {message}", quoted(content))
}
