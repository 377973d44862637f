//! What a key of a profile is: its path, its kind, and how a value gets in and out.

use super::Profile;
use super::suggest::list;
use crate::devices::Device;
use crate::page::layout::Orientation;
use crate::textures::Sign;

/// One key of a profile, such as `lines.width_max`.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// Section and name, joined by a point.
    pub path: &'static str,
    /// What it is for, in one line.
    pub doc: &'static str,
    /// What it takes.
    pub kind: Kind,
    pub(super) get: fn(&Profile) -> Value,
    pub(super) slot: for<'a> fn(&'a mut Profile) -> Slot<'a>,
}

/// The words for what presses a page: none, and the devices.
pub(super) const DEVICES: [&str; 1 + Device::ALL.len()] = {
    let mut words = ["none"; 1 + Device::ALL.len()];
    let mut i = 0;
    while i < Device::ALL.len() {
        words[1 + i] = Device::ALL[i].id;
        i += 1;
    }
    words
};

/// What a key takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// `true` or `false`.
    Switch,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A texture's sign: rows of rhombuses in a direction, or dots.
    Sign,
    /// A number from `low` to `high`, both included.
    Number {
        /// The smallest value taken.
        low: f32,
        /// The largest value taken.
        high: f32,
        /// Its unit; empty for a bare ratio.
        unit: &'static str,
    },
}

/// What a key holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// `true` or `false`.
    Switch(bool),
    /// One of the key's words.
    Choice(&'static str),
    /// A texture's sign.
    Sign(Sign),
    /// A number in the key's unit.
    Number(f32),
}

/// A field of a profile, to be written to.
pub(super) enum Slot<'a> {
    Switch(&'a mut bool),
    Orientation(&'a mut Orientation),
    Device(&'a mut Option<&'static Device>),
    Sign(&'a mut Sign),
    Number(&'a mut f32),
}

impl Key {
    /// The section before the last point.
    pub fn section(&self) -> &'static str {
        self.path.rsplit_once('.').map_or("", |(section, _)| section)
    }

    /// The name after the last point.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |(_, name)| name)
    }

    /// What the profile holds under this key.
    pub fn value(&self, profile: &Profile) -> Value {
        (self.get)(profile)
    }

    /// What the key takes, in words: "a number from 0.3 to 10 mm", "true or false".
    pub fn range(&self) -> String {
        match self.kind {
            Kind::Switch => "true or false".to_owned(),
            Kind::Choice(words) => {
                let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
                list(&quoted.iter().map(String::as_str).collect::<Vec<_>>(), "or")
            }
            Kind::Sign => r#""dot" or "rhombus D" with D from 0 to below 180 degrees"#.to_owned(),
            Kind::Number { low, high, unit: "" } => format!("a number from {low} to {high}"),
            Kind::Number { low, high, unit } => format!("a number from {low} to {high} {unit}"),
        }
    }

    /// Is the value of the right kind and within the range?
    pub fn takes(&self, value: Value) -> bool {
        match (self.kind, value) {
            (Kind::Switch, Value::Switch(_)) | (Kind::Sign, Value::Sign(_)) => true,
            (Kind::Choice(words), Value::Choice(word)) => words.contains(&word),
            (Kind::Number { low, high, .. }, Value::Number(number)) => (low..=high).contains(&number),
            _ => false,
        }
    }

    /// Writes a value of the key's own kind; one of the other kind changes nothing.
    pub(super) fn put(&self, profile: &mut Profile, value: Value) {
        match ((self.slot)(profile), value) {
            (Slot::Switch(field), Value::Switch(value)) => *field = value,
            (Slot::Orientation(field), Value::Choice(word)) => {
                *field = Orientation::ALL.into_iter().find(|way| way.name() == word).unwrap_or(*field);
            }
            (Slot::Device(field), Value::Choice(word)) => *field = Device::named(word),
            (Slot::Sign(field), Value::Sign(value)) => *field = value,
            // Adding nothing turns minus zero, which is written oddly, into zero.
            (Slot::Number(field), Value::Number(value)) => *field = value + 0.0,
            _ => {}
        }
    }

    /// The value that a text such as `1.2` or `false` stands for, if it is of the key's kind; its range is not checked.
    pub(super) fn read(&self, text: &str) -> Option<Value> {
        match self.kind {
            Kind::Switch => text.parse().ok().map(Value::Switch),
            Kind::Choice(_) => self.word(text.trim_matches('"')),
            Kind::Sign => text.trim_matches('"').parse().ok().map(Value::Sign),
            Kind::Number { .. } => text.parse().ok().map(Value::Number),
        }
    }

    /// The value that one of the key's words stands for.
    pub(super) fn word(&self, text: &str) -> Option<Value> {
        let Kind::Choice(words) = self.kind else { return None };
        words.iter().find(|word| **word == text).map(|word| Value::Choice(word))
    }

    /// The fault of a value out of range or of the wrong kind; `got` names it.
    pub(super) fn refuse(&self, got: &str) -> String {
        let with_unit = match self.kind {
            Kind::Number { unit, .. } => !unit.is_empty() && got.trim_end_matches('"').ends_with(unit),
            Kind::Switch | Kind::Choice(_) | Kind::Sign => false,
        };
        let advice = if with_unit { ", write it without the unit" } else { "" };
        format!("{} must be {}, not {got}{advice}", self.path, self.range())
    }
}

/// As TOML has it: `true`, `false`, a word or a sign in quotes, or the shortest decimal that reads back as the same number.
impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Switch(switch) => switch.fmt(f),
            Self::Choice(word) => write!(f, "\"{word}\""),
            Self::Sign(sign) => write!(f, "\"{sign}\""),
            Self::Number(number) => number.fmt(f),
        }
    }
}

impl From<bool> for Value {
    fn from(switch: bool) -> Self {
        Self::Switch(switch)
    }
}

impl From<Orientation> for Value {
    fn from(orientation: Orientation) -> Self {
        Self::Choice(orientation.name())
    }
}

impl From<Option<&'static Device>> for Value {
    fn from(device: Option<&'static Device>) -> Self {
        Self::Choice(device.map_or(DEVICES[0], |device| device.id))
    }
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<Sign> for Value {
    fn from(sign: Sign) -> Self {
        Self::Sign(sign)
    }
}

impl<'a> From<&'a mut bool> for Slot<'a> {
    fn from(field: &'a mut bool) -> Self {
        Self::Switch(field)
    }
}

impl<'a> From<&'a mut Orientation> for Slot<'a> {
    fn from(field: &'a mut Orientation) -> Self {
        Self::Orientation(field)
    }
}

impl<'a> From<&'a mut Option<&'static Device>> for Slot<'a> {
    fn from(field: &'a mut Option<&'static Device>) -> Self {
        Self::Device(field)
    }
}

impl<'a> From<&'a mut Sign> for Slot<'a> {
    fn from(field: &'a mut Sign) -> Self {
        Self::Sign(field)
    }
}

impl<'a> From<&'a mut f32> for Slot<'a> {
    fn from(field: &'a mut f32) -> Self {
        Self::Number(field)
    }
}
