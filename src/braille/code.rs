//! The braille codes that come with the program, one for each language.

use super::parse;
use super::table::Table;

/// A braille code that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Code {
    /// The language that it is for (BCP 47), which is also its name.
    pub language: &'static str,
    text: &'static str,
}

/// How much a code shortens words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grade {
    /// Grade 1: letter by letter, uncontracted.
    One,
    /// Grade 2: contracted.
    Two,
}

/// All codes, by their names.
const CODES: &[Code] = &[
    Code { language: "cs", text: include_str!("tables/cs.txt") },
    Code { language: "de", text: include_str!("tables/de.txt") },
    Code { language: "en", text: include_str!("tables/en.txt") },
    Code { language: "es", text: include_str!("tables/es.txt") },
    Code { language: "fr", text: include_str!("tables/fr.txt") },
    Code { language: "it", text: include_str!("tables/it.txt") },
    Code { language: "nl", text: include_str!("tables/nl.txt") },
    Code { language: "pl", text: include_str!("tables/pl.txt") },
    Code { language: "pt", text: include_str!("tables/pt.txt") },
    Code { language: "sv", text: include_str!("tables/sv.txt") },
];

impl Code {
    /// Every code there is, by its name.
    pub const fn all() -> &'static [Self] {
        CODES
    }

    /// The code of this name.
    pub fn named(name: &str) -> Option<Self> {
        CODES.iter().copied().find(|code| code.language == name)
    }

    /// The code of a language such as `de` or `de-CH`.
    pub fn of_language(tag: &str) -> Option<Self> {
        let language = tag.split(['-', '_']).next().unwrap_or(tag);
        CODES.iter().copied().find(|code| code.language.eq_ignore_ascii_case(language))
    }

    /// Its table. The texts of the program itself are tested, so that this gives one for each of [`Code::all`].
    pub fn table(self) -> Option<Table> {
        parse::table(self.text).ok().map(|table| Table { language: self.language, ..table })
    }
}

#[cfg(test)]
mod tests;
