//! Sentences about pages in several languages: one file of messages a language, in the format of Project Fluent, which
//! knows how each language counts.
//!
//! Names of colours are those of the braille tables, so that a key on a page and a sentence about it say the same.

use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};

use crate::braille::{Code, Table};

/// What a message is filled with: a number, by which it may choose its words, or a text.
pub(crate) use fluent_bundle::FluentValue as Value;

/// The languages, by the tags of BCP 47, English first; each with its messages.
const FILES: [(&str, &str); 5] = [
    ("en", include_str!("en.ftl")),
    ("de", include_str!("de.ftl")),
    ("es", include_str!("es.ftl")),
    ("fr", include_str!("fr.ftl")),
    ("pl", include_str!("pl.ftl")),
];

/// Each language when it is first asked for.
static LOADED: [OnceLock<Wording>; FILES.len()] = [const { OnceLock::new() }; FILES.len()];

/// The messages of one language.
pub(crate) struct Wording {
    language: &'static str,
    bundle: FluentBundle<FluentResource>,
    table: Option<Table>,
}

impl Wording {
    /// The languages that there are, English first.
    pub(crate) fn languages() -> impl Iterator<Item = &'static str> {
        FILES.iter().map(|(language, _)| *language)
    }

    /// The messages of a language such as `de` or `de-CH`, if there are any.
    pub(crate) fn of_language(tag: &str) -> Option<&'static Self> {
        let wanted = tag.split(['-', '_']).next().unwrap_or(tag);
        let number = FILES.iter().position(|(language, _)| language.eq_ignore_ascii_case(wanted))?;
        Some(Self::load(number))
    }

    /// English.
    pub(crate) fn english() -> &'static Self {
        Self::load(0)
    }

    /// Those of a language, or English where there are none.
    pub(crate) fn nearest(tag: &str) -> &'static Self {
        Self::of_language(tag).unwrap_or_else(Self::english)
    }

    fn load(number: usize) -> &'static Self {
        LOADED[number].get_or_init(|| {
            let (language, text) = FILES[number];
            // what could be wrong with the program's own files is tested
            let resource = FluentResource::try_new(text.to_owned()).unwrap_or_else(|(read, _)| read);
            let mut bundle = FluentBundle::new_concurrent(language.parse().into_iter().collect());
            bundle.set_use_isolating(false);
            let _ = bundle.add_resource(resource);
            Self { language, bundle, table: Code::of_language(language).and_then(Code::table) }
        })
    }

    /// The tag of the language.
    pub(crate) fn language(&self) -> &'static str {
        self.language
    }

    /// A message filled with values, as one line. Every language has every message, which is tested; one that none has
    /// would be told by its name.
    pub(crate) fn say(&self, message: &str, values: &[(&'static str, Value<'_>)]) -> String {
        let pattern = self.bundle.get_message(message).and_then(|message| message.value());
        let Some(pattern) = pattern else { return message.to_owned() };
        let values: FluentArgs<'_> = values.iter().cloned().collect();
        let text = self.bundle.format_pattern(pattern, Some(&values), &mut Vec::new());
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Where something is, within a sentence, by the number of its [ninth](crate::geom::ninths).
    pub(crate) fn place(&self, ninth: usize) -> String {
        self.say(&format!("place-{}", ninth + 1), &[])
    }

    /// A share (0..=1) in whole percent; nothing is told as 0 or 100 that is not, but for what the digits of a page's
    /// numbers leave open.
    pub(crate) fn percent(&self, share: f32) -> String {
        let percent = 100.0 * share;
        let size = match percent {
            p if p > 0.0 && p < 0.5 => "under",
            p if (99.5..99.95).contains(&p) => "over",
            _ => "is",
        };
        self.say("percent", &[("size", size.into()), ("percent", percent.round().into())])
    }

    /// A colour, by its English name. The tables of braille have it as a word by itself; in a sentence it is a noun
    /// where the language says so.
    pub(crate) fn colour(&self, name: &str) -> String {
        let word = self.table.as_ref().map_or(name, |table| table.word(name));
        let mut letters = word.chars();
        match (self.say("colours-are-names", &[]).as_str(), letters.next()) {
            ("yes", Some(first)) => first.to_uppercase().chain(letters).collect(),
            _ => word.to_owned(),
        }
    }
}

impl std::fmt::Debug for Wording {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Wording").field(&self.language).finish()
    }
}

#[cfg(test)]
mod tests;
