//! What a key can hold. A new kind of value is one type that implements [`Setting`], here and nowhere else.

use super::built_in;
use super::nearest::nearest_value;
use crate::braille::{CellSize, Code, Grade};
use crate::devices::Device;
use crate::listing::list;
use crate::page::heading::Align;
use crate::page::layout::Orientation;
use crate::textures::Sign;

/// What a key holds, as TOML has it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Value {
    /// `true` or `false`.
    Switch(bool),
    /// A number in the key's unit.
    Number(f32),
    /// A word or a texture's sign.
    Text(String),
}

/// From which to which number a key goes, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NumberRange {
    /// The smallest value taken.
    pub low: f32,
    /// The largest value taken.
    pub high: f32,
    /// Its unit; empty for a bare ratio.
    pub unit: &'static str,
    /// Whether only whole numbers are taken.
    pub whole: bool,
}

/// A type of which a field of a profile can be.
pub(super) trait Setting: Sized {
    /// What a profile holds that nothing has been read into; out of every range where there is such a value.
    const BLANK: Self;

    /// Whether it is a number without a part after the point.
    const WHOLE: bool = false;

    /// What is taken, in words: "a number from 0.3 to 10 mm", "true or false".
    fn range(limits: Option<NumberRange>) -> String;

    /// All that is taken, where that is a list.
    fn choices() -> Vec<Value> {
        Vec::new()
    }

    /// What a value stands for; `None` if it is of another kind or out of range.
    fn read(value: &Value, limits: Option<NumberRange>) -> Option<Self>;

    /// As TOML has it.
    fn write(&self) -> Value;

    /// What a text that is refused may have meant, as the end of a message; nothing where no name is near.
    fn suggestion(_text: &str) -> Option<String> {
        None
    }
}

impl Value {
    /// The value that a text on the command line stands for, such as `1.2`, `false`, `auto` or `"auto"`.
    pub(super) fn of_text(text: &str) -> Self {
        match (text.parse(), text.parse()) {
            (Ok(switch), _) => Self::Switch(switch),
            (_, Ok(number)) => Self::Number(number),
            _ => Self::Text(text.trim_matches('"').to_owned()),
        }
    }
}

/// As TOML has it: `true`, `false`, a text in quotes, or the shortest decimal that reads back as the same number.
impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Switch(switch) => switch.fmt(f),
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => write!(f, "\"{text}\""),
        }
    }
}

impl Setting for bool {
    const BLANK: Self = false;

    fn range(_: Option<NumberRange>) -> String {
        "true or false".to_owned()
    }

    fn choices() -> Vec<Value> {
        vec![Value::Switch(true), Value::Switch(false)]
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        if let Value::Switch(switch) = value { Some(*switch) } else { None }
    }

    fn write(&self) -> Value {
        Value::Switch(*self)
    }
}

impl Setting for f32 {
    const BLANK: Self = Self::NAN;

    fn range(limits: Option<NumberRange>) -> String {
        match limits {
            None => "a number".to_owned(),
            Some(NumberRange { low, high, unit: "", .. }) => format!("a number from {low} to {high}"),
            Some(NumberRange { low, high, unit, .. }) => format!("a number from {low} to {high} {unit}"),
        }
    }

    fn read(value: &Value, limits: Option<NumberRange>) -> Option<Self> {
        let Value::Number(number) = value else { return None };
        let within = limits.is_none_or(|limits| (limits.low..=limits.high).contains(number));
        // Adding nothing turns minus zero, which is written oddly, into zero.
        within.then_some(number + 0.0)
    }

    fn write(&self) -> Value {
        Value::Number(*self)
    }
}

/// A whole number.
impl Setting for usize {
    const BLANK: Self = Self::MAX;
    const WHOLE: bool = true;

    fn range(limits: Option<NumberRange>) -> String {
        match limits {
            None => "a whole number".to_owned(),
            Some(NumberRange { low, high, .. }) => format!("a whole number from {low} to {high}"),
        }
    }

    fn read(value: &Value, limits: Option<NumberRange>) -> Option<Self> {
        let number = <f32 as Setting>::read(value, limits)?;
        (number >= 0.0 && number.fract().abs() <= 0.0).then_some(number as Self)
    }

    fn write(&self) -> Value {
        Value::Number(*self as f32)
    }
}

impl Setting for Sign {
    const BLANK: Self = Self::Dot;

    fn range(_: Option<NumberRange>) -> String {
        r#""dot" or "rhombus D" with D from 0 to below 180 degrees"#.to_owned()
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        if let Value::Text(text) = value { Self::named(text) } else { None }
    }

    fn write(&self) -> Value {
        Value::Text(self.to_string())
    }
}

