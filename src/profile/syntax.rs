//! Reading TOML past its mistakes, so that all of them are told at once.
//!
//! The TOML reader recovers from most mistakes by itself. Two kinds it cannot know better: a line that takes the next
//! ones with it (quotes or brackets that do not close on their line, a key without `=`), and a heading that is damaged,
//! so that the keys below it are read into another section. A profile has one value on each line, so such a line can be
//! told by itself. Those lines are left out, and the rest is read a second time.

use std::collections::BTreeSet;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue, Error};

use super::fault::{FaultInText, has_decimal_comma, quoted};

/// A line that is put behind another one, to see whether it is still read.
const NEXT: &str = "next-line = 1";

/// Reads a text as TOML. `see` gets what the TOML reader made of it, and the lines of the mistakes; what is on one of
/// those is not to be trusted. Returned are the mistakes, at most one for each line.
pub(super) fn read(text: &str, lines: &Lines, see: &mut dyn FnMut(&DeTable<'_>, &BTreeSet<usize>)) -> Vec<FaultInText> {
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        see(table.get_ref(), &BTreeSet::new());
        return Vec::new();
    }
    let whole: Vec<_> = long_values(table.get_ref(), lines)
        .into_iter()
        .filter(|value| !starts(&errors).iter().any(|(at, _)| value.contains(at)))
        .collect();
    let mut readable = text.to_owned();
    let mut faults = leave_out_spoiling_lines(&mut readable, lines, &whole);
    let mut told: BTreeSet<_> = faults.iter().map(|fault| fault.line).collect();
    let (table, errors) = DeTable::parse_recoverable(&readable);
    for (at, message) in starts(&errors) {
        let line = lines.line(at);
        let content = readable.get(lines.bytes(line, readable.len())).unwrap_or_default().trim();
        // A mistake that shows only at the end of the text has another one before it.
        if (!content.is_empty() || told.is_empty()) && told.insert(line) {
            faults.push(FaultInText::new(line, explain(message, content)));
        }
    }
    see(table.get_ref(), &told);
    faults
}

/// Where mistakes begin, in the order of the text, with the TOML reader's own words.
fn starts(errors: &[Error]) -> Vec<(usize, &str)> {
    let at = |error: &Error| error.span().map_or(0, |span| span.start);
    let mut starts: Vec<_> = errors.iter().map(|error| (at(error), error.message())).collect();
    starts.sort_by_key(|&(at, _)| at);
    starts
}

/// The values that go over more than one line: where they begin to one past their end.
fn long_values(table: &DeTable<'_>, lines: &Lines) -> Vec<Range<usize>> {
    let mut long = Vec::new();
    for value in table.values() {
        if let DeValue::Table(keys) = value.get_ref() {
            // The span of a section is its heading; of a table in braces, all of it.
            long.extend(long_values(keys, lines));
        }
        let span = value.span();
        if lines.line(span.start) < lines.line(span.end) {
            long.push(span.start..span.end + 1);
        }
    }
    long
}

/// Blanks the lines that spoil what follows, so that all others keep their number, and tells them. Lines of the values
/// `whole`, which are read well, are none of them.
fn leave_out_spoiling_lines(text: &mut String, lines: &Lines, whole: &[Range<usize>]) -> Vec<FaultInText> {
    let mut faults = Vec::new();
    let mut under_damaged_heading = false;
    for line in 1..=lines.count() {
        let bytes = lines.bytes(line, text.len());
        let content = text.get(bytes.clone()).unwrap_or_default();
        if whole.iter().any(|value| value.start < bytes.end && bytes.start < value.end) {
            continue;
        }
        let heading = is_heading(content);
        under_damaged_heading &= !heading;
        let spoils = spoils(content.trim_end_matches(['\n', '\r']), heading);
        if let Some(what) = spoils.filter(|_| !under_damaged_heading) {
            faults.push(FaultInText::new(line, what));
            under_damaged_heading |= heading;
        } else if !under_damaged_heading {
            continue;
        }
        let blank: String = content.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect();
        text.replace_range(bytes, &blank);
    }
    faults
}

fn is_heading(line: &str) -> bool {
    line.split(['=', '#']).next().is_some_and(|start| start.contains('['))
}

/// The mistake of a line that keeps others from being read as they are meant, if it has one.
fn spoils(line: &str, heading: bool) -> Option<String> {
    let text = format!("{line}\n{NEXT}");
    let (table, errors) = DeTable::parse_recoverable(&text);
    let starts = starts(&errors);
    let (_, message) = *starts.first()?;
    let reads_next = |table: &DeTable<'_>| {
        let next = table.iter().find(|(name, _)| name.span().start == line.len() + 1);
        next.is_some_and(|(_, value)| matches!(value.get_ref(), DeValue::Integer(_)))
    };
    if !heading && reads_next(table.get_ref()) {
        return None;
    }
    let goes_on = |value: &Spanned<DeValue<'_>>| value.span().start <= line.len() && value.span().end > line.len() + 1;
    if values(table.get_ref()).into_iter().any(goes_on) {
        return Some("the value does not end on its line, close the quotes or brackets".to_owned());
    }
    Some(explain(message, line.trim()))
}

/// All values of a table and of those in it.
fn values<'t, 'i>(table: &'t DeTable<'i>) -> Vec<&'t Spanned<DeValue<'i>>> {
    let inner = |value: &'t Spanned<DeValue<'i>>| value.get_ref().as_table().map_or_else(Vec::new, values);
    table.values().flat_map(|value| std::iter::once(value).chain(inner(value))).collect()
}

/// A mistake in words; `message` is the TOML reader's own.
fn explain(message: &str, content: &str) -> String {
    if message == "duplicate key" {
        let kind = if content.starts_with('[') { "section" } else { "key" };
        return format!("this {kind} is given twice, take one of the two away");
    }
    if content.split_once('=').is_some_and(|(_, value)| has_decimal_comma(value)) {
        return format!("{} has a decimal comma, write a point as in 1.5", quoted(content));
    }
    let message: String = message.replace('`', "\"").chars().filter(|c| !c.is_control()).collect();
    format!("{} cannot be read as TOML: {message}", quoted(content))
}

/// Where the lines of a text begin.
pub(super) struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let after_breaks = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n').map(|(at, _)| at + 1);
        Self { starts: std::iter::once(0).chain(after_breaks).collect() }
    }

    /// The line of a byte, counted from 1.
    pub(super) fn line(&self, byte: usize) -> usize {
        self.starts.partition_point(|&start| start <= byte)
    }

    /// The bytes of a line that is counted from 1, its break included; `end` is the length of the text.
    fn bytes(&self, line: usize, end: usize) -> Range<usize> {
        let start = self.starts.get(line - 1).copied().unwrap_or(end);
        start..self.starts.get(line).copied().unwrap_or(end)
    }

    /// How many lines there are.
    fn count(&self) -> usize {
        self.starts.len()
    }
}
