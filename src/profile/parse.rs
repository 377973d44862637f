//! One TOML text to what it says, with every fault and its line.

use std::collections::BTreeSet;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::Found;
use super::key::{Key, Kind, Value};
use super::keys::{KEYS, SECTIONS};
use super::suggest::{quoted, quoted_path, unknown_key, unknown_section};
use super::syntax::{self, Table};

/// Longest profile that is read, in bytes; the longest built-in one is an eighth of it.
const LONGEST_TEXT: usize = 64 * 1024;

/// The names at the top of a file beside the sections.
const TOP: &[&str] = &["description", "inherits"];

/// What one file says.
#[derive(Debug, Default)]
pub(super) struct Written {
    pub(super) description: Option<String>,
    /// The name of the profile it builds on, and its line.
    pub(super) inherits: Option<(String, usize)>,
    /// In the order of the lines.
    pub(super) given: Vec<Given>,
    /// Whether some line could not be read at all, so that a key may be missing for that reason only.
    pub(super) broken: bool,
}

/// One key and its value.
#[derive(Debug)]
pub(super) struct Given {
    /// Its place in [`KEYS`].
    pub(super) key: usize,
    /// `None` if the value was refused.
    pub(super) value: Option<Value>,
    pub(super) line: usize,
}

/// Reads a text. Whatever it holds, as much as can be understood comes back; the faults go to `faults` in the order of
/// their lines.
pub(super) fn parse(text: &str, faults: &mut Vec<Found>) -> Written {
    if text.len() > LONGEST_TEXT {
        faults.push(Found::new(
            1,
            format!("a profile has at most {LONGEST_TEXT} bytes, this text has {}, is it the right file?", text.len()),
        ));
        return Written { broken: true, ..Written::default() };
    }
    let lines = Lines::of(text);
    let mut reader = Reader { text, lines: &lines, written: Written::default(), faults: Vec::new() };
    let mistakes = syntax::read(text, &lines, &mut |table| match table {
        Table::Damaged(table, mistakes) => reader.damaged(table, mistakes),
        Table::Sound(table) => reader.table(table),
    });
    reader.written.broken |= !mistakes.is_empty();
    // Of a line told of already, the mistake in the TOML is the same thing said less well.
    let told: BTreeSet<_> = reader.faults.iter().map(|fault| fault.line).collect();
    reader.faults.extend(mistakes.into_iter().filter(|mistake| !told.contains(&mistake.line)));
    reader.faults.sort_by_key(|fault| fault.line);
    reader.written.given.sort_by_key(|given| given.line);
    faults.append(&mut reader.faults);
    reader.written
}

struct Reader<'l> {
    text: &'l str,
    lines: &'l Lines,
    written: Written,
    faults: Vec<Found>,
}

type Name<'i> = Spanned<std::borrow::Cow<'i, str>>;

