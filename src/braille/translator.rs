//! Text to cells by the table of a code, or by another translator, such as one for contracted braille.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::characters::composed;
use super::formula::is_raised_or_lowered;
use super::grouped;
use super::joined;
use super::numbers;
use super::table::Table;
use super::translate::Braille;

/// Gives the cells of a text (bit 0 is dot 1, 0 is a blank), or says why it cannot.
pub type Translate = dyn Fn(&str) -> Result<Vec<u8>, String> + Send + Sync;

/// What texts are written with.
pub struct Translator<'a> {
    table: Option<Table>,
    other: Option<&'a Translate>,
    /// What the other translator said of each text.
    known: Mutex<BTreeMap<String, Result<Braille, String>>>,
}

impl<'a> Translator<'a> {
    /// The other translator, if there is one, else the table; `None` without either.
    pub fn new(table: Option<Table>, other: Option<&'a Translate>) -> Option<Self> {
        (table.is_some() || other.is_some()).then(|| Self { table, other, known: Mutex::default() })
    }

    /// Whether the table writes, and no other translator.
    pub fn is_own(&self) -> bool {
        self.other.is_none()
    }

    /// A text in braille.
    ///
    /// # Errors
    /// What the other translator says; tables write what they can, and tell the rest.
    pub fn translate(&self, text: &str) -> Result<Braille, String> {
        match (self.other, &self.table) {
            (Some(other), _) => {
                // a page asks for a text many times, and another translator may be a process
                let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
                known.entry(text.to_owned()).or_insert_with(|| by_other(other, text, self.table.as_ref())).clone()
            }
            (None, Some(table)) => Ok(table.translate(text)),
            (None, None) => Ok(Braille::default()),
        }
    }

    /// A text letter by letter, as abbreviations are written: by the table, if there is one.
    ///
    /// # Errors
    /// As [`Translator::translate`].
    pub fn spell(&self, text: &str) -> Result<Braille, String> {
        self.table.as_ref().map_or_else(|| self.translate(text), |table| Ok(table.translate(text)))
    }

    /// Whether letters that are spelled stand for these alone, and are no short word of the language: the other
    /// translator writes a sign before them, or other cells, where the code reads a word or a part of one in theirs, or
    /// the table knows them as such: where a code has no sign for it, both have the same cells. What has a digit is
    /// known as no word.
    pub fn is_read_as_letters(&self, letters: &str) -> bool {
        let Some(table) = &self.table else { return true };
        let is_short_word = table.short_words.contains(letters);
        if is_short_word || self.other.is_none() {
            return !is_short_word;
        }
        let has_digit = letters.contains(|letter: char| letter.is_ascii_digit());
        let is_known = table.contracted.contains(letters);
        let is_same = || self.translate(letters).is_ok_and(|other| other.cells == table.translate(letters).cells);
        has_digit || (!is_known && is_same())
    }

    /// A word of the key, by its English name, in the language of the code.
    pub fn word<'w>(&'w self, name: &'w str) -> &'w str {
        self.table.as_ref().map_or(name, |table| table.word(name))
    }
}

/// A text by a translator that is no table. A hyphen that the table of its code writes as a minus sign is one, unless
/// the other translator has no cells for that.
fn by_other(other: &Translate, text: &str, table: Option<&Table>) -> Result<Braille, String> {
    let plain = composed(text).split_whitespace().collect::<Vec<_>>().join(" ");
    all_by_other(other, &plain, table).or_else(|why| {
        let own = table.filter(|table| table.formulas_are_uncontracted);
        let formulas = own.and_then(|table| beside_formulas(other, &plain, table));
        formulas.or_else(|| with_signs_on_line(other, &plain, table)).ok_or(why)
    })
}

/// A text in which a raised or lowered plus or minus alone, as that of an ion, stands on the line; none without such.
fn with_signs_on_line(other: &Translate, plain: &str, table: Option<&Table>) -> Option<Braille> {
    let (on_line, simplified) = numbers::with_signs_on_line(plain);
    if simplified.is_empty() {
        return None;
    }
    Some(Braille { simplified, ..all_by_other(other, &on_line, table).ok()? })
}

/// A text in which words with raised or lowered signs, as H\u{2082}O, are written by the table of its code, and the
/// others by another translator, which knows no such signs; none if either cannot, or there are no such words.
fn beside_formulas(other: &Translate, plain: &str, table: &Table) -> Option<Braille> {
    let is_formula = |word: &&str| word.contains(is_raised_or_lowered);
    let words: Vec<&str> = plain.split(' ').collect();
    if !words.iter().any(is_formula) {
        return None;
    }
    let mut all = Braille::default();
    for part in words.chunk_by(|a, b| !is_formula(a) && !is_formula(b)) {
        let own = match part {
            [word] if is_formula(word) => Some(table.translate(word)).filter(|own| own.lacking.is_empty())?,
            words => all_by_other(other, &words.join(" "), Some(table)).ok()?,
        };
        all.cells.extend((!all.cells.is_empty()).then_some(0));
        all.cells.extend(own.cells);
        all.simplified.extend(own.simplified);
    }
    all.joined = joined::blanks(plain, &all.cells);
    Some(all)
}

/// A text that another translator writes as a whole.
fn all_by_other(other: &Translate, plain: &str, table: Option<&Table>) -> Result<Braille, String> {
    let with_minus = table.map(|table| table.with_minus(plain)).filter(|with| *with != plain);
    let cells = match with_minus.and_then(|with| other(&with).ok()) {
        Some(cells) => cells,
        None => other(plain)?,
    };
    // a cell of eight dots has no place on a page
    if cells.iter().any(|cell| *cell >= 64) {
        return Err("cells of eight dots".into());
    }
    let cells = match table {
        Some(table) => grouped::join(table, plain, cells),
        None => cells,
    };
    let joined = joined::blanks(plain, &cells);
    Ok(Braille { cells, joined, ..Braille::default() })
}

#[cfg(test)]
mod tests;

impl std::fmt::Debug for Translator<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let table = self.table.as_ref().map(|table| &table.name);
        f.debug_struct("Translator").field("table", &table).field("other", &self.other.is_some()).finish()
    }
}