/// What presses a page: `none`, which prints it, or a device.
impl Setting for Option<&'static Device> {
    const BLANK: Self = None;

    fn range(_: Option<NumberRange>) -> String {
        one_of(&Self::choices())
    }

    fn choices() -> Vec<Value> {
        words(std::iter::once(PRINTED).chain(Device::ALL.iter().map(|device| device.id)))
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        match value {
            Value::Text(text) if text == PRINTED => Some(None),
            Value::Text(text) => Device::named(text).ok().map(Some),
            Value::Switch(_) | Value::Number(_) => None,
        }
    }

    fn write(&self) -> Value {
        Value::Text(self.map_or(PRINTED, |device| device.id).to_owned())
    }

    fn suggestion(text: &str) -> Option<String> {
        let of_profile =
            built_in::text_of(text).and_then(|text| text.lines().find_map(|line| line.strip_prefix(DEVICE)));
        let device = of_profile.and_then(|rest| rest.split('"').next());
        match device {
            Some(device) => Some(format!("which is a profile, its device is \"{device}\"")),
            None => nearest_value(text, std::iter::once(PRINTED).chain(Device::ALL.iter().map(|device| device.id))),
        }
    }
}

/// The braille code: `auto`, which is that of the language, or a code by its name.
impl Setting for Option<Code> {
    const BLANK: Self = None;

    fn range(_: Option<NumberRange>) -> String {
        one_of(&Self::choices())
    }

    fn choices() -> Vec<Value> {
        words(std::iter::once(AUTO).chain(codes()))
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        let Value::Text(text) = value else { return None };
        if text == AUTO { Some(None) } else { Code::named(text).map(Some) }
    }

    fn write(&self) -> Value {
        Value::Text(self.map_or(AUTO, |code| code.language).to_owned())
    }

    fn suggestion(text: &str) -> Option<String> {
        nearest_value(text, std::iter::once(AUTO).chain(codes()))
    }
}

const GRADES: [Grade; 2] = [Grade::One, Grade::Two];

/// The grade of braille: 1 or 2.
impl Setting for Grade {
    const BLANK: Self = Self::One;
    const WHOLE: bool = true;

    fn range(_: Option<NumberRange>) -> String {
        "1 or 2".to_owned()
    }

    fn choices() -> Vec<Value> {
        GRADES.map(|grade| grade.write()).into()
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        // exactly: there is nothing between them
        GRADES.into_iter().find(|grade| *value == grade.write())
    }

    fn write(&self) -> Value {
        Value::Number(match self {
            Self::One => 1.0,
            Self::Two => 2.0,
        })
    }
}

/// What a key holds that is one of some words.
trait Word: Copy + PartialEq + 'static {
    /// All of them; the first stands where nothing has been read.
    const ALL: &'static [Self];

    fn word(self) -> &'static str;
}

impl Word for Orientation {
    const ALL: &'static [Self] = &Self::ALL;

    fn word(self) -> &'static str {
        self.name()
    }
}

impl Word for Align {
    const ALL: &'static [Self] = &Self::ALL;

    fn word(self) -> &'static str {
        self.name()
    }
}

impl Word for CellSize {
    const ALL: &'static [Self] = &Self::ALL;

    fn word(self) -> &'static str {
        self.name
    }
}

impl<T: Word> Setting for T {
    const BLANK: Self = T::ALL[0];

    fn range(_: Option<NumberRange>) -> String {
        one_of(&Self::choices())
    }

    fn choices() -> Vec<Value> {
        words(T::ALL.iter().map(|own| own.word()))
    }

    fn read(value: &Value, _: Option<NumberRange>) -> Option<Self> {
        let Value::Text(text) = value else { return None };
        T::ALL.iter().copied().find(|own| own.word() == text)
    }

    fn write(&self) -> Value {
        Value::Text(self.word().to_owned())
    }

    fn suggestion(text: &str) -> Option<String> {
        nearest_value(text, T::ALL.iter().map(|own| own.word()))
    }
}

/// The word for the code of the language.
const AUTO: &str = "auto";

fn codes() -> impl Iterator<Item = &'static str> {
    Code::all().iter().map(|code| code.language)
}

/// How the line of a profile begins that names its device.
const DEVICE: &str = "device = \"";

/// The word for a page that is printed, in place of a device.
const PRINTED: &str = "none";

fn words(words: impl Iterator<Item = &'static str>) -> Vec<Value> {
    words.map(|word| Value::Text(word.to_owned())).collect()
}

fn one_of(choices: &[Value]) -> String {
    let quoted: Vec<_> = choices.iter().map(Value::to_string).collect();
    list(&quoted, "or")
}