impl Reader<'_> {
    fn fault(&mut self, line: usize, what: String) {
        self.faults.push(Found::new(line, what));
    }

    fn line<T>(&self, spanned: &Spanned<T>) -> usize {
        self.lines.line(spanned.span().start)
    }

    fn table(&mut self, table: &DeTable<'_>) {
        for (name, value) in table {
            match (name.get_ref().as_ref(), value.get_ref()) {
                ("description", DeValue::String(text)) if !text.chars().any(char::is_control) => {
                    self.written.description = Some(text.to_string());
                }
                ("inherits", DeValue::String(text)) => {
                    self.written.inherits = Some((text.to_string(), self.line(name)));
                }
                (top, _) if TOP.contains(&top) => {
                    self.written.broken |= top == "inherits";
                    self.fault(
                        self.line(name),
                        format!("{top} must be one line of text in quotes, not {}", self.said(value)),
                    );
                }
                (section, _) if SECTIONS.contains(&section) => self.section(section, name, value),
                (unknown, _) => self.fault(self.line(name), unknown_section(unknown, TOP)),
            }
        }
    }

    fn section(&mut self, section: &str, name: &Name<'_>, value: &Spanned<DeValue<'_>>) {
        let switch = switch_of(section);
        match (value.get_ref(), switch) {
            (DeValue::Table(table), _) => {
                for (name, value) in table {
                    let inner = format!("{section}.{}", name.get_ref());
                    if SECTIONS.contains(&inner.as_str()) {
                        self.section(&inner, name, value);
                        continue;
                    }
                    match position(section, name.get_ref()) {
                        Some(key) => self.key(key, name, value),
                        None => self.fault(self.line(name), unknown_key(section, name.get_ref())),
                    }
                }
            }
            (DeValue::Boolean(_), Some(key)) => self.key(key, name, value),
            (_, Some(_)) => {
                let what = format!("{section} must be true, false or a section with keys, not {}", self.said(value));
                self.fault(self.line(name), what);
            }
            (_, None) => {
                let what = format!(
                    "{section} must be a section, written [{section}] with its keys on the lines below, not {}",
                    self.said(value)
                );
                self.fault(self.line(name), what);
            }
        }
    }

    fn key(&mut self, index: usize, name: &Name<'_>, value: &Spanned<DeValue<'_>>) {
        let (key, line) = (&KEYS[index], self.line(name));
        let value = match given(key, value.get_ref()) {
            Some(given) if key.takes(given) => Some(given),
            _ => {
                self.fault(line, key.refuse(&self.said(value)));
                None
            }
        };
        self.written.given.push(Given { key: index, value, line });
    }

    /// Finds keys with a value of the wrong kind in the lines with mistakes, for a better message: `1.2mm` is no
    /// number.
    fn damaged(&mut self, table: &DeTable<'_>, mistakes: &BTreeSet<usize>) {
        for (section, keys) in table.iter().filter_map(|(section, value)| Some((section, value.get_ref().as_table()?)))
        {
            self.damaged_section(section.get_ref(), keys, mistakes);
        }
    }

    fn damaged_section(&mut self, section: &str, keys: &DeTable<'_>, mistakes: &BTreeSet<usize>) {
        for (name, value) in keys {
            if let Some(keys) = value.get_ref().as_table() {
                self.damaged_section(&format!("{section}.{}", name.get_ref()), keys, mistakes);
            } else {
                let line = self.line(name);
                let Some(index) = position(section, name.get_ref()) else { continue };
                if wrong_kind(&KEYS[index], value.get_ref()) && mistakes.contains(&line) {
                    self.key(index, name, value);
                }
            }
        }
    }

    /// Names a value in a message: "the text \"thick\"", "12.5".
    fn said(&self, value: &Spanned<DeValue<'_>>) -> String {
        match value.get_ref() {
            DeValue::String(text) => format!("the text {}", quoted(text)),
            DeValue::Integer(_) | DeValue::Float(_) => {
                quoted_path(&[self.text.get(value.span()).unwrap_or_default().trim()])
            }
            DeValue::Boolean(switch) => switch.to_string(),
            DeValue::Datetime(_) => "a date or time".to_owned(),
            DeValue::Array(_) => "a list in brackets".to_owned(),
            DeValue::Table(_) => "a section of keys".to_owned(),
        }
    }
}

fn wrong_kind(key: &Key, value: &DeValue<'_>) -> bool {
    !matches!(
        (key.kind, given(key, value)),
        (Kind::Switch, Some(Value::Switch(_)))
            | (Kind::Number { .. }, Some(Value::Number(_)))
            | (Kind::Choice(_), Some(Value::Choice(_)))
            | (Kind::Sign, Some(Value::Sign(_)))
    )
}

/// Where in [`KEYS`] a key is.
pub(super) fn position(section: &str, name: &str) -> Option<usize> {
    KEYS.iter().position(|key| key.section() == section && key.name() == name)
}

/// The key that `true` or `false` in place of a whole section stands for.
pub(super) fn switch_of(section: &str) -> Option<usize> {
    position(section, "on")
}

/// What a value stands for; a text only for a key that has it as one of its words, or that takes a sign.
fn given(key: &Key, value: &DeValue<'_>) -> Option<Value> {
    match value {
        DeValue::String(text) if matches!(key.kind, Kind::Sign) => text.parse().ok().map(Value::Sign),
        DeValue::String(text) => key.word(text),
        DeValue::Boolean(switch) => Some(Value::Switch(*switch)),
        DeValue::Float(number) => number.as_str().parse().ok().map(Value::Number),
        DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok().map(Value::Number),
        DeValue::Integer(number) => {
            i64::from_str_radix(number.as_str(), number.radix()).ok().map(|number| Value::Number(number as f32))
        }
        _ => None,
    }
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
    pub(super) fn bytes(&self, line: usize, end: usize) -> std::ops::Range<usize> {
        let start = self.starts.get(line - 1).copied().unwrap_or(end);
        start..self.starts.get(line).copied().unwrap_or(end)
    }

    /// How many lines there are.
    pub(super) fn count(&self) -> usize {
        self.starts.len()
    }
}
