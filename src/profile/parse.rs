//! One TOML text to what it says, with every fault and its line.

use std::collections::BTreeSet;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::fault::{FaultInText, quoted, quoted_path};
use super::keys::{KEYS, SECTIONS, position, switch_of};
use super::kind::Value;
use super::suggest::{unknown_key, unknown_section};
use super::syntax::{self, Lines};

/// Longest profile that is read, in bytes; the longest built-in one is an eighth of it.
const LONGEST_TEXT: usize = 64 * 1024;

/// The names at the top of a file beside the sections.
const TOP: &[&str] = &["description", "inherits"];

/// What one file says.
#[derive(Debug, Default)]
pub(super) struct WrittenKey {
    pub(super) description: Option<String>,
    /// The name of the profile it builds on, and its line.
    pub(super) inherits: Option<(String, usize)>,
    /// In the order of the lines.
    pub(super) given: Vec<GivenKeys>,
    /// Whether some line could not be read at all, so that a key may be missing for that reason only.
    pub(super) broken: bool,
}

/// One key and its value.
#[derive(Debug)]
pub(super) struct GivenKeys {
    /// Its place in [`KEYS`].
    pub(super) key: usize,
    /// `None` if the value was refused.
    pub(super) value: Option<Value>,
    pub(super) line: usize,
}

/// Reads a text. Whatever it holds, as much as can be understood comes back; the faults go to `faults` in the order of
/// their lines.
pub(super) fn parse(text: &str, faults: &mut Vec<FaultInText>) -> WrittenKey {
    if text.len() > LONGEST_TEXT {
        faults.push(FaultInText::new(
            1,
            format!("a profile has at most {LONGEST_TEXT} bytes, this text has {}, is it the right file?", text.len()),
        ));
        return WrittenKey { broken: true, ..WrittenKey::default() };
    }
    let lines = Lines::of(text);
    let mut reader =
        Reader { text, lines: &lines, mistakes: BTreeSet::new(), written: WrittenKey::default(), faults: Vec::new() };
    let mistakes = syntax::read(text, &lines, &mut |table, mistakes| {
        reader.mistakes.clone_from(mistakes);
        reader.table(table);
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
    /// Lines with a mistake in the TOML: what was made of them is not to be trusted.
    mistakes: BTreeSet<usize>,
    written: WrittenKey,
    faults: Vec<FaultInText>,
}

type KeyName<'i> = Spanned<std::borrow::Cow<'i, str>>;

impl Reader<'_> {
    /// A mistake in the TOML of a line is told instead of what follows from it.
    fn fault(&mut self, line: usize, what: String) {
        if !self.mistakes.contains(&line) {
            self.faults.push(FaultInText::new(line, what));
        }
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
                ("inherits", DeValue::String(text)) if !self.mistakes.contains(&self.line(name)) => {
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

    fn section(&mut self, section: &str, name: &KeyName<'_>, value: &Spanned<DeValue<'_>>) {
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

    fn key(&mut self, index: usize, name: &KeyName<'_>, value: &Spanned<DeValue<'_>>) {
        let (key, line) = (&KEYS[index], self.line(name));
        let damaged = self.mistakes.contains(&line);
        let given = given(value.get_ref());
        let refused = match &given {
            // Of `1.2mm` it is said better that it is no number than that it is no TOML.
            Some(given) if damaged => !key.is_of_kind(given),
            Some(given) => !key.takes(given),
            None => true,
        };
        if refused {
            self.faults.push(FaultInText::of_key(key.path, line, key.refuse(&self.said(value))));
        }
        self.written.given.push(GivenKeys { key: index, value: given.filter(|_| !refused && !damaged), line });
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

/// What a value stands for; `None` for one of a kind that no key has.
fn given(value: &DeValue<'_>) -> Option<Value> {
    match value {
        DeValue::String(text) => Some(Value::Text(text.to_string())),
        DeValue::Boolean(switch) => Some(Value::Switch(*switch)),
        DeValue::Float(number) => number.as_str().parse().ok().map(Value::Number),
        DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok().map(Value::Number),
        DeValue::Integer(number) => {
            i64::from_str_radix(number.as_str(), number.radix()).ok().map(|number| Value::Number(number as f32))
        }
        DeValue::Datetime(_) | DeValue::Array(_) | DeValue::Table(_) => None,
    }
}
